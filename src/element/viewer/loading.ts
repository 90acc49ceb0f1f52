// What a viewer loads: its own mesh and its children's, with their progress, events and errors. Knows neither how files
// are read nor how anything is drawn.
import type { ReactiveController } from '@lit/reactive-element';
import { clipMessage } from '../../fields/clip.js';
import type { FieldStore } from '../../fields/field-store.js';
import { NoWebGL2Error } from '../../scene/gpu/stage.js';
import type { ShapeValues } from '../../scene/mesh/mesh-fields.js';
import { type MeshHost, SceneMesh } from '../../scene/mesh/scene-mesh.js';
import type { CrossOrigin } from '../../scene/model/load-model.js';
import { ModelError } from '../../scene/model/model.js';
import { isOutOfMemory } from '../../scene/out-of-memory.js';
import type { SharedMaterials } from '../../scene/mesh/shared-materials.js';
import type { Viewport } from '../../scene/viewport.js';
import { LOADING_KEYS, type ViewerValues } from '../fields/viewer-fields.js';
import type { PhongViewer } from '../phong-viewer.js';
import type { EventQueue } from './event-queue.js';
import { takeDrops } from './file-drop.js';

export type ViewerErrorCode =
  'load-failed' | 'bad-model' | 'too-large' | 'csp' | 'context-lost' | 'no-webgl2';

export interface ViewerErrorDetail {
  readonly code: ViewerErrorCode;
  /** For the page's author. */
  readonly message: string;
  /** The address that could not be loaded; null if the error is about something else. */
  readonly url: string | null;
}

export function errorDetail(error: unknown, url: URL | null): ViewerErrorDetail {
  const code = codeOf(error);
  let message = error instanceof Error ? error.message : String(error);
  if (code === 'too-large' && !(error instanceof ModelError))
    message = 'There is not enough memory to show this.';
  return { code, message: clipMessage(message), url: url?.href ?? null };
}

function codeOf(error: unknown): ViewerErrorCode {
  if (error instanceof ModelError) return error.code;
  if (isOutOfMemory(error)) return 'too-large';
  return error instanceof NoWebGL2Error ? 'no-webgl2' : 'load-failed';
}

export interface LoadingHost {
  readonly viewer: PhongViewer;
  readonly store: FieldStore<ViewerValues>;
  readonly viewport: Viewport;
  readonly events: EventQueue;
  /** The child that shows this mesh; undefined for the viewer's own mesh. */
  elementOf(mesh: SceneMesh): HTMLElement | undefined;
  childMeshes(): Iterable<SceneMesh>;
  failed(mesh: SceneMesh, detail: ViewerErrorDetail): void;
  /** A load succeeded or is no longer wanted: an earlier failure of this mesh is over. */
  cleared(mesh: SceneMesh): void;
  /** A load ended, whichever way. */
  ended(): void;
}

export class ViewerLoading implements MeshHost, ReactiveController {
  readonly #host: LoadingHost;
  readonly #progress = new LoadProgress();
  /** The viewer's own `src` or `geometry`. */
  readonly ownMesh: SceneMesh;
  #near = false;
  #suspended = false;
  #removal: ReturnType<typeof setTimeout> | undefined;
  /** Meshes whose content has not been drawn yet. */
  readonly #undrawn = new Set<SceneMesh>();

  constructor(host: LoadingHost) {
    this.#host = host;
    this.ownMesh = new SceneMesh(host.store as unknown as FieldStore<ShapeValues>, this);
    host.viewport.add(this.ownMesh);
    takeDrops(host.viewer);
  }

  get materials(): SharedMaterials {
    return this.#host.viewport.materials;
  }

  get crossOrigin(): CrossOrigin {
    return this.#host.store.values.crossOrigin;
  }

  get mayLoad(): boolean {
    return !this.#suspended && (this.#near || this.#host.store.values.loading !== 'lazy');
  }

  changed(): void {
    this.#host.viewport.invalidate();
  }

  reshaped(): void {
    this.#host.viewport.reshaped();
  }

  shown(mesh: SceneMesh): boolean {
    this.#undrawn.add(mesh);
    return this.#host.viewport.drawable;
  }

  /** All content has been drawn. */
  drawn(): void {
    for (const mesh of this.#undrawn) mesh.drawn();
    this.#undrawn.clear();
  }

  /** Drawing has thrown. Takes new content back, unless `draw` throws without it too: then something else is wrong. */
  undrawable(error: unknown, draw: () => void): boolean {
    const meshes = [...this.#undrawn];
    if (meshes.length === 0) return false;
    const show = (visible: boolean): void => {
      for (const { root } of meshes) if (root !== null) root.visible = visible;
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
    for (const mesh of meshes) mesh.revert(error);
    return true;
  }

  removed(mesh: SceneMesh): void {
    this.#undrawn.delete(mesh);
  }

  progress(mesh: SceneMesh, loaded: number, total: number): void {
    this.#progress.update(mesh, loaded, total);
    this.#enqueueProgress();
  }

  dropped(mesh: SceneMesh): void {
    this.#progress.end(mesh);
    this.#host.cleared(mesh);
  }

  ended(mesh: SceneMesh, url: URL | null, error: unknown): void {
    this.#progress.end(mesh);
    const child = this.#host.elementOf(mesh);
    if (error !== null) {
      const detail = errorDetail(error, url);
      child?.dispatchEvent(new CustomEvent('error', { detail }));
      this.#host.failed(mesh, detail);
    } else if (url !== null) {
      const detail = { url: url.href };
      this.#enqueueProgress();
      child?.dispatchEvent(new CustomEvent('load', { detail }));
      this.#host.events.enqueue('load', detail, detail);
    }
    this.#host.ended();
  }

  /** Something requested has not arrived yet. */
  get pending(): boolean {
    return this.#meshes().some((mesh) => mesh.loading);
  }

  /** Everything requested is there, and shapes have been drawn. False if nothing is requested. */
  get loaded(): boolean {
    const wanted = this.#meshes().filter((mesh) => mesh.wanted);
    const there = (mesh: SceneMesh): boolean =>
      mesh.complete === 'model' || (mesh.complete === 'shape' && !this.#undrawn.has(mesh));
    return wanted.length > 0 && wanted.every(there);
  }

  hostConnected(): void {
    clearTimeout(this.#removal);
    if (!this.#suspended) return;
    this.#suspended = false;
    this.update();
  }

  /** Nothing is downloaded for a removed viewer. One that only moves is back before the next task. */
  hostDisconnected(): void {
    this.#removal = setTimeout(() => {
      this.#suspended = true;
      for (const mesh of this.#meshes()) mesh.suspend();
    });
  }

  /** The viewer is in view or near it: lazy loading begins. */
  neared(): void {
    if (this.#near) return;
    this.#near = true;
    if (this.#host.store.values.loading === 'lazy') this.update();
  }

  /** Values of the viewer have changed, or were assigned again. */
  apply(changed: { has(key: string): boolean }): void {
    if (changed.has('src') || changed.has('geometry')) this.ownMesh.retry();
    if (LOADING_KEYS.some((key) => changed.has(key))) this.update();
  }

  update(): void {
    for (const mesh of this.#meshes()) mesh.update();
  }

  #enqueueProgress(): void {
    this.#host.events.enqueue('progress', { totalProgress: this.#progress.share });
  }

  #meshes(): SceneMesh[] {
    return [this.ownMesh, ...this.#host.childMeshes()];
  }
}

interface Transfer {
  loaded: number;
  total: number;
}

/** Progress of all loads together, 0 to 1. A load is identified by any object. */
class LoadProgress {
  readonly #transfers = new Map<object, Transfer>();

  update(load: object, loaded: number, total: number): void {
    this.#transfers.set(load, { loaded, total });
  }

  end(load: object): void {
    this.#transfers.delete(load);
  }

  /** Share of the bytes received. A load of unknown size counts as not begun. */
  get share(): number {
    let loaded = 0;
    let total = 0;
    for (const transfer of this.#transfers.values()) {
      if (transfer.total > 0) loaded += Math.min(transfer.loaded, transfer.total);
      total += transfer.total > 0 ? transfer.total : transfer.loaded;
    }
    return total > 0 ? loaded / total : 1;
  }
}
