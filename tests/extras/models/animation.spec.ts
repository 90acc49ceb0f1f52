// Do models move when `autoplay` says so, and only then? What is drawn, culled and explained is the
// pose of the last frame.

import { firstOf } from '../../support/repeats.js';
import { type ViewerLocator, compare, expect, pixels, same, test } from '../../support/test.js';
import { addressOf, bar } from '../../support/animated-gltf.js';
import { countEverything, expectIdle } from '../../element/support/counting.js';
import { comparedWithPicture, errorOf, isClear, show } from '../explain/shade-at-support.js';
import { assign, cameraOf, nextFrame } from '../../element/support/viewer.js';

const SIZE = { width: 160, height: 120 };
const BAR = addressOf(bar());
const LIGHT = '<phong-light position="1 2 3 0" ambient="30" specular="90"></phong-light>';
const viewerOf = (attributes: string, children = LIGHT) =>
  `<phong-viewer src="${BAR}" ${attributes}>${children}</phong-viewer>`;

/** Waits until this many more frames have been drawn. */
const played = (viewer: ViewerLocator, count = 3) =>
  viewer.evaluate(async (element, more) => {
    const end = element.stats.frames + more;
    while (element.stats.frames < end) {
      await new Promise(requestAnimationFrame);
    }
  }, count);

test.describe('nothing runs', () => {
  test.beforeEach(({ page }) => countEverything(page));

  test('without autoplay, at the rest pose, and with reduced motion, at the current one', async ({
    page,
    mount,
  }) => {
    const viewer = await mount(viewerOf(''), SIZE);
    await nextFrame(page);
    await expectIdle(page, 300);
    const still = await pixels(viewer);
    await assign(viewer, { autoplay: true });
    await played(viewer);
    expect(compare(await pixels(viewer), still).max).toBeGreaterThan(0);
    await page.emulateMedia({ reducedMotion: 'reduce' });
    await nextFrame(page);
    const frozen = await pixels(viewer);
    await expectIdle(page, 300);
    same(await pixels(viewer), frozen);
    await page.emulateMedia({ reducedMotion: 'no-preference' });
    await played(viewer);
    await assign(viewer, { autoplay: false });
    await nextFrame(page);
    same(await pixels(viewer), still);
    await expectIdle(page, 300);
  });

  test('out of view, and that time does not count', async ({ page, mount }) => {
    const viewer = await mount(viewerOf('autoplay'), SIZE);
    await played(viewer);
    await viewer.evaluate(({ style }) => (style.cssText += '; position: absolute; top: 9000px'));
    await nextFrame(page);
    await nextFrame(page);
    const before = await pixels(viewer, SIZE);
    await expectIdle(page, 300);
    same(await pixels(viewer, SIZE), before);
    await viewer.evaluate(({ style }) => (style.top = '0'));
    await played(viewer);
    expect(compare(await pixels(viewer, SIZE), before).max).toBeGreaterThan(0);
  });
});

test('`auto` frames all poses at the keys: a model that grows or slides stays in the picture', async ({
  mount,
  page,
}) => {
  const viewer = await mount('<phong-viewer></phong-viewer>', SIZE);
  /** The least distance of the picture from its edge while it plays, in pixels. */
  const margin = async () => {
    let least = Infinity;
    for (const end = performance.now() + 2100; performance.now() < end;) {
      const { data } = await pixels(viewer, SIZE);
      for (let i = 0; i < 160 * 120; i += 1) {
        if (data[4 * i + 3] === 0) continue;
        const [x, y] = [i % 160, Math.floor(i / 160)];
        least = Math.min(least, x, 159 - x, y, 119 - y);
      }
    }
    return least;
  };
  for (const name of firstOf(['slide', 'swell', 'bend'], 1)) {
    await show(viewer, viewerOf(`autoplay animation-name="${name}"`));
    expect.soft(await margin(), name).toBeGreaterThan(0);
  }
  const rest = await show(viewer, viewerOf('')).then(() => cameraOf(viewer));
  await assign(viewer, { autoplay: true, animationName: 'slide' });
  await nextFrame(page);
  await nextFrame(page);
  const wide = await cameraOf(viewer);
  expect(wide.radius).toBeGreaterThan(1.2 * rest.radius);
  await assign(viewer, { autoplay: false });
  await nextFrame(page);
  expect((await cameraOf(viewer)).radius).toBe(rest.radius);
});

test('target and radius stay while a model moves; bad names give warnings', async ({
  mount,
  consoleGuard,
}) => {
  consoleGuard.allow(/has no animation "dance".* It has: "bend", "slide", "swell"/, 1);
  const viewer = await mount(viewerOf('autoplay animation-name="slide"'), SIZE);
  const { target, radius } = await cameraOf(viewer);
  await played(viewer, 10);
  expect(await cameraOf(viewer)).toMatchObject({ target, radius });
  await assign(viewer, { animationName: 'dance' });
  await played(viewer);
});

test('shadeAt explains an animated picture of joints, morphs, flat copies and nodes', async ({
  page,
  mount,
}) => {
  const viewer = await mount('<phong-viewer></phong-viewer>', { width: 200, height: 150 });
  const plain = viewerOf('autoplay phi="80" radius="3"');
  const nodes = plain.replace(BAR, addressOf(bar({ skinned: false })));
  for (const [i, markup] of [
    plain,
    plain.replace('autoplay', 'autoplay shading="flat"'),
    nodes,
  ].entries()) {
    await show(viewer, markup);
    await played(viewer, 5);
    await page.emulateMedia({ reducedMotion: 'reduce' });
    await nextFrame(page);
    const judged = (await comparedWithPicture(viewer, 4)).filter(isClear);
    expect(judged.length, `viewer ${i}`).toBeGreaterThan(5);
    expect(
      judged.filter((fragment) => !(errorOf(fragment) <= 1)),
      `viewer ${i}`,
    ).toEqual([]);
    await page.emulateMedia({ reducedMotion: 'no-preference' });
  }
});
test('lights are culled by the pose of the last frame', async ({ mount }) => {
  // The spot lights a place that the bar reaches only during `slide`, which moves it by 3 along x
  // within a second.
  const spot = '<phong-light position="3 1 5 1" axis="0 0 -1" aperture="4"></phong-light>';
  const viewer = await mount(viewerOf('autoplay animation-name="slide"', LIGHT + spot), SIZE);
  const reached = (count: number) =>
    viewer.evaluate(async (element, wanted) => {
      while (element.stats.lightsSent !== wanted) {
        await new Promise(requestAnimationFrame);
      }
    }, count);
  await reached(1);
  await reached(2);
  await reached(1);
});
