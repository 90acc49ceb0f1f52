// Runs a search by rays to its end in one go.
import type { RaySearch } from '../../../src/extras/explain/ray-triangles.js';

/** The answer, and how many triangles each step tested. */
export function stepsOf<Answer>(search: RaySearch<Answer>): {
  readonly answer: Answer;
  readonly steps: readonly number[];
} {
  const steps: number[] = [];
  for (let step = search.next(); ; step = search.next()) {
    if (step.done === true) return { answer: step.value, steps };
    steps.push(step.value);
  }
}

export const answerOf = <Answer>(search: RaySearch<Answer>): Answer => stepsOf(search).answer;
