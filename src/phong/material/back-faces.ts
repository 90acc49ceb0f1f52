// Decides whether a mesh's back faces can be seen. Where they cannot, they are culled: half of a
// closed shape's fragments. Decided for each draw, so that moving into a shape compiles nothing.
import { type BufferGeometry, type Camera, type Matrix4, Vector3 } from 'three';

/**
 * Which sides a surface has. `closed`: an opaque shape without holes, whose inside is seen only
 * from inside. `single`: back faces are never drawn (glTF's `doubleSided: false`). `double`: both
 * sides are drawn.
 */
export type Sides = 'closed' | 'single' | 'double';

/**
 * Determinants below this share of the column lengths' product are 0 up to rounding: the mesh is
 * flattened.
 */
const FLATTENED = 1e-9;

/**
 * Whether back faces are culled. Never on a flattened mesh: its two sides coincide. `matrixWorld`
 * and the camera must be up to date.
 */
export function cullsBackFaces(
  sides: Sides,
  geometry: BufferGeometry,
  matrixWorld: Matrix4,
  camera: Camera,
): boolean {
  if (sides === 'double' || isFlattened(matrixWorld)) return false;
  return sides === 'single' || isOutside(geometry, matrixWorld, camera);
}

function isFlattened(matrix: Matrix4): boolean {
  const { elements } = matrix;
  const determinant = matrix.determinant();
  const lengths = squared(elements, 0) * squared(elements, 4) * squared(elements, 8);
  return !(determinant * determinant > FLATTENED * FLATTENED * lengths);
}

/** The squared length of the column that begins at this element. */
const squared = (e: readonly number[], at: number): number =>
  e[at]! * e[at]! + e[at + 1]! * e[at + 1]! + e[at + 2]! * e[at + 2]!;

/** Scratch of {@link isOutside}. */
const middle = /* @__PURE__ */ new Vector3();

/** Whether the eye and the near plane are outside the geometry's bounds. */
function isOutside(geometry: BufferGeometry, matrixWorld: Matrix4, camera: Camera): boolean {
  if (geometry.boundingBox === null) {
    geometry.computeBoundingBox();
  }
  if (geometry.boundingSphere === null) {
    geometry.computeBoundingSphere();
  }
  const { boundingBox: box, boundingSphere: sphere } = geometry;
  if (box === null || sphere === null || box.isEmpty()) return false;
  const { elements: m } = matrixWorld;
  const { elements: view } = camera.matrixWorld;
  const [backX, backY, backZ] = [view[8], view[9], view[10]];
  // From the box's centre to the eye, in world space.
  const { x, y, z } = box.getCenter(middle);
  const dx = view[12] - (m[0] * x + m[4] * y + m[8] * z + m[12]);
  const dy = view[13] - (m[1] * x + m[5] * y + m[9] * z + m[13]);
  const dz = view[14] - (m[2] * x + m[6] * y + m[10] * z + m[14]);
  // Half the bounds' depth along the view: the moved sphere is an ellipsoid, the moved box a
  // parallelepiped.
  const along = (column: number): number =>
    m[column]! * backX + m[column + 1]! * backY + m[column + 2]! * backZ;
  const [ax, ay, az] = [along(0), along(4), along(8)];
  const hx = (box.max.x - box.min.x) / 2;
  const hy = (box.max.y - box.min.y) / 2;
  const hz = (box.max.z - box.min.z) / 2;
  const offset = middle.distanceTo(sphere.center); // three.js's own have none
  const sphereDepth = (sphere.radius + offset) * Math.sqrt(ax * ax + ay * ay + az * az);
  const boxDepth = hx * Math.abs(ax) + hy * Math.abs(ay) + hz * Math.abs(az);
  const depth = dx * backX + dy * backY + dz * backZ;
  if (depth - Math.min(sphereDepth, boxDepth) > nearOf(camera)) return true;
  // Beside or behind the eye: the near plane's corners are within `reach`, and the box's face
  // normals separate it.
  const reach = nearReach(camera);
  return (
    isBeyond(m, 4, 8, 0, hx, dx, dy, dz, reach) ||
    isBeyond(m, 8, 0, 4, hy, dx, dy, dz, reach) ||
    isBeyond(m, 0, 4, 8, hz, dx, dy, dz, reach)
  );
}

/**
 * Whether d is longer than `half` of the column at `axis`, plus `reach`, along the normal of
 * columns `u` and `v`.
 */
function isBeyond(
  m: ArrayLike<number>,
  u: number,
  v: number,
  axis: number,
  half: number,
  dx: number,
  dy: number,
  dz: number,
  reach: number,
): boolean {
  const nx = m[u + 1]! * m[v + 2]! - m[u + 2]! * m[v + 1]!;
  const ny = m[u + 2]! * m[v]! - m[u]! * m[v + 2]!;
  const nz = m[u]! * m[v + 1]! - m[u + 1]! * m[v]!;
  const length = Math.sqrt(nx * nx + ny * ny + nz * nz);
  const extent = half * Math.abs(nx * m[axis]! + ny * m[axis + 1]! + nz * m[axis + 2]!);
  return Math.abs(nx * dx + ny * dy + nz * dz) > extent + reach * length;
}

/** Distance of the near plane, from the projection. A multiple of a projection is the same one. */
function nearOf({ projectionMatrix }: Camera): number {
  const p = projectionMatrix.elements;
  return (p[14] + p[15]) / (p[10] + p[11]);
}

/** Distance of the eye from the farthest corner of the near plane. */
function nearReach(camera: Camera): number {
  const p = camera.projectionMatrix.elements;
  const near = nearOf(camera);
  const w = p[15] - p[11] * near;
  const x = (w + Math.abs(p[8] * near - p[12])) / p[0];
  const y = (w + Math.abs(p[9] * near - p[13])) / p[5];
  return Math.sqrt(near * near + x * x + y * y);
}
