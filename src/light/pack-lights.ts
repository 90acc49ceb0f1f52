// Lights into the rows that the GLSL reads: doubles in, shading-space floats out, sorted by kind, inactive and black
// lights left out. Everything that is the same for all fragments is done here, in float64: units, cosines, unit
// vectors, the sum of ambient light, a directional light's cone. Knows neither three.js nor where rows are stored.
import { radians } from '../math/angle.js';
import { srgbDecode } from '../math/color.js';
import { add, dot, map, type Mat4, negate, normalize, scale, transform, type Vec3 } from '../math/vector.js';
import { isAttenuated, isSpot, kindOf, type LightKind } from './light-kind.js';
import { HEADER, LARGEST_WHOLE_POWER, LEAST_EXPONENT, LIMIT_OPEN, ROWS, SHAPE } from './light-layout.js';
import type { LightValues } from './light-state.js';

/** How lights get into shading space: the space, of any origin and orientation, that fragments are shaded in. */
export interface PackSpace {
  /** Rigid 4×4 matrix, by columns, float64: world to shading space. */
  readonly worldToShading: Mat4;
  /** The same from camera space (x right, y up, looking along −z), for `space: 'camera'`. */
  readonly cameraToShading: Mat4;
  /** Light colours are decoded by the sRGB curve first. */
  readonly linear: boolean;
}

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
  shapes: Uint16Array;
}

export const emptyPack = (): PackedLights => ({
  data: new Float32Array(64),
  rows: HEADER.rows,
  active: 0,
  sent: 0,
  counts: { directional: 0, point: 0, spot: 0 },
  shapes: new Uint16Array(8),
});

type Values = Readonly<LightValues>;

/** In the order of their rows. */
export const KINDS = ['directional', 'point', 'spot'] as const satisfies readonly LightKind[];

/** Packs the active lights of `lights` for one shading space, into `into`. */
export function packLights(lights: readonly Values[], space: PackSpace, into: PackedLights): void {
  let ambient: Vec3 = [0, 0, 0];
  into.rows = HEADER.rows;
  into.active = 0;
  into.sent = 0;
  for (const light of lights) if (light.active) into.active += 1;
  for (const kind of KINDS) {
    const before = into.sent;
    for (const light of lights) {
      if (!light.active || kindOf(light) !== kind) continue;
      const factor = kind === 'directional' ? directionalDecay(light) : 1;
      if (factor === 0) continue;
      const colors = lightColors(light, factor, space.linear);
      if (kind !== 'spot') ambient = add(ambient, colors.ambient);
      if (!reaches(light, kind, colors)) continue;
      reserve(into, ROWS[kind].rows);
      WRITERS[kind](into.data, into.rows * 4, light, colors, space);
      into.shapes[into.sent] = shapeOf(light, kind, colors);
      into.rows += ROWS[kind].rows;
      into.sent += 1;
    }
    into.counts[kind] = into.sent - before;
  }
  const { directional, point, spot } = into.counts;
  write(into.data, HEADER.counts * 4, [directional, point, spot], 0);
  write(into.data, HEADER.ambient * 4, ambient, 0);
}

/** What this light needs of a program beyond its kind: SHAPE's bits. */
function shapeOf(light: Values, kind: LightKind, { ambient, diffuse, specular }: LightColors): number {
  let shape = (isBlack(diffuse) ? 0 : SHAPE.diffuse) + (isBlack(specular) ? 0 : SHAPE.specular);
  if (isAttenuated(light)) shape += SHAPE.attenuated;
  if (kind !== 'spot') return shape;
  if (!isBlack(ambient)) shape += SHAPE.ambient;
  if (light.aperture < 180) shape += light.aperture <= 90 ? SHAPE.narrow : SHAPE.wide;
  const { cutoff } = light;
  if (cutoff < LEAST_EXPONENT) return shape;
  return shape + (isWholePower(cutoff) ? cutoff << SHAPE.powerShift : SHAPE.decay);
}

/** An exponent that is multiplied out where a program is made for it. */
export const isWholePower = (exponent: number): boolean =>
  Number.isInteger(exponent) && exponent >= 1 && exponent <= LARGEST_WHOLE_POWER;

interface LightColors {
  readonly ambient: Vec3;
  readonly diffuse: Vec3;
  readonly specular: Vec3;
}

/** 255 to 1, decoded where the picture is linear, times what is the same at every fragment. */
function lightColors(light: Values, factor: number, linear: boolean): LightColors {
  const color = (c: Vec3): Vec3 => {
    const unit = scale(c, 1 / 255);
    return scale(linear ? map(unit, srgbDecode) : unit, factor);
  };
  return { ambient: color(light.ambient), diffuse: color(light.diffuse), specular: color(light.specular) };
}

export const isBlack = (c: Vec3): boolean => c[0] === 0 && c[1] === 0 && c[2] === 0;

/** Whether the loop has anything to do for this light that the sum of ambient light has not done. */
function reaches(light: Values, kind: LightKind, { ambient, diffuse, specular }: LightColors): boolean {
  if (kind === 'spot') return !(isBlack(ambient) && isBlack(diffuse) && isBlack(specular));
  const [x, y, z] = light.position;
  if (kind === 'directional' && x === 0 && y === 0 && z === 0) return false;
  return !(isBlack(diffuse) && isBlack(specular));
}

/**
 * A directional light's L is the same everywhere, and so are its cone and its decay: 0 outside the cone. A zero
 * vector has no angle to the axis: inside any cone, decay 1.
 */
function directionalDecay(light: Values): number {
  const L = normalize([light.position[0], light.position[1], light.position[2]]);
  if (!isSpot(light) || dot(L, L) === 0) return 1;
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

/** An aperture in degrees as the one float the shader compares with; see LIMIT_OPEN. */
export function coneLimit(aperture: number): number {
  if (aperture >= 180) return LIMIT_OPEN;
  // Beyond 90° the chord to the far side is the short one, and precise; degrees to 180 are exact.
  return aperture <= 90
    ? Math.sin(radians(aperture) / 2) ** 2
    : -(Math.sin(radians(180 - aperture) / 2) ** 2);
}

/**
 * The same for float32: unit vectors there may be 2 ULP too long or short (inversesqrt's allowance) and round beside, so
 * what lies exactly on the axis can be 1e-6 rad off it, and a cone of no width must be that wide to hold its axis.
 */
function packedLimit(aperture: number): number {
  const limit = coneLimit(aperture);
  return limit < 0 ? limit : Math.max(limit, LEAST_LIMIT);
}

/** sin² of half of 1e-6 rad. */
const LEAST_LIMIT = 2.5e-13;

type Writer = (data: Float32Array, at: number, light: Values, colors: LightColors, space: PackSpace) => void;

const matrixOf = (light: Values, space: PackSpace): Mat4 =>
  light.space === 'camera' ? space.cameraToShading : space.worldToShading;

const writePoint: Writer = (data, at, light, colors, space) => {
  const [x, y, z] = light.position;
  const [kc, kl, kq] = light.attenuation;
  const row = ROWS.point;
  write(data, at + row.position * 4, transform(matrixOf(light, space), [x, y, z], 1), kc);
  write(data, at + row.diffuse * 4, colors.diffuse, kl);
  write(data, at + row.specular * 4, colors.specular, kq);
};

const WRITERS: Readonly<Record<LightKind, Writer>> = {
  directional(data, at, light, colors, space) {
    const [x, y, z] = light.position;
    const row = ROWS.directional;
    write(data, at + row.direction * 4, transform(matrixOf(light, space), normalize([x, y, z]), 0), 0);
    write(data, at + row.diffuse * 4, colors.diffuse, 0);
    write(data, at + row.specular * 4, colors.specular, 0);
  },
  point: writePoint,
  spot(data, at, light, colors, space) {
    const row = ROWS.spot;
    writePoint(data, at, light, colors, space);
    const A = transform(matrixOf(light, space), normalize(light.axis), 0);
    write(data, at + row.axis * 4, A, light.cutoff);
    write(data, at + row.ambient * 4, colors.ambient, packedLimit(light.aperture));
  },
};

function write(data: Float32Array, at: number, xyz: Vec3, w: number): void {
  data[at] = xyz[0];
  data[at + 1] = xyz[1];
  data[at + 2] = xyz[2];
  data[at + 3] = w;
}

function reserve(into: PackedLights, rows: number): void {
  if (into.sent === into.shapes.length) {
    const grown = new Uint16Array(into.sent * 2);
    grown.set(into.shapes);
    into.shapes = grown;
  }
  const needed = (into.rows + rows) * 4;
  if (needed <= into.data.length) return;
  const grown = new Float32Array(Math.max(needed, into.data.length * 2));
  grown.set(into.data);
  into.data = grown;
}
