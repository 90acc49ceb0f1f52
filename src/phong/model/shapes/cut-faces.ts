// Planes and boxes that are large for the distance of the eye, cut by cubes around it, each four
// times as large as the one before. A rasteriser moves vertices to a grid of parts of a pixel. What
// that changes at a vertex far beside or behind the eye is large in what is seen nearby, and a
// triangle thinner than a pixel is extrapolated to the pixel's centre: so triangles are as large as
// they are far away, and few. Neighbouring faces are cut in the same points of their edge.
import type { BufferGeometry } from 'three';
import type { Vec3 } from '../../math/vector.js';
import { indexedGeometry } from './grid-geometry.js';

/** In the shape's own space, where each side is 1. */
export interface Cut {
  /** About where the eye is. */
  readonly center: Vec3;
  /** Half the sides of the smallest cube. */
  readonly half: Vec3;
}

export const keyOfCut = ({ center, half }: Cut): string =>
  `cut ${center.join(' ')} ${half.join(' ')}`;

export type CutName = 'box' | 'plane';

/**
 * A cube's side over that of the next smaller one: no triangle is longer than about 8 times its
 * distance from the eye, up to which a whole shape is right too (`LARGE` in levels.ts).
 */
const RATIO = 4;

/** Cubes beyond this have no use: float32 coordinates within a side of 1 are 2^-25 apart. */
const MOST_CUBES = 13;

/** At least the triangles of any cut. */
export const MOST_CUT_TRIANGLES = 6 * (2 + 8 * MOST_CUBES);

/**
 * The axes of the texture's u and v, the directions in which they grow (v: shrinks), the outside.
 */
type Face = readonly [
  u: 0 | 1 | 2,
  v: 0 | 1 | 2,
  w: 0 | 1 | 2,
  uSign: number,
  vSign: number,
  at: number,
];

/** As three.js's BoxGeometry and PlaneGeometry have them. */
const FACES: Readonly<Record<CutName, readonly Face[]>> = {
  box: [
    [2, 1, 0, -1, -1, 0.5],
    [2, 1, 0, 1, -1, -0.5],
    [0, 2, 1, 1, 1, 0.5],
    [0, 2, 1, 1, -1, -0.5],
    [0, 1, 2, 1, -1, 0.5],
    [0, 1, 2, -1, -1, -0.5],
  ],
  plane: [[0, 2, 1, 1, 1, 0]],
};

/**
 * Where a cube meets a face, in the face's own directions. Its sides in the order of its corners.
 */
type Rectangle = readonly [u0: number, v1: number, u1: number, v0: number];

const WHOLE: Rectangle = [-0.5, 0.5, 0.5, -0.5];

export function cutGeometry(name: CutName, cut: Cut): BufferGeometry {
  const position: number[] = [];
  const normal: number[] = [];
  const uv: number[] = [];
  const index: number[] = [];
  // A cube that ends in a face's edge meets the face in a line.
  const same = (a: number, b: number) => uv[2 * a] === uv[2 * b] && uv[2 * a + 1] === uv[2 * b + 1];
  const add = (a: number, b: number, c: number) => {
    if (!same(a, b) && !same(b, c) && !same(c, a)) {
      index.push(a, b, c);
    }
  };
  for (const face of FACES[name]) {
    const [uAxis, vAxis, wAxis, uSign, vSign, at] = face;
    const outside = at < 0 ? -1 : 1;
    let inner: Rectangle | null = null;
    for (const rectangle of rectanglesOf(face, cut)) {
      const first = position.length / 3;
      const [u0, v1, u1, v0] = rectangle;
      for (const [u, v] of [
        [u0, v0],
        [u0, v1],
        [u1, v1],
        [u1, v0],
      ] as const) {
        // oxfmt-ignore
        const place = [0, 0, 0];
        place[uAxis] = uSign * u;
        place[vAxis] = vSign * v;
        place[wAxis] = at;
        position.push(...place);
        const N = [0, 0, 0];
        N[wAxis] = outside;
        normal.push(...N);
        uv.push(u + 0.5, 0.5 - v);
      }
      if (inner === null) {
        add(first, first + 1, first + 3);
        add(first + 1, first + 2, first + 3);
      } else {
        for (let k = 0; k < 4; k++) {
          if (inner[k] === rectangle[k]) continue; // both end at the face's edge
          const next = (k + 1) % 4;
          add(first + k, first + next, first + next - 4);
          add(first + k, first + next - 4, first + k - 4);
        }
      }
      inner = rectangle;
    }
  }
  return indexedGeometry(
    index,
    new Float32Array(position),
    new Float32Array(normal),
    new Float32Array(uv),
  );
}

/** From the smallest one to the whole face. */
function rectanglesOf([u, v, w, uSign, vSign, at]: Face, { center, half }: Cut): Rectangle[] {
  const found: Rectangle[] = [];
  let size = 1;
  for (let i = 0; i < MOST_CUBES; i++) {
    // The same sums for the two faces of an edge, which are cut in the same points.
    const from = (axis: 0 | 1 | 2) => center[axis] - size * half[axis];
    const to = (axis: 0 | 1 | 2) => center[axis] + size * half[axis];
    const low = (axis: 0 | 1 | 2) => Math.max(from(axis), -0.5);
    const high = (axis: 0 | 1 | 2) => Math.min(to(axis), 0.5);
    size *= RATIO;
    const meets = from(w) <= at && to(w) >= at && low(u) <= high(u) && low(v) <= high(v);
    if (!meets) continue;
    const rectangle: Rectangle = [
      uSign > 0 ? low(u) : -high(u),
      vSign > 0 ? high(v) : -low(v),
      uSign > 0 ? high(u) : -low(u),
      vSign > 0 ? low(v) : -high(v),
    ];
    if (rectangle.every((edge, k) => edge === WHOLE[k])) break;
    found.push(rectangle);
  }
  return [...found, WHOLE];
}
