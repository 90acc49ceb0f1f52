// The ray caster's sums over the lights are the reference's, at random points under random lights.
import fc from 'fast-check';
import { expect, it } from 'vitest';
import { LightCells } from '../../../src/extras/still/light-cells.js';
import { LightSums } from '../../../src/extras/still/lights.js';
import { basisOf } from '../../../src/phong/camera/orbit.js';
import { add, map, normalize, type Vec3 } from '../../../src/phong/math/vector.js';
import { shade } from '../../../src/phong/reference/index.js';
import { plainLight, plainVector } from '../../unit/arbitraries.js';

const zero = fc.constant<Vec3>([0, 0, 0]);
const anyVector = fc.oneof({ weight: 9, arbitrary: plainVector }, zero);
const anyLight = fc
  .tuple(
    plainLight,
    fc.record({
      axis: anyVector,
      aperture: fc.constantFrom(0, 5, 60, 90, 179, 180),
      cutoff: fc.constantFrom(0, 1e-7, 1, 40, 1e4),
    }),
  )
  .map(([plain, own]) => ({ ...plain, ...own }));

it('sums few of 10,000 spots at a point, and all that reach it', () => {
  const lights = Array.from({ length: 10_000 }, (_, i) => ({
    positional: true,
    place: [(i % 100) / 25 - 2, 1, Math.floor(i / 100) / 25 - 2] as const,
    axis: [0, -1, 0] as const,
    cosine: Math.cos(0.02),
    sine: Math.sin(0.02),
  }));
  const cells = new LightCells(lights, 4);
  for (let i = 0; i < 20_000; i++) {
    const [x, z] = [2 * Math.sin(i * i), 2 * Math.cos(3 * i)];
    const found = cells.at([x, -1, z]);
    if (i < 19_900) continue;
    const reaching = lights.filter(
      ({ place }) => Math.hypot(place[0] - x, place[2] - z) < 2 * Math.tan(0.02),
    );
    expect(found).toEqual(expect.arrayContaining(reaching));
    expect(found.length).toBeLessThan(100);
  }
});

it('has the light sums of the reference', () => {
  const white = { ka: [255, 255, 255], kd: [255, 255, 255], ks: [255, 255, 255] } as const;
  const scene = fc.record({
    lights: fc.array(anyLight, { maxLength: 4 }),
    p: plainVector,
    n: anyVector,
    eye: anyVector,
    shininess: fc.constantFrom(0, 0.3, 1, 32, 200, 1e5),
    isBlinn: fc.boolean(),
    linear: fc.boolean(),
  });
  fc.assert(
    fc.property(scene, ({ lights, p, n, eye, shininess, isBlinn, linear }) => {
      const camera = { eye, ...basisOf({ theta: 20, phi: 50 }), fov: 45 };
      const N = normalize(n);
      const V = normalize(map(p, (x) => -x));
      const sums = new LightSums(lights, camera, linear, 5);
      sums.at(p, N, V, shininess, isBlinn);
      const surface = { ...white, shininess };
      const options = { camera, linear, reflection: isBlinn ? 'blinn-phong' : 'phong' } as const;
      const { shares } = shade({ p: add(eye, p), normal: N, eye }, surface, lights, options);
      const total = (term: 'ambient' | 'diffuse' | 'specular') =>
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
