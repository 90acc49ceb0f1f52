// Does a removed viewer leave anything behind: in the heap, on the GPU, among the page's listeners
// and observers?

import type { Page } from '@playwright/test';
import { findTestBrowser, softwareGl } from '../../../.ci/browser.mjs';
import { fullOr } from '../../support/repeats.js';
import { allReady, expect, test } from '../../support/test.js';
import { countEverything, countsOf } from '../support/counting.js';
import { comeAndGo, Ledger, remember, stillAlive } from './many-viewers.js';
import { nextFrame, type PhongViewer } from '../support/viewer.js';

const size = { width: 90, height: 60, css: 'phong-viewer { float: left }' };
const stays =
  '<phong-viewer geometry="box"><phong-light position="1 2 3 0"></phong-light></phong-viewer>';
const kinds = [
  '<phong-viewer src="/fixtures/models/textured.glb"></phong-viewer>',
  '<phong-viewer geometry="sphere" shading="flat" gui></phong-viewer>',
  '<phong-viewer geometry="box" helpers="lights grid"><phong-light position="1 2 3 1"></phong-light></phong-viewer>',
  '<phong-viewer color-interpolation="linear" auto-rotate="9"><phong-light></phong-light><phong-mesh geometry="torus"></phong-mesh></phong-viewer>',
];

test.beforeEach(({ page }) => countEverything(page));

/** What the page holds of its GPU. */
async function held(page: Page): Promise<object> {
  const { contexts, textures, buffers, programs, vertexArrays } = await countsOf(page);
  return { contexts, textures, buffers, programs, vertexArrays };
}

// On a page composed by WebGL: composed without, a specialised program may keep waiting for its
// next frame, with its shaders.
const executablePath = await findTestBrowser();
test.use({
  launchOptions: { ...(executablePath === undefined ? {} : { executablePath }), args: softwareGl },
});

/** Levels of round shapes stay for a second without a user. */
const KEPT_MS = 1500;

test('viewers that come and go leave nothing behind', async ({ page, mount }) => {
  test.slow();
  await mount(stays, size);
  const ledger = await Ledger.of(page);
  // The first viewers load what stays for good, such as the panel's code.
  await comeAndGo(page, kinds, kinds.length);
  await page.waitForTimeout(KEPT_MS);
  const before = await ledger.read();
  await comeAndGo(page, kinds, 2 * kinds.length);
  await page.waitForTimeout(KEPT_MS);
  const { counts, objects } = await ledger.read();
  expect(counts).toEqual(before.counts);
  expect(objects).toEqual(before.objects);
  expect(objects).toMatchObject({ viewers: 1, scenes: 1 });
});

test('a picture that converges again and again leaves nothing behind', async ({ page, mount }) => {
  const viewer = await mount(
    '<phong-viewer geometry="box" antialias="full" samples="16"><phong-light></phong-light></phong-viewer>',
    size,
  );
  const turn = (times: number) =>
    viewer.evaluate(async (element, count) => {
      for (let i = 0; i < count; i++) {
        element.theta += 1;
        await element.ready;
      }
    }, times);
  const ledger = await Ledger.of(page);
  // Past the frames after which a specialised program comes: its code may take some more.
  await turn(30);
  await expect(async () => {
    const before = await ledger.read();
    await turn(5);
    expect((await ledger.read()).objects).toEqual(before.objects);
  }).toPass();
});

test('moving a viewer on its page opens no context and uploads nothing', async ({
  page,
  mount,
}) => {
  const viewer = await mount(`${kinds[0]}${stays}<section></section>`, size);
  const before = await held(page);
  const shot = await viewer.screenshot();
  await viewer.evaluate(async (element) => {
    const place = document.querySelector('section')!;
    for (let i = 0; i < 10; i++) {
      place.append(element);
      document.body.prepend(element);
      await element.ready;
    }
  });
  await nextFrame(page);
  expect(await held(page)).toEqual(before);
  expect(Buffer.compare(await viewer.screenshot(), shot)).toBe(0);
});

const light = '<phong-light position="1 2 3 1"></phong-light>';
const box = (attributes = '') =>
  `<phong-viewer geometry="box" ${attributes}>${light}</phong-viewer>`;

type Last = readonly [
  markup: string,
  use?: ((page: Page) => Promise<unknown>) | undefined,
  said?: RegExp,
];

/**
 * What is the last of its kind on a page, how it is used before it is removed, and what it says.
 */
const lasts: Record<string, Last> = {
  'one viewer': [box()],
  'four viewers': [kinds.join('')],
  '128 viewers': [box().repeat(128)],
  'a viewer that was dragged and turned by keys': [
    box(),
    async (page) => {
      await page.mouse.move(45, 30);
      await page.mouse.down();
      await page.mouse.move(60, 35, { steps: 3 });
      await page.mouse.up();
      await page.keyboard.press('ArrowLeft');
    },
  ],
  'a comparison': [
    `<phong-compare labels="a|b">${box()}${box('shading="flat"')}</phong-compare>`,
    async (page) => {
      await page.mouse.move(10, 30);
      await page.mouse.down();
      await page.mouse.move(30, 35, { steps: 3 });
      await page.mouse.up();
    },
  ],
  'a control': [
    `${box('id="a"')}<phong-control for="a" attribute="theta">turn</phong-control>`,
    async (page) => {
      await page.locator('phong-control input').first().focus();
      await page.keyboard.press('ArrowUp');
      await page.keyboard.press('Control+z');
    },
  ],
  'a probe with questions': [
    `${box('id="a"')}<phong-probe for="a" as="ask"></phong-probe>`,
    async (page) => {
      await page.locator('phong-probe input').first().fill('1');
      await page.keyboard.press('Enter');
    },
  ],
  'a viewer with a panel': [
    box('gui="camera lights"'),
    async (page) => {
      await page.locator('[part=panel] input').first().focus();
      await page.keyboard.press('ArrowUp');
      await page.keyboard.press('Control+z');
    },
  ],
  'a viewer with helpers': [
    box('helpers="lights axes grid normals bounds"'),
    (page) => page.keyboard.press('Tab'),
  ],
  'a viewer with a probe': [
    box('probe'),
    async (page) => {
      await page.mouse.move(45, 30);
      await page.mouse.click(45, 30);
    },
  ],
  'a viewer with a pinned probe': [box('probe probe-at="0.5 0.5 0.5"')],
  'a viewer that shows a view': [box('view="n-dot-l"')],
  'a viewer that converges': [box('antialias="full" samples="16"')],
  'viewers with one camera': [box('camera-group="a"').repeat(2)],
  'a viewer of which a picture is kept': [
    box(),
    (page) =>
      page.evaluate(async () => {
        const viewer = document.querySelector('phong-viewer')!;
        const files = [await viewer.toBlob(), await viewer.toBlob({ samples: 4 })];
        const point = await viewer.shadeAt(45, 30);
        Object.assign(window, { kept: [files, viewer.toHTML(), point?.color] });
      }),
  ],
  'a viewer that failed': [
    '<phong-viewer src="/fixtures/models/none.glb"></phong-viewer>',
    undefined,
    /404/,
  ],
  'a viewer that lost its context': [
    box(),
    (page) =>
      page.evaluate(async () => {
        const canvas = document.querySelector('phong-viewer')!.shadowRoot!.querySelector('canvas')!;
        canvas.getContext('webgl2')!.getExtension('WEBGL_lose_context')!.loseContext();
        await new Promise((resolve) => setTimeout(resolve, 50));
      }),
  ],
};

test('frees whatever is the last of the page', async ({ page, mount, consoleGuard }) => {
  test.slow();
  await mount(box(), size);
  for (const [what, [markup, use, said]] of Object.entries(lasts)) {
    if (said !== undefined) {
      consoleGuard.allow(said);
    }
    await page.evaluate((html) => (document.body.innerHTML = html), markup);
    await allReady(page);
    await use?.(page);
    await nextFrame(page);
    await remember(page);
    await page.evaluate(() => document.body.replaceChildren());
    await expect.poll(() => stillAlive(page), what).toEqual([]);
  }
});

test('frees the last light, mesh and control of a viewer that stays', async ({ page, mount }) => {
  const markup = `<phong-viewer id="a" gui helpers="lights" probe>${light}
    <phong-mesh geometry="box"></phong-mesh></phong-viewer>
    <phong-control for="a" attribute="theta">turn</phong-control>`;
  await mount(markup, size);
  await remember(page);
  await page.evaluate(async () => {
    document.querySelector('phong-viewer')!.replaceChildren();
    document.querySelector('phong-control')!.remove();
    await document.querySelector('phong-viewer')!.ready;
  });
  await expect.poll(() => stillAlive(page)).toEqual(['phong-viewer', 'scene']);
});

test('frees the last viewer of an iframe that is removed with it', async ({ page, mount }) => {
  await mount(`${box()}<iframe></iframe>`, size);
  await page.evaluate(async () => {
    const viewer = document.querySelector('phong-viewer')!;
    document.querySelector('iframe')!.contentDocument!.body.append(viewer);
    await viewer.ready;
    Object.assign(window, { remembered: [['phong-viewer', new WeakRef(viewer)]] });
    document.querySelector('iframe')!.remove();
  });
  await expect.poll(() => stillAlive(page)).toEqual([]);
});

// What is shown before the load, and so what is replaced by it.
const before = {
  nothing: '',
  'a shape': 'geometry="torus"',
  'a model': 'src="/fixtures/models/textured.glb"',
};

for (const [what, attributes] of Object.entries(before)) {
  test(`frees viewers that showed ${what} and are removed while a model loads`, async ({
    page,
    mount,
  }) => {
    await mount(stays, size);
    // At each time after the request, and around each event of the load.
    const viewers = `<phong-viewer ${attributes}>${light}</phong-viewer>`;
    await page.evaluate(
      async ({ html, step }) => {
        const remembered: [name: string, object: WeakRef<object>][] = [];
        const frame = () => new Promise((resolve) => requestAnimationFrame(resolve));
        const moments: Record<string, (viewer: PhongViewer) => Promise<unknown>> = {
          'at once': () => Promise.resolve(),
          'in the next frame': frame,
        };
        for (let ms = 0; ms < 100; ms += step) {
          moments[`after ${ms} ms`] = () => new Promise((resolve) => setTimeout(resolve, ms));
        }
        for (const type of ['progress', 'load', 'render']) {
          const event = (viewer: PhongViewer) =>
            new Promise((resolve) => viewer.addEventListener(type, resolve, { once: true }));
          moments[`at ${type}`] = event;
          moments[`a task after ${type}`] = async (viewer) => {
            await event(viewer);
            await new Promise((resolve) => setTimeout(resolve));
          };
          moments[`a frame after ${type}`] = async (viewer) => {
            await event(viewer);
            await frame();
          };
        }
        let count = 0;
        for (const [moment, comes] of Object.entries(moments)) {
          const place = document.createElement('section');
          place.innerHTML = html;
          document.body.append(place);
          const viewer = place.firstElementChild as PhongViewer;
          await viewer.ready;
          const come = comes(viewer);
          viewer.src = `/fixtures/models/textured.glb?${count++}`;
          await come;
          place.remove();
          remembered.push([moment, new WeakRef(viewer)]);
        }
        Object.assign(window, { remembered });
      },
      { html: viewers, step: fullOr(4, 20) },
    );
    await expect.poll(() => stillAlive(page)).toEqual([]);
  });
}
