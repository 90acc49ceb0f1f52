// One content in the scene: the parts that show it, with the geometries of their shading or level,
// their materials, their place and their pose.
import type { Object3D } from 'three';
import { radians } from '../../../phong/math/angle.js';
import type { Vec3 } from '../../../phong/math/vector.js';
import type { Shading, ShadingStyle } from '../../../phong/material/material-values.js';
import type { Claim, Need } from '../../../phong/model/budget.js';
import type { Content, PlayedAnimation } from '../../../phong/model/model.js';
import type { MeshState, MeshValues, ShapeValues } from '../../../phong/model/mesh-fields.js';
import { appearanceOf } from '../../../phong/model/appearance.js';
import { geometriesOf, type Part, partsOf, releaseParts, rootOf, setGeometries } from './parts.js';
import type { SharedMaterials } from './shared-materials.js';
import {
  acquireShape,
  FIXED,
  type Level,
  levelKey,
  type ShapeContent,
  shapeKey,
  shapeNeeds,
} from './shared-shapes.js';
import type { GeometryName } from '../../../phong/model/shapes/shapes.js';

/** The picture that content is shown in. */
export interface ContentPicture {
  readonly materials: SharedMaterials;
  readonly style: ShadingStyle;
  /** Meshes show another geometry; `moved`: this one was only moved. */
  reshaped(moved?: Object3D): void;
}

const ZERO: Vec3 = [0, 0, 0];
const ONE: Vec3 = [1, 1, 1];

export class ShownContent {
  readonly parts: readonly Part[];
  /** A three.js mesh, or a group where there are several parts. Null where there is nothing. */
  readonly root: Object3D | null;
  /** Null where nothing in it moves. */
  readonly animation: PlayedAnimation | null;
  /** The shape that has automatic segments; null where it is anything else. */
  readonly auto: GeometryName | null;
  /** Where a model came from; null for a shape. */
  readonly url: URL | null;
  #content: Content;
  readonly #claim: Claim | null;
  readonly #state: MeshState;
  readonly picture: ContentPicture;
  #level: Level;
  /** What the geometries are for. */
  #shading: Shading;
  /** Where the root was last put; null for not yet. */
  #placed: Readonly<Pick<MeshValues, 'position' | 'rotation' | 'scale'>> | null = null;

  /**
   * `claim`: what the content holds of its viewer's budget. Throws if there is no memory to show it,
   * and has taken nothing then.
   */
  constructor(
    content: Content,
    claim: Claim | null,
    url: URL | null,
    state: MeshState,
    picture: ContentPicture,
  ) {
    this.#content = content;
    this.#claim = claim;
    this.url = url;
    this.#state = state;
    this.picture = picture;
    const { values } = state;
    const { motion } = content;
    const { geometry, segments } = values;
    const isAuto = url === null && geometry !== null && segments === 'auto';
    // Shapes are called as their geometry is. The values may already name another one.
    const auto = (this.auto = isAuto && content.parts[0]?.name === geometry ? geometry : null);
    this.#level = (auto === null ? undefined : shapeKey(auto, 'auto').segments) ?? FIXED;
    const shading = (this.#shading = shadingOf(state, picture));
    // Before anything measures the content.
    if (values.autoplay) {
      motion?.pose(values.animationName, 0);
    }
    const geometries = geometriesOf(content, shading === 'flat', auto === null ? claim : null);
    this.parts = partsOf(content, geometries, picture.materials, state);
    this.root = rootOf(this.parts, motion !== null);
    this.animation = motion?.play(values, this) ?? null;
  }

  /** What a model is shown without, by the names in it. */
  get missing(): readonly string[] {
    return this.#content.missing ?? [];
  }

  /** What the geometries are for: {@link wanted}, unless {@link reshade} has thrown. */
  get shading(): Shading {
    return this.#shading;
  }

  /** What they should be for, by the values and the picture. */
  get wanted(): Shading {
    return shadingOf(this.#state, this.picture);
  }

  /** Its number of segments is part of the picture. */
  get isFixed(): boolean {
    return isFixed(this.#state, this.picture);
  }

  /** The segments of {@link auto}, or `FIXED`, or how its faces are cut. */
  get level(): Level {
    return this.#level;
  }

  set level(level: Level) {
    this.#showLevel(level, this.#shading === 'flat');
  }

  /**
   * Shows the geometries of the {@link wanted} shading. Throws if there is no room or no memory for
   * them: it shows those before then.
   */
  reshade(): void {
    const { wanted } = this;
    if (wanted === this.#shading) return;
    try {
      this.#regroup(wanted === 'flat');
      this.#shading = wanted;
      this.animation?.pose(); // a flat copy may be of an earlier pose
    } catch (error) {
      if (this.#shading !== 'flat') {
        this.#claim?.dropFlat();
      }
      throw error;
    }
  }

  /** Shows the materials of the values. `shading`: null for the picture's. */
  restyle(shading: Shading | null): void {
    for (const part of this.parts) {
      const appearance = appearanceOf(this.#state, part.source, shading);
      const material = this.picture.materials.exchange(part.material, appearance);
      if (material === part.material) continue;
      part.material = part.mesh.material = material;
    }
  }

  /** Moves it to where the values say. */
  moveToValues(): void {
    const { root } = this;
    if (root === null) return;
    const { name = '', position = ZERO, rotation = ZERO, scale = ONE } = this.#state.values;
    const [{ mesh, source }] = this.parts as [Part];
    root.name = name === '' && mesh === root ? source.name : name;
    const last = this.#placed;
    // Values are replaced when they change, so those that are the same need not be written again.
    if (last?.position === position && last.rotation === rotation && last.scale === scale) return;
    this.#placed = { position, rotation, scale };
    root.position.set(...position);
    root.rotation.set(radians(rotation[0]), radians(rotation[1]), radians(rotation[2]));
    root.scale.set(...scale);
    root.updateMatrix();
    this.picture.reshaped(root);
  }

  /** Call after the next one is there: equal looks keep their material, and so their program. */
  free(): void {
    this.animation?.dispose();
    releaseParts(this.parts, this.picture.materials);
    this.#content.dispose();
    this.#claim?.release();
  }

  /** Shows another level of the shape. Its bounds are the same. */
  #showLevel(level: Level, flat: boolean): void {
    const content = acquireShape(levelKey(this.auto!, level)) as ShapeContent; // its code is here: it is no promise
    setGeometries(this.parts, content, geometriesOf(content, flat, null));
    this.#content.dispose();
    this.#content = content;
    this.#level = level;
  }

  /** Shows the geometries with or without separate triangles. */
  #regroup(flat: boolean): void {
    const { auto } = this;
    const claim = this.#claim;
    const needs = auto === null ? null : needsOf(auto, 'auto', this.#state, this.picture);
    if (needs !== null) {
      claim?.add(needs);
      // Before a flat copy is made of a finer level.
      if (this.isFixed && this.#level !== FIXED) {
        this.#showLevel(FIXED, false);
      }
      this.picture.reshaped(); // another level may be needed
    }
    const content = this.#content;
    setGeometries(this.parts, content, geometriesOf(content, flat, needs === null ? claim : null));
    if (needs !== null) {
      claim?.keep(needs);
    } else if (!flat) {
      claim?.dropFlat();
    }
  }
}

/** What a shape will hold before there is a geometry. */
export function needsOf(
  name: GeometryName,
  segments: ShapeValues['segments'],
  state: MeshState,
  picture: ContentPicture,
): readonly Need[] {
  const isOwn = segments === 'auto' && isFixed(state, picture);
  const key = isOwn ? levelKey(name, FIXED) : shapeKey(name, segments);
  return shapeNeeds(key, shadingOf(state, picture) === 'flat');
}

/** The shading that geometries are for. */
const shadingOf = ({ values }: MeshState, { materials }: ContentPicture): Shading =>
  materials.geometryShading(values.shading ?? null);

const isFixed = ({ values }: MeshState, { style }: ContentPicture): boolean =>
  (values.shading ?? style.shading) !== 'phong';
