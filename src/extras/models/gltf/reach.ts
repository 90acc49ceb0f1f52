// Where the vertices of an animated model come to: a bounded number of them, the outermost, over
// the poses at its keys.
import { Box3, type BufferAttribute, type Matrix4, Vector3 } from 'three';
import { LIMITS } from '../../../phong/model/limits.js';
import type { ContentPart } from '../../../phong/model/model.js';
import type { Slices } from '../slices.js';
import { hasMovingVertices } from '../../../phong/geometry/geometry-size.js';

/** Steps of all poses that are read for one animation: 0.3 s. Of more keys some are left out. */
const WORK_LIMIT = 8 * LIMITS.pose;
/** Most keys that are read, whatever the model: nodes are moved too. */
const KEY_LIMIT = 1000;

/**
 * Times to read out of these, evenly spread where not all can be; first and last are among them.
 */
export function keysWithin(keys: readonly number[], work: number): readonly number[] {
  const most = Math.min(Math.max(Math.floor(WORK_LIMIT / work), 2), KEY_LIMIT);
  if (keys.length <= most) return keys;
  const step = (keys.length - 1) / (most - 1);
  return Array.from({ length: most }, (_, i) => keys[Math.round(i * step)]!);
}

/** Directions from the centre are told apart by a grid on each face of a cube: 2.8° at most. */
const CELLS = 32;

/** Keeps the farthest vertex in each direction, and those that the box ends at. */
export class Reach {
  readonly #center = new Vector3();
  #begun = false;
  /** Squared distances from the centre, and the vertices: of each cell. */
  readonly #farthest = new Float64Array(6 * CELLS * CELLS).fill(-1);
  readonly #points = new Float64Array(3 * this.#farthest.length);
  /** Of each axis the least and the largest coordinate, and the vertices. */
  readonly #ends = new Float64Array(6).fill(-Infinity);
  readonly #endPoints = new Float64Array(18);

  /** Adds the pose that the parts are in now. They may get another one while this waits. */
  async add(parts: readonly ContentPart[], slices: Slices): Promise<void> {
    const placed = parts.map(({ geometry, matrix }) => ({ geometry, matrix: matrix.clone() }));
    if (!this.#begun) {
      const box = new Box3();
      for (const { geometry, matrix } of placed) {
        if (geometry.boundingBox === null) {
          geometry.computeBoundingBox();
        }
        box.union(geometry.boundingBox!.clone().applyMatrix4(matrix));
      }
      box.getCenter(this.#center);
      this.#begun = true;
    }
    const [moving, still] = [true, false].map((moves) =>
      placed.filter(({ geometry }) => hasMovingVertices(geometry) === moves),
    );
    // Those that move are read at once: no more than a pose has.
    for (const { geometry, matrix } of moving!) {
      const position = geometry.getAttribute('position') as BufferAttribute;
      this.#read(position.array, matrix, 0, position.count);
    }
    for (const { geometry, matrix } of still!) {
      const { array, count } = geometry.getAttribute('position') as BufferAttribute;
      await slices.over(count, (from, to) => this.#read(array, matrix, from, to));
    }
    await slices.pauseIfDue();
  }

  /** The vertices that were kept: x, y and z of each. */
  get vertices(): Float64Array {
    const kept = Array.from(this.#farthest.keys()).filter((cell) => this.#farthest[cell]! >= 0);
    return Float64Array.from([
      ...(kept.length === 0 ? [] : this.#endPoints),
      ...kept.flatMap((cell) => Array.from(this.#points.subarray(3 * cell, 3 * cell + 3))),
    ]);
  }

  #read(positions: ArrayLike<number>, { elements: m }: Matrix4, from: number, to: number) {
    const { x: cx, y: cy, z: cz } = this.#center;
    for (let i = 3 * from; i < 3 * to; i += 3) {
      const [px, py, pz] = [positions[i]!, positions[i + 1]!, positions[i + 2]!];
      const x = m[0] * px + m[4] * py + m[8] * pz + m[12];
      const y = m[1] * px + m[5] * py + m[9] * pz + m[13];
      const z = m[2] * px + m[6] * py + m[10] * pz + m[14];
      const [dx, dy, dz] = [x - cx, y - cy, z - cz];
      const squared = dx * dx + dy * dy + dz * dz;
      if (!(squared < Infinity)) continue;
      this.#end(0, -x, x, y, z);
      this.#end(1, x, x, y, z);
      this.#end(2, -y, x, y, z);
      this.#end(3, y, x, y, z);
      this.#end(4, -z, x, y, z);
      this.#end(5, z, x, y, z);
      const cell = cellOf(dx, dy, dz);
      if (squared <= this.#farthest[cell]!) continue;
      this.#farthest[cell] = squared;
      this.#points[3 * cell] = x;
      this.#points[3 * cell + 1] = y;
      this.#points[3 * cell + 2] = z;
    }
  }

  #end(side: number, along: number, x: number, y: number, z: number) {
    if (along <= this.#ends[side]!) return;
    this.#ends[side] = along;
    this.#endPoints[3 * side] = x;
    this.#endPoints[3 * side + 1] = y;
    this.#endPoints[3 * side + 2] = z;
  }
}

function cellOf(x: number, y: number, z: number): number {
  const [ax, ay, az] = [Math.abs(x), Math.abs(y), Math.abs(z)];
  if (ax >= ay && ax >= az) return cellOn(x < 0 ? 0 : 1, y, z, ax);
  return ay >= az ? cellOn(y < 0 ? 2 : 3, x, z, ay) : cellOn(z < 0 ? 4 : 5, x, y, az);
}

function cellOn(face: number, u: number, v: number, along: number): number {
  // The centre itself has no direction.
  const at = (value: number) =>
    along > 0 ? Math.min(Math.floor(((value / along + 1) / 2) * CELLS), CELLS - 1) : 0;
  return (face * CELLS + at(u)) * CELLS + at(v);
}
