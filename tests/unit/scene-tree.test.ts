// In which order are a scene's objects drawn, and which world matrices are computed again?

import { Mesh, Scene } from 'three';
import { describe, expect, it } from 'vitest';
import { FieldStore } from '../../src/fields/field-store.js';
import { PhongLighting } from '../../src/material/lighting.js';
import { MESH_FIELDS, type MeshValues } from '../../src/scene/mesh/mesh-fields.js';
import { type MeshHost, SceneMesh } from '../../src/scene/mesh/scene-mesh.js';
import { SharedMaterials } from '../../src/scene/mesh/shared-materials.js';
import { Budget } from '../../src/model/budget.js';
import { Animations } from '../../src/scene/mesh/animation.js';
import { SceneTree } from '../../src/scene/scene-tree.js';

const quiet = (): void => undefined;

function setUp(count: number): { tree: SceneTree; meshes: SceneMesh[]; stores: FieldStore<MeshValues>[] } {
  const host: MeshHost = {
    ...{ materials: new SharedMaterials(new PhongLighting()), animations: new Animations() },
    budget: new Budget(),
    ...{ crossOrigin: null, mayLoad: true },
    ...{
      changed: quiet,
      reshaped: quiet,
      began: quiet,
      progress: quiet,
      ended: quiet,
      dropped: quiet,
      shown: () => false,
      removed: quiet,
    },
  };
  const tree = new SceneTree(new Scene());
  const stores = Array.from({ length: count }, () => new FieldStore(MESH_FIELDS));
  const meshes = stores.map((store, i) => {
    store.set('geometry', 'box');
    store.set('name', String(i));
    const mesh = new SceneMesh(store, host);
    tree.add(mesh);
    mesh.update();
    return mesh;
  });
  tree.update();
  return { tree, meshes, stores };
}

const names = ({ scene }: SceneTree): string => scene.children.map(({ name }) => name).join(' ');

describe('the scene', () => {
  it('contains one object for a mesh of one part', () => {
    const { tree, stores, meshes } = setUp(2);
    stores[1]!.set('position', [1, 2, 3]);
    stores[1]!.set('scale', [2, 0, 2]);
    meshes[1]!.update();
    tree.update();
    expect(tree.scene.children).toHaveLength(2);
    expect(tree.scene.children[1]).toMatchObject({ isMesh: true, name: '1' });
    expect(tree.scene.children[1]!.matrixWorld.elements).toEqual([
      2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 2, 0, 1, 2, 3, 1,
    ]);
  });

  it('draws meshes in document order, whenever they were added or changed, and own objects last', () => {
    const { tree, stores, meshes } = setUp(3);
    const own = new Mesh();
    own.name = 'own';
    tree.scene.children.unshift(own);
    own.parent = tree.scene;
    tree.update();
    expect(names(tree)).toBe('0 1 2 own');
    tree.arrange([meshes[2]!, meshes[0]!]); // 1 is no child, as a viewer's own mesh
    tree.update();
    expect(names(tree)).toBe('1 2 0 own');
    stores[2]!.set('geometry', 'sphere');
    meshes[2]!.update();
    tree.update();
    expect(names(tree)).toBe('1 2 0 own');
    tree.remove(meshes[2]!);
    tree.update();
    expect(names(tree)).toBe('1 0 own');
  });

  it('omits objects that the page has removed from it', () => {
    const { tree, meshes } = setUp(3);
    tree.scene.remove(meshes[1]!.root!);
    tree.update();
    expect(names(tree)).toBe('0 2');
  });
});
