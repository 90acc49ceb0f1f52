// <phong-light>: a light as markup. Renders nothing; its attributes and properties write into one
// LightState.
import { LIGHT_FIELDS, LightState, type LightValues } from '../../phong/light/light-state.js';
import type { ElementClass, PhongLight as PublicLight } from './elements.js';
import { ChildElement } from './child-element.js';
import { registryAround } from './child-registry.js';
import { attributesOf, defineProperties } from './fields/field-binding.js';
import type { LightProperties } from './fields/properties.js';
import { phrase, type ViewerTexts } from './fields/texts.js';
import { fieldsOf } from './internals.js';

export class ElementLight extends LightState {
  /** Null only while the element is constructed. */
  element: PublicLight | null = null;
}

/** The element of a light; null for the head-light. */
export const lightOf = (state: LightState): PublicLight | null =>
  state instanceof ElementLight ? state.element : null;

// The accessors come from the table of fields.
interface LightElement extends LightProperties {
  readonly localName: 'phong-light';
}

/**
 * A light of the nearest `<phong-viewer>` around it: in wrapper elements, in shadow trees, or in
 * another light or mesh, so that `<phong-light … />` works. A viewer without lights gets one at the
 * eye. Its properties have the attributes' names. A bad attribute value warns and gives the
 * default; a bad property value throws.
 */
class LightElement extends ChildElement<LightValues> implements PublicLight {
  static readonly observedAttributes: readonly string[] = attributesOf(LIGHT_FIELDS);

  constructor() {
    const state = new ElementLight();
    super(state);
    state.element = this;
  }

  get name(): LightProperties['name'] {
    const { name } = fieldsOf(this).store.values;
    if (name !== '') return name;
    const lights =
      registryAround(this)?.inOrder.filter((child) => child instanceof LightElement) ?? [];
    return numberedName(Math.max(lights.indexOf(this), 0));
  }

  set name(name: string | null | undefined) {
    fieldsOf(this).set('name', name);
  }
}

/** The name of a light without one; `index` counts the viewer's lights from 0. */
const numberedName = (index: number, texts: ViewerTexts | null = null) =>
  phrase(texts, 'light {number}', { number: String(index + 1) });

/** As the panel and explanations name a light; `index` counts the viewer's lights from 0. */
export const lightName = (
  state: LightState,
  index: number,
  texts: ViewerTexts | null = null,
): string =>
  lightOf(state) === null
    ? phrase(texts, 'head-light')
    : state.values.name || numberedName(index, texts);

defineProperties(LightElement.prototype, LIGHT_FIELDS);

export type PhongLight = PublicLight;
export const PhongLight: ElementClass<PhongLight> = LightElement;
