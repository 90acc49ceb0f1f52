// Divides a box into cells, each with a list of the lights that can reach it: for many small lights on one large mesh, where a
// fragment then loops over a few instead of all. The lists stand in shading space, so they stay while the camera turns.
// Knows neither meshes nor where rows are kept.
import { GRID, HEADER, ROWS } from './light-layout.js';
import { Cone } from './cone.js';
import { type Box, forEachLight, mostOf, type Reflectance } from './light-reach.js';
import type { LightKind } from './light-kind.js';
import { KINDS, type PackedLights, reserve } from './pack-lights.js';

/** Cells at most: 64 by 64 on a floor, which a light of a hundredth of it covers with 41 whole ones. */
const MOST_CELLS = 4096;

/** Fewer lights than this are not worth a list. */
export const LEAST_DIVIDED = 24;

/** A light that reaches this share of the cells is looped over everywhere instead. */
const MOST_OF_THEM = 0.5;

/**
 * Cells are taken a little larger than they are: fragments find theirs by float32 places. In shares of a cell, and of the
 * largest coordinate (float32 rounds by 6e-8 of it).
 */
const PADDING = { cell: 1e-3, place: 1e-6 } as const;

interface Cells {
  readonly box: Box;
  readonly size: readonly [number, number, number];
  readonly step: readonly [number, number, number];
  readonly pad: number;
}

/** What of a light is found while dividing. */
interface Reach {
  readonly light: number;
  readonly kind: LightKind;
  readonly row: number;
  /** The cells it reaches; null: everywhere. */
  readonly cells: Int32Array | null;
}

/**
 * Writes the lights of `packed` into `into`, those that reach everywhere first of their kind, and after them the lists for
 * `box`. False, and `into` is not to be used, where lists would not halve the work. `budget`, 1 being full, is the colour
 * that may be given up at each point by what a list leaves out.
 */
export function divide(
  packed: PackedLights,
  box: Box,
  surface: Reflectance,
  budget: number,
  into: PackedLights,
): boolean {
  const positional = packed.counts.point + packed.counts.spot;
  if (positional < LEAST_DIVIDED) return false;
  // Directional lights reach everywhere, and so do lamps where nothing may be given up.
  const surely = packed.counts.directional + (budget > 0 ? 0 : packed.counts.point);
  if (surely > packed.sent / 2) return false;
  const cells = cellsOf(box);
  const count = cells.size[0] * cells.size[1] * cells.size[2];
  if (count < 2) return false;
  const share = budget / positional; // each light's part of what may be given up
  const scratch = new Int32Array(Math.floor(count * MOST_OF_THEM));
  const reaches: Reach[] = [];
  let listed = 0;
  let everywhere = 0;
  const tooMany = (): boolean => everywhere + listed / count > packed.sent / 2;
  forEachLight(packed, (light, kind, row) => {
    if (tooMany()) return;
    const found =
      kind === 'directional' ? null : reachedCells(packed, light, kind, row, cells, surface, share, scratch);
    if (found === null) everywhere += 1;
    else listed += found.length;
    reaches.push({ light, kind, row, cells: found });
  });
  if (tooMany()) return false;
  writeLights(packed, reaches, into);
  writeLists(reaches, cells, count, listed, into);
  return true;
}

function cellsOf(box: Box): Cells {
  const extent = [box[3] - box[0], box[4] - box[1], box[5] - box[2]] as const;
  const largest = Math.max(...extent);
  let edge = largest / MOST_CELLS;
  const along = (length: number): number => Math.max(1, Math.floor(length / edge));
  const fits = (): boolean => along(extent[0]) * along(extent[1]) * along(extent[2]) <= MOST_CELLS;
  if (!(largest > 0)) edge = 1;
  else while (!fits()) edge *= 1.02;
  const size = [along(extent[0]), along(extent[1]), along(extent[2])] as const;
  const coordinate = Math.max(...box.map(Math.abs));
  return {
    box,
    size,
    step: [extent[0] / size[0], extent[1] / size[1], extent[2] / size[2]],
    pad: PADDING.cell * edge + PADDING.place * coordinate,
  };
}

/** The cells where the light can bring more than `share`; null where those are too many for a list. */
function reachedCells(
  packed: PackedLights,
  light: number,
  kind: LightKind,
  row: number,
  { box, size, step, pad }: Cells,
  surface: Reflectance,
  share: number,
  scratch: Int32Array,
): Int32Array | null {
  const cone = kind === 'spot' ? new Cone().take(packed, row) : null;
  if (cone === null && share === 0) return null;
  const shape = packed.shapes[light] ?? 0;
  let count = 0;
  const visit = (i0: number, j0: number, k0: number, i1: number, j1: number, k1: number): void => {
    if (count > scratch.length) return;
    const x0 = box[0] + i0 * step[0] - pad;
    const y0 = box[1] + j0 * step[1] - pad;
    const z0 = box[2] + k0 * step[2] - pad;
    const x1 = box[0] + i1 * step[0] + pad;
    const y1 = box[1] + j1 * step[1] + pad;
    const z1 = box[2] + k1 * step[2] + pad;
    if (cone?.reaches(x0, y0, z0, x1, y1, z1, 0) === false) return;
    if (
      share > 0 &&
      Math.max(...mostOf(packed, row, shape, cone, [x0, y0, z0, x1, y1, z1], surface)) <= share
    )
      return;
    const i = i1 - i0;
    const j = j1 - j0;
    const k = k1 - k0;
    if (i === 1 && j === 1 && k === 1) {
      if (count < scratch.length) scratch[count] = i0 + size[0] * (j0 + size[1] * k0);
      count += 1;
    } else if (i >= j && i >= k) {
      visit(i0, j0, k0, i0 + (i >> 1), j1, k1);
      visit(i0 + (i >> 1), j0, k0, i1, j1, k1);
    } else if (j >= k) {
      visit(i0, j0, k0, i1, j0 + (j >> 1), k1);
      visit(i0, j0 + (j >> 1), k0, i1, j1, k1);
    } else {
      visit(i0, j0, k0, i1, j1, k0 + (k >> 1));
      visit(i0, j0, k0 + (k >> 1), i1, j1, k1);
    }
  };
  visit(0, 0, 0, size[0], size[1], size[2]);
  return count > scratch.length ? null : scratch.slice(0, count);
}

/** All lights again, in another order. */
function writeLights(packed: PackedLights, reaches: Reach[], into: PackedLights): void {
  const rank = ({ kind, cells }: Reach): number => 2 * KINDS.indexOf(kind) + (cells === null ? 0 : 1);
  reaches.sort((a, b) => rank(a) - rank(b)); // stable
  reserve(into, packed.rows, packed.sent);
  into.data.set(packed.data.subarray(0, HEADER.rows * 4));
  into.rows = HEADER.rows;
  reaches.forEach((reach, i) => {
    const { rows } = ROWS[reach.kind];
    into.data.set(packed.data.subarray(reach.row * 4, (reach.row + rows) * 4), into.rows * 4);
    into.shapes[i] = packed.shapes[reach.light] ?? 0;
    reaches[i] = { ...reach, row: into.rows };
    into.rows += rows;
  });
  into.active = packed.active;
  into.sent = packed.sent;
  Object.assign(into.counts, packed.counts);
}

function writeLists(
  reaches: readonly Reach[],
  { box, size, step }: Cells,
  count: number,
  listed: number,
  into: PackedLights,
): void {
  const grid = into.rows;
  const firstCell = grid + GRID.rows;
  const firstListed = firstCell + count;
  into.rows = firstListed + Math.ceil(listed / 4);
  reserve(into, into.rows, into.sent);
  const { data } = into;
  data.fill(0, grid * 4, into.rows * 4);
  const put = (row: number, values: readonly number[]): void => {
    data.set(values, row * 4);
  };
  const everywhere = KINDS.map(
    (kind) => reaches.filter((one) => one.kind === kind && one.cells === null).length,
  );
  data[HEADER.counts * 4 + 3] = grid;
  put(grid + GRID.low, [box[0], box[1], box[2], firstCell]);
  put(grid + GRID.scale, [...step.map((s) => (s > 0 ? 1 / s : 0)), firstListed]);
  put(grid + GRID.size, size);
  put(grid + GRID.everywhere, everywhere);
  // How many points and spots each cell lists, then where each list begins, then the lists: points come before spots.
  const cell = (i: number): number => (firstCell + i) * 4;
  for (const { kind, cells } of reaches) {
    const at = kind === 'point' ? 1 : 2;
    for (const i of cells ?? []) data[cell(i) + at]! += 1;
  }
  const next = new Int32Array(count);
  let place = 0;
  for (let i = 0; i < count; i++) {
    data[cell(i)] = place;
    next[i] = place;
    place += data[cell(i) + 1]! + data[cell(i) + 2]!;
  }
  for (const { row, cells } of reaches) {
    for (const i of cells ?? []) {
      data[firstListed * 4 + next[i]!] = row;
      next[i]! += 1;
    }
  }
}
