// What every element here does with its attributes and properties: attributes are parsed, a bad one is warned of and
// gives way to its default; properties are checked, a bad one throws; both write to one FieldStore state. Knows no
// particular element.
import type { FieldStore, Fields } from '../../fields/field-store.js';
import { attributeOf, parseText } from './attribute-text.js';

/** Of each set of fields, the keys by their attributes. */
const keys = new WeakMap<object, ReadonlyMap<string, string>>();

function keysOf(fields: object): ReadonlyMap<string, string> {
  const found = keys.get(fields) ?? new Map(Object.keys(fields).map((key) => [attributeOf(key), key]));
  keys.set(fields, found);
  return found;
}

/** The attributes that belong to these fields. */
export const attributesOf = (fields: object): string[] => [...keysOf(fields).keys()];

/** The element side of a {@link FieldStore} state. */
export class FieldBinding<V extends object> {
  readonly #element: HTMLElement;
  readonly #state: FieldStore<V>;
  readonly #assigned: (key: keyof V) => void;
  readonly #warned = new Set<string>();

  /** `assigned` is told of every assignment that took, the same value too. */
  constructor(
    element: HTMLElement,
    state: FieldStore<V>,
    assigned: (key: keyof V) => void = () => undefined,
  ) {
    this.#element = element;
    this.#state = state;
    this.#assigned = assigned;
  }

  /** For `attributeChangedCallback`; false where the attribute is none of ours. */
  attributeChanged(attribute: string, text: string | null): boolean {
    const key = keysOf(this.#state.fields).get(attribute) as (keyof V & string) | undefined;
    if (key === undefined) return false;
    if (text === null) this.#state.set(key, null);
    else this.#setOrWarn(key, text);
    this.#assigned(key);
    return true;
  }

  /** For a property's getter. Freezes what it hands out: values that are never read again, as in a light's motion, need it not. */
  get<K extends keyof V>(key: K): V[K] {
    return Object.freeze(this.#state.values[key]) as V[K];
  }

  /** For a property's setter: throws TypeError or RangeError and then changes nothing. */
  set(key: keyof V & string, value: unknown): void {
    let typed = value;
    if (typeof value === 'string') {
      const field = this.#state.fields[key];
      typed = parseText(value, field);
      if (typed === undefined)
        throw new TypeError(this.#about(key, `expected ${field.expected}, got "${value}"`));
    }
    try {
      this.#state.set(key, typed);
    } catch (error) {
      if (error instanceof Error) error.message = this.#about(key, error.message);
      throw error;
    }
    this.#assigned(key);
  }

  /**
   * Properties that were set before the element was upgraded lie on the element itself and would hide the accessors:
   * takes them over, as attributes would be.
   */
  upgrade(): void {
    for (const key of Object.keys(this.#state.fields) as (keyof V & string)[]) {
      if (!Object.hasOwn(this.#element, key)) continue;
      const value: unknown = Reflect.get(this.#element, key);
      Reflect.deleteProperty(this.#element, key);
      this.#setOrWarn(key, value);
      this.#assigned(key);
    }
  }

  #setOrWarn(key: keyof V & string, value: unknown): void {
    const field = this.#state.fields[key];
    const typed = typeof value === 'string' ? parseText(value, field) : value;
    if (!(typed === undefined && value !== undefined)) {
      try {
        this.#state.set(key, typed);
        return;
      } catch {
        // The warning below says what the error would.
      }
    }
    this.#state.set(key, null);
    this.#warn(key, value);
  }

  /** One warning per element, attribute and value. */
  #warn(key: keyof V & string, value: unknown): void {
    const field = this.#state.fields[key];
    const text = typeof value === 'string' ? JSON.stringify(value) : String(value);
    const { fallback } = field;
    const instead = Array.isArray(fallback) ? fallback.join(' ') : String(fallback ?? 'none');
    const message = `${this.#tag} ${attributeOf(key)}=${text}: expected ${field.expected}; using ${instead === '' ? 'none' : instead} instead.`;
    if (this.#warned.has(message)) return;
    this.#warned.add(message);
    console.warn(message);
  }

  #about(key: string, message: string): string {
    return `${this.#tag}.${key}: ${message}`;
  }

  get #tag(): string {
    return `<${this.#element.localName}>`;
  }
}

/**
 * Gives a class its properties: one accessor per field. `of` finds an instance's {@link FieldBinding}. Accessors
 * that the class has itself are left alone.
 */
export function defineProperties<E extends HTMLElement, V extends object>(
  prototype: E,
  fields: Fields<V>,
  of: (element: E) => FieldBinding<V>,
): void {
  for (const key of Object.keys(fields) as (keyof V & string)[]) {
    if (Object.hasOwn(prototype, key)) continue;
    Object.defineProperty(prototype, key, {
      configurable: true,
      enumerable: true,
      get(this: E) {
        return of(this).get(key);
      },
      set(this: E, value: unknown) {
        of(this).set(key, value);
      },
    });
  }
}
