// A record of declared values: each has a default until it is given, is checked on the way in, and tells one listener
// when it changes. Lights, meshes and viewers keep their state in one; there is no second copy. Knows no DOM.
import type { Field } from './field.js';

export type Fields<V> = { readonly [K in keyof V]: Field<V[K]> };

export class FieldStore<V extends object> {
  readonly fields: Fields<V>;
  readonly #values: V;
  readonly #given = new Set<keyof V>();
  #listener: ((key: keyof V) => void) | null = null;

  constructor(fields: Fields<V>) {
    this.fields = fields;
    const defaults: Partial<V> = {};
    for (const key in fields) defaults[key] = fields[key].fallback;
    this.#values = defaults as V;
  }

  /** All values as they are now, defaults included; live, and never to be written to, nor are lists in it. */
  get values(): Readonly<V> {
    return this.#values;
  }

  /** Whether a value was given, rather than being the default. */
  given(key: keyof V): boolean {
    return this.#given.has(key);
  }

  /**
   * Gives a value; `null` and `undefined` restore the default. Throws `TypeError` or `RangeError` where the value is
   * outside the field's domain, and then changes nothing.
   */
  set<K extends keyof V>(key: K, value: unknown): void {
    const given = value !== undefined && value !== null;
    const checked = given ? this.fields[key].check(value) : this.fields[key].fallback;
    const before = this.#given.has(key);
    if (given && !before) this.#given.add(key);
    else if (!given) this.#given.delete(key);
    if (given === before && sameValue(checked, this.#values[key])) return;
    this.#values[key] = checked;
    this.#listener?.(key);
  }

  /** Gives several values, as {@link set} does each. All are checked before the first is written. */
  assign(values: Partial<V>): void {
    for (const key in values) {
      if (!Object.hasOwn(this.fields, key)) throw new TypeError(`there is no value named ${key}`);
      const value = values[key];
      if (value !== undefined && value !== null) this.fields[key].check(value);
    }
    for (const key in values) this.set(key, values[key]);
  }

  /** There is one listener at a time; null ends it. */
  listen(listener: ((key: keyof V) => void) | null): void {
    this.#listener = listener;
  }

  /** Ends this listener; one that has taken its place since stays. */
  unlisten(listener: (key: keyof V) => void): void {
    if (this.#listener === listener) this.#listener = null;
  }
}

/** Equal numbers, strings and flags, and lists of such. */
export function sameValue(a: unknown, b: unknown): boolean {
  if (!Array.isArray(a) || !Array.isArray(b)) return a === b;
  if (a.length !== b.length) return false;
  for (let i = 0; i < a.length; i++) if (a[i] !== b[i]) return false;
  return true;
}
