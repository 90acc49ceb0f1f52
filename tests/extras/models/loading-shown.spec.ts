// What do users, CSS and screen readers get to know about loading? Progress, states, posters and
// the retry button. The test controls when models arrive and when the progress bar's timer ends.

import { axeOn } from '../../support/axe.js';
import type { Locator, Page } from '@playwright/test';
import { type ViewerLocator, expect, type Mount, test } from '../../support/test.js';
import { assign, nextFrame, type PhongViewer, set, settled } from '../../element/support/viewer.js';

const size = { width: 300, height: 200 };
const POSTER = "data:image/svg+xml,<svg xmlns='http://www.w3.org/2000/svg' width='9' height='9'/>";
const model = '/fixtures/models/no-normals.glb';

declare global {
  interface Window {
    loads: {
      /** Callbacks that wait for the progress bar's delay. */
      timers: Map<number, () => void>;
      /** Sends the next half of each file whose address contains "slow". */
      send: (() => void)[];
    };
  }
}

/** To be called before the page is mounted. */
async function slowDown(page: Page, sizeIsKnown = true) {
  await page.addInitScript((known) => {
    const timers = new Map<number, () => void>();
    const send: (() => void)[] = [];
    window.loads = { timers, send };
    const { setTimeout: start, clearTimeout: stop, fetch: get } = window;
    Reflect.set(window, 'setTimeout', (run: () => void, ms?: number) => {
      const id = start(() => (ms === 300 ? undefined : run()), ms);
      if (ms === 300) {
        timers.set(id, run);
      }
      return id;
    });
    window.clearTimeout = (id) => {
      timers.delete(Number(id));
      stop(id);
    };
    window.fetch = async (input, init) => {
      const response = await get(input, init);
      const address = input instanceof Request ? input.url : String(input);
      if (!address.includes('slow') || !response.ok) return response;
      const bytes = new Uint8Array(await response.arrayBuffer());
      const half = bytes.length / 2;
      const body = new ReadableStream({
        start(controller) {
          send.push(
            () => controller.enqueue(bytes.slice(0, half)),
            () => {
              controller.enqueue(bytes.slice(half));
              controller.close();
            },
          );
        },
      });
      const headers = known ? { 'content-length': String(bytes.length) } : undefined;
      return new Response(body, headers === undefined ? {} : { headers });
    };
  }, sizeIsKnown);
}

const slow = `${model}?slow`;
const barOf = (viewer: ViewerLocator) => viewer.getByRole('progressbar');
const delayOver = (page: Page) =>
  page.evaluate(() => {
    for (const run of window.loads.timers.values()) {
      run();
    }
  });
const sendNext = async (page: Page) => {
  await page.waitForFunction(() => window.loads.send.length > 0);
  await page.evaluate(() => window.loads.send.shift()?.());
};
const sendAll = async (page: Page, viewer: ViewerLocator) => {
  await sendNext(page);
  await sendNext(page);
  await settled(viewer);
};
/** A viewer of the slow model, which has begun to load. */
async function mountSlow(
  page: Page,
  mount: Mount,
  { attributes = '', inner = '', sizeIsKnown = true, width = 300, height = 200, css = '' } = {},
): Promise<Locator> {
  await slowDown(page, sizeIsKnown);
  const markup = `<phong-viewer alt="A model" src="${slow}" ${attributes}>${inner}</phong-viewer>`;
  return mount(markup, { width, height, css, waitForReady: false });
}
const axeViolations = async (page: Page) => {
  const { violations } = await axeOn(page).include('phong-viewer').analyze();
  return violations.map(({ id }) => id);
};
const statesOf = (viewer: ViewerLocator) =>
  viewer.evaluate((element) =>
    ['loading', 'error', 'empty'].filter((name) => element.matches(`:state(${name})`)),
  );

test('shows a bar with a name and a value, or what is slotted, from 300 ms to the end', async ({
  page,
  mount,
}) => {
  const viewer = await mountSlow(page, mount);
  const surface = viewer.locator('[part=surface]');
  await expect(surface).toHaveAttribute('aria-busy', 'true');
  await expect(barOf(viewer)).toHaveCount(0);
  await delayOver(page);
  await expect(barOf(viewer)).toBeVisible();
  await expect(barOf(viewer)).toHaveAccessibleName('Loading');
  await assign(viewer, { texts: { Loading: 'Lädt' } });
  await expect(barOf(viewer)).toHaveAccessibleName('Lädt');
  await sendNext(page);
  await expect(barOf(viewer)).toHaveAttribute('aria-valuenow', '50');
  expect(await axeViolations(page)).toEqual([]);
  const own = viewer.locator('b');
  await viewer.evaluate((element) =>
    element.insertAdjacentHTML('beforeend', '<b slot="progress">Wait</b>'),
  );
  await expect(own).toBeVisible();
  await expect(viewer.locator('[part=progress]')).toBeHidden();
  await sendNext(page);
  await settled(viewer);
  await expect(own).toBeHidden();
  await expect(viewer.locator('[part=progress]')).toHaveCount(0);
  await expect(surface).not.toHaveAttribute('aria-busy');
});

test('the bar of an unknown size moves, except with reduced motion; paper shows no bar', async ({
  page,
  mount,
}) => {
  const viewer = await mountSlow(page, mount, { sizeIsKnown: false });
  await delayOver(page);
  await sendNext(page);
  await expect(barOf(viewer)).toBeVisible();
  await expect(barOf(viewer)).not.toHaveAttribute('aria-valuenow');
  const animations = () => viewer.evaluate((element) => element.shadowRoot!.getAnimations().length);
  expect(await animations()).toBe(1);
  await page.emulateMedia({ reducedMotion: 'reduce' });
  expect(await animations()).toBe(0);
  await page.emulateMedia({ media: 'print' });
  await expect(barOf(viewer)).toBeHidden();
});

test('progress does not decrease when one of several loads ends', async ({ page, mount }) => {
  const viewer = await mountSlow(page, mount, {
    inner: `<phong-mesh src="${slow}2"></phong-mesh>`,
  });
  await page.waitForFunction(() => window.loads.send.length === 4);
  await delayOver(page);
  await sendNext(page);
  await sendNext(page);
  await expect(barOf(viewer)).toHaveAttribute('aria-valuenow', '50');
  await sendNext(page);
  await expect(barOf(viewer)).toHaveAttribute('aria-valuenow', '75');
  await sendNext(page);
  await settled(viewer);
  await expect(barOf(viewer)).toHaveCount(0);
});

test('CSS can select viewers that are loading, failed or empty', async ({
  page,
  mount,
  consoleGuard,
}) => {
  consoleGuard.allow(/404/);
  await slowDown(page);
  const viewer = await mount('<phong-viewer alt="A model"></phong-viewer>', size);
  expect(await statesOf(viewer)).toEqual(['empty']);
  await assign(viewer, { src: slow });
  await expect.poll(() => statesOf(viewer)).toEqual(['loading']);
  const timers = () => page.evaluate(() => window.loads.timers.size);
  await expect.poll(timers).toBe(1);
  await sendAll(page, viewer);
  expect(await statesOf(viewer)).toEqual([]);
  expect(await timers()).toBe(0);
  await set(viewer, { src: '/none.glb' });
  expect(await statesOf(viewer)).toEqual(['error']);
  await assign(viewer, { src: null });
  await expect.poll(() => statesOf(viewer)).toEqual(['empty']);
  await viewer.evaluate((element) =>
    element.append(Object.assign(document.createElement('phong-mesh'), { geometry: 'box' })),
  );
  await expect.poll(() => statesOf(viewer)).toEqual([]);
  expect(await timers()).toBe(0);
  await viewer.evaluate((element) => element.replaceChildren());
  await expect.poll(() => statesOf(viewer)).toEqual(['empty']);
});

test('a browser without internals or custom states loads and shows everything', async ({
  page,
  mount,
}) => {
  for (const withdraw of [
    () =>
      (CustomStateSet.prototype.add = () => {
        throw new SyntaxError();
      }),
    () => Reflect.deleteProperty(ElementInternals.prototype, 'states'),
    () => Reflect.deleteProperty(HTMLElement.prototype, 'attachInternals'),
  ]) {
    await page.addInitScript(withdraw);
    const viewer = await mount(`<phong-viewer alt="A model" src="${model}"></phong-viewer>`, size);
    expect(await viewer.evaluate((element) => element.loaded), String(withdraw)).toBe(true);
  }
});
test('the first picture has all shapes but those that fail; the poster goes', async ({
  page,
  mount,
  consoleGuard,
}) => {
  consoleGuard.allow(/Failed to load resource/);
  let send: (() => void) | undefined;
  const code = /\/(solids|teapot)\./;
  await page.route(code, async (route) => {
    if (route.request().url().includes('teapot')) return route.abort();
    await new Promise<void>((resolve) => (send = resolve));
    return route.continue();
  });
  const shapes = ['sphere', 'torus', 'teapot', 'cone', 'box'];
  const meshes = shapes.map((shape) => `<phong-mesh geometry="${shape}"></phong-mesh>`).join('');
  const viewer = await mount(
    `<phong-viewer alt="Shapes" poster="${POSTER}" auto-rotate="30">${meshes}</phong-viewer>`,
    { ...size, waitForReady: false },
  );
  await expect.poll(() => send !== undefined).toBe(true);
  await expect(viewer.locator('[part=notice]')).toHaveText(/teapot/);
  await nextFrame(page);
  const shown = () =>
    viewer.evaluate(({ stats, shadowRoot }) => ({
      frames: stats.frames,
      posters: shadowRoot!.querySelectorAll('[part=poster]').length,
    }));
  expect(await shown()).toEqual({ frames: 0, posters: 1 });
  const drawn = await viewer.evaluateHandle((element: PhongViewer) => {
    const pictures: number[][] = [];
    element.addEventListener('render', () =>
      pictures.push([element.stats.frames, element.stats.drawCalls, element.camera.theta]),
    );
    return pictures;
  });
  send!();
  await expect.poll(() => drawn.evaluate(([first]) => first)).toEqual([1, 4, 30]);
  await expect(viewer.locator('[part=poster]')).toHaveCount(0);
});

test('an image in the slot "poster" lies over the picture, beside the panel, until the first one, also in print', async ({
  page,
  mount,
}) => {
  const image = `<img slot="poster" src="${POSTER}" width="20" height="10" alt="">`;
  const viewer = await mountSlow(page, mount, {
    attributes: `gui poster="${POSTER}"`,
    inner: image,
    width: 760,
    css: 'img { height: auto; margin: 5px; max-width: 50% }',
  });
  const poster = viewer.locator('> img');
  const place = () => viewer.locator('[part=surface]').boundingBox();
  await expect.poll(async () => (await poster.boundingBox())!.width).toBeCloseTo(454, 0);
  expect(await poster.boundingBox()).toEqual(await place());
  await expect(viewer.locator('[part=poster]')).toBeHidden();
  await page.emulateMedia({ media: 'print' });
  expect(await poster.boundingBox()).toEqual(await place());
  await page.emulateMedia({ media: null });
  await poster.evaluate((element) => element.remove());
  await expect(viewer.locator('[part=poster]')).toBeVisible();
  await viewer.evaluate((element, text) => element.insertAdjacentHTML('beforeend', text), image);
  await sendAll(page, viewer);
  await expect(poster).toBeHidden();
  await page.emulateMedia({ media: 'print' });
  await expect(poster).toBeHidden();
});

test('a poster that cannot be shown leaves no trace, and the next one is shown', async ({
  page,
  mount,
}) => {
  const viewer = await mountSlow(page, mount, { attributes: 'poster="data:image/png,none"' });
  const poster = viewer.locator('[part=poster]');
  await expect(poster).toHaveCount(0);
  await assign(viewer, { alt: 'The model' });
  await expect(viewer.getByRole('application', { name: 'The model' })).toHaveCount(1);
  await expect(poster).toHaveCount(0);
  await assign(viewer, { poster: POSTER });
  await expect(poster).toHaveCount(1);
  await sendAll(page, viewer);
  await expect(poster).toHaveCount(0);
});

test('the button of the message repeats what failed, and keeps the focus', async ({
  page,
  mount,
  consoleGuard,
}) => {
  consoleGuard.allow(/404/);
  let refuse = true;
  await page.route('**/none*.glb', (route) =>
    refuse
      ? route.fulfill({ status: 404 })
      : route.continue({ url: new URL(model, page.url()).href }),
  );
  const viewer = await mount(
    '<phong-viewer alt="Models" src="/none.glb"><phong-mesh src="/none2.glb"></phong-mesh></phong-viewer>',
    size,
  );
  const retry = viewer.getByRole('button', { name: 'Try again' });
  await expect(viewer.getByRole('alert')).toContainText('404');
  const box = (await retry.boundingBox())!;
  expect(box.height).toBeGreaterThanOrEqual(24);
  expect(box.width).toBeGreaterThanOrEqual(24);
  expect(await axeViolations(page)).toEqual([]);
  await retry.click();
  await settled(viewer);
  await expect(retry).toBeVisible();
  refuse = false;
  await retry.focus();
  await page.keyboard.press('Enter');
  await settled(viewer);
  await expect(retry).toHaveCount(0);
  await expect(viewer).toHaveJSProperty('loaded', true);
  await expect(viewer).toBeFocused();
});

test('the bar stands out in all colour schemes; dir="rtl" mirrors it and the panel’s signs', async ({
  page,
  mount,
}) => {
  const viewer = await mountSlow(page, mount, {
    attributes: 'dir="rtl" gui',
    width: 600,
    height: 400,
  });
  await delayOver(page);
  await sendNext(page);
  await expect(barOf(viewer)).toHaveAttribute('aria-valuenow', '50');
  const arrived = (await viewer.locator('.arrived').boundingBox())!;
  expect([arrived.x, arrived.width]).toEqual([300, 300]);
  const title = viewer.locator('.lil-title', { hasText: 'Camera' });
  expect(await title.evaluate((part) => getComputedStyle(part, '::before').scale)).toBe('-1 1');
  await title.click();
  const slider = viewer.locator('input[type=range]').first();
  const startOf = (part: Element) => getComputedStyle(part).getPropertyValue('--start');
  expect(await slider.evaluate(startOf)).toBe('-90deg');
  for (const scheme of ['light', 'dark']) {
    const [ground, empty, full] = await barOf(viewer).evaluate((bar, value) => {
      document.documentElement.style.colorScheme = value;
      const pixel = new OffscreenCanvas(1, 1).getContext('2d', { willReadFrequently: true })!;
      const green = (color: string) => {
        pixel.fillStyle = color;
        pixel.fillRect(0, 0, 1, 1);
        return pixel.getImageData(0, 0, 1, 1).data[1]!;
      };
      const { backgroundColor, color } = getComputedStyle(bar);
      document.body.style.color = 'Canvas';
      const canvas = getComputedStyle(document.body).color;
      return [green(canvas), green(backgroundColor), green(color)] as const;
    }, scheme);
    expect(ground > 127).toBe(scheme === 'light');
    expect(Math.abs(ground - empty), scheme).toBeLessThan(60);
    expect(Math.abs(empty - full), scheme).toBeGreaterThan(90);
  }
  await page.emulateMedia({ forcedColors: 'active' });
  const colors = await barOf(viewer).evaluate((bar) =>
    [bar, bar.firstElementChild!].map((part) => getComputedStyle(part).backgroundColor),
  );
  expect(colors[0]).not.toBe(colors[1]);
});
