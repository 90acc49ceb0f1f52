// What a viewer declares besides its children: loading, camera, shading and the panel. Values in HTML's units, with
// domains and defaults. Knows nothing of how they are acted on.
import { LIMITS } from '../../light/light-state.js';
import {
  type Antialias,
  ANTIALIASES,
  type Reflection,
  REFLECTIONS,
  type Shading,
  SHADINGS,
  type Term,
  TERMS,
} from '../../material/program/variant.js';
import type { Fields } from '../../fields/field-store.js';
import {
  booleanField,
  choiceField,
  numberField,
  optional,
  orWord,
  presenceField,
  subsetField,
  textField,
  vectorField,
} from '../../fields/field.js';
import type { Vec3 } from '../../math/vector.js';
import { SHAPE_FIELDS, type ShapeValues } from '../../scene/mesh/mesh-fields.js';

export type Loading = 'eager' | 'lazy';
export type ColorInterpolation = 'srgb' | 'linear';

export interface CameraValues {
  /** Azimuth of the eye about +y in degrees, any finite number; 0 looks from +z. Default 30. */
  theta: number;
  /** Polar angle of the eye from +y in degrees, 0–180. Default 70. */
  phi: number;
  /** Distance of the eye from the target in scene units, or `auto`: all of the scene fits. Default auto. */
  radius: number | 'auto';
  /** What the eye looks at, or `auto`: the centre of the scene's box. Default auto. */
  target: Vec3 | 'auto';
}

export interface ViewerValues extends ShapeValues, CameraValues {
  /** What the picture shows, in words, for those who do not see it. */
  alt: string;
  /** Address of an image shown until the first picture is drawn. */
  poster: string;
  /** `lazy`: models are not loaded until the viewer can be seen. Default eager. */
  loading: Loading;
  /** How models, and what they name, are fetched from other origins. Null: not at all beyond `src` itself. */
  crossOrigin: 'anonymous' | 'use-credentials' | null;
  /** Vertical field of view in degrees, 1–170. Default 45. */
  fov: number;
  /** Whether a drag or the arrow keys turn the scene. Default true. */
  orbit: boolean;
  /** Whether wheel, pinch, + and − change the distance. Default true. */
  zoom: boolean;
  /** Degrees a second about y; 0 is off. Stands still for readers who prefer reduced motion. Default 0. */
  autoRotate: number;
  /** `phong` per fragment, `gouraud` per vertex, `flat` with the triangles' own normals. Default phong. */
  shading: Shading;
  /** Specular lobe: R·V or N·H. Default phong. */
  reflection: Reflection;
  /** Which terms are summed. Default all three; the empty list sums none. */
  terms: readonly Term[];
  /** `srgb` shades encoded colours as they are; `linear` decodes first and encodes last. Default srgb. */
  colorInterpolation: ColorInterpolation;
  /**
   * `edges`: several samples a pixel where faces end, one inside them. `highlights`: the specular lobe is averaged over
   * each pixel too, so that highlights smaller than pixels keep their brightness; not under `gouraud`. Default edges.
   */
  antialias: Antialias;
  /** How much colour may be given up per fragment for speed, in 1/255; 0 gives up nothing. Default 0. */
  errorBudget: number;
  /** The control panel is shown. Default false. */
  gui: boolean;
}

export const CAMERA_FIELDS: Fields<CameraValues> = {
  theta: numberField(30, {}),
  phi: numberField(70, { min: 0, max: 180 }),
  radius: orWord('auto', numberField(4, { above: 0, max: LIMITS.coordinate })),
  target: orWord('auto', vectorField([0, 0, 0], { min: -LIMITS.coordinate, max: LIMITS.coordinate })),
};

export const VIEWER_FIELDS: Fields<ViewerValues> = {
  ...SHAPE_FIELDS,
  alt: textField(),
  poster: textField('', 'the address of an image'),
  loading: choiceField<Loading>('eager', ['eager', 'lazy']),
  crossOrigin: {
    ...optional(choiceField<'anonymous' | 'use-credentials'>('anonymous', ['anonymous', 'use-credentials'])),
    empty: 'anonymous',
  },
  ...CAMERA_FIELDS,
  fov: numberField(45, { min: 1, max: 170 }),
  orbit: booleanField(true),
  zoom: booleanField(true),
  // A turn per frame is not motion any more; the limit keeps elapsed time times speed precise.
  autoRotate: numberField(0, { min: -1e6, max: 1e6 }),
  shading: choiceField<Shading>('phong', SHADINGS),
  reflection: choiceField<Reflection>('phong', REFLECTIONS),
  terms: subsetField<Term>(TERMS),
  colorInterpolation: choiceField<ColorInterpolation>('srgb', ['srgb', 'linear']),
  antialias: choiceField<Antialias>('edges', ANTIALIASES),
  errorBudget: numberField(0, { min: 0, max: 255 }),
  gui: presenceField(),
};

/** What the viewer's own mesh, and the loading of all of them, depend on. */
export const LOADING_KEYS: readonly string[] = [...Object.keys(SHAPE_FIELDS), 'loading', 'crossOrigin'];
