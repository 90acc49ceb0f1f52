// Does `phong-viewer/core` draw the same with every program and storage, with and without back faces?

import type { Step } from '../glsl/page/core.js';
import type { LightValues } from '../../src/light/light-state.js';
import { firstOf } from '../support/repeats.js';
import { expect, pixels, test } from '../support/test.js';
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

const view: Step = { eye: [1.2, 0.9, 1.4], fov: 45 };

/** From one light to more than any uniform array holds: the last two are read from a texture. */
const COUNTS = firstOf([1, 70, 400, 60, 2000], 3);

test('the general program draws the same from a texture, from uniform arrays of each capacity, and specialised', async ({
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
    const [again] = await drawCore(page, steps.at(-2)!, { lights: mixedLights(1), frames: 2 }).then((list) =>
      list.slice(-1),
    );
    expectSame(again!, drawn[device][0]!, `${device}, one light after many`);
  }
  COUNTS.forEach((count, i) => {
    const pictures = [
      drawn.software[2 * i]!,
      drawn.software[2 * i + 1]!,
      drawn.gpu[2 * i]!,
      drawn.gpu[2 * i + 1]!,
    ];
    expect(tellingChannels(pictures[0]!), `${String(count)} lights`).toBeGreaterThan(880);
    for (const picture of pictures.slice(1)) expectSame(picture, pictures[0]!, `${String(count)} lights`);
  });
  expect(drawn.software[1]!.isSpecialised).toBe(true);
  expect(drawn.gpu[1]!.isSpecialised).toBe(true);
});

// Those of software are in skipping.spec.ts, and in the tests of the elements.
for (const device of firstOf(['gpu', 'software'] as const, 1)) {
  test(`specialised programs draw the same as the general one, ${device}`, async ({ page }) => {
    await openCore(page, device);
    for (const [count, step] of [
      [1, {}],
      [2, { style: { reflection: 'blinn-phong' } }],
      [5, { style: { shading: 'gouraud' }, shape: 'sphere' }],
      [8, { surface: { shininess: 33.5 } }],
      [8, { style: { terms: ['diffuse'] } }],
    ] as const satisfies readonly (readonly [number, Step])[]) {
      const lights = mixedLights(count, count);
      const [general, settled] = await drawCore(page, { ...view, ...step, lights }, { frames: SETTLED });
      expect(general!.isSpecialised).toBe(false);
      expect(settled!.isSpecialised, JSON.stringify(step)).toBe(true);
      expect(settled!.programs).toBe(general!.programs + 1);
      expectSame(settled!, general!, JSON.stringify(step));
    }
  });
}

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
    const [general, settled] = await drawCore(
      page,
      { shape: 'floor', eye: [0, 5, 6], lights },
      { frames: SETTLED },
    );
    expect([general!.isSpecialised, settled!.isSpecialised]).toEqual([false, true]);
    expect(tellingChannels(general!)).toBeGreaterThan(880);
    expectSame(settled!, general!, device);
  }
});

test('toggling, moving, recolouring, adding and removing lights of a declared kind adds no general program', async ({
  page,
}) => {
  for (const device of ['software', 'gpu'] as const) {
    await openCore(page, device);
    const lamp: Partial<LightValues> = { position: [1, 2, 3, 1] };
    const changes = [
      [lamp, {}],
      [{ ...lamp, active: false }, {}],
      [{ position: [3, 2, 1, 1] }, {}],
      [{ ...lamp, diffuse: [9, 90, 200] }, {}],
      [lamp, lamp, {}, {}, {}],
      [lamp],
    ] as const;
    const drawn = await drawCore(page, ...changes.map((lights): Step => ({ ...view, lights, frames: 5 })));
    expect(
      drawn.map(({ programs }) => programs),
      device,
    ).toEqual(changes.map(() => 1));
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
      const [before, after, settled] = await drawCore(
        page,
        { ...view, lights, frames: SETTLED },
        { lose: true, frames: 2 },
        { frames: SETTLED },
      );
      expect(tellingChannels(before!)).toBeGreaterThan(880);
      expectSame(after!, before!, `${String(lights.length)} lights, at once`);
      expectSame(settled!, before!, `${String(lights.length)} lights, settled`);
    }
  });
}

test('a three.js camera draws the same as the element', async ({ page, mount }) => {
  const lights =
    '<phong-light position="1 2 3" ambient="20"></phong-light><phong-light space="camera" position="-1 0 1 0"></phong-light>';
  const html = `<phong-viewer geometry="box" ka="200" kd="200" ks="128" radius="3" theta="30" phi="70" target="0 0 0">${lights}</phong-viewer>`;
  const viewer = await mount(html, SIZE);
  const element = await pixels(viewer, SIZE);
  const [theta, phi] = [Math.PI / 6, (70 * Math.PI) / 180];
  const eye = [
    3 * Math.sin(phi) * Math.sin(theta),
    3 * Math.cos(phi),
    3 * Math.sin(phi) * Math.cos(theta),
  ] as const;
  await openCore(page);
  const [core] = await drawCore(page, {
    eye,
    fov: 45,
    target: [0, 0, 0],
    surface: { ka: [200, 200, 200], kd: [200, 200, 200], ks: [128, 128, 128] },
    lights: [
      { position: [1, 2, 3, 1], ambient: [20, 20, 20] },
      { space: 'camera', position: [-1, 0, 1, 0] },
    ],
  });
  const { width, height } = SIZE;
  let compared = 0;
  let off = 0;
  for (let y = 0; y < height; y++)
    for (let x = 0; x < width; x++) {
      const [top, bottom] = [4 * (y * width + x), 4 * ((height - 1 - y) * width + x)];
      if (element.data[top + 3] !== 255 || core!.codes[bottom + 3] !== 255) continue;
      compared += 1;
      if ([0, 1, 2].some((c) => Math.abs(element.data[top + c]! - core!.codes[bottom + c]!) > 1)) off += 1;
    }
  expect(compared).toBeGreaterThan(440);
  // Pixels on the edges between two faces: the samples of a canvas and of a picture lie at different places.
  expect(off).toBeLessThan(28);
});
