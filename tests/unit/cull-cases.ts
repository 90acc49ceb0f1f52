// Boxes, and lights whose cones graze them: of all sizes, from apexes inside and far away. Places are in shading space;
// each light is written in the world's or the camera's, as an author would. Knows geometry and lights' values, not how
// culling works.
import { type Box, cullLights } from '../../src/light/cull-lights.js';
import type { LightValues } from '../../src/light/light-state.js';
import type { PackedLights, PackSpace } from '../../src/light/pack-lights.js';
import { add, cross, dot, length, normalize, scale, subtract, type Vec3 } from '../../src/math/vector.js';
import { type CameraAxes, shade, type Shaded, type Surface } from '../../src/reference/equation.js';
import type { Random } from '../stress/random.js';
import { light } from './arbitraries.js';

/** Powers of ten from the smallest scene to the largest. */
const SIZES = [1e-9, 1e-3, 1, 1e6, 1e12] as const;

/** Apertures in degrees, beside those drawn from all. Narrower ones have tests of their own. */
const APERTURES = [1, 45, 89.999, 90, 90.001, 135, 179, 179.999, 180] as const;

/** Distances of apexes from the box's middle, in radii of the box: inside, at a corner, far away. */
const AWAY = [0, 0.5, 1, 1.1, 2, 10, 100] as const;

/**
 * Where the cone's edge passes, in angles that the bounding sphere subtends: 0 through its middle, 1 beside it, 3 far
 * away.
 */
const GRAZES = [-1, 0, 0.5, 0.9, 1, 1.001, 1.1, 1.5, 3] as const;

export interface View {
  /** Of shading space in the world, and of the eye in shading space. */
  readonly origin: Vec3;
  readonly eye: Vec3;
  readonly camera: CameraAxes;
}

export function anyView(random: Random, size: number): View {
  const back = random.unit();
  const right = random.around(back, Math.PI / 2);
  return {
    origin: scale(random.unit(), random.pick([0, size])),
    eye: scale(back, 4 * size),
    camera: { right, up: cross(back, right), back },
  };
}

export const spaceOf = ({ origin, eye, camera: { right, up, back } }: View, linear: boolean): PackSpace => ({
  worldToShading: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -origin[0], -origin[1], -origin[2], 1],
  cameraToShading: [...right, 0, ...up, 0, ...back, 0, ...eye, 1],
  linear,
});

export interface BoxCase {
  readonly size: number;
  readonly middle: Vec3;
  /** Half of each side; 0 where the box is flat. */
  readonly half: Vec3;
}

export function anyBox(random: Random, size = random.pick(SIZES)): BoxCase {
  const flat = random.chance(0.1);
  const side = (): number => (flat && random.chance(0.6) ? 0 : size * random.pick([1, random.magnitude(1e-4, 1)]));
  return {
    size,
    middle: scale(random.unit(), size * random.pick([0, 0.5, 3])),
    half: [side(), side(), side()],
  };
}

/** The box, grown on all sides by `margin`. */
export function boxOf({ middle, half }: BoxCase, margin = 0): Box {
  const wide = add(half, [margin, margin, margin]);
  return [...subtract(middle, wide), ...add(middle, wide)];
}

/** Apex and axis in shading space. */
export interface ConeCase {
  readonly apex: Vec3;
  readonly axis: Vec3;
  /** Degrees. */
  readonly aperture: number;
}

/** `apart`: not at the box, if the box is a single point. */
export function coneBy(random: Random, { middle, half, size }: BoxCase, apart = false): ConeCase {
  const radius = length(half) === 0 ? size : length(half);
  const away = Math.max(random.pick(AWAY), apart && length(half) === 0 ? 0.5 : 0);
  const apex = add(middle, scale(random.unit(), radius * away));
  const aperture = random.chance(0.7) ? random.from(1, 180) : random.pick(APERTURES);
  const ball = away > 1 ? Math.asin(1 / away) : 1;
  const toMiddle = away === 0 ? random.unit() : normalize(subtract(middle, apex));
  const axis = random.around(toMiddle, (aperture * Math.PI) / 180 + random.pick(GRAZES) * ball);
  return { apex, axis, aperture };
}

/** A light with this cone, in the world's or the camera's space. */
export function spotOf(
  random: Random,
  { apex, axis, aperture }: ConeCase,
  { origin, eye, camera: { right, up, back } }: View,
  values: Partial<LightValues>,
): LightValues {
  const inCamera = (v: Vec3): Vec3 => [dot(v, right), dot(v, up), dot(v, back)];
  const space = random.pick(['world', 'camera'] as const);
  const place = space === 'world' ? add(apex, origin) : inCamera(subtract(apex, eye));
  const long = scale(space === 'world' ? axis : inCamera(axis), random.pick([1, 1e-6, 1e9]));
  return light({ ...values, space, position: [...place, 1], axis: long, aperture });
}

/** Angle between the axis and the direction from the apex to p, in radians. */
export function angleOf({ apex, axis }: ConeCase, p: Vec3): number {
  const v = subtract(p, apex);
  return Math.atan2(length(cross(v, axis)), dot(v, axis));
}

/** Points of a box: corners, middles of edges and sides, any others, and where the cone would be entered first. */
export function pointsOf(box: Box, cone: ConeCase, random: Random, count: number): Vec3[] {
  const [x0, y0, z0, x1, y1, z1] = box;
  const held = ([x, y, z]: Vec3): Vec3 => [
    Math.min(Math.max(x, x0), x1),
    Math.min(Math.max(y, y0), y1),
    Math.min(Math.max(z, z0), z1),
  ];
  const at = (i: number, j: number, k: number): Vec3 =>
    held([x0 + i * (x1 - x0), y0 + j * (y1 - y0), z0 + k * (z1 - z0)]);
  const THREE = [0, 0.5, 1] as const;
  const points = THREE.flatMap((i) => THREE.flatMap((j) => THREE.map((k) => at(i, j, k))));
  while (points.length < count) points.push(at(random.from(0, 1), random.from(0, 1), random.from(0, 1)));
  points.push(held(cone.apex));
  // Descends to the smallest angle: random steps, shorter after each that brings no improvement.
  let best = points.reduce((a, b) => (angleOf(cone, a) <= angleOf(cone, b) ? a : b));
  for (let step = 0.5; step > 1e-7;) {
    const [i, j, k] = random.vector(-step, step);
    const moved = held(add(best, [i * (x1 - x0), j * (y1 - y0), k * (z1 - z0)]));
    if (angleOf(cone, moved) < angleOf(cone, best)) points.push((best = moved));
    else step *= 0.9;
  }
  return points;
}

/** The equation at a point of shading space, seen from the view's eye. */
export const shadeAt = (
  point: Vec3,
  normal: Vec3,
  lights: readonly LightValues[],
  { origin, camera, eye }: View,
): Shaded => shade({ p: add(point, origin), normal, eye: add(eye, origin) }, WHITE_SURFACE, lights, { camera });

const full = [255, 255, 255] as const;
const WHITE_SURFACE: Surface = { ka: full, kd: full, ks: full, shininess: 1 };

/** `mask`: 1 for each sent light that can reach the box. */
export function cull(packed: PackedLights, box: Box): { readonly mask: readonly number[]; readonly count: number } {
  const mask = new Uint8Array(packed.sent + 1).fill(7);
  const count = cullLights(packed, box, mask);
  return { mask: [...mask.subarray(0, packed.sent)], count };
}
