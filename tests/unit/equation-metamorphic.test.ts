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
const options = fc.record({
  camera: rotation.map(([right, up, back]) => ({ right, up, back })),
  reflection: fc.constantFrom('phong' as const, 'blinn-phong' as const),
  linear: fc.boolean(),
});
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
  options,
});

/** Away from where the equation jumps: rounding may then take either side. */
const smoothScenes = scenes.filter(({ fragment, surface, lights, options }) =>
  shade(fragment, surface, lights, options).shares.every((share, i) => {
    if (share === null) return true;
    const { aperture } = lights[i]!;
    const angle = (Math.acos(Math.min(Math.max(share.c, -1), 1)) * 180) / Math.PI;
    const clearOfEdge = aperture === 180 || Math.abs(angle - aperture) > 1e-6;
    return clearOfEdge && Math.abs(share.NoL) > 1e-9 && share.d > 1e-3 && 1 + share.c > 1e-6;
  }),
);

const sumOf = ({ fragment, surface, lights, options }: Scene): Vec3 => shade(fragment, surface, lights, options).sum;

const near = (a: Vec3, b: Vec3, tolerance: number): void => {
  a.forEach((x, i) => {
    expect(Math.abs(x - b[i]!)).toBeLessThanOrEqual(tolerance);
  });
};

/** The sum is the same after a change of the scene by any value. */
function leavesSum<T>(
  from: fc.Arbitrary<Scene>,
  values: fc.Arbitrary<T>,
  tolerance: number,
  change: (scene: Scene, value: T) => Partial<Scene>,
): void {
  fc.assert(
    fc.property(from, values, (scene, value) => {
      near(sumOf({ ...scene, ...change(scene, value) }), sumOf(scene), tolerance);
    }),
    { numRuns: 300 },
  );
}

type Change = (v: Vec3) => Vec3;

function changed(light: LightValues, point: Change, vector = point): LightValues {
  const [x, y, z, w] = light.position;
  const position: Vec4 = [...(w === 1 ? point : vector)([x, y, z]), w];
  return { ...light, position, axis: vector(light.axis) };
}

const inWorld = ({ lights }: Scene, change: (light: LightValues) => LightValues): readonly LightValues[] =>
  lights.map((light) => (light.space === 'world' ? change(light) : light));

const inBasis =
  ([x, y, z]: readonly [Vec3, Vec3, Vec3]): Change =>
  (v) =>
    add(add(scale(x, v[0]), scale(y, v[1])), scale(z, v[2]));

const withColors = (light: LightValues, change: Change): LightValues => ({
  ...light,
  ambient: change(light.ambient),
  diffuse: change(light.diffuse),
  specular: change(light.specular),
});

const nothing = fc.constant(null);

describe('the reference', () => {
  it('is the same to the bit in a scene scaled by a power of two, with attenuation to match', () => {
    // Nearer than 1e-15 the equation itself has a scale.
    leavesSum(smoothScenes, fc.integer({ min: -36, max: 60 }), 0, ({ fragment, lights }, k) => {
      const s = 2 ** k;
      const grow: Change = (v) => scale(v, s);
      return {
        fragment: { p: grow(fragment.p), normal: grow(fragment.normal), eye: grow(fragment.eye) },
        lights: lights.map((light) => {
          const [kc, kl, kq] = light.attenuation;
          return { ...changed(light, grow), attenuation: [kc, kl / s, kq / s / s] };
        }),
      };
    });
  });

  it('does not depend on the lengths of normal, axis and the vector to a directional light', () => {
    const lengths = fc.double({ min: 1e-9, max: 1e9, noNaN: true });
    leavesSum(smoothScenes, lengths, 1e-12, ({ fragment, lights }, s) => {
      const stretch: Change = (v) => scale(v, s);
      return {
        fragment: { ...fragment, normal: stretch(fragment.normal) },
        lights: lights.map((light) => changed(light, (v) => v, stretch)),
      };
    });
  });

  it('turns with the whole scene, camera and its lights included', () => {
    // The steep start of sRGB's curve and small exponents enlarge the rotation's own roundings.
    leavesSum(smoothScenes, rotation, 1e-9, (scene, axes) => {
      const turn = inBasis(axes);
      const { fragment, options } = scene;
      const { right, up, back } = options.camera;
      return {
        fragment: { p: turn(fragment.p), normal: turn(fragment.normal), eye: turn(fragment.eye) },
        lights: inWorld(scene, (light) => changed(light, turn)),
        options: { ...options, camera: { right: turn(right), up: turn(up), back: turn(back) } },
      };
    });
  });

  it('moves with the whole scene', () => {
    const offsets = triple(fc.integer({ min: -(2 ** 20), max: 2 ** 20 }));
    leavesSum(smoothScenes, offsets, 1e-6, (scene, offset) => {
      const move: Change = (v) => add(v, offset);
      const { p, normal, eye } = scene.fragment;
      return {
        fragment: { p: move(p), normal, eye: move(eye) },
        lights: inWorld(scene, (light) => changed(light, move, (v) => v)),
      };
    });
  });

  it('shades a point of camera space as the same point of the world', () => {
    leavesSum(smoothScenes, nothing, 1e-9, ({ fragment, lights, options }) => {
      const { right, up, back } = options.camera;
      const toWorld = inBasis([right, up, back]);
      return {
        lights: lights.map((light) =>
          light.space === 'world'
            ? light
            : { ...changed(light, (v) => add(toWorld(v), fragment.eye), toWorld), space: 'world' },
        ),
      };
    });
  });

  it('does not depend on the order of lights, beyond the rounding of a sum', () => {
    leavesSum(scenes, nothing, 1e-13, ({ lights }) => ({ lights: lights.toReversed() }));
  });

  it('is not changed by lights that are off or black', () => {
    leavesSum(scenes, anyLight, 0, ({ lights }, stranger) => {
      const black = withColors(stranger, () => [0, 0, 0]);
      const off: LightValues = { ...stranger, active: false };
      return { lights: [off, black, ...lights, off] };
    });
  });

  const encoded = scenes.map((scene): Scene => ({ ...scene, options: { ...scene.options, linear: false } }));

  it('sees no difference between a light and its two halves', () => {
    leavesSum(encoded, nothing, 1e-13, ({ lights }) => ({
      lights: lights.flatMap((light) => {
        const half = withColors(light, (color) => scale(color, 0.5));
        return [half, half];
      }),
    }));
  });

  it('adds up from its terms, and from its lights', () => {
    fc.assert(
      fc.property(encoded, (scene) => {
        const { lights, options } = scene;
        const terms = (['ambient', 'diffuse', 'specular'] as const).map((term) =>
          sumOf({ ...scene, options: { ...options, terms: [term] } }),
        );
        near(terms.reduce(add), sumOf(scene), 1e-13);
        near(lights.map((light) => sumOf({ ...scene, lights: [light] })).reduce(add), sumOf(scene), 1e-13);
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
});
