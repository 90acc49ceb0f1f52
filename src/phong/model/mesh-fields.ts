// The values that a mesh declares, with domains and defaults, in HTML's units.
import { LIMITS } from '../light/light-state.js';
import {
  SURFACE_FIELDS,
  type SurfaceValues,
  type Reflection,
  REFLECTIONS,
  type Shading,
  SHADINGS,
} from '../material/material-values.js';
import type { Fields } from '../fields/field-store.js';
import {
  type Field,
  choiceField,
  numberField,
  optional,
  orAuto,
  presenceField,
  scaleField,
  textField,
  vectorField,
} from '../fields/field.js';
import type { Vec3 } from '../math/vector.js';
import { GEOMETRIES, type GeometryName } from './shapes/shapes.js';
import { MODEL_TYPES, type ModelType } from './format-names.js';

/** Where a mesh's triangles come from. `src` wins if both are given. */
export interface ShapeValues extends SurfaceValues {
  /**
   * URL of a model, relative to the page, used instead of `geometry`; or a `Blob` or `File` that
   * holds one (property only). Empty for none.
   */
  src: string | Blob;
  /**
   * Format of `src`, where content, extension and server do not tell: `obj` or `model/obj`, for
   * example. Default null.
   */
  type: ModelType | null;
  /**
   * A built-in shape, centred on the origin: `box` (1 × 1 × 1), `sphere` (⌀ 1), `cylinder`, `cone`
   * and `pyramid` (⌀ 1, height 1), `torus` (outer ⌀ 1), `torus-knot` and `teapot` (in a unit box),
   * `plane` (1 × 1, facing +y). Null for none.
   */
  geometry: GeometryName | null;
  /**
   * Segments around the shape, 1–512, or `auto`: under Phong shading as many as a round shape's
   * outline (1/4 of a device pixel) and the shading of its faces (one code) need and its pixels
   * allow, 1 for shapes with flat faces; else the shape's own number. Framing and zoom measure the
   * round shape. Default auto.
   */
  segments: number | 'auto';
  /**
   * Plays the model's animation in a loop while it is in view, unless the user prefers reduced
   * motion. Default false.
   */
  autoplay: boolean;
  /** The animation that `autoplay` plays, by its name in the file. Default empty: the first one. */
  animationName: string;
}

export interface MeshValues extends ShapeValues {
  /** Shown in the panel and in explanations. */
  name: string;
  /** Place of its origin, in scene units. Default 0 0 0. */
  position: Vec3;
  /** Degrees about x, y, z: three.js's Euler order XYZ, right-handed. Default 0 0 0. */
  rotation: Vec3;
  /** Factors along the mesh's own axes, one or three; negative ones mirror. Default 1 1 1. */
  scale: Vec3;
  /** As for the viewer. Null, the default: as the viewer says. */
  shading: Shading | null;
  /** As for the viewer. Null, the default: as the viewer says. */
  reflection: Reflection | null;
}

/**
 * The values of a mesh, as far as its declaration has them: a viewer that is one has no place of
 * its own.
 */
export interface MeshState {
  readonly values: Readonly<ShapeValues & Partial<Omit<MeshValues, keyof ShapeValues>>>;
  /** Whether a value was set, rather than being the default. */
  given(key: keyof SurfaceValues): boolean;
}

/** Largest magnitude of a scale that keeps float32 products finite. */
const SCALE = 1e12;

const addressField = textField('', 'the address of a model, a Blob or a File');

const sourceField: Field<string | Blob> = {
  ...addressField,
  check: (value) => (isBlob(value) ? value : addressField.check(value)),
};

/** By its tag: those of other windows are no instances of this one's class. */
function isBlob(value: unknown): value is Blob {
  return /^\[object (Blob|File)\]$/.test(Object.prototype.toString.call(value));
}

export const SHAPE_FIELDS: Fields<ShapeValues> = {
  ...SURFACE_FIELDS,
  src: sourceField,
  type: optional(choiceField(MODEL_TYPES)),
  geometry: optional(choiceField(GEOMETRIES)),
  segments: orAuto(numberField(64, { min: 1, max: 512, integer: true })),
  autoplay: presenceField(),
  animationName: textField('', 'the name of an animation'),
};

const coordinates = { min: -LIMITS.coordinate, max: LIMITS.coordinate };

export const MESH_FIELDS: Fields<MeshValues> = {
  name: textField(),
  ...SHAPE_FIELDS,
  position: vectorField([0, 0, 0], coordinates),
  rotation: vectorField([0, 0, 0], coordinates),
  scale: scaleField([1, 1, 1], { min: -SCALE, max: SCALE }),
  shading: optional(choiceField(SHADINGS)),
  reflection: optional(choiceField(REFLECTIONS)),
};
