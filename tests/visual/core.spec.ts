// Does `phong-viewer/core` draw the same with every program and storage, with and without back
// faces?

import type { Step } from '../glsl/page/core.js';
import type { LightValues } from '../../src/phong/light/light-state.js';
import { firstOf, fullOr } from '../support/repeats.js';
import { expect, test } from '../support/test.js';
import { lightWith } from '../stress/case.js';
import { compareWithReference } from './against-reference.js';
import {
  type Device,
  drawCore,
  expectSame,
  mixedLights,
  openCore,
  SETTLED,
  SIZE,
  tellingChannels,
} from './core-page.js';
import { cameraOf, type DeclaredScene } from './ray-cast.js';

const view: Step = { eye: [1.2, 0.9, 1.4], fov: 45 };

/** From one light to more than any uniform array holds: the last two are read from a texture. */
const COUNTS = firstOf([1, 70, 400, 60, 2000], 3);

test('the general program draws the same from a texture, from uniform arrays, and specialised', async ({
  page,
}) => {
  test.setTimeout(180_000);
  const steps = COUNTS.flatMap((count): Step[] => [
    { ...view, lights: mixedLights(count) },
    { frames: count < 100 ? SETTLED : 2 },
  ]);
  const drawn: Record<Device, Awaited<ReturnType<typeof drawCore>>> = { software: [], gpu: [] };
  for (const device of ['software', 'gpu'] as const) {
    await openCore(page, device);
    drawn[device] = await drawCore(page, ...steps);
    // And back: stale rows add nothing.
    const [, again] = await drawCore(page, steps.at(-2)!, { lights: mixedLights(1), frames: 2 });
    expectSame(again!, drawn[device][0]!, `${device}, one light after many`);
  }
  COUNTS.forEach((count, i) => {
    const [first, ...others] = [drawn.software, drawn.gpu].flatMap((list) =>
      list.slice(2 * i, 2 * i + 2),
    );
    expect(tellingChannels(first!), `${String(count)} lights`).toBeGreaterThan(880);
    for (const other of others) {
      expectSame(other, first!, `${String(count)} lights`);
    }
  });
  expect(drawn.software[1]!.isSpecialised).toBe(true);
  expect(drawn.gpu[1]!.isSpecialised).toBe(true);
});

// Those of software are in skipping.spec.ts, and in the tests of the elements.
test('specialised programs of GPUs draw the same as the general one', async ({ page }) => {
  await openCore(page, 'gpu');
  for (const [count, step] of [
    [1, {}],
    [2, { style: { reflection: 'blinn-phong' } }],
    [5, { style: { shading: 'gouraud' }, shape: 'sphere' }],
    [8, { surface: { shininess: 33.5 } }],
    [8, { style: { terms: ['diffuse'] } }],
  ] as const satisfies readonly (readonly [number, Step])[]) {
    const lights = mixedLights(count, count);
    const [general, settled] = await drawCore(
      page,
      { ...view, ...step, lights },
      { frames: SETTLED },
    );
    expect(general!.isSpecialised).toBe(false);
    expect(settled!.isSpecialised, JSON.stringify(step)).toBe(true);
    expect(settled!.programs).toBe(general!.programs + 1);
    expectSame(settled!, general!, JSON.stringify(step));
  }
});

test('a floor under many narrow spots looks the same with and without a grid', async ({ page }) => {
  const lights = Array.from({ length: 64 }, (_, i): Partial<LightValues> => ({
    position: [(i % 8) - 3.5, 1, Math.floor(i / 8) - 3.5, 1],
    axis: [0.1, -1, 0.05],
    aperture: 25,
    diffuse: [60 + 3 * i, 200 - i, 90],
    cutoff: i % 3,
    ambient: [3, 0, 5],
  }));
  for (const device of ['software', 'gpu'] as const) {
    await openCore(page, device);
    const floor: Step = { shape: 'floor', eye: [0, 5, 6], lights };
    const [general, settled] = await drawCore(page, floor, { frames: SETTLED });
    expect([general!.isSpecialised, settled!.isSpecialised]).toEqual([false, true]);
    expect(tellingChannels(general!)).toBeGreaterThan(880);
    expectSame(settled!, general!, device);
  }
});

test('a hundred equal meshes share one specialised program', async ({ page }) => {
  await openCore(page);
  const lights = mixedLights(4);
  const steps: Step[] = [{ ...view, meshes: 100, lights }, { frames: SETTLED }];
  const [general, settled] = await drawCore(page, ...steps);
  expect([general!.programs, settled!.programs]).toEqual([1, 2]);
  expectSame(settled!, general!, '100 meshes');
});

for (const device of firstOf(['gpu', 'software'] as const, 1)) {
  test(`a restored context draws the same again, ${device}`, async ({ page, consoleGuard }) => {
    consoleGuard.allow(/THREE.WebGLRenderer: Context (Lost|Restored)/);
    await openCore(page, device);
    for (const lights of [mixedLights(4), mixedLights(400)]) {
      const frames = lights.length < 100 ? SETTLED : fullOr(SETTLED, 2);
      const first: Step = { ...view, lights, frames };
      const [before, after, settled] = await drawCore(
        page,
        first,
        { lose: true, frames: 2 },
        { frames },
      );
      expect(tellingChannels(before!)).toBeGreaterThan(880);
      expectSame(after!, before!, `${String(lights.length)} lights, at once`);
      expectSame(settled!, before!, `${String(lights.length)} lights, settled`);
    }
  });
}

test('a three.js camera draws what the equation says, as the element does', async ({ page }) => {
  const surface = {
    ka: [200, 200, 200],
    kd: [200, 200, 200],
    ks: [128, 128, 128],
    shininess: 32,
  } as const;
  const lights = [
    lightWith({ position: [1, 2, 3, 1], ambient: [20, 20, 20] }),
    lightWith({ space: 'camera', position: [-1, 0, 1, 0] }),
  ];
  const scene: DeclaredScene = {
    pose: { theta: 30, phi: 70, radius: 3, target: [0, 0, 0] },
    fov: 45,
    meshes: [
      { geometry: 'box', position: [0, 0, 0], rotation: [0, 0, 0], scale: [1, 1, 1], ...surface },
    ],
    lights,
    options: {},
  };
  const { width, height } = SIZE;
  const { eye } = cameraOf(scene);
  await openCore(page);
  const [core] = await drawCore(page, { eye, fov: 45, target: [0, 0, 0], surface, lights });
  const data = new Uint8Array(4 * width * height);
  for (let y = 0; y < height; y++) {
    const row = core!.codes.subarray(4 * y * width, 4 * (y + 1) * width);
    data.set(row, 4 * (height - 1 - y) * width); // from the bottom
  }
  const errors = compareWithReference({ width, height, data }, scene);
  expect(errors.max, errors.at).toBeLessThanOrEqual(1);
  expect(errors.compared).toBeGreaterThan(440);
});
