// Do models move when `autoplay` says so, and only then? What is drawn, culled and explained is the pose of the last
// frame.

import type { Locator } from '@playwright/test';
import { compare, expect, pixels, test } from '../../support/test.js';
import { addressOf, bar } from '../../support/animated-gltf.js';
import { countEverything, NOTHING, spentIn } from '../support/counting.js';
import { comparedWithPicture, errorOf, isClear } from '../shade-at/shade-at-support.js';
import { assign, cameraOf, nextFrame, type PhongViewer } from '../support/viewer.js';

const SIZE = { width: 160, height: 120 };
const BAR = addressOf(bar());
const LIGHT = '<phong-light position="1 2 3 0" ambient="30" specular="90"></phong-light>';
const viewerOf = (attributes: string, children = LIGHT): string =>
  `<phong-viewer src="${BAR}" ${attributes}>${children}</phong-viewer>`;

/** Waits until this many more frames have been drawn. */
const played = (viewer: Locator, count = 3): Promise<void> =>
  viewer.evaluate(async (element: PhongViewer, more) => {
    const end = element.stats.frames + more;
    while (element.stats.frames < end) await new Promise(requestAnimationFrame);
  }, count);

/** The scene's first vertex, in world space. */
const vertexOf = (viewer: Locator): Promise<number[]> =>
  viewer.evaluate((element: PhongViewer) => {
    const places: number[][] = [];
    element.scene.traverse((object) => {
      const mesh = object as unknown as {
        isMesh?: boolean;
        geometry: { attributes: { position: { array: Float32Array } } };
        matrixWorld: { elements: number[] };
      };
      if (mesh.isMesh !== true) return;
      const { array } = mesh.geometry.attributes.position;
      places.push([...array.slice(-12, -9), ...mesh.matrixWorld.elements.slice(12, 15)]);
    });
    return places.flat();
  });

test.describe('nothing runs', () => {
  test.beforeEach(({ page }) => countEverything(page));

  test('without autoplay: a model stands still, and returns to its rest pose', async ({ page, mount }) => {
    const viewer = await mount(viewerOf(''), SIZE);
    await nextFrame(page);
    expect(await spentIn(page, 300)).toEqual(NOTHING);
    const still = await pixels(viewer);
    await assign(viewer, { autoplay: true });
    await played(viewer);
    expect(compare(await pixels(viewer), still).max).toBeGreaterThan(0);
    await assign(viewer, { autoplay: false });
    await nextFrame(page);
    expect(compare(await pixels(viewer), still).max).toBe(0);
    expect(await spentIn(page, 300)).toEqual(NOTHING);
  });

  test('with reduced motion, which freezes the current pose', async ({ page, mount }) => {
    const viewer = await mount(viewerOf('autoplay'), SIZE);
    await played(viewer);
    await page.emulateMedia({ reducedMotion: 'reduce' });
    await nextFrame(page);
    const still = await pixels(viewer);
    expect(await spentIn(page, 300)).toEqual(NOTHING);
    expect(compare(await pixels(viewer), still).max).toBe(0);
    await page.emulateMedia({ reducedMotion: 'no-preference' });
    await played(viewer);
  });

  test('out of view, and that time does not count', async ({ page, mount }) => {
    const viewer = await mount(viewerOf('autoplay'), SIZE);
    await played(viewer);
    await viewer.evaluate(({ style }: PhongViewer) => (style.cssText += '; position: absolute; top: 9000px'));
    await nextFrame(page);
    await nextFrame(page);
    const before = await vertexOf(viewer);
    expect(await spentIn(page, 300)).toEqual(NOTHING);
    expect(await vertexOf(viewer)).toEqual(before);
    await viewer.evaluate(({ style }: PhongViewer) => (style.top = '0'));
    await played(viewer);
    expect(await vertexOf(viewer)).not.toEqual(before);
  });
});

test('autoplay keeps target and radius while the model moves', async ({ page, mount }) => {
  const viewer = await mount(viewerOf('autoplay animation-name="slide"'), SIZE);
  const { target, radius } = await cameraOf(viewer);
  await played(viewer, 10);
  await page.emulateMedia({ reducedMotion: 'reduce' });
  expect(await cameraOf(viewer)).toMatchObject({ target, radius });
});

test('animation-name selects an animation, and an unknown name gives a warning', async ({
  page,
  mount,
  consoleGuard,
}) => {
  consoleGuard.allow(/has no animation "dance".* It has: "bend", "slide", "swell"/, 1);
  const viewer = await mount(viewerOf('autoplay animation-name="swell"'), SIZE);
  await played(viewer);
  await assign(viewer, { animationName: 'dance' });
  await played(viewer);
  await page.emulateMedia({ reducedMotion: 'reduce' });
});

test('two meshes with one file move apart', async ({ page, mount }) => {
  const meshes = `<phong-mesh src="${BAR}" autoplay></phong-mesh><phong-mesh src="${BAR}"></phong-mesh>`;
  const viewer = await mount(`<phong-viewer>${meshes}${LIGHT}</phong-viewer>`, SIZE);
  await played(viewer);
  await page.emulateMedia({ reducedMotion: 'reduce' });
  const [moved, still] = await viewer.evaluate((element: PhongViewer) =>
    element.scene.children.map((root) => {
      const [mesh] = root.children as unknown as {
        geometry: { attributes: { position: { array: number[] } } };
      }[];
      return Array.from(mesh!.geometry.attributes.position.array);
    }),
  );
  expect(moved).not.toEqual(still);
});

for (const [what, markup] of [
  ['joints and morph targets', viewerOf('autoplay phi="80" radius="3"')],
  ['a flat copy', viewerOf('autoplay shading="flat" phi="80" radius="3"')],
  ['nodes', viewerOf('autoplay phi="80" radius="3"').replace(BAR, addressOf(bar({ skinned: false })))],
] as const) {
  test(`shadeAt explains the picture in the middle of an animation of ${what}`, async ({ page, mount }) => {
    const viewer = await mount(markup, { width: 400, height: 300 });
    await played(viewer, 5);
    await page.emulateMedia({ reducedMotion: 'reduce' });
    await nextFrame(page);
    const judged = (await comparedWithPicture(viewer, 7)).filter(isClear);
    expect(judged.length).toBeGreaterThan(5);
    expect(judged.filter((fragment) => errorOf(fragment) > 1)).toEqual([]);
  });
}

test('lights are culled by the pose of the last frame', async ({ page, mount }) => {
  // The spot lights a place that the bar reaches only during `slide`, which moves it by 3 along x within a second.
  const spot = '<phong-light position="3 1 5 1" axis="0 0 -1" aperture="4"></phong-light>';
  const viewer = await mount(viewerOf('autoplay animation-name="slide"', LIGHT + spot), SIZE);
  const reached = (count: number): Promise<void> =>
    viewer.evaluate(async (element: PhongViewer, wanted) => {
      while (element.stats.lightsSent !== wanted) await new Promise(requestAnimationFrame);
    }, count);
  await reached(1);
  await reached(2);
  await reached(1);
  await page.emulateMedia({ reducedMotion: 'reduce' });
});
