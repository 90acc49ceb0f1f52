// Everything that the views differ in: what their pixels show, which lights have a part in them,
// and what their legends say. A view of `VIEWS` without an entry does not compile.
import type { Term } from '../../light/light-state.js';
import type { View } from '../views.js';

/**
 * What a view shows. `equation`: all its terms, or one without emissive and unlit colours;
 * materials keep their programs. `quantity`: one of the fragment or of one light, by the function
 * of the view's name in view_quantity.glsl. `triangles`: every triangle for itself, so each has
 * vertices of its own.
 */
export type Shows =
  | { readonly by: 'equation'; readonly term: Term | null }
  | { readonly by: 'quantity' | 'triangles' };

export interface ViewEntry {
  readonly shows: Shows;
  /**
   * The lights that have a part in it. `one`: each light has its own. `view-light` limits `all` to
   * one.
   */
  readonly lights: 'all' | 'one' | 'none';
  /** Title of the legend: a key of the element's texts. */
  readonly title: string;
  /** The same with `reflection="blinn-phong"`, where that differs. */
  readonly blinnTitle?: string;
  /**
   * The legend's scale. `unit`: a number from 0 to 1 in grey; the picture can be all white or all
   * black, as the page behind it can, so it has an outline. `axes`: a colour, −1 to 1 for each
   * axis.
   */
  readonly scale: 'none' | 'unit' | 'axes';
}

const equation = (term: Term | null) => ({ by: 'equation', term }) as const;
const QUANTITY = { by: 'quantity' } as const;

export const VIEW_TABLE = {
  shaded: { shows: equation(null), lights: 'all', title: 'Shaded', scale: 'none' },
  ambient: { shows: equation('ambient'), lights: 'all', title: 'Ambient term', scale: 'none' },
  diffuse: { shows: equation('diffuse'), lights: 'all', title: 'Diffuse term', scale: 'none' },
  specular: { shows: equation('specular'), lights: 'all', title: 'Specular term', scale: 'none' },
  normals: { shows: QUANTITY, lights: 'none', title: 'Normals', scale: 'axes' },
  'n-dot-l': { shows: QUANTITY, lights: 'one', title: 'N · L', scale: 'unit' },
  'r-dot-v': { shows: QUANTITY, lights: 'one', title: 'R · V', blinnTitle: 'N · H', scale: 'unit' },
  attenuation: { shows: QUANTITY, lights: 'one', title: 'Attenuation', scale: 'unit' },
  decay: { shows: QUANTITY, lights: 'one', title: 'Decay', scale: 'unit' },
  triangles: {
    shows: { by: 'triangles' },
    lights: 'none',
    title: 'Triangles',
    scale: 'none',
  },
} as const satisfies Readonly<Record<View, ViewEntry>>;

/** The views of a quantity. */
export type Quantity = {
  [V in View]: (typeof VIEW_TABLE)[V]['shows'] extends typeof QUANTITY ? V : never;
}[View];

/** The GLSL expression of a quantity's colour: `ofLight(viewNDotL(at))`. */
export const viewValue = (view: View): string => {
  const call = `${`-${view}`.replace(/-(\w)/g, (_, letter: string) => letter.toUpperCase())}(at)`;
  const { scale, lights } = viewEntry(view);
  if (scale !== 'unit') return `view${call}`;
  return lights === 'one' ? `ofLight(view${call})` : `vec3(view${call})`;
};

/** The entry of a view, with all its possible fields. */
export const viewEntry = (view: View): ViewEntry => VIEW_TABLE[view];
