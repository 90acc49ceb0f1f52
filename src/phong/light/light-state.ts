// One light's values in HTML's units: their domains and defaults, and what shading makes of each.
// Elements, the panel and plain JavaScript all write here; packing, masks and the GLSL's structs
// follow from the table.
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
import { isBlack, isGrey } from '../math/color.js';
import type { Vec3, Vec4 } from '../math/vector.js';
import { isIntegerPower, isOnFarSide, isSteep, LEAST_EXPONENT, packedLimit } from './precision.js';

/** In the order of their packed rows. */
export const KINDS = ['directional', 'point', 'spot'] as const;
export type LightKind = (typeof KINDS)[number];

/** The terms of the equation. */
export const TERMS = ['ambient', 'diffuse', 'specular'] as const;
export type Term = (typeof TERMS)[number];

export const LIGHT_SPACES = ['world', 'camera'] as const;
export type LightSpace = (typeof LIGHT_SPACES)[number];

export interface LightValues {
  /** Text shown in the panel and in explanations. Default: empty, shown as `light N`. */
  name: string;
  /** The light takes part; an inactive one costs no shading. Default true. */
  active: boolean;
  /**
   * Ia: colour of the light's ambient term; 255 is full, more is brighter, up to 1e6. Default 0 0
   * 0.
   */
  ambient: Vec3;
  /** Id: colour of the diffuse term, as `ambient`. Default 255 255 255. */
  diffuse: Vec3;
  /** Is: colour of the specular term, as `ambient`. Default 255 255 255. */
  specular: Vec3;
  /**
   * w = 1, or left out: the light's place, in scene units; w = 0: the vector that points to a light
   * infinitely far away. Default 1 2 3 0.
   */
  position: Vec4;
  /** Where a spot points, away from the light; any length. Zero: no spot. Default 0 0 -1. */
  axis: Vec3;
  /** Half-angle of a spot's cone in degrees, 0–180: a hard edge. 180 means no cone. Default 180. */
  aperture: number;
  /**
   * Exponent of the decay away from a spot's axis, >= 0: a soft edge. 20° off the axis 1 leaves
   * 0.97 of the light, 4 leaves 0.88, 12 leaves 0.69, 48 leaves 0.23. Below 1e-6: no decay. Default
   * 0.
   */
  cutoff: number;
  /**
   * kc, kl and kq of 1 / max(kc + kl·d + kq·d², 1); positional lights only. Default 1 0 0: none.
   */
  attenuation: Vec3;
  /**
   * `world`, or `camera` (x right, y up, looking along −z): the light turns with the eye. Default
   * `world`.
   */
  space: LightSpace;
}

/** Largest magnitudes that keep every float32 product of the equation finite. */
export const LIMITS = { coordinate: 1e15, exponent: 1e6, color: 1e6, attenuation: 1e6 } as const;

const coordinates = { min: -LIMITS.coordinate, max: LIMITS.coordinate };
const colors = { min: 0, max: LIMITS.color };

type Test = (light: Readonly<LightValues>) => boolean;

/** How shading takes a value. */
export interface Packing<T> {
  /**
   * The numbers in the rows. `light`: r g b, 255 is 1, times what its own cone and decay leave of a
   * directional light. `place`: where the light is, or the unit vector to a directional one.
   * `axis`: a unit vector. `numbers`: three, in the w of this row and of the next two. A function:
   * one, in the row's w.
   */
  readonly as: 'light' | 'place' | 'axis' | 'numbers' | ((value: T) => number);
  /** Its row in each kind of light that holds it, relative to the light's first. */
  readonly rows: { readonly [K in LightKind]?: number };
  /** The terms that it enters. Without these its features are left out. */
  readonly terms: readonly Term[];
  /**
   * Code that only some of these lights need, a bit each. `now`: whether this light needs it;
   * `ever`: whether it may with another colour, cone or cutoff.
   */
  readonly features: Readonly<Record<string, readonly [now: Test, ever?: Test]>>;
}

/**
 * `select`: says whether, as which kind or in which space a light is packed. `none`: the picture is
 * the same.
 */
export type LightField<T> = Field<T> & { readonly shading: Packing<T> | 'select' | 'none' };

const isAmbient: Test = ({ ambient }) => !isBlack(ambient);
const isDiffuse: Test = ({ diffuse }) => !isBlack(diffuse);
const isSpecular: Test = ({ specular }) => !isBlack(specular);

/** Attenuation that can differ from 1. */
const isAttenuated: Test = ({ attenuation: k }) => k[0] > 1 || k[1] > 0 || k[2] > 0;
const hasCone: Test = ({ aperture }) => aperture < 180;
const hasDecay: Test = ({ cutoff }) => cutoff >= LEAST_EXPONENT;

/**
 * Every value of a light: default, domain, and what shading makes of it. One without `shading` does
 * not compile. GLSL reads a packed value by its name in the kind's struct, as in `light.cutoff`;
 * its features are FEATURE_… there.
 */
export const LIGHT_FIELDS = {
  name: { ...textField(), shading: 'none' },
  active: { ...booleanField(), shading: 'select' },
  ambient: {
    ...colorField([0, 0, 0], colors),
    // The other kinds' is summed in the header.
    shading: {
      as: 'light',
      rows: { spot: 4 },
      terms: ['ambient'],
      features: { ambient: [isAmbient] },
    },
  },
  diffuse: {
    ...colorField([255, 255, 255], colors),
    shading: {
      as: 'light',
      rows: { directional: 1, point: 1, spot: 1 },
      terms: ['diffuse'],
      // Grey light is summed as one number.
      features: {
        diffuse: [isDiffuse],
        tintedDiffuse: [({ diffuse }) => !isGrey(diffuse), isDiffuse],
      },
    },
  },
  specular: {
    ...colorField([255, 255, 255], colors),
    shading: {
      as: 'light',
      rows: { directional: 2, point: 2, spot: 2 },
      terms: ['specular'],
      features: {
        specular: [isSpecular],
        tintedSpecular: [({ specular }) => !isGrey(specular), isSpecular],
      },
    },
  },
  position: {
    ...homogeneousField([1, 2, 3, 0], coordinates),
    shading: {
      as: 'place',
      rows: { directional: 0, point: 0, spot: 0 },
      terms: TERMS,
      features: {},
    },
  },
  axis: {
    ...vectorField([0, 0, -1], coordinates),
    shading: { as: 'axis', rows: { spot: 3 }, terms: TERMS, features: {} },
  },
  aperture: {
    ...numberField(180, { min: 0, max: 180 }),
    shading: {
      as: packedLimit,
      rows: { spot: 4 },
      terms: TERMS,
      features: {
        // Compared on the axis's side, by (1 - c)/2. Steep cones may be compared on either side.
        narrow: [(light) => hasCone(light) && !isOnFarSide(light.aperture), isSteep],
        // Compared on the far side, by (1 + c)/2.
        wide: [({ aperture }) => isOnFarSide(aperture), hasCone],
        // Too steep for a cosine. Without chords an H200 takes 0.93 to 0.96 of the time under 8 to
        // 256 lights.
        chords: [isSteep],
      },
    },
  },
  cutoff: {
    ...numberField(0, { min: 0, max: LIMITS.exponent }),
    shading: {
      as: Number,
      rows: { spot: 3 },
      terms: TERMS,
      // Integer powers are in the mask themselves: see LIGHT_FEATURES.
      features: { decay: [(light) => hasDecay(light) && !isIntegerPower(light.cutoff), hasDecay] },
    },
  },
  attenuation: {
    ...vectorField([1, 0, 0], { min: 0, max: LIMITS.attenuation }),
    shading: {
      as: 'numbers',
      rows: { point: 0, spot: 0 },
      terms: ['diffuse', 'specular'],
      features: {
        attenuated: [isAttenuated],
        // Near the light it is clamped to 1. Also without attenuation: in a loop every light takes
        // its sum.
        clamped: [({ attenuation: k }) => k[0] < 1, isAttenuated],
        // It needs the distance, not its square alone.
        linear: [({ attenuation: k }) => k[1] > 0, isAttenuated],
      },
    },
  },
  space: { ...choiceField(LIGHT_SPACES), shading: 'select' },
} as const satisfies { readonly [K in keyof LightValues]: LightField<LightValues[K]> };

type Values = typeof LIGHT_FIELDS;

/** The values that enter the equation. */
export type ShadedValue = {
  [K in keyof Values]: Values[K]['shading'] extends string ? never : K;
}[keyof Values];

/**
 * kc + kl·d + kq·d² at a distance >= 0: what the attenuation divides by where it is above 1. The
 * one place on the CPU, as shaders/attenuation.glsl is on the GPU.
 */
export const falloff = (
  { attenuation: k }: Readonly<Pick<LightValues, ShadedValue>>,
  d: number,
): number => k[0] + k[1] * d + k[2] * d * d;

/** One light. Every write is checked and notifies the listener, its LightSet. */
export class LightState extends FieldStore<LightValues> {
  /** Throws as {@link FieldStore.set} does. Values that are not given have their defaults. */
  constructor(values: Partial<LightValues> = {}) {
    super(LIGHT_FIELDS);
    this.assign(values);
  }
}
