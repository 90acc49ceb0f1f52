// Finds the lights that can reach a box, in shading space and float64, from the packed rows that
// the GLSL reads. Only a spot's cone keeps light out: attenuation never reaches 0. A culled light
// adds nothing to any point of the box.
import { floatOf, HEADER, ROWS } from './light-layout.js';
import type { PackedLights } from './pack-lights.js';
import { LIMIT_OPEN, NEAREST } from './precision.js';

/** Axis-aligned, in shading space: low x y z, high x y z. */
export type Box = readonly [number, number, number, number, number, number];

/**
 * Writes into `mask` 1 for each sent light that can reach the box, else 0. Returns how many can.
 */
export function cullLights(packed: Readonly<PackedLights>, box: Box, mask: Uint8Array): number {
  const { directional, point } = packed.counts;
  const firstSpot = directional + point;
  mask.fill(1, 0, packed.sent);
  let count = packed.sent;
  let row = HEADER.rows + directional * ROWS.directional.rows + point * ROWS.point.rows;
  for (let light = firstSpot; light < packed.sent; light++, row += ROWS.spot.rows) {
    if (cone.read(packed, row).reaches(box[0], box[1], box[2], box[3], box[4], box[5])) continue;
    mask[light] = 0;
    count -= 1;
  }
  return count;
}

/**
 * Largest angle in radians between the cone's edge on the GPU and here: 2e-6 measured on the worst
 * lawful driver (tests/stress), with a margin. Relative to the coordinates, it covers their
 * rounding to float32 too.
 */
const EDGE = 1e-5;

/** Times a box is halved where its bounding sphere is too large to decide: 64 parts at most. */
const HALVINGS = 6;

const PLACE = floatOf('spot', 'position');
const AXIS = floatOf('spot', 'axis');
const APERTURE = floatOf('spot', 'aperture');

/**
 * One spot's cone, read once and tested against many boxes. Before it is read it reaches
 * everything.
 */
export class Cone {
  #x = 0;
  #y = 0;
  #z = 0;
  /**
   * The axis as rounded to float32: up to 6e-8 too long or short, so only ratios to it are used.
   */
  #ax = 0;
  #ay = 0;
  #az = 0;
  #sin = 0;
  #cos = 1;
  #open = true;

  /** Reads the spot whose first row is `row`. */
  read({ data }: PackedLights, row: number): this {
    const place = row * 4 + PLACE;
    const axis = row * 4 + AXIS;
    this.#x = data[place]!;
    this.#y = data[place + 1]!;
    this.#z = data[place + 2]!;
    this.#ax = data[axis]!;
    this.#ay = data[axis + 1]!;
    this.#az = data[axis + 2]!;
    const limit = data[row * 4 + APERTURE]!;
    const half = Math.abs(limit); // sin² of half the aperture, or of half its complement to 180°
    this.#open = limit === LIMIT_OPEN;
    this.#sin = 2 * Math.sqrt(Math.max(half * (1 - half), 0));
    this.#cos = (limit < 0 ? -1 : 1) * (1 - 2 * half);
    return this;
  }

  /** Whether any point of the box may be inside. */
  reaches(
    x0: number,
    y0: number,
    z0: number,
    x1: number,
    y1: number,
    z1: number,
    halvings = HALVINGS,
  ): boolean {
    if (this.#open) return true;
    const sizeX = x1 - x0;
    const sizeY = y1 - y0;
    const sizeZ = z1 - z0;
    const x = x0 + sizeX / 2;
    const y = y0 + sizeY / 2;
    const z = z0 + sizeZ / 2;
    const radius = lengthOf(sizeX, sizeY, sizeZ) / 2;
    const outside = this.#distance(x, y, z) - this.#slack(x, y, z, radius);
    if (outside > radius) return false;
    if (halvings === 0 || outside <= 0) return true;
    const next = halvings - 1;
    if (sizeX >= sizeY && sizeX >= sizeZ) {
      return this.reaches(x0, y0, z0, x, y1, z1, next) || this.reaches(x, y0, z0, x1, y1, z1, next);
    }
    if (sizeY >= sizeZ) {
      return this.reaches(x0, y0, z0, x1, y, z1, next) || this.reaches(x0, y, z0, x1, y1, z1, next);
    }
    return this.reaches(x0, y0, z0, x1, y1, z, next) || this.reaches(x0, y0, z, x1, y1, z1, next);
  }

  /** Distance of a point from the cone; 0 or less inside. */
  #distance(x: number, y: number, z: number): number {
    const vx = x - this.#x;
    const vy = y - this.#y;
    const vz = z - this.#z;
    const along = vx * this.#ax + vy * this.#ay + vz * this.#az;
    const across = lengthOf(
      vy * this.#az - vz * this.#ay,
      vz * this.#ax - vx * this.#az,
      vx * this.#ay - vy * this.#ax,
    );
    const outside = across * this.#cos - along * this.#sin;
    // Beyond a right angle from the cone's side the nearest point is the apex.
    return outside > 0 && along * this.#cos + across * this.#sin < 0
      ? lengthOf(vx, vy, vz)
      : outside;
  }

  #slack(x: number, y: number, z: number, radius: number): number {
    const here = Math.abs(this.#x) + Math.abs(this.#y) + Math.abs(this.#z);
    const extent = here + Math.abs(x) + Math.abs(y) + Math.abs(z) + radius;
    return EDGE * extent + NEAREST; // that near the light there is no angle: every cone reaches
  }
}

/**
 * Euclidean length in half of Math.hypot's time: it runs for every spot in every frame that moves
 * it. It loses numbers below 1e-154, which do not matter beside NEAREST.
 */
const lengthOf = (x: number, y: number, z: number) => Math.sqrt(x * x + y * y + z * z);

const cone = /* @__PURE__ */ new Cone();
