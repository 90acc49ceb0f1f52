// One declared mesh in the scene: follows its values, and shows the last content until the next one
// can be shown.
import type { BufferGeometry, Mesh, Object3D } from 'three';
import type { Shading, ShadingStyle } from '../../../phong/material/material-values.js';
import type { PhongMaterial } from '../../../phong/material/phong-material.js';
import { radians } from '../../../phong/math/angle.js';
import type { Vec3 } from '../../../phong/math/vector.js';
import type { Budget, Claim, Need } from '../../../phong/model/budget.js';
import { isOutOfMemory } from '../../../phong/model/limits.js';
import { type Content, ModelError } from '../../../phong/model/model.js';
import { modelCode } from '../../model/request-model.js';
import { declareReach } from '../../../phong/geometry/bounds.js';
import { type Animations, MeshAnimation, measureReach } from './animation.js';
import { ContentLoad, type LoadHost } from './content-load.js';
import type { MeshState, MeshValues, ShapeValues } from '../../../phong/model/mesh-fields.js';
import { appearanceOf } from '../../../phong/model/appearance.js';
import {
  EMPTY,
  followPose,
  freeShown,
  geometriesOf,
  type Part,
  partsOf,
  rootOf,
  setGeometries,
  showLevel,
  type ShownContent,
} from './parts.js';
import { looksAlike, type SharedMaterials } from './shared-materials.js';
import { FIXED, type Level, levelKey, shapeKey, shapeNeeds } from './shared-shapes.js';
import { effectiveSegments, type GeometryName } from '../../../phong/model/shapes/shapes.js';

/** The picture that a mesh is part of. */
export interface MeshPicture {
  readonly budget: Budget;
  readonly materials: SharedMaterials;
  readonly animations: Animations;
  readonly style: ShadingStyle;
  readonly fit: {
    /** A mesh has moved from where its world matrix is. */
    moved(mesh: Mesh): void;
  };
  /** Another version is to be drawn. */
  invalidate(): void;
  /** Meshes were moved, or show another geometry. */
  reshaped(): void;
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

const ZERO: Vec3 = [0, 0, 0];
const ONE: Vec3 = [1, 1, 1];

export class SceneMesh {
  readonly #state: MeshState;
  readonly #host: MeshHost;
  readonly #load: ContentLoad<SceneMesh>;
  /** Materials of a model that is about to come. */
  readonly #held: PhongMaterial[] = [];
  #parent: Object3D | null = null;
  #shown = EMPTY;
  /** Shown before the present content, which has not been drawn yet. */
  #before: ShownContent | null = null;
  /** There was no memory for flat normals: the shading stays until another one is wanted. */
  #notFlat = false;
  /** Where the root was last put; null for not yet. */
  #placed: Readonly<Pick<MeshValues, 'position' | 'rotation' | 'scale'>> | null = null;
  /** Of the reach of an animation that has begun since the content came. */
  #measuring: AbortController | null = null;
  /** What the geometries were made for; null for not known. */
  #effective: Shading | null = null;

  constructor(state: MeshState, host: MeshHost) {
    this.#state = state;
    this.#host = host;
    this.#load = new ContentLoad<SceneMesh>(this, host);
  }

  /**
   * The mesh in the scene: a three.js mesh, or a group where there are several parts. Null while
   * nothing is shown.
   */
  get root(): Object3D | null {
    return this.#shown.root;
  }

  get parts(): readonly Readonly<Part>[] {
    return this.#shown.parts;
  }

  /** All that it may have drawn: its own, flat copies, and those before the present content. */
  get geometries(): BufferGeometry[] {
    return [...this.parts, ...(this.#before?.parts ?? [])].flatMap(({ mesh, source }) => [
      mesh.geometry,
      source.geometry,
    ]);
  }

  /** What the model is shown without, by the names in it. */
  get missing(): readonly string[] {
    return this.#shown.content.missing ?? [];
  }

  /** The segments of the shape that is shown; null for a model or nothing. */
  get segments(): number | null {
    const { geometry, segments } = this.#values;
    if (this.complete !== 'shape' || geometry === null) return null;
    const { level } = this;
    const drawn =
      this.auto === null || typeof level === 'object' || level === FIXED ? undefined : level;
    return effectiveSegments(geometry, segments === 'auto' ? drawn : segments);
  }

  /** Its `src` is a file of the user's own, not an address. */
  get isOwnFile(): boolean {
    return typeof this.#values.src !== 'string';
  }

  /** The `src` to go back to from a file that cannot be shown. */
  get sourceBefore(): string | Blob {
    return this.#load.sourceBefore;
  }

  /** Its values name something to show. */
  get wanted(): boolean {
    return this.#values.src !== '' || this.#values.geometry !== null;
  }

  /** The code of its shape is being fetched. */
  get awaitsShape(): boolean {
    return this.#load.pending && this.#values.src === '';
  }

  /**
   * What it shows now is what its values name: a model, a shape, or (null) something else, as after
   * a failure.
   */
  get complete(): 'model' | 'shape' | null {
    if (this.root === null || !this.#load.has(this.#values)) return null;
    return this.#shown.url === null ? 'shape' : 'model';
  }

  /** Its number of segments is part of the picture. */
  get isFixed(): boolean {
    return (this.#values.shading ?? this.#picture.style.shading) !== 'phong';
  }

  /** The shape that has automatic segments; null where it shows anything else. */
  get auto(): GeometryName | null {
    return this.#shown.auto;
  }

  get level(): Level {
    return this.#shown.level;
  }

  set level(level: Level) {
    this.#shown = showLevel(this.#shown, level, this.#effective === 'flat');
  }

  get plays(): boolean {
    return this.#shown.animation?.plays ?? false;
  }

  /** Steps of each pose. */
  get work(): number {
    return this.#shown.animation?.work ?? 0;
  }

  advance(seconds: number): void {
    this.#shown.animation?.advance(seconds);
    if (seconds > 0) {
      followPose(this.parts);
    }
  }

  /** Shows it below `parent`, whose world matrix is the identity. */
  attach(parent: Object3D): void {
    this.#parent = parent;
    if (this.root !== null) {
      parent.add(this.root);
    }
  }

  /** Updates the scene to the values. Cheap if nothing has changed. */
  update(): void {
    this.#load.request(this.#values);
    this.#settle();
  }

  /** Updates materials and flat normals after a change of the mesh's own style or the picture's. */
  restyle(): void {
    const shading = this.#reshade();
    for (const part of this.#shown.parts) {
      const appearance = appearanceOf(this.#state, part.source, shading);
      if (looksAlike(appearance, part.appearance)) continue;
      part.material = this.#picture.materials.exchange(part.material, appearance);
      part.mesh.material = part.material;
      part.appearance = appearance;
    }
    this.#picture.invalidate();
  }

  /** After a failure, the next {@link update} requests the same again. */
  retry(): void {
    this.#load.retry();
    this.#forgetNotFlat();
  }

  /** Cancels a load in progress. The next {@link update} requests it again. */
  suspend(): void {
    this.#load.suspend();
  }

  /** The present content has been drawn. */
  drawn(): void {
    if (this.#before !== null) {
      freeShown(this.#before, this.#picture.materials);
    }
    this.#before = null;
  }

  /** The present content could not be drawn: goes back to what was shown before. */
  revert(error: unknown): void {
    const failed = this.#shown;
    this.#replace(this.#before ?? EMPTY);
    this.#pose();
    this.#before = null;
    freeShown(failed, this.#picture.materials);
    this.#effective = null;
    this.#settle();
    const undrawable = new ModelError('bad-model', `Drawing failed: ${String(error)}`, {
      cause: error,
    });
    this.#load.fail(failed.url, isOutOfMemory(error) ? error : undrawable);
  }

  dispose(): void {
    this.#load.drop();
    this.#forgetNotFlat();
    this.#letGo();
    this.#host.removed(this);
    this.#parent = null;
    const before = this.#shown;
    this.#replace(EMPTY);
    freeShown(before, this.#picture.materials);
    this.drawn();
  }

  /** For its load: what a shape will hold before there is a geometry. */
  needsOf(geometry: GeometryName, segments: ShapeValues['segments']): readonly Need[] {
    const isFixed = segments === 'auto' && this.isFixed;
    const key = isFixed ? levelKey(geometry, FIXED) : shapeKey(geometry, segments);
    return shapeNeeds(key, this.#wantedShading === 'flat');
  }

  /** For its load: makes the materials before {@link arrived}, in slices: thousands take long. */
  async prepare({ parts, motion }: Content, signal: AbortSignal): Promise<void> {
    this.#letGo();
    await measureReach(motion, this.#values, signal);
    if (parts.length < MANY_PARTS) return;
    const { Slices } = await modelCode();
    const slices = new Slices(signal);
    await slices.pause(); // the last task of the reader
    await slices.map(parts, (part) => {
      this.#held.push(this.#picture.materials.acquire(appearanceOf(this.#state, part)));
    });
    await slices.pause();
  }

  /** For its load: there is new content, `late` unless at once. `url` is null for a shape. */
  arrived(content: Content, claim: Claim, url: URL | null, late: boolean): void {
    let next: ShownContent;
    try {
      next = this.#prepared(content, claim, url);
    } catch (error) {
      content.dispose();
      claim.release();
      this.#load.fail(url, error);
      return;
    } finally {
      this.#letGo();
    }
    this.#show(next);
    if (!late) return;
    this.#settle();
    this.#host.ended(this, url, null);
  }

  get #values(): MeshState['values'] {
    return this.#state.values;
  }

  get #picture(): MeshPicture {
    return this.#host.picture;
  }

  get #wantedShading(): Shading {
    return this.#picture.materials.geometryShading(this.#values.shading ?? null);
  }

  #letGo(): void {
    for (const material of this.#held.splice(0)) {
      this.#picture.materials.release(material);
    }
  }

  /**
   * Content as it will be in the scene. Throws if there is no memory for it, and changes nothing
   * then.
   */
  #prepared(content: Content, claim: Claim, url: URL | null): ShownContent {
    const { motion } = content;
    const { geometry, segments } = this.#values;
    const animation = motion === null ? null : new MeshAnimation(motion, this.#values);
    const isAuto = url === null && geometry !== null && segments === 'auto';
    // Shapes are called as their geometry is. The values may already name another one.
    const auto = isAuto && content.parts[0]?.name === geometry ? geometry : null;
    const level = (auto === null ? undefined : shapeKey(auto, 'auto').segments) ?? FIXED;
    const geometries = geometriesOf(
      content,
      this.#wantedShading === 'flat',
      auto === null ? claim : null,
    );
    const parts = partsOf(content, geometries, this.#picture.materials, this.#state);
    const root = rootOf(parts, motion !== null);
    return { content, auto, level, claim, parts, root, url, animation };
  }

  /** Replaces what is shown. Call {@link #settle} next. */
  #show(next: ShownContent): void {
    this.#effective = this.#wantedShading;
    const before = this.#shown;
    this.#replace(next);
    this.#forgetNotFlat();
    const kept = next.root !== null && this.#host.shown(this);
    if (kept && this.#before === null) {
      this.#before = before;
    } else {
      freeShown(before, this.#picture.materials); // it was never drawn, or nothing goes back to it
      if (!kept) {
        this.drawn();
      }
    }
  }

  #replace(next: ShownContent): void {
    this.root?.removeFromParent();
    this.#shown = next;
    if (next.root !== null) {
      this.#parent?.add(next.root);
    }
    this.#placed = null; // the new root has no place yet
    this.#measuring?.abort('replaced');
    this.#frame();
    const { meshes } = this.#picture.animations;
    if (next.animation === null) {
      meshes.delete(this);
    } else {
      meshes.add(this);
    }
  }

  /** Shows pose, place and style that the values say. */
  #settle(): void {
    const { animation, parts } = this.#shown;
    if (animation?.update(this.#values) === true) {
      followPose(parts);
      void this.#measure();
    }
    this.#place();
    this.restyle();
  }

  /** Frames the poses of the animation that the values name now, as soon as they are known. */
  async #measure(): Promise<void> {
    const { content, animation } = this.#shown;
    this.#frame();
    this.#measuring?.abort('replaced');
    const { signal } = (this.#measuring = new AbortController());
    const isNew = await measureReach(content.motion, this.#values, signal).catch(() => false);
    if (isNew && this.#shown.animation === animation) {
      this.#frame();
    }
  }

  #frame(): void {
    const { root, animation } = this.#shown;
    if (root === null || animation === null) return;
    declareReach(root, animation.reach);
    this.#picture.reshaped();
  }

  /** Brings what is shown into its present pose. */
  #pose(): void {
    const { animation, parts } = this.#shown;
    animation?.pose();
    if (animation !== null) {
      followPose(parts);
    }
  }

  #place(): void {
    const { name = '', position = ZERO, rotation = ZERO, scale = ONE } = this.#values;
    const [part] = this.parts;
    const { root } = this;
    if (root !== null) {
      root.name = name === '' && part?.mesh === root ? part.source.name : name;
    }
    const last = this.#placed;
    // Values are replaced when they change, so those that are the same need not be written again.
    if (last?.position === position && last.rotation === rotation && last.scale === scale) return;
    this.#placed = { position, rotation, scale };
    root?.position.set(...position);
    root?.rotation.set(radians(rotation[0]), radians(rotation[1]), radians(rotation[2]));
    root?.scale.set(...scale);
    root?.updateMatrix();
    if (last !== null && part?.mesh === root) {
      this.#picture.fit.moved(part.mesh);
    } else {
      this.#picture.reshaped();
    }
  }

  /**
   * Gives the parts the geometries of their shading. Returns that of their materials; null: the
   * picture's.
   */
  #reshade(): Shading | null {
    const { shading = null } = this.#values;
    const wanted = this.#wantedShading;
    if (wanted === 'flat' && this.#notFlat) return this.#effective;
    if (wanted !== this.#effective) {
      try {
        this.#regroup(wanted === 'flat');
        this.#effective = wanted;
        this.#pose(); // a flat copy may be of an earlier pose
      } catch (error) {
        if (this.#effective !== 'flat') {
          this.#shown.claim?.dropFlat();
        }
        this.#notFlat = true;
        this.#host.ended(this, this.#shown.url, error);
        return this.#effective;
      }
    }
    this.#forgetNotFlat();
    return shading;
  }

  /**
   * Shows the geometries with or without separate triangles. Throws if there is no room or no
   * memory for them.
   */
  #regroup(flat: boolean): void {
    const { auto, claim } = this.#shown;
    const needs = auto === null ? null : this.needsOf(auto, 'auto');
    if (auto !== null && needs !== null) {
      claim?.add(needs);
      // Before a flat copy is made of a finer level.
      if (this.isFixed && this.level !== FIXED) {
        this.#shown = showLevel(this.#shown, FIXED, false);
      }
      this.#picture.reshaped(); // another level may be needed
    }
    const { content, parts } = this.#shown;
    setGeometries(parts, geometriesOf(content, flat, needs === null ? claim : null));
    if (needs !== null) {
      claim?.keep(needs);
    } else if (!flat) {
      claim?.dropFlat();
    }
  }

  #forgetNotFlat(): void {
    if (this.#notFlat) {
      this.#host.dropped(this);
    }
    this.#notFlat = false;
  }
}
