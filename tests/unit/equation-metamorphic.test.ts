// Which changes of a scene leave the reference's result alone, or change it in a known way? A failing seed is printed.

import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import type { LightValues } from '../../src/light/light-state.js';
import { add, scale, type Vec3, type Vec4 } from '../../src/math/vector.js';
import {
  type CameraAxes,
  type Fragment,
  type ReferenceOptions,
  shade,
  type Surface,
} from '../../src/reference/equation.js';
import { anyLight, numbers, plainLight, plainVector, rotation, triple } from './arbitraries.js';

interface Scene {
  readonly fragment: Fragment;
  readonly surface: Surface;
  readonly lights: readonly LightValues[];
  readonly options: ReferenceOptions & { readonly camera: CameraAxes };
}

const channel = fc.integer({ min: 0, max: 255 });
const scenes: fc.Arbitrary<Scene> = fc.record({
  fragment: fc.record({ p: plainVector, normal: plainVector, eye: plainVector }),
  surface: fc.record({
    ka: triple(channel),
    kd: triple(channel),
    ks: triple(channel),
    shininess: fc.constantFrom(0, 1, 2.5, 32),
    baseColor: triple(channel.map((c) => c / 255)),
  }),
  lights: fc.array(plainLight, { minLength: 1, maxLength: 5 }),
  options: fc.record({
    camera: rotation.map(([right, up, back]) => ({ right, up, back })),
    reflection: fc.constantFrom('phong' as const, 'blinn-phong' as const),
    linear: fc.boolean(),
  }),
});

const sumOf = ({ fragment, surface, lights, options }: Scene): Vec3 =>
  shade(fragment, surface, lights, options).sum;

const near = (a: Vec3, b: Vec3, tolerance: number): void => {
  a.forEach((x, i) => {
    expect(Math.abs(x - b[i]!)).toBeLessThan(tolerance);
  });
};

const placed = (position: Vec4, move: (v: Vec3) => Vec3): Vec4 => [
  ...move([position[0], position[1], position[2]]),
  position[3],
];

/** Away from where the equation jumps: rounding may then take either side. */
function smooth({ fragment, surface, lights, options }: Scene): boolean {
  return shade(fragment, surface, lights, options).shares.every((share, i) => {
    if (share === null) return true;
    const { aperture } = lights[i]!;
    const angle = (Math.acos(Math.min(Math.max(share.c, -1), 1)) * 180) / Math.PI;
    const clearOfEdge = aperture === 180 || Math.abs(angle - aperture) > 1e-6;
    return clearOfEdge && Math.abs(share.NoL) > 1e-9 && share.d > 1e-3 && 1 + share.c > 1e-6;
  });
}

describe('the reference', () => {
  it('is the same to the bit in a scene scaled by a power of two, with attenuation to match', () => {
    fc.assert(
      fc.property(scenes, fc.integer({ min: -36, max: 60 }), (scene, k) => {
        const s = 2 ** k;
        const { p, normal, eye } = scene.fragment;
        const scaled: Scene = {
          ...scene,
          fragment: { p: scale(p, s), normal: scale(normal, s), eye: scale(eye, s) },
          lights: scene.lights.map((light) => {
            const [kc, kl, kq] = light.attenuation;
            return {
              ...light,
              position: placed(light.position, (v) => scale(v, s)),
              axis: scale(light.axis, s),
              attenuation: [kc, kl / s, kq / s / s],
            };
          }),
        };
        // Nearer than 1e-15 the equation itself has a scale.
        fc.pre(smooth(scene));
        expect(sumOf(scaled)).toStrictEqual(sumOf(scene));
      }),
      { numRuns: 300 },
    );
  });

  it('does not depend on the lengths of normal, axis and the vector to a directional light', () => {
    fc.assert(
      fc.property(scenes, fc.double({ min: 1e-9, max: 1e9, noNaN: true }), (scene, s) => {
        fc.pre(smooth(scene));
        const stretched: Scene = {
          ...scene,
          fragment: { ...scene.fragment, normal: scale(scene.fragment.normal, s) },
          lights: scene.lights.map((light) => ({
            ...light,
            axis: scale(light.axis, s),
            position: light.position[3] === 0 ? placed(light.position, (v) => scale(v, s)) : light.position,
          })),
        };
        near(sumOf(stretched), sumOf(scene), 1e-12);
      }),
      { numRuns: 300 },
    );
  });

  it('turns with the whole scene, camera and its lights included', () => {
    fc.assert(
      fc.property(scenes, rotation, (scene, [x, y, z]) => {
        fc.pre(smooth(scene));
        const turn = (v: Vec3): Vec3 => add(add(scale(x, v[0]), scale(y, v[1])), scale(z, v[2]));
        const { p, normal, eye } = scene.fragment;
        const { right, up, back } = scene.options.camera;
        const turned: Scene = {
          ...scene,
          fragment: { p: turn(p), normal: turn(normal), eye: turn(eye) },
          lights: scene.lights.map((light) =>
            light.space === 'camera'
              ? light
              : { ...light, position: placed(light.position, turn), axis: turn(light.axis) },
          ),
          options: { ...scene.options, camera: { right: turn(right), up: turn(up), back: turn(back) } },
        };
        // The steep start of sRGB's curve and small exponents enlarge the rotation's own roundings.
        near(sumOf(turned), sumOf(scene), 1e-9);
      }),
      { numRuns: 300 },
    );
  });

  it('moves with the whole scene', () => {
    fc.assert(
      fc.property(scenes, triple(fc.integer({ min: -(2 ** 20), max: 2 ** 20 })), (scene, offset) => {
        fc.pre(smooth(scene));
        const move = (v: Vec3): Vec3 => add(v, offset);
        const { p, normal, eye } = scene.fragment;
        const moved: Scene = {
          ...scene,
          fragment: { p: move(p), normal, eye: move(eye) },
          lights: scene.lights.map((light) =>
            light.space === 'camera' || light.position[3] === 0
              ? light
              : { ...light, position: placed(light.position, move) },
          ),
        };
        near(sumOf(moved), sumOf(scene), 1e-6);
      }),
      { numRuns: 300 },
    );
  });

  it('does not depend on the order of lights, beyond the rounding of a sum', () => {
    fc.assert(
      fc.property(scenes, (scene) => {
        near(sumOf({ ...scene, lights: scene.lights.toReversed() }), sumOf(scene), 1e-13);
      }),
      { numRuns: 300 },
    );
  });

  it('is not changed by lights that are off or black', () => {
    fc.assert(
      fc.property(scenes, anyLight, (scene, stranger) => {
        const black: LightValues = {
          ...stranger,
          ambient: [0, 0, 0],
          diffuse: [0, 0, 0],
          specular: [0, 0, 0],
        };
        const off: LightValues = { ...stranger, active: false };
        expect(sumOf({ ...scene, lights: [off, ...scene.lights, off] })).toStrictEqual(sumOf(scene));
        expect(sumOf({ ...scene, lights: [black, ...scene.lights] })).toStrictEqual(sumOf(scene));
      }),
      { numRuns: 300 },
    );
  });

  it('sees no difference between a light and its two halves', () => {
    const encoded: fc.Arbitrary<Scene> = scenes.map((scene) => ({
      ...scene,
      options: { ...scene.options, linear: false },
    }));
    fc.assert(
      fc.property(encoded, (scene) => {
        const half = (light: LightValues): LightValues => ({
          ...light,
          ambient: scale(light.ambient, 0.5),
          diffuse: scale(light.diffuse, 0.5),
          specular: scale(light.specular, 0.5),
        });
        const halves = scene.lights.flatMap((light) => [half(light), half(light)]);
        near(sumOf({ ...scene, lights: halves }), sumOf(scene), 1e-13);
      }),
      { numRuns: 300 },
    );
  });

  it('adds up from its terms, and from its lights', () => {
    fc.assert(
      fc.property(scenes, (scene) => {
        const options = { ...scene.options, linear: false };
        const whole = sumOf({ ...scene, options });
        const terms = (['ambient', 'diffuse', 'specular'] as const).map((term) =>
          sumOf({ ...scene, options: { ...options, terms: [term] } }),
        );
        near(terms.reduce(add), whole, 1e-13);
        const lights = scene.lights.map((light) => sumOf({ ...scene, lights: [light], options }));
        near(lights.reduce(add), whole, 1e-13);
      }),
      { numRuns: 300 },
    );
  });

  it('is never darker with one more light', () => {
    fc.assert(
      fc.property(scenes, plainLight, (scene, more) => {
        const before = sumOf(scene);
        sumOf({ ...scene, lights: [...scene.lights, more] }).forEach((x, i) => {
          expect(x).toBeGreaterThanOrEqual(before[i]! - 1e-13);
        });
      }),
      { numRuns: 300 },
    );
  });

  it('shades a point of camera space as the same point of the world', () => {
    fc.assert(
      fc.property(scenes, (scene) => {
        fc.pre(smooth(scene));
        const { right, up, back } = scene.options.camera;
        const toWorld = (v: Vec3): Vec3 => add(add(scale(right, v[0]), scale(up, v[1])), scale(back, v[2]));
        const world = scene.lights.map((light): LightValues => {
          if (light.space === 'world') return light;
          const eye: Vec3 = light.position[3] === 1 ? scene.fragment.eye : [0, 0, 0];
          return {
            ...light,
            space: 'world',
            position: placed(light.position, (v) => add(toWorld(v), eye)),
            axis: toWorld(light.axis),
          };
        });
        near(sumOf({ ...scene, lights: world }), sumOf(scene), 1e-9);
      }),
      { numRuns: 300 },
    );
  });

  it('is finite and not negative for anything in the domains', () => {
    const coordinate = triple(numbers(-1e15, 1e15));
    const color = triple(numbers(0, 1e6));
    const anything = fc.record({
      fragment: fc.record({ p: coordinate, normal: coordinate, eye: coordinate }),
      surface: fc.record({ ka: color, kd: color, ks: color, shininess: numbers(0, 1e6) }),
      lights: fc.array(anyLight, { maxLength: 4 }),
      options: fc.record({
        camera: rotation.map(([right, up, back]) => ({ right, up, back })),
        reflection: fc.constantFrom('phong' as const, 'blinn-phong' as const),
        linear: fc.boolean(),
      }),
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
});
