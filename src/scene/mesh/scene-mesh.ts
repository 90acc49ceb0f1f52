// One declared mesh in the scene: follows its values, loads what they name, and keeps showing the last content until
// the next one is there and can be shown.
import type { PhongMaterial } from '../../material/phong-material.js';
import type { Claim } from '../../model/budget.js';
import { isOutOfMemory } from '../../model/limits.js';
import { type Content, ModelError } from '../../model/model.js';
import { modelCode } from '../../model/request-model.js';
import { ContentLoad, type ContentOwner, type LoadHost } from './content-load.js';
import type { MeshState } from './mesh-fields.js';
import type { ShownContent } from './parts.js';
import { FIXED } from './shapes/shared-shapes.js';
import { effectiveSegments } from './shapes/shapes.js';
import { type MeshPicture, ShownMesh } from './shown-mesh.js';

/** The viewer of a mesh. */
export interface MeshHost extends LoadHost<SceneMesh> {
  readonly picture: MeshPicture;
  /**
   * The mesh has new content, which has not been drawn yet. True if it will be drawn soon: until then the content
   * before is kept.
   */
  shown(mesh: SceneMesh): boolean;
  /** The mesh was removed from the scene. */
  removed(mesh: SceneMesh): void;
}

/** Models with fewer parts get their materials at once. */
const MANY_PARTS = 256;

export class SceneMesh extends ShownMesh implements ContentOwner {
  readonly #host: MeshHost;
  readonly #load: ContentLoad<SceneMesh>;
  /** Materials of a model that is about to come. */
  readonly #held: PhongMaterial[] = [];

  constructor(state: MeshState, host: MeshHost) {
    super(state, host.picture);
    this.#host = host;
    this.#load = new ContentLoad<SceneMesh>(this, host);
  }

  /** The segments of the shape that is shown; null for a model or nothing. */
  get segments(): number | null {
    const { geometry, segments } = this.values;
    if (this.complete !== 'shape' || geometry === null) return null;
    const drawn = this.auto === null || this.level === FIXED ? undefined : this.level;
    return effectiveSegments(geometry, segments === 'auto' ? drawn : segments);
  }

  /** Makes the materials. Thousands take long, so each slice makes a few. They are held until the content has come. */
  async prepare({ parts }: Content, signal: AbortSignal): Promise<void> {
    this.#letGo();
    if (parts.length < MANY_PARTS) return;
    const { Slices } = await modelCode();
    const { shading = null, reflection = null } = this.values;
    const slices = new Slices(signal);
    await slices.pause(); // the last task of the reader
    await slices.map(parts, (part) => {
      const appearance = this.appearanceOf(part, { shading, reflection });
      this.#held.push(this.#host.picture.materials.acquire(appearance));
    });
    await slices.pause();
  }

  #letGo(): void {
    for (const material of this.#held.splice(0)) this.#host.picture.materials.release(material);
  }

  arrived(content: Content, claim: Claim, url: URL | null, late: boolean): void {
    let next: ShownContent;
    try {
      next = this.prepared(content, claim, url);
    } catch (error) {
      content.dispose();
      claim.release();
      this.#load.fail(url, error);
      return;
    } finally {
      this.#letGo();
    }
    this.show(next);
    if (!late) return;
    this.settle();
    this.ended(url, null);
  }

  /** Its `src` is a file of the user's own, not an address. */
  get isOwnFile(): boolean {
    return typeof this.values.src !== 'string';
  }

  /** Its values name something to show. */
  get wanted(): boolean {
    return this.values.src !== '' || this.values.geometry !== null;
  }

  /** The code of its shape is being fetched. */
  get awaitsShape(): boolean {
    return this.#load.pending && this.values.src === '';
  }

  /** What it shows now is what its values name: a model, a shape, or (null) something else, as after a failure. */
  get complete(): 'model' | 'shape' | null {
    if (this.root === null || !this.#load.has(this.values)) return null;
    return this.url === null ? 'shape' : 'model';
  }

  /** Updates the scene to the values. Cheap if nothing has changed. */
  update(): void {
    this.#load.request(this.values);
    this.settle();
  }

  /** After a failure, the next {@link update} requests the same again. */
  retry(): void {
    this.#load.retry();
    this.forgetNotFlat();
  }

  /** Cancels a load in progress. The next {@link update} requests it again. */
  suspend(): void {
    this.#load.suspend();
  }

  /** The present content could not be drawn: goes back to what was shown before. */
  revert(error: unknown): void {
    this.#load.fail(this.goBack(), isOutOfMemory(error) ? error : undrawable(error));
  }

  protected ended(url: URL | null, error: unknown): void {
    this.#host.ended(this, url, error);
  }

  protected dropped(): void {
    this.#host.dropped(this);
  }

  protected keepsLast(): boolean {
    return this.#host.shown(this);
  }

  /** A shape that was too large as it was shaded before may fit in now. */
  protected reshaded(): void {
    if (!this.#load.failed || this.values.src !== '') return;
    this.#load.retry();
    this.#load.request(this.values);
  }

  /** Ends any load and frees everything. */
  dispose(): void {
    this.#load.drop();
    this.#letGo();
    this.#host.removed(this);
    this.clear();
  }
}

const undrawable = (cause: unknown): ModelError =>
  new ModelError('bad-model', `Drawing failed: ${String(cause)}`, { cause });
