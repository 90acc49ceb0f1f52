// One light's values in HTML's units, with their domains and defaults. Elements, the panel and plain JavaScript all
// write here.
import { FieldStore } from '../fields/field-store.js';
import {
  booleanField,
  choiceField,
  colorField,
  type Field,
  homogeneousField,
  numberField,
  textField,
  vectorField,
} from '../fields/field.js';
import type { Vec3, Vec4 } from '../math/vector.js';

export type LightSpace = 'world' | 'camera';

export const LIGHT_SPACES = ['world', 'camera'] as const satisfies readonly LightSpace[];

export interface LightValues {
  /** Text shown in the panel and in explanations. Default: empty, shown as `light N`. */
  name: string;
  /** Whether the light takes part. An inactive light costs no shading. Default true. */
  active: boolean;
  /** Ia: colour of the light's ambient term; 255 is full, more is a brighter light, up to 1e6. Default 0 0 0. */
  ambient: Vec3;
  /** Id: colour of the diffuse term, as `ambient`. Default 255 255 255. */
  diffuse: Vec3;
  /** Is: colour of the specular term, as `ambient`. Default 255 255 255. */
  specular: Vec3;
  /**
   * Homogeneous position x y z w. w = 1: the light's place, in scene units; w = 0: the vector that points to a light
   * infinitely far away. Three numbers mean w = 1. Default 1 2 3 0.
   */
  position: Vec4;
  /** Where a spot points, away from the light; any length. Zero: no spot. Default 0 0 -1. */
  axis: Vec3;
  /** Half-angle of a spot's cone in degrees, 0–180: a hard edge. 180 means no cone. Default 180. */
  aperture: number;
  /**
   * Exponent of the decay away from a spot's axis, >= 0: a soft edge. 20° off the axis 1 leaves 0.97 of the light, 4
   * leaves 0.88, 12 leaves 0.69, 48 leaves 0.23. Below 1e-6: no decay. Default 0.
   */
  cutoff: number;
  /** kc, kl and kq of 1 / max(kc + kl·d + kq·d², 1); positional lights only. Default 1 0 0: none. */
  attenuation: Vec3;
  /** `world`, or `camera` (x right, y up, looking along −z): the light turns with the eye. Default `world`. */
  space: LightSpace;
}

/** Largest magnitudes that keep every float32 product of the equation finite. */
export const LIMITS = { coordinate: 1e15, exponent: 1e6, color: 1e6, attenuation: 1e6 } as const;

const coordinates = { min: -LIMITS.coordinate, max: LIMITS.coordinate };
const colors = { min: 0, max: LIMITS.color };

/** Default and domain of every value of a light. */
export const LIGHT_FIELDS: { readonly [K in keyof LightValues]: Field<LightValues[K]> } = {
  name: textField(),
  active: booleanField(true),
  ambient: colorField([0, 0, 0], colors),
  diffuse: colorField([255, 255, 255], colors),
  specular: colorField([255, 255, 255], colors),
  position: homogeneousField([1, 2, 3, 0], coordinates),
  axis: vectorField([0, 0, -1], coordinates),
  aperture: numberField(180, { min: 0, max: 180 }),
  cutoff: numberField(0, { min: 0, max: LIMITS.exponent }),
  attenuation: vectorField([1, 0, 0], { min: 0, max: LIMITS.attenuation }),
  space: choiceField<LightSpace>('world', LIGHT_SPACES),
};

/** One light. Every write is checked and notifies the listener, its LightSet. */
export class LightState extends FieldStore<LightValues> {
  /** Throws as {@link FieldStore.set} does. Values that are not given have their defaults. */
  constructor(values: Partial<LightValues> = {}) {
    super(LIGHT_FIELDS);
    this.assign(values);
  }
}
