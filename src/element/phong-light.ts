// <phong-light>: a light as markup. It renders nothing; its attributes and properties write into one LightState, which
// the viewer around it shades with. Knows no lighting.
import { LIGHT_FIELDS, LightState, type LightValues } from '../light/light-state.js';
import { childBinding, ChildElement } from './child-element.js';
import { registryAround } from './child-registry.js';
import { attributesOf, defineProperties } from './fields/field-binding.js';
import type { LightProperties } from './fields/properties.js';
import { phrase, type ViewerTexts } from './fields/texts.js';
import { fieldsOf } from './internals.js';

export interface PhongLight extends LightProperties {
  readonly localName: 'phong-light';
}

/** The values of a light that an element declares. */
export class ElementLight extends LightState {
  /** Null only while the element is constructed. */
  element: PhongLight | null = null;
  /** The last `light-change` that reports it: see EventQueue. */
  batch = 0;
}

/**
 * A light of the `<phong-viewer>` around it. Its properties have the attributes' names. A bad attribute value warns and
 * gives the default; a bad property value throws.
 */
export class PhongLight extends ChildElement<LightValues> {
  static readonly observedAttributes: readonly string[] = attributesOf(LIGHT_FIELDS);

  constructor() {
    const state = new ElementLight();
    super(state);
    state.element = this;
  }

  /** Text shown in the panel and in explanations. Default: `light N`, N counting the viewer's lights from 1. */
  get name(): LightProperties['name'] {
    const { name } = fieldsOf(this).store.values;
    if (name !== '') return name;
    const lights = registryAround(this)?.inOrder.filter((child) => child instanceof PhongLight) ?? [];
    return numberedName(Math.max(lights.indexOf(this), 0));
  }

  set name(name: string | null | undefined) {
    fieldsOf(this).set('name', name);
  }
}

/** The name of a light without one; `index` counts the viewer's lights from 0. */
export const numberedName = (index: number, texts: ViewerTexts | null = null): string =>
  phrase(texts, 'light {number}', { number: String(index + 1) });

defineProperties(PhongLight.prototype, LIGHT_FIELDS, childBinding);
