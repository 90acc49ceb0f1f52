// The declared values of one light, mesh or viewer: each has its default until it is set, is
// checked when it is set, and notifies one listener when it changes.
import { type Field, show } from './field.js';
import { didYouMean } from './nearest.js';

export type Fields<V> = { readonly [K in keyof V]: Field<V[K]> };

/**
 * For each set of fields, its defaults in one object: copying it is seven times as fast as writing
 * them one by one.
 */
const defaults = new WeakMap<object, object>();

function defaultsOf<V extends object>(fields: Fields<V>): V {
  let values = defaults.get(fields);
  if (values === undefined) {
    const entries = Object.entries<Field<unknown>>(fields);
    values = Object.fromEntries(entries.map(([key, { fallback }]) => [key, fallback]));
    defaults.set(fields, values);
  }
  return values as V;
}

const NONE: readonly never[] = [];

export class FieldStore<V extends object> {
  readonly fields: Fields<V>;
  readonly #values: V;
  /**
   * Keys of the values that were set. Replaced, not written to: most elements have few, and a set
   * takes 200 bytes.
   */
  #given: readonly (keyof V)[] = NONE;
  #listener: ((key: keyof V) => void) | null = null;

  constructor(fields: Fields<V>) {
    this.fields = fields;
    this.#values = { ...defaultsOf(fields) };
  }

  /** All values as they are now, defaults included. Live: do not write to it, nor to its lists. */
  get values(): Readonly<V> {
    return this.#values;
  }

  /** Throws `TypeError` for a key that no value has, with the one that was probably meant. */
  field<K extends keyof V>(key: K): Field<V[K]> {
    if (Object.hasOwn(this.fields, key)) return this.fields[key];
    const hint = didYouMean(String(key), Object.keys(this.fields));
    throw new TypeError(`there is no value named ${show(key)}.${hint}`);
  }

  /** Whether a value was set, rather than being the default. */
  given(key: keyof V): boolean {
    return this.#given.includes(key);
  }

  /**
   * Sets a value; `null` and `undefined` restore the default. Throws `TypeError` or `RangeError`
   * for a value outside the field's domain and then changes nothing.
   */
  set<K extends keyof V>(key: K, value: unknown): void {
    const given = value !== undefined && value !== null;
    const checked = given ? this.fields[key].check(value) : this.fields[key].fallback;
    const before = this.given(key);
    if (given && !before) {
      this.#given = [...this.#given, key];
    } else if (before && !given) {
      this.#given = this.#given.filter((other) => other !== key);
    }
    if (given === before && sameValue(checked, this.#values[key])) return;
    this.#values[key] = checked;
    this.#listener?.(key);
  }

  /** Notifies the listener as if the value had changed. */
  notify(key: keyof V): void {
    this.#listener?.(key);
  }

  /** Sets several values as {@link set} does. All are checked before the first is written. */
  assign(values: Partial<V>): void {
    // Not for … in, here and elsewhere: pages may add to Object.prototype.
    const keys = Object.keys(values) as (keyof V)[];
    for (const key of keys) {
      const field = this.field(key);
      const value = values[key];
      if (value !== undefined && value !== null) {
        field.check(value);
      }
    }
    for (const key of keys) {
      this.set(key, values[key]);
    }
  }

  /** Replaces the listener; null removes it. */
  listen(listener: ((key: keyof V) => void) | null): void {
    this.#listener = listener;
  }

  /** Removes this listener. A listener that has replaced it stays. */
  unlisten(listener: (key: keyof V) => void): void {
    if (this.#listener === listener) {
      this.#listener = null;
    }
  }
}

/** Compares numbers, strings and booleans, and lists of these. */
export function sameValue(a: unknown, b: unknown): boolean {
  if (!Array.isArray(a) || !Array.isArray(b)) return a === b;
  if (a.length !== b.length) return false;
  for (let i = 0; i < a.length; i++) {
    if (a[i] !== b[i]) return false;
  }
  return true;
}
