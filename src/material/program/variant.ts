// Which code does a program hold? A variant is the defines of one program and its text. The general variant of a material works
// for any number of its lights; specialised variants are made from it for the lights at hand.
import { forEachLight, type PackedLights } from '../../light/pack-lights.js';
import {
  type DeclaredFeatures,
  KINDS,
  type LightKind,
  noFeatures,
  unionOf,
} from '../../light/light-features.js';
import { HEADER, LIGHT_FEATURES, ROWS } from '../../light/light-layout.js';
import { type Shaders, shadersOf } from './source.js';

export type Shading = 'phong' | 'gouraud' | 'flat';
export type Reflection = 'phong' | 'blinn-phong';
export type Term = 'ambient' | 'diffuse' | 'specular';
export type Antialias = 'edges' | 'highlights';
export type AlphaMode = 'opaque' | 'mask' | 'blend';

export const SHADINGS = ['phong', 'gouraud', 'flat'] as const satisfies readonly Shading[];
export const REFLECTIONS = ['phong', 'blinn-phong'] as const satisfies readonly Reflection[];
export const ANTIALIASES = ['edges', 'highlights'] as const satisfies readonly Antialias[];
export const TERMS = ['ambient', 'diffuse', 'specular'] as const satisfies readonly Term[];

/** How a material shades, besides its colours. */
export interface MaterialStyle {
  readonly shading: Shading;
  readonly reflection: Reflection;
  readonly terms: readonly Term[];
  readonly antialias: Antialias;
}

/** What a general variant depends on; `terms` are those whose code is needed. */
export interface MaterialFeatures extends MaterialStyle {
  /** Shading happens in linear light: `color-interpolation="linear"`. */
  readonly linear: boolean;
  /** All exponents so far were 64 at most. */
  readonly shininessTo64: boolean;
  readonly vertexColors: boolean;
  readonly alphaMode: AlphaMode;
  readonly unlit: boolean;
  readonly emissive: boolean;
  readonly metalness: boolean;
  /** A texture gives the roughness. */
  readonly roughness: boolean;
  /** The maps that are sampled, and the set of texture coordinates of each, 0–3. */
  readonly maps: Readonly<Partial<Record<MapName, number>>>;
}

export type MapName = 'map' | 'emissiveMap' | 'metalRoughMap' | 'normalMap';

/** Each map's name in the shaders: `HAS_…`, `…_UV`. */
const MAP_DEFINES: Readonly<Record<MapName, string>> = {
  map: 'MAP',
  emissiveMap: 'EMISSIVE_MAP',
  metalRoughMap: 'METAL_ROUGH_MAP',
  normalMap: 'NORMAL_MAP',
};

/** The defines and the text of one program; `key` tells variants apart. */
export interface Variant extends Shaders {
  readonly defines: Readonly<Record<string, string>>;
  readonly key: string;
}

/** Where the general program reads rows: a uniform array of so many, or (0) a texture. */
export type RowCapacity = number;

/** The variant for any number of lights with the declared features. */
export function generalVariant(
  material: MaterialFeatures,
  declared: Readonly<DeclaredFeatures>,
  capacity: RowCapacity,
): Variant {
  const { shading, reflection, terms, antialias, alphaMode, unlit } = material;
  const { steepSpot, spotAmbient, ...needed } = unlit ? noFeatures() : declared;
  for (const term of TERMS) needed[term] &&= terms.includes(term);
  const flags: Record<string, boolean> = {
    // Flat differs from phong in its geometry alone: every vertex carries its triangle's own normal.
    SHADING_GOURAUD: shading === 'gouraud',
    REFLECTION_BLINN_PHONG: reflection === 'blinn-phong',
    // A vertex has no pixel to average over.
    FILTER_HIGHLIGHTS: antialias === 'highlights' && needed.specular && shading !== 'gouraud',
    SHININESS_TO_64: material.shininessTo64,
    IS_LINEAR: material.linear,
    IS_UNLIT: unlit,
    HAS_EMISSIVE: material.emissive,
    HAS_METALNESS: material.metalness,
    HAS_ROUGHNESS: material.roughness,
    HAS_VERTEX_COLOR: material.vertexColors,
    HAS_ALPHA_MASK: alphaMode === 'mask',
    IS_BLENDED: alphaMode === 'blend',
    SPOTS_ARE_GENTLE: needed.spot && !steepSpot,
    SPOTS_LACK_AMBIENT: needed.spot && needed.ambient && !spotAmbient,
  };
  for (const [name, on] of Object.entries(needed)) flags[`HAS_${name.toUpperCase()}`] = on;
  const defines: Record<string, string> = storageDefines(capacity);
  for (const [name, on] of Object.entries(flags)) if (on) defines[name] = '';
  for (const [name, set] of Object.entries(material.maps)) {
    const define = MAP_DEFINES[name as MapName];
    const uv = set === 0 ? 'uv' : `uv${String(set)}`;
    Object.assign(defines, { [`HAS_${define}`]: '', [`${define}_UV`]: uv, [`HAS_${uv.toUpperCase()}`]: '' });
  }
  return variantOf(defines);
}

const storageDefines = (capacity: RowCapacity): Record<string, string> =>
  capacity > 0
    ? { LIGHT_STORAGE: 'STORAGE_UNIFORMS', LIGHT_ROWS: String(capacity) }
    : { LIGHT_STORAGE: 'STORAGE_TEXTURE' };

/** Defines in one order, because three.js's program key depends on it. `surface` as in {@link shadersOf}; the defines name it. */
export function variantOf(defines: Readonly<Record<string, string>>, surface?: string): Variant {
  const sorted = Object.entries(defines).sort(([a], [b]) => (a < b ? -1 : 1));
  const ordered = Object.fromEntries(sorted);
  return {
    defines: ordered,
    key: sorted.map((pair) => pair.join('=')).join(' '),
    ...shadersOf(ordered, surface),
  };
}

/** What a specialised variant takes from its material besides the general variant. */
export interface MaterialTerms {
  /** The terms that are summed now. */
  readonly terms: readonly Term[];
  /** The specular exponent where it is an integer that is multiplied out; else null. */
  readonly integerShininess: number | null;
}

/** How a specialised variant holds its lights. */
export type Form = 'counted' | 'inlined' | 'grid';

/**
 * The variant for exactly these lights. `counted`: loops of literal length, which a GPU's compiler unrolls. `inlined`: each
 * light by itself with its numbers as constants, which a software renderer's compiler folds. `grid`: run-time loops over the
 * lights of the fragment's cell.
 */
export function specialisedVariant(
  { defines }: Variant,
  { terms, integerShininess }: MaterialTerms,
  form: Form,
  packed: Readonly<PackedLights>,
): Variant {
  const needed: Record<string, string> = { ...defines };
  if (!terms.includes('ambient')) delete needed['HAS_AMBIENT'];
  if (integerShininess !== null) needed['INTEGER_SHININESS'] = String(integerShininess);
  if (form === 'grid') {
    Object.assign(needed, { ...storageDefines(0), HAS_LIGHT_GRID: '' });
    delete needed['LIGHT_ROWS'];
  }
  if (form === 'inlined') {
    needed['LIGHT_STORAGE'] = 'STORAGE_INLINED';
    needed['LIGHT_ROW_LITERALS'] = rowLiterals(packed);
    delete needed['LIGHT_ROWS'];
  }
  needed['LIGHT_STATEMENTS'] = STATEMENTS[form](packed, termMask(terms));
  return variantOf(needed);
}

/** Adds one light; the arguments besides row and features are lightSums' own. */
const add = (kind: LightKind, row: string, features: number): string =>
  `add${kind.charAt(0).toUpperCase()}${kind.slice(1)}(sums,${row},p,N,view,n,${String(features)});`;

/**
 * Most turns of a counted loop. An H200's compiler unrolls loops of 32, which read each row as an operand; beyond 64 it does
 * not, and each row costs a load.
 */
const MOST_TURNS = 32;

const STATEMENTS: Readonly<Record<Form, (packed: Readonly<PackedLights>, mask: number) => string>> = {
  counted(packed, mask) {
    const features = unions(packed, mask);
    let text = '';
    forEachRun(packed, (kind, row, length) => {
      for (let first = 0; first < length; first += MOST_TURNS) {
        const turns = Math.min(length - first, MOST_TURNS);
        const start = row + first * ROWS[kind].rows;
        const each = add(kind, `${String(start)}+i*${String(ROWS[kind].rows)}`, features[kind]);
        text += `for(int i=0;i<${String(turns)};i++)${each}`;
      }
    });
    return text;
  },
  inlined(packed, mask) {
    let text = '';
    forEachLight(packed, (light, kind, row) => {
      text += add(kind, String(row), packed.features[light]! & mask);
    });
    return text;
  },
  grid(packed, mask) {
    const { directional, point, spot } = unions(packed, mask);
    const loop = (kind: LightKind, count: string, features: number): string =>
      `for(int i=0;i<${count};i++,row+=${String(ROWS[kind].rows)})${add(kind, 'row', features)}`;
    return [
      'ivec3 counts=ivec3(lightRow(HEADER_COUNTS).xyz);int row=HEADER_ROWS;',
      loop('directional', 'counts.x', directional),
      loop('point', 'counts.y', point),
      loop('spot', 'unlistedSpots()', spot),
      'CellSpots cell=cellSpots(p);',
      `for(int i=0;i<cell.count;i++)${add('spot', 'listedRow(cell.first+i)', spot)}`,
    ].join('');
  },
};

function forEachRun(
  { counts }: Readonly<PackedLights>,
  visit: (kind: LightKind, row: number, length: number) => void,
): void {
  let row: number = HEADER.rows;
  for (const kind of KINDS) {
    if (counts[kind] > 0) visit(kind, row, counts[kind]);
    row += counts[kind] * ROWS[kind].rows;
  }
}

/** For each kind, the features that any of its lights needs. */
export function unions(
  { counts, features }: Readonly<PackedLights>,
  mask: number,
): Record<LightKind, number> {
  const all: Record<LightKind, number> = { directional: 0, point: 0, spot: 0 };
  let light = 0;
  for (const kind of KINDS) {
    for (let i = 0; i < counts[kind]; i++, light++) {
      const own = features[light]! & mask;
      all[kind] = i === 0 ? own : unionOf(all[kind], own);
    }
  }
  return all;
}

/** All feature bits but those of terms that are not summed. */
function termMask(terms: readonly Term[]): number {
  let dropped = 0;
  if (!terms.includes('ambient')) dropped |= LIGHT_FEATURES.ambient;
  if (!terms.includes('diffuse')) dropped |= LIGHT_FEATURES.diffuse | LIGHT_FEATURES.tintedDiffuse;
  if (!terms.includes('specular')) dropped |= LIGHT_FEATURES.specular | LIGHT_FEATURES.tintedSpecular;
  return ~dropped;
}

/** All rows as a GLSL array. Nine digits are all that float32 has. */
function rowLiterals({ data, rows }: Readonly<PackedLights>): string {
  const row = (i: number): string =>
    `vec4(${Array.from(data.subarray(i * 4, i * 4 + 4), (x) => x.toExponential(8)).join()})`;
  return `vec4[](${Array.from({ length: rows }, (_, i) => row(i)).join()})`;
}
