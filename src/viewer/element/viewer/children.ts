// The lights and meshes of a viewer: in effect when they register, in document order before the
// next frame or reading.
import { sameValue } from '../../../phong/fields/field-store.js';
import { LightState } from '../../../phong/light/light-state.js';
import { type MeshHost, SceneMesh } from '../../scene/mesh/scene-mesh.js';
import { register } from '../child-element.js';
import { type ChildRegistry, registryOf } from '../child-registry.js';
import { inspect } from '../inspect.js';
import { fieldsOf, sceneMeshes } from '../internals.js';
import type { PhongLight, PhongMesh } from '../elements.js';
import type { ViewerContext } from './viewer-context.js';

export class ViewerChildren {
  readonly #viewer: HTMLElement;
  readonly #context: ViewerContext;
  readonly #meshHost: MeshHost;
  readonly #registry: ChildRegistry;
  /** Lights a viewer that declares no light. */
  readonly #headLight = new LightState({ space: 'camera', position: [0, 0, 1, 0] });
  readonly #shown = new Map<PhongMesh, ElementMesh>();
  /** Written to, added or removed in this task. */
  readonly #changed = new Set<PhongMesh>();
  #inOrder: readonly HTMLElement[] = [];
  #lights: readonly PhongLight[] = Object.freeze([]);
  #meshes: readonly PhongMesh[] = Object.freeze([]);

  constructor(context: ViewerContext, meshHost: MeshHost) {
    this.#viewer = context.viewer;
    this.#context = context;
    this.#meshHost = meshHost;
    this.#registry = registryOf(context.viewer);
    context.lightSet.assign([this.#headLight]);
    context.signals.orderNeeded.listen(() => this.sort());
    this.#registry.listen(this);
  }

  get lights(): readonly PhongLight[] {
    this.sort();
    return this.#lights;
  }

  get meshes(): readonly PhongMesh[] {
    this.sort();
    return this.#meshes;
  }

  added(child: HTMLElement): void {
    if (isLight(child)) {
      this.#addLight(stateOf(child));
    } else if (isMesh(child)) {
      this.#addMesh(child);
    }
  }

  removed(child: HTMLElement): void {
    if (isLight(child)) {
      this.#removeLight(stateOf(child));
    } else if (isMesh(child)) {
      this.#flushLater(child);
    }
  }

  moved(): void {
    this.#context.picture.invalidate();
  }

  /** For the viewer's `connectedCallback`, after its shadow tree was made. */
  connected(): void {
    // Those that left while the viewer was outside the document; the others register when they are
    // connected, after it.
    for (const child of this.#registry.all) {
      register(child);
    }
    inspect(this.#viewer);
    this.#viewer.shadowRoot?.addEventListener('slotchange', this.#slotted);
    this.#viewer.addEventListener('slotchange', this.#refresh);
  }

  readonly #slotted = (): void => inspect(this.#viewer, true);

  /**
   * Looks for children that came or went without a callback of theirs: outside a document, or into
   * the slot of a component whose shadow tree holds the viewer.
   */
  readonly #refresh = () => {
    const slots = Array.from(this.#viewer.querySelectorAll('slot'));
    const shown = slots.flatMap((slot) => slot.assignedElements({ flatten: true }));
    const found = [this.#viewer, ...shown].flatMap((root) => [
      root,
      ...root.querySelectorAll('phong-light, phong-mesh'),
    ]);
    for (const child of [...this.#registry.all, ...found]) {
      register(child);
    }
  };

  /**
   * Brings lights and meshes into document order. Does nothing unless children came, went or moved.
   */
  sort(): void {
    if (!this.#viewer.isConnected) {
      this.#refresh();
    }
    const { inOrder } = this.#registry;
    if (inOrder === this.#inOrder) return;
    this.#inOrder = inOrder;
    this.#sortLights(inOrder.filter((child) => isLight(child)));
    this.#sortMeshes(inOrder.filter((child) => isMesh(child)));
  }

  /**
   * Acts now on what was written to meshes, and on their removal, rather than at the end of the
   * task.
   */
  flush(): void {
    if (this.#changed.size === 0) return;
    const changed = [...this.#changed];
    this.#changed.clear();
    const isHere = (element: PhongMesh) => this.#registry.all.has(element);
    // Those that have gone make room for those that load.
    for (const element of changed) {
      if (!isHere(element)) {
        this.#dropMesh(element);
      }
    }
    for (const element of changed) {
      if (isHere(element)) {
        this.#shown.get(element)?.update();
      }
    }
    this.#context.signals.meshesChanged.emit();
  }

  #addLight(state: LightState) {
    const { lightSet } = this.#context;
    if (lightSet.lights[0] === this.#headLight) {
      lightSet.assign([state]);
    } else {
      lightSet.add(state);
    }
  }

  #removeLight(state: LightState) {
    const { lightSet } = this.#context;
    if (lightSet.lights.length === 1) {
      lightSet.assign([this.#headLight]);
    } else {
      lightSet.remove(state);
    }
  }

  #sortLights(lights: readonly PhongLight[]) {
    if (sameValue(lights, this.#lights)) return;
    this.#lights = Object.freeze(lights);
    if (lights.length > 0) {
      this.#context.lightSet.assign(lights.map(stateOf));
    }
  }

  #addMesh(element: PhongMesh) {
    // Removed and inserted again in one task, it keeps its model.
    let mesh = this.#shown.get(element);
    if (mesh === undefined) {
      mesh = new ElementMesh(element, this.#meshHost, () => this.#flushLater(element));
      this.#shown.set(element, mesh);
      this.#context.picture.add(mesh);
    }
    fieldsOf(element).store.listen(mesh.written);
    mesh.written();
  }

  #dropMesh(element: PhongMesh) {
    const mesh = this.#shown.get(element);
    if (mesh === undefined) return;
    // Another viewer may have taken it over already and listens now.
    fieldsOf(element).store.unlisten(mesh.written);
    this.#shown.delete(element);
    this.#context.picture.remove(mesh);
  }

  #sortMeshes(meshes: readonly PhongMesh[]) {
    if (sameValue(meshes, this.#meshes)) return;
    this.#meshes = Object.freeze(meshes);
    this.#context.picture.arrange(meshes.flatMap((element) => this.#shown.get(element) ?? []));
    this.#context.signals.meshesChanged.emit();
  }

  /** Several values written in one task make one update. */
  #flushLater(element: PhongMesh) {
    if (this.#changed.size === 0) {
      queueMicrotask(() => this.flush());
    }
    this.#changed.add(element);
  }
}

const stateOf = (light: PhongLight): LightState => fieldsOf(light).store;

/** By name, which only the elements of this package have in a registry. */
const isLight = (child: HTMLElement): child is PhongLight => child.localName === 'phong-light';
const isMesh = (child: HTMLElement): child is PhongMesh => child.localName === 'phong-mesh';

class ElementMesh extends SceneMesh {
  readonly element: PhongMesh;
  readonly written: (key?: string) => void;

  constructor(element: PhongMesh, host: MeshHost, changed: () => void) {
    super(fieldsOf(element).store, host);
    this.element = element;
    sceneMeshes.set(element, this);
    this.written = (key) => {
      if (key === 'src' || key === 'geometry') {
        this.retry();
      }
      changed();
    };
  }
}

/** The child that shows this mesh; undefined for the viewer's own mesh. */
export const elementOf = (mesh: SceneMesh): PhongMesh | undefined =>
  mesh instanceof ElementMesh ? mesh.element : undefined;
