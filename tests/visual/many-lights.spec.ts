// Do thousands of lights work within the limits that WebGL 2 guarantees, and do many small ones
// cost only where they reach? Pictures are compared with float64 at samples, and with the loop over
// all lights.

import type { Page } from '@playwright/test';
import type { LightValues } from '../../src/phong/light/light-state.js';
import { expect, pixels, test, type Picture } from '../support/test.js';
import { drawFrames, drawUntilSpecialised } from '../element/frames/driving.js';
import {
  drawnWith,
  glPrograms,
  glSpent,
  isSpecialised,
  isLit,
  logGl,
} from '../element/support/gl-log.js';
import { assign, settled, statsOf, htmlOf } from '../element/support/viewer.js';
import { innerPixels } from './against-reference.js';
import { lightWith } from '../stress/case.js';
import { betweenPrograms, DifferenceSum, expectDrawnBy, picturesBy } from './between-programs.js';
import type { DeclaredScene } from './ray-cast.js';
import { Dice, dimmed, randomLight, randomScene, sceneMarkup } from './random-scene.js';

const SIZE = { width: 60, height: 42 };

/** WebGL 2's guaranteed minimum of uniforms and of a uniform block. */
const PROMISED = { vectors: 224, blockBytes: 16_384 } as const;

/** One pixel of so many is computed in float64. */
const EVERY = 23;

/**
 * The largest distance from float64 of sampled pixels, in codes beyond rounding, and how many
 * channels were compared.
 */
function sampled({ width, height, data }: Picture, scene: DeclaredScene) {
  const samples = innerPixels(scene, width, height, EVERY);
  let max = 0;
  for (const { x, y, hit } of samples) {
    for (const channel of [0, 1, 2] as const) {
      const off = data[4 * (y * width + x) + channel]! - 255 * hit.shaded.color[channel];
      max = Math.max(max, Math.abs(off) - 0.5);
    }
  }
  return { max, compared: 3 * samples.length };
}

/**
 * Lights of all kinds, so dim that `count` of them stay in range. Only the first few have cones,
 * because their edges are excluded.
 */
function crowd(count: number, seed: number): LightValues[] {
  const dice = new Dice(seed);
  return Array.from({ length: count }, (_, i) => {
    const light = dimmed(randomLight(dice), 1 / count);
    return { ...light, active: true, aperture: i < 8 ? light.aperture : 180 };
  });
}

async function expectWithinPromises(page: Page) {
  const programs = await glPrograms(page);
  expect(programs.some(isLit)).toBe(true);
  for (const { uniformVectors, blockBytes, fragment } of programs) {
    expect(uniformVectors, fragment).toBeLessThanOrEqual(PROMISED.vectors);
    expect(blockBytes, fragment).toBeLessThanOrEqual(PROMISED.blockBytes);
  }
}

test('one to 4,096 lights agree with float64, within the uniforms that WebGL 2 guarantees', async ({
  page,
  mount,
}) => {
  test.setTimeout(120_000);
  await logGl(page, {
    MAX_FRAGMENT_UNIFORM_VECTORS: PROMISED.vectors,
    MAX_VERTEX_UNIFORM_VECTORS: PROMISED.vectors,
    MAX_UNIFORM_BLOCK_SIZE: PROMISED.blockBytes,
  });
  const viewer = await mount('<phong-viewer></phong-viewer>', SIZE);
  const found: Record<string, number> = {};
  for (const count of [1, 16, 4096]) {
    const scene: DeclaredScene = { ...randomScene(4), lights: crowd(count, 7) };
    const markup = sceneMarkup(scene);
    await viewer.evaluate((element, html) => (element.outerHTML = html), markup);
    await settled(viewer);
    const { lightsActive, lightsSent } = await statsOf(viewer);
    expect(lightsActive).toBe(count);
    expect(lightsSent).toBeGreaterThan(count - 8 - 1); // but for cones that miss
    const general = (await picturesBy(page, [viewer], 'general', SIZE))[0]!;
    const errors = sampled(general, scene);
    // Within a code of the rounded value, as elsewhere: half a code beyond rounding is 1 code of
    // difference at most.
    expect(errors.max, `${count} lights`).toBeLessThan(0.5);
    expect(errors.compared).toBeGreaterThan(100);
    found[count] = errors.max;
    if (count > 16) continue; // the general program is as fast in software
    await drawUntilSpecialised(page);
    const specialised = (await picturesBy(page, [viewer], 'specialised', SIZE))[0]!;
    expect(sampled(specialised, scene).max, `${count} lights, specialised`).toBeLessThan(0.5);
    const difference = new DifferenceSum();
    difference.add(betweenPrograms(general, specialised));
    difference.expectPromise();
  }
  console.log('Codes beyond rounding, by number of lights:', JSON.stringify(found));
  await expectWithinPromises(page);
});

/**
 * Spots over a floor of 20 × 20, each reaching about a hundredth of it: a circle of radius 1.13.
 */
const FLOOR = { size: 20, height: 3, aperture: 20.6 } as const;

function spots(count: number, seed: number) {
  const dice = new Dice(seed);
  const spot = () =>
    lightWith({
      ambient: [dice.from(0, 4), 0, dice.from(0, 4)],
      diffuse: dice.vector(10, 40),
      specular: dice.vector(0, 30),
      position: [dice.from(-10, 10), FLOOR.height, dice.from(-10, 10), 1],
      axis: [dice.from(-0.1, 0.1), -1, dice.from(-0.1, 0.1)],
      aperture: FLOOR.aperture,
      cutoff: dice.pick([0, 2, 8.5]),
      attenuation: dice.chance(0.5) ? [1, 0, 0] : [1, 0.1, 0.05],
    });
  return Array.from({ length: count }, spot);
}

const overFloor = (lights: readonly LightValues[], shading = 'phong'): DeclaredScene => ({
  pose: { theta: 30, phi: 40, radius: 22, target: [0, 0, 0] },
  fov: 45,
  meshes: [
    {
      geometry: 'plane',
      position: [0, 0, 0],
      rotation: [0, 0, 0],
      scale: [FLOOR.size, 1, FLOOR.size],
      ka: [255, 255, 255],
      kd: [200, 210, 220],
      ks: [120, 120, 120],
      shininess: 20,
      ...(shading === 'gouraud' ? { segments: 24 } : {}),
    },
  ],
  lights,
  options: { reflection: 'phong', terms: ['ambient', 'diffuse', 'specular'], linear: false },
});

/** Whether the last frame was drawn with a light grid. */
async function usesGrid(page: Page) {
  await glSpent(page);
  await drawFrames(page, 1);
  return (await drawnWith(page))
    .filter(isLit)
    .every((one) => /HAS_LIGHT_GRID/.test(one.vertex + one.fragment) && isSpecialised(one));
}

test('five hundred spots on a floor look as with a loop over all, whatever changes', async ({
  page,
  mount,
}) => {
  test.setTimeout(120_000);
  await logGl(page);
  const scene = overFloor(spots(500, 3));
  const viewer = await mount(sceneMarkup(scene), SIZE);
  const sum = new DifferenceSum();
  /** The same state drawn once by the loop: a new viewer starts with general programs. */
  const expectLike = async (what: string) => {
    // It may owe its picture with all pixels.
    await settled(viewer);
    await glSpent(page);
    const shown = await pixels(viewer, SIZE);
    const markup = await htmlOf(viewer);
    const looped = await firstPicture(page, markup);
    const difference = betweenPrograms(shown, looped);
    expect(difference.max, what).toBeLessThanOrEqual(1);
    sum.add(difference);
  };
  const expectExact = async () =>
    expect(sampled(await pixels(viewer, SIZE), scene).max).toBeLessThan(0.5);
  await expectExact();
  await drawUntilSpecialised(page);
  expect(await usesGrid(page)).toBe(true);
  expect(await statsOf(viewer)).toMatchObject({ lightsActive: 500, drawCalls: 1 });
  await expectLike('settled');
  await expectExact();
  await assign(viewer, { theta: 75, phi: 25 });
  await expectLike('with the camera turned');
  await viewer.evaluate((element) => {
    for (const light of element.lights.slice(0, 200)) {
      const [x, y, z, w] = light.position;
      light.position = [-z, y, x, w];
    }
  });
  await expectLike('after lights have moved');
  expect(await usesGrid(page)).toBe(true);
  await viewer.evaluate((element) =>
    element.lights.forEach((light, i) => (light.active = i % 3 > 0)),
  );
  await drawUntilSpecialised(page);
  expect(await usesGrid(page)).toBe(true);
  await expectLike('settled with a third of the lights out');
  await assign(viewer.locator('phong-mesh'), { rotation: [25, 40, 10], scale: [14, 1, 25] });
  await expectLike('with the floor turned and stretched');
  await assign(viewer, { reflection: 'blinn-phong', colorInterpolation: 'linear' });
  await drawUntilSpecialised(page);
  await expectLike('in linear light');
  console.log(`500 spots: ${String(sum)}`);
  sum.expectPromise();
});

/** The first frame of this markup, in a second viewer, which is removed again. */
async function firstPicture(page: Page, markup: string) {
  await page.evaluate(
    (html) => document.body.insertAdjacentHTML('beforeend', `<section>${html}</section>`),
    markup,
  );
  const other = page.locator('section > phong-viewer');
  await settled(other);
  await glSpent(page);
  const picture = await pixels(other, SIZE);
  await expectDrawnBy(page, 'general');
  await other.evaluate((element) => element.parentElement?.remove());
  return picture;
}

test('@release five hundred spots on a floor of many vertices look alike under Gouraud', async ({
  page,
  mount,
}) => {
  test.setTimeout(120_000);
  await logGl(page);
  const markup = sceneMarkup(overFloor(spots(500, 4), 'gouraud'), 'gouraud');
  const viewer = await mount(markup, SIZE);
  const [looped] = await picturesBy(page, [viewer], 'general', SIZE);
  await drawUntilSpecialised(page);
  expect(await usesGrid(page)).toBe(true);
  const [shown] = await picturesBy(page, [viewer], 'specialised', SIZE);
  const sum = new DifferenceSum();
  sum.add(betweenPrograms(looped!, shown!));
  console.log(`500 spots under Gouraud: ${String(sum)}`);
  sum.expectPromise();
});
