// Builds geometries of curved surfaces row by row, so that a large one can be built in slices.
import { BufferAttribute, BufferGeometry } from 'three';

/** A geometry that is built in steps, each of some hundred vertices; `return` gives it. */
export type Steps = Generator<undefined, BufferGeometry, undefined>;

/** Takes the next vertex: place, unit normal and texture coordinates. */
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
   * The corners of a quadrangle's two triangles, counter-clockwise from outside. 0 and 1 are in its first row, 2 and 3
   * in its second one.
   */
  readonly corners: readonly [number, number, number, number, number, number];
  /** All vertices of the first row, or of the last one, are in one place: they have one triangle for a quadrangle. */
  readonly closedFirst?: boolean;
  readonly closedLast?: boolean;
  /** Puts the vertices of a row: one more than there are columns. Row 0 to `rows`. */
  readonly row: (row: number, put: Put) => void;
}

/** Most vertices that 16-bit indices can tell apart. */
const FEW = 2 ** 16;

/** One geometry of all these grids. */
export function* gridGeometry(grids: readonly Grid[]): Steps {
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
  let corner = 0;
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
  for (const grid of grids) {
    const { columns, rows, corners } = grid;
    for (let row = 0; row <= rows; row++) {
      const first = vertex;
      grid.row(row, put);
      const from = row === 1 && grid.closedFirst === true ? 3 : 0;
      const to = row === rows && grid.closedLast === true ? 3 : 6;
      for (let column = 0; row > 0 && column < columns; column++)
        for (let k = from; k < to; k++) {
          const c = corners[k]!;
          // A vertex of the row before, or of this one.
          index[corner++] = first + column + (c & 1) - (c < 2 ? columns + 1 : 0);
        }
      yield;
    }
  }
  const geometry = new BufferGeometry();
  geometry.setIndex(new BufferAttribute(index, 1));
  geometry.setAttribute('position', new BufferAttribute(position, 3));
  geometry.setAttribute('normal', new BufferAttribute(normal, 3));
  geometry.setAttribute('uv', new BufferAttribute(uv, 2));
  return geometry;
}

/** All steps at once. */
export function finish(steps: Steps): BufferGeometry {
  for (;;) {
    const { done, value } = steps.next();
    if (done === true) return value;
  }
}
