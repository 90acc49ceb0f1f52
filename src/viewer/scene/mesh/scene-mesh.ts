// One declared mesh in the scene: follows its values, and shows the last content until the next one
// can be shown.
import type { BufferGeometry, Object3D } from 'three';
import type { Shading } from '../../../phong/material/material-values.js';
import type { PhongMaterial } from '../../../phong/material/phong-material.js';
import type { Budget, Claim, Need } from '../../../phong/model/budget.js';
import { isOutOfMemory } from '../../../phong/model/limits.js';
import { type Content, ModelError } from '../../../phong/model/model.js';
import { modelCode } from '../../model/request-model.js';
import type { Animations } from './animations.js';
import { ContentLoad, type LoadHost } from './content-load.js';
import type { MeshState, ShapeValues } from '../../../phong/model/mesh-fields.js';
import { appearanceOf } from '../../../phong/model/appearance.js';
import { FIXED } from './shared-shapes.js';
import { effectiveSegments, type GeometryName } from '../../../phong/model/shapes/shapes.js';
import { type ContentPicture, needsOf, ShownContent } from './shown-content.js';

/** The picture that a mesh is part of. */
interface MeshPicture extends ContentPicture {
  readonly budget: Budget;
  readonly animations: Animations;
  /** What each mesh shows at first. */
  readonly nothing: ShownContent;
  /** Another version is to be drawn. */
  invalidate(): void;
}

export interface MeshHost extends LoadHost<SceneMesh> {
  readonly picture: MeshPicture;
  /**
   * It has content that was not drawn yet. True if it will be soon: the content before is kept
   * until then.
   */
  shown(mesh: SceneMesh): boolean;
  removed(mesh: SceneMesh): void;
}

/** Models with fewer parts get their materials at once. */
const MANY_PARTS = 256;

export class SceneMesh {
  readonly load: ContentLoad<SceneMesh>;
  readonly #state: MeshState;
  readonly #host: MeshHost;
  /** Materials of a model that is about to come. */
  readonly #held: PhongMaterial[] = [];
  #parent: Object3D | null = null;
  #shown: ShownContent;
  /** Shown before the present content, which has not been drawn yet. */
  #before: ShownContent | null = null;
  /** There was no memory for flat normals: the shading stays until another one is wanted. */
  #notFlat = false;

  constructor(state: MeshState, host: MeshHost) {
    this.#state = state;
    this.#host = host;
    this.#shown = host.picture.nothing;
    this.load = new ContentLoad<SceneMesh>(this, host);
  }

  get values(): MeshState['values'] {
    return this.#state.values;
  }

  /** What it shows now, which need not be what its values name. */
  get shown(): ShownContent {
    return this.#shown;
  }

  /** All that it may have drawn, those before the present content included. */
  get geometries(): BufferGeometry[] {
    return [...this.#shown.parts, ...(this.#before?.parts ?? [])].flatMap(({ mesh, source }) => [
      mesh.geometry,
      source.geometry,
    ]);
  }

  /** The segments of the shape that is shown; null for a model or nothing. */
  get segments(): number | null {
    const { geometry, segments } = this.values;
    if (this.complete !== 'shape' || geometry === null) return null;
    const { auto, level } = this.#shown;
    const drawn = auto === null || typeof level === 'object' || level === FIXED ? undefined : level;
    return effectiveSegments(geometry, segments === 'auto' ? drawn : segments);
  }

  /** Its `src` is a file of the user's own, not an address. */
  get isOwnFile(): boolean {
    return typeof this.values.src !== 'string';
  }

  /**
   * What it shows now is what its values name: a model, a shape, or (null) something else, as after
   * a failure.
   */
  get complete(): 'model' | 'shape' | null {
    const { root, url } = this.#shown;
    if (root === null || !this.load.has(this.values)) return null;
    return url === null ? 'shape' : 'model';
  }

  /** Shows it below `parent`, whose world matrix is the identity. */
  attach(parent: Object3D): void {
    this.#parent = parent;
    this.#replace(this.#shown);
  }

  /** Updates the scene to the values. Cheap if nothing has changed. */
  update(): void {
    this.load.request(this.values);
    this.#settle();
  }

  /** Updates materials and flat normals after a change of the mesh's own style or the picture's. */
  restyle(): void {
    this.#shown.restyle(this.#reshade());
    this.#host.picture.invalidate();
  }

  /** After a failure, the next {@link update} requests the same again. */
  retry(): void {
    this.load.retry();
    this.#forgetNotFlat();
  }

  /** The present content has been drawn. */
  drawn(): void {
    this.#before?.free();
    this.#before = null;
  }

  /** The present content could not be drawn: goes back to what was shown before. */
  revert(error: unknown): void {
    const failed = this.#shown;
    this.#replace(this.#before ?? this.#host.picture.nothing);
    this.#before = null;
    this.#shown.animation?.pose();
    failed.free();
    this.#settle();
    const undrawable = new ModelError('bad-model', `Drawing failed: ${String(error)}`, {
      cause: error,
    });
    this.load.fail(failed.url, isOutOfMemory(error) ? error : undrawable);
  }

  /** Takes it out of the scene for good, and frees what it holds. */
  dispose(): void {
    this.load.drop();
    this.#forgetNotFlat();
    this.#letGo();
    this.#host.removed(this);
    this.#parent = null;
    const before = this.#shown;
    this.#replace(this.#host.picture.nothing);
    before.free();
    this.drawn(); // nothing goes back to what was shown before that
  }

  /** For its load: what a shape will hold before there is a geometry. */
  needsOf(geometry: GeometryName, segments: ShapeValues['segments']): readonly Need[] {
    return needsOf(geometry, segments, this.#state, this.#host.picture);
  }

  /** For its load: makes the materials before {@link arrived}, in slices: thousands take long. */
  async prepare({ parts, motion }: Content, signal: AbortSignal): Promise<void> {
    this.#letGo();
    const { autoplay, animationName } = this.values;
    if (autoplay) {
      await motion?.reach(animationName, signal);
    }
    if (parts.length < MANY_PARTS) return;
    const { Slices } = await modelCode();
    const slices = new Slices(signal);
    await slices.pause(); // the last task of the reader
    await slices.map(parts, (part) => {
      this.#held.push(this.#host.picture.materials.acquire(appearanceOf(this.#state, part)));
    });
    await slices.pause();
  }

  /** For its load: there is new content, `late` unless at once. `url` is null for a shape. */
  arrived(content: Content, claim: Claim, url: URL | null, late: boolean): void {
    let next: ShownContent;
    try {
      next = new ShownContent(content, claim, url, this.#state, this.#host.picture);
    } catch (error) {
      content.dispose();
      claim.release();
      this.load.fail(url, error);
      return;
    } finally {
      this.#letGo();
    }
    this.#show(next);
    if (!late) return;
    this.#settle();
    this.#host.ended(this, url, null);
  }

  #letGo(): void {
    for (const material of this.#held.splice(0)) {
      this.#host.picture.materials.release(material);
    }
  }

  /** Replaces what is shown. Call {@link #settle} next. */
  #show(next: ShownContent): void {
    const before = this.#shown;
    this.#replace(next);
    this.#forgetNotFlat();
    const kept = next.root !== null && this.#host.shown(this);
    if (kept && this.#before === null) {
      this.#before = before;
    } else {
      before.free(); // it was never drawn, or nothing goes back to it
      if (!kept) {
        this.drawn();
      }
    }
  }

  #replace(next: ShownContent): void {
    const { animations } = this.#host.picture;
    const { root, animation } = this.#shown;
    root?.removeFromParent();
    if (animation !== null) {
      animations.all.delete(animation);
    }
    this.#shown = next;
    if (next.root !== null) {
      this.#parent?.add(next.root);
    }
    if (next.animation !== null) {
      animations.all.add(next.animation);
    }
    this.#host.picture.reshaped();
  }

  /** Shows pose, place and style that the values say. */
  #settle(): void {
    this.#shown.animation?.update(this.values);
    this.#shown.moveToValues();
    this.restyle();
  }

  /**
   * Gives the parts the geometries of their shading. Returns that of their materials; null: the
   * picture's.
   */
  #reshade(): Shading | null {
    const shown = this.#shown;
    if (this.#notFlat && shown.wanted === 'flat') return shown.shading;
    try {
      shown.reshade();
    } catch (error) {
      this.#notFlat = true;
      this.#host.ended(this, shown.url, error);
      return shown.shading;
    }
    this.#forgetNotFlat();
    return this.values.shading ?? null;
  }

  #forgetNotFlat(): void {
    if (this.#notFlat) {
      this.#host.dropped(this);
    }
    this.#notFlat = false;
  }
}
