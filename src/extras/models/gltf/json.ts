// Reads values from untrusted JSON. Each reader throws a plain Error that names the wrong value, or
// `too-large`.
import { requireAtMost } from '../../../phong/model/budget.js';
import { JSON_LIST_LIMIT, JSON_NAME_LIMIT } from '../limits.js';

export type JsonObject = Readonly<Record<string, unknown>>;

export function objectAt(value: unknown, what: string): JsonObject {
  if (isObject(value)) return value;
  throw new Error(`${what} is not an object`);
}

const isObject = (value: unknown): value is JsonObject =>
  typeof value === 'object' && value !== null && !Array.isArray(value);

/** As {@link objectAt}; an absent value gives an empty object. */
export const optionalObject = (value: unknown, what: string) =>
  value === undefined ? {} : objectAt(value, what);

/** A list of objects; an absent value gives an empty list. */
export function objectsAt(value: unknown, what: string): readonly JsonObject[] {
  const list = listAt(value, what);
  list.forEach((item, i) => {
    if (!isObject(item)) throw new Error(`${what}[${String(i)}] is not an object`);
  });
  return list as readonly JsonObject[];
}

/** A list; an absent value gives an empty list. */
export function listAt(value: unknown, what: string): readonly unknown[] {
  if (value === undefined) return [];
  if (Array.isArray(value)) return value as readonly unknown[];
  throw new Error(`${what} is not a list`);
}

/** As {@link listAt}, of a list that is read in one task. */
export function shortListAt(
  value: unknown,
  what: string,
  limit = JSON_LIST_LIMIT,
): readonly unknown[] {
  const list = listAt(value, what);
  requireAtMost(list.length, limit, `values in ${what}`);
  return list;
}

/** The names in an object. */
export function namesIn(object: JsonObject, what: string): readonly string[] {
  const names = Object.keys(object);
  requireAtMost(names.length, JSON_NAME_LIMIT, `names in ${what}`);
  return names;
}

/** A whole number >= 0; an absent value gives `fallback`. */
export function countAt(value: unknown, what: string, fallback?: number): number {
  if (value === undefined && fallback !== undefined) return fallback;
  if (typeof value === 'number' && Number.isSafeInteger(value) && value >= 0) return value;
  throw new Error(`${what} is not a whole number`);
}

/** An index into a list of the given length. */
export function indexAt(value: unknown, length: number, what: string): number {
  const index = countAt(value, what);
  if (index < length) return index;
  throw new Error(`${what} is ${String(index)}, but there are only ${String(length)}`);
}

/** As {@link indexAt}; an absent value stays absent. */
export const optionalIndex = (value: unknown, length: number, what: string) =>
  value === undefined ? undefined : indexAt(value, length, what);

/** Exactly `length` finite numbers, or undefined if absent. */
export function numbersAt(
  value: unknown,
  length: number,
  what: string,
): readonly number[] | undefined {
  if (value === undefined) return undefined;
  const list = listAt(value, what);
  const isFinite = (item: unknown): item is number => Number.isFinite(item);
  // The length first: others can be millions long.
  if (list.length === length && list.every(isFinite)) return list;
  throw new Error(`${what} is not ${String(length)} numbers`);
}

/** A finite number; an absent value gives `fallback`. */
export function numberAt(value: unknown, what: string, fallback: number): number {
  if (value === undefined) return fallback;
  if (typeof value === 'number' && Number.isFinite(value)) return value;
  throw new Error(`${what} is not a number`);
}

export const textAt = (value: unknown) => (typeof value === 'string' ? value : '');
