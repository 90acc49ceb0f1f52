// Does the page rest while nothing changes? Counts frames, timers and WebGL calls from outside
// (counting.ts).

import { allReady, expect, test } from '../../support/test.js';
import { countEverything, countsOf, expectIdle } from '../support/counting.js';
import { assign, drag, framesOf, nextFrame, type PhongViewer } from '../support/viewer.js';

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
