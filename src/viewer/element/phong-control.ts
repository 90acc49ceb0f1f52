// <phong-control>: one value of viewers, lights or meshes, anywhere on the page. Its chunk also
// gives it properties.
import type { PhongControl as PublicControl } from './elements.js';
import { reportMissing } from '../model/provided-code.js';
import { controlCode } from './extra-code.js';
import type { ControlProperties } from './fields/control-properties.js';
import { Base } from './child-element.js';
import { withRows } from './panel-rows.js';

// The accessors come from the table of fields.
interface ControlElement extends ControlProperties {
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
class ControlElement extends Base implements PublicControl {
  connectedCallback(): void {
    withRows(controlCode).then(({ follow }) => follow(this), reportMissing);
  }
}

export type PhongControl = PublicControl;
export const PhongControl: { new (): PhongControl; readonly prototype: PhongControl } =
  ControlElement;
