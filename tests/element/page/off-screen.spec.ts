// What does a viewer do while it is out of view, for each value of `loading`? Screen and window are
// 700 px high.

import { allReady, expect, test } from '../../support/test.js';
import { countEverything, countsOf, expectIdle } from '../support/counting.js';
import { assign, framesOf, nextFrame, type PhongViewer, settled } from '../support/viewer.js';
import { requestsOf } from '../../support/requests.js';

const size = { width: 90, height: 60 };
const bunny = '/assets/models/bunny.glb';
const viewer = (attributes = '') =>
  `<phong-viewer geometry="box" ${attributes}><phong-light></phong-light></phong-viewer>`;
const above = (height: number) => `main { padding: ${height}px 0 5000px }`;

test.beforeEach(({ page }) => countEverything(page));

test('auto waits in a closed dialog or <details>, model and panel; eager does not', async ({
  page,
  site,
}) => {
  const requests = requestsOf(page);
  const model = (name: string) => `/fixtures/models/no-normals.glb?${name}`;
  const viewer = (name: string, rest = '') =>
    `<phong-viewer id="${name}" gui src="${model(name)}" ${rest}></phong-viewer>`;
  const head = '<script type="module" src="/dist/phong-viewer.standalone.js"></script>';
  await page.goto(
    site.page(
      `<dialog>${viewer('a')}</dialog><details><summary>More</summary><div><template shadowrootmode="open">${viewer('b')}</template></div></details>
       <dialog>${viewer('c', 'loading="eager"').replace('gui', '')}</dialog>
       <dialog><phong-viewer id="d" geometry="box" gui><phong-mesh src="${model('d')}"></phong-mesh></phong-viewer></dialog>`,
      { head },
    ),
  );
  await expect.poll(() => requests).toContain(site.origin + model('c'));
  await page.locator('#a').evaluate((element: PhongViewer) => element.ready);
  await nextFrame(page);
  const names = () => requests.flatMap((url) => /no-normals\.glb\?(.)/.exec(url)?.[1] ?? []).sort();
  const panels = () => requests.filter((url) => /chunks\/panel.*\.js/.test(url)).length;
  expect([names(), panels()]).toEqual([['c'], 0]);
  await page.locator('dialog').first().evaluate((dialog: HTMLDialogElement) => dialog.showModal()); // oxfmt-ignore
  await expect.poll(names).toEqual(['a', 'c']);
  await expect(page.locator('#a .lil-root')).toBeVisible();
  expect(panels()).toBeGreaterThan(0);
  await page.locator('dialog').first().evaluate((dialog: HTMLDialogElement) => dialog.close()); // oxfmt-ignore
  await page.locator('details').evaluate((details: HTMLDetailsElement) => (details.open = true));
  await expect.poll(names).toEqual(['a', 'b', 'c']);
  await expect(page.locator('#b .lil-root')).toBeVisible();
  await page
    .locator('dialog')
    .last()
    .evaluate((dialog: HTMLDialogElement) => dialog.show());
  await expect.poll(names).toEqual(['a', 'b', 'c', 'd']);
});

test('auto fetches at once, lazy less than a screen height away; both draw there, once', async ({
  page,
  mount,
}) => {
  const near = await mount(`<main>${viewer()}</main>`, { ...size, css: above(700 + 650) });
  expect(await framesOf(near)).toBe(1);
  const requests = requestsOf(page);
  const later = '/fixtures/models/textured.glb';
  const auto = await mount(
    `<main><phong-viewer src="${bunny}"></phong-viewer><phong-viewer loading="lazy" src="${later}"></phong-viewer></main>`,
    { ...size, css: `${above(700 + 750)} phong-viewer { float: left }` },
  );
  const lazy = page.locator('phong-viewer').last();
  expect(await auto.evaluate(({ loaded }) => loaded)).toBe(true);
  for (let theta = 1; theta < 5; theta++) {
    await assign(auto, { theta });
  }
  await nextFrame(page);
  expect([await framesOf(auto), await framesOf(lazy), requests.join().includes(later)]).toEqual([
    0,
    0,
    false,
  ]);
  for (const top of [100, 0, 100]) {
    await page.evaluate((y) => scrollTo(0, y), top);
    await expect.poll(() => framesOf(auto)).toBe(1);
    await nextFrame(page);
  }
  expect(await framesOf(auto), 'an unchanged picture is drawn once').toBe(1);
  await expect.poll(() => lazy.evaluate(({ loaded }: PhongViewer) => loaded)).toBe(true);
  await expect.poll(() => framesOf(lazy)).toBeGreaterThan(0);
});

test('eager draws off screen, and is ready when it is drawn', async ({ page, mount }) => {
  const eager = await mount(`<main>${viewer('loading="eager"')}${viewer()}</main>`, {
    ...size,
    css: above(9000),
  });
  const auto = page.locator('phong-viewer').last();
  expect([await framesOf(eager), await framesOf(auto)]).toEqual([1, 0]);
  const drawn = await eager.evaluate(async (element) => {
    element.theta = 50;
    await element.ready;
    return element.stats.frames;
  });
  expect(drawn).toBe(2);
  await assign(auto, { loading: 'eager' });
  await settled(auto);
  expect(await framesOf(auto)).toBe(1);
  await assign(eager, { loading: 'auto' });
  await assign(eager, { theta: 70 });
  await settled(eager);
  expect(await framesOf(eager)).toBe(2);
});

test('what scrolling cannot show is not drawn, eager or in a closed accordion nearby', async ({
  page,
  mount,
}) => {
  for (const [attributes, css] of [
    ['loading="eager"', 'main { display: none }'],
    ['loading="eager"', 'main { visibility: hidden }'],
    ['loading="eager"', 'phong-viewer { width: 0 !important }'],
    ['', 'main { height: 0; overflow: hidden }'],
  ] as const) {
    const inside = await mount(`<main>${viewer(attributes)}</main>`, { ...size, css });
    await nextFrame(page);
    await assign(inside, { kd: [9, 9, 9] });
    await nextFrame(page);
    expect(await framesOf(inside), css).toBe(0);
  }
});

test('out of view a change is drawn once, and nothing moves', async ({ page, mount }) => {
  const turning = 'auto-rotate="90"';
  const first = await mount(
    `<main>${viewer(turning)}${viewer(`${turning} loading="eager"`)}</main>`,
    { ...size, css: above(1000) },
  );
  const both = [first, page.locator('phong-viewer').last()];
  for (const one of both) {
    expect(await framesOf(one)).toBe(1);
  }
  await nextFrame(page);
  await expectIdle(page, 300);
  for (const one of both) {
    await assign(one, { kd: [9, 9, 9] });
  }
  await nextFrame(page);
  for (const one of both) {
    expect(await framesOf(one)).toBe(2);
  }
  await expectIdle(page, 300);
  await page.evaluate(() => scrollTo(0, 1000));
  for (const one of both) {
    await expect.poll(() => framesOf(one)).toBeGreaterThan(4);
  }
});

test('the next pictures of a carousel are drawn before they come into view', async ({
  page,
  mount,
}) => {
  const slides = `<div>${viewer('auto-rotate="45"')}</div>`.repeat(5);
  for (const overflow of ['auto', 'hidden']) {
    await mount(`<main>${slides}</main>`, {
      width: 400,
      height: 60,
      css: `main { display: flex; width: 400px; overflow: ${overflow}; scroll-snap-type: x mandatory }
        div { flex: 0 0 400px; scroll-snap-align: start }`,
    });
    await nextFrame(page);
    await nextFrame(page);
    const all = await page.locator('phong-viewer').all();
    const counts = async () => Promise.all(all.map(framesOf));
    // Slides 1 and 2 lie within 700 px of the visible one, which alone moves.
    await expect.poll(async () => (await counts())[0]).toBeGreaterThan(3);
    expect((await counts()).slice(1), overflow).toEqual([1, 1, 0, 0]);
    await page.evaluate(() => document.querySelector('main')!.scrollTo(400, 0));
    await expect.poll(async () => (await counts())[1]).toBeGreaterThan(3);
    expect((await counts()).slice(2), overflow).toEqual([1, 1, 0]);
  }
});

test('in an iframe the same holds; nothing moves while the iframe itself is out of view', async ({
  page,
  mount,
}) => {
  await mount(`<main><iframe></iframe></main>${viewer(`auto-rotate="45"`)}${viewer()}`, {
    ...size,
    css: 'iframe { width: 300px; height: 200px } main { height: 5000px }',
  });
  await page.evaluate(async () => {
    const inner = document.querySelector('iframe')!.contentDocument!;
    const [turning, below] = document.querySelectorAll('phong-viewer');
    for (const one of [turning!, below!]) {
      one.style.cssText = 'display: block; width: 90px; height: 60px';
    }
    below!.style.marginTop = '500px';
    inner.body.append(turning!, below!);
    await Promise.all([turning!.ready, below!.ready]);
  });
  const inside = page.frameLocator('iframe').locator('phong-viewer');
  await nextFrame(page);
  await nextFrame(page);
  expect(await framesOf(inside.last())).toBe(1);
  const turned = await framesOf(inside.first());
  await expect.poll(() => framesOf(inside.first())).toBeGreaterThan(turned + 2);
  await page.evaluate(() => scrollTo(0, 3000));
  await nextFrame(page);
  await nextFrame(page);
  const rest = await framesOf(inside.first());
  await expectIdle(page, 300);
  expect(await framesOf(inside.first())).toBe(rest);
});

test('during scrolling no viewer in view is blank for more than a frame', async ({
  page,
  mount,
}) => {
  const count = 60;
  await mount(`<main>${viewer().repeat(count)}</main>`, { width: 60, height: 200 });
  const blank = await page.evaluate(async () => {
    const viewers = [...document.querySelectorAll('phong-viewer')];
    const since = new Map<Element, number>();
    let longest = 0;
    const end = document.documentElement.scrollHeight;
    // Includes jumps of more than a screen and its margin, each in one frame.
    for (let top = 0, frame = 0; top < end; frame += 1) {
      scrollTo(0, top);
      await new Promise(requestAnimationFrame);
      // What came into view is reported by a task after the frame, which the next frame may
      // overtake on a busy machine.
      await new Promise((resolve) => setTimeout(resolve));
      for (const one of viewers) {
        const { top: upper, bottom } = one.getBoundingClientRect();
        const isBlank =
          bottom > 0 && upper < innerHeight && !one.shadowRoot!.querySelector('canvas');
        since.set(one, isBlank ? (since.get(one) ?? 0) + 1 : 0);
        longest = Math.max(longest, since.get(one)!);
      }
      if (frame % 2 === 1) {
        top += frame % 10 === 9 ? 2500 : 120;
      }
    }
    return longest;
  });
  expect(blank).toBeLessThanOrEqual(1);
});

test('eager viewers off screen keep only their pixels; the shared canvas fits a screen', async ({
  page,
  mount,
}) => {
  const count = 48;
  await mount(`<main>${viewer('loading="eager"').repeat(count)}</main>`, {
    width: 100,
    height: 200,
    css: above(5000),
  });
  await allReady(page);
  await nextFrame(page);
  const { contexts, canvasPixels, sheetPixels } = await countsOf(page);
  expect(contexts).toBe(1);
  expect(sheetPixels).toBeLessThanOrEqual(1000 * 700);
  expect(canvasPixels).toBe(count * 100 * 200 + sheetPixels);
  await expectIdle(page, 300);
});
