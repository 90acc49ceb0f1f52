// Base colour and opacity at a point of a triangle: the look's colour times its texture times its vertex colours, as in
// phong.frag.glsl, in float64.
import type { BufferGeometry } from 'three';
import type { BaseLook } from '../../material/base-look.js';
import { srgbDecode, srgbEncode } from '../../math/color.js';
import type { Vec3, Vec4 } from '../../math/vector.js';
import type { TriangleHit } from './ray-triangles.js';
import { interpolated, sampleAt } from './sample-at.js';

export interface BaseColor {
  /** Encoded sRGB, 0–1. */
  readonly color: Vec3;
  /** 0–1; 1 where the look does not blend. */
  readonly opacity: number;
  /** The alpha mask discards this fragment. */
  readonly discarded: boolean;
}

/** With `linear`, colours are decoded before they are multiplied, and the product is encoded again. */
export function baseColorAt(
  look: BaseLook,
  geometry: BufferGeometry,
  hit: TriangleHit,
  linear: boolean,
): BaseColor {
  const factors: Vec4[] = [[...look.baseColor, look.opacity]];
  if (look.map !== null) factors.push(sampleAt(look.map, geometry, hit));
  if (look.vertexColors) {
    const [r = 1, g = 1, b = 1, a = 1] = interpolated(geometry, 'color', hit);
    factors.push([r, g, b, a]);
  }
  const product = (channel: 0 | 1 | 2): number => {
    if (!linear) return factors.reduce((all, factor) => all * factor[channel], 1);
    return srgbEncode(factors.reduce((all, factor) => all * srgbDecode(factor[channel]), 1));
  };
  const alpha = factors.reduce((all, factor) => all * factor[3], 1);
  return {
    color: [product(0), product(1), product(2)],
    opacity: look.alphaMode === 'blend' ? alpha : 1,
    discarded: look.alphaMode === 'mask' && alpha < look.alphaCutoff,
  };
}
