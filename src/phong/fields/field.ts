// A declared value's default, its domain in words, and the one check for all that sets it:
// attributes, properties and the plain objects of `phong-viewer/core`. Values are in HTML's units
// (degrees, 255 = full colour).
import type { Vec3, Vec4 } from '../math/vector.js';
import { clip } from './clip.js';

/** How a value is written as text; selects the element's parser and formatter. */
export type FieldKind =
  | 'number'
  | 'numbers'
  | 'color'
  | 'boolean'
  | 'presence'
  | 'text'
  | 'choice'
  | 'words'
  | 'flag-or-words';

/** A declared value's default and domain. */
export interface Field<T> {
  readonly kind: FieldKind;
  /** A word allowed in place of the value: `auto`. */
  readonly word?: string;
  /** The meaning of the empty attribute, if it has one: `crossorigin` alone means `anonymous`. */
  readonly empty?: T;
  /** The words to choose from, if the value is one of several. */
  readonly choices?: readonly string[];
  /** The default: used if nothing, or nothing valid, is given. Frozen. */
  readonly fallback: T;
  /** The domain as a noun phrase, for warnings and errors: "a number from 0 to 180". */
  readonly expected: string;
  /**
   * Returns the value to store (arrays are copied). Throws `TypeError` for the wrong kind of value
   * and `RangeError` for a value outside the domain. NaN and ±Infinity are always outside.
   */
  check(value: unknown): T;
}

export interface Range {
  readonly min?: number;
  readonly max?: number;
  /** Exclusive lower bound. */
  readonly above?: number;
  readonly integer?: boolean;
}

const spell = (n: number) =>
  Math.abs(n) >= 1e5 ? n.toExponential().replace('e+', 'e') : String(n);

function rangeWords({ min, max, above, integer }: Range): string {
  const kind = integer === true ? 'whole number' : 'number';
  if (above !== undefined && max !== undefined) {
    return `${kind} above ${spell(above)}, up to ${spell(max)}`;
  }
  if (min !== undefined && max !== undefined) return `${kind} from ${spell(min)} to ${spell(max)}`;
  return kind;
}

/** Items of a list that a message repeats. */
const ITEMS_SHOWN = 5;

/** A value in a message, clipped. Lists in lists, which may contain themselves, are objects. */
export function show(value: unknown): string {
  if (!Array.isArray(value)) return showItem(value);
  const rest = value.length > ITEMS_SHOWN ? ', ...' : '';
  return `[${value.slice(0, ITEMS_SHOWN).map(showItem).join(', ')}${rest}]`;
}

function showItem(value: unknown): string {
  if (typeof value === 'string') return JSON.stringify(clip(value));
  if (typeof value === 'function') return 'a function';
  if (typeof value === 'object' && value !== null) return 'an object';
  return clip(String(value));
}

const wrong = (expected: string, value: unknown): TypeError =>
  new TypeError(`expected ${expected}, got ${show(value)}`);

export const outside = (expected: string, value: unknown): RangeError =>
  new RangeError(`expected ${expected}, got ${show(value)}`);

/** Checks a single number, or one of the numbers of `whole`, which the error shows. */
function numberCheck(
  { min = -Number.MAX_VALUE, max = Number.MAX_VALUE, above = -Infinity, integer = false }: Range,
  expected: string,
): (value: unknown, whole?: unknown) => number {
  return (value, whole = value) => {
    if (typeof value !== 'number') throw wrong(expected, whole);
    if (value >= min && value <= max && value > above && (!integer || Number.isInteger(value))) {
      return value + 0; // -0 would show as "0" and divide as "-"
    }
    throw outside(expected, value);
  };
}

export function numberField(fallback: number, range: Range): Field<number> {
  const expected = `a ${rangeWords(range)}`;
  return { kind: 'number', fallback, expected, check: numberCheck(range, expected) };
}

/**
 * A tuple of numbers, each in the same range. `finish` completes a shorter list without writing to
 * it.
 */
function tupleField<T extends Vec3 | Vec4>(
  fallback: T,
  range: Range,
  words?: string,
  finish?: (numbers: readonly unknown[]) => readonly unknown[],
): Field<T> {
  const size = fallback.length;
  const expected = words ?? `${String(size)} numbers, each a ${rangeWords(range)}`;
  const at = numberCheck(range, expected);
  return {
    kind: 'numbers',
    fallback: Object.freeze([...fallback]) as unknown as T,
    expected,
    check(value) {
      if (!isList(value)) throw wrong(expected, value);
      const n = finish === undefined ? value : finish(value);
      if (n.length !== size) throw wrong(expected, value);
      // Moving lights do this every frame: one pass into a literal, without an iterator.
      const x = at(n[0], value);
      const y = at(n[1], value);
      const z = at(n[2], value);
      return (size === 3 ? [x, y, z] : [x, y, z, at(n[3], value)]) as unknown as T;
    },
  };
}

/**
 * Any number of numbers in ascending order, at least one; a single one may stand alone. `expected`
 * says so.
 */
export function numbersField(expected: string, min: number, max: number): Field<readonly number[]> {
  const at = numberCheck({ min, max }, expected);
  return {
    kind: 'numbers',
    fallback: Object.freeze([]),
    expected,
    check(value) {
      if (
        isList(value) ? value.length === 0 || value.length > MOST_WORDS : typeof value !== 'number'
      ) {
        throw wrong(expected, value);
      }
      const numbers = (isList(value) ? Array.from(value) : [value]).map((n) => at(n, value));
      if (numbers.some((n, i) => i > 0 && n < numbers[i - 1]!)) throw outside(expected, value);
      return numbers;
    },
  };
}

const isList = (value: unknown): value is readonly unknown[] =>
  Array.isArray(value) || (ArrayBuffer.isView(value) && !(value instanceof DataView));

export const vectorField = (fallback: Vec3, range: Range): Field<Vec3> =>
  tupleField(fallback, range);

/** x y z w, w being 0 (a direction) or 1 (a position); three numbers mean w = 1. */
export function homogeneousField(fallback: Vec4, range: Range): Field<Vec4> {
  const expected = `3 or 4 numbers x y z w, each a ${rangeWords(range)}, w 0 or 1`;
  const tuple = tupleField(fallback, range, expected, (n) => (n.length === 3 ? [...n, 1] : n));
  return {
    ...tuple,
    check(value) {
      const numbers = tuple.check(value);
      if (numbers[3] !== 0 && numbers[3] !== 1) throw outside(expected, value);
      return numbers;
    },
  };
}

/** One number means the same on all three axes. */
export const scaleField = (fallback: Vec3, range: Range): Field<Vec3> =>
  repeatedField(fallback, range, `1 or 3 numbers, each a ${rangeWords(range)}`);

/** Three channels where 255 is full; one number means grey. */
export function colorField(fallback: Vec3, range: Range): Field<Vec3> {
  const expected = `r g b (or one number), each a ${rangeWords(range)} with 255 full, or a CSS colour in sRGB`;
  return { ...repeatedField(fallback, range, expected), kind: 'color' };
}

/** Three numbers, or one, alone or in a list, that stands for all three. */
function repeatedField(fallback: Vec3, range: Range, expected: string): Field<Vec3> {
  const tuple = tupleField(fallback, range, expected, (n) =>
    n.length === 1 ? [...n, ...n, ...n] : n,
  );
  return { ...tuple, check: (value) => tuple.check(typeof value === 'number' ? [value] : value) };
}

/** True by default. */
export const booleanField = (): Field<boolean> =>
  typeField<boolean>('boolean', true, 'true or false');

/** True if present, like HTML's own boolean attributes, except for the text `false`. */
export const presenceField = (): Field<boolean> =>
  typeField<boolean>('presence', false, 'true or false');

export const textField = (fallback = '', expected = 'text'): Field<string> =>
  typeField('text', fallback, expected);

/** Any value of the default's type. */
const typeField = <T extends boolean | string>(
  kind: FieldKind,
  fallback: T,
  expected: string,
): Field<T> => ({
  kind,
  fallback,
  expected,
  check(value) {
    if (typeof value !== typeof fallback) throw wrong(expected, value);
    return value as T;
  },
});

/** One of these words; the first is the default. */
export function choiceField<T extends string>(choices: readonly T[]): Field<T> {
  const expected = `one of ${choices.map((c) => (c === '' ? '(empty)' : c)).join(', ')}`;
  return {
    kind: 'choice',
    choices,
    fallback: choices[0]!,
    expected,
    check(value) {
      if (typeof value !== 'string') throw wrong(expected, value);
      const choice = choices.find((c) => c === value);
      if (choice === undefined) throw outside(expected, value);
      return choice;
    },
  };
}

/**
 * Words that a list may repeat. An empty list of length 2^32 - 1 would take 32 GB once it is
 * spread.
 */
const MOST_WORDS = 1000;

/** Any subset of the choices, in the choices' order, each once. */
export function subsetField<T extends string>(
  choices: readonly T[],
  fallback: readonly T[] = choices,
): Field<readonly T[]> {
  const expected = `any of ${choices.join(', ')}`;
  return {
    kind: 'words',
    fallback: Object.freeze([...fallback]),
    expected,
    check(value) {
      // Spread first: holes become undefined, which is no word.
      const words: readonly unknown[] | null =
        Array.isArray(value) && value.length <= MOST_WORDS ? [...(value as unknown[])] : null;
      if (words?.every((word) => typeof word === 'string') !== true) throw wrong(expected, value);
      const stray = words.find((word) => !(choices as readonly unknown[]).includes(word));
      if (stray !== undefined) throw outside(expected, stray);
      return Object.freeze(choices.filter((choice) => words.includes(choice)));
    },
  };
}

/**
 * False; true if present without a value or with its own name, as in HTML; or a list of words, all
 * from one of `lists`, in the order given, each once.
 */
export function flagOrWordsField(
  own: string,
  expected: string,
  lists: readonly (readonly string[])[],
): Field<boolean | readonly string[]> {
  return {
    kind: 'flag-or-words',
    fallback: false,
    expected,
    check(value) {
      if (typeof value === 'boolean') return value;
      if (!Array.isArray(value) || value.length > MOST_WORDS) throw wrong(expected, value);
      const words: readonly unknown[] = [...(value as unknown[])];
      if (words.length === 1 && words[0] === own) return true;
      if (
        !lists.some((list) => words.every((word) => (list as readonly unknown[]).includes(word)))
      ) {
        throw outside(expected, words);
      }
      return words.length > 0 && Object.freeze([...new Set(words as readonly string[])]);
    },
  };
}

/** A value that may be absent: null if nothing is given. */
export const optional = <T>(field: Field<T>): Field<T | null> => ({ ...field, fallback: null });

/** Another field's value, or `auto` in its place, which is the default. */
export function orAuto<T>(field: Field<T>): Field<T | 'auto'> {
  const expected = `auto or ${field.expected}`;
  return {
    ...field,
    word: 'auto',
    fallback: 'auto',
    expected,
    check(value) {
      if (value === 'auto') return value;
      try {
        return field.check(value);
      } catch (error) {
        // The field's own message does not mention the word.
        if (error instanceof RangeError) throw outside(expected, value);
        throw wrong(expected, value);
      }
    },
  };
}
