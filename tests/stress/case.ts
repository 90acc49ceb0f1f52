// What one stress case is: a fragment in shading space, as the rasteriser would give it, a surface,
// and lights in world space, as authors would. Everything that the shader is given is exact in
// float32, so reference and shader see the same.
import { LIGHT_FIELDS, type LightValues } from '../../src/phong/light/light-state.js';
import { emptyPack, packLights, type PackedLights } from '../../src/phong/light/pack-lights.js';
import { add, type Mat4, negate, type Vec3 } from '../../src/phong/math/vector.js';
import {
  type CameraAxes,
  shade,
  type Shaded,
  type Surface,
} from '../../src/phong/reference/equation.js';
import type { Reflection } from '../../src/phong/material/material-values.js';
import { translation } from '../support/matrices.js';

export interface Variant {
  readonly reflection: Reflection;
  readonly linear: boolean;
}

export interface StressCase {
  /** Shading space; float32. The eye is there too. */
  readonly p: Vec3;
  readonly eye: Vec3;
  /** Any length; float32. In shading space, or in the mesh's own where `normalMatrix` is given. */
  readonly normal: Vec3;
  /** As the element would send it: nine float32 by columns. */
  readonly normalMatrix?: readonly number[];
  /**
   * What that matrix makes of the normal, found another way in float64; only its direction counts.
   */
  readonly exactNormal?: Vec3;
  /** World position of shading space's origin, such that the fragment's world position is exact. */
  readonly origin: Vec3;
  readonly camera: CameraAxes;
  readonly surface: Surface;
  readonly lights: readonly LightValues[];
}

/** Looking along −z. */
export const CAMERA: CameraAxes = { right: [1, 0, 0], up: [0, 1, 0], back: [0, 0, 1] };

export const ORIGIN: Vec3 = [0, 0, 0];

const DEFAULTS = Object.fromEntries(
  Object.entries(LIGHT_FIELDS).map(([key, field]) => [key, field.fallback]),
) as unknown as LightValues;

/** A light with these values, and the defaults for all others. */
export const lightWith = (values: Partial<LightValues> = {}): LightValues => ({
  ...DEFAULTS,
  ...values,
});

export function reference(stress: StressCase, { reflection, linear }: Variant): Shaded {
  const { p, eye, origin, camera, surface, lights } = stress;
  const normal = stress.exactNormal ?? stress.normal;
  const fragment = { p: add(origin, p), normal, eye: add(origin, eye) };
  return shade(fragment, surface, lights, { camera, reflection, linear });
}

const packed = emptyPack();

/** The lights as the shipped packing writes them for this case; good until the next call. */
export function pack(
  { origin, camera, eye, lights }: StressCase,
  { linear }: Variant,
): PackedLights {
  const { right, up, back } = camera;
  const cameraToShading: Mat4 = [...right, 0, ...up, 0, ...back, 0, ...eye, 1];
  const worldToShading = translation(negate(origin));
  packLights(lights, { worldToShading, cameraToShading, linear }, packed);
  return packed;
}

/**
 * What the contract's bounds are relative to, where it is above 1: the sum of the lights'
 * intensities, times the surface's largest coefficient where that is above 1 too.
 */
export function intensity({ lights, surface: { ka, kd, ks } }: StressCase): number {
  let sum = 0;
  for (const { active, ambient, diffuse, specular } of lights) {
    if (!active) continue;
    let brightest = 0;
    for (let i = 0; i < 3; i++) {
      brightest = Math.max(brightest, ambient[i]! + diffuse[i]! + specular[i]!);
    }
    sum += brightest / 255;
  }
  return sum * Math.max(1, Math.max(...ka, ...kd, ...ks) / 255);
}
