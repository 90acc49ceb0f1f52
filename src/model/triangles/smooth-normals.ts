// Normals for corners that have none in the file: the mean of the faces around a vertex that are smoothed together,
// weighted by their angles there, so that it does not depend on how polygons are cut into triangles. Computed in
// float64.
import { PAUSE_MASK, type Slices } from '../slices.js';
import { FACETED, itemAt, NONE, setItem, UNSTATED, type CornerLists } from './corner-lists.js';
import { faceVector, type FaceVector } from './triangulate.js';

/**
 * Faces without a stated smoothing group are smoothed together if they meet at less than 40°. The five regular solids
 * keep their edges (an icosahedron's faces meet at 41.8°), and cylinders of ten sides or more (36°) are round.
 */
const CREASE_COSINE = Math.cos((40 * Math.PI) / 180);

/** Most corners at a vertex that are compared in pairs. With more, each triangle has its own normal there. */
const FAN_LIMIT = 256;

/** Appends normals to `lists.normals` and sets them in `lists.cornerNormals`. */
export async function smoothNormals(lists: CornerLists, slices: Slices): Promise<void> {
  const { corners, cornerNormals } = lists;
  const count = corners.length;
  const { starts, around } = await cornersByVertex(lists, slices);
  if (around.length === 0) return;
  const { normals, angles } = await measuredFaces(lists, slices);
  const chosen = new Int32Array(around.length).fill(NONE);
  const sum: FaceVector = { x: 0, y: 0, z: 0 };
  const { groups } = lists;
  const groupOf = (face: number): number =>
    face < groups.length ? (groups.array[face] ?? UNSTATED) : UNSTATED;

  const joined = (a: number, b: number): boolean => {
    if (a === b) return true;
    const group = groupOf(a);
    if (group !== groupOf(b) || group === FACETED) return false;
    return group !== UNSTATED || dot(normals, a, b) >= CREASE_COSINE;
  };

  for (let vertex = 0; vertex + 1 < starts.length; vertex += 1) {
    if ((vertex & PAUSE_MASK) === 0 && slices.due) await slices.pause();
    const start = starts[vertex] ?? 0;
    const end = starts[vertex + 1] ?? 0;
    const first = lists.normals.length / 3;
    for (let i = start; i < end; i += 1) {
      const face = triangleOf(around[i] ?? 0);
      sum.x = sum.y = sum.z = 0;
      if (end - start > FAN_LIMIT) {
        addFace(sum, normals, face, 1);
      } else {
        for (let j = start; j < end; j += 1) {
          const corner = around[j] ?? 0;
          if (joined(face, triangleOf(corner)))
            addFace(sum, normals, triangleOf(corner), angles[corner] ?? 0);
        }
      }
      lists.pushNormal(sum.x, sum.y, sum.z);
      chosen[i] = mergedWithLast(lists, first);
    }
  }
  // In the order of corners, because the list may end early.
  const byCorner = new Int32Array(count).fill(NONE);
  for (let i = 0; i < around.length; i += 1) {
    if ((i & PAUSE_MASK) === 0 && slices.due) await slices.pause();
    byCorner[around[i] ?? 0] = chosen[i] ?? NONE;
  }
  for (let corner = 0; corner < count; corner += 1) {
    if ((corner & PAUSE_MASK) === 0 && slices.due) await slices.pause();
    const own = byCorner[corner] ?? NONE;
    if (corner >= cornerNormals.length) setItem(cornerNormals, corner, own);
    else if (own !== NONE) cornerNormals.array[corner] = own;
  }
}

const triangleOf = (corner: number): number => Math.floor(corner / 3);

/** The corners without a normal, sorted by vertex: those of vertex i are from `starts[i]` to `starts[i + 1]`. */
async function cornersByVertex(
  lists: CornerLists,
  slices: Slices,
): Promise<{ readonly starts: Uint32Array; readonly around: Uint32Array }> {
  const { corners, cornerNormals, places } = lists;
  const starts = new Uint32Array(places.count + 1);
  let missing = 0;
  for (let corner = 0; corner < corners.length; corner += 1) {
    if ((corner & PAUSE_MASK) === 0 && slices.due) await slices.pause();
    if (itemAt(cornerNormals, corner) !== NONE) continue;
    const vertex = corners.array[corner] ?? 0;
    starts[vertex] = (starts[vertex] ?? 0) + 1;
    missing += 1;
  }
  const around = new Uint32Array(missing);
  if (missing === 0) return { starts, around };
  for (let vertex = 1; vertex < starts.length; vertex += 1) {
    starts[vertex] = (starts[vertex] ?? 0) + (starts[vertex - 1] ?? 0);
  }
  // `starts` holds the ends now. Filling from the last corner down moves them to the starts.
  for (let corner = corners.length - 1; corner >= 0; corner -= 1) {
    if ((corner & PAUSE_MASK) === 0 && slices.due) await slices.pause();
    if (itemAt(cornerNormals, corner) !== NONE) continue;
    const vertex = corners.array[corner] ?? 0;
    const place = (starts[vertex] ?? 0) - 1;
    starts[vertex] = place;
    around[place] = corner;
  }
  return { starts, around };
}

interface Faces {
  /** Unit normal of each triangle, or zero. */
  readonly normals: Float32Array;
  /** Angle of the triangle at each corner, in radians. */
  readonly angles: Float32Array;
}

async function measuredFaces({ corners, places }: CornerLists, slices: Slices): Promise<Faces> {
  const count = corners.length / 3;
  const normals = new Float32Array(3 * count);
  const angles = new Float32Array(3 * count);
  const position = places.array;
  const face: FaceVector = { x: 0, y: 0, z: 0 };
  for (let i = 0; i < count; i += 1) {
    if ((i & PAUSE_MASK) === 0 && slices.due) await slices.pause();
    const a = 3 * (corners.array[3 * i] ?? 0);
    const b = 3 * (corners.array[3 * i + 1] ?? 0);
    const c = 3 * (corners.array[3 * i + 2] ?? 0);
    const doubleArea = faceVector(position, a, b, c, face);
    if (!(doubleArea > 0)) continue;
    normals[3 * i] = face.x / doubleArea;
    normals[3 * i + 1] = face.y / doubleArea;
    normals[3 * i + 2] = face.z / doubleArea;
    angles[3 * i] = Math.atan2(doubleArea, edgesDot(position, a, b, c));
    angles[3 * i + 1] = Math.atan2(doubleArea, edgesDot(position, b, c, a));
    angles[3 * i + 2] = Math.atan2(doubleArea, edgesDot(position, c, a, b));
  }
  return { normals, angles };
}

/** Dot product of the edges from `a` to `b` and to `c`. */
function edgesDot(position: Float32Array, a: number, b: number, c: number): number {
  let sum = 0;
  for (let axis = 0; axis < 3; axis += 1) {
    const origin = position[a + axis] ?? 0;
    sum += ((position[b + axis] ?? 0) - origin) * ((position[c + axis] ?? 0) - origin);
  }
  return sum;
}

function dot(normals: Float32Array, a: number, b: number): number {
  return (
    (normals[3 * a] ?? 0) * (normals[3 * b] ?? 0) +
    (normals[3 * a + 1] ?? 0) * (normals[3 * b + 1] ?? 0) +
    (normals[3 * a + 2] ?? 0) * (normals[3 * b + 2] ?? 0)
  );
}

function addFace(sum: FaceVector, normals: Float32Array, face: number, weight: number): void {
  sum.x += weight * (normals[3 * face] ?? 0);
  sum.y += weight * (normals[3 * face + 1] ?? 0);
  sum.z += weight * (normals[3 * face + 2] ?? 0);
}

/** The number of the last normal, or of an equal one from `first` on: then the last is removed. */
function mergedWithLast({ normals }: CornerLists, first: number): number {
  const { array } = normals;
  const last = normals.length / 3 - 1;
  for (let i = Math.max(first, last - FAN_LIMIT); i < last; i += 1) {
    const same =
      array[3 * i] === array[3 * last] &&
      array[3 * i + 1] === array[3 * last + 1] &&
      array[3 * i + 2] === array[3 * last + 2];
    if (!same) continue;
    normals.length -= 3;
    return i;
  }
  return last;
}
