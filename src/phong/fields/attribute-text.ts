// Attribute text to values and back. One contract for every kind: `parseText` returns a value for
// the field's own check, or undefined if the text is malformed. It never throws and never guesses.
// Domains are checked by the fields.
import { show, type Field, type FieldKind } from './field.js';
import { didYouMean } from './nearest.js';
import type { Vec3 } from '../math/vector.js';

// Each digit matches in one way only, so that a long text that is not a number is refused in linear
// time.
const NUMBER = /^[+-]?(\d+(\.\d*)?|\.\d+)(e[+-]?\d+)?$/i;

function parseNumber(text: string): number | undefined {
  const trimmed = text.trim();
  return NUMBER.test(trimmed) ? Number(trimmed) : undefined;
}

/** Numbers separated by white space or single commas. */
function parseNumbers(text: string): readonly number[] | undefined {
  const numbers = text
    .trim()
    .split(/\s*,\s*|\s+/)
    .map(parseNumber);
  return numbers.includes(undefined) ? undefined : (numbers as readonly number[]);
}

function parseFlag(text: string): boolean | undefined {
  const word = text.trim().toLowerCase();
  if (word === '' || word === 'true') return true;
  return word === 'false' ? false : undefined;
}

const parseWords = (text: string): readonly string[] =>
  text
    .toLowerCase()
    .split(/[\s,]+/)
    .filter((word) => word !== '');

/** Parses a CSS colour; null for other text. */
type ColorParser = (text: string) => Vec3 | null;

const PARSERS: Readonly<
  Record<FieldKind, (text: string, colorOf: ColorParser | undefined) => unknown>
> = {
  number: parseNumber,
  numbers: parseNumbers,
  color: (text, colorOf) => parseNumbers(text) ?? colorOf?.(text) ?? undefined,
  boolean: parseFlag,
  // Like HTML's own boolean attributes: no text is malformed.
  presence: (text) => parseFlag(text) ?? true,
  text: (text) => text,
  choice: (text) => text.trim().toLowerCase(),
  words: parseWords,
  'flag-or-words': (text) => parseFlag(text) ?? parseWords(text),
};

/**
 * A value for `field.check`, or undefined if the text is malformed. Colours are numbers, or what
 * `colorOf` knows.
 */
export function parseText(text: string, field: Field<unknown>, colorOf?: ColorParser): unknown {
  const word = text.trim().toLowerCase();
  if (field.word !== undefined && word === field.word) return field.word;
  if (field.empty !== undefined && word === '') return field.empty;
  return PARSERS[field.kind](text, colorOf);
}

/**
 * The attribute text that {@link parseText} reads as this value; null if the attribute must be
 * absent.
 */
export function formatValue(value: unknown, field: Field<unknown>): string | null {
  if (field.kind === 'presence' || field.kind === 'flag-or-words') {
    if (typeof value === 'boolean') return value ? '' : null;
  }
  if (value === null || value === undefined) return null;
  // The empty attribute would mean something else.
  if (field.empty !== undefined && Array.isArray(value) && value.length === 0) return null;
  return Array.isArray(value) ? value.join(' ') : `${value as string | number | boolean}`;
}

/** The attribute of a property: `auto-rotate` for `autoRotate`; `crossorigin` as in HTML. */
export const attributeOf = (key: string): string =>
  key === 'crossOrigin'
    ? 'crossorigin'
    : key.replace(/[A-Z]/g, (letter) => `-${letter.toLowerCase()}`);

/** What is wrong with a declared value, and what is used instead. */
export function valueWarning(
  tag: string,
  key: string,
  value: unknown,
  { expected, fallback, choices }: Field<unknown>,
): string {
  const words = Array.isArray(fallback)
    ? fallback.join(' ')
    : (fallback as { toString(): string } | null);
  const instead = words?.toString() || 'none';
  const hint =
    typeof value === 'string' ? didYouMean(value.trim().toLowerCase(), choices ?? []) : '';
  return `<${tag}> ${attributeOf(key)}=${show(value)}: expected ${expected}; using ${instead} instead.${hint}`;
}
