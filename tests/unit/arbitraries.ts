// Lights drawn from the whole of their domains, and moderate ones as authors write them. Values in
// HTML's units. Knows only what a light's values may be, never how they are used.

import fc from 'fast-check';
import { Quaternion, Vector3 } from 'three';
import { type LightValues, LIMITS } from '../../src/phong/light/light-state.js';
import type { Vec3, Vec4 } from '../../src/phong/math/vector.js';

export { lightWith as light } from '../stress/case.js';

/** Doubles from `min` to `max`. */
export const between = (min: number, max: number) => fc.double({ min, max, noNaN: true });

/** Doubles from `min` to `max`, the ends, 0, denormals and whole powers of ten among them. */
export function numbers(min: number, max: number): fc.Arbitrary<number> {
  const inside = (n: number) => n >= min && n <= max;
  const special = [
    0,
    5e-324,
    1e-310,
    1e-45,
    1e-30,
    1e-15,
    1e-6,
    0.5,
    1,
    255,
    1e6,
    1e12,
    1e15,
    min,
    max,
  ];
  const usual = { min: Math.max(min, -1000), max: Math.min(max, 1000) };
  return fc.oneof(
    { weight: 3, arbitrary: between(min, max) },
    { weight: 3, arbitrary: fc.double({ ...usual, noNaN: true }) },
    {
      weight: 2,
      arbitrary: fc.constantFrom(...[...special, ...special.map((n) => -n)].filter(inside)),
    },
  );
}

export const triple = (number: fc.Arbitrary<number>): fc.Arbitrary<Vec3> =>
  fc.tuple(number, number, number);

const placed = (number: fc.Arbitrary<number>): fc.Arbitrary<Vec4> =>
  fc.tuple(number, number, number, fc.constantFrom(0, 1));

const lightsFrom = (
  of: Record<'coordinate' | 'color' | 'aperture' | 'cutoff' | 'attenuation', fc.Arbitrary<number>>,
): fc.Arbitrary<LightValues> =>
  fc.record({
    name: fc.constant(''),
    active: fc.boolean(),
    ambient: triple(of.color),
    diffuse: triple(of.color),
    specular: triple(of.color),
    position: placed(of.coordinate),
    axis: triple(of.coordinate),
    aperture: of.aperture,
    cutoff: of.cutoff,
    attenuation: triple(of.attenuation),
    space: fc.constantFrom('world', 'camera'),
  });

/** Any light that the fields accept. */
export const anyLight: fc.Arbitrary<LightValues> = lightsFrom({
  coordinate: numbers(-LIMITS.coordinate, LIMITS.coordinate),
  color: numbers(0, LIMITS.color),
  aperture: numbers(0, 180),
  cutoff: numbers(0, LIMITS.exponent),
  attenuation: numbers(0, LIMITS.attenuation),
});

/** Lights as authors write them: a few decimals, well away from every limit. */
const plain = (min: number, max: number) =>
  fc.integer({ min: min * 100, max: max * 100 }).map((n) => n / 100);

export const plainLight: fc.Arbitrary<LightValues> = lightsFrom({
  coordinate: plain(-5, 5),
  color: fc.integer({ min: 0, max: 255 }),
  aperture: fc.constantFrom(5, 20, 60, 90, 130, 180),
  cutoff: fc.constantFrom(0, 0.5, 1, 8, 40),
  attenuation: plain(0, 2),
});

/** The same, lit and in world space. */
export const worldLight: fc.Arbitrary<LightValues> = plainLight.map((one) => ({
  ...one,
  active: true,
  space: 'world',
}));

/** Directions and places within a few units, never zero. */
export const plainVector: fc.Arbitrary<Vec3> = triple(plain(-5, 5)).filter((v) =>
  v.some((x) => x !== 0),
);

/** A rotation by columns: orthonormal to a few roundings. */
export const rotation: fc.Arbitrary<readonly [Vec3, Vec3, Vec3]> = fc
  .tuple(plain(-1, 1), plain(-1, 1), plain(-1, 1), plain(-1, 1))
  .filter((q) => q.some((x) => x !== 0))
  .map((q) => {
    const turn = new Quaternion(...q).normalize();
    const [x, y, z] = [new Vector3(1, 0, 0), new Vector3(0, 1, 0), new Vector3(0, 0, 1)].map(
      (axis) => axis.applyQuaternion(turn).toArray(),
    );
    return [x!, y!, z!];
  });
