// In which order are a scene's objects drawn?
import { Mesh, Scene } from 'three';
import { expect, it } from 'vitest';
import { SceneTree } from '../../src/scene/scene-tree.js';
import { meshHost, meshOf } from './scene-host.js';

it('draws meshes in document order, whenever added or changed, and own objects last, but none that is removed', () => {
  const tree = new SceneTree(new Scene());
  const host = meshHost();
  const meshes = ['0', '1', '2'].map((name) => {
    const one = meshOf(host, tree.scene, { geometry: 'box', name });
    tree.add(one.mesh);
    return one;
  });
  const [first, second, third] = meshes.map(({ mesh }) => mesh);
  const own = new Mesh();
  own.name = 'own';
  tree.scene.children.unshift(own);
  own.parent = tree.scene;
  const names = (): string => {
    tree.update();
    return tree.scene.children.map(({ name }) => name).join(' ');
  };
  expect(names()).toBe('0 1 2 own');
  tree.arrange([third!, first!]); // 1 is no child, as a viewer's own mesh
  expect(names()).toBe('1 2 0 own');
  meshes[2]!.set({ geometry: 'sphere' });
  expect(names()).toBe('1 2 0 own');
  tree.remove(third!);
  expect(names()).toBe('1 0 own');
  tree.scene.remove(second!.root!);
  expect(names()).toBe('0 own');
});
