// What is on its way to a viewer: its own mesh, its children's, and what is said of their loads. Knows neither how
// files are read nor how anything is drawn.
import type { FieldStore } from '../../fields/field-store.js';
import type { PhongLighting } from '../../material/lighting.js';
import type { ShadingStyle } from '../../material/phong-material.js';
import type { ShapeValues } from '../../scene/mesh/mesh-fields.js';
import type { CrossOrigin } from '../../scene/model/load-model.js';
import { ModelError } from '../../scene/model/model.js';
import { type MeshHost, SceneMesh } from '../../scene/mesh/scene-mesh.js';
import { NoWebGL2Error } from '../../scene/gpu/stage.js';
import type { Viewport } from '../../scene/viewport.js';
import type { EventQueue } from './event-queue.js';
import type { ViewerValues } from '../fields/viewer-fields.js';

export type ViewerErrorCode =
  'load-failed' | 'bad-model' | 'too-large' | 'csp' | 'context-lost' | 'no-webgl2';

export interface ViewerErrorDetail {
  readonly code: ViewerErrorCode;
  /** For the page's author. */
  readonly message: string;
  /** What could not be loaded, where it is about a load. */
  readonly url: string | null;
}

export function errorDetail(error: unknown, url: URL | null): ViewerErrorDetail {
  const message = error instanceof Error ? error.message : String(error);
  return { code: codeOf(error), message, url: url?.href ?? null };
}

function codeOf(error: unknown): ViewerErrorCode {
  if (error instanceof ModelError) return error.code;
  return error instanceof NoWebGL2Error ? 'no-webgl2' : 'load-failed';
}

export interface LoadingHost {
  readonly state: FieldStore<ViewerValues>;
  readonly viewport: Viewport;
  readonly notices: EventQueue;
  /** The child that a mesh stands for; undefined for the viewer's own. */
  elementOf(mesh: SceneMesh): HTMLElement | undefined;
  childMeshes(): Iterable<SceneMesh>;
  fail(mesh: SceneMesh, detail: ViewerErrorDetail): void;
  /** A load ended well, or is asked for no more: nothing of it has failed any longer. */
  mended(mesh: SceneMesh): void;
  /** Something that was waited for ended, whichever way. */
  ended(): void;
}

export class ViewerLoading implements MeshHost {
  readonly #host: LoadingHost;
  readonly #progress = new LoadProgress();
  /** The viewer's own `src` or `geometry`. */
  readonly ownMesh: SceneMesh;
  #seen = false;

  constructor(host: LoadingHost) {
    this.#host = host;
    this.ownMesh = new SceneMesh(host.state as unknown as FieldStore<ShapeValues>, this);
    host.viewport.add(this.ownMesh);
  }

  get lighting(): PhongLighting {
    return this.#host.viewport.lighting;
  }

  get style(): ShadingStyle {
    return this.#host.viewport.style;
  }

  get crossOrigin(): CrossOrigin {
    return this.#host.state.values.crossOrigin;
  }

  get mayLoad(): boolean {
    return this.#seen || this.#host.state.values.loading !== 'lazy';
  }

  changed(): void {
    this.#host.viewport.invalidate();
  }

  reshaped(): void {
    this.#host.viewport.reshaped();
  }

  progress(mesh: SceneMesh, loaded: number, total: number): void {
    this.#progress.update(mesh, loaded, total);
    this.#tellProgress();
  }

  dropped(mesh: SceneMesh): void {
    this.#progress.end(mesh);
    this.#host.mended(mesh);
  }

  ended(mesh: SceneMesh, url: URL | null, error: unknown): void {
    this.#progress.end(mesh);
    const child = this.#host.elementOf(mesh);
    if (error !== null) {
      const detail = errorDetail(error, url);
      child?.dispatchEvent(new CustomEvent('error', { detail }));
      this.#host.fail(mesh, detail);
    } else if (url !== null) {
      const detail = { url: url.href };
      this.#tellProgress();
      child?.dispatchEvent(new CustomEvent('load', { detail }));
      this.#host.notices.tell('load', detail, detail);
    }
    this.#host.ended();
  }

  /** Something that was asked for is on its way. */
  get pending(): boolean {
    return this.#loads;
  }

  /** At least one model is there and none is on its way. */
  get loaded(): boolean {
    return !this.#loads && this.#meshes().some((mesh) => mesh.showsModel);
  }

  /** The viewer can be seen: lazy loading begins. */
  seen(): void {
    if (this.#seen) return;
    this.#seen = true;
    if (this.#host.state.values.loading === 'lazy') this.update();
  }

  update(): void {
    for (const mesh of this.#meshes()) mesh.update();
  }

  get #loads(): boolean {
    return this.#meshes().some((mesh) => mesh.loading);
  }

  #tellProgress(): void {
    this.#host.notices.tell('progress', { totalProgress: this.#progress.share });
  }

  #meshes(): SceneMesh[] {
    return [this.ownMesh, ...this.#host.childMeshes()];
  }
}

interface Transfer {
  loaded: number;
  total: number;
}

/** Progress of all loads together, 0 to 1; loads are told apart by whatever object stands for them. */
class LoadProgress {
  readonly #transfers = new Map<object, Transfer>();

  update(load: object, loaded: number, total: number): void {
    this.#transfers.set(load, { loaded, total });
  }

  end(load: object): void {
    this.#transfers.delete(load);
  }

  /** Share of the bytes that have come; a load whose size is unknown counts as not begun. */
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
