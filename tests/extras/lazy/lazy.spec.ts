// `phong-viewer.lazy.js`: pages whose viewers stand still with their posters until somebody wants
// more. All pages have the strict policy.
import { statSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import type { Page } from '@playwright/test';
import { still } from '../../../src/extras/still/index.js';
import { outputFolder } from '../../../.ci/output-folder.mjs';
import { bundleOf, renderedByServer } from '../../package/bundle.js';
import { Requests } from '../../package/requests.js';
import { countJumps, jumpsOf } from '../../support/jumps.js';
import { decodePng } from '../../support/picture.js';
import { expect, test } from '../../support/test.js';
import { cameraOf, Fingers, holdBack, type PhongViewer } from '../../element/support/viewer.js';

// The pointer rests in the corner.
const css = 'body { margin: 60px } phong-viewer { display: block; width: 300px; height: 200px }';
const head = '<script type="module" src="/dist/phong-viewer.lazy.js"></script>';
const IMAGE =
  "data:image/svg+xml,<svg xmlns='http://www.w3.org/2000/svg' width='3' height='2'><rect width='3' height='2' fill='red'/></svg>";
const POSTER = `<img slot="poster" src="${IMAGE}" width="300" height="200" alt="">`;
const BALL = 'geometry="sphere" radius="3" target="0 0 0"';
const ELEMENTS = 'phong-viewer.standalone.js';

const figure = (attributes = '', inner = '') =>
  `<phong-viewer ${BALL} ${attributes}>${POSTER}${inner}</phong-viewer>`;
const isDefined = (page: Page) =>
  page.evaluate(() => customElements.get('phong-viewer') !== undefined);
const thetaOf = async (page: Page) => (await cameraOf(page.locator('phong-viewer').first())).theta;
const waitForPicture = (page: Page) =>
  page.waitForFunction(() => document.querySelector<PhongViewer>('phong-viewer')!.loaded);

/** Keeps the elements from the page until the returned function is called. */
const holdElements = (page: Page) => holdBack(page, `**/${ELEMENTS}`);

test('the file has at most 2 kB, and a page with ten figures fetches nothing else before a touch', async ({
  page,
  site,
}) => {
  expect(statSync(join(outputFolder('dist'), 'phong-viewer.lazy.js')).size).toBeLessThan(2049);
  const requests = new Requests(page);
  await countJumps(page);
  await page.goto(site.page(`<p>Text</p>${figure().repeat(10)}`, { css, head }));
  await page.mouse.wheel(0, 2000);
  await expect(page.locator('[slot=poster]').last()).toBeVisible();
  expect(requests.take()).toEqual(['phong-viewer.lazy.js']);
  await page.locator('phong-viewer').nth(9).hover();
  await page.waitForFunction(
    () => [...document.querySelectorAll<PhongViewer>('phong-viewer')].at(-1)!.loaded,
  );
  await expect(page.locator('[slot=poster]').last()).toBeHidden();
  expect(requests.take()).toEqual([ELEMENTS]);
  expect(await jumpsOf(page), 'each stays where it is while it takes over').toBe(0);
});

test('the drag that asks for the elements turns the viewer by what the pointer has moved', async ({
  page,
  site,
}) => {
  await page.goto(site.page(figure(), { css, head }));
  const send = await holdElements(page);
  await page.mouse.move(150, 100);
  await page.mouse.down();
  await page.mouse.move(190, 110);
  await page.mouse.move(210, 90);
  expect(await isDefined(page)).toBe(false);
  send();
  await waitForPicture(page);
  const camera = async () => {
    const { theta, phi } = await cameraOf(page.locator('phong-viewer'));
    return [theta, phi];
  };
  await expect.poll(async () => (await camera())[0]).not.toBe(30);
  const [theta, phi] = await camera();
  // It goes on: the same move again doubles the turn.
  await page.mouse.move(270, 80);
  await expect.poll(async () => (await camera())[0]! - 30).toBeCloseTo(2 * (theta! - 30), 6);
  expect((await camera())[1]! - 70).toBeCloseTo(2 * (phi! - 70), 6);
  await page.mouse.up();
  await page.mouse.move(100, 100);
  expect((await camera())[0]! - 30).toBeCloseTo(2 * (theta! - 30), 6);
});

test('a finger’s drag that asks for the elements turns the viewer too, and the page still scrolls', async ({
  page,
  site,
}) => {
  const long = `${css} .far { height: 3000px }`;
  await page.goto(site.page(`${figure()}<div class="far"></div>`, { css: long, head }));
  const send = await holdElements(page);
  const fingers = await Fingers.on(page);
  await fingers.down([150, 100]);
  for (let x = 160; x <= 210; x += 10) {
    await fingers.move([x, 100]);
  }
  await expect.poll(() => page.evaluate(() => scrollY)).toBe(0);
  send();
  await waitForPicture(page);
  await expect.poll(() => thetaOf(page)).not.toBe(30);
  const turned = await thetaOf(page);
  await fingers.move([270, 100]);
  await expect.poll(async () => (await thetaOf(page)) - 30).toBeCloseTo(2 * (turned - 30), 6);
  await fingers.up();
  // Up and down the finger scrolls, over a viewer too.
  await fingers.down([150, 200]);
  for (let y = 190; y >= 100; y -= 10) {
    await fingers.move([150, y]);
  }
  await fingers.up();
  await expect.poll(() => page.evaluate(() => scrollY)).toBeGreaterThan(0);
});

test('a drag that ends before the elements are there counts too', async ({ page, site }) => {
  await page.goto(site.page(figure(), { css, head }));
  const send = await holdElements(page);
  await page.mouse.move(150, 100);
  await page.mouse.down();
  await page.mouse.move(210, 100);
  await page.mouse.up();
  await page.mouse.move(20, 20);
  send();
  await waitForPicture(page);
  await expect.poll(() => thetaOf(page)).not.toBe(30);
  const turned = await thetaOf(page);
  await page.mouse.move(150, 120);
  expect(await thetaOf(page)).toBe(turned);
});

test('the keyboard reaches a viewer, and has it once the elements are there', async ({
  page,
  site,
}) => {
  await page.goto(site.page(`${figure()}${figure('tabindex="0" id="own"')}`, { css, head }));
  await expect(page.locator('phong-viewer').first()).not.toHaveAttribute('tabindex');
  await page.keyboard.press('Tab');
  await waitForPicture(page);
  await expect(page.locator('phong-viewer').first()).not.toHaveAttribute('tabindex');
  await expect(page.locator('#own')).toHaveAttribute('tabindex', '0');
  await expect(page.locator('[part=surface]').first()).toBeFocused();
  await page.keyboard.press('ArrowLeft');
  await expect.poll(() => thetaOf(page)).not.toBe(30);
});

for (const [what, body] of [
  ['a viewer with an animation', figure('', '<phong-mesh geometry="box" autoplay></phong-mesh>')],
  ...['gui', 'probe', 'helpers', 'auto-rotate="9"', 'camera-group="a"'].map(
    (name) => [`a viewer with ${name}`, figure(name)] as const,
  ),
  ['a viewer without a poster', `<phong-viewer ${BALL}></phong-viewer>`],
  ['a comparison', `<phong-compare>${figure()}${figure()}</phong-compare>`],
  ['a control', '<phong-control attribute="theta"></phong-control>'],
  [
    'a viewer that a control is for',
    `${figure('id="it"')}<div class="far"></div><phong-control for="it" attribute="theta"></phong-control>`,
  ],
] as const) {
  test(`${what} fetches the elements as soon as it comes near`, async ({ page, site }) => {
    const far = `${css} .far { height: 3000px }`;
    await page.goto(site.page(`<div class="far"></div>${body}`, { css: far, head }));
    await page.waitForTimeout(100);
    expect(await isDefined(page)).toBe(false);
    await page.mouse.wheel(0, 2000);
    await expect.poll(() => isDefined(page)).toBe(true);
  });
}

test('values that are off do not count as alive', async ({ page, site }) => {
  await page.goto(
    site.page(figure('gui="false" probe="false" auto-rotate="0" alt="a probe"'), { css, head }),
  );
  await page.waitForTimeout(200);
  expect(await isDefined(page)).toBe(false);
});

test('without the elements the posters stay, and the next touch or call tries again', async ({
  page,
  site,
  consoleGuard,
}) => {
  consoleGuard.allow(/Failed to load resource|net::ERR_FAILED/);
  await page.goto(site.page(`${figure()}<p id="p">x</p>`, { css, head }));
  await page.route(`**/${ELEMENTS}`, (route) => route.abort());
  const failed = page.waitForEvent('requestfailed');
  await page.locator('phong-viewer').hover();
  await failed;
  await expect(page.locator('[slot=poster]')).toBeVisible();
  await page.unroute(`**/${ELEMENTS}`);
  await page.locator('#p').hover();
  const names = await page.evaluate(async (lazy) => {
    const { load } = (await import(lazy)) as { load(): Promise<object> };
    return Object.keys(await load());
  }, '/dist/phong-viewer.lazy.js');
  expect(names).toContain('PhongViewer');
  await waitForPicture(page);
  await expect(page.locator('[slot=poster]')).toBeHidden();
});

test('a viewer has the same box before as after, with any poster', async ({ page, site }) => {
  const rules = 'body { margin: 60px } img { max-width: 50%; height: auto }';
  const body = `a <phong-viewer ${BALL} poster="${IMAGE}"><b>hidden</b></phong-viewer> b`;
  await page.goto(site.page(body, { css: rules, head }));
  const image = page.locator('phong-viewer > img');
  await expect(image).toBeVisible();
  await expect(page.getByRole('img', { name: 'A test scene' })).toBeVisible();
  const boxes = async () => [
    await page.locator('phong-viewer').boundingBox(),
    await image.boundingBox(),
  ];
  const before = await boxes();
  expect(before).toMatchObject([
    { width: 300, height: 150 },
    { width: 300, height: 150 },
  ]);
  await page.locator('phong-viewer').hover();
  await waitForPicture(page);
  expect(await page.locator('phong-viewer').boundingBox()).toEqual((before as object[])[0]);
});

test('a poster beside a panel lies where the picture will be', async ({ page, site }) => {
  const send = await holdElements(page);
  const rules = `${css} phong-viewer { width: 806px; height: 400px }`;
  await page.goto(site.page(figure('gui') + figure('gui="false"'), { css: rules, head }));
  const poster = page.locator('[slot=poster]').first();
  const box = { x: 60, y: 60, width: 500, height: 400 };
  await expect.poll(() => poster.boundingBox()).toEqual(box);
  const viewer = page.locator('phong-viewer').first();
  await viewer.evaluate((element) => (element.style.width = '639px'));
  expect(await poster.boundingBox()).toEqual({ ...box, width: 639 });
  await viewer.evaluate((element) => (element.style.width = ''));
  expect(await page.locator('[slot=poster]').last().boundingBox()).toMatchObject({ width: 806 });
  send();
  await waitForPicture(page);
  const surface = await viewer.locator('[part=surface]').boundingBox();
  expect(surface!.width).toBeCloseTo(500, 0);
});

test('a poster by the command differs from the picture that takes over only at outlines', async ({
  page,
  site,
}) => {
  const scene = `<phong-viewer antialias="full" samples="64" style="width:150px;height:100px;background:#123" geometry="torus"><phong-light position="1 2 2"></phong-light></phong-viewer>`;
  const options = { width: 150, height: 100, threads: 1, background: [17, 34, 51] } as const;
  const { png } = await still(scene, options);
  await page.route('**/poster.png', (route) => route.fulfill({ body: Buffer.from(png) }));
  const markup = scene
    .replace(
      '><phong-light',
      '><img slot="poster" src="/poster.png" width="150" height="100" alt=""><phong-light',
    )
    .replace(/ style="[^"]*"/, '');
  await page.goto(
    site.page(markup, {
      css: `${css} phong-viewer { background: #123; width: 150px; height: 100px }`,
      head,
    }),
  );
  const viewer = page.locator('phong-viewer');
  await expect(page.locator('[slot=poster]')).toBeVisible();
  const before = decodePng(await viewer.screenshot());
  await viewer.hover();
  await viewer.evaluate(async (element: PhongViewer) => {
    await customElements.whenDefined('phong-viewer');
    await element.ready;
  });
  await expect(page.locator('[slot=poster]')).toBeHidden();
  const after = decodePng(await viewer.screenshot());
  let inside = 0;
  let apart = 0;
  const { width } = before;
  const isFlat = (at: number) =>
    [-4, 4, -4 * width, 4 * width].every((step) =>
      [0, 1, 2].every((k) => Math.abs(before.data[at + k]! - before.data[at + step + k]!) < 12),
    );
  for (let y = 1; y < before.height - 1; y++) {
    for (let x = 1; x < width - 1; x++) {
      const at = 4 * (y * width + x);
      if (!isFlat(at)) continue;
      inside++;
      apart += Number(
        [0, 1, 2].some((k) => Math.abs(before.data[at + k]! - after.data[at + k]!) > 1),
      );
    }
  }
  expect(inside).toBeGreaterThan(0.8 * width * before.height);
  expect(apart).toBe(0);
});

const app = (file: string) => `
  import { createElement as h } from 'react';
  import { PhongLight, PhongViewer } from ${JSON.stringify(file)};
  const App = () => h(PhongViewer, { alt: 'A ball', geometry: 'sphere', gui: false, poster: ${JSON.stringify(IMAGE)} },
    h(PhongLight, { position: [1, 1, 1] }));
`;

test('React renders the poster on the server, and hydrates it without the elements', async ({
  page,
  site,
  consoleGuard,
}) => {
  consoleGuard.allow(/^info: .*React DevTools/);
  const components = join(outputFolder('dist'), 'react-lazy.js');
  const markup = renderedByServer(app(pathToFileURL(components).href));
  expect(markup).toContain('<img slot="poster" src="data:image/svg+xml,');
  const body = await bundleOf(
    `${app(components)}
    import { hydrateRoot } from 'react-dom/client';
    hydrateRoot(document.getElementById('root'), h(App));
    document.body.dataset.shown = '';`,
    { whole: true, define: { 'process.env.NODE_ENV': '"development"' } },
  );
  await page.route('**/app.js', (route) => route.fulfill({ contentType: 'text/javascript', body }));
  const own = '<script type="module" src="/app.js"></script>';
  await page.goto(site.page(`<div id="root">${markup}</div>`, { css, csp: '', head: own }));
  await expect(page.locator('body')).toHaveAttribute('data-shown', '');
  await expect(page.locator('[slot=poster]')).toBeVisible();
  expect(await isDefined(page)).toBe(false);
  await page.locator('phong-viewer').hover();
  await waitForPicture(page);
  await expect(page.locator('[slot=poster]')).toBeHidden();
});
