// The values that a viewer declares besides its children: loading, camera, shading and the panel, with domains and
// defaults in HTML's units.
import { LIGHT_FIELDS, LIMITS, type Term, TERMS } from '../../light/light-state.js';
import { type Reflection, REFLECTIONS, type Shading, SHADINGS } from '../../material/material-values.js';
import { type View, VIEWS } from '../../material/views.js';
import type { Fields } from '../../fields/field-store.js';
import {
  booleanField,
  choiceField,
  flagOrWordsField,
  numberField,
  optional,
  orWord,
  presenceField,
  subsetField,
  textField,
  vectorField,
} from '../../fields/field.js';
import type { Vec3 } from '../../math/vector.js';
import { MESH_FIELDS, SHAPE_FIELDS, type ShapeValues } from '../../scene/mesh/mesh-fields.js';
import { attributeOf } from './attribute-text.js';

export type Loading = 'auto' | 'eager' | 'lazy';
type ColorInterpolation = 'srgb' | 'linear';
type Antialias = 'edges' | 'full';

/** What can be drawn over the picture. */
export const HELPERS = ['lights', 'axes', 'grid', 'normals', 'bounds'] as const;
export type Helper = (typeof HELPERS)[number];

export interface CameraValues {
  /** Azimuth of the eye about +y in degrees, any finite number; 0 looks from +z, 90 from +x. Default 30. */
  theta: number;
  /** Polar angle of the eye from +y in degrees, 0–180. Default 70. */
  phi: number;
  /** Distance of the eye from the target in scene units, > 0, or `auto`: the whole scene fits. Default auto. */
  radius: number | 'auto';
  /** What the eye looks at, or `auto`: the centre of the scene's box. Default auto. */
  target: Vec3 | 'auto';
}

export interface ViewerValues extends ShapeValues, CameraValues {
  /**
   * The picture in words. Empty, the default: none. The attribute `alt=""` says that the picture is decoration. Without
   * it, and without `aria-label` or `aria-labelledby`, the console warns.
   */
  alt: string;
  /**
   * Address of an image shown until the first picture is drawn. One that cannot be shown leaves nothing behind. Default
   * empty: none.
   */
  poster: string;
  /**
   * What waits until the viewer is in view or less than a screen height away from it. `auto`: drawing; models are
   * fetched at once. `eager`: nothing, the picture is drawn off screen too, as screenshots of whole pages need. `lazy`:
   * drawing and fetching models. Default auto.
   */
  loading: Loading;
  /** Files dropped on the viewer become its `src`. Default false. */
  droppable: boolean;
  /**
   * How files that a model names are fetched from other origins: without (`anonymous`) or with credentials. Null, the
   * default: not at all.
   */
  crossOrigin: 'anonymous' | 'use-credentials' | null;
  /** Vertical field of view in degrees, 1–170. Default 45. */
  fov: number;
  /** Whether the user can rotate the scene and shift the target. Default true. */
  orbit: boolean;
  /** Whether the user can zoom by wheel, pinch and keys. Default true. */
  zoom: boolean;
  /** Degrees per second about y; 0 is off. Stopped for users who prefer reduced motion. Default 0. */
  autoRotate: number;
  /** `phong` per fragment, `gouraud` per vertex, `flat` per fragment with the triangle's normal. Default phong. */
  shading: Shading;
  /** Specular lobe: R·V or N·H. Default phong. */
  reflection: Reflection;
  /** Which terms are summed; an empty list sums none. Default all three. */
  terms: readonly Term[];
  /** `srgb` shades encoded colours; `linear` decodes them first and encodes the sum. Default srgb. */
  colorInterpolation: ColorInterpolation;
  /**
   * `edges`: several samples per pixel at the edges of faces, one inside. `full`: a picture that stands still converges
   * to the mean over each pixel; until then, and while anything moves, like `edges`. Default edges.
   */
  antialias: Antialias;
  /** Samples per pixel of `antialias="full"`. Whole, 16–1,024. Default 64. */
  samples: number;
  /**
   * Most pixels of the canvas per CSS pixel, a number above 0, or `auto`: as many as the device has. Below 1 the
   * picture is blurred. Default auto.
   */
  pixelRatio: number | 'auto';
  /**
   * What is drawn over the picture: `lights` with handles that move them, `axes`, `grid`, `normals`, `bounds`. As an
   * attribute without a value: `lights`. Default none.
   */
  helpers: readonly Helper[];
  /** What the picture shows: the shaded colours, or one quantity of the equation with a legend. Default shaded. */
  view: View;
  /**
   * Name of the light that `view` is limited to, `shaded` too. A name that no light has warns, and the picture is
   * black. Empty, the default: all lights, or the first active one where a view is of one.
   */
  viewLight: string;
  /**
   * The user can point at the picture to see N, L, R and V there, and the sum light by light. `formula`: the equation
   * with the numbers of the point in place of the table. `ask`: the same as questions. Default false.
   */
  probe: boolean | 'formula' | 'ask';
  /**
   * World-space point. The probe explains the fragment at its pixel until the user points elsewhere. Null, the default:
   * none.
   */
  probeAt: Vec3 | null;
  /** Viewers of a page with the same name here move their cameras together. Empty, the default: alone. */
  cameraGroup: string;
  /**
   * The control panel is shown: beside the picture from 640 px on, over it below. A list of folders (`lights camera
   * shading show meshes`) opens these; a list of attributes of lights, meshes and the viewer shows only their rows, in
   * this order and without folders. `gui="false"` is off. Default false.
   */
  gui: boolean | readonly string[];
}

/** Folders of the panel that `gui` can open. */
export const GUI_FOLDERS = ['lights', 'camera', 'shading', 'show', 'meshes'] as const;

/** Attributes that `gui` can list: those of all elements that the panel edits. The panel warns of one without a row. */
const GUI_ROWS: string[] = [];

const PROBE_VALUES = 'true, false, formula or ask';

const CAMERA_FIELDS: Fields<CameraValues> = {
  theta: numberField(30, {}),
  phi: numberField(70, { min: 0, max: 180 }),
  radius: orWord('auto', numberField(4, { above: 0, max: LIMITS.coordinate })),
  target: orWord('auto', vectorField([0, 0, 0], { min: -LIMITS.coordinate, max: LIMITS.coordinate })),
};

export const VIEWER_FIELDS: Fields<ViewerValues> = {
  ...SHAPE_FIELDS,
  alt: textField(),
  poster: textField('', 'the address of an image'),
  loading: choiceField<Loading>('auto', ['auto', 'eager', 'lazy']),
  droppable: presenceField(),
  crossOrigin: {
    ...optional(choiceField<'anonymous' | 'use-credentials'>('anonymous', ['anonymous', 'use-credentials'])),
    empty: 'anonymous',
  },
  ...CAMERA_FIELDS,
  fov: numberField(45, { min: 1, max: 170 }),
  orbit: booleanField(true),
  zoom: booleanField(true),
  // The limit keeps elapsed time times speed precise. It is far above a turn per frame.
  autoRotate: numberField(0, { min: -1e6, max: 1e6 }),
  shading: choiceField<Shading>('phong', SHADINGS),
  reflection: choiceField<Reflection>('phong', REFLECTIONS),
  terms: subsetField<Term>(TERMS),
  colorInterpolation: choiceField<ColorInterpolation>('srgb', ['srgb', 'linear']),
  antialias: choiceField<Antialias>('edges', ['edges', 'full']),
  samples: numberField(64, { min: 16, max: 1024, integer: true }),
  // Any limit far above what screens have would do.
  pixelRatio: orWord('auto', numberField(1, { above: 0, max: 1e6 })),
  helpers: { ...subsetField<Helper>(HELPERS, []), empty: Object.freeze<Helper[]>(['lights']) },
  view: choiceField<View>('shaded', VIEWS),
  viewLight: textField(),
  probe: {
    kind: 'flag-or-words',
    fallback: false,
    expected: PROBE_VALUES,
    check(value) {
      if (typeof value === 'boolean') return value;
      const word = String(value); // of one word, or of a list of them
      if (word === 'formula' || word === 'ask') return word;
      if (word === 'probe') return true;
      const message = `expected ${PROBE_VALUES}, got ${word}`;
      throw typeof value === 'string' || Array.isArray(value) ? new RangeError(message) : new TypeError(message);
    },
  },
  probeAt: optional(vectorField([0, 0, 0], { min: -LIMITS.coordinate, max: LIMITS.coordinate })),
  cameraGroup: textField(),
  gui: flagOrWordsField('gui', 'true, false, folders of the panel or names of attributes', [GUI_FOLDERS, GUI_ROWS]),
};

for (const fields of [LIGHT_FIELDS, MESH_FIELDS, VIEWER_FIELDS]) GUI_ROWS.push(...Object.keys(fields).map(attributeOf));

/** Assigning the same value again retries what failed. */
export const RETRY_KEYS: ReadonlySet<string> = new Set(['src', 'geometry', 'gui']);

/** Values that the viewer's own mesh, or the loading of all meshes, depends on. */
export const LOADING_KEYS: readonly string[] = [...Object.keys(SHAPE_FIELDS), 'loading', 'crossOrigin'];
