// Which way does a normal map's u run at each vertex? The file's tangents, or ones computed from its texture coordinates (Lengyel,
// "Computing Tangent Space Basis Vectors for an Arbitrary Mesh", as three.js does it). Knows no materials.
import { BufferAttribute, BufferGeometry } from 'three';
import type { Attribute } from './attributes.js';

/**
 * Adds the attribute `tangent` to `geometry`: unit vectors with w ±1, or zero where there is no direction, which leaves
 * the normal as it is. `source` is the file's geometry, `uv` the map's texture coordinates in `geometry`.
 */
export function addTangents(geometry: BufferGeometry, source: BufferGeometry, uv: string): void {
  const given = source.hasAttribute('tangent') && source.hasAttribute('normal');
  const tangents = given ? source.getAttribute('tangent') : computed(geometry, uv);
  geometry.setAttribute('tangent', unitTangents(tangents));
}

function computed(geometry: BufferGeometry, uv: string): Attribute {
  const bare = new BufferGeometry();
  bare.setAttribute('position', geometry.getAttribute('position'));
  bare.setAttribute('normal', geometry.getAttribute('normal'));
  bare.setAttribute('uv', geometry.getAttribute(uv));
  const { count } = geometry.getAttribute('position');
  bare.setIndex(
    geometry.index ??
      new BufferAttribute(
        Uint32Array.from({ length: count }, (_, i) => i),
        1,
      ),
  );
  bare.computeTangents();
  return bare.getAttribute('tangent');
}

function unitTangents(source: Attribute): BufferAttribute {
  const values = new Float32Array(source.count * 4);
  for (let i = 0; i < source.count; i += 1) {
    const [x, y, z] = [source.getX(i), source.getY(i), source.getZ(i)];
    const length = Math.hypot(x, y, z);
    const scale = length > 0 && length < Infinity ? 1 / length : 0;
    values.set([x * scale || 0, y * scale || 0, z * scale || 0, source.getW(i) < 0 ? -1 : 1], i * 4);
  }
  return new BufferAttribute(values, 4);
}
