// <phong-control>: one value of viewers, lights or meshes, anywhere on the page. Its chunk also
// gives it properties.
import type { PhongControl as PublicControl } from './elements.js';
import { reportMissing } from '../model/lazy-code.js';
import type { ControlProperties } from '../../extras/panel/control-fields.js';
import { Base } from './child-element.js';

type Loader = () => Promise<{ readonly follow: (control: PublicControl) => void }>;

let load: Loader;

/**
 * How its code is fetched. The package's entry says so, because elements do not import the panel's
 * rows.
 */
export const provideControl = (loader: Loader): unknown => (load = loader);

// The accessors come from the table of fields.
interface ControlElement extends ControlProperties {
  readonly localName: 'phong-control';
}

/**
 * Edits one value of viewers, lights or meshes: a slider with a number, a switch, a choice, a
 * colour, a vector or a stepper, as the value asks. It may stand in a line of text, where a number
 * is dragged sideways, turned by arrow keys or typed. It follows scripts, drags and the panel, and
 * its changes can be undone. On paper it is its name and value.
 *
 * @slot - the label; empty: the value's name, in the page's language
 * @csspart label - the label
 * @csspart input - each input, choice and button
 * @csspart unit - the unit of a number
 */
class ControlElement extends Base implements PublicControl {
  connectedCallback(): void {
    load().then(({ follow }) => follow(this), reportMissing);
  }
}

export type PhongControl = PublicControl;
export const PhongControl: { new (): PhongControl; readonly prototype: PhongControl } =
  ControlElement;
