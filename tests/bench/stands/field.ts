// Boxes in rows, or one floor, under many lamps: what an error budget is tried on. Flat faces, so that no mesh is an
// approximation. Lengths in scene units, colours of 255; the eye is given as the element's attributes are.
import { shade } from '../../../src/reference/equation.js';
import { LightState, type LightValues } from '../../../src/light/light-state.js';
import { add, cross, normalize, scale, subtract, type Vec3 } from '../../../src/math/vector.js';
import type { ColorPicture } from '../error/error-figures.js';
import { Random } from '../../stress/random.js';
import type { Pace, Size } from './stand.js';

export interface Field {
  readonly lamps: readonly LightValues[];
  /** Centres of boxes of side 1; none: a floor at y = 0, `SIZE` wide. */
  readonly boxes: readonly Vec3[];
}

export const SIZE = 12;
export const EYE = { theta: 0, phi: 40, radius: 13, fov: 45 } as const;
const SHININESS = 32;
export const LOOK = {
  ka: [255, 255, 255],
  kd: [255, 255, 255],
  ks: [128, 128, 128],
  shininess: SHININESS,
} as const;

/** Half of the lamps are spots that look down. The more there are, the less far each reaches, at the same brightness in all. */
export function fieldOf(count: number, floor: boolean, seed: number): Field {
  const random = new Random(seed);
  const fall = count / 4;
  const lamps = Array.from({ length: count }, (_, i): LightValues => {
    const color = (): Vec3 => [random.from(100, 255), random.from(100, 255), random.from(100, 255)];
    const spot = {
      axis: [random.from(-0.3, 0.3), -1, random.from(-0.3, 0.3)],
      aperture: 50,
      cutoff: 8,
    } as const;
    return new LightState({
      position: [random.from(-SIZE / 2, SIZE / 2), random.from(1, 2), random.from(-SIZE / 2, SIZE / 2), 1],
      ...{ diffuse: color(), specular: color(), attenuation: [1, 0, fall] },
      ...(i % 2 === 0 ? spot : {}),
    }).values;
  });
  const boxes: Vec3[] = [];
  if (!floor) for (let z = -4; z <= 4; z += 2) for (let x = -5; x <= 5; x += 2) boxes.push([x, 0, z]);
  return { lamps, boxes };
}

interface Hit {
  readonly p: Vec3;
  readonly normal: Vec3;
  readonly face: number;
}

/** Where a ray first meets the field. */
function hit({ boxes }: Field, eye: Vec3, ray: Vec3): Hit | null {
  let nearest: (Hit & { t: number }) | null = null;
  if (boxes.length === 0) {
    const t = -eye[1] / ray[1];
    const p = add(eye, scale(ray, t));
    const inside = t > 0 && Math.max(Math.abs(p[0]), Math.abs(p[2])) < SIZE / 2;
    return inside ? { p: [p[0], 0, p[2]], normal: [0, 1, 0], face: 0 } : null;
  }
  boxes.forEach((center, i) => {
    let [enter, leave, axis] = [-Infinity, Infinity, 0];
    for (let k = 0; k < 3; k++) {
      const near = (center[k]! - Math.sign(ray[k]!) * 0.5 - eye[k]!) / ray[k]!;
      const far = (center[k]! + Math.sign(ray[k]!) * 0.5 - eye[k]!) / ray[k]!;
      if (near > enter) [enter, axis] = [near, k];
      leave = Math.min(leave, far);
    }
    if (enter > leave || enter <= 0 || (nearest !== null && nearest.t < enter)) return;
    const normal = [0, 1, 2].map((k) => (k === axis ? -Math.sign(ray[k]!) : 0)) as unknown as Vec3;
    nearest = { t: enter, p: add(eye, scale(ray, enter)), normal, face: 3 * i + axis };
  });
  return nearest;
}

/** The picture's hits, and null also beside edges, whose pixels are mixtures. */
export function insides(field: Field, [width, height]: Size): (Hit | null)[] {
  const { eye, right, up, forward } = camera();
  const step = (2 * Math.tan((EYE.fov * Math.PI) / 360)) / height;
  const at = (i: number, j: number): Hit | null => {
    const [x, y] = [(i + 0.5 - width / 2) * step, (height / 2 - j - 0.5) * step];
    return hit(field, eye, normalize(add(forward, add(scale(right, x), scale(up, y)))));
  };
  const hits = Array.from({ length: width * height }, (_, k) => at(k % width, Math.floor(k / width)));
  return hits.map((own, k) => {
    const [i, j] = [k % width, Math.floor(k / width)];
    if (own === null || i === 0 || j === 0 || i === width - 1 || j === height - 1) return null;
    const alike = [-width - 1, -width, -width + 1, -1, 1, width - 1, width, width + 1];
    return alike.every((step) => hits[k + step]?.face === own.face) ? own : null;
  });
}

/** What is inside faces as float64 has it, as codes; black elsewhere. */
export async function fieldReference(field: Field, [width, height]: Size, pace: Pace): Promise<ColorPicture> {
  const { eye } = camera();
  const data = new Float64Array(width * height * 3);
  for (const [k, own] of insides(field, [width, height]).entries()) {
    if (own === null) continue;
    const { color } = shade({ p: own.p, normal: own.normal, eye }, LOOK, field.lamps);
    color.forEach((channel, c) => (data[3 * k + c] = Math.round(255 * channel)));
    await pace();
  }
  return { width, height, data };
}

function camera(): { eye: Vec3; right: Vec3; up: Vec3; forward: Vec3 } {
  const [theta, phi] = [EYE.theta, EYE.phi].map((degrees) => (degrees * Math.PI) / 180) as [number, number];
  const back: Vec3 = [Math.sin(phi) * Math.sin(theta), Math.cos(phi), Math.sin(phi) * Math.cos(theta)];
  const right: Vec3 = [Math.cos(theta), 0, -Math.sin(theta)];
  const forward = subtract([0, 0, 0], back);
  return { eye: scale(back, EYE.radius), right, up: cross(back, right), forward };
}
