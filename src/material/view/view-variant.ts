// The programs of views that are not the equation's: a material's general program with another text for the colour, and
// without what only colours need. One for each view and general program.
import trianglesVertex from '../../../shaders/view_triangles.vert.glsl?raw';
import { type Variant, variantOf } from '../program/variant.js';
import { SCALE_GLSL } from './scale.js';
import type { Shows } from './view-table.js';

/** What a view shows by programs of its own. */
export type OwnProgram = Exclude<Shows, { by: 'equation' }>;

/**
 * Quantities are of the fragment itself, not averaged, not encoded, and the same whether a surface is lit or emits
 * light.
 */
const DROPPED = [
  'SHADING_GOURAUD',
  'FILTER_HIGHLIGHTS',
  'IS_LINEAR',
  'IS_UNLIT',
  'HAS_EMISSIVE',
  'HAS_EMISSIVE_MAP',
];

const made = new WeakMap<OwnProgram, Map<string, Variant>>();

/** `general` reads its lights from a texture. `grid`: so do the spots of a light grid's cells. */
export function viewVariant(shows: OwnProgram, general: Variant, grid: boolean): Variant {
  let variants = made.get(shows);
  if (variants === undefined) made.set(shows, (variants = new Map<string, Variant>()));
  const key = `${String(grid)} ${general.key}`;
  let variant = variants.get(key);
  if (variant === undefined) variants.set(key, (variant = make(shows, general, grid)));
  return variant;
}

function make(shows: OwnProgram, general: Variant, grid: boolean): Variant {
  const defines: Record<string, string> = { ...general.defines };
  for (const name of DROPPED) Reflect.deleteProperty(defines, name);
  // Programs are told apart by their defines.
  defines['VIEW'] = shows.by;
  switch (shows.by) {
    case 'quantity':
      defines['VIEW_VALUE'] = shows.value;
      break;
    case 'count':
      defines['SCALE_COLOR'] = SCALE_GLSL;
      if ('IS_UNLIT' in general.defines) defines['VIEW_UNLIT'] = '';
      if (grid) defines['HAS_LIGHT_GRID'] = '';
      break;
    case 'triangles': {
      const variant = variantOf(defines, shows.text);
      const vertex = ['#define main shadedMain', variant.vertexShader, '#undef main', trianglesVertex];
      return { ...variant, vertexShader: vertex.join('\n') };
    }
  }
  return variantOf(defines, shows.text);
}
