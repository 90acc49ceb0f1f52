// Normals for corners that have none: the mean, in float64, of the faces around a vertex that are
// smoothed together, weighted by their angles there, so that it does not depend on how polygons are
// cut into triangles.
import { cosDegrees } from '../../../phong/math/angle.js';
import { atan2 } from '../../../phong/math/elementary.js';
import type { Slices } from '../slices.js';
import { FACETED, itemAt, NONE, NOT_THERE, UNSTATED, type CornerLists } from './corner-lists.js';
import { faceVector, type FaceVector } from './triangulate.js';
import { free } from '../limits.js';

/**
 * Faces without a stated smoothing group are smoothed together if they meet at less than 40°. The
 * five regular solids keep their edges (an icosahedron's faces meet at 41.8°), and cylinders of ten
 * sides or more (36°) are round.
 */
const CREASE_COSINE = /* @__PURE__ */ cosDegrees(40);
/** Faces within this angle of one of them all meet at less than the crease, rounding included. */
const ALIKE_COSINE = /* @__PURE__ */ cosDegrees(19.9);
/** Cosine of 120°: a neighbour in a sheet that turns by up to 60° there is on its other side. */
const TURNED_AWAY = -0.5;

/**
 * Most corners at a vertex that are compared in pairs. With more, each triangle has its own normal
 * there.
 */
const FAN_LIMIT = 256;

/**
 * Faces whose sum is no longer than this share of its terms cancel: what is left is rounding of
 * float32 normals.
 */
const CANCELLED = 1e-5;

/** Appends normals to `lists.normals` and sets them in `lists.cornerNormals`. */
export async function smoothNormals(lists: CornerLists, slices: Slices): Promise<void> {
  const { starts, around } = await cornersByVertex(lists, slices);
  if (around.length === 0) return;
  const faces = await measuredFaces(lists, slices);
  const fan = new Fan();
  for (let vertex = 0; vertex + 1 < starts.length; vertex += 1) {
    let from = starts[vertex]!;
    const end = starts[vertex + 1]!;
    const smoothed = end - from <= FAN_LIMIT;
    do {
      const count = Math.min(end - from, FAN_LIMIT);
      if (slices.took(1 / 64 + count * (1 + count / 64))) {
        await slices.pause();
      }
      fan.load(around, from, count, lists, faces);
      fan.write(lists, smoothed);
      from += FAN_LIMIT;
    } while (from < end);
  }
  free(starts, around, faces.normals, faces.angles);
}

/** The corners around a vertex, copied out of the lists: each is compared with every other. */
class Fan {
  readonly #x = new Float64Array(FAN_LIMIT);
  readonly #y = new Float64Array(FAN_LIMIT);
  readonly #z = new Float64Array(FAN_LIMIT);
  readonly #angles = new Float64Array(FAN_LIMIT);
  /** How many there are. */
  #count = 0;
  readonly #corners = new Int32Array(FAN_LIMIT);
  readonly #triangles = new Int32Array(FAN_LIMIT);
  readonly #groups = new Int32Array(FAN_LIMIT).fill(UNSTATED);
  /** The corners of its face before and after each corner, or those of its triangle. */
  readonly #before = new Uint32Array(FAN_LIMIT);
  readonly #after = new Uint32Array(FAN_LIMIT);
  /** The mean normal of the faces that are smoothed with the last one asked for; any length. */
  readonly #sum: FaceVector = { x: 0, y: 0, z: 0 };

  load(
    around: Uint32Array,
    from: number,
    count: number,
    lists: CornerLists,
    { normals, angles }: Faces,
  ): void {
    const { groups } = lists;
    const vertices = lists.corners.array;
    const stated = groups.length > 0;
    this.#count = count;
    for (let i = 0; i < count; i += 1) {
      const corner = around[from + i]!;
      const triangle = (corner / 3) | 0;
      const first = 3 * triangle;
      this.#corners[i] = corner;
      this.#triangles[i] = triangle;
      this.#x[i] = normals[first]!;
      this.#y[i] = normals[first + 1]!;
      this.#z[i] = normals[first + 2]!;
      this.#angles[i] = angles[corner]!;
      if (!stated) continue;
      this.#groups[i] = itemAt(groups, triangle);
      this.#before[i] = vertices[first + ((corner - first + 2) % 3)]!;
      this.#after[i] = vertices[first + ((corner - first + 1) % 3)]!;
    }
    if (!stated) return;
    for (let first = 0, i = 1; i <= count; i += 1) {
      const triangle = this.#triangles[i]!;
      const goesOn = i < count && triangle === this.#triangles[i - 1]! + 1;
      if (goesOn && lists.joined.array[triangle] === 1) continue;
      if (i - first > 1) {
        this.#joinFace(first, i);
      }
      first = i;
    }
  }

  /**
   * Two sides of a sheet are the same faces, but not the same triangles: forgets the diagonals
   * between the triangles of one face.
   */
  #joinFace(from: number, to: number) {
    let before = this.#before[from]!;
    let after = this.#after[from]!;
    for (let i = from + 1; i < to; i += 1) {
      if (this.#after[i] === before) {
        before = this.#before[i]!;
      } else if (this.#before[i] === after) {
        after = this.#after[i]!;
      }
    }
    this.#before.fill(before, from, to);
    this.#after.fill(after, from, to);
  }

  /**
   * Gives each of the corners a normal. @param smoothed whether it may be that of several faces.
   */
  write(lists: CornerLists, smoothed: boolean): void {
    const first = lists.normals.length / 3;
    const sum = this.#sum;
    let areAlike = false;
    let normal = first;
    for (let i = 0; i < this.#count; i += 1) {
      if (!areAlike) {
        this.#takeOwn(i);
        areAlike = smoothed && this.#smooth(i);
        lists.pushNormal(sum.x, sum.y, sum.z);
        normal = mergedWithLast(lists, first);
      }
      lists.cornerNormals.array[this.#corners[i]!] = normal;
    }
  }

  /**
   * Replaces the corner's own normal by that of the faces around it. True if all of them have the
   * same sum, in the same order: usual, and no pairs need to be compared then.
   */
  #smooth(i: number): boolean {
    const x = this.#x[i]!;
    const y = this.#y[i]!;
    const z = this.#z[i]!;
    const triangle = this.#triangles[i]!;
    const group = this.#groups[i]!;
    let least = group === UNSTATED ? CREASE_COSINE : -Infinity;
    if (group !== UNSTATED && group !== FACETED && this.#hasOtherSide(i)) {
      least = 0;
    }
    let sumX = 0;
    let sumY = 0;
    let sumZ = 0;
    let weights = 0;
    let areAlike = group === UNSTATED;
    for (let j = 0; j < this.#count; j += 1) {
      const otherX = this.#x[j]!;
      const otherY = this.#y[j]!;
      const otherZ = this.#z[j]!;
      const along = x * otherX + y * otherY + z * otherZ;
      areAlike &&= along > ALIKE_COSINE && this.#groups[j] === group;
      if (this.#triangles[j] !== triangle) {
        if (group === FACETED || this.#groups[j] !== group || along < least) continue;
      }
      const angle = this.#angles[j]!;
      sumX += angle * otherX;
      sumY += angle * otherY;
      sumZ += angle * otherZ;
      weights += angle;
    }
    // Faces of both sides in one group cancel, and a face that is folded over would be lit from
    // behind.
    const along = sumX * x + sumY * y + sumZ * z;
    if (!(x * x + y * y + z * z > 0) || along > CANCELLED * weights) {
      this.#sum.x = sumX;
      this.#sum.y = sumY;
      this.#sum.z = sumZ;
      return areAlike;
    }
    return false;
  }

  /**
   * Whether the sheet around this vertex is written twice, front and back: a face of the same group
   * looks the other way and has the same edge in the same direction, or both edges reversed.
   */
  #hasOtherSide(i: number): boolean {
    const x = this.#x[i]!;
    const y = this.#y[i]!;
    const z = this.#z[i]!;
    const [before, after, group] = [this.#before[i], this.#after[i], this.#groups[i]];
    for (let j = 0; j < this.#count; j += 1) {
      const isSame = this.#before[j] === before || this.#after[j] === after;
      const isTwin = this.#before[j] === after && this.#after[j] === before;
      if (j === i || !(isSame || isTwin) || this.#groups[j] !== group) continue;
      const along = x * this.#x[j]! + y * this.#y[j]! + z * this.#z[j]!;
      if (along < TURNED_AWAY) return true;
    }
    return false;
  }

  #takeOwn(i: number) {
    this.#sum.x = this.#x[i]!;
    this.#sum.y = this.#y[i]!;
    this.#sum.z = this.#z[i]!;
  }
}

/**
 * The corners without a normal, sorted by vertex: those of vertex i are from `starts[i]` to
 * `starts[i + 1]`.
 */
async function cornersByVertex(lists: CornerLists, slices: Slices) {
  const { corners, cornerNormals, places } = lists;
  // So that every corner has an entry that can be overwritten.
  cornerNormals.fillTo(corners.length, NONE);
  const count = corners.length;
  const [vertices, normals] = [corners.array, cornerNormals.array];
  const starts = new Uint32Array(places.count + 1);
  let missing = 0;
  await slices.over(count, (from, to) => {
    for (let corner = from; corner < to; corner += 1) {
      const vertex = vertices[corner]!;
      if (vertex === NOT_THERE || normals[corner] !== NONE) continue;
      starts[vertex]! += 1;
      missing += 1;
    }
  });
  const around = new Uint32Array(missing);
  if (missing === 0) return { starts, around };
  let sum = 0;
  await slices.over(starts.length, (from, to) => {
    for (let vertex = from; vertex < to; vertex += 1) {
      starts[vertex] = sum += starts[vertex]!;
    }
  });
  // `starts` holds the ends now. Filling from the last corner down moves them to the starts.
  await slices.over(count, (from, to) => {
    for (let corner = count - 1 - from; corner >= count - to; corner -= 1) {
      const vertex = vertices[corner]!;
      if (vertex === NOT_THERE || normals[corner] !== NONE) continue;
      around[(starts[vertex]! -= 1)] = corner;
    }
  });
  return { starts, around };
}

interface Faces {
  /** Unit normal of each triangle, or zero. */
  readonly normals: Float32Array;
  /** Angle of the triangle at each corner, in radians. */
  readonly angles: Float32Array;
}

async function measuredFaces({ corners, places }: CornerLists, slices: Slices): Promise<Faces> {
  const normals = new Float32Array(corners.length);
  const angles = new Float32Array(corners.length);
  const [position, vertices] = [places.array, corners.array];
  const face: FaceVector = { x: 0, y: 0, z: 0 };
  await slices.over(corners.length, (from, to) => {
    for (let i = from; i < to; i += 3) {
      const a = 3 * vertices[i]!;
      const b = 3 * vertices[i + 1]!;
      const c = 3 * vertices[i + 2]!;
      const doubleArea = faceVector(position, a, b, c, face);
      if (!(doubleArea > 0)) continue;
      normals[i] = face.x / doubleArea;
      normals[i + 1] = face.y / doubleArea;
      normals[i + 2] = face.z / doubleArea;
      const first = atan2(doubleArea, edgesDot(position, a, b, c));
      const second = atan2(doubleArea, edgesDot(position, b, c, a));
      angles[i] = first;
      angles[i + 1] = second;
      angles[i + 2] = Math.PI - first - second; // a third less of the costliest step
    }
  });
  return { normals, angles };
}

/** Dot product of the edges from `a` to `b` and to `c`. */
function edgesDot(position: Float32Array, a: number, b: number, c: number): number {
  let sum = 0;
  for (let axis = 0; axis < 3; axis += 1) {
    const origin = position[a + axis]!;
    sum += (position[b + axis]! - origin) * (position[c + axis]! - origin);
  }
  return sum;
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
