// Does culling back faces change no picture and no program?

import type { Drawn, Step } from '../glsl/page/core.js';
import { expect, test } from '../support/test.js';
import {
  drawCore,
  expectSame,
  mixedLights,
  openCore,
  SETTLED,
  SIZE,
  tellingChannels,
} from './core-page.js';

const lights = mixedLights(3);

/** Eyes outside, far away, just outside, inside, and outside with the near plane inside. */
const VIEWS: Readonly<Record<string, Step>> = {
  outside: { eye: [1.2, 0.9, 1.4] },
  'far away': { eye: [20, 10, 30], fov: 3 },
  'near its surface': { eye: [0, 0, 0.62], near: 0.01 },
  inside: { eye: [0.1, 0.05, 0.2], near: 0.01 },
  'outside, cut open by the near plane': { eye: [0, 0, 1], near: 0.8 },
};

const SCALES: Readonly<Record<string, Step>> = {
  'as it is': { scale: [1, 1, 1] },
  mirrored: { scale: [-1, 1.1, 0.9] },
  'mirrored three times': { scale: [-1, -1, -1] },
  flattened: { scale: [1, 0, 1] },
};

/** Pixels that lie inside the outline: they and their neighbours are covered in full. */
function insideOutline({ codes }: Drawn, width: number) {
  const isFull = (i: number) => codes[4 * i + 3] === 255;
  const near = [0, 1, -1, width, -width, width + 1, width - 1, -width + 1, -width - 1];
  return Array.from({ length: codes.length / 4 }, (_, i) => i).filter((i) =>
    near.every((d) => isFull(i + d)),
  );
}

for (const shape of ['sphere', 'box'] as const) {
  test(`a closed ${shape} looks the same with and without its back faces, and compiles nothing`, async ({
    page,
  }) => {
    await openCore(page);
    const cases = Object.keys(SCALES).flatMap((scale) =>
      Object.keys(VIEWS).map((view) => [scale, view] as const),
    );
    const steps = cases.flatMap(([scale, view]) =>
      (['double', 'closed'] as const).map((sides): Step => ({
        near: 0.1,
        fov: 45,
        ...SCALES[scale],
        ...VIEWS[view],
        sides,
      })),
    );
    const drawn = await drawCore(page, { shape, lights, frames: SETTLED }, ...steps);
    expect(drawn.map(({ programs }) => programs)).toEqual(drawn.map(() => drawn[0]!.programs));
    cases.forEach(([scale, view], i) => {
      const [whole, culled] = [drawn[1 + 2 * i]!, drawn[2 + 2 * i]!];
      if (scale !== 'flattened') {
        expect.soft(tellingChannels(whole), `${scale}, ${view}`).toBeGreaterThan(64);
      }
      for (const pixel of insideOutline(whole, SIZE.width)) {
        for (let c = 0; c < 4; c++) {
          if (whole.codes[4 * pixel + c] !== culled.codes[4 * pixel + c]) {
            expect
              .soft(
                culled.codes.slice(4 * pixel, 4 * pixel + 4),
                `${scale}, ${view}, pixel ${String(pixel)}`,
              )
              .toEqual(whole.codes.slice(4 * pixel, 4 * pixel + 4));
          }
        }
      }
    });
  });
}

test('a single-sided surface is invisible from behind, a double-sided one is not', async ({
  page,
}) => {
  await openCore(page);
  const floor: Step = {
    shape: 'floor',
    lights: [{ position: [0, 1, 0, 0] }, { position: [0, -1, 0, 0] }],
  };
  const [above, below, mirrored, both] = await drawCore(
    page,
    { ...floor, sides: 'single', eye: [0, 3, 4] },
    { eye: [0, -3, 4] },
    { scale: [1, -1, 1] },
    { scale: [1, 1, 1], sides: 'double' },
  );
  const covered = ({ codes }: Drawn) => codes.filter((code, i) => i % 4 === 3 && code > 0).length;
  expect(covered(above!)).toBeGreaterThan(220);
  expect(covered(below!)).toBe(0);
  expect(covered(mirrored!)).toBe(covered(both!));
  expectSame(mirrored!, both!, 'from behind');
});
