// What shows a mesh in the scene: its content, with level of detail, pose, place and style.
import type { Mesh, Object3D } from 'three';
import type { ShadingStyle } from '../../material/material-values.js';
import type { Budget, Claim, Need } from '../../model/budget.js';
import { isOutOfMemory } from '../../model/limits.js';
import type { Content, ContentPart } from '../../model/model.js';
import { type Animated, type Animations, MeshAnimation } from './animation.js';
import type { MeshState, ShapeValues } from './mesh-fields.js';
import {
  appearanceOf,
  dress,
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
  WrittenTransform,
} from './parts.js';
import type { Appearance, SharedMaterials } from './shared-materials.js';
import { FIXED, levelKey, shapeKey, shapeNeeds } from './shapes/shared-shapes.js';
import type { GeometryName, LoadedShape } from './shapes/shapes.js';

/** The picture that it is in. */
export interface MeshPicture {
  readonly materials: SharedMaterials;
  readonly animations: Animations;
  readonly budget: Budget;
  /** The mesh looks different: draw again. */
  invalidate(): void;
  /** The mesh's geometry or place is different: measure again. */
  reshaped(): void;
  readonly fit: {
    /** The mesh, which is this one, was put elsewhere; its world matrix still says where it was. */
    moved(mesh: Mesh): void;
  };
}

type Shading = ShadingStyle['shading'];

export abstract class ShownMesh implements Animated {
  readonly #state: MeshState;
  readonly #picture: MeshPicture;
  #parent: Object3D | null = null;
  #shown = EMPTY;
  /** Shown before the present content, which has not been drawn yet. */
  #before: ShownContent | null = null;
  /** There was no memory for flat normals. Until another shading is wanted, the mesh keeps the one it has. */
  #notFlat = false;
  /** There was no memory for a material: one of the parts does not look as its values say. */
  #notRestyled = false;
  readonly #placement = new WrittenTransform();
  /** As last written to the scene; null for not yet. */
  #shading: Shading | null = null;
  /** What the geometries were made for; null for not known. */
  #effective: Shading | null = null;
  #reflection: ShadingStyle['reflection'] | null = null;

  constructor(state: MeshState, picture: MeshPicture) {
    this.#state = state;
    this.#picture = picture;
  }

  /** What is shown, from `url`, cannot be as the values say. */
  protected abstract ended(url: URL | null, error: unknown): void;
  /** What could not be shown is no longer wanted, or is shown now. */
  protected abstract dropped(): void;
  /** There is new content. True if it will be drawn soon: until then the content before is kept. */
  protected abstract keepsLast(): boolean;
  /** Another shading is shown, which may take less memory. */
  protected abstract reshaded(): void;

  needsOf(geometry: GeometryName, segments: ShapeValues['segments']): readonly Need[] {
    const isFixed = segments === 'auto' && this.isFixed;
    return shapeNeeds(isFixed ? levelKey(geometry, FIXED) : shapeKey(geometry, segments), this.wantsFlat);
  }

  get wantsFlat(): boolean {
    return this.#wantedShading === 'flat';
  }

  /** Its number of segments is part of the picture. */
  get isFixed(): boolean {
    return this.#ownShading !== 'phong';
  }

  /** The shape that has automatic segments; null where it shows anything else. */
  get auto(): LoadedShape | null {
    return this.#shown.auto;
  }

  /** The segments of {@link auto}, or `FIXED`. */
  get level(): number {
    return this.#shown.level;
  }

  /** Shows another level of {@link auto}. Where there is no memory for it the level stays. */
  set level(level: number) {
    const { auto } = this;
    if (auto === null) return;
    try {
      this.#shown = showLevel(this.#shown, auto, level, this.#effective === 'flat');
    } catch (error) {
      if (!isOutOfMemory(error)) throw error;
    }
  }

  /** The mesh in the scene: a three.js mesh, or a group where there are several parts. Null while nothing is shown. */
  get root(): Object3D | null {
    return this.#shown.root;
  }

  /** Shows it below `parent`, whose world matrix is the identity. */
  attach(parent: Object3D): void {
    this.#parent = parent;
    if (this.root !== null) parent.add(this.root);
  }

  /** What the model is shown without, by the names in it. */
  get missing(): readonly string[] {
    return this.#shown.content.missing ?? [];
  }

  /** The three.js meshes that show it, each with its material. */
  get parts(): readonly Readonly<Part>[] {
    return this.#shown.parts;
  }

  get plays(): boolean {
    return this.#shown.animation?.plays ?? false;
  }

  advance(seconds: number): void {
    this.#shown.animation?.advance(seconds);
    if (seconds > 0) followPose(this.parts);
  }

  /** The present content has been drawn. */
  drawn(): void {
    if (this.#before !== null) freeShown(this.#before, this.#picture.materials);
    this.#before = null;
  }

  protected get values(): MeshState['values'] {
    return this.#state.values;
  }

  /** Where the model that is shown came from; null for a shape. */
  protected get url(): URL | null {
    return this.#shown.url;
  }

  /** Shows pose, place and style that the values say. */
  protected settle(): void {
    const { animation, parts } = this.#shown;
    if (animation?.update(this.values) === true) followPose(parts);
    this.#place();
    this.restyle();
  }

  /** Goes back to what was shown before the present content, and frees that. Returns where it came from. */
  protected goBack(): URL | null {
    const failed = this.#shown;
    this.#replace(this.#before ?? EMPTY);
    this.#pose();
    this.#before = null;
    freeShown(failed, this.#picture.materials);
    this.#effective = null;
    this.settle();
    return failed.url;
  }

  /** Shows nothing from now on. */
  protected clear(): void {
    this.#parent = null;
    const before = this.#shown;
    this.#replace(EMPTY);
    freeShown(before, this.#picture.materials);
    this.drawn();
  }

  /** Updates materials and flat normals after a change of the mesh's own style or the picture's. */
  restyle(): void {
    const { reflection = null } = this.values;
    const shading = this.#reshade();
    const restyled = shading !== this.#shading || reflection !== this.#reflection;
    this.#shading = shading;
    this.#reflection = reflection;
    let failure: unknown = null;
    let exchanged = false;
    for (const part of this.#shown.parts) {
      const appearance = this.appearanceOf(part.source, { shading, reflection });
      try {
        if (dress(part, appearance, this.#picture.materials, restyled)) exchanged = true;
      } catch (error) {
        failure = error;
      }
    }
    if (failure !== null) this.ended(this.url, failure);
    else if (exchanged && this.#notRestyled) this.dropped();
    if (failure !== null || exchanged) this.#notRestyled = failure !== null;
    this.#picture.invalidate();
  }

  /**
   * Gives the parts the geometries that their shading needs. Returns the shading for their materials; null for the
   * picture's.
   */
  #reshade(): Shading | null {
    const { shading = null } = this.values;
    const wanted = this.#wantedShading;
    if (wanted === 'flat' && this.#notFlat) return this.#effective;
    if (wanted !== this.#effective) {
      try {
        this.#regroup(wanted === 'flat');
        const was = this.#effective;
        this.#effective = wanted;
        // A shape that was too large as it was shaded before may fit in now.
        if (was !== null) this.reshaded();
        this.#pose(); // a flat copy may be of an earlier pose
      } catch (error) {
        if (this.#effective !== 'flat') this.#shown.claim?.dropFlat();
        this.#notFlat = true;
        this.ended(this.url, error);
        return this.#effective;
      }
    }
    this.forgetNotFlat();
    return shading;
  }

  /** Shows the geometries with or without separate triangles. Throws if there is no room or no memory for them. */
  #regroup(flat: boolean): void {
    const { auto, claim } = this.#shown;
    const needs = auto === null ? null : this.needsOf(auto, 'auto');
    if (auto !== null && needs !== null) {
      claim?.add(needs);
      // Before a flat copy is made of a finer level.
      if (this.isFixed && this.level !== FIXED) this.#shown = showLevel(this.#shown, auto, FIXED, false);
      this.#picture.reshaped(); // another level may be needed
    }
    const { content, parts } = this.#shown;
    setGeometries(parts, geometriesOf(content, flat, needs === null ? claim : null));
    if (needs !== null) claim?.keep(needs);
    else if (!flat) claim?.dropFlat();
  }

  /** Brings what is shown into its present pose. */
  #pose(): void {
    const { animation, parts } = this.#shown;
    animation?.pose();
    if (animation !== null) followPose(parts);
  }

  protected forgetNotFlat(): void {
    if (this.#notFlat) this.dropped();
    this.#notFlat = false;
  }

  get #ownShading(): Shading {
    return this.values.shading ?? this.#picture.materials.style.shading;
  }

  get #wantedShading(): Shading {
    return this.#picture.materials.geometryShading(this.values.shading ?? null);
  }

  /** In the style that its values, not the picture, say. */
  protected appearanceOf(source: ContentPart, style: Pick<Appearance, 'shading' | 'reflection'>): Appearance {
    return appearanceOf(this.#state, source, style);
  }

  #place(): void {
    const { name = '' } = this.values;
    const [part] = this.parts;
    const { root } = this;
    if (root !== null) root.name = name === '' && part?.mesh === root ? part.source.name : name;
    const { known } = this.#placement;
    if (!this.#placement.put(root, this.values)) return;
    if (known && part?.mesh === root) this.#picture.fit.moved(part.mesh);
    else this.#picture.reshaped();
  }

  /** Content as it will be in the scene. Throws if there is no memory for it, and changes nothing then. */
  protected prepared(content: Content, claim: Claim, url: URL | null): ShownContent {
    const { motion } = content;
    const { shading = null, reflection = null } = this.values;
    const animation = motion === null ? null : new MeshAnimation(motion, this.values);
    const { geometry, segments } = this.values;
    const isAuto = url === null && geometry !== null && segments === 'auto';
    // Shapes are called as their geometry is. The values may already name another one. Its code came with its content.
    const auto = isAuto && content.parts[0]?.name === geometry ? (geometry as LoadedShape) : null;
    const level = (auto === null ? undefined : shapeKey(auto, 'auto').segments) ?? FIXED;
    const geometries = geometriesOf(content, this.wantsFlat, auto === null ? claim : null);
    const parts = partsOf(content, geometries, this.#picture.materials, (source) =>
      this.appearanceOf(source, { shading, reflection }),
    );
    const root = rootOf(parts, motion !== null);
    return { content, auto, level, claim, parts, root, url, animation };
  }

  /** Replaces what is shown. Call {@link settle} next. */
  protected show(next: ShownContent): void {
    this.#effective = this.#wantedShading;
    this.#shading = this.values.shading ?? null;
    this.#reflection = this.values.reflection ?? null;
    const before = this.#shown;
    this.#replace(next);
    this.forgetNotFlat();
    const kept = next.root !== null && this.keepsLast();
    if (kept && this.#before === null) {
      this.#before = before;
    } else {
      freeShown(before, this.#picture.materials); // it was never drawn, or nothing goes back to it
      if (!kept) this.drawn();
    }
  }

  #replace(next: ShownContent): void {
    this.root?.removeFromParent();
    this.#shown = next;
    if (next.root !== null) this.#parent?.add(next.root);
    this.#placement.forget(); // the new root has no place yet
    if (next.animation === null) this.#picture.animations.delete(this);
    else this.#picture.animations.add(this);
  }
}
