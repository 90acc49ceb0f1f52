// The objects of a scene, their order, and where they are. Meshes come first, in document order: where surfaces
// coincide, the last one drawn shows. Then the page author's own objects.
import type { Object3D, Scene } from 'three';
import type { SceneMesh } from './mesh/scene-mesh.js';

export class SceneTree {
  readonly scene: Scene;
  readonly #meshes = new Set<SceneMesh>();

  constructor(scene: Scene) {
    this.scene = scene;
  }

  /** In drawing order. */
  get meshes(): ReadonlySet<SceneMesh> {
    return this.#meshes;
  }

  add(mesh: SceneMesh): void {
    this.#meshes.add(mesh);
    mesh.attach(this.scene);
  }

  remove(mesh: SceneMesh): void {
    this.#meshes.delete(mesh);
    mesh.dispose();
  }

  /** Meshes that are not in `ordered` come first, in the order in which they were added. */
  arrange(ordered: readonly SceneMesh[]): void {
    for (const mesh of ordered) {
      if (this.#meshes.delete(mesh)) this.#meshes.add(mesh);
    }
  }

  /**
   * Updates order and world matrices before drawing or measuring. A mesh that has not moved costs one call. A user's
   * objects are computed again each time, as three.js does.
   */
  update(): void {
    const { children } = this.scene;
    let own = 0;
    for (const { root } of this.#meshes) {
      if (root?.parent !== this.scene) continue; // the page may have put it into an object of its own
      if (children[own] !== root) this.#sort();
      own += 1;
    }
    for (let i = 0; i < children.length; i++) children[i]!.updateMatrixWorld(i >= own);
  }

  #sort(): void {
    const ranks = new Map<Object3D, number>();
    for (const { root } of this.#meshes) if (root !== null) ranks.set(root, ranks.size);
    const rank = (object: Object3D): number => ranks.get(object) ?? ranks.size;
    this.scene.children.sort((a, b) => rank(a) - rank(b));
  }
}
