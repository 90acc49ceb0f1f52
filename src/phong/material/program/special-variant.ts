// Specialised variants: derived from a material's general variant for the lights that a mesh is drawn
// with now.
import lightGrid from '../../../../shaders/light_grid.glsl?raw';
import { kindFeatures } from '../../light/kind-features.js';
import { HEADER, ROWS } from '../../light/light-layout.js';
import { KINDS, type LightKind, type Term } from '../../light/light-state.js';
import { forEachLight, type PackedLights } from '../../light/pack-lights.js';
import { DECLARED, maskOf, storageDefines, type Variant, variantOf } from './variant.js';

/** What a specialised variant takes from its material besides the general variant. */
export interface MaterialTerms {
  readonly terms: readonly Term[];
  /** The specular exponent where it is an integer that is multiplied out; else null. */
  readonly integerShininess: number | null;
}

/**
 * How a specialised variant holds its lights. `counted`: loops of literal length, which a GPU's
 * compiler unrolls. `inlined`: each light by itself with its numbers as constants, which a software
 * renderer's compiler folds. `grid`: run-time loops over the lights of the fragment's cell, from a
 * texture.
 */
export const FORMS = ['counted', 'inlined', 'grid'] as const;
export type Form = (typeof FORMS)[number];

export function specialisedVariant(
  general: Variant,
  { terms, integerShininess }: MaterialTerms,
  form: Form,
  packed: Readonly<PackedLights>,
): Variant {
  const defines: Record<string, string> = { ...general.defines };
  const mask = maskOf(terms);
  defines[DECLARED] = String(Number(defines[DECLARED]) & mask);
  if (integerShininess !== null) {
    defines['INTEGER_SHININESS'] = String(integerShininess);
  }
  if (form !== 'counted') {
    delete defines['LIGHT_ROWS'];
  }
  switch (form) {
    case 'counted':
      defines['LIGHT_STATEMENTS'] = countedLoops(packed, mask);
      break;
    case 'inlined':
      defines['LIGHT_STORAGE'] = 'STORAGE_INLINED';
      defines['LIGHT_ROW_LITERALS'] = rowLiterals(packed);
      defines['LIGHT_STATEMENTS'] = calls(packed, mask);
      break;
    case 'grid':
      Object.assign(defines, storageDefines(0), { HAS_LIGHT_GRID: '' });
      for (const [kind, features] of Object.entries(kindFeatures(packed))) {
        defines[`${kind.toUpperCase()}_FEATURES`] = String(features & mask);
      }
  }
  return variantOf(defines, undefined, form === 'grid' ? lightGrid : '');
}

/**
 * Most lights whose rows have literal addresses too. An H200's driver unrolls such loops: 16 lights
 * take 0.71 of MeshPhongMaterial's time instead of 0.82. But with 32 the first frame takes 65 ms
 * longer (OpenGL), without 29.
 */
const MOST_UNROLLED = 16;

/** A loop for each kind, its bounds literals. */
function countedLoops(packed: Readonly<PackedLights>, mask: number): string {
  const features = kindFeatures(packed);
  const unrolled = packed.sent <= MOST_UNROLLED;
  let first: number = HEADER.rows;
  const loops = KINDS.map((kind) => {
    const { rows } = ROWS[kind];
    const row = unrolled ? `${String(first)}+i*${String(rows)}` : 'row';
    const step = unrolled ? '' : `,row+=${String(rows)}`;
    const count = packed.counts[kind];
    first += count * rows;
    const call = add(kind, row, features[kind] & mask);
    return count > 0 ? `for(int i=0;i<${String(count)};i++${step})${call}` : '';
  });
  return (unrolled ? '' : `int row=${String(HEADER.rows)};`) + loops.join('');
}

function calls(packed: Readonly<PackedLights>, mask: number): string {
  let text = '';
  forEachLight(packed, (light, kind, row) => {
    text += add(kind, String(row), packed.features[light]! & mask);
  });
  return text;
}

/** Adds one light; the arguments besides row and features are lightSums' own. */
const add = (kind: LightKind, row: string, features: number): string =>
  `add${kind.charAt(0).toUpperCase()}${kind.slice(1)}(sums,${row},p,N,view,n,${String(features)});`;

/** All rows as a GLSL array. Nine digits are all that float32 has. */
function rowLiterals({ data, rows }: Readonly<PackedLights>): string {
  const row = (i: number): string =>
    `vec4(${Array.from(data.subarray(i * 4, i * 4 + 4), (x) => x.toExponential(8)).join()})`;
  return `vec4[](${Array.from({ length: rows }, (_, i) => row(i)).join()})`;
}
