// What a viewer is to its meshes, and meshes in it.
import { BoxGeometry, Matrix4, type Scene } from 'three';
import { vi } from 'vitest';
import { PLAIN_LOOK } from '../../src/phong/material/file-surface.js';
import type { Content } from '../../src/phong/model/model.js';
import { FieldStore } from '../../src/phong/fields/field-store.js';
import { LightSet } from '../../src/phong/light/light-set.js';
import { MESH_FIELDS, type MeshValues } from '../../src/phong/model/mesh-fields.js';
import { type MeshHost, SceneMesh } from '../../src/viewer/scene/mesh/scene-mesh.js';
import { Picture } from '../../src/viewer/scene/picture.js';

const quiet = () => undefined;

/** A host that reports nothing but to `own`. */
export const meshHost = (
  own: Partial<MeshHost> = {},
): MeshHost & { readonly picture: Picture } => ({
  crossOrigin: null,
  mayLoad: true,
  shown: () => false,
  began: quiet,
  progress: quiet,
  ended: quiet,
  dropped: quiet,
  removed: quiet,
  ...own,
  picture: new Picture(new LightSet(), quiet, quiet),
});

/** A mesh with these values; `set` changes them. */
export function meshOf(host: MeshHost, scene: Scene, values: Partial<MeshValues> = {}) {
  const store = new FieldStore(MESH_FIELDS);
  const mesh = new SceneMesh(store, host);
  const set = (changed: Partial<MeshValues>): void => {
    for (const [key, value] of Object.entries(changed)) {
      store.set(key as 'src', value);
    }
    mesh.update();
  };
  mesh.attach(scene);
  set(values);
  return { mesh, set };
}

/** A content of as many parts, which look different. */
export const content = (parts: number) => ({
  parts: Array.from({ length: parts }, (_, i) => ({
    name: '',
    geometry: new BoxGeometry(),
    matrix: new Matrix4(),
    surface: {},
    sides: 'single' as const,
    look: { ...PLAIN_LOOK, opacity: 1 - i / parts },
  })),
  motion: null,
  dispose: vi.fn<Content['dispose']>(),
});
