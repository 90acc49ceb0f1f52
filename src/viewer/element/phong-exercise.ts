// <phong-exercise>: a lighting function to write, run and judge. Its code, an extra, also gives it
// properties.
import type { LightKind, Term } from '../../phong/light/light-state.js';
import type { Listen } from './elements.js';
import { elementCode } from './extra-code.js';
import { fetchedElement, type FormControl } from './fetched-element.js';
import type { Inputs, ValuesOf } from './fields/properties.js';

export interface ExerciseProperties {
  /** Id of the viewer whose lights, surfaces and camera make the picture. Default empty. */
  get for(): string;
  set for(value: Accepted['for']);
  /** Name under which a form sends what was written. Default empty. */
  get name(): string;
  set name(value: Accepted['name']);
  /** The terms that the function must compute. Default all three. */
  get terms(): readonly Term[];
  set terms(value: Accepted['terms']);
  /** The kinds of lights that the function must know. Null, the default: those of the viewer. */
  get kinds(): readonly LightKind[] | null;
  set kinds(value: Accepted['kinds']);
  /**
   * How much is said: `what` names the mistake, `where` shows where it differs, `verdict` says only
   * right or wrong, `none` nothing. Default what.
   */
  get hint(): 'what' | 'where' | 'verdict' | 'none';
  set hint(value: Accepted['hint']);
  /** Shows the exact function once the learner's was right. Default false. */
  get solution(): boolean;
  set solution(value: Accepted['solution']);
  /** A form needs something written here. Default false. */
  get required(): boolean;
  set required(value: Accepted['required']);
}

export type ExerciseValues = ValuesOf<ExerciseProperties>;
type Accepted = Inputs<ExerciseValues>;

/** A lighting function to write, and a verdict on it. */
export interface PhongExercise extends HTMLElement, ExerciseProperties, FormControl {
  readonly localName: 'phong-exercise';
  addEventListener: Listen<this, PhongExerciseEventMap>;
  removeEventListener: Listen<this, PhongExerciseEventMap>;
}

/** What a run of a learner's function gave. */
export interface CheckDetail {
  readonly right: boolean;
  /** Ids of the mistakes that together explain the colours, one or two; empty where none do. */
  readonly mistakes: readonly string[];
  /** Of the judged pixels, those that are right: 0–1. */
  readonly share: number;
  readonly source: string;
}

/** Events of `<phong-exercise>`. None bubbles. */
export interface PhongExerciseEventMap {
  /** Somebody has run the function: `detail.right`, `mistakes`, `share` and `source`. */
  check: CustomEvent<CheckDetail>;
}

/** Properties of `<phong-exercise>` without an attribute. */
export interface ExerciseOwnProps {
  readonly value?: string | undefined;
}

/**
 * A lighting function in GLSL to write, and a verdict: right to one 8-bit step, or the mistake by
 * name. The text to begin with stands in a `<script type="text/plain">` inside. A form sends
 * `value`, what was written.
 *
 * @csspart editor - the text field with its line numbers
 * @csspart pictures - the pictures
 * @csspart verdict - what is said after a run
 * @csspart button - each button
 */
class ExerciseElement
  extends fetchedElement<PhongExercise>(elementCode('phong-exercise'))
  implements PhongExercise
{
  static readonly formAssociated = true;
}

export const PhongExercise: { new (): PhongExercise; readonly prototype: PhongExercise } =
  ExerciseElement;

declare module './elements.js' {
  interface ElementTypes {
    'phong-exercise': Types<PhongExercise, ExerciseValues, PhongExerciseEventMap, ExerciseOwnProps>;
  }
}
