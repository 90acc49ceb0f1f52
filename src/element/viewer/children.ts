// Which lights and meshes does a viewer have? Its slot says; this brings lighting and scene in step with it, however
// children come, go, move or are upgraded. Knows neither camera nor frames.
import type { LightSet } from '../../light/light-set.js';
import { LightState } from '../../light/light-state.js';
import { type MeshHost, SceneMesh } from '../../scene/mesh/scene-mesh.js';
import type { Viewport } from '../../scene/viewport.js';
import { PhongLight } from '../phong-light.js';
import { PhongMesh } from '../phong-mesh.js';

export interface ChildrenHost {
  readonly viewport: Viewport;
  readonly meshHost: MeshHost;
  /** The slot that shows children without a slot of their own; null before there is a shadow tree. */
  slot(): HTMLSlotElement | null;
  meshesChanged(): void;
}

/** What lights a viewer that declares no light. */
const headLight = (): LightState => new LightState({ space: 'camera', position: [0, 0, 1, 0] });

export class ViewerChildren {
  readonly #host: ChildrenHost;
  readonly #lightSet: LightSet;
  readonly #headLight = headLight();
  readonly #meshes = new Map<PhongMesh, SceneMesh>();
  readonly #listeners = new WeakMap<SceneMesh, () => void>();
  #lights: readonly PhongLight[] = Object.freeze([]);
  #elements: ReadonlyMap<LightState, PhongLight> = new Map();
  #meshList: readonly PhongMesh[] = Object.freeze([]);

  constructor(host: ChildrenHost, lightSet: LightSet) {
    this.#host = host;
    this.#lightSet = lightSet;
    lightSet.assign([this.#headLight]);
  }

  get lights(): readonly PhongLight[] {
    this.collect();
    return this.#lights;
  }

  get meshes(): readonly PhongMesh[] {
    this.collect();
    return this.#meshList;
  }

  get sceneMeshes(): Iterable<SceneMesh> {
    return this.#meshes.values();
  }

  /** The element of a light; null for the head-light. */
  lightOf(state: LightState): PhongLight | null {
    return this.#elements.get(state) ?? null;
  }

  elementOf(mesh: SceneMesh): PhongMesh | undefined {
    return [...this.#meshes].find(([, sceneMesh]) => sceneMesh === mesh)?.[0];
  }

  /** Looks at the slot. A child that is not upgraded yet is no light and no mesh until the slot changes again. */
  collect(): void {
    const children = this.#host.slot()?.assignedElements() ?? [];
    this.#collectLights(children.filter((child) => child instanceof PhongLight));
    this.#collectMeshes(children.filter((child) => child instanceof PhongMesh));
  }

  #collectLights(lights: readonly PhongLight[]): void {
    if (sameList(lights, this.#lights)) return;
    this.#lights = Object.freeze(lights);
    this.#elements = new Map(lights.map((light) => [light.state, light]));
    // A light set before its element was connected lies in its own properties until then.
    for (const light of lights) light.declared.upgrade();
    this.#lightSet.assign(lights.length === 0 ? [this.#headLight] : lights.map((light) => light.state));
  }

  #collectMeshes(meshes: readonly PhongMesh[]): void {
    if (sameList(meshes, this.#meshList)) return;
    this.#meshList = Object.freeze(meshes);
    const { viewport, meshHost } = this.#host;
    for (const [element, mesh] of this.#meshes) {
      if (meshes.includes(element)) continue;
      // Another viewer may have taken it over already, and listens now.
      element.state.unlisten(this.#listeners.get(mesh) ?? (() => undefined));
      viewport.remove(mesh);
      this.#meshes.delete(element);
    }
    for (const element of meshes) {
      if (this.#meshes.has(element)) continue;
      element.declared.upgrade();
      const mesh = new SceneMesh(element.state, meshHost);
      this.#meshes.set(element, mesh);
      viewport.add(mesh);
      mesh.update();
      const listener = (): void => {
        this.#written(mesh);
      };
      this.#listeners.set(mesh, listener);
      element.state.listen(listener);
    }
    viewport.arrange(meshes.flatMap((element) => this.#meshes.get(element) ?? []));
    this.#host.meshesChanged();
  }

  readonly #toUpdate = new Set<SceneMesh>();

  /** Several values written in one task make one update. */
  #written(mesh: SceneMesh): void {
    if (this.#toUpdate.size === 0) queueMicrotask(this.flush);
    this.#toUpdate.add(mesh);
  }

  /** Brings the meshes written to in step now, rather than at the end of the task. */
  readonly flush = (): void => {
    if (this.#toUpdate.size === 0) return;
    const meshes = [...this.#toUpdate];
    this.#toUpdate.clear();
    const present = new Set(this.#meshes.values());
    for (const mesh of meshes) if (present.has(mesh)) mesh.update();
    this.#host.meshesChanged();
  };
}

const sameList = (a: readonly unknown[], b: readonly unknown[]): boolean =>
  a.length === b.length && a.every((item, i) => item === b[i]);
