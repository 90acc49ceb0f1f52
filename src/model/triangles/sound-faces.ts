// Judges the faces of a whole file, when all that they refer to has come: what is not there is left out, and corners
// that run against their normals are turned around.
import type { LeftOut } from '../left-out.js';
import type { Slices } from '../slices.js';
import { type CornerLists, type Growing, itemAt, NONE, NOT_THERE, setItem } from './corner-lists.js';
import { faceVector, type FaceVector } from './triangulate.js';

/**
 * Marks all corners of a face with a vertex that is missing or no number as {@link NOT_THERE}. Texture coordinates that
 * are missing, and normals that are missing or have no direction, become {@link NONE}. OBJ and PLY have no rule of
 * winding, so that the normals tell which side is outside: where they point the other way, two corners are exchanged.
 */
export async function keepSoundFaces(lists: CornerLists, leftOut: LeftOut, slices: Slices): Promise<void> {
  const { joined, triangles } = lists;
  const corners = new Corners(lists);
  for (let first = 0; first < triangles;) {
    let end = first;
    let isSound = true;
    do {
      if (slices.took(1 / 4)) await slices.pause();
      isSound &&= corners.areThere(end);
      end += 1;
    } while (end < triangles && joined.array[end] === 1);
    if (!isSound) leftOut.add('face');
    for (let triangle = first; triangle < end; triangle += 1) {
      if (slices.took(1 / 4)) await slices.pause();
      if (isSound) corners.settle(triangle);
      else lists.corners.array.fill(NOT_THERE, 3 * triangle, 3 * triangle + 3);
    }
    corners.nameMissing(leftOut);
    first = end;
  }
}

/** The corners of triangles. */
class Corners {
  readonly #lists: CornerLists;
  readonly #uvs: number;
  readonly #normals: number;
  /** What the current face refers to although it is not there. */
  readonly #misses = { uv: false, normal: false };
  readonly #face: FaceVector = { x: 0, y: 0, z: 0 };

  constructor(lists: CornerLists) {
    this.#lists = lists;
    this.#uvs = lists.uvs.length / 2;
    this.#normals = lists.normals.length / 3;
  }

  areThere(triangle: number): boolean {
    const { corners, places } = this.#lists;
    const { array } = corners;
    const at = 3 * triangle;
    return (
      places.has(array[at] ?? NOT_THERE) &&
      places.has(array[at + 1] ?? NOT_THERE) &&
      places.has(array[at + 2] ?? NOT_THERE)
    );
  }

  settle(triangle: number): void {
    const { cornerUvs, cornerNormals } = this.#lists;
    for (let corner = 3 * triangle; corner < 3 * triangle + 3; corner += 1) {
      if (itemAt(cornerUvs, corner) >= this.#uvs) {
        cornerUvs.array[corner] = NONE;
        this.#misses.uv = true;
      }
      const normal = itemAt(cornerNormals, corner);
      if (normal >= this.#normals) this.#misses.normal = true;
      if (normal !== NONE && !this.#hasDirection(normal)) cornerNormals.array[corner] = NONE;
    }
    if (this.#normals > 0 && this.#isTurned(triangle)) this.#turn(3 * triangle);
  }

  /** Counts a face whose triangles have been settled. */
  nameMissing(leftOut: LeftOut): void {
    for (const kind of ['uv', 'normal'] as const) {
      if (this.#misses[kind]) leftOut.add(kind);
      this.#misses[kind] = false;
    }
  }

  #hasDirection(normal: number): boolean {
    const { array } = this.#lists.normals;
    return normal < this.#normals && !(array[3 * normal] === 0 && array[3 * normal + 1] === 0 && array[3 * normal + 2] === 0); // prettier-ignore
  }

  /** Whether the normals of its corners point away from the side where the corners run counter-clockwise. */
  #isTurned(triangle: number): boolean {
    const { corners, cornerNormals, normals, places } = this.#lists;
    const at = 3 * triangle;
    const [a, b, c] = [corners.array[at] ?? 0, corners.array[at + 1] ?? 0, corners.array[at + 2] ?? 0];
    faceVector(places.array, 3 * a, 3 * b, 3 * c, this.#face);
    let along = 0;
    for (let corner = at; corner < at + 3; corner += 1) {
      const normal = 3 * itemAt(cornerNormals, corner);
      if (normal < 0) continue;
      along += this.#face.x * (normals.array[normal] ?? 0);
      along += this.#face.y * (normals.array[normal + 1] ?? 0);
      along += this.#face.z * (normals.array[normal + 2] ?? 0);
    }
    return along < 0;
  }

  #turn(at: number): void {
    const { corners, cornerUvs, cornerNormals } = this.#lists;
    [corners.array[at + 1], corners.array[at + 2]] = [corners.array[at + 2] ?? 0, corners.array[at + 1] ?? 0];
    exchange(cornerUvs, at + 1, at + 2);
    exchange(cornerNormals, at + 1, at + 2);
  }
}

function exchange(list: Growing<Int32Array>, a: number, b: number): void {
  const [first, second] = [itemAt(list, a), itemAt(list, b)];
  setItem(list, a, second);
  setItem(list, b, first);
}
