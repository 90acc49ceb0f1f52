// Builds geometries of curved surfaces row by row.
import { BufferAttribute, BufferGeometry } from 'three';
import { cosDegrees, sinDegrees } from '../../math/angle.js';

/** Writes a vertex: its place, unit normal and texture coordinates. */
export type Put = (
  x: number,
  y: number,
  z: number,
  nx: number,
  ny: number,
  nz: number,
  u: number,
  v: number,
) => void;

/** Quadrangles in rows and columns, each cut into two triangles. */
export interface Grid {
  readonly columns: number;
  readonly rows: number;
  /**
   * Corners of its two triangles, counter-clockwise from outside: 0 and 1 in its first row, 2 and 3
   * in the next.
   */
  readonly corners: readonly [number, number, number, number, number, number];
  /**
   * All vertices of the first row, or of the last one, are in one place: they have one triangle for
   * a quadrangle.
   */
  readonly closedFirst?: boolean;
  readonly closedLast?: boolean;
  /** Puts the vertices of a row, 0 to `rows`: one more than there are columns. */
  readonly row: (row: number, put: Put) => void;
}

/** Most vertices that 16-bit indices can tell apart. */
const FEW = 2 ** 16;

export function gridGeometry(grids: readonly Grid[]): BufferGeometry {
  let vertices = 0;
  let triangles = 0;
  for (const { columns, rows, closedFirst, closedLast } of grids) {
    vertices += (columns + 1) * (rows + 1);
    triangles += columns * (2 * rows - Number(closedFirst === true) - Number(closedLast === true));
  }
  const position = new Float32Array(3 * vertices);
  const normal = new Float32Array(3 * vertices);
  const uv = new Float32Array(2 * vertices);
  const index = vertices > FEW ? new Uint32Array(3 * triangles) : new Uint16Array(3 * triangles);
  let vertex = 0;
  const put: Put = (x, y, z, nx, ny, nz, u, v) => {
    const at = 3 * vertex;
    position[at] = x;
    position[at + 1] = y;
    position[at + 2] = z;
    normal[at] = nx;
    normal[at + 1] = ny;
    normal[at + 2] = nz;
    uv[2 * vertex] = u;
    uv[2 * vertex + 1] = v;
    vertex += 1;
  };
  let corner = 0;
  for (const grid of grids) {
    for (let row = 0; row <= grid.rows; row++) {
      if (row > 0) {
        corner = indexRow(index, corner, grid, row, vertex);
      }
      grid.row(row, put);
    }
  }
  return indexedGeometry(new BufferAttribute(index, 1), position, normal, uv);
}

/** A geometry of these vertices and triangles. */
export function indexedGeometry(
  index: BufferAttribute | number[],
  position: Float32Array,
  normal: Float32Array,
  uv: Float32Array,
): BufferGeometry {
  const geometry = new BufferGeometry();
  geometry.setIndex(index);
  geometry.setAttribute('position', new BufferAttribute(position, 3));
  geometry.setAttribute('normal', new BufferAttribute(normal, 3));
  geometry.setAttribute('uv', new BufferAttribute(uv, 2));
  return geometry;
}

/**
 * Writes the triangles between a row, of first vertex `first`, and the one before. Returns the next
 * corner.
 */
function indexRow(
  index: Uint16Array | Uint32Array,
  corner: number,
  grid: Grid,
  row: number,
  first: number,
): number {
  const { columns, rows, corners, closedFirst, closedLast } = grid;
  const from = row === 1 && closedFirst === true ? 3 : 0;
  const to = row === rows && closedLast === true ? 3 : 6;
  const step = to - from;
  for (let k = from; k < to; k++) {
    const c = corners[k]!;
    // The first vertex, of the row before or of this one.
    let vertex = first + (c & 1) - (c < 2 ? columns + 1 : 0);
    const end = vertex + columns;
    for (let at = corner + k - from; vertex < end; at += step) {
      index[at] = vertex++;
    }
  }
  return corner + step * columns;
}

/**
 * Cosines and sines of the angles that divide a circle into n parts. The last ones are the first
 * ones, exactly.
 */
export function circle(n: number): { readonly cos: Float64Array; readonly sin: Float64Array } {
  const angles = Float64Array.from({ length: n + 1 }, (_, i) => ((i % n) / n) * 360);
  return { cos: angles.map(cosDegrees), sin: angles.map(sinDegrees) };
}
