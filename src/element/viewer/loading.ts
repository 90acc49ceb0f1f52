// What a viewer loads: its own mesh and its children's, with their progress, events and errors. Knows neither how files
// are read nor how anything is drawn.
import { clipMessage } from '../../fields/clip.js';
import type { FieldStore } from '../../fields/field-store.js';
import { NoWebGL2Error } from '../../scene/gpu/stage.js';
import type { ShapeValues } from '../../scene/mesh/mesh-fields.js';
import { type MeshHost, SceneMesh } from '../../scene/mesh/scene-mesh.js';
import type { CrossOrigin } from '../../scene/model/load-model.js';
import { ModelError } from '../../scene/model/model.js';
import type { SharedMaterials } from '../../scene/mesh/shared-materials.js';
import type { Viewport } from '../../scene/viewport.js';
import type { ViewerValues } from '../fields/viewer-fields.js';
import type { EventQueue } from './event-queue.js';

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
  const message = clipMessage(error instanceof Error ? error.message : String(error));
  return { code: codeOf(error), message, url: url?.href ?? null };
}

function codeOf(error: unknown): ViewerErrorCode {
  if (error instanceof ModelError) return error.code;
  return error instanceof NoWebGL2Error ? 'no-webgl2' : 'load-failed';
}

export interface LoadingHost {
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

export class ViewerLoading implements MeshHost {
  readonly #host: LoadingHost;
  readonly #progress = new LoadProgress();
  /** The viewer's own `src` or `geometry`. */
  readonly ownMesh: SceneMesh;
  #near = false;

  constructor(host: LoadingHost) {
    this.#host = host;
    this.ownMesh = new SceneMesh(host.store as unknown as FieldStore<ShapeValues>, this);
    host.viewport.add(this.ownMesh);
  }

  get materials(): SharedMaterials {
    return this.#host.viewport.materials;
  }

  get crossOrigin(): CrossOrigin {
    return this.#host.store.values.crossOrigin;
  }

  get mayLoad(): boolean {
    return this.#near || this.#host.store.values.loading !== 'lazy';
  }

  changed(): void {
    this.#host.viewport.invalidate();
  }

  reshaped(): void {
    this.#host.viewport.reshaped();
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

  /** At least one model is there and none is pending. */
  get loaded(): boolean {
    return !this.pending && this.#meshes().some((mesh) => mesh.showsModel);
  }

  /** The viewer is in view or near it: lazy loading begins. */
  neared(): void {
    if (this.#near) return;
    this.#near = true;
    if (this.#host.store.values.loading === 'lazy') this.update();
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
