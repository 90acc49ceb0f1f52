// A light grid: a box divided into cells, each with a list of the spots that can reach it. A
// fragment of a large mesh then loops over a few narrow spots instead of all. In shading space: it
// stays while the camera turns.
import { type Box, Cone } from './cull-lights.js';
import { GRID, HEADER, ROWS } from './light-layout.js';
import { forEachLight, type PackedLights, reserve } from './pack-lights.js';

/** Most cells: 64 by 64 on a floor; a light as wide as a tenth of it covers 41 whole ones. */
const MOST_CELLS = 4096;

/** Fewer spots than this are not worth a grid. */
export const LEAST_DIVIDED = 24;

/** A spot that reaches this share of the cells stands in no list: every fragment loops over it. */
const MOST_OF_THEM = 0.5;

/**
 * Cells are taken a little larger than they are, because fragments find theirs by float32
 * coordinates. As a share of a cell, and of the largest coordinate (float32 rounds by 6e-8 of it).
 */
const PADDING = { cell: 1e-3, coordinate: 1e-6 } as const;

interface Cells {
  readonly box: Box;
  readonly size: readonly [number, number, number];
  readonly count: number;
  readonly step: readonly [number, number, number];
  readonly pad: number;
}

/** A spot and the cells it reaches; null: it stands in no list. */
interface Reach {
  readonly light: number;
  readonly row: number;
  readonly cells: Int32Array | null;
}

/**
 * Writes the lights of `packed` into `into`, spots that reach most cells before the others, and
 * after them the grid for `box`. Returns false, leaving `into` undefined, where the grid would not
 * halve the lights per fragment.
 */
export function divideLights(
  packed: Readonly<PackedLights>,
  box: Box,
  into: PackedLights,
): boolean {
  const { directional, point, spot } = packed.counts;
  if (spot < LEAST_DIVIDED || directional + point > packed.sent / 2) return false;
  const cells = cellsOf(box);
  const { count } = cells;
  if (count < 2) return false;
  const scratch = new Int32Array(Math.floor(count * MOST_OF_THEM));
  const reaches: Reach[] = [];
  let listed = 0;
  let unlisted = directional + point;
  const isTooMany = () => unlisted + listed / count > packed.sent / 2;
  forEachLight(packed, (light, kind, row) => {
    if (kind !== 'spot' || isTooMany()) return;
    const reached = reachedCells(packed, row, cells, scratch);
    if (reached === null) {
      unlisted += 1;
    } else {
      listed += reached.length;
    }
    reaches.push({ light, row, cells: reached });
  });
  if (isTooMany()) return false;
  const ordered = writeLights(packed, reaches, into);
  writeGrid(ordered, cells, listed, into);
  return true;
}

function cellsOf(box: Box): Cells {
  const extent = [box[3] - box[0], box[4] - box[1], box[5] - box[2]] as const;
  const largest = Math.max(...extent);
  let edge = largest / MOST_CELLS;
  const along = (length: number) => Math.max(1, Math.floor(length / edge));
  const fits = () => along(extent[0]) * along(extent[1]) * along(extent[2]) <= MOST_CELLS;
  if (!(largest > 0)) {
    edge = 1;
  } else {
    while (!fits()) {
      edge *= 1.02;
    }
  }
  const size = [along(extent[0]), along(extent[1]), along(extent[2])] as const;
  const coordinate = Math.max(...box.map(Math.abs));
  return {
    box,
    size,
    count: size[0] * size[1] * size[2],
    step: [extent[0] / size[0], extent[1] / size[1], extent[2] / size[2]],
    pad: PADDING.cell * edge + PADDING.coordinate * coordinate,
  };
}

/**
 * The cells that the spot reaches, found by halving the box; null where they are too many for a
 * list.
 */
function reachedCells(
  packed: Readonly<PackedLights>,
  row: number,
  { box, size, step, pad }: Cells,
  scratch: Int32Array,
): Int32Array | null {
  const cone = new Cone().read(packed, row);
  let count = 0;
  const visit = (i0: number, j0: number, k0: number, i1: number, j1: number, k1: number) => {
    if (count > scratch.length) return;
    const x0 = box[0] + i0 * step[0] - pad;
    const y0 = box[1] + j0 * step[1] - pad;
    const z0 = box[2] + k0 * step[2] - pad;
    const x1 = box[0] + i1 * step[0] + pad;
    const y1 = box[1] + j1 * step[1] + pad;
    const z1 = box[2] + k1 * step[2] + pad;
    if (!cone.reaches(x0, y0, z0, x1, y1, z1, 0)) return;
    const i = i1 - i0;
    const j = j1 - j0;
    const k = k1 - k0;
    if (i === 1 && j === 1 && k === 1) {
      if (count < scratch.length) {
        scratch[count] = i0 + size[0] * (j0 + size[1] * k0);
      }
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

/**
 * Copies all lights, unlisted spots before listed ones. Returns the spots in that order, with their
 * new rows.
 */
function writeLights(
  packed: Readonly<PackedLights>,
  reaches: readonly Reach[],
  into: PackedLights,
): readonly Reach[] {
  const { directional, point } = packed.counts;
  const before = directional + point;
  const firstRow = HEADER.rows + directional * ROWS.directional.rows + point * ROWS.point.rows;
  reserve(into, packed.rows, packed.sent);
  into.data.set(packed.data.subarray(0, firstRow * 4));
  into.features.set(packed.features.subarray(0, before));
  into.active = packed.active;
  into.sent = packed.sent;
  into.rows = packed.rows;
  Object.assign(into.counts, packed.counts);
  const ordered = [
    ...reaches.filter(({ cells }) => cells === null),
    ...reaches.filter(({ cells }) => cells !== null),
  ];
  const { rows } = ROWS.spot;
  return ordered.map(({ light, row, cells }, i) => {
    const newRow = firstRow + i * rows;
    into.data.set(packed.data.subarray(row * 4, (row + rows) * 4), newRow * 4);
    into.features[before + i] = packed.features[light]!;
    return { light: before + i, row: newRow, cells };
  });
}

function writeGrid(reaches: readonly Reach[], cells: Cells, listed: number, into: PackedLights) {
  const { box, size, step, count } = cells;
  const grid = into.rows;
  const firstCell = grid + GRID.rows;
  const firstListed = firstCell + count;
  into.rows = firstListed + Math.ceil(listed / 4);
  reserve(into, into.rows, into.sent);
  const { data } = into;
  data.fill(0, grid * 4, into.rows * 4);
  const put = (row: number, values: readonly number[]): void => data.set(values, row * 4);
  data[HEADER.counts * 4 + 3] = grid;
  put(grid + GRID.low, [box[0], box[1], box[2], firstCell]);
  put(grid + GRID.scale, [...step.map((s) => (s > 0 ? 1 / s : 0)), firstListed]);
  put(grid + GRID.size, [...size, reaches.filter(({ cells }) => cells === null).length]);
  // Count the spots of each cell, then find where each list begins, then fill the lists.
  const cell = (i: number) => (firstCell + i) * 4;
  for (const { cells } of reaches) {
    for (const i of cells ?? []) {
      data[cell(i) + 1]! += 1;
    }
  }
  const next = new Int32Array(count);
  let index = 0;
  for (let i = 0; i < count; i++) {
    data[cell(i)] = index;
    next[i] = index;
    index += data[cell(i) + 1]!;
  }
  for (const { row, cells } of reaches) {
    for (const i of cells ?? []) {
      data[firstListed * 4 + next[i]!] = row;
      next[i]! += 1;
    }
  }
}
