// Does the page rest while nothing changes? Counts frames, timers and WebGL calls from outside
// (counting.ts).

import { allReady, expect, test } from '../../support/test.js';
import { countEverything, countsOf, spentBetween, expectIdle } from '../support/counting.js';
import { assign, drag, framesOf, nextFrame, type PhongViewer, record } from '../support/viewer.js';

const size = { width: 90, height: 60 };
const light = '<phong-light position="1 2 3 0"></phong-light>';
const box = `<phong-viewer geometry="box">${light}</phong-viewer>`;

test.beforeEach(({ page }) => countEverything(page));

/** Milliseconds: eighteen frames, and longer than usual polling intervals. */
const A_WHILE = 300;

test('no frame, timer or WebGL call happens while nothing changes, nor after a motion', async ({
  page,
  mount,
}) => {
  const viewer = await mount(`${box}${box}`, size);
  expect((await countsOf(page)).layouts).toBeGreaterThan(0); // of the first look
  const turnAWhile = () =>
    viewer.evaluate(async (element) => {
      const end = element.stats.frames + 3;
      element.autoRotate = 45;
      while (element.stats.frames < end) {
        await new Promise(requestAnimationFrame);
      }
      element.autoRotate = 0;
    });
  const stills: (readonly [string, () => Promise<unknown>])[] = [
    ['at first', () => Promise.resolve()],
    ['after a drag', () => drag(page, [45, 30], [20, 10])],
    ['after the wheel', () => page.mouse.wheel(0, 50)],
    ['after a key', () => page.keyboard.press('ArrowLeft')],
    ['with the pointer away', () => page.mouse.move(500, 500)],
    ['with a light less', () => viewer.evaluate((element) => element.lights[0]?.remove())],
    ['after turning by itself', turnAWhile],
    ['with reduced motion', () => page.emulateMedia({ reducedMotion: 'reduce' })],
    ['turning, with reduced motion', () => assign(viewer, { autoRotate: 45 })],
  ];
  for (const [when, act] of stills) {
    const before = await framesOf(viewer);
    await act();
    await allReady(page);
    await nextFrame(page);
    if (when.startsWith('after')) {
      expect(await framesOf(viewer), when).toBeGreaterThan(before);
    }
    await expectIdle(page, A_WHILE, when);
  }
});

/** Ways to be on a page but out of sight. Each runs in the page. */
const UNSEEN: Readonly<Record<string, (place: HTMLElement, hidden: boolean) => void>> = {
  'off screen': ({ style }, hidden) =>
    (style.cssText = hidden ? 'position: absolute; top: 9000px' : ''),
  'not displayed': ({ style }, hidden) => (style.display = hidden ? 'none' : ''),
  'of no size': ({ style }, hidden) =>
    (style.cssText = hidden ? 'width: 0; height: 0; overflow: hidden' : ''),
  'under visibility: hidden': ({ style }, hidden) => (style.visibility = hidden ? 'hidden' : ''),
  'under content-visibility: hidden': ({ style }, hidden) =>
    (style.contentVisibility = hidden ? 'hidden' : ''),
  'under the hidden attribute': (place, hidden) => (place.hidden = hidden),
  'hidden itself': (place, hidden) => {
    for (const viewer of place.querySelectorAll('phong-viewer')) {
      viewer.hidden = hidden;
    }
  },
  'invisible itself': (place, hidden) => {
    for (const { style } of place.querySelectorAll('phong-viewer')) {
      style.visibility = hidden ? 'hidden' : '';
    }
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

test('nothing happens out of sight; changes are drawn once when the viewer is visible', async ({
  page,
  mount,
}) => {
  const turning = box.replace('geometry', 'auto-rotate="45" geometry');
  await mount(`<section><details open><summary>Two</summary>${box}${turning}</details></section>`, {
    ...size,
    css: '[hidden] { display: none !important }',
  });
  const place = page.locator('section');
  const [still, turned] = [
    page.locator('phong-viewer').first(),
    page.locator('phong-viewer').last(),
  ];
  for (const [how, hide] of Object.entries(UNSEEN)) {
    const turns = await framesOf(turned);
    await expect.poll(() => framesOf(turned), `turning before it is ${how}`).toBeGreaterThan(turns);
    await place.evaluate(hide as (place: Element, hidden: boolean) => void, true);
    await nextFrame(page);
    await nextFrame(page);
    const drawn = await framesOf(still);
    for (const diffuse of [
      [1, 2, 3],
      [255, 255, 255],
      [200, 90, 0],
    ]) {
      await still.evaluate(
        (element: PhongViewer, value) =>
          (element.lights[0]!.diffuse = value as [number, number, number]),
        diffuse,
      );
    }
    await expectIdle(page, A_WHILE, how);
    await place.evaluate(hide as (place: Element, hidden: boolean) => void, false);
    await expect.poll(() => framesOf(still), how).toBe(drawn + 1);
    await nextFrame(page);
    expect(await framesOf(still), how).toBe(drawn + 1);
  }
});

test('many changes in one task make one frame, and those that change nothing make none', async ({
  page,
  mount,
}) => {
  const viewer = await mount(`${box}${box}`, size);
  const renders = await record(viewer, 'render');
  await nextFrame(page);
  const before = await countsOf(page);
  await viewer.evaluate((element) => {
    element.theta = 30;
    element.lights[0]!.position = [1, 2, 3, 0];
    element.setAttribute('alt', 'A box');
  });
  await nextFrame(page);
  const same = await countsOf(page);
  expect(spentBetween(before, same).gl).toBe(0);
  await viewer.evaluate((element) => {
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
  expect(spentBetween(same, await countsOf(page)).frames).toBe(1);
  expect((await renders.take()).length).toBe(1);
});

test('a viewer alone on its page shows the WebGL canvas itself, after others went too', async ({
  page,
  mount,
}) => {
  const viewer = await mount(box, size);
  const alone = await viewer.screenshot();
  const other = box.replace('box', 'torus');
  for (const count of [1, 2, 1]) {
    if (count === 2) {
      await page.evaluate((html) => document.body.insertAdjacentHTML('beforeend', html), other);
    } else {
      await page.evaluate(() => document.querySelector('phong-viewer + phong-viewer')?.remove());
    }
    await allReady(page);
    await nextFrame(page);
    const isDirect = await viewer.evaluate(
      (element) =>
        element.shadowRoot?.querySelector('canvas')?.getContext('webgl2') instanceof
        WebGL2RenderingContext,
    );
    expect(isDirect).toBe(count === 1);
    expect(Buffer.compare(await viewer.screenshot(), alone)).toBe(0);
  }
});
