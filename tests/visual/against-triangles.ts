// How far is a picture from its own triangles in float64? In 8-bit codes.
import type { Picture } from '../support/picture.js';
import type { Vec3 } from '../../src/math/vector.js';
import { around, CONE_EDGE, type Errors, outside } from './against-reference.js';
import type { DeclaredScene } from './ray-cast.js';
import { remembered } from './remembered.js';
import { castTriangles } from './triangle-cast.js';

/**
 * Farther than this from every edge of its triangle, in pixels, a pixel is of one sample: its corners lie within, also
 * where the edges are snapped to the coarsest grid that OpenGL ES allows, 1/16 of a pixel.
 */
const WHOLE = Math.SQRT1_2 + 1 / 16;

const hitsOf = remembered((scene, width: number, height: number, shading: string) =>
  castTriangles(scene, width, height, shading),
);

/** Of channels inside triangles. `snapped`: those more than a code off, which snapped vertices may explain. */
interface TriangleErrors extends Errors {
  snapped: number;
}

/**
 * Rasterisers move vertices to a grid of `1 / 2^subpixelBits` pixels, so what is interpolated is that of a point up to
 * half a step away on each axis. A channel more than a code off is held against the range of colours among which that
 * is.
 */
export function compareWithTriangles(
  picture: Picture,
  scene: DeclaredScene,
  shading: string,
  subpixelBits: number,
): TriangleErrors {
  const { width, height, data } = picture;
  const hits = hitsOf(scene, width, height, shading);
  const errors: TriangleErrors = { max: 0, at: '', compared: 0, exact: 0, snapped: 0 };
  const reach = 2 ** -subpixelBits / 2;
  hits.forEach((hit, i) => {
    const [x, y] = [i % width, Math.floor(i / width)];
    const isBorder = x === 0 || y === 0 || x === width - 1 || y === height - 1;
    if (isBorder || hit === null || hit.edge < WHOLE || hit.coneMargin < CONE_EDGE) return;
    for (let channel = 0; channel < 3; channel++) {
      const actual = data[4 * i + channel]!;
      let error = Math.abs(actual - code(hit.color, channel));
      errors.compared += 1;
      if (error === 0) errors.exact += 1;
      if (error > 1) {
        const near = around(reach, (dx, dy) => hit.beside(dx, dy));
        error = outside(
          actual,
          [...near, hit.color].map((color) => code(color, channel)),
        );
        errors.snapped += 1;
      }
      if (error > errors.max)
        errors.at = `pixel ${x}, ${y} channel ${channel}: ${actual} instead of ${255 * hit.color[channel]!}`;
      errors.max = Math.max(errors.max, error);
    }
  });
  return errors;
}

const code = (color: Vec3, channel: number): number => Math.round(color[channel]! * 255);
