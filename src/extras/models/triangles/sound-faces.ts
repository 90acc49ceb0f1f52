// Drops faces and references to data that the file lacks, and reverses faces whose winding
// contradicts their normals.
import type { LeftOut } from '../left-out.js';
import { isZero } from '../model-reader.js';
import type { Slices } from '../slices.js';
import { type CornerLists, itemAt, NONE, NOT_THERE, setItem } from './corner-lists.js';
import { faceVector, type FaceVector } from './triangulate.js';

/**
 * Marks all corners of a face as {@link NOT_THERE} if one of its vertices is missing or not finite.
 * Texture coordinates that are missing, and normals that are missing or of zero length, become
 * {@link NONE}. OBJ and PLY define no winding, so the normals decide which side is outside: two
 * corners are exchanged where the winding says otherwise.
 */
export async function keepSoundFaces(
  lists: CornerLists,
  leftOut: LeftOut,
  slices: Slices,
): Promise<void> {
  const { corners, cornerNormals, cornerUvs, joined, triangles } = lists;
  const refers = cornerUvs.length + cornerNormals.length > 0;
  if (!refers && lists.areAllThere) return;
  /** 1 if the face refers to texture coordinates, or to normals, that the file lacks. */
  const misses = { uv: 0, normal: 0 };
  for (let first = 0; first < triangles;) {
    let end = first;
    let isSound = true;
    do {
      if (slices.took(1 / 4)) {
        await slices.pause();
      }
      isSound &&= areThere(lists, 3 * end);
      end += 1;
    } while (end < triangles && joined.array[end] === 1);
    if (!isSound) {
      leftOut.add('face');
      corners.array.fill(NOT_THERE, 3 * first, 3 * end);
    }
    for (; isSound && refers && first < end; first += 1) {
      if (slices.took(1 / 4)) {
        await slices.pause();
      }
      settle(lists, 3 * first, misses);
    }
    leftOut.add('uv', misses.uv);
    leftOut.add('normal', misses.normal);
    misses.uv = misses.normal = 0;
    first = end;
  }
}

/** Whether the corners of the triangle at corner `at` have vertices. */
function areThere({ corners, places }: CornerLists, at: number): boolean {
  const { array } = corners;
  return places.has(array[at]!) && places.has(array[at + 1]!) && places.has(array[at + 2]!);
}

/** @param misses becomes 1 for what the triangle at corner `at` refers to, and is not there. */
function settle(lists: CornerLists, at: number, misses: { uv: number; normal: number }) {
  const { cornerUvs, cornerNormals, uvs, normals } = lists;
  for (let corner = at; corner < at + 3; corner += 1) {
    if (itemAt(cornerUvs, corner) >= uvs.length / 2) {
      cornerUvs.array[corner] = NONE;
      misses.uv = 1;
    }
    const normal = itemAt(cornerNormals, corner);
    if (normal === NONE) continue;
    const isThere = normal < normals.length / 3;
    if (!isThere) {
      misses.normal = 1;
    }
    if (!isThere || isZero(normals.array, 3 * normal)) {
      cornerNormals.array[corner] = NONE;
    }
  }
  if (normals.length === 0 || !isTurned(lists, at)) return;
  const { array } = lists.corners;
  [array[at + 1], array[at + 2]] = [array[at + 2]!, array[at + 1]!];
  for (const list of [cornerUvs, cornerNormals]) {
    const [second, third] = [itemAt(list, at + 1), itemAt(list, at + 2)];
    setItem(list, at + 1, third);
    setItem(list, at + 2, second);
  }
}

const face: FaceVector = { x: 0, y: 0, z: 0 };

/**
 * Whether the normals of its corners point away from the side where the corners run
 * counter-clockwise.
 */
function isTurned({ corners, cornerNormals, normals, places }: CornerLists, at: number): boolean {
  const { array } = corners;
  faceVector(places.array, 3 * array[at]!, 3 * array[at + 1]!, 3 * array[at + 2]!, face);
  let along = 0;
  for (let corner = at; corner < at + 3; corner += 1) {
    const normal = 3 * itemAt(cornerNormals, corner);
    if (normal < 0) continue;
    along += face.x * normals.array[normal]!;
    along += face.y * normals.array[normal + 1]!;
    along += face.z * normals.array[normal + 2]!;
  }
  return along < 0;
}
