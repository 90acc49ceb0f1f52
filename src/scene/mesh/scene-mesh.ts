// One declared mesh in the scene: follows its values, loads what they name, and keeps showing the last content until the next
// one is there and can be shown. Knows neither elements nor frames.
import type { BufferGeometry, Object3D } from 'three';
import type { Animated, Animations } from '../animations.js';
import type { ShadingStyle } from '../../material/phong-material.js';
import type { FieldStore } from '../../fields/field-store.js';
import type { Vec3 } from '../../math/vector.js';
import { ModelError } from '../model/model.js';
import { isOutOfMemory } from '../out-of-memory.js';
import { MeshAnimation } from './animation.js';
import { ContentLoad, type ContentOwner, type LoadHost } from './content-load.js';
import type { Content, ContentPart } from './content.js';
import type { MeshValues, ShapeValues } from './mesh-fields.js';
import {
  EMPTY,
  followPose,
  geometriesOf,
  lookOf,
  partsOf,
  type Part,
  placeRoot,
  rootOf,
  sameSurface,
  type Shown,
  surfaceOf,
} from './parts.js';
import type { Appearance, SharedMaterials } from './shared-materials.js';

/** The picture that shows a mesh. */
export interface MeshHost extends LoadHost<SceneMesh> {
  readonly materials: SharedMaterials;
  readonly animations: Animations;
  /** The mesh looks different: draw again. */
  changed(): void;
  /** The mesh's geometry or place is different: measure again. */
  reshaped(): void;
  /** The mesh has new content, which has not been drawn yet. True if it will be drawn soon: until then the content before is kept. */
  shown(mesh: SceneMesh): boolean;
  /** The mesh was removed from the scene. */
  removed(mesh: SceneMesh): void;
}

type Shading = ShadingStyle['shading'];

type Values = Readonly<ShapeValues & Partial<Omit<MeshValues, keyof ShapeValues>>>;

export class SceneMesh implements Animated, ContentOwner {
  readonly #state: FieldStore<ShapeValues> | FieldStore<MeshValues>;
  readonly #host: MeshHost;
  readonly #load: ContentLoad<SceneMesh>;
  #parent: Object3D | null = null;
  #shown = EMPTY;
  /** Shown before the present content, which has not been drawn yet. */
  #before: Shown | null = null;
  /** There was no memory for flat normals. Until another shading is wanted, the mesh keeps the one it has. */
  #notFlat = false;
  /** As last written to the scene; null for not yet. Values are replaced when they change. */
  #position: Vec3 | null = null;
  #rotation: Vec3 | null = null;
  #scale: Vec3 | null = null;
  #shading: Shading | null = null;
  /** What the geometries were made for; null for not known. */
  #effective: Shading | null = null;
  #reflection: ShadingStyle['reflection'] | null = null;

  constructor(state: FieldStore<ShapeValues> | FieldStore<MeshValues>, host: MeshHost) {
    this.#state = state;
    this.#host = host;
    this.#load = new ContentLoad<SceneMesh>(this, host);
  }

  arrived(content: Content, url: URL | null, late: boolean): void {
    if (!this.#show(content, url) || !late) return;
    this.#place();
    this.restyle();
    this.#host.ended(this, url, null);
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

  get #values(): Values {
    return this.#state.values;
  }

  /** Its values name something to show. */
  get wanted(): boolean {
    return this.#values.src !== '' || this.#values.geometry !== null;
  }

  /** What it shows now is what its values name: a model, a shape, or (null) something else, as after a failure. */
  get complete(): 'model' | 'shape' | null {
    if (this.root === null || !this.#load.has(this.#values)) return null;
    return this.#shown.url === null ? 'shape' : 'model';
  }

  /** The three.js meshes that show it, each with its material. */
  get parts(): readonly Readonly<Part>[] {
    return this.#shown.parts;
  }

  /** Updates the scene to the values. Cheap if nothing has changed. */
  update(): void {
    this.#load.request(this.#values);
    const { animation, parts } = this.#shown;
    if (animation?.update(this.#values) === true) followPose(parts);
    this.#place();
    this.restyle();
  }

  get plays(): boolean {
    return this.#shown.animation?.plays ?? false;
  }

  advance(seconds: number): void {
    this.#shown.animation?.advance(seconds);
    if (seconds > 0) followPose(this.parts);
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
    if (this.#before !== null) this.#free(this.#before);
    this.#before = null;
  }

  /** The present content could not be drawn: goes back to what was shown before. */
  revert(error: unknown): void {
    const failed = this.#shown;
    this.#replace(this.#before ?? EMPTY);
    this.#pose();
    this.#before = null;
    this.#free(failed);
    this.#effective = null;
    this.#place();
    this.restyle();
    this.#load.fail(failed.url, isOutOfMemory(error) ? error : undrawable(error));
  }

  /** Updates materials and flat normals after a change of the mesh's own style or the picture's. */
  restyle(): void {
    const { reflection = null } = this.#values;
    const { materials } = this.#host;
    const shading = this.#reshade();
    const restyled = shading !== this.#shading || reflection !== this.#reflection;
    this.#shading = shading;
    this.#reflection = reflection;
    for (const part of this.#shown.parts) {
      const appearance = this.#appearanceOf(part.source);
      const { look, surface } = appearance;
      if (restyled || look !== part.look || !sameSurface(surface, part.surface)) {
        part.look = look;
        part.surface = surface;
        part.material = materials.exchange(part.material, appearance);
        part.mesh.material = part.material;
      }
    }
    this.#host.changed();
  }

  /** Gives the parts the geometries that their shading needs. Returns the shading for their materials; null for the picture's. */
  #reshade(): Shading | null {
    const { shading = null } = this.#values;
    const wanted = this.#wantedShading;
    if (wanted === 'flat' && this.#notFlat) return this.#effective;
    if (wanted !== this.#effective) {
      try {
        const geometries = geometriesOf(this.#shown.content.parts, wanted === 'flat');
        this.parts.forEach(({ mesh }, i) => {
          mesh.geometry = geometries[i]!;
        });
        this.#effective = wanted;
        this.#pose(); // a flat copy may be of an earlier pose
      } catch (error) {
        this.#notFlat = true;
        this.#host.ended(this, this.#shown.url, error);
        return this.#effective;
      }
    }
    this.#forgetNotFlat();
    return shading;
  }

  /** Brings what is shown into its present pose. */
  #pose(): void {
    const { animation, parts } = this.#shown;
    animation?.pose();
    if (animation !== null) followPose(parts);
  }

  #forgetNotFlat(): void {
    if (this.#notFlat) this.#host.dropped(this);
    this.#notFlat = false;
  }

  get #wantedShading(): Shading {
    return this.#host.materials.geometryShading(this.#values.shading ?? null);
  }

  /** Ends any load and frees everything. */
  dispose(): void {
    this.#load.drop();
    this.#host.removed(this);
    this.#parent = null;
    const before = this.#shown;
    this.#replace(EMPTY);
    this.#free(before);
    this.drawn();
  }

  #appearanceOf(source: ContentPart): Appearance {
    const state = this.#state as FieldStore<ShapeValues>;
    const look = lookOf(state, source);
    const surface = surfaceOf(state, source);
    const { sides } = source;
    return { look, sides, surface, shading: this.#shading, reflection: this.#reflection };
  }

  #place(): void {
    const { position = ZERO, rotation = ZERO, scale = ONE, name = '' } = this.#values;
    const [part] = this.parts;
    const { root } = this;
    if (root !== null) root.name = name === '' && part?.mesh === root ? part.source.name : name;
    if (position === this.#position && rotation === this.#rotation && scale === this.#scale) return;
    this.#position = position;
    this.#rotation = rotation;
    this.#scale = scale;
    if (root !== null) placeRoot(root, position, rotation, scale);
    this.#host.reshaped();
  }

  /**
   * Replaces what is shown, unless there is no memory for the new content: then everything stays as it was. Call {@link #place} and
   * {@link restyle} next.
   */
  #show(content: Content, url: URL | null): boolean {
    const { motion } = content;
    const animation = motion === null ? null : new MeshAnimation(motion, this.#values);
    let geometries: readonly BufferGeometry[];
    try {
      geometries = geometriesOf(content.parts, this.#wantedShading === 'flat');
    } catch (error) {
      content.dispose();
      this.#load.fail(url, error);
      return false;
    }
    this.#effective = this.#wantedShading;
    const { shading = null, reflection = null } = this.#values;
    this.#shading = shading;
    this.#reflection = reflection;
    const parts = partsOf(content, geometries, this.#host.materials, (source) => this.#appearanceOf(source));
    const next = { content, parts, root: rootOf(parts, motion !== null), url, animation };
    const before = this.#shown;
    this.#replace(next);
    this.#forgetNotFlat();
    const kept = next.root !== null && this.#host.shown(this);
    if (kept && this.#before === null) {
      this.#before = before;
    } else {
      this.#free(before); // it was never drawn, or nothing goes back to it
      if (!kept) this.drawn();
    }
    return true;
  }

  #replace(next: Shown): void {
    this.root?.removeFromParent();
    this.#shown = next;
    if (next.root !== null) this.#parent?.add(next.root);
    this.#position = null; // the new root has no place yet
    if (next.animation === null) this.#host.animations.delete(this);
    else this.#host.animations.add(this);
  }

  /** After the next ones are acquired: equal looks keep their material, and so their program. */
  #free({ content, parts }: Shown): void {
    for (const { material } of parts) this.#host.materials.release(material);
    content.dispose();
  }
}

const undrawable = (cause: unknown): ModelError =>
  new ModelError('bad-model', `Drawing failed: ${String(cause)}`, { cause });

const ZERO: Vec3 = [0, 0, 0];
const ONE: Vec3 = [1, 1, 1];
