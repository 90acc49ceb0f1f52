// A file's triangles while they are read: corners refer to lists of positions, uvs and normals, as
// OBJ writes them.
import { Matrix4, type TypedArray } from 'three';
import { requireAtMost } from '../../../phong/model/budget.js';
import { LIMITS } from '../../../phong/model/limits.js';
import { LIMITS as LIGHT_LIMITS } from '../../../phong/light/light-state.js';
import type { Slices } from '../slices.js';
import { free } from '../limits.js';

/** Smoothing group of a triangle about which the file says nothing. */
export const UNSTATED = -1;
/** Smoothing group of a triangle with its own normal. */
export const FACETED = 0;

/** No texture coordinates or no normal yet. */
export const NONE = -1;
/** A reference to something that no file can have. */
export const NOT_THERE = 0x7fffffff;

export class CornerLists {
  readonly places: Positions;
  /** r g b of each position, or empty. Encoded sRGB, 0 to 1 after {@link toFractions}. */
  readonly colors: Growing<Float32Array>;
  /** u v; the first row of an image is at v = 0, as in glTF. */
  readonly uvs = new Growing(Float32Array);
  /**
   * r g b of each face that has a colour, after a white one. Empty, or the colours of positions
   * are.
   */
  readonly faceColors: Growing<Float32Array>;
  /** x y z; unit length, or zero for one without a direction. */
  readonly normals: Growing<Float32Array>;

  /** Number of the position of each corner, or {@link NOT_THERE}; three corners are a triangle. */
  readonly corners: Growing<Uint32Array>;
  /**
   * Number of the texture coordinates of each corner, or {@link NONE}. Shorter if the last corners
   * have none.
   */
  readonly cornerUvs = new Growing(Int32Array, 0, 1);
  /**
   * Number of the normal of each corner, or {@link NONE}. Shorter if the last corners have none.
   */
  readonly cornerNormals: Growing<Int32Array>;
  /**
   * Smoothing group of each triangle: {@link UNSTATED} beyond the end, {@link FACETED}, or a number
   * above 0.
   */
  readonly groups = new Growing(Int32Array, 0, 3);
  /** Number of each triangle's colour among those of faces. Shorter if the last ones are white, 0. */
  readonly triangleColors: Growing<Int32Array>;
  /** The largest number of a position that a corner has. */
  highestVertex = -1;
  /** 1 for a triangle of the same face as the one before it. */
  readonly joined: Growing<Uint8Array>;

  /** @param vertices and `faces`: how many the file announces, having as many bytes at least. */
  constructor(vertices = 0, faces = 0) {
    this.places = new Positions(vertices);
    this.colors = new Growing(Float32Array, 3 * vertices, 1);
    this.normals = new Growing(Float32Array, 3 * vertices);
    this.faceColors = new Growing(Float32Array, 3 * (faces + 1));
    this.corners = new Growing(Uint32Array, 3 * faces);
    this.cornerNormals = new Growing(Int32Array, 3 * faces, 2);
    this.triangleColors = new Growing(Int32Array, faces);
    this.joined = new Growing(Uint8Array, faces);
  }

  /** Call when the geometries are made. */
  free(): void {
    for (const list of Object.values(this)) {
      if (list instanceof Growing) {
        free(list.array as Uint8Array);
      }
    }
    free(this.places.array);
  }

  /** Whether the vertices of all corners are there, and their coordinates numbers. */
  get areAllThere() {
    return this.places.areSound && this.highestVertex < this.places.count;
  }

  get triangles() {
    return this.corners.length / 3;
  }

  /** @throws ModelError `too-large` for too many triangles. Call before the corners of each. */
  beginTriangle(joined: boolean): void {
    requireAtMost(this.corners.length + 3, LIMITS.corners, 'triangle corners');
    this.joined.push(joined ? 1 : 0);
  }

  pushCorner(position: number, uv = NONE, normal = NONE): void {
    const corner = this.corners.length;
    this.corners.push(position);
    this.highestVertex = Math.max(this.highestVertex, position);
    setItem(this.cornerUvs, corner, uv);
    setItem(this.cornerNormals, corner, normal);
  }

  pushNormal(x: number, y: number, z: number): void {
    const length = Math.sqrt(x * x + y * y + z * z);
    const scale = length > 0 && length < Infinity ? 1 / length : 0;
    this.normals.push(scale === 0 ? 0 : x * scale);
    this.normals.push(scale === 0 ? 0 : y * scale);
    this.normals.push(scale === 0 ? 0 : z * scale);
  }
}

/** Sets an item of a list that may be shorter, filling it up with {@link NONE}. */
export function setItem(list: Growing<Int32Array>, index: number, value: number): void {
  if (index < list.length) {
    list.array[index] = value;
  }
  if (index < list.length || value === NONE) return;
  list.fillTo(index, NONE);
  list.push(value);
}

/** The item at `index`, or {@link NONE} beyond the end. */
export const itemAt = (list: Growing<Int32Array>, index: number) =>
  index < list.length ? (list.array[index] ?? NONE) : NONE;

/**
 * A first vertex farther out than this becomes the origin. Maps and plants have coordinates of 1e5
 * to 1e7 metres and details of centimetres; float32 keeps steps of 3 cm at 5e5.
 */
const FAR_OUT = 1024;

/** A file's vertex positions, as float32 relative to an origin that keeps their precision. */
export class Positions {
  readonly #values: Growing<Float32Array>;
  #origin: readonly [number, number, number] | null = null;
  /** Whether {@link push} has refused no vertex. */
  areSound = true;

  constructor(vertices = 0) {
    this.#values = new Growing(Float32Array, 3 * vertices);
  }

  get count() {
    return this.#values.length / 3;
  }

  /** x y z of each vertex, relative to the origin. Longer than the list. Replaced when it grows. */
  get array() {
    return this.#values.array;
  }

  /** From the origin to the file's coordinates. */
  get matrix() {
    return new Matrix4().makeTranslation(...(this.#origin ?? [0, 0, 0]));
  }

  /**
   * False for a coordinate that is no number or beyond ±1e15: all three become NaN.
   * @throws ModelError `too-large` for too many vertices, whether triangles use them or not.
   */
  push(x: number, y: number, z: number): boolean {
    const largest = Math.max(Math.abs(x), Math.abs(y), Math.abs(z));
    const sound = largest <= LIGHT_LIMITS.coordinate;
    if (sound) {
      this.#origin ??= largest > FAR_OUT ? [x, y, z] : [0, 0, 0];
    }
    this.areSound &&= sound;
    const values = this.#values;
    const [x0, y0, z0] = sound ? (this.#origin ?? NOWHERE) : NOWHERE;
    values.push(x - x0);
    values.push(y - y0);
    values.push(z - z0);
    return sound;
  }

  /** Whether there is such a vertex, and its coordinates are numbers. */
  has(vertex: number) {
    return vertex < this.count && !Number.isNaN(this.array[3 * vertex]);
  }

  /** Removes the vertices from `count` on. */
  cut(count: number): void {
    this.#values.length = 3 * count;
  }
}

const NOWHERE = [NaN, NaN, NaN] as const;

/** Why {@link Positions.push} refused a vertex, for messages. */
export function wrongCoordinate(x: number, y: number, z: number): string {
  const value = [x, y, z].find((coordinate) => !(Math.abs(coordinate) <= LIGHT_LIMITS.coordinate));
  return `a vertex has the coordinate ${String(value)}; ±1e15 is the limit`;
}

/** A channel of a colour that the file does not give: full in whatever range the others have. */
export const FULL = -1;

export function pushColor(
  colors: Growing<Float32Array>,
  ...channels: readonly [r: number, g: number, b: number]
): void {
  for (const value of channels) {
    colors.push(value > 0 ? value : 0);
  }
}

/** Floats above this are taken for bytes. A little more than 1 is rounding, or a bright colour. */
const MOST_FRACTION = 2;

/**
 * Full intensity of channels that were divided by `unit`, and of which this is the largest: what is
 * written above 1, of floats above 2, counts to 255, and above 255 to the unit.
 */
export function fullOf(most: number, unit = 1): number {
  const written = most * unit;
  if (written <= (unit === 1 ? MOST_FRACTION : 1.5)) return 1 / unit; // half a step for float32
  return written < 255.5 || unit === 1 ? 255 / unit : 1;
}

/** Colours as fractions, clamped to 0–1. */
export async function toFractions(
  colors: Growing<Float32Array>,
  slices: Slices,
  unit?: number,
): Promise<void> {
  const { array } = colors;
  let most = 0;
  await slices.over(colors.length, (from, to) => {
    for (let i = from; i < to; i += 1) {
      most = Math.max(most, array[i]!);
    }
  });
  const full = fullOf(most, unit);
  await slices.over(colors.length, (from, to) => {
    for (let i = from; i < to; i += 1) {
      array[i] = array[i] === FULL ? 1 : Math.min(array[i]! / full, 1);
    }
  });
}

const FIRST_LENGTH = 1024;
/** Longest list: 11 million vertices, 3.7 million STL triangles. Moving half of it takes 30 ms. */
const LONGEST = 2 ** 25;

/**
 * A list of numbers of unknown length: a typed array, doubled when it is full. What is not written
 * takes no memory.
 */
export class Growing<A extends TypedArray> {
  readonly #make: new (length: number) => A;
  readonly #first: number;
  /** Valid up to {@link length}. Replaced when it grows: do not keep it. */
  array: A;
  length = 0;

  /**
   * @param capacity the length that it will probably have.
   * @param lane lists that are written together have different ones: they are not moved in the same
   * task.
   */
  constructor(make: new (length: number) => A, capacity = 0, lane = 0) {
    this.#make = make;
    this.#first = Math.max(capacity, FIRST_LENGTH + 128 * lane);
    this.array = new make(0);
  }

  push(value: number): void {
    if (this.length === this.array.length) {
      this.#grow(this.length + 1);
    }
    this.array[this.length] = value;
    this.length += 1;
  }

  /** Makes the list at least that long, by items of this value. */
  fillTo(length: number, value: number): void {
    if (length > this.array.length) {
      this.#grow(length);
    }
    this.array.fill(value, this.length, length);
    this.length = Math.max(this.length, length);
  }

  /** @throws ModelError `too-large` past {@link LONGEST}. */
  #grow(least: number) {
    requireAtMost(least, LONGEST, 'numbers in one list');
    const wanted = Math.max(least, this.array.length * 2, this.#first);
    const larger = new this.#make(Math.min(wanted, LONGEST));
    larger.set(this.array);
    this.array = larger;
  }
}
