// Loads the content that a mesh's values name, a built-in shape or a model. One load at a time: a newer one replaces
// it.
import { sameValue } from '../../fields/field-store.js';
import { fileName } from '../../model/file-name.js';
import { type Content, NO_CONTENT } from '../../model/model.js';
import type { ShapeValues } from './mesh-fields.js';
import { acquireGeometry, releaseGeometry, type ShapeKey, shapeKey, shapeNeeds } from './shapes/shared-shapes.js';
import { CLOSED, type GeometryName, type LoadedShape } from './shapes/shapes.js';
import type { Budget, Claim, Need } from '../../model/budget.js';
import { acquireModel } from './shared-models.js';
import { type BufferGeometry, Matrix4 } from 'three';
import { PLAIN_LOOK } from '../../material/file-surface.js';
import type { CrossOrigin } from '../../model/request-file.js';

type ContentName = Pick<ShapeValues, 'src' | 'type' | 'geometry' | 'segments'>;

/** What shows the content. */
export interface ContentOwner {
  /** What a shape will hold before there is a geometry. */
  needsOf(geometry: GeometryName, segments: ContentName['segments']): readonly Need[];
  /** Makes ready for a model what would take long in one task. Before {@link arrived}. */
  prepare(content: Content, signal: AbortSignal): Promise<void>;
  /** `late` unless it was there at once. `url` is null for a shape. The owner releases the claim. */
  arrived(content: Content, claim: Claim, url: URL | null, late: boolean): void;
}

/** Follows the loads of all owners. */
export interface LoadHost<Owner> {
  readonly crossOrigin: CrossOrigin;
  readonly picture: { readonly budget: Budget };
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
    const claim = this.#host.picture.budget.claim(this.#owner);
    if (src !== '') {
      const url = addressOf(src);
      this.#await(url, claim, (signal) => this.#loadModel(url, { src, type }, claim, signal));
      return;
    }
    try {
      // Before the shape is built.
      if (geometry !== null) claim.add(this.#owner.needsOf(geometry, segments));
      const content = geometry === null ? NO_CONTENT : shapeContent(shapeKey(geometry, segments));
      if (content instanceof Promise) this.#await(null, claim, () => content);
      else this.#owner.arrived(content, claim, null, false);
    } catch (error) {
      claim.release();
      this.fail(null, error);
    }
  }

  /** What was requested last has failed. */
  get failed(): boolean {
    return this.#failed;
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
    const onProgress = (loaded: number, total: number): void => this.#host.progress(this.#owner, loaded, total);
    const name = { url, src, type: type ?? '', crossOrigin };
    const content = await acquireModel(name, { claim, signal, onProgress });
    try {
      await this.#owner.prepare(content, signal);
    } catch (error) {
      content.dispose();
      throw error;
    }
    return content;
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

/** A built-in shape: at once if its code is loaded, else a promise. */
export function shapeContent(key: ShapeKey & { readonly name: LoadedShape }): Content;
export function shapeContent(key: ShapeKey): Content | Promise<Content>;
export function shapeContent(key: ShapeKey): Content | Promise<Content> {
  const geometry = acquireGeometry(key);
  const content = (ready: BufferGeometry): Content => {
    let known = shapeContents.get(ready);
    if (known === undefined) {
      const { name } = key;
      const sides = CLOSED.has(name) ? 'closed' : 'double';
      known = {
        parts: [{ name, geometry: ready, matrix: IDENTITY, look: PLAIN_LOOK, sides, surface: {} }],
        motion: null,
        dispose: () => releaseGeometry(key),
      };
      shapeContents.set(ready, known);
      flatNeeds.set(known, shapeNeeds(key, true));
    }
    return known;
  };
  return geometry instanceof Promise ? geometry.then(content) : content(geometry);
}

/** Equal shapes are one content. */
const shapeContents = new WeakMap<BufferGeometry, Content>();

/** What flat copies of a content's geometries hold. */
export const flatNeedsOf = (content: Content): readonly Need[] =>
  flatNeeds.get(content) ??
  [...new Set(content.parts.map(({ geometry }) => geometry))].map((geometry) => ({
    key: geometry,
    claims: { values: flatValues(geometry) },
    flat: true,
  }));

/** The values of a geometry's flat copy: every corner has its own, as floats. */
function flatValues({ attributes, index }: BufferGeometry): number {
  const sizes = Object.entries(attributes).map(([name, { itemSize }]) => (name === 'normal' ? 0 : itemSize));
  const corners = index?.count ?? attributes['position']?.count ?? 0;
  return corners * sizes.reduce((sum, size) => sum + size, 3);
}

/** Those of shapes, which are claimed before there is a geometry. */
const flatNeeds = new WeakMap<Content, readonly Need[]>();

const IDENTITY: Matrix4 = /* @__PURE__ */ new Matrix4();
