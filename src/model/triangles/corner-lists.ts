// A file's triangles while they are read: each corner refers to lists of positions, texture coordinates and normals of
// their own, as OBJ writes them.
import { Growing, Positions } from './positions.js';

/** Smoothing group of a triangle about which the file says nothing. */
export const UNSTATED = -1;
/** Smoothing group of a triangle with its own normal. */
export const FACETED = 0;

/** No texture coordinates or no normal yet. */
export const NONE = -1;

export class CornerLists {
  readonly places = new Positions();
  /** r g b of each position, or empty. Encoded sRGB, 0 to 1. */
  readonly colors = new Growing(Float32Array);
  /** u v; the first row of an image is at v = 0, as in glTF. */
  readonly uvs = new Growing(Float32Array);
  /** x y z; unit length or zero. */
  readonly normals = new Growing(Float32Array);

  /** Number of the position of each corner; three corners are a triangle. */
  readonly corners = new Growing(Uint32Array);
  /** Number of the texture coordinates of each corner, or {@link NONE}. Shorter if the last corners have none. */
  readonly cornerUvs = new Growing(Int32Array);
  /** Number of the normal of each corner, or {@link NONE}. Shorter if the last corners have none. */
  readonly cornerNormals = new Growing(Int32Array);
  /** Smoothing group of each triangle: {@link UNSTATED} beyond the end, {@link FACETED}, or a number above 0. */
  readonly groups = new Growing(Int32Array);

  get triangles(): number {
    return this.corners.length / 3;
  }

  pushNormal(x: number, y: number, z: number): void {
    const length = Math.hypot(x, y, z);
    // Without a direction: only ambient light.
    const scale = length > 0 && length < Infinity ? 1 / length : 0;
    this.normals.push(scale === 0 ? 0 : x * scale);
    this.normals.push(scale === 0 ? 0 : y * scale);
    this.normals.push(scale === 0 ? 0 : z * scale);
  }
}

/** Sets an item of a list that may be shorter, filling it up with {@link NONE}. */
export function setItem(list: Growing<Int32Array>, index: number, value: number): void {
  if (value === NONE && list.length <= index) return;
  while (list.length < index) list.push(NONE);
  list.push(value);
}

/** The item at `index`, or {@link NONE} beyond the end. */
export const itemAt = (list: Growing<Int32Array>, index: number): number =>
  index < list.length ? (list.array[index] ?? NONE) : NONE;
