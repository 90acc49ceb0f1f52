// What a <phong-exercise> declares: which viewer it is about, what its function must do, and how
// much is said. Types only: the table of its fields comes with its code.
import type { LightKind, Term } from '../../../phong/light/light-state.js';
import type { Inputs, ValuesOf } from './properties.js';

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
