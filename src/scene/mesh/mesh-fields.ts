// What a mesh declares: shape, place, surface and how it differs from its picture's shading. Values in HTML's units,
// with domains and defaults. Knows neither elements nor how a mesh is drawn.
import { LIMITS } from '../../light/light-state.js';
import { SURFACE_FIELDS, type SurfaceValues } from '../../material/material-values.js';
import { type Reflection, REFLECTIONS, type Shading, SHADINGS } from '../../material/program/variant.js';
import type { Fields } from '../../fields/field-store.js';
import {
  choiceField,
  numberField,
  optional,
  scaleField,
  textField,
  vectorField,
} from '../../fields/field.js';
import type { Vec3 } from '../../math/vector.js';
import { GEOMETRIES, type GeometryName } from './shapes/shapes.js';

/** Where a mesh's triangles come from. `src` wins where both are given. */
export interface ShapeValues extends SurfaceValues {
  /** Address of a model, relative to the page; empty for none. */
  src: string;
  /** A built-in shape; null for none. */
  geometry: GeometryName | null;
  /** Segments around, 1–512; null: the shape's own default. */
  segments: number | null;
}

export interface MeshValues extends ShapeValues {
  /** Text for the panel and for explanations. */
  name: string;
  /** Scene units. Default 0 0 0. */
  position: Vec3;
  /** Degrees about x, y, z: three.js's Euler order XYZ, right-handed. Default 0 0 0. */
  rotation: Vec3;
  /** Factors along the mesh's own axes, each up to 1e12 either way; negative ones mirror. Default 1 1 1. */
  scale: Vec3;
  /** Null: as the viewer. */
  shading: Shading | null;
  /** Null: as the viewer. */
  reflection: Reflection | null;
}

/** Largest scale either way that keeps float32 products finite. */
const SCALE = 1e12;

export const SHAPE_FIELDS: Fields<ShapeValues> = {
  ...SURFACE_FIELDS,
  src: textField('', 'the address of a model'),
  geometry: optional(choiceField<GeometryName>('box', GEOMETRIES)),
  segments: optional(numberField(1, { min: 1, max: 512, integer: true })),
};

const coordinates = { min: -LIMITS.coordinate, max: LIMITS.coordinate };

export const MESH_FIELDS: Fields<MeshValues> = {
  name: textField(),
  ...SHAPE_FIELDS,
  position: vectorField([0, 0, 0], coordinates),
  rotation: vectorField([0, 0, 0], coordinates),
  scale: scaleField([1, 1, 1], { min: -SCALE, max: SCALE }),
  shading: optional(choiceField<Shading>('phong', SHADINGS)),
  reflection: optional(choiceField<Reflection>('phong', REFLECTIONS)),
};
