// Can a mesh's back faces be seen? Where they cannot, they are culled: half of a closed shape's fragments. Decided for each
// draw, so that moving into a shape compiles nothing. Knows neither materials nor programs.
import type { BufferGeometry, Camera, Matrix4 } from 'three';

/**
 * Which sides a surface has. `closed`: an opaque shape without holes, whose inside is seen only from inside. `single`: back
 * faces are never drawn (glTF's `doubleSided: false`). `double`: both sides are drawn.
 */
export type Sides = 'closed' | 'single' | 'double';

/** Determinants below this share of the column lengths' product are 0 but for rounding: the mesh is flattened. */
const FLATTENED = 1e-9;

/** Whether back faces are culled. Never on a flattened mesh: its two sides coincide. `matrixWorld` and camera are up to date. */
export function cullsBackFaces(
  sides: Sides,
  geometry: BufferGeometry,
  matrixWorld: Matrix4,
  camera: Camera,
): boolean {
  if (sides === 'double' || isFlattened(matrixWorld)) return false;
  return sides === 'single' || isOutside(geometry, matrixWorld, camera);
}

function isFlattened({ elements: e }: Matrix4): boolean {
  const [a, b, c, d, f, g, h, i, j] = [e[0], e[1], e[2], e[4], e[5], e[6], e[8], e[9], e[10]];
  const determinant = a * (f * j - g * i) - d * (b * j - c * i) + h * (b * g - c * f);
  const lengths = (a * a + b * b + c * c) * (d * d + f * f + g * g) * (h * h + i * i + j * j);
  return !(determinant * determinant > FLATTENED * FLATTENED * lengths);
}

/** Whether the eye and the whole near plane are outside the geometry's bounds: its sphere, or else its box. */
function isOutside(geometry: BufferGeometry, matrixWorld: Matrix4, camera: Camera): boolean {
  const { elements: view } = camera.matrixWorld;
  const reach = nearReach(camera);
  if (geometry.boundingBox === null) geometry.computeBoundingBox();
  const box = geometry.boundingBox;
  if (box === null || box.isEmpty()) return false;
  const { elements: m } = matrixWorld;
  const [x, y, z] = [view[12], view[13], view[14]];
  // The box's centre and half its size along each axis of its own, in world space.
  const cx = (box.min.x + box.max.x) / 2;
  const cy = (box.min.y + box.max.y) / 2;
  const cz = (box.min.z + box.max.z) / 2;
  const dx = x - (m[0] * cx + m[4] * cy + m[8] * cz + m[12]);
  const dy = y - (m[1] * cx + m[5] * cy + m[9] * cz + m[13]);
  const dz = z - (m[2] * cx + m[6] * cy + m[10] * cz + m[14]);
  const hx = (box.max.x - box.min.x) / 2;
  const hy = (box.max.y - box.min.y) / 2;
  const hz = (box.max.z - box.min.z) / 2;
  // Outside along one of the box's face normals: its axes are the columns of the matrix, sheared or not.
  return (
    isBeyond(m, 4, 8, 0, hx, dx, dy, dz, reach) ||
    isBeyond(m, 8, 0, 4, hy, dx, dy, dz, reach) ||
    isBeyond(m, 0, 4, 8, hz, dx, dy, dz, reach)
  );
}

/** Whether d, from the box's centre, is farther than `half` of the axis at `axis` plus `reach`, along the normal of the columns at `u` and `v`. */
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

/** Distance of the eye from the farthest corner of the near plane, from the projection: perspective or orthographic. */
function nearReach({ projectionMatrix: { elements: p } }: Camera): number {
  const isPerspective = p[11] !== 0;
  const near = isPerspective ? p[14] / (p[10] - 1) : (p[14] + 1) / p[10];
  const scale = isPerspective ? near : 1;
  const x = (scale * (1 + Math.abs(isPerspective ? p[8] : p[12]))) / p[0];
  const y = (scale * (1 + Math.abs(isPerspective ? p[9] : p[13]))) / p[5];
  return Math.sqrt(near * near + x * x + y * y);
}
