// The ray caster's sums over the lights are the reference's, at random points under random lights.
import fc from 'fast-check';
import { expect, it } from 'vitest';
import { LightCells } from '../../../src/extras/still/light-cells.js';
import { LightSums } from '../../../src/extras/still/lights.js';
import { basisOf } from '../../../src/phong/camera/orbit.js';
import { add, dot, map, normalize, subtract, type Vec3 } from '../../../src/phong/math/vector.js';
import { shade } from '../../../src/phong/reference/index.js';
import { plainLight } from '../../unit/arbitraries.js';

const number = (min: number, max: number): fc.Arbitrary<number> =>
  fc.double({ min, max, noNaN: true });
/** Thousandths: points that are 1e-300 apart have no common direction in both spaces. */
const length = fc.integer({ min: -3000, max: 3000 }).map((n) => n / 1000);
const vector = fc.tuple(length, length, length);
/** What is not drawn here is as authors write it. */
const anyLight = fc
  .tuple(
    plainLight,
    fc.record({
      position: fc.tuple(length, length, length, fc.constantFrom(0, 1)),
      axis: fc.oneof(vector, fc.constant([0, 0, 0] as const)),
      aperture: fc.oneof(number(0, 180), fc.constantFrom(0, 90, 180)),
      cutoff: fc.oneof(number(0, 64), fc.constantFrom(0, 1e-7, 1e4)),
      attenuation: fc.tuple(number(0, 2), number(0, 1), number(0, 1)),
      ambient: fc.tuple(number(0, 99), number(0, 99), number(0, 99)),
      diffuse: fc.tuple(number(0, 999), number(0, 255), number(0, 255)),
      space: fc.constantFrom('world' as const, 'camera' as const),
      active: fc.boolean(),
    }),
  )
  .map(([plain, own]) => ({ ...plain, ...own }));

it('sums a few of 10,000 spots at a point, and leaves out none that reaches it', () => {
  const cosine = Math.cos(0.02);
  const lights = Array.from({ length: 10_000 }, (_, i) => ({
    positional: i % 2500 !== 0,
    place: [(i % 100) / 25 - 2, 1, Math.floor(i / 100) / 25 - 2] as const,
    axis: normalize([Math.sin(i), -9, Math.cos(i)]),
    cosine,
    sine: Math.sin(0.02),
  }));
  const cells = new LightCells(lights, 4);
  let summed = 0;
  for (let i = 0; i < 20_000; i++) {
    const p: Vec3 = [2 * Math.sin(i * i), Math.sin(i) / 9 - 1, 2 * Math.cos(3 * i)];
    const found = cells.at(p);
    if (i < 19_000) continue;
    summed += found.length;
    const needed = lights.filter(
      ({ positional, place, axis }) =>
        !positional || dot(normalize(subtract(p, place)), axis) >= cosine,
    );
    expect(found).toEqual(lights.filter((light) => found.includes(light)));
    expect(needed.filter((light) => !found.includes(light))).toEqual([]);
  }
  expect(summed / 1000).toBeLessThan(60);
});

it('has the light sums of the reference', () => {
  const white = { ka: [255, 255, 255], kd: [255, 255, 255], ks: [255, 255, 255] } as const;
  const scene = fc.record({
    lights: fc.array(anyLight, { maxLength: 4 }),
    p: vector.filter((v) => v.some((x) => x !== 0)),
    n: vector,
    eye: vector,
    shininess: fc.oneof(number(0, 200), fc.constantFrom(0, 1e5)),
    isBlinn: fc.boolean(),
    linear: fc.boolean(),
  });
  fc.assert(
    fc.property(scene, ({ lights, p, n, eye, shininess, isBlinn, linear }) => {
      const camera = { eye, ...basisOf({ theta: 20, phi: 50 }), fov: 45 };
      const N = normalize(n);
      const V = normalize(map(p, (x) => -x));
      const sums = new LightSums(lights, camera, linear, 3);
      sums.at(p, N, V, shininess, isBlinn);
      const surface = { ...white, shininess };
      const options = { camera, linear, reflection: isBlinn ? 'blinn-phong' : 'phong' } as const;
      const { shares } = shade({ p: add(eye, p), normal: N, eye }, surface, lights, options);
      const total = (term: 'ambient' | 'diffuse' | 'specular'): Vec3 =>
        shares.reduce<Vec3>((sum, s) => (s === null ? sum : add(sum, s[term])), [0, 0, 0]);
      const expected = [...total('ambient'), ...total('diffuse'), ...total('specular')];
      // The point relative to the eye rounds otherwise than in the world: 1e-15 times the exponent.
      const most = 1e-13 * Math.max(1, shininess, ...lights.map(({ cutoff }) => cutoff));
      expected.forEach((value, i) => {
        expect(Math.abs(sums.sums[i]! - value)).toBeLessThan(most * Math.max(1, value));
      });
    }),
    { seed: 20261128, numRuns: 3000 },
  );
});
