// Light grids as tests need them: numbered spots, and lists read back as the GLSL reads them, its float32 included.

import { expect } from 'vitest';
import { divideLights } from '../../src/light/light-grid.js';
import { KINDS } from '../../src/light/light-state.js';
import { floatOf, GRID, HEADER, ROWS } from '../../src/light/light-layout.js';
import type { Box } from '../../src/light/cull-lights.js';
import type { LightValues } from '../../src/light/light-state.js';
import { emptyPack, type PackedLights } from '../../src/light/pack-lights.js';
import { radians } from '../../src/math/angle.js';
import { subtract, type Vec3 } from '../../src/math/vector.js';
import { float32, type Random } from '../stress/random.js';
import { light } from './arbitraries.js';
import { angleOf } from './cull-cases.js';
import { pack } from './packed-reader.js';

export const SEED = Number(process.env['PHONG_VIEWER_SEED'] ?? 1);
export const FLOOR: Box = [-10, 0, -10, 10, 0, 10];
export const ROOM: Box = [-4, -3, -2, 4, 3, 2];
export const DOWN: Vec3 = [0, -1, 0];

/** Spots above the box that point nearly downward. Red ambient light numbers them from 1. */
export function spotsOver(box: Box, count: number, random: Random, more: Partial<LightValues> = {}): LightValues[] {
  const unit = Math.max(box[3] - box[0], box[4] - box[1], box[5] - box[2]) / 8;
  const inside = (k: 0 | 2): number => random.from(box[k], box[k + 3]!);
  return Array.from({ length: count }, (_, i) =>
    light({
      position: [inside(0), box[4] + unit * random.from(0.5, 2), inside(2), 1],
      axis: subtract(DOWN, random.vector(-0.3, 0.3)),
      aperture: random.from(8, 25),
      ambient: [i + 1, 0, 0],
      ...more,
    }),
  );
}

/** The grid of a box, the number of its cells along each axis, and the size of one. */
export function divided(lights: readonly LightValues[], box: Box) {
  const into = emptyPack();
  expect(divideLights(pack(lights), box, into)).toBe(true);
  const size = float32(rowOf(into, gridOf(into) + GRID.size));
  return { into, size, step: [0, 1, 2].map((k) => (box[k + 3]! - box[k]!) / size[k]!) as unknown as Vec3 };
}

export const rowOf = ({ data }: PackedLights, row: number): Vec3 => [data[row * 4]!, data[row * 4 + 1]!, data[row * 4 + 2]!]; // prettier-ignore
const lastOf = ({ data }: PackedLights, row: number): number => data[row * 4 + 3]!;
const gridOf = (into: PackedLights): number => lastOf(into, HEADER.counts);

/** The number of spots without a list entry; they come first. */
export const unlistedOf = (into: PackedLights): number => lastOf(into, gridOf(into) + GRID.size);

/** The rows of all lights, by kind. */
export function rowsOf({ counts }: PackedLights): number[][] {
  let row: number = HEADER.rows;
  return KINDS.map((kind) =>
    Array.from({ length: counts[kind] }, () => {
      row += ROWS[kind].rows;
      return row - ROWS[kind].rows;
    }),
  );
}

/** The rows of the lights that the GLSL adds at p, computed as cellSpots and listedRow do, in float32. */
export function addedAt(into: PackedLights, p: Vec3): number[] {
  const grid = gridOf(into);
  const [low, scales, size] = [GRID.low, GRID.scale, GRID.size].map((row) => rowOf(into, grid + row)) as [Vec3, Vec3, Vec3]; // prettier-ignore
  const cell = low.map((from, k) => {
    const at = Math.floor(Math.fround(Math.fround(Math.fround(p[k]!) - from) * scales[k]!));
    return Math.min(Math.max(at, 0), size[k]! - 1);
  });
  const index = cell[0]! + size[0] * (cell[1]! + size[1] * cell[2]!);
  const [first, count] = rowOf(into, lastOf(into, grid + GRID.low) + index);
  const lists = lastOf(into, grid + GRID.scale) * 4;
  const listed = [...into.data.subarray(lists + first, lists + first + count)];
  const [directional, point, spot] = rowsOf(into) as [number[], number[], number[]];
  for (const row of listed) expect(spot).toContain(row);
  return [...directional, ...point, ...spot.slice(0, unlistedOf(into)), ...listed];
}

/** Anywhere in the box, its corners and the corners of its cells among it; float32, as fragments have it. */
export function pointIn(random: Random, box: Box, size: Vec3): Vec3 {
  const p = [0, 1, 2].map((k) => {
    const [low, high] = [box[k]!, box[k + 3]!];
    const corner = low + (Math.floor(random.from(0, size[k]! + 1)) / size[k]!) * (high - low);
    return random.pick([random.from(low, high), random.from(low, high), corner, low, high]);
  });
  return float32(p as unknown as Vec3);
}

/** Whether p is within a spot's cone: by its values, not by its rows. */
export const isLit = ({ position: [x, y, z], axis, aperture }: LightValues, p: Vec3): boolean =>
  angleOf({ apex: [x, y, z], axis, aperture }, p) <= radians(aperture);

/** The rows that each of `lights` has in `into`, found by its red ambient light, which is its number: spots alone. */
export const rowByNumber = (into: PackedLights): Map<number, number> =>
  new Map(rowsOf(into)[2]!.map((row) => [Math.round(255 * into.data[row * 4 + floatOf('spot', 'ambient')]!), row]));

/**
 * The corner of a cell and a spot whose cone ends just before it with an upright wall: the nearest point of the next
 * cell's ball is the corner itself. `at` is within the cone, and `p`, as which rounding may take it, in the next cell.
 * In the middle of the box, where a cone itself is taken larger by next to nothing.
 */
export function cornerCase(
  random: Random,
  box: Box,
  flat: number,
  [u, v]: readonly [number, number],
  size: Vec3,
  step: Vec3,
  pad: number,
): { readonly lamp: LightValues; readonly at: Vec3; readonly p: Vec3 } {
  const corner = [box[0], box[1], box[2]];
  for (const k of [u, v]) corner[k]! += step[k]! * Math.floor(random.from(0.45, 0.55) * size[k]!);
  const outward = [0, 0, 0];
  for (const k of [u, v]) outward[k] = random.sign() * Math.SQRT1_2;
  const moved = (by: number): Vec3 => corner.map((x, k) => x + by * outward[k]!) as unknown as Vec3;
  const wall = [...moved(-1.3 * pad)];
  wall[flat]! += 1;
  const tilt = radians(20);
  const axis = outward.map((x) => -Math.sin(tilt) * x);
  axis[flat] = -Math.cos(tilt);
  const position = [...wall, 1] as unknown as LightValues['position'];
  const lamp = light({ position, axis: axis as unknown as Vec3, aperture: 20 });
  return { lamp, at: moved(-1.38 * pad), p: moved(0.3 * pad) };
}
