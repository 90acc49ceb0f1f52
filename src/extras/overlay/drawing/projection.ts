// Projects points of the scene to the layer over the picture, and back, in float64. World space to
// CSS pixels.
import { basisOf, type Basis, type Pose } from '../../../phong/camera/orbit.js';
import type { ExtraHost, FragmentExplanation } from '../../../viewer/extra.js';
import { radians } from '../../../phong/math/angle.js';
import type { Size } from '../../../phong/math/region.js';
import {
  add,
  clamp,
  dot,
  normalize,
  scale,
  subtract,
  type Vec3,
} from '../../../phong/math/vector.js';

/** CSS pixels of the layer, right and down from its top left corner. */
export interface Point {
  readonly x: number;
  readonly y: number;
}

/** Steps to the right and down by the `KeyboardEvent.key` of an arrow; other keys have no entry. */
export const ARROWS: Readonly<Record<string, readonly [right: number, down: number]>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
};

/** `width` and `height`: CSS pixels of the layer, both above 0. */
interface Sight extends Size {
  readonly pose: Pose;
  /** Vertical field of view, degrees. */
  readonly fov: number;
  /**
   * Of the picture in device pixels, which rounding makes slightly different. Default: that of the
   * layer.
   */
  readonly aspect?: number;
}

export interface Ray {
  readonly origin: Vec3;
  /** Unit length. */
  readonly direction: Vec3;
}

/** CSS pixels of the layer over a picture; at least 1 by 1. */
export const layerSize = ({ width, height }: Size): Size => ({
  width: Math.max(width, 1),
  height: Math.max(height, 1),
});

/** Onto a layer of this size, of what `viewport` shows now. */
export function projectionOf(
  { picture: { orbit, fit }, width, height }: ExtraHost['viewport'],
  size: Size,
): Projection {
  const sight = { pose: orbit.pose, fov: fit.fov, ...size };
  // None before the first layout.
  return new Projection(width > 0 && height > 0 ? { ...sight, aspect: width / height } : sight);
}

/** Reports what is explained. `at`: where it is on the layer; null outside the picture. */
export function reportProbe(
  host: ExtraHost,
  fragment: FragmentExplanation | null,
  at: Point | null,
  pinned: boolean,
): void {
  const { zoom } = host.size();
  const detail = { fragment, x: at && at.x * zoom, y: at && at.y * zoom, pinned };
  host.viewer.dispatchEvent(new CustomEvent('probe-change', { detail }));
}

/**
 * Nearer to the eye than this share of the orbit's radius, places on the layer would overflow: they
 * count as behind.
 */
const NEAREST = 1e-4;

/**
 * Widths and heights outside the picture at which lines are cut. Far ends would make dashes slow to
 * draw.
 */
const OUTSIDE = 1;

export class Projection {
  readonly width: number;
  readonly height: number;
  readonly pose: Pose;
  readonly eye: Vec3;
  readonly basis: Basis;
  readonly #near: number;
  /** CSS pixels per unit of slope, to the right and upward. */
  readonly #scaleX: number;
  readonly #scaleY: number;

  constructor({ pose, fov, width, height, aspect = width / height }: Sight) {
    this.width = width;
    this.height = height;
    this.pose = pose;
    this.basis = basisOf(pose);
    this.eye = add(pose.target, scale(this.basis.back, pose.radius));
    this.#near = NEAREST * pose.radius;
    this.#scaleY = height / (2 * Math.tan(radians(fov) / 2));
    this.#scaleX = width / (2 * Math.tan(radians(fov) / 2) * aspect);
  }

  /** World place to camera space: x right, y up, z backward, from the eye. */
  toCamera(place: Vec3): Vec3 {
    return this.turnToCamera(subtract(place, this.eye));
  }

  toWorld(place: Vec3): Vec3 {
    return add(this.eye, this.turnToWorld(place));
  }

  turnToCamera(direction: Vec3): Vec3 {
    const { right, up, back } = this.basis;
    return [dot(direction, right), dot(direction, up), dot(direction, back)];
  }

  turnToWorld([x, y, z]: Vec3): Vec3 {
    const { right, up, back } = this.basis;
    return add(add(scale(right, x), scale(up, y)), scale(back, z));
  }

  /** Distance of a place in front of the eye, along the view direction. Negative behind the eye. */
  depthOf(place: Vec3): number {
    return -dot(subtract(place, this.eye), this.basis.back);
  }

  /** Null for places behind the eye and in its plane. May lie outside the layer. */
  point(place: Vec3): Point | null {
    const [x, y, z] = this.toCamera(place);
    return -z >= this.#near ? this.#onLayer(x, y, -z) : null;
  }

  /** Null outside the layer too. */
  pointInside(place: Vec3): Point | null {
    const point = this.point(place);
    return point !== null && isInside(point, this, 0) ? point : null;
  }

  /** The world place on the layer's point at this depth in front of the eye. */
  placeAt({ x, y }: Point, depth: number): Vec3 {
    const slopeX = (x - this.width / 2) / this.#scaleX;
    const slopeY = (this.height / 2 - y) / this.#scaleY;
    return this.toWorld([slopeX * depth, slopeY * depth, -depth]);
  }

  ray(point: Point): Ray {
    return { origin: this.eye, direction: normalize(subtract(this.placeAt(point, 1), this.eye)) };
  }

  /** CSS pixels that one scene unit at this depth covers. */
  pixelsPerUnit(depth: number): number {
    return this.#scaleY / Math.max(Math.abs(depth), this.#near);
  }

  /**
   * The part of a segment that is in front of the eye and not far outside the layer; null for none.
   */
  segment(from: Vec3, to: Vec3): readonly [Point, Point] | null {
    return this.#segment(this.toCamera(from), this.toCamera(to));
  }

  /** A line through these places, in as many pieces as {@link segment} leaves. */
  line(places: readonly Vec3[]): (readonly Point[])[] {
    const pieces: Point[][] = [];
    // Each place is turned to camera space once: that halves the time of the circles around lights.
    const turned = places.map((place) => this.toCamera(place));
    for (let i = 1; i < turned.length; i++) {
      const part = this.#segment(turned[i - 1]!, turned[i]!);
      if (part === null) continue;
      const [from, to] = part;
      const last = pieces.at(-1)?.at(-1);
      if (last !== undefined && last.x === from.x && last.y === from.y) {
        pieces.at(-1)!.push(to);
      } else {
        pieces.push([from, to]);
      }
    }
    return pieces;
  }

  /** In camera space. */
  #segment(a: Vec3, b: Vec3): readonly [Point, Point] | null {
    const [da, db] = [-a[2] - this.#near, -b[2] - this.#near];
    if (da < 0 && db < 0) return null;
    const from = da < 0 ? this.#cut(a, b, da / (da - db)) : a;
    const to = db < 0 ? this.#cut(a, b, da / (da - db)) : b;
    return this.#clipped(
      this.#onLayer(from[0], from[1], -from[2]),
      this.#onLayer(to[0], to[1], -to[2]),
    );
  }

  /**
   * The segment's end at the near plane. The depth is set, because the difference of large
   * coordinates would be lost to rounding.
   */
  #cut(a: Vec3, b: Vec3, share: number): Vec3 {
    const [x, y] = add(a, scale(subtract(b, a), share));
    return [x, y, -this.#near];
  }

  #onLayer(x: number, y: number, depth: number): Point {
    return {
      x: this.width / 2 + (this.#scaleX * x) / depth,
      y: this.height / 2 - (this.#scaleY * y) / depth,
    };
  }

  /** Liang and Barsky's clipping. */
  #clipped(a: Point, b: Point): readonly [Point, Point] | null {
    const [dx, dy] = [b.x - a.x, b.y - a.y];
    let [from, to] = [0, 1];
    const sides = [
      [-dx, a.x + OUTSIDE * this.width],
      [dx, (1 + OUTSIDE) * this.width - a.x],
      [-dy, a.y + OUTSIDE * this.height],
      [dy, (1 + OUTSIDE) * this.height - a.y],
    ] as const;
    for (const [step, room] of sides) {
      if (step === 0) {
        if (room < 0) return null;
      } else if (step < 0) {
        from = Math.max(from, room / step);
      } else {
        to = Math.min(to, room / step);
      }
    }
    if (!(from <= to)) return null;
    // Rounding moves an end that is far away by up to hundreds of pixels.
    const at = (share: number): Point => ({
      x: clamp(a.x + share * dx, -OUTSIDE * this.width, (1 + OUTSIDE) * this.width),
      y: clamp(a.y + share * dy, -OUTSIDE * this.height, (1 + OUTSIDE) * this.height),
    });
    return [from === 0 ? a : at(from), to === 1 ? b : at(to)];
  }
}

/**
 * The nearest point that is at least `margin` pixels inside the layer; the middle of a layer
 * smaller than that.
 */
export function inside(
  { x, y }: Point,
  { width, height }: { readonly width: number; readonly height: number },
  margin: number,
): Point {
  const within = (value: number, size: number) =>
    size <= 2 * margin ? size / 2 : clamp(value, margin, size - margin);
  return { x: within(x, width), y: within(y, height) };
}

/** At least `margin` pixels inside the layer, as {@link inside} has it. */
export function isInside(
  point: Point,
  layer: { readonly width: number; readonly height: number },
  margin: number,
): boolean {
  const { x, y } = inside(point, layer, margin);
  return x === point.x && y === point.y;
}
