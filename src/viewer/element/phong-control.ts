// <phong-control>: one value of viewers, lights or meshes, anywhere on the page. Its code, an extra,
// also gives it properties.
import { controlCode } from './extra-code.js';
import { fetchedElement } from './fetched-element.js';
import type { Inputs, ValuesOf } from './fields/properties.js';
import { withRows } from './panel-rows.js';

export interface ControlProperties {
  /**
   * Ids of viewers, lights or meshes, separated by spaces. All get the value; that of the first is
   * shown. Default empty.
   */
  get for(): string;
  set for(value: Accepted['for']);
  /** The attribute to edit: any that these elements have. Default empty. */
  get attribute(): string;
  set attribute(value: Accepted['attribute']);
  /**
   * One number of a vector: `x`, `y`, `z`, or `kc`, `kl`, `kq` of `attenuation`. Null, the default:
   * all three.
   */
  get component(): 'x' | 'y' | 'z' | 'kc' | 'kl' | 'kq' | null;
  set component(value: Accepted['component']);
  /**
   * Values as the attribute's text, separated by `|`: a stepper through them, with back and
   * forward. Default empty.
   */
  get values(): string;
  set values(value: Accepted['values']);
  /**
   * Least number. Null, the default: as in the panel, where the slider grows to include the value.
   */
  get min(): number | null;
  set min(value: Accepted['min']);
  /** Greatest number. Null, the default: as in the panel. */
  get max(): number | null;
  set max(value: Accepted['max']);
  /** Distance of the numbers. Null, the default: as in the panel. */
  get step(): number | null;
  set step(value: Accepted['step']);
  /**
   * `number` to drag, turn or type, or `slider` with that number, on a line of its own. Null, the
   * default: a number within a line of text, otherwise a slider.
   */
  get type(): 'number' | 'slider' | null;
  set type(value: Accepted['type']);
}

export type ControlValues = ValuesOf<ControlProperties>;
type Accepted = Inputs<ControlValues>;

/** Edits one value of viewers, lights or meshes, anywhere on the page. */
export interface PhongControl extends HTMLElement, ControlProperties {
  readonly localName: 'phong-control';
}

/**
 * Edits one value of viewers, lights or meshes, by a slider with a number, a switch, a choice, a
 * colour, a vector or a stepper, on a line of its own or in a sentence. It follows scripts, drags
 * and the panel. On paper it is its name and value.
 *
 * @slot - the label; empty: the value's name, in the page's language
 * @csspart label - the label
 * @csspart input - each input, choice and button
 * @csspart unit - the unit of a number
 */
class ControlElement
  extends fetchedElement<PhongControl>(() => withRows(controlCode))
  implements PhongControl {}

export const PhongControl: { new (): PhongControl; readonly prototype: PhongControl } =
  ControlElement;

declare module './elements.js' {
  interface ElementTypes {
    'phong-control': Types<PhongControl, ControlValues>;
  }
}
