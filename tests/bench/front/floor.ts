// The scene that all ways to write the light loop draw: a bent floor that fills the picture. Points and normals are exact in
// float32, so a difference from float64 comes from the arithmetic of the light loop alone.
import { LightState, type LightValues, shade } from 'phong-viewer/reference';
import type { Vec3 } from '../pages/scenes.js';

export interface Floor {
  readonly lights: readonly LightValues[];
  readonly shininess: number;
  readonly eye: Vec3;
  /** Half of the picture's height in scene units: a power of two. */
  readonly half: number;
}

/** The floor is z = -BEND (x² + y²). A power of two. */
export const BEND = 2 ** -6;
/** Reflectances 0 to 1. */
export const SURFACE = { ka: 1, kd: 1, ks: 0.5 } as const;

/** A light of each kind; their highlights coincide and fill a sixth of the picture. */
export function floorOf(shininess: number): Floor {
  const width = 1 / Math.sqrt(shininess);
  const reach = Math.min(width, 0.3);
  const mirrored = (dx: number, dy: number): Vec3 => [-1 + dx * reach, dy * reach, 3];
  const colors = { diffuse: [40, 40, 40], specular: [100, 100, 100] } as const;
  const [a, b, c] = [mirrored(0.3, -0.2), mirrored(-0.4, 0.1), mirrored(0.1, 0.4)];
  const cone = { axis: [-c[0], -c[1], -c[2]] as const, aperture: 40, cutoff: 12 };
  return {
    lights: [
      { ...colors, position: [...a, 0] as const },
      { ...colors, position: [...b, 1] as const, attenuation: [1, 0.05, 0.01] as const },
      { ...colors, position: [...c, 1] as const, ...cone },
    ].map((values) => new LightState(values).values),
    shininess,
    eye: [1, 0, 3],
    half: Math.min(2 ** Math.round(Math.log2(6 * width)), 1),
  };
}

/**
 * A square picture in float64, three channels of 255 a pixel, rows from the bottom. `pace` lets the
 * page live in between.
 */
export async function floorTruth(
  { lights, shininess, eye, half }: Floor,
  side: number,
  pace: () => Promise<void>,
): Promise<Float64Array> {
  const grey = (k: number) => [255 * k, 255 * k, 255 * k] as const;
  const surface = { ka: grey(SURFACE.ka), kd: grey(SURFACE.kd), ks: grey(SURFACE.ks), shininess };
  const step = (2 * half) / side;
  const data = new Float64Array(3 * side * side);
  for (let j = 0; j < side; j++) {
    for (let i = 0; i < side; i++) {
      const [x, y] = [(i + 0.5 - side / 2) * step, (j + 0.5 - side / 2) * step];
      const p = [x, y, -BEND * (x * x + y * y)] as const;
      const { color } = shade({ p, normal: [2 * BEND * x, 2 * BEND * y, 1], eye }, surface, lights);
      color.forEach((channel, k) => (data[3 * (i + side * j) + k] = 255 * channel));
    }
    await pace();
  }
  return data;
}
