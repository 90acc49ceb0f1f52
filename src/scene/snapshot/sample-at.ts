// A geometry's texture and vertex values at a point of a triangle. Interpolated in float64.
import type { BufferGeometry, Texture } from 'three';
import type { Vec4 } from '../../math/vector.js';
import type { TriangleHit } from './ray-triangles.js';
import { sample } from './sample.js';
import { texelsOf } from './texels.js';

/** A texture at the hit, through its own coordinates and transform. */
export function sampleAt(texture: Texture, geometry: BufferGeometry, hit: TriangleHit): Vec4 {
  const { channel, matrix } = texture;
  const [u = 0, v = 0] = interpolated(geometry, channel === 0 ? 'uv' : `uv${String(channel)}`, hit);
  const m = matrix.elements;
  return sample(texelsOf(texture), texture, m[0] * u + m[3] * v + m[6], m[1] * u + m[4] * v + m[7]);
}

/** A vertex attribute at the hit; empty if the geometry lacks it. */
export function interpolated(
  geometry: BufferGeometry,
  name: string,
  { corners, weights }: TriangleHit,
): number[] {
  if (!geometry.hasAttribute(name)) return [];
  const attribute = geometry.getAttribute(name);
  return Array.from({ length: attribute.itemSize }, (_, c) =>
    corners.reduce((sum, corner, k) => sum + weights[k]! * attribute.getComponent(corner, c), 0),
  );
}
