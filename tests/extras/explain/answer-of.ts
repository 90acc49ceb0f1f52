// Runs a search by rays to its end in one go.
import type { RaySearch } from '../../../src/extras/explain/ray-triangles.js';

/** The answer, and the number of steps before it. */
export function stepsOf<Answer>(search: RaySearch<Answer>): {
  readonly answer: Answer;
  readonly steps: number;
} {
  for (let steps = 0; ; steps++) {
    const { done, value } = search.next();
    if (done === true) return { answer: value, steps };
  }
}

export const answerOf = <Answer>(search: RaySearch<Answer>): Answer => stepsOf(search).answer;
