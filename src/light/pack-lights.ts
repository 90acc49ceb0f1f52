// Lights into the rows that the GLSL reads: doubles in, shading-space floats out, sorted by kind, inactive and black
// lights left out. Everything that is the same for all fragments is done here, in float64: units, cosines, unit
// vectors, the sum of ambient light, a directional light's cone. Knows neither three.js nor where rows are stored.
import { add, dot, type Mat4, negate, normalize, type Vec3, type Vec4 } from '../math/vector.js';
import type { LightKind } from './light-kind.js';
import { HEADER, LEAST_EXPONENT, ROWS } from './light-layout.js';
import type { LightValues } from './light-state.js';
import { coneLimit, SteadyLight } from './steady-light.js';

/** How lights get into shading space: the space, of any origin and orientation, that fragments are shaded in. */
export interface PackSpace {
  /** Rigid 4×4 matrix, by columns, float64: world to shading space. */
  readonly worldToShading: Mat4;
  /** The same from camera space (x right, y up, looking along −z), for `space: 'camera'`. */
  readonly cameraToShading: Mat4;
  /** Light colours are decoded by the sRGB curve first. */
  readonly linear: boolean;
}

type Values = Readonly<LightValues>;

/** Packed lights. Kept and reused from frame to frame: `data` and `shapes` only ever grow. */
export interface PackedLights {
  /** Rows of four floats; those from `rows` on are stale. */
  data: Float32Array;
  rows: number;
  /** Lights that take part. */
  active: number;
  /** Lights that the loop runs over. Others bring ambient light only, or nothing. */
  sent: number;
  /** How many of each kind are sent, in the order of their rows. */
  readonly counts: Record<LightKind, number>;
  /** What each sent light needs of a program, see SHAPE; those from `sent` on are stale. */
  shapes: Uint32Array;
  /** What was found of the active lights, in their order, and holds while they only move. */
  readonly steady: SteadyLight[];
  /** Both matrices that they were packed with; NaN before. */
  readonly packedBy: Float64Array;
}

export const emptyPack = (): PackedLights => ({
  data: new Float32Array(64),
  rows: HEADER.rows,
  active: 0,
  sent: 0,
  counts: { directional: 0, point: 0, spot: 0 },
  shapes: new Uint32Array(8),
  steady: [],
  packedBy: new Float64Array(32).fill(NaN),
});

/** In the order of their rows. */
export const KINDS = ['directional', 'point', 'spot'] as const satisfies readonly LightKind[];

/** Packs the active lights of `lights` for one shading space, into `into`. */
export function packLights(lights: readonly Values[], space: PackSpace, into: PackedLights): void {
  if (isSteady(lights, space, into) && repackPlaces(space, into)) return;
  const ambient: [number, number, number] = [0, 0, 0];
  into.rows = HEADER.rows;
  into.sent = 0;
  into.active = into.steady.length;
  for (const kind of KINDS) {
    const before = into.sent;
    for (const steady of into.steady) {
      if (steady.kind !== kind) continue;
      const { light } = steady;
      steady.row = -1;
      const factor = kind === 'directional' && steady.spot ? directionalDecay(light) : 1;
      if (factor === 0) continue;
      if (kind !== 'spot') for (const c of CHANNELS) ambient[c] += steady.ambient[c] * factor;
      if (!reaches(light, kind, steady)) continue;
      reserve(into, into.rows + ROWS[kind].rows, into.sent + 1);
      const at = into.rows * 4;
      steady.row = into.rows;
      if (kind === 'directional') writeDirectional(into.data, at, light, steady, factor, space);
      else writePoint(into.data, at, light, steady, space);
      if (kind === 'spot') writeSpot(into.data, at, light, steady, space);
      into.shapes[into.sent] = kind === 'spot' ? steady.spotShape : steady.pointShape;
      into.rows += ROWS[kind].rows;
      into.sent += 1;
    }
    into.counts[kind] = into.sent - before;
  }
  const { directional, point, spot } = into.counts;
  write(into.data, HEADER.counts * 4, directional, point, spot, 0);
  write(into.data, HEADER.ambient * 4, ambient[0], ambient[1], ambient[2], 0);
}

const CHANNELS = [0, 1, 2] as const;

/** Brings what is found of the active lights in step; true where that, and the spaces, are as they were packed. */
function isSteady(
  lights: readonly Values[],
  { worldToShading, cameraToShading, linear }: PackSpace,
  { steady, packedBy }: PackedLights,
): boolean {
  let same = true;
  for (let i = 0; i < 16; i++) {
    same &&= packedBy[i] === worldToShading[i] && packedBy[16 + i] === cameraToShading[i];
    packedBy[i] = worldToShading[i]!;
    packedBy[16 + i] = cameraToShading[i]!;
  }
  let active = 0;
  for (const light of lights) {
    if (!light.active) continue;
    if (steady[active]?.holds(light, linear) !== true) {
      same = false;
      steady[active] = new SteadyLight(light, linear);
    }
    active += 1;
  }
  same &&= steady.length === active;
  steady.length = active;
  return same;
}

/**
 * Writes places and directions alone, which is all of most frames; false where a move brings more with it. For lights of which
 * nothing but their places differs from what was packed last, for the same space.
 */
export function repackPlaces(space: PackSpace, { steady, data }: PackedLights): boolean {
  for (const one of steady) {
    const { kind, light, row } = one;
    if (kind === 'directional' && one.spot) return false; // its decay is another
    if (row >= 0 !== reaches(light, kind, one)) return false;
    if (row < 0) continue;
    const matrix = matrixOf(light, space);
    const { position } = light;
    if (kind === 'directional') writeDirection(matrix, data, row * 4, position);
    else writeThrough(matrix, data, row * 4, position[0], position[1], position[2], 1, data[row * 4 + 3]!);
  }
  return true;
}

/** Whether the loop has anything to do for this light that the sum of ambient light has not done. */
function reaches({ position }: Values, kind: LightKind, { shines, ambient }: SteadyLight): boolean {
  if (kind === 'spot') return shines || ambient[0] > 0 || ambient[1] > 0 || ambient[2] > 0;
  if (kind === 'directional' && position[0] === 0 && position[1] === 0 && position[2] === 0) return false;
  return shines;
}

/**
 * A directional light's L is the same everywhere, and so are its cone and its decay: 0 outside the cone. A zero
 * vector has no angle to the axis: inside any cone, decay 1.
 */
function directionalDecay(light: Values): number {
  const L = normalize([light.position[0], light.position[1], light.position[2]]);
  if (dot(L, L) === 0) return 1;
  const A = normalize(light.axis);
  const q = chord(L, A);
  const p = chord(L, negate(A));
  // A few roundings of float64, so that a direction exactly at the edge stays inside, where it belongs. Chords and not
  // their squares: near 0 a square would make 6e-8 rad of the same roundings.
  const rounding = 4 * Number.EPSILON;
  const limit = coneLimit(light.aperture);
  const inside =
    limit < 0 ? Math.sqrt(p) >= Math.sqrt(-limit) - rounding : Math.sqrt(q) <= Math.sqrt(limit) + rounding;
  if (!inside) return 0;
  return light.cutoff < LEAST_EXPONENT ? 1 : p ** light.cutoff;
}

/** |a + b|²/4 of unit vectors: (1 - dot(a, -b))/2 without its cancellation near 0. */
function chord(a: Vec3, b: Vec3): number {
  const sum = add(a, b);
  return dot(sum, sum) / 4;
}

const matrixOf = (light: Values, space: PackSpace): Mat4 =>
  light.space === 'camera' ? space.cameraToShading : space.worldToShading;

function writeDirectional(
  data: Float32Array,
  at: number,
  light: Values,
  { diffuse, specular }: SteadyLight,
  factor: number,
  space: PackSpace,
): void {
  const row = ROWS.directional;
  writeDirection(matrixOf(light, space), data, at + row.direction * 4, light.position);
  write(data, at + row.diffuse * 4, diffuse[0] * factor, diffuse[1] * factor, diffuse[2] * factor, 0);
  write(data, at + row.specular * 4, specular[0] * factor, specular[1] * factor, specular[2] * factor, 0);
}

/** L, unit: scaled by its largest component first, so that a denormal vector still has its direction. */
function writeDirection(m: Mat4, data: Float32Array, at: number, position: Vec4): void {
  const largest = Math.max(Math.abs(position[0]), Math.abs(position[1]), Math.abs(position[2]));
  const x = position[0] / largest;
  const y = position[1] / largest;
  const z = position[2] / largest;
  const unit = 1 / Math.sqrt(x * x + y * y + z * z);
  writeThrough(m, data, at, x * unit, y * unit, z * unit, 0, 0);
}

/** Also what a spot begins with. */
function writePoint(
  data: Float32Array,
  at: number,
  light: Values,
  { diffuse, specular }: SteadyLight,
  space: PackSpace,
): void {
  const { position, attenuation } = light;
  const row = ROWS.point;
  const [x, y, z] = position;
  writeThrough(matrixOf(light, space), data, at + row.position * 4, x, y, z, 1, attenuation[0]);
  write(data, at + row.diffuse * 4, diffuse[0], diffuse[1], diffuse[2], attenuation[1]);
  write(data, at + row.specular * 4, specular[0], specular[1], specular[2], attenuation[2]);
}

function writeSpot(
  data: Float32Array,
  at: number,
  light: Values,
  { ambient, axis, limit }: SteadyLight,
  space: PackSpace,
): void {
  const row = ROWS.spot;
  writeThrough(matrixOf(light, space), data, at + row.axis * 4, ...axis, 0, light.cutoff);
  write(data, at + row.ambient * 4, ambient[0], ambient[1], ambient[2], limit);
}

/** A place (w = 1) or a direction (w = 0) through a matrix, and a scalar beside it. */
function writeThrough(
  m: Mat4,
  data: Float32Array,
  at: number,
  x: number,
  y: number,
  z: number,
  w: 0 | 1,
  scalar: number,
): void {
  data[at] = m[0]! * x + m[4]! * y + m[8]! * z + m[12]! * w;
  data[at + 1] = m[1]! * x + m[5]! * y + m[9]! * z + m[13]! * w;
  data[at + 2] = m[2]! * x + m[6]! * y + m[10]! * z + m[14]! * w;
  data[at + 3] = scalar;
}

function write(data: Float32Array, at: number, x: number, y: number, z: number, w: number): void {
  data[at] = x;
  data[at + 1] = y;
  data[at + 2] = z;
  data[at + 3] = w;
}

/** Room for this many rows and lights in all; what is there stays. */
export function reserve(into: PackedLights, rows: number, lights: number): void {
  if (lights > into.shapes.length) {
    const grown = new Uint32Array(Math.max(lights, into.shapes.length * 2));
    grown.set(into.shapes);
    into.shapes = grown;
  }
  if (rows * 4 <= into.data.length) return;
  const grown = new Float32Array(Math.max(rows * 4, into.data.length * 2));
  grown.set(into.data);
  into.data = grown;
}
