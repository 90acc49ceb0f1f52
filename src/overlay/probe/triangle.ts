// The corners of the triangle that a fragment belongs to. World space, as drawn now.
import type { FragmentExplanation } from '../../element/explanation.js';
import type { Vec3 } from '../../math/vector.js';

/** Three places; empty if the object's geometry has changed. */
export function trianglePlaces({ object, triangle }: FragmentExplanation): Vec3[] {
  const { geometry, matrixWorld } = object;
  const { index } = geometry;
  const position = geometry.getAttribute('position');
  if (3 * triangle + 2 >= (index ?? position).count) return [];
  const e = matrixWorld.elements;
  return [0, 1, 2].map((corner): Vec3 => {
    const vertex = index === null ? 3 * triangle + corner : index.getX(3 * triangle + corner);
    const [x, y, z] = [position.getX(vertex), position.getY(vertex), position.getZ(vertex)];
    const along = (row: 0 | 1 | 2): number => e[row] * x + e[4 + row]! * y + e[8 + row]! * z + e[12 + row]!;
    return [along(0), along(1), along(2)];
  });
}
