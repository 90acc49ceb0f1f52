// Plays histories, and reduces a failing one by fast-check: leaves out viewers and steps, and plays
// the rest again each time.
import fc from 'fast-check';
import type { Scenario } from './history-steps.js';

/** Milliseconds for reducing a failing history. */
const SHORTENING_MS = Number(process.env['PHONG_VIEWER_SHORTENING'] ?? 60_000);

/** Returns the fault, or null. */
type Play = (scenario: Scenario) => Promise<string | null>;

/**
 * Plays the histories of these seeds. Throws the first fault, with a shorter history that still has
 * one.
 */
export async function playSeeds(
  seeds: readonly number[],
  historyOf: (seed: number) => Scenario,
  play: Play,
): Promise<void> {
  for (const seed of seeds) {
    const history = historyOf(seed);
    const fault = await play(history);
    if (fault !== null) {
      await failWithShortest(`seed ${seed}, ${fault}`, history, play);
    }
  }
}

async function failWithShortest(message: string, { begins, tasks }: Scenario, play: Play) {
  // Two viewers can begin alike.
  const viewers = begins.map((markup) => ({ markup }));
  const parts = [...viewers, ...tasks.flatMap(({ steps }) => steps)];
  const left = (list: readonly (typeof parts)[number][]): Scenario => ({
    begins: viewers.filter((one) => list.includes(one)).map(({ markup }) => markup),
    tasks: tasks.map((task) => ({
      ...task,
      steps: task.steps.filter((one) => list.includes(one)),
    })),
  });
  const shortened = fc.asyncProperty(fc.uniqueArray(fc.constantFrom(...parts)), async (list) => {
    const fault = await play(left(list));
    if (fault !== null) throw new Error(fault);
  });
  const { counterexample, errorInstance } = await fc.check(shortened, {
    examples: [[parts]],
    numRuns: 1,
    interruptAfterTimeLimit: SHORTENING_MS,
  });
  const shortest = JSON.stringify(left(counterexample?.[0] ?? parts), null, 1);
  throw new Error(
    `${message}\n\nshortest:\n${shortest}\n${String(errorInstance ?? 'did not fail again')}`,
  );
}
