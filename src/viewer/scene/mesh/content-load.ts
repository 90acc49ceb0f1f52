// Loads the shape or model that a mesh's values name. One load at a time: a newer one replaces it.
import { sameValue } from '../../../phong/fields/field-store.js';
import type { CrossOrigin } from '../../model/request-model.js';
import { fileName } from '../../../phong/fields/file-names.js';
import { type Content, NO_CONTENT } from '../../../phong/model/model.js';
import type { ShapeValues } from '../../../phong/model/mesh-fields.js';
import { acquireShape, shapeKey } from './shared-shapes.js';
import type { GeometryName } from '../../../phong/model/shapes/shapes.js';
import type { Claim, Need } from '../../../phong/model/budget.js';
import { acquireModel } from './shared-models.js';

type ContentName = Pick<ShapeValues, 'src' | 'type' | 'geometry' | 'segments'>;

/** The mesh that content is loaded for. */
interface LoadingMesh {
  /** What a shape will hold before there is a geometry. */
  needsOf(geometry: GeometryName, segments: ShapeValues['segments']): readonly Need[];
  /** Called before {@link arrived}, to make materials in slices. */
  prepare(content: Content, signal: AbortSignal): Promise<void>;
  /** There is new content, `late` unless at once. `url` is null for a shape. */
  arrived(content: Content, claim: Claim, url: URL | null, late: boolean): void;
}

/** Who is told of loads, and allows them. */
export interface LoadHost<M> {
  readonly picture: { readonly budget: { claim(owner: M): Claim } };
  readonly crossOrigin: CrossOrigin;
  /** False while a lazy viewer has not been near the view, and after a viewer was removed. */
  readonly mayLoad: boolean;
  /** A load that takes a while has begun. Either {@link ended} or {@link dropped} follows. */
  began(mesh: M): void;
  progress(mesh: M, loaded: number, total: number): void;
  /**
   * A load has ended, or what came from `url` cannot be shown. `error`: null on success. Not for
   * replaced loads.
   */
  ended(mesh: M, url: URL | null, error: unknown): void;
  /** A load in progress was cancelled, or what failed is no longer wanted, or is shown now. */
  dropped(mesh: M): void;
}

export class ContentLoad<M extends LoadingMesh> {
  readonly #mesh: M;
  readonly #host: LoadHost<M>;
  #loading: AbortController | null = null;
  #failed = false;
  /** What was requested last; null for nothing. */
  #request: readonly unknown[] | null = null;
  /** The request of what is shown. */
  #arrived: readonly unknown[] | null = null;
  #source: string | Blob = '';
  #sourceBefore: string | Blob = '';

  constructor(mesh: M, host: LoadHost<M>) {
    this.#mesh = mesh;
    this.#host = host;
  }

  get pending(): boolean {
    return this.#loading !== null;
  }

  /** The last `src` before this one that is an address or was shown: no file that failed. */
  get sourceBefore(): string | Blob {
    return this.#sourceBefore;
  }

  /** What these values name was requested, and has arrived. */
  has(name: ContentName): boolean {
    return !this.pending && !this.#failed && sameValue(this.#request, this.#keyOf(name));
  }

  /** Requests what the values name, unless it was requested last. */
  request(name: ContentName): void {
    const { src, geometry, segments } = name;
    const key = this.#keyOf(name);
    if (sameValue(key, this.#request) || (src !== '' && !this.#host.mayLoad)) return;
    if (typeof this.#source === 'string' || (!this.#failed && !this.pending)) {
      this.#sourceBefore = this.#source;
    }
    this.#source = src;
    this.drop();
    this.#request = key;
    // Shown all the time, while something else was loading or has failed.
    if (src !== '' && sameValue(key, this.#arrived)) {
      queueMicrotask(() => {
        if (this.#request === key) {
          this.#host.ended(this.#mesh, addressOf(src), null);
        }
      });
      return;
    }
    const claim = this.#host.picture.budget.claim(this.#mesh);
    if (src !== '') {
      const url = addressOf(src);
      void this.#await(url, claim, (signal) => this.#loadModel(url, name, claim, signal));
      return;
    }
    try {
      // Before the shape is built.
      if (geometry !== null) {
        claim.add(this.#mesh.needsOf(geometry, segments));
      }
      const content = geometry === null ? NO_CONTENT : acquireShape(shapeKey(geometry, segments));
      if (content instanceof Promise) {
        void this.#await(null, claim, () => content);
      } else {
        this.#arrive(content, claim, null, false);
      }
    } catch (error) {
      claim.release();
      this.fail(null, error);
    }
  }

  fail(url: URL | null, error: unknown): void {
    this.#failed = true;
    if (this.#arrived === this.#request) {
      this.#arrived = null; // it could not be drawn
    }
    this.#host.ended(this.#mesh, url, error);
  }

  retry(): void {
    if (this.#failed) {
      this.#request = null;
    }
  }

  suspend(): void {
    if (this.pending) {
      this.drop();
    }
  }

  drop(): void {
    const dropped = this.pending || this.#failed;
    this.#loading?.abort('dropped');
    this.#loading = null;
    this.#failed = false;
    this.#request = null;
    if (dropped) {
      this.#host.dropped(this.#mesh);
    }
  }

  #keyOf({ src, type, geometry, segments }: ContentName): readonly unknown[] {
    return src === '' ? [geometry, segments] : [src, type, this.#host.crossOrigin];
  }

  #arrive(content: Content, claim: Claim, url: URL | null, late: boolean): void {
    const request = this.#request;
    const before = this.#arrived;
    this.#arrived = request;
    this.#mesh.arrived(content, claim, url, late);
    if (this.#failed && this.#request === request) {
      this.#arrived = before; // still shown
    }
  }

  async #loadModel(
    url: URL | null,
    { src, type }: ContentName,
    claim: Claim,
    signal: AbortSignal,
  ): Promise<Content> {
    if (url === null) throw new TypeError(`src=${JSON.stringify(src)} is not an address`);
    const { crossOrigin } = this.#host;
    const onProgress = (loaded: number, total: number): void =>
      this.#host.progress(this.#mesh, loaded, total);
    const model = { url, src, type: type ?? '', crossOrigin };
    const content = await acquireModel(model, { claim, signal, onProgress });
    try {
      await this.#mesh.prepare(content, signal);
    } catch (error) {
      content.dispose();
      throw error;
    }
    return content;
  }

  async #await(
    url: URL | null,
    claim: Claim,
    load: (signal: AbortSignal) => Promise<Content>,
  ): Promise<void> {
    const loading = (this.#loading = new AbortController());
    this.#host.began(this.#mesh);
    try {
      const content = await load(loading.signal);
      if (loading.signal.aborted) {
        content.dispose();
        claim.release();
        return;
      }
      this.#loading = null;
      this.#arrive(content, claim, url, true);
    } catch (error) {
      claim.release();
      if (loading.signal.aborted) return;
      if (this.#loading === loading) {
        this.#loading = null;
      }
      loading.abort('failed'); // ends what is still being downloaded
      this.fail(url, error);
    }
  }
}

/** A file's address is not fetched: it is for messages and events. */
function addressOf(src: string | Blob): URL | null {
  if (typeof src !== 'string') return new URL(encodeURIComponent(fileName(src)), 'file:///');
  return URL.canParse(src, document.baseURI) ? new URL(src, document.baseURI) : null;
}
