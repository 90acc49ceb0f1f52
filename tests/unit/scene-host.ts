// What a viewer is to its meshes, and meshes in it.
import type { Scene } from 'three';
import { FieldStore } from '../../src/fields/field-store.js';
import { PhongLighting } from '../../src/material/lighting.js';
import { Budget } from '../../src/model/budget.js';
import { Animations } from '../../src/scene/mesh/animation.js';
import { MESH_FIELDS, type MeshValues } from '../../src/scene/mesh/mesh-fields.js';
import { type MeshHost, SceneMesh } from '../../src/scene/mesh/scene-mesh.js';
import { SharedMaterials } from '../../src/scene/mesh/shared-materials.js';

const quiet = (): void => undefined;

/** A host that reports nothing but to `own`. */
export const meshHost = (own: Partial<MeshHost> = {}): MeshHost => ({
  picture: {
    materials: new SharedMaterials(new PhongLighting()),
    animations: new Animations(),
    budget: new Budget(),
    ...{ invalidate: quiet, reshaped: quiet, fit: { moved: quiet } },
  },
  ...{ crossOrigin: null, mayLoad: true, shown: () => false },
  ...{ began: quiet, progress: quiet, ended: quiet, dropped: quiet, removed: quiet },
  ...own,
});

/** A mesh with these values; `set` changes them. */
export function meshOf(host: MeshHost, scene: Scene, values: Partial<MeshValues> = {}) {
  const store = new FieldStore(MESH_FIELDS);
  const mesh = new SceneMesh(store, host);
  const set = (changed: Partial<MeshValues>): void => {
    for (const [key, value] of Object.entries(changed)) store.set(key as 'src', value);
    mesh.update();
  };
  mesh.attach(scene);
  set(values);
  return { mesh, set };
}
