// What is on its way to a viewer: its own mesh, its children's, and what is said of their loads. Knows neither how
// files are read nor how anything is drawn.
import type { Declared } from '../math/declared.js';
import type { ShapeValues } from '../scene/mesh-fields.js';
import { ModelError } from '../scene/model/model.js';
import { type MeshContext, type MeshEvents, SceneMesh } from '../scene/scene-mesh.js';
import { NoWebGL2Error } from '../scene/stage.js';
import type { Viewport } from '../scene/viewport.js';
import type { Notices } from './notices.js';
import type { ViewerValues } from './viewer-fields.js';

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
  readonly state: Declared<ViewerValues>;
  readonly viewport: Viewport;
  readonly notices: Notices;
  /** The child that a mesh stands for; undefined for the viewer's own. */
  elementOf(mesh: SceneMesh): HTMLElement | undefined;
  childMeshes(): Iterable<SceneMesh>;
  fail(mesh: SceneMesh, detail: ViewerErrorDetail): void;
  /** A load ended well, or is asked for no more: nothing of it has failed any longer. */
  mended(mesh: SceneMesh): void;
  /** Something that was waited for ended, whichever way. */
  ended(): void;
}

export class ViewerLoading {
  readonly #host: LoadingHost;
  readonly #progress = new LoadProgress();
  readonly context: MeshContext;
  readonly events: MeshEvents;
  /** The viewer's own `src` or `geometry`. */
  readonly ownMesh: SceneMesh;
  #seen = false;

  constructor(host: LoadingHost) {
    this.#host = host;
    const mayLoad = (): boolean => this.#seen || host.state.values.loading !== 'lazy';
    this.context = {
      lighting: host.viewport.lighting,
      get style() {
        return host.viewport.style;
      },
      get crossOrigin() {
        return host.state.values.crossOrigin;
      },
      get mayLoad() {
        return mayLoad();
      },
    };
    this.events = {
      changed: () => {
        host.viewport.invalidate();
      },
      reshaped: () => {
        host.viewport.reshaped();
      },
      progress: (mesh, loaded, total) => {
        this.#progress.update(mesh, loaded, total);
        host.notices.tell('progress', { totalProgress: this.#progress.share });
      },
      ended: (mesh, url, error) => {
        this.#ended(mesh, url, error);
      },
      dropped: (mesh) => {
        this.#progress.end(mesh);
        host.mended(mesh);
      },
    };
    this.ownMesh = new SceneMesh(host.state as unknown as Declared<ShapeValues>, this.context, this.events);
    host.viewport.add(this.ownMesh);
  }

  get pending(): boolean {
    return this.#meshes().some((mesh) => mesh.loading);
  }

  /** At least one model is there and none is on its way. */
  get loaded(): boolean {
    return !this.pending && this.#meshes().some((mesh) => mesh.showsModel);
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

  #meshes(): SceneMesh[] {
    return [this.ownMesh, ...this.#host.childMeshes()];
  }

  #ended(mesh: SceneMesh, url: URL | null, error: unknown): void {
    this.#progress.end(mesh);
    const child = this.#host.elementOf(mesh);
    if (error !== null) {
      const detail = errorDetail(error, url);
      child?.dispatchEvent(new CustomEvent('error', { detail }));
      this.#host.fail(mesh, detail);
    } else if (url !== null) {
      const detail = { url: url.href };
      this.#host.notices.tell('progress', { totalProgress: this.#progress.share });
      child?.dispatchEvent(new CustomEvent('load', { detail }));
      this.#host.notices.tell('load', detail, detail);
    }
    this.#host.ended();
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
