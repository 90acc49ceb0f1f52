// Pixels and directions of a picture's rays. Pixels count from the top left corner, with fractions.
import { cosDegrees, sinDegrees } from '../../phong/math/angle.js';
import { add, dot, scale, subtract, type Vec3 } from '../../phong/math/vector.js';
import type { CastCamera } from './cast-scene.js';

export class Screen {
  readonly camera: CastCamera;
  readonly width: number;
  readonly height: number;
  readonly slopeX: number;
  readonly slopeY: number;

  constructor(camera: CastCamera, width: number, height: number) {
    this.camera = camera;
    this.width = width;
    this.height = height;
    this.slopeY = sinDegrees(camera.fov / 2) / cosDegrees(camera.fov / 2);
    this.slopeX = (this.slopeY * width) / height;
  }

  /** The direction of a pixel's ray, of length 1 along the view. */
  direction(x: number, y: number): Vec3 {
    const { right, up, back } = this.camera;
    const across = ((2 * x) / this.width - 1) * this.slopeX;
    const upward = (1 - (2 * y) / this.height) * this.slopeY;
    return subtract(add(scale(right, across), scale(up, upward)), back);
  }

  /** Where a place, as seen from the eye, is in the picture. */
  project(place: Vec3) {
    const { right, up, back } = this.camera;
    const depth = -dot(place, back);
    const x = ((dot(place, right) / (depth * this.slopeX) + 1) * this.width) / 2;
    const y = ((1 - dot(place, up) / (depth * this.slopeY)) * this.height) / 2;
    return { x, y, depth };
  }
}
