// Loads the content that a mesh's values name. One load at a time: a newer one replaces it.
import { sameValue } from '../../fields/field-store.js';
import type { CrossOrigin } from '../../model/load-model.js';
import { fileName } from '../../model/file-name.js';
import { type Content, NOTHING } from '../../model/content.js';
import { requestModel, shapeContent } from './content.js';
import type { ShapeValues } from './mesh-fields.js';
import { shapeKey } from './shapes/shared-shapes.js';
import type { GeometryName } from './shapes/shapes.js';
import type { Claim, Claimant, Need, TriangleBudget } from './triangle-budget.js';

export type ContentName = Pick<ShapeValues, 'src' | 'type' | 'geometry' | 'segments'>;

/** What shows the content. */
export interface ContentOwner extends Claimant {
  /** What a shape will hold before there is a geometry. */
  needsOf(geometry: GeometryName, segments: ContentName['segments']): readonly Need[];
  /** `late` unless it was there at once. `url` is null for a shape. The owner releases the claim. */
  arrived(content: Content, claim: Claim, url: URL | null, late: boolean): void;
}

/** Follows the loads of all owners. */
export interface LoadHost<Owner> {
  readonly crossOrigin: CrossOrigin;
  readonly budget: TriangleBudget;
  /**
   * Whether models may be fetched: false while a lazy viewer has not come near the view, and after a viewer was
   * removed.
   */
  readonly mayLoad: boolean;
  /** A load that takes a while has begun. Either {@link ended} or {@link dropped} follows. */
  began(owner: Owner): void;
  progress(owner: Owner, loaded: number, total: number): void;
  /**
   * A load has ended, or what it brought cannot be shown; `error` is null on success. Not called for loads that a newer
   * one replaced.
   */
  ended(owner: Owner, url: URL | null, error: unknown): void;
  /** A load in progress was cancelled, or what failed is no longer wanted. */
  dropped(owner: Owner): void;
}

export class ContentLoad<Owner extends ContentOwner> {
  readonly #owner: Owner;
  readonly #host: LoadHost<Owner>;
  #loading: AbortController | null = null;
  #failed = false;
  /** What was requested last; null for nothing. */
  #request: readonly unknown[] | null = null;

  constructor(owner: Owner, host: LoadHost<Owner>) {
    this.#owner = owner;
    this.#host = host;
  }

  get pending(): boolean {
    return this.#loading !== null;
  }

  /** What these values name was requested, and has arrived. */
  has(name: ContentName): boolean {
    return !this.pending && !this.#failed && sameValue(this.#request, this.#keyOf(name));
  }

  /** Requests what the values name, unless it was requested last. */
  request(name: ContentName): void {
    const { src, type, geometry, segments } = name;
    const key = this.#keyOf(name);
    if (sameValue(key, this.#request) || (src !== '' && !this.#host.mayLoad)) return;
    this.drop();
    this.#request = key;
    const claim = this.#host.budget.claim(this.#owner);
    if (src !== '') {
      const url = addressOf(src);
      this.#await(url, claim, (signal) => this.#loadModel(url, { src, type }, claim, signal));
      return;
    }
    try {
      // Before the shape is built.
      if (geometry !== null) claim.add(this.#owner.needsOf(geometry, segments));
      const content = geometry === null ? NOTHING : shapeContent(shapeKey(geometry, segments));
      if (content instanceof Promise) this.#await(null, claim, () => content);
      else this.#owner.arrived(content, claim, null, false);
    } catch (error) {
      claim.release();
      this.fail(null, error);
    }
  }

  /** What has arrived cannot be used. */
  fail(url: URL | null, error: unknown): void {
    this.#failed = true;
    this.#host.ended(this.#owner, url, error);
  }

  /** After a failure, the next {@link request} may be for the same. */
  retry(): void {
    if (this.#failed) this.#request = null;
  }

  /** Cancels a load in progress. The next {@link request} may be for the same. */
  suspend(): void {
    if (this.pending) this.drop();
  }

  drop(): void {
    const dropped = this.pending || this.#failed;
    this.#host.budget.forget(this.#owner);
    this.#loading?.abort();
    this.#loading = null;
    this.#failed = false;
    this.#request = null;
    if (dropped) this.#host.dropped(this.#owner);
  }

  #keyOf({ src, type, geometry, segments }: ContentName): readonly unknown[] {
    return src === '' ? [geometry, segments] : [src, type, this.#host.crossOrigin];
  }

  async #loadModel(
    url: URL | null,
    { src, type }: Pick<ContentName, 'src' | 'type'>,
    claim: Claim,
    signal: AbortSignal,
  ): Promise<Content> {
    if (url === null) throw new TypeError(`src=${JSON.stringify(src)} is not an address`);
    const { crossOrigin } = this.#host;
    const onProgress = (loaded: number, total: number): void => {
      this.#host.progress(this.#owner, loaded, total);
    };
    return requestModel(
      url,
      { signal, onProgress, onValues: claim.addValues, crossOrigin, type: type ?? '' },
      typeof src === 'string' ? null : src,
    );
  }

  #await(url: URL | null, claim: Claim, load: (signal: AbortSignal) => Promise<Content>): void {
    const loading = new AbortController();
    this.#loading = loading;
    this.#host.began(this.#owner);
    load(loading.signal).then(
      (content) => {
        if (this.#loading !== loading) {
          content.dispose();
          claim.release();
          return;
        }
        this.#loading = null;
        try {
          this.#owner.arrived(content, claim, url, true);
        } catch (error) {
          claim.release();
          this.fail(url, error);
        }
      },
      (error: unknown) => {
        claim.release();
        if (this.#loading !== loading) return;
        this.#loading = null;
        loading.abort(); // ends what is still being downloaded
        this.fail(url, error);
      },
    );
  }
}

/** A file's address is not fetched: it is for messages and events. */
function addressOf(src: string | Blob): URL | null {
  if (typeof src !== 'string') return new URL(encodeURIComponent(fileName(src)), 'file:///');
  return URL.canParse(src, document.baseURI) ? new URL(src, document.baseURI) : null;
}
