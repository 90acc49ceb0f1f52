// Lights into the rows that the GLSL reads: doubles in, shading-space floats out, sorted by kind,
// inactive and black lights left out. What is the same for all fragments is computed here in
// float64.
import { channelOf, isBlack } from '../math/color.js';
import { add, dot, type Mat4, negate, normalize, type Vec3 } from '../math/vector.js';
import { featuresOf, isSpot, kindOf } from './light-features.js';
import { HEADER, PACKED_VALUES, type PackedValue, ROWS } from './light-layout.js';
import { KINDS, type LightKind, type LightValues } from './light-state.js';
import { coneLimit, LEAST_EXPONENT } from './precision.js';

/**
 * How lights get into shading space: the space, of any origin and orientation, that fragments are
 * shaded in.
 */
export interface PackSpace {
  /** Rigid 4×4 matrix by columns, float64: world to shading space. */
  readonly worldToShading: Mat4;
  /** The same from camera space (x right, y up, looking along −z), for `space: 'camera'`. */
  readonly cameraToShading: Mat4;
  /** Light colours are decoded by the sRGB curve first. */
  readonly linear: boolean;
}

type Values = Readonly<LightValues>;

/** Packed lights, reused from frame to frame: `data` and `features` only ever grow. */
export interface PackedLights {
  /** Rows of four floats; those from `rows` on are stale. */
  data: Float32Array;
  rows: number;
  /** Lights that take part. */
  active: number;
  /** Lights that the loop runs over. The others add ambient light only, or nothing. */
  sent: number;
  /** Lights of each kind that are sent, in the order of their rows. */
  readonly counts: Record<LightKind, number>;
  /** The feature mask of each sent light; those from `sent` on are stale. */
  features: Uint32Array;
}

export const emptyPack = (): PackedLights => ({
  data: new Float32Array(64),
  rows: HEADER.rows,
  active: 0,
  sent: 0,
  counts: { directional: 0, point: 0, spot: 0 },
  features: new Uint32Array(8),
});

/** Packs the active lights of `lights` for one shading space, into `into`. */
export function packLights(lights: readonly Values[], space: PackSpace, into: PackedLights): void {
  const ambient: [number, number, number] = [0, 0, 0];
  packNothing(into);
  for (const light of lights) {
    if (light.active) {
      byKind[kindOf(light)].push(light);
    }
  }
  for (const kind of KINDS) {
    const before = into.sent;
    for (const light of byKind[kind]) {
      into.active += 1;
      const factor = kind === 'directional' && isSpot(light) ? directionalDecay(light) : 1;
      if (factor === 0) continue;
      if (kind !== 'spot') {
        addAmbient(ambient, light.ambient, factor, space.linear);
      }
      if (shines(light, kind)) {
        packLight(light, kind, factor, space, into);
      }
    }
    into.counts[kind] = into.sent - before;
    byKind[kind].length = 0; // so that removed lights can be collected
  }
  writeCounts(into);
  into.data.set(ambient, HEADER.ambient * 4);
}

/** Packs no light. */
export function packNothing(into: PackedLights): void {
  into.rows = HEADER.rows;
  into.sent = 0;
  into.active = 0;
  for (const kind of KINDS) {
    into.counts[kind] = 0;
  }
  into.data.fill(0, 0, HEADER.rows * 4);
}

function writeCounts({ data, counts }: PackedLights) {
  for (let i = 0; i < KINDS.length; i++) {
    data[HEADER.counts * 4 + i] = counts[KINDS[i]!];
  }
}

/** Reused from call to call; empty between them. */
const byKind: Readonly<Record<LightKind, Values[]>> = { directional: [], point: [], spot: [] };

/**
 * Whether the loop has anything to do for this light that the sum of ambient light has not done.
 */
function shines(light: Values, kind: LightKind): boolean {
  const { diffuse, specular, ambient } = light;
  const lit = !(isBlack(diffuse) && isBlack(specular));
  if (kind === 'spot') return lit || !isBlack(ambient);
  return lit && !hasNoDirection(light, kind);
}

const hasNoDirection = ({ position }: Values, kind: LightKind) =>
  kind === 'directional' && position[0] === 0 && position[1] === 0 && position[2] === 0;

function packLight(
  light: Values,
  kind: LightKind,
  factor: number,
  space: PackSpace,
  into: PackedLights,
) {
  const { rows } = ROWS[kind];
  reserve(into, into.rows + rows, into.sent + 1);
  const { data } = into;
  const at = into.rows * 4;
  data.fill(0, at, at + rows * 4);
  for (const value of PACKED_VALUES[kind]) {
    writeValue(value, light, kind, factor, space, data, at);
  }
  into.features[into.sent] = featuresOf(light, kind);
  into.rows += rows;
  into.sent += 1;
}

/**
 * Writes one value into the rows that begin at `first`. The light's own are multiplied by `factor`.
 */
function writeValue(
  { key, as, at: offset }: PackedValue,
  light: Values,
  kind: LightKind,
  factor: number,
  space: PackSpace,
  data: Float32Array,
  first: number,
) {
  const at = first + offset;
  if (typeof as === 'function') {
    data[at] = as(light[key] as never);
    return;
  }
  // By index: taking an array apart costs more than all of the rest.
  const v = light[key] as Vec3;
  if (as === 'light') {
    data[at] = channelOf(v[0], space.linear) * factor;
    data[at + 1] = channelOf(v[1], space.linear) * factor;
    data[at + 2] = channelOf(v[2], space.linear) * factor;
  } else if (as === 'numbers') {
    data[at] = v[0];
    data[at + 4] = v[1];
    data[at + 8] = v[2];
  } else {
    const matrix = light.space === 'camera' ? space.cameraToShading : space.worldToShading;
    if (as === 'place' && kind !== 'directional') {
      writeThrough(matrix, data, at, v[0], v[1], v[2], 1);
    } else {
      writeDirection(matrix, data, at, v);
    }
  }
}

function addAmbient(sum: [number, number, number], color: Vec3, factor: number, linear: boolean) {
  if (isBlack(color)) return;
  sum[0] += channelOf(color[0], linear) * factor;
  sum[1] += channelOf(color[1], linear) * factor;
  sum[2] += channelOf(color[2], linear) * factor;
}

/**
 * A directional light's L is the same everywhere, and so are its cone and its decay: 0 outside the
 * cone. A zero vector has no angle to the axis: inside any cone, decay 1.
 */
function directionalDecay(light: Values): number {
  const L = normalize([light.position[0], light.position[1], light.position[2]]);
  if (dot(L, L) === 0) return 1;
  const A = normalize(light.axis);
  const q = quarterChordSquared(L, A);
  const p = quarterChordSquared(L, negate(A));
  // A few roundings of float64, so that a direction exactly at the edge stays inside. Compared as
  // chords: near 0 their squares would make 6e-8 rad of the same roundings.
  const rounding = 4 * Number.EPSILON;
  const limit = coneLimit(light.aperture);
  const inside =
    limit < 0
      ? Math.sqrt(p) >= Math.sqrt(-limit) - rounding
      : Math.sqrt(q) <= Math.sqrt(limit) + rounding;
  if (!inside) return 0;
  return light.cutoff < LEAST_EXPONENT ? 1 : p ** light.cutoff;
}

/** |a + b|²/4 of unit vectors: (1 - dot(a, -b))/2 without its cancellation near 0. */
function quarterChordSquared(a: Vec3, b: Vec3): number {
  const sum = add(a, b);
  return dot(sum, sum) / 4;
}

/**
 * A unit vector along v, not zero; divided first, so that a denormal vector keeps its direction.
 */
function writeDirection(m: Mat4, data: Float32Array, at: number, v: Vec3) {
  const largest = Math.max(Math.abs(v[0]), Math.abs(v[1]), Math.abs(v[2]));
  const x = v[0] / largest;
  const y = v[1] / largest;
  const z = v[2] / largest;
  const unit = 1 / Math.sqrt(x * x + y * y + z * z);
  writeThrough(m, data, at, x * unit, y * unit, z * unit, 0);
}

/** A position (w = 1) or a direction (w = 0) through a matrix. */
function writeThrough(
  m: Mat4,
  data: Float32Array,
  at: number,
  x: number,
  y: number,
  z: number,
  w: 0 | 1,
) {
  data[at] = m[0]! * x + m[4]! * y + m[8]! * z + m[12]! * w;
  data[at + 1] = m[1]! * x + m[5]! * y + m[9]! * z + m[13]! * w;
  data[at + 2] = m[2]! * x + m[6]! * y + m[10]! * z + m[14]! * w;
}

/** Calls `visit` with each sent light's index, kind and first row. */
export function forEachLight(
  packed: Readonly<PackedLights>,
  visit: (light: number, kind: LightKind, row: number) => void,
): void {
  let row: number = HEADER.rows;
  let light = 0;
  for (const kind of KINDS) {
    const rows = ROWS[kind].rows;
    for (let i = 0; i < packed.counts[kind]; i++, row += rows) {
      visit(light++, kind, row);
    }
  }
}

/** Copies the lights that `mask` has a 1 for, and the header, into `into`. */
export function selectLights(
  packed: Readonly<PackedLights>,
  mask: Uint8Array,
  into: PackedLights,
): void {
  reserve(into, packed.rows, packed.sent);
  into.data.set(packed.data.subarray(0, HEADER.rows * 4));
  into.active = packed.active;
  into.sent = 0;
  into.rows = HEADER.rows;
  for (const kind of KINDS) {
    into.counts[kind] = 0;
  }
  forEachLight(packed, (light, kind, row) => {
    if (mask[light] !== 1) return;
    const rows = ROWS[kind].rows;
    into.data.set(packed.data.subarray(row * 4, (row + rows) * 4), into.rows * 4);
    into.features[into.sent] = packed.features[light]!;
    into.rows += rows;
    into.sent += 1;
    into.counts[kind] += 1;
  });
  writeCounts(into);
}

/** Makes room for this many rows and lights in all; what is there stays. */
export function reserve(into: PackedLights, rows: number, lights: number): void {
  if (lights > into.features.length) {
    const grown = new Uint32Array(Math.max(lights, into.features.length * 2));
    grown.set(into.features);
    into.features = grown;
  }
  if (rows * 4 <= into.data.length) return;
  const grown = new Float32Array(Math.max(rows * 4, into.data.length * 2));
  grown.set(into.data);
  into.data = grown;
}
