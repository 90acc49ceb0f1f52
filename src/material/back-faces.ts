// Which back faces are never seen, and so need not be drawn?
import { type BufferGeometry, type Camera, type Matrix4, Vector3 } from 'three';

/**
 * `closed`: the front faces enclose a volume, so that back faces are hidden unless the eye is inside. `single`: only front
 * faces are to be seen. `double`: both sides are.
 */
export type Sides = 'closed' | 'single' | 'double';

/** Whether a mesh's back faces are left out. A matrix with determinant 0 has no back faces to tell from front ones. */
export function cullsBackFaces(
  sides: Sides,
  geometry: BufferGeometry,
  matrixWorld: Matrix4,
  camera: Camera,
): boolean {
  if (sides === 'double' || matrixWorld.determinant() === 0) return false;
  if (sides === 'single') return true;
  if (geometry.boundingBox === null) geometry.computeBoundingBox();
  if (geometry.boundingBox === null) return false;
  const box = geometry.boundingBox.clone().applyMatrix4(matrixWorld);
  const eye = corner.setFromMatrixPosition(camera.matrixWorld);
  if (box.containsPoint(eye)) return false;
  for (const x of [-1, 1]) {
    for (const y of [-1, 1]) {
      corner.set(x, y, -1).applyMatrix4(camera.projectionMatrixInverse).applyMatrix4(camera.matrixWorld);
      if (box.containsPoint(corner)) return false;
    }
  }
  return true;
}

const corner = /* @__PURE__ */ new Vector3();
