// Does the page rest while nothing changes? Counts frames, timers and WebGL calls from outside (counting.ts).

import type { Locator } from '@playwright/test';
import { allReady, expect, test } from '../../support/test.js';
import { countEverything, countsOf, NOTHING, spentBetween, spentIn } from '../support/counting.js';
import { assign, drag, nextFrame, type PhongViewer, record } from '../support/viewer.js';

const size = { width: 90, height: 60 };
const light = '<phong-light position="1 2 3 0"></phong-light>';
const box = `<phong-viewer geometry="box">${light}</phong-viewer>`;

test.beforeEach(({ page }) => countEverything(page));

/** Milliseconds: eighteen frames, and longer than usual polling intervals. */
const A_WHILE = 300;

test('no frame, timer or WebGL call happens while nothing changes, nor after a motion has ended', async ({
  page,
  mount,
}) => {
  const viewer = await mount(`${box}${box}`, size);
  expect((await countsOf(page)).layouts).toBeGreaterThan(0); // of the first look
  const stills: (readonly [string, () => Promise<unknown>])[] = [
    ['at first', () => Promise.resolve()],
    ['after a drag', () => drag(page, [45, 30], [20, 10])],
    ['after the wheel', () => page.mouse.wheel(0, 50)],
    ['after a key', () => page.keyboard.press('ArrowLeft')],
    ['with the pointer away', () => page.mouse.move(500, 500)],
    ['with a light less', () => viewer.evaluate((element: PhongViewer) => element.lights[0]?.remove())],
    ['after turning by itself', () => turnAWhile(viewer)],
    ['turning, for those who want no motion', () => turnUnmoved(viewer)],
  ];
  const frames = (): Promise<number> => viewer.evaluate((element: PhongViewer) => element.stats.frames);
  for (const [when, act] of stills) {
    const before = await frames();
    await act();
    await allReady(page);
    await nextFrame(page);
    if (when.startsWith('after')) expect(await frames(), when).toBeGreaterThan(before);
    expect(await spentIn(page, A_WHILE), when).toEqual(NOTHING);
  }
});

/** Sets `auto-rotate` and removes it after some frames. */
const turnAWhile = (viewer: Locator): Promise<void> =>
  viewer.evaluate(async (element: PhongViewer) => {
    const end = element.stats.frames + 3;
    element.autoRotate = 45;
    while (element.stats.frames < end) await new Promise(requestAnimationFrame);
    element.autoRotate = 0;
  });

async function turnUnmoved(viewer: Locator): Promise<void> {
  await viewer.page().emulateMedia({ reducedMotion: 'reduce' });
  await assign(viewer, { autoRotate: 45 });
}

/** Ways to be on a page but out of sight. Each runs in the page. */
const UNSEEN: Readonly<Record<string, (place: HTMLElement, hidden: boolean) => void>> = {
  'off screen': ({ style }, hidden) => (style.cssText = hidden ? 'position: absolute; top: 9000px' : ''),
  'not displayed': ({ style }, hidden) => (style.display = hidden ? 'none' : ''),
  'of no size': ({ style }, hidden) =>
    (style.cssText = hidden ? 'width: 0; height: 0; overflow: hidden' : ''),
  'under visibility: hidden': ({ style }, hidden) => (style.visibility = hidden ? 'hidden' : ''),
  'under content-visibility: hidden': ({ style }, hidden) =>
    Reflect.set(style, 'contentVisibility', hidden ? 'hidden' : ''),
  'under the hidden attribute': (place, hidden) => (place.hidden = hidden),
  'hidden itself': (place, hidden) => {
    for (const viewer of place.querySelectorAll('phong-viewer')) viewer.hidden = hidden;
  },
  'invisible itself': (place, hidden) => {
    for (const { style } of place.querySelectorAll('phong-viewer')) style.visibility = hidden ? 'hidden' : '';
  },
  'in a closed <details>': (place, hidden) => (place.querySelector('details')!.open = !hidden),
  'in a background tab': (_, hidden) => {
    const visibilityState = hidden ? 'hidden' : 'visible';
    Object.defineProperties(document, {
      visibilityState: { value: visibilityState, configurable: true },
      hidden: { value: hidden, configurable: true },
    });
    document.dispatchEvent(new Event('visibilitychange'));
  },
};

test('nothing happens out of sight, and changes are drawn once when the viewer becomes visible', async ({
  page,
  mount,
}) => {
  const turning = box.replace('geometry', 'auto-rotate="45" geometry');
  await mount(`<section><details open><summary>Two</summary>${box}${turning}</details></section>`, { ...size, css: '[hidden] { display: none !important }' }); // prettier-ignore
  const place = page.locator('section');
  const [still, turned] = [page.locator('phong-viewer').first(), page.locator('phong-viewer').last()];
  const frames = (viewer: Locator): Promise<number> =>
    viewer.evaluate((element: PhongViewer) => element.stats.frames);
  for (const [how, hide] of Object.entries(UNSEEN)) {
    const turns = await frames(turned);
    await expect.poll(() => frames(turned), `turning before it is ${how}`).toBeGreaterThan(turns);
    await place.evaluate(hide as (place: Element, hidden: boolean) => void, true);
    await nextFrame(page);
    await nextFrame(page);
    const drawn = await frames(still);
    for (const diffuse of [[1, 2, 3], [255, 255, 255], [200, 90, 0]]) // prettier-ignore
      await still.evaluate((element: PhongViewer, value) => (element.lights[0]!.diffuse = value as [number, number, number]), diffuse); // prettier-ignore
    expect(await spentIn(page, A_WHILE), how).toEqual(NOTHING);
    await place.evaluate(hide as (place: Element, hidden: boolean) => void, false);
    await expect.poll(() => frames(still), how).toBe(drawn + 1);
    await nextFrame(page);
    expect(await frames(still), how).toBe(drawn + 1);
  }
});

test('many changes in one task make one frame', async ({ page, mount }) => {
  const viewer = await mount(`${box}${box}`, size);
  const renders = await record(viewer, 'render');
  await nextFrame(page);
  const before = await countsOf(page);
  await viewer.evaluate((element: PhongViewer) => {
    for (let i = 0; i < 50; i++) {
      element.theta = i;
      element.kd = [i, i, i];
      element.lights[0]!.diffuse = [i, i, i];
      element.lights[0]!.setAttribute('cutoff', String(i));
      element.append(document.createElement('phong-light'));
    }
    element.append(document.createElement('phong-mesh'));
    element.meshes[0]!.geometry = 'sphere';
    element.setAttribute('fov', '50');
    const other = element.nextElementSibling as PhongViewer;
    other.theta = 3;
  });
  await allReady(page);
  expect((await countsOf(page)).frames - before.frames).toBe(1);
  expect((await renders.take()).length).toBe(1);
});

test('a change that changes nothing draws nothing', async ({ page, mount }) => {
  const viewer = await mount(box, size);
  await nextFrame(page);
  const before = await countsOf(page);
  await viewer.evaluate((element: PhongViewer) => {
    element.theta = 30;
    element.lights[0]!.position = [1, 2, 3, 0];
    element.setAttribute('alt', 'A box');
  });
  await nextFrame(page);
  expect(spentBetween(before, await countsOf(page)).gl).toBe(0);
});

test('a viewer alone on its page shows the WebGL canvas itself, also after others have gone', async ({
  page,
  mount,
}) => {
  const viewer = await mount(box, size);
  const direct = (): Promise<boolean> =>
    viewer.evaluate((element: PhongViewer) => element.shadowRoot?.querySelector('canvas')?.getContext('webgl2') instanceof WebGL2RenderingContext); // prettier-ignore
  expect(await direct()).toBe(true);
  const alone = await viewer.screenshot();
  await page.evaluate(
    (html) => document.body.insertAdjacentHTML('beforeend', html),
    box.replace('box', 'torus'),
  );
  await allReady(page);
  await nextFrame(page);
  expect(await direct()).toBe(false);
  expect(Buffer.compare(await viewer.screenshot(), alone)).toBe(0);
  await page.evaluate(() => document.querySelector('phong-viewer:last-of-type')?.remove());
  await allReady(page);
  await nextFrame(page);
  expect(await direct()).toBe(true);
  expect(Buffer.compare(await viewer.screenshot(), alone)).toBe(0);
});
