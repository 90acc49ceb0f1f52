// The values that a viewer declares besides its children, with domains and defaults in HTML's
// units.
import { LIGHT_FIELDS, LIMITS, type Term, TERMS } from '../../../phong/light/light-state.js';
import {
  type Reflection,
  REFLECTIONS,
  type Shading,
  SHADINGS,
} from '../../../phong/material/material-values.js';
import { type View, VIEWS } from '../../../phong/material/views.js';
import type { Fields } from '../../../phong/fields/field-store.js';
import {
  booleanField,
  choiceField,
  flagOrWordsField,
  numberField,
  optional,
  orAuto,
  presenceField,
  subsetField,
  textField,
  vectorField,
} from '../../../phong/fields/field.js';
import type { Vec3 } from '../../../phong/math/vector.js';
import { MESH_FIELDS, SHAPE_FIELDS } from '../../../phong/model/mesh-fields.js';
import { attributeOf } from '../../../phong/fields/attribute-text.js';
import { GUI_FOLDERS, type Helper, HELPERS } from '../../../phong/fields/viewer-words.js';
import type { Inputs, ShapeProperties, ValuesOf } from './properties.js';

export interface ViewerProperties extends ShapeProperties {
  /**
   * Azimuth of the eye about +y in degrees, any finite number; 0 looks from +z, 90 from +x. Default
   * 30.
   */
  get theta(): number;
  set theta(value: Accepted['theta']);
  /** Polar angle of the eye from +y in degrees, 0–180. Default 70. */
  get phi(): number;
  set phi(value: Accepted['phi']);
  /**
   * Distance of the eye from the target in scene units, > 0, or `auto`: the whole scene fits.
   * Default auto.
   */
  get radius(): number | 'auto';
  set radius(value: Accepted['radius']);
  /** What the eye looks at, or `auto`: the centre of the scene's box. Default auto. */
  get target(): Vec3 | 'auto';
  set target(value: Accepted['target']);
  /**
   * The picture in words; `alt=""` says that it is decoration. Without it, `aria-label` and
   * `aria-labelledby` the console warns. Empty, the default: none.
   */
  get alt(): string;
  set alt(value: Accepted['alt']);
  /**
   * Address of an image shown until the first picture is drawn; nothing if it cannot be. Default
   * empty: none.
   */
  get poster(): string;
  set poster(value: Accepted['poster']);
  /**
   * What waits until the viewer is less than a screen height away from the view. `auto`: drawing;
   * models are fetched at once, in a closed dialog or `<details>` once it is opened. `eager`:
   * nothing, as screenshots of whole pages need. `lazy`: drawing and fetching models. Default auto.
   */
  get loading(): 'auto' | 'eager' | 'lazy';
  set loading(value: Accepted['loading']);
  /** Files dropped on the viewer become its `src`; a PNG with a scene opens it. Default false. */
  get droppable(): boolean;
  set droppable(value: Accepted['droppable']);
  /**
   * Fetches files that a model names from other origins too, without (`anonymous`) or with
   * credentials. Null, the default: not at all.
   */
  get crossOrigin(): 'anonymous' | 'use-credentials' | null;
  set crossOrigin(value: Accepted['crossOrigin']);
  /** Vertical field of view in degrees, 1–170. Default 45. */
  get fov(): number;
  set fov(value: Accepted['fov']);
  /** The user can rotate the scene and shift the target. Default true. */
  get orbit(): boolean;
  set orbit(value: Accepted['orbit']);
  /** The user can zoom by wheel, pinch and keys. Default true. */
  get zoom(): boolean;
  set zoom(value: Accepted['zoom']);
  /** Degrees per second about y, unless the user prefers reduced motion; 0 is off. Default 0. */
  get autoRotate(): number;
  set autoRotate(value: Accepted['autoRotate']);
  /**
   * `phong` per fragment, `gouraud` per vertex, `flat` with the triangle's normal. Default phong.
   */
  get shading(): Shading;
  set shading(value: Accepted['shading']);
  /** Specular lobe: R·V or N·H. Default phong. */
  get reflection(): Reflection;
  set reflection(value: Accepted['reflection']);
  /** Which terms are summed; an empty list sums none. Default all three. */
  get terms(): readonly Term[];
  set terms(value: Accepted['terms']);
  /**
   * `srgb` shades encoded colours; `linear` decodes them first and encodes the sum. Default srgb.
   */
  get colorInterpolation(): 'srgb' | 'linear';
  set colorInterpolation(value: Accepted['colorInterpolation']);
  /**
   * `edges`: several samples per pixel at the edges of faces, one inside. `full`: a picture that
   * stands still converges to the mean over each pixel. Default edges.
   */
  get antialias(): 'edges' | 'full';
  set antialias(value: Accepted['antialias']);
  /** Samples per pixel of `antialias="full"`. Whole, 16–1,024. Default 64. */
  get samples(): number;
  set samples(value: Accepted['samples']);
  /**
   * Most pixels of the canvas per CSS pixel, above 0; below 1 the picture is blurred. `auto`: those
   * of the device, fewer while something moves and drawing is slow. Default auto.
   */
  get pixelRatio(): number | 'auto';
  set pixelRatio(value: Accepted['pixelRatio']);
  /**
   * What is drawn over the picture: `lights` with handles that move them, `axes`, `grid`,
   * `normals`, `bounds`. As an attribute without a value: `lights`. Default none.
   */
  get helpers(): readonly Helper[];
  set helpers(value: Accepted['helpers']);
  /** What the picture shows: the shaded colours, or one quantity with a legend. Default shaded. */
  get view(): View;
  set view(value: Accepted['view']);
  /**
   * Name of the light that `view` is limited to, `shaded` too. If no light has it, the console
   * warns and the picture is black. Empty, the default: all lights, or the first active one for
   * views of one.
   */
  get viewLight(): string;
  set viewLight(value: Accepted['viewLight']);
  /**
   * The user can point at the picture to see N, L, R, V and the sum light by light. Default false.
   */
  get probe(): boolean;
  set probe(value: Accepted['probe']);
  /**
   * Point in world space whose pixel the probe explains until the user points elsewhere. Null, the
   * default: none.
   */
  get probeAt(): Vec3 | null;
  set probeAt(value: Accepted['probeAt']);
  /** Viewers with the same name here move their cameras together. Empty, the default: alone. */
  get cameraGroup(): string;
  set cameraGroup(value: Accepted['cameraGroup']);
  /**
   * The control panel is shown, beside the picture from 640 px on, else over it. A list of folders
   * (`lights camera shading show meshes`) opens these; a list of attributes of lights, meshes and
   * the viewer shows only their rows, in this order. `gui="false"` is off. Default false.
   */
  get gui(): boolean | readonly string[];
  set gui(value: Accepted['gui']);
}

export type ViewerValues = ValuesOf<ViewerProperties>;
type Accepted = Inputs<ViewerValues>;

/**
 * Attributes that `gui` can list: those of all elements that the panel edits. The panel warns of
 * one without a row.
 */
const GUI_ROWS: string[] = [];

/** Samples per pixel, of `samples` and of picture files. */
export const MOST_SAMPLES = 1024;

export const VIEWER_FIELDS: Fields<ViewerValues> = {
  ...SHAPE_FIELDS,
  alt: textField(),
  poster: textField('', 'the address of an image'),
  loading: choiceField(['auto', 'eager', 'lazy']),
  droppable: presenceField(),
  crossOrigin: {
    ...optional(choiceField(['anonymous', 'use-credentials'])),
    empty: 'anonymous',
  },
  theta: numberField(30, {}),
  phi: numberField(70, { min: 0, max: 180 }),
  radius: orAuto(numberField(4, { above: 0, max: LIMITS.coordinate })),
  target: orAuto(vectorField([0, 0, 0], { min: -LIMITS.coordinate, max: LIMITS.coordinate })),
  fov: numberField(45, { min: 1, max: 170 }),
  orbit: booleanField(),
  zoom: booleanField(),
  // The limit keeps elapsed time times speed precise. It is far above a turn per frame.
  autoRotate: numberField(0, { min: -1e6, max: 1e6 }),
  shading: choiceField(SHADINGS),
  reflection: choiceField(REFLECTIONS),
  terms: subsetField(TERMS),
  colorInterpolation: choiceField(['srgb', 'linear']),
  antialias: choiceField(['edges', 'full']),
  samples: numberField(64, { min: 16, max: MOST_SAMPLES, integer: true }),
  // Any limit far above what screens have would do.
  pixelRatio: orAuto(numberField(1, { above: 0, max: 1e6 })),
  helpers: { ...subsetField(HELPERS, []), empty: Object.freeze<Helper[]>(['lights']) },
  view: choiceField(VIEWS),
  viewLight: textField(),
  probe: {
    ...presenceField(),
    kind: 'flag-or-words',
    expected: 'true or false; <phong-probe for="id" as="formula"> and as="ask" show more',
    check(value) {
      // One word, or a list of one.
      return String(value) === 'probe' ? true : presenceField().check(value);
    },
  },
  probeAt: optional(vectorField([0, 0, 0], { min: -LIMITS.coordinate, max: LIMITS.coordinate })),
  cameraGroup: textField(),
  gui: flagOrWordsField('gui', 'true, false, folders of the panel or names of attributes', [
    GUI_FOLDERS,
    GUI_ROWS,
  ]),
};

for (const fields of [LIGHT_FIELDS, MESH_FIELDS, VIEWER_FIELDS]) {
  GUI_ROWS.push(...Object.keys(fields).map(attributeOf));
}

/** Assigning the same value again retries what failed. */
export const RETRY_KEYS: ReadonlySet<string> = new Set(['src', 'geometry', 'gui']);

/** Values that the viewer's own mesh, or the loading of all meshes, depends on. */
export const LOADING_KEYS: readonly string[] = [
  ...Object.keys(SHAPE_FIELDS),
  'loading',
  'crossOrigin',
];
