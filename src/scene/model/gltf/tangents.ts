// Which way does a normal map's u run at each vertex? The file's tangents, or ones computed from its texture coordinates (Lengyel,
// "Computing Tangent Space Basis Vectors for an Arbitrary Mesh", as three.js does it). Knows no materials.
import { BufferAttribute, BufferGeometry } from 'three';
import type { Slices } from '../slices.js';
import type { Attribute, Conversion } from './attributes.js';

/** The file's tangents: unit vectors with w ±1, or zero where there is no direction, which leaves the normal as it is. */
export const unitTangents: Conversion = async (source, slices) => {
  const values = new Float32Array(source.count * 4);
  await slices.over(source.count, (from, to) => {
    for (let i = from; i < to; i += 1) {
      const x = source.getX(i);
      const y = source.getY(i);
      const z = source.getZ(i);
      const length = Math.hypot(x, y, z);
      if (length > 0 && length < Infinity) {
        values[i * 4] = x / length;
        values[i * 4 + 1] = y / length;
        values[i * 4 + 2] = z / length;
      }
      values[i * 4 + 3] = source.getW(i) < 0 ? -1 : 1;
    }
  });
  return new BufferAttribute(values, 4);
};

/** Adds the attribute `tangent` to `geometry`, computed from its texture coordinates `uv`. */
export async function addTangents(geometry: BufferGeometry, uv: string, slices: Slices): Promise<void> {
  geometry.setAttribute('tangent', await unitTangents(computed(geometry, uv), slices));
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
