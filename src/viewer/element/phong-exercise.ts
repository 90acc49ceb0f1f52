// <phong-exercise>: a lighting function to write, run and judge. Its chunk also gives it
// properties.
import type {
  FormControl,
  Listen,
  PhongExercise as PublicExercise,
  PhongExerciseEventMap,
} from './elements.js';
import { exerciseCode } from './extra-code.js';
import { formElement } from './form-element.js';
import type { ExerciseProperties } from './fields/exercise-properties.js';

// The accessors come from the table of fields and from the chunk.
interface ExerciseElement extends ExerciseProperties, FormControl {
  readonly localName: 'phong-exercise';
  addEventListener: Listen<this, PhongExerciseEventMap>;
  removeEventListener: Listen<this, PhongExerciseEventMap>;
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
class ExerciseElement extends formElement(exerciseCode) implements PublicExercise {}

export type PhongExercise = PublicExercise;
export const PhongExercise: { new (): PhongExercise; readonly prototype: PhongExercise } =
  ExerciseElement;
