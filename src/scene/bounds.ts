// How large a scene is: the box of all its vertices in world space and the farthest of them from a point, in float64.
// Knows nothing of cameras.
import { type Mesh, type Object3D, Vector3 } from 'three';
import type { Vec3 } from '../math/vector.js';

/** Box and vertices of what a scene shows; `empty` where it shows nothing. */
export interface Extent {
  readonly empty: boolean;
  readonly center: Vec3;
  /** Distance of the farthest vertex from a point. */
  radiusAbout(point: Vec3): number;
}

export const NO_EXTENT: Extent = { empty: true, center: [0, 0, 0], radiusAbout: () => 0 };

/** Measures every visible mesh below `root`. World matrices must be up to date. */
export function measure(root: Object3D): Extent {
  const meshes: Mesh[] = [];
  root.traverseVisible((object) => {
    // By its mark, not its class: another copy of three.js may have made it.
    const mesh = object as Partial<Mesh>;
    if (mesh.isMesh && mesh.geometry && 'position' in mesh.geometry.attributes) meshes.push(object as Mesh);
  });
  const low: [number, number, number] = [Infinity, Infinity, Infinity];
  const high: [number, number, number] = [-Infinity, -Infinity, -Infinity];
  for (const mesh of meshes) {
    forEachVertex(mesh, ({ x, y, z }) => {
      low[0] = Math.min(low[0], x);
      low[1] = Math.min(low[1], y);
      low[2] = Math.min(low[2], z);
      high[0] = Math.max(high[0], x);
      high[1] = Math.max(high[1], y);
      high[2] = Math.max(high[2], z);
    });
  }
  if (!(low[0] <= high[0])) return NO_EXTENT;
  const middle = (i: 0 | 1 | 2): number => low[i] + (high[i] - low[i]) / 2;
  return {
    empty: false,
    center: [middle(0), middle(1), middle(2)],
    radiusAbout(point) {
      let farthest = 0;
      for (const mesh of meshes) {
        forEachVertex(mesh, ({ x, y, z }) => {
          const [dx, dy, dz] = [x - point[0], y - point[1], z - point[2]];
          farthest = Math.max(farthest, dx * dx + dy * dy + dz * dz); // finite: coordinates are below 1e30
        });
      }
      return Math.sqrt(farthest);
    },
  };
}

const vertex = new Vector3();

function forEachVertex(mesh: Mesh, visit: (place: Vector3) => void): void {
  const positions = mesh.geometry.getAttribute('position');
  for (let i = 0; i < positions.count; i++)
    visit(vertex.fromBufferAttribute(positions, i).applyMatrix4(mesh.matrixWorld));
}
