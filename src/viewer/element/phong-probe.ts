// <phong-probe>: one point of a viewer as a table, an equation or questions, anywhere on the page.
// Its code, an extra, also gives it properties.
import type { Vec3 } from '../../phong/math/vector.js';
import type { MistakeId } from '../../phong/mistakes/mistakes.js';
import type { SlipId } from '../../phong/mistakes/slips.js';
import type { Listen, PhongLight } from './elements.js';
import { elementCode } from './extra-code.js';
import { fetchedElement, type FormControl } from './fetched-element.js';
import type { Inputs, ValuesOf } from './fields/properties.js';

export interface ProbeProperties {
  /** Id of the viewer whose point is explained. Default empty. */
  get for(): string;
  set for(value: Accepted['for']);
  /**
   * `table`: the sum light by light. `formula`: the equation with its numbers. `ask`: the same as
   * questions. Null, the default: `ask` where {@link ask} says what, else `table`.
   */
  get as(): 'table' | 'formula' | 'ask' | null;
  set as(value: Accepted['as']);
  /**
   * World-space point on a surface. Null, the default: the point under the mouse, or pinned by a
   * press (questions: pinned only), before that the viewer's `probe-at`, or the middle of the
   * picture.
   */
  get at(): Vec3 | null;
  set at(value: Accepted['at']);
  /**
   * What is asked: `sum`, or `ambient`, `diffuse` or `specular`, of all lights or of one by its name
   * or id. Empty, the default: everything.
   */
  get ask(): string;
  set ask(value: Accepted['ask']);
  /**
   * Another point of the surface and other coefficients for each text. Empty, the default: those of
   * the scene.
   */
  get seed(): string;
  set seed(value: Accepted['seed']);
  /** Name of its answers in a form. Default empty. */
  get name(): string;
  set name(value: Accepted['name']);
  /** An empty answer is invalid in a form. Default false. */
  get required(): boolean;
  set required(value: Accepted['required']);
}

export type ProbeValues = ValuesOf<ProbeProperties>;
type Accepted = Inputs<ProbeValues>;

/** Explains one point of a viewer's picture, anywhere on the page. */
export interface PhongProbe extends HTMLElement, ProbeProperties, FormControl {
  readonly localName: 'phong-probe';
  addEventListener: Listen<this, PhongProbeEventMap>;
  removeEventListener: Listen<this, PhongProbeEventMap>;
}

/**
 * A usual mistake: of the table that also checks a learner's function, or of answers alone.
 * `left-out`: a term of a sum. `digits`: too few.
 */
export type AnswerMistake = MistakeId | SlipId | 'left-out' | 'digits' | 'above-full';

/** An answer to a question of a `<phong-probe>`. */
export interface AnswerDetail {
  readonly term: 'ambient' | 'diffuse' | 'specular' | 'sum';
  /** Null for the sum and the head-light. */
  readonly light: PhongLight | null;
  /** Null where all channels are equal. */
  readonly channel: 'red' | 'green' | 'blue' | null;
  /** As typed, and as a number; null if it is none. */
  readonly text: string;
  readonly value: number | null;
  readonly expected: number;
  readonly correct: boolean;
  /** The likeliest one that gives this value. Null for right answers and unusual ones. */
  readonly mistake: AnswerMistake | null;
}

/** Events of `<phong-probe>`. None bubbles. */
export interface PhongProbeEventMap {
  /** The user answered a question: what was typed, and whether it was right. */
  answer: CustomEvent<AnswerDetail>;
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
class ProbeElement
  extends fetchedElement<PhongProbe>(elementCode('phong-probe'))
  implements PhongProbe
{
  static readonly formAssociated = true;
}

export const PhongProbe: { new (): PhongProbe; readonly prototype: PhongProbe } = ProbeElement;

declare module './elements.js' {
  interface ElementTypes {
    'phong-probe': Types<PhongProbe, ProbeValues, PhongProbeEventMap>;
  }
}
