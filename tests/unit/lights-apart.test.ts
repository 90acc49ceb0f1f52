// Lights that stand apart from a box are at no point of it, in float32 neither: then the shader need not ask at each fragment.

import { describe, expect, it } from 'vitest';
import { areApart } from '../../src/light/light-apart.js';
import type { Box } from '../../src/light/cull-lights.js';
import type { LightValues } from '../../src/light/light-state.js';
import { light } from './arbitraries.js';
import { pack } from './packed-reader.js';

const BOX: Box = [-1, -2, -3, 1, 2, 3];
const SUN = light({ position: [0, 1, 0, 0] });

const lamp = (x: number, y: number, z: number): LightValues => light({ position: [x, y, z, 1] });
const spot = (x: number, y: number, z: number): LightValues =>
  light({ position: [x, y, z, 1], aperture: 30 });
const apart = (lights: readonly LightValues[], box = BOX): boolean => areApart(pack(lights), box);

describe.each([
  ['lamps', lamp],
  ['spots', spot],
])('%s', (_, at) => {
  it.each([0, 1, 2])('stand apart beyond either side along axis %i, and nowhere within', (axis) => {
    const along = (place: number): LightValues[] => {
      const p = [0, 0, 0];
      p[axis] = place;
      return [at(p[0]!, p[1]!, p[2]!)];
    };
    const half = BOX[axis + 3]!;
    expect(apart(along(half + 0.01))).toBe(true);
    expect(apart(along(-half - 0.01))).toBe(true);
    for (const place of [0, half - 0.01, 0.01 - half, half, -half]) expect(apart(along(place))).toBe(false);
  });

  it('stand apart by more than the rounding of a place that is far from the origin', () => {
    const far: Box = [1e6, 0, 0, 1e6 + 1, 1, 1];
    expect(apart([at(1e6 - 0.0625, 0.5, 0.5)], far)).toBe(false); // a step of float32 there
    expect(apart([at(1e6 + 1.0625, 0.5, 0.5)], far)).toBe(false);
    expect(apart([at(1e6 - 10, 0.5, 0.5)], far)).toBe(true);
  });

  it('stand apart only where each of them does', () => {
    const [out, inside] = [at(0, 5, 0), at(0.5, 0.5, 0.5)];
    expect(apart([out, out, out])).toBe(true);
    for (const i of [0, 1, 2]) expect(apart([out, out, out].map((one, k) => (i === k ? inside : one)))).toBe(false); // prettier-ignore
  });
});

describe('of mixed kinds', () => {
  it('suns stand nowhere, and every other light is looked at', () => {
    const out = [lamp(0, 5, 0), lamp(4, 0, 0), spot(0, 0, 9), spot(-3, 0, 0)];
    expect(apart([SUN, SUN, SUN])).toBe(true);
    expect(apart([SUN, ...out, SUN])).toBe(true);
    for (const i of out.keys()) {
      for (const make of [lamp, spot])
        expect(apart([SUN, ...out.map((one, k) => (k === i ? make(0, 0, 0) : one)), SUN])).toBe(false);
    }
    expect(apart([])).toBe(true);
  });
});
