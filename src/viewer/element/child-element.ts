// What lights and meshes share: values from attributes and properties, and a place in the nearest
// viewer's registry.
import type { FieldStore } from '../../phong/fields/field-store.js';
import { type ChildRegistry, registryAround } from './child-registry.js';
import { inspect } from './inspect.js';
import { FieldBinding } from './fields/field-binding.js';

/** Importing this file where there is no DOM does nothing. */
export const Base =
  typeof HTMLElement === 'undefined' ? (class {} as typeof HTMLElement) : HTMLElement;

/**
 * Registers a light or mesh with the nearest viewer around it, if any. Does nothing for other
 * elements.
 */
export let register: (element: Element) => void;

export abstract class ChildElement<V extends object> extends Base {
  static {
    register = (element) => {
      if (#registry in element) {
        element.#register();
      }
    };
  }

  readonly #binding: FieldBinding<V>;
  #registry: ChildRegistry | null = null;

  constructor(store: FieldStore<V>, assigned?: (key: keyof V, store: FieldStore<V>) => void) {
    super();
    this.#binding = new FieldBinding(this, store, assigned);
  }

  connectedCallback(): void {
    this.#register();
    inspect(this);
  }

  /** A child that is removed together with its viewer stays registered. */
  disconnectedCallback(): void {
    this.#register();
  }

  /** After `moveBefore`. */
  connectedMoveCallback(): void {
    this.#register();
  }

  attributeChangedCallback(attribute: string, _old: string | null, text: string | null): void {
    this.#binding.attributeChanged(attribute, text);
  }

  #register() {
    this.#binding.upgrade();
    const registry = registryAround(this);
    if (registry !== this.#registry) {
      this.#registry?.delete(this);
    }
    this.#registry = registry;
    registry?.add(this);
  }
}
