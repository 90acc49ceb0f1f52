// Does the reference agree with the same equation in 50 digits? The vectors come from
// vectors/make_vectors.py, which knows only the written equation. Then what the vectors leave out,
// and laws for anything in the domain.

/// <reference types="vite/client" />
import fc from 'fast-check';
import { expect, it } from 'vitest';
import type { LightValues } from '../../../src/phong/light/light-state.js';
import type { Vec3 } from '../../../src/phong/math/vector.js';
import {
  coefficientsOf,
  type Fragment,
  type ReferenceOptions,
  shade,
  type Surface,
} from '../../../src/phong/reference/equation.js';
import { anyLight, light, numbers, rotation, triple } from '../arbitraries.js';
import text from '../vectors/equation.jsonl?raw';

const FACTS = ['c', 'att', 'decay', 'NoL', 'RoV'] as const;

interface Vector {
  readonly name: string;
  readonly fragment: Fragment;
  readonly surface: Surface;
  readonly lights: readonly Partial<LightValues>[];
  readonly options: ReferenceOptions;
  readonly want: {
    readonly sum: Vec3;
    readonly shares: readonly (
      | (Readonly<Record<(typeof FACTS)[number], number>> & { readonly inside: boolean })
      | null
    )[];
    /** Sum over the lights of the brightest channels of Ia, Id and Is. */
    readonly intensity: number;
  };
}

const vectors = text
  .trimEnd()
  .split('\n')
  .map((line) => JSON.parse(line) as Vector);
const names = [...new Set(vectors.map(({ name }) => name))];

it.each(names)('the reference agrees with 50 digits: %s', (name) => {
  for (const vector of vectors.filter((one) => one.name === name)) {
    const { fragment, surface, lights, options, want } = vector;
    const got = shade(fragment, surface, lights.map(light), options);
    const bound = 1e-12 * Math.max(1, want.intensity);
    want.sum.forEach((x, i) => {
      const message = `${JSON.stringify(vector)} gave ${got.sum.join(' ')}`;
      expect(Math.abs(got.sum[i]! - x), message).toBeLessThan(bound);
      expect(got.color[i]).toBe(Math.min(Math.max(got.sum[i]!, 0), 1));
    });
    want.shares.forEach((facts, i) => {
      const share = got.shares[i]!;
      if (facts === null) {
        expect(share).toBeNull();
        return;
      }
      expect(share.insideCone).toBe(facts.inside);
      for (const fact of FACTS) {
        expect(
          Math.abs(share[fact] - facts[fact]),
          `${fact} of ${JSON.stringify(vector)}`,
        ).toBeLessThan(1e-12);
      }
    });
  }
});

/** A floor seen from straight above: N = V = +z. */
const floor: Fragment = { p: [0, 0, 0], normal: [0, 0, 1], eye: [0, 0, 5] };
const white: Surface = {
  ka: [255, 255, 255],
  kd: [255, 255, 255],
  ks: [255, 255, 255],
  shininess: 2,
};
const grey = {
  ambient: [51, 51, 51],
  diffuse: [102, 102, 102],
  specular: [153, 153, 153],
} as const;

const one = (
  values: Partial<LightValues>,
  fragment: Partial<Fragment> = {},
  surface: Partial<Surface> = {},
  options: ReferenceOptions = {},
) =>
  shade(
    { ...floor, ...fragment },
    { ...white, ...surface },
    [light({ ...grey, ...values })],
    options,
  ).shares[0]!;

const even = (x: number): Vec3 => [x, x, x];

it('has no highlight by Blinn where light and eye are exactly opposite, whatever the normal', () => {
  for (let i = 1; i <= 100; i++) {
    const fragment = { normal: [i, 1, 7] as const, eye: [-4, 0, 0] as const };
    const { specular, NoL } = one(
      { position: [2, 0, 0, 1] },
      fragment,
      {},
      { reflection: 'blinn-phong' },
    );
    expect([...specular, NoL > 0]).toEqual([0, 0, 0, true]);
  }
});

it('the distance of a light is Infinity without a place', () => {
  expect(one({ position: [0, 0, 3, 0] }).d).toBe(Infinity);
});

it('a metal loses diffuse light and reflects its base colour; an unlit surface has that alone', () => {
  const look = { baseColor: [0.5, 0, 1], metalness: 0.25, lobeScale: 0.5 } as const;
  const { diffuse, specular } = one({ position: [0, 0, 1, 0] }, {}, look);
  [0.15, 0, 0.3].forEach((x, i) => expect(diffuse[i]).toBeCloseTo(x, 15));
  [0.3, 0.225, 0.375].forEach((x, i) => expect(specular[i]).toBeCloseTo(x, 15));
  expect(coefficientsOf({ ...white, ka: [51, 51, 51] }).ka).toEqual(even(0.2));
  const unlit = shade(floor, { ...white, ...look, unlit: true }, [light({ ...grey })]);
  expect([unlit.sum, unlit.shares[0]?.ambient]).toStrictEqual([[0.5, 0, 1], even(0)]);
});

it('a light in camera space needs the camera', () => {
  expect(() => one({ space: 'camera' })).toThrow('a light in camera space needs options.camera');
});

it.each([0, 9.9e-7, 1e-6, 1e6])('exponent %d turns base 0 into 1 only below 1e-6', (n) => {
  const power = n < 1e-6 ? 1 : 0;
  const share = one({ position: [0, 1, 0.1, 0] }, { eye: [0, 3, 4] }, { shininess: n });
  expect(share.RoV).toBeLessThan(0);
  expect(share.specular).toStrictEqual(even(0.6 * power));
  expect(one({ position: [0, 0, 2, 1], axis: [0, 0, 1], cutoff: n }).decay).toBe(power);
});

it('a light 1e-15 from the fragment has a direction', () => {
  expect(one({ position: [0, 0, 1e-15, 1] }).NoL).toBe(1);
});

it.each([
  { position: [0, 1, 1, 0], axis: [1, 0, 1], aperture: 120 },
  { position: [-3, -3, 0, 0], axis: [-3, 0, -3], aperture: 120 },
  { position: [0.3, 0.3, 0.2, 0], axis: [-3, -3, -2], aperture: 0 },
] as const)(
  'a direction of round numbers exactly at the edge of $aperture degrees is inside',
  (spot) => {
    expect(one(spot).insideCone).toBe(true);
  },
);

it('a light by the camera keeps its place relative to the eye where the eye is 1e15 from the origin', () => {
  const place = [1e15, 0, 0] as const;
  const camera = { right: [1, 0, 0], up: [0, 1, 0], back: [0, 0, 1] } as const;
  const beside = { position: [0.03, 0, 0, 1], space: 'camera' } as const;
  expect(one(beside, { p: place, eye: place }, {}, { camera }).d).toBe(0.03);
});

const options = fc.record({
  camera: rotation.map(([right, up, back]) => ({ right, up, back })),
  reflection: fc.constantFrom('phong' as const, 'blinn-phong' as const),
  linear: fc.boolean(),
});
it('the reference is finite and not negative for anything in the domains', () => {
  const coordinate = triple(numbers(-1e15, 1e15));
  const color = triple(numbers(0, 1e6));
  const anything = fc.record({
    fragment: fc.record({ p: coordinate, normal: coordinate, eye: coordinate }),
    surface: fc.record({ ka: color, kd: color, ks: color, shininess: numbers(0, 1e6) }),
    lights: fc.array(anyLight, { maxLength: 4 }),
    options,
  });
  fc.assert(
    fc.property(anything, ({ fragment, surface, lights, options }) => {
      const { sum, color: clamped } = shade(fragment, surface, lights, options);
      expect(sum.every((x) => Number.isFinite(x) && x >= 0)).toBe(true);
      expect(clamped.every((x) => x >= 0 && x <= 1)).toBe(true);
    }),
    { numRuns: 1000 },
  );
});
