// What a viewer loads: its own mesh and its children's, with their progress, events and errors.
import type { ReactiveController } from 'lit';
import { stage } from '../../scene/gpu/stage.js';
import { type MeshHost, SceneMesh } from '../../scene/mesh/scene-mesh.js';
import { lazyCode } from '../../../phong/lazy-code.js';
import { reportMissing } from '../../model/provided-code.js';
import type { CrossOrigin } from '../../model/request-model.js';
import type { Picture } from '../../scene/picture.js';
import { LOADING_KEYS } from '../fields/viewer-fields.js';
import type { LoadDetail } from '../elements.js';
import { sceneMeshes } from '../internals.js';
import type { ViewerContext } from './viewer-context.js';
import { isInClosed } from '../page/closed.js';
import { elementOf } from './children.js';
import type { EventQueue } from './event-queue.js';
import type { ViewerFailure } from './failure.js';

export const stepsCode = /* @__PURE__ */ lazyCode(() => import('./source-steps.js'), 'undo');

/** Loads that take less show no progress bar, ms: it would only flicker. */
const BAR_DELAY = 300;

export class ViewerLoading implements MeshHost, ReactiveController {
  readonly #context: ViewerContext;
  readonly #events: EventQueue;
  readonly #failure: ViewerFailure;
  /**
   * What has arrived of each load, 0 to 1; null: not known. Those that have ended stay, or the
   * share would fall.
   */
  readonly #shares = new Map<SceneMesh, number | null>();
  readonly #active = new Set<SceneMesh>();
  readonly ownMesh: SceneMesh;
  /** Both at any time until now. */
  #near = false;
  #painted = false;
  #suspended = false;
  #removal: ReturnType<typeof setTimeout> | undefined;
  #barTimer: ReturnType<typeof setTimeout> | undefined;
  #isSlow = false;
  #hasDrawn = false;
  /** Meshes whose content has not been drawn yet. */
  readonly #undrawn = new Set<SceneMesh>();

  constructor(context: ViewerContext, events: EventQueue, failure: ViewerFailure) {
    const { viewer, store, viewport, signals } = (this.#context = context);
    this.#events = events;
    this.#failure = failure;
    this.ownMesh = new SceneMesh(store, this);
    sceneMeshes.set(viewer, this.ownMesh);
    viewport.picture.add(this.ownMesh);
    signals.unproven = () => [...this.#undrawn].some(({ shown }) => shown.url !== null);
    signals.recover = (error, draw) => this.#recover(error, draw);
    signals.drawn.listen(() => this.#drawn());
    signals.viewChanged.listen(({ near, painted }) => {
      const isFirst = (near && !this.#near) || (painted && !this.#painted);
      this.#near ||= near;
      this.#painted ||= painted;
      if (!isFirst) return;
      // Those that waited. An update of the others would count as a change of the picture.
      for (const mesh of this.#meshes()) {
        if (mesh.values.src !== '' && mesh.complete === null) {
          mesh.update();
        }
      }
    });
  }

  /** Something that belongs to the first picture is on its way. */
  get awaited(): boolean {
    return !this.#hasDrawn && (this.#isEmpty || this.#meshes().some(awaitsShape));
  }

  get picture(): Picture {
    return this.#context.picture;
  }

  get crossOrigin(): CrossOrigin {
    return this.#context.values.crossOrigin;
  }

  get mayLoad(): boolean {
    const { viewer, values } = this.#context;
    if (this.#suspended || this.#near) return !this.#suspended;
    return (
      values.loading === 'eager' ||
      (values.loading === 'auto' && (this.#painted || !isInClosed(viewer)))
    );
  }

  shown(mesh: SceneMesh): boolean {
    this.#undrawn.add(mesh);
    return this.#context.viewport.drawable;
  }

  #drawn() {
    this.#hasDrawn = true;
    for (const mesh of this.#undrawn) {
      mesh.drawn();
    }
    this.#undrawn.clear();
  }

  /**
   * Drawing has thrown. Takes new content back, unless `draw` throws without it too: then something
   * else is wrong.
   */
  #recover(error: unknown, draw: () => void): boolean {
    const meshes = [...this.#undrawn];
    if (meshes.length === 0) return false;
    const show = (visible: boolean) => {
      for (const { shown } of meshes) {
        if (shown.root !== null) {
          shown.root.visible = visible;
        }
      }
    };
    show(false);
    try {
      draw();
    } catch {
      return false;
    } finally {
      show(true);
    }
    this.#undrawn.clear();
    for (const mesh of meshes) {
      mesh.revert(error);
    }
    return true;
  }

  removed(mesh: SceneMesh): void {
    this.#undrawn.delete(mesh);
  }

  began(mesh: SceneMesh): void {
    if (!this.pending) {
      this.#barTimer = setTimeout(() => {
        this.#isSlow = true;
        this.#context.viewer.requestUpdate();
      }, BAR_DELAY);
    }
    this.#active.add(mesh);
    this.#shares.set(mesh, null);
    this.#context.viewer.requestUpdate();
  }

  /** In bytes. A `total` of 0 is not known. */
  progress(mesh: SceneMesh, loaded: number, total: number): void {
    this.#shares.set(mesh, total > 0 ? Math.min(loaded / total, 1) : null);
    this.#enqueueProgress();
    if (this.#isSlow) {
      this.#context.viewer.requestUpdate();
    }
  }

  dropped(mesh: SceneMesh): void {
    this.#end(mesh);
    this.#failure.clear(mesh);
    this.#emitEnded();
  }

  ended(mesh: SceneMesh, url: URL | null, error: unknown): void {
    this.#end(mesh);
    const child = elementOf(mesh);
    if (error !== null) {
      const detail = this.#failure.report(mesh, error, url);
      child?.dispatchEvent(new CustomEvent('error', { detail }));
    } else if (url !== null) {
      const detail: LoadDetail = { url: url.href, missing: mesh.shown.missing };
      this.#enqueueProgress();
      child?.dispatchEvent(new CustomEvent('load', { detail }));
      this.#events.append('load', detail);
    }
    this.#emitEnded();
  }

  /** Later: meshes may be being updated now. */
  #emitEnded() {
    queueMicrotask(() => this.#context.signals.ended.emit());
  }

  get pending(): boolean {
    return this.#active.size > 0;
  }

  /**
   * What a progress bar shows: the share that has arrived, null if it is not known. Undefined for
   * no bar.
   */
  get bar(): number | null | undefined {
    return this.#isSlow ? this.#share : undefined;
  }

  /** Something to show is declared. */
  get wanted(): boolean {
    for (const mesh of this.picture.meshes) {
      if (isWanted(mesh)) return true;
    }
    return false;
  }

  /** Something is there, whatever else failed. */
  get shows(): boolean {
    return this.#meshes().some(({ shown }) => shown.root !== null);
  }

  /** A picture would show nothing, but something is on its way. */
  get #isEmpty(): boolean {
    const { children, background } = this.picture.scene;
    return this.pending && children.length === 0 && background === null;
  }

  /** Everything requested is there, and shapes have been drawn. False if nothing is requested. */
  get loaded(): boolean {
    let some = false;
    for (const mesh of this.picture.meshes) {
      if (!isWanted(mesh)) continue;
      const { complete } = mesh;
      if (complete === null || (complete === 'shape' && this.#undrawn.has(mesh))) return false;
      some = true;
    }
    return some;
  }

  hostConnected(): void {
    clearTimeout(this.#removal);
    if (!this.#suspended) return;
    this.#suspended = false;
    this.update();
  }

  /**
   * Nothing is downloaded for a removed viewer. One that only moves is back before the next task.
   */
  hostDisconnected(): void {
    // Disconnected twice: a popup that closes disconnects first, then the page moves the viewer out
    // of its document.
    clearTimeout(this.#removal);
    this.#removal = setTimeout(() => {
      this.#suspended = true;
      for (const mesh of this.#meshes()) {
        mesh.load.suspend();
      }
    });
  }

  /** Values of the viewer have changed, or were assigned again. */
  apply(changed: { has(key: string): boolean }): void {
    if (changed.has('src') || changed.has('geometry')) {
      this.ownMesh.retry();
    }
    if (LOADING_KEYS.some((key) => changed.has(key))) {
      this.update();
    }
  }

  update(): void {
    for (const mesh of this.#meshes()) {
      mesh.update();
    }
  }

  /**
   * Removes the message about a file of the user's own, which gives its place back to the source
   * before it. False if there is none.
   */
  dismiss(): boolean {
    const { newest, dismissible } = this.#failure;
    const mesh = this.#meshes().find((each) => each === newest?.subject);
    if (!dismissible || mesh === undefined) return false;
    this.#failure.clear(mesh);
    const { viewer } = this.#context;
    const element = elementOf(mesh) ?? viewer;
    const { src } = element;
    const { sourceBefore } = mesh.load;
    stepsCode().then(
      ({ takeBackSource }) => takeBackSource(viewer, element, src, sourceBefore),
      reportMissing,
    );
    return true;
  }

  /** Requests again what failed, a WebGL context included. */
  readonly retry = (): void => {
    stage.retry();
    for (const mesh of this.#meshes()) {
      mesh.retry();
    }
    this.update();
  };

  #end(mesh: SceneMesh) {
    this.#context.viewport.animate(); // the first picture may have waited for it
    if (!this.#active.delete(mesh)) return;
    this.#shares.set(mesh, 1);
    if (this.pending) return;
    this.#shares.clear();
    clearTimeout(this.#barTimer);
    this.#isSlow = false;
    this.#context.viewer.requestUpdate();
  }

  /** Mean of the loads, those not known counting as 0. Null if none is known. */
  get #share(): number | null {
    const shares = [...this.#shares.values()];
    if (shares.every((share) => share === null)) return null;
    return shares.reduce<number>((sum, share) => sum + (share ?? 0), 0) / shares.length;
  }

  #enqueueProgress() {
    const totalProgress = this.pending ? (this.#share ?? 0) : 1;
    this.#events.enqueue('progress', { totalProgress });
  }

  #meshes(): SceneMesh[] {
    return [...this.picture.meshes];
  }
}

/** Its values name something to show. */
const isWanted = ({ values }: SceneMesh) => values.src !== '' || values.geometry !== null;

/** The code of its shape is being fetched. */
const awaitsShape = ({ load, values }: SceneMesh) => load.pending && values.src === '';
