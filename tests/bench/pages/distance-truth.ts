// The sphere as the equation has it: float64, on the sphere itself, not on triangles; and how far a picture of 8 bits is from
// that. Rows from the top; differences in 1/255. Knows no peer.
import {
  type Fragment,
  shade,
  type ReferenceOptions,
  type Surface,
} from '../../../src/reference/equation.js';
import type { Vec3 } from '../../../src/math/vector.js';
import { LightState } from '../../../src/light/light-state.js';
import { EYE_Z, FOV, KD, KS, SHININESS, SIZE, SPHERE, TO_LIGHT } from './distance-scene.js';

export interface Distance {
  /** Pixels that were compared. */
  readonly pixels: number;
  /** Of their channels. Rounding to 8 bits alone makes 0.29 (1/√12) of it, */
  readonly rmse: number;
  /** and 0.5 of this. How triangles are rasterized adds 0.15 here in software, 0.2 with four times as many of them. */
  readonly max: number;
}

/**
 * Well inside: the sphere's edge is a matter of triangles and samples. At N·V = 0.3 the nearest of the mesh's chords is
 * farther from the edge than a pixel.
 */
const LEAST_NOV = 0.3;

/** Where a pixel's centre shows the sphere well inside its edge; null elsewhere. */
export function fragmentAt(x: number, y: number): Fragment | null {
  const half = Math.tan((FOV * Math.PI) / 360);
  const eye: Vec3 = [0, 0, EYE_Z];
  const dx = ((2 * (x + 0.5)) / SIZE - 1) * half;
  const dy = (1 - (2 * (y + 0.5)) / SIZE) * half;
  // |eye + t (dx, dy, -1)| = radius, the nearer of two solutions
  const a = dx * dx + dy * dy + 1;
  const c = EYE_Z * EYE_Z - SPHERE.radius * SPHERE.radius;
  const discriminant = EYE_Z * EYE_Z - a * c;
  if (discriminant < 0) return null;
  const t = (EYE_Z - Math.sqrt(discriminant)) / a;
  const p: Vec3 = [t * dx, t * dy, EYE_Z - t];
  const NoV = -(p[0] * dx + p[1] * dy - p[2]) / (SPHERE.radius * Math.sqrt(a));
  return NoV < LEAST_NOV ? null : { p, normal: p, eye };
}

/** `pixels`: RGBA of 8 bits. `terms` without `specular` compares what is left. */
export function distanceOf(pixels: ArrayLike<number>, options: ReferenceOptions): Distance {
  const light = new LightState({ position: [...TO_LIGHT, 0] }).values;
  const surface: Surface = { ka: [0, 0, 0], kd: KD, ks: KS, shininess: SHININESS };
  let [count, squares, max] = [0, 0, 0];
  for (let y = 0; y < SIZE; y++) {
    for (let x = 0; x < SIZE; x++) {
      const fragment = fragmentAt(x, y);
      if (fragment === null) continue;
      count += 1;
      const { color } = shade(fragment, surface, [light], options);
      color.forEach((channel, k) => {
        const difference = Math.abs(pixels[(y * SIZE + x) * 4 + k]! - 255 * channel);
        squares += difference * difference;
        max = Math.max(max, difference);
      });
    }
  }
  return { pixels: count, rmse: Math.sqrt(squares / (3 * count)), max };
}
