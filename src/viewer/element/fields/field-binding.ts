// How attributes and properties reach a FieldStore: a bad attribute warns and gives the default, a
// bad property throws.
import { show } from '../../../phong/fields/field.js';
import type { FieldStore } from '../../../phong/fields/field-store.js';
import { attributeOf, parseText, valueWarning } from '../../../phong/fields/attribute-text.js';
import { cssColor } from './css-color.js';

/** For each set of fields, its keys by attribute name. */
const keysByAttribute = new WeakMap<object, ReadonlyMap<string, string>>();

function keysOf(fields: object): ReadonlyMap<string, string> {
  const present = keysByAttribute.get(fields);
  if (present !== undefined) return present;
  const keys = new Map(Object.keys(fields).map((key) => [attributeOf(key), key]));
  keysByAttribute.set(fields, keys);
  return keys;
}

export const attributesOf = (fields: object): string[] => [...keysOf(fields).keys()];

/** Private to the package: users of an element see its properties only. */
const bindings = new WeakMap<HTMLElement, unknown>();

/** The binding of an element with values `V`; see `fieldsOf` for the typed form. */
export const bindingOf = <V extends object>(element: HTMLElement): FieldBinding<V> =>
  bindings.get(element) as FieldBinding<V>;

/**
 * Warnings that an element remembers, in order to give each once. More are forgotten together: they
 * cost 50 kB.
 */
const WARNINGS_KEPT = 100;

export class FieldBinding<V extends object> {
  readonly store: FieldStore<V>;
  readonly #element: HTMLElement;
  readonly #assigned: ((key: keyof V, store: FieldStore<V>) => void) | null;
  /** Null before the first warning: pages have thousands of elements. */
  #warned: Set<string> | null = null;

  /** `assigned` is called after each successful assignment, even if the value stays the same. */
  constructor(
    element: HTMLElement,
    store: FieldStore<V>,
    assigned?: (key: keyof V, store: FieldStore<V>) => void,
  ) {
    this.store = store;
    this.#element = element;
    this.#assigned = assigned ?? null;
    bindings.set(element, this);
  }

  /** For `attributeChangedCallback`. False if the attribute belongs to no field. */
  attributeChanged(attribute: string, text: string | null): boolean {
    const key = keysOf(this.store.fields).get(attribute) as (keyof V & string) | undefined;
    if (key === undefined) return false;
    this.#setOrWarn(key, text);
    return true;
  }

  /**
   * For a property's getter. Lists are frozen here, not when they are written: a moving light is
   * rarely read.
   */
  get<K extends keyof V>(key: K): V[K] {
    const value = this.store.values[key];
    return Array.isArray(value) ? (Object.freeze(value) as V[K]) : value;
  }

  /**
   * For a property's setter. Throws TypeError or RangeError for a bad value and then changes
   * nothing.
   */
  set(key: keyof V & string, value: unknown): void {
    this.#put(key, value);
    this.#assigned?.(key, this.store);
  }

  /**
   * Properties set before the element was upgraded are own properties and would hide the accessors.
   * Moves them into the store and treats them like attributes.
   */
  upgrade(): void {
    // Few elements have properties of their own at all.
    for (const name of Object.keys(this.#element)) {
      if (!Object.hasOwn(this.store.fields, name)) continue;
      const key = name as keyof V & string;
      const value: unknown = Reflect.get(this.#element, key);
      Reflect.deleteProperty(this.#element, key);
      this.#setOrWarn(key, value);
    }
  }

  #setOrWarn(key: keyof V & string, value: unknown) {
    try {
      this.#put(key, value);
    } catch {
      // The warning says what the error says.
      this.store.set(key, null);
      this.#warn(key, value);
    }
    this.#assigned?.(key, this.store);
  }

  #put(key: keyof V & string, value: unknown) {
    const field = this.store.field(key);
    const typed = typeof value === 'string' ? parseText(value, field, cssColor) : value;
    if (typed === undefined && typeof value === 'string') {
      throw new TypeError(this.#about(key, `expected ${field.expected}, got ${show(value)}`));
    }
    try {
      this.store.set(key, typed);
    } catch (error) {
      if (error instanceof Error) {
        error.message = this.#about(key, error.message);
      }
      throw error;
    }
  }

  /** One warning per element, attribute and value. */
  #warn(key: keyof V & string, value: unknown) {
    const message = valueWarning(this.#element.localName, key, value, this.store.fields[key]);
    const warned = (this.#warned ??= new Set());
    if (warned.has(message)) return;
    if (warned.size >= WARNINGS_KEPT) {
      warned.clear();
    }
    warned.add(message);
    console.warn(message);
  }

  #about(key: string, message: string): string {
    return `<${this.#element.localName}>.${key}: ${message}`;
  }
}

/** Gives a class one accessor per field. Accessors that the class has itself stay. */
export function defineProperties(prototype: HTMLElement, fields: object): void {
  for (const key of Object.keys(fields)) {
    if (Object.hasOwn(prototype, key)) continue;
    Object.defineProperty(prototype, key, {
      configurable: true,
      enumerable: true,
      get(this: HTMLElement): unknown {
        return bindingOf<Record<string, unknown>>(this).get(key);
      },
      set(this: HTMLElement, value: unknown) {
        bindingOf<Record<string, unknown>>(this).set(key, value);
      },
    });
  }
}
