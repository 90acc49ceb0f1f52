// <phong-light>: a light as markup. It renders nothing; its attributes and properties write into one LightState, which
// the viewer around it picks up. Knows no lighting.
import { LIGHT_FIELDS, LightState, type LightValues } from '../light/light-state.js';
import { attributesOf, FieldBinding, defineProperties } from './fields/field-binding.js';

/** Importing this file where there is no DOM does nothing. */
const Base = typeof HTMLElement === 'undefined' ? (class {} as typeof HTMLElement) : HTMLElement;

export interface PhongLight extends Omit<LightValues, 'name'> {
  readonly localName: 'phong-light';
}

/**
 * A light of the `<phong-viewer>` around it. Properties are those of {@link LightValues}, under the attributes' names;
 * bad attribute values give way to defaults with a warning, bad property values throw.
 */
export class PhongLight extends Base {
  static readonly observedAttributes: readonly string[] = attributesOf(LIGHT_FIELDS);

  /** The light itself. Written through the element's properties; here for who shades with it. */
  readonly state = new LightState();
  readonly declared = new FieldBinding<LightValues>(this, this.state);

  /** Text shown in the panel and in explanations. Default: `light N`, N counting the viewer's lights from 1. */
  get name(): string {
    return this.state.values.name === '' ? this.#numbered() : this.state.values.name;
  }

  set name(name: string) {
    this.declared.set('name', name);
  }

  connectedCallback(): void {
    this.declared.upgrade();
  }

  attributeChangedCallback(attribute: string, _old: string | null, text: string | null): void {
    this.declared.attributeChanged(attribute, text);
  }

  #numbered(): string {
    const siblings = [...(this.parentElement?.children ?? [this])].filter(
      (child) => child instanceof PhongLight,
    );
    return `light ${String(siblings.indexOf(this) + 1)}`;
  }
}

defineProperties(PhongLight.prototype, LIGHT_FIELDS, (light) => light.declared);

declare global {
  interface HTMLElementTagNameMap {
    'phong-light': PhongLight;
  }
}
