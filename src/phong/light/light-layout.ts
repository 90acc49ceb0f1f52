// Where each number of a packed light is, from the table of values (LIGHT_FIELDS): the offsets that
// pack-lights writes to, and the structs that the GLSL reads, so the two cannot disagree. A row is
// a vec4.
import { KINDS, LIGHT_FIELDS, type LightKind, type Packing } from './light-state.js';
import { LEAST_EXPONENT, LIMIT_OPEN, NEAREST, TINY } from './precision.js';

/**
 * Rows before the first light: the number of lights of each kind, and the ambient light that
 * reaches everywhere.
 */
export const HEADER = { counts: 0, ambient: 1, rows: 2 } as const;

/**
 * Rows of a light grid, relative to the row that the counts' w names. `low`: the box's low corner,
 * w = the first cell's row; `scale`: cells per unit, w = the first row of the list of spots, four
 * to a row; `size`: cells along each axis, w = the number of leading spots that stand in no list
 * because they reach most cells. A cell's row: the index of its first spot in the list, and its
 * number of spots.
 */
export const GRID = { low: 0, scale: 1, size: 2, rows: 3 } as const;

type Key = keyof typeof LIGHT_FIELDS;
type Shading<K extends Key> = (typeof LIGHT_FIELDS)[K]['shading'];

const SHADED = Object.entries(LIGHT_FIELDS).flatMap(([key, { shading }]) =>
  typeof shading === 'string' ? [] : [{ key: key as Key, ...(shading as Packing<never>) }],
);

const byKind = <T>(of: (kind: LightKind) => T): Readonly<Record<LightKind, T>> => ({
  directional: of('directional'),
  point: of('point'),
  spot: of('spot'),
});

/** A value in the rows of one kind. */
export interface PackedValue extends Pick<Packing<never>, 'as'> {
  readonly key: Key;
  /** Its name in the GLSL's struct. */
  readonly name: string;
  /** Where its first number is, in floats from the light's first. */
  readonly at: number;
}

/** In x y z. */
const isVector = ({ as }: Pick<PackedValue, 'as'>) => typeof as === 'string' && as !== 'numbers';

/** The packed values of each kind. */
export const PACKED_VALUES = byKind((kind) =>
  SHADED.filter(({ rows }) => kind in rows).map(({ key, as, rows }): PackedValue => {
    const name = as === 'place' && kind === 'directional' ? 'direction' : key;
    return { key, as, name, at: rows[kind]! * 4 + (isVector({ as }) ? 0 : 3) };
  }),
);

/** Where the value of this name begins, in floats from the light's first. */
export const floatOf = (kind: LightKind, name: string): number =>
  PACKED_VALUES[kind].find((value) => value.name === name)!.at;

/**
 * Rows from the first of a light, by the vector in x y z. Lights stand sorted: directional, point,
 * spot.
 */
export const ROWS = byKind((kind): Readonly<Record<string, number>> & { readonly rows: number } => {
  const values = PACKED_VALUES[kind];
  const rows = Math.max(...values.map(({ at, as }) => (at >> 2) + (as === 'numbers' ? 3 : 1)));
  return {
    ...Object.fromEntries(values.filter(isVector).map(({ name, at }) => [name, at / 4])),
    rows,
  };
});

/** The bits of the feature mask, and which lights need them. */
export const FEATURES = SHADED.flatMap(({ features, terms, rows }) =>
  Object.entries(features).map(([name, [now, ever = now]]) => ({ name, now, ever, terms, rows })),
).map((feature, i) => ({ ...feature, bit: 1 << i }));

/** Those that lights of each kind can need. */
export const FEATURES_OF = byKind((kind) => FEATURES.filter(({ rows }) => kind in rows));

type FeatureName = {
  [K in Key]: Shading<K> extends { readonly features: infer F } ? keyof F : never;
}[Key];

/**
 * The code that a light needs beyond its kind, as bits of one mask that the packing and the GLSL
 * share. Each bit adds code, so the union of several lights' masks is right for all of them. Kind
 * bits occur only in the declared mask; packed lights are already sorted by kind. From `powerShift`
 * on a mask holds a spot's cutoff where it is an integer from 1 to LARGEST_INTEGER_POWER; other
 * cutoffs above 0 set `decay`.
 */
export const LIGHT_FEATURES = Object.fromEntries([
  ...[...FEATURES.map(({ name }) => name), ...KINDS].map((name, i) => [name, 1 << i]),
  ['powerShift', FEATURES.length + KINDS.length],
]) as Readonly<Record<FeatureName | LightKind | 'powerShift', number>>;

/**
 * Width of the light texture in texels, one row of a light each: a power of two within every
 * device's limit.
 */
export const TEXTURE_ROWS_LOG2 = 10;

const snake = (name: string) => name.replace(/[A-Z]/g, '_$&').toUpperCase();
const float = (n: number) => (Number.isInteger(n) ? n.toFixed(1) : n.toExponential());

/**
 * Not String(n): V8's number-to-string cache (Chromium 156) grows to 64 KiB for good when numbers
 * collide in it, as these do.
 */
const integer = (n: number) => n.toFixed();

/** `#define` lines for the GLSL. */
export function layoutDefines(): string {
  const lines = [
    `#define LIMIT_OPEN ${float(LIMIT_OPEN)}`,
    `#define TEXTURE_ROWS_LOG2 ${integer(TEXTURE_ROWS_LOG2)}`,
    `#define NEAREST_SQUARED ${float(NEAREST * NEAREST)}`,
    `#define LEAST_EXPONENT ${float(LEAST_EXPONENT)}`,
    `#define TINY ${float(TINY)}`,
  ];
  const lengths = Object.fromEntries(KINDS.map((kind) => [`${kind}Rows`, ROWS[kind].rows]));
  const tables = { HEADER_: HEADER, GRID_: GRID, FEATURE_: LIGHT_FEATURES, '': lengths };
  for (const [table, numbers] of Object.entries(tables)) {
    for (const [name, number] of Object.entries(numbers)) {
      lines.push(`#define ${table}${snake(name)} ${integer(number)}`);
    }
  }
  return lines.join('\n');
}

/**
 * GLSL: for each kind a struct of its packed values, SpotLight, and the function of its first row,
 * spotLight(row).
 */
export const lightStructs = (): string =>
  KINDS.map((kind) => {
    const type = `${kind.charAt(0).toUpperCase()}${kind.slice(1)}Light`;
    const values = PACKED_VALUES[kind];
    const members = values.map(
      ({ as, name }) => `${typeof as === 'string' ? 'vec3' : 'float'} ${name};`,
    );
    const rows = Array.from(
      { length: ROWS[kind].rows },
      (_, i) => `vec4 r${i}=lightRow(row+${i});`,
    );
    const numbers = values.map((value) => {
      const row = value.at >> 2;
      if (isVector(value)) return `r${row}.xyz`;
      return value.as === 'numbers' ? `vec3(r${row}.w,r${row + 1}.w,r${row + 2}.w)` : `r${row}.w`;
    });
    return `struct ${type}{${members.join('')}};
${type} ${kind}Light(int row){${rows.join('')}return ${type}(${numbers.join()});}`;
  }).join('\n');
