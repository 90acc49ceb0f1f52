// Which program shows a quantity in place of the shaded colour? A material's general program with another text for the colour, and
// without what only colours need. One for each view and general program. Knows no lights.
import viewCount from '../../../shaders/view_count.glsl?raw';
import viewQuantity from '../../../shaders/view_quantity.glsl?raw';
import viewTriangles from '../../../shaders/view_triangles.glsl?raw';
import viewTrianglesVertex from '../../../shaders/view_triangles.vert.glsl?raw';
import { type Variant, variantOf } from '../program/variant.js';
import { SCALE_GLSL } from './scale.js';

/** The views with programs of their own. */
export type DrawnView = keyof typeof TEXTS;

const TEXTS = {
  normals: viewQuantity,
  'n-dot-l': viewQuantity,
  'r-dot-v': viewQuantity,
  attenuation: viewQuantity,
  decay: viewQuantity,
  'light-count': viewCount,
  triangles: viewTriangles,
} as const;

export const isDrawnView = (view: string): view is DrawnView => view in TEXTS;

/** Quantities are of the fragment itself, not averaged, not encoded, and the same whether a surface is lit or emits light. */
const DROPPED = [
  'SHADING_GOURAUD',
  'FILTER_HIGHLIGHTS',
  'IS_LINEAR',
  'IS_UNLIT',
  'HAS_EMISSIVE',
  'HAS_EMISSIVE_MAP',
];

const made = new Map<string, Variant>();

/** `general` reads its lights from a texture. `grid`: so do the spots of a light grid's cells. */
export function viewVariant(view: DrawnView, general: Variant, grid: boolean): Variant {
  const key = `${view} ${String(grid)} ${general.key}`;
  let variant = made.get(key);
  if (variant === undefined) made.set(key, (variant = make(view, general, grid)));
  return variant;
}

function make(view: DrawnView, general: Variant, grid: boolean): Variant {
  const defines: Record<string, string> = { ...general.defines };
  for (const name of DROPPED) Reflect.deleteProperty(defines, name);
  defines[`VIEW_${view.replaceAll('-', '_').toUpperCase()}`] = '';
  if (view === 'light-count') {
    defines['SCALE_COLOR'] = SCALE_GLSL;
    if ('IS_UNLIT' in general.defines) defines['VIEW_UNLIT'] = '';
    if (grid) defines['HAS_LIGHT_GRID'] = '';
  }
  const variant = variantOf(defines, TEXTS[view]);
  if (view !== 'triangles') return variant;
  const vertexShader = ['#define main shadedMain', variant.vertexShader, '#undef main', viewTrianglesVertex];
  return { ...variant, vertexShader: vertexShader.join('\n') };
}
