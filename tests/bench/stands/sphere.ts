// A sphere that is round, by float64: what every mesh of one is an approximation of.
import { shade } from '../../../src/reference/equation.js';
import type { LightValues } from '../../../src/light/light-state.js';
import { add, dot, normalize, scale, subtract, type Vec3 } from '../../../src/math/vector.js';
import type { ColorPicture } from '../error/error-figures.js';
import { CAMERA, surfaceOf } from './core-view.js';
import type { Pace } from './stand.js';

export interface Ball {
  readonly center: Vec3;
  readonly radius: number;
}

/** A square picture of `ball` on black, a sample in the middle of each pixel, as the nearest codes. */
export async function roundSphere(
  { center, radius }: Ball,
  side: number,
  lights: readonly LightValues[],
  shininess: number,
  pace: Pace,
): Promise<ColorPicture> {
  const eye: Vec3 = [0, 0, CAMERA.radius];
  const surface = surfaceOf(shininess);
  const step = (2 * Math.tan((CAMERA.fov * Math.PI) / 360)) / side;
  const from = subtract(eye, center);
  const data = new Float64Array(3 * side * side);
  for (let j = 0; j < side; j++) {
    for (let i = 0; i < side; i++) {
      const ray = normalize([(i + 0.5 - side / 2) * step, (side / 2 - j - 0.5) * step, -1]);
      const b = dot(from, ray);
      const under = b * b - dot(from, from) + radius * radius;
      if (under <= 0) continue;
      const p = add(eye, scale(ray, -b - Math.sqrt(under)));
      const { color } = shade({ p, normal: subtract(p, center), eye }, surface, lights);
      color.forEach((channel, k) => (data[3 * (i + side * j) + k] = Math.round(255 * channel)));
    }
    await pace();
  }
  return { width: side, height: side, data };
}
