// <phong-probe>: one point of a viewer as a table, an equation or questions, anywhere on the page.
// Its code, an extra, also gives it properties.
import { probeCode } from './extra-code.js';
import { formElement } from './form-element.js';
import type { PhongProbe as PublicProbe, FormControl } from './elements.js';
import type { Listen, PhongProbeEventMap } from './elements.js';
import type { ProbeProperties } from './fields/probe-properties.js';

// The accessors come from the table of fields.
interface ProbeElement extends ProbeProperties, FormControl {
  readonly localName: 'phong-probe';
  addEventListener: Listen<this, PhongProbeEventMap>;
  removeEventListener: Listen<this, PhongProbeEventMap>;
}

/**
 * Explains one point of a viewer's picture anywhere on the page, as ordinary HTML in the page's
 * flow, font and colours. In a form it is a control: `value` is what was typed, separated by `; `.
 *
 * @csspart title - the light and the term of a line
 * @csspart input - each field for an answer
 * @csspart button - each button
 * @csspart verdict - what is said of an answer
 */
class ProbeElement extends formElement(probeCode) implements PublicProbe {}

export type PhongProbe = PublicProbe;
export const PhongProbe: { new (): PhongProbe; readonly prototype: PhongProbe } = ProbeElement;
