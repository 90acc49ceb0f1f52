// Reduces a failing history: leaves out runs of tasks, then of steps, then viewers, long runs
// first, and plays the rest again each time.

import type { Scenario, Task } from './history-steps.js';

interface Found {
  scenario: Scenario;
  /** Empty if the history did not fail again. */
  fault: string;
}

/** Returns the fault and the task that it follows, or null. */
type Play = (scenario: Scenario) => Promise<string | null>;

/** Milliseconds for reducing a failing history. */
const SHORTENING_MS = Number(process.env['PHONG_VIEWER_SHORTENING'] ?? 60_000);

/** Throws an error with this message and the shortest part of `history` that still fails. */
export async function failWithShortest(
  message: string,
  history: Scenario,
  play: Play,
): Promise<never> {
  const { scenario, fault } = await shortest(history, play);
  const lines = [...scenario.begins, ...scenario.tasks.map((task) => JSON.stringify(task))].join(
    '\n',
  );
  throw new Error(`${message}\n\nshortest:\n${lines}\n${fault || 'did not fail again'}`);
}

async function shortest(scenario: Scenario, play: Play): Promise<Readonly<Found>> {
  const end = Date.now() + SHORTENING_MS;
  const found: Found = { scenario, fault: '' };
  const attempt = async (candidate: Scenario): Promise<void> => {
    const fault = await play(candidate);
    if (fault === null) return;
    // Tasks after the failing look are not needed.
    const last = Number(/^after task (\d+)/.exec(fault)?.[1]);
    found.scenario = { ...candidate, tasks: candidate.tasks.slice(0, last + 1) };
    found.fault = fault;
  };
  const thin = async <T>(
    list: () => readonly T[],
    withOnly: (left: readonly T[]) => Scenario,
  ): Promise<void> => {
    let size = list().length;
    while (size > 1) {
      size = Math.ceil(size / 2);
      for (let at = list().length - size; at > -size && Date.now() < end; at -= size) {
        await attempt(withOnly(list().filter((_, i) => i < at || i >= at + size)));
      }
    }
  };
  await attempt(scenario);
  if (found.fault === '') return found;
  const look: Task = { steps: [], then: 'look' };
  await thin(
    () => found.scenario.tasks,
    (left) => ({ ...found.scenario, tasks: [...left, look] }),
  );
  for (let i = found.scenario.tasks.length - 1; i >= 0; i--) {
    const others = (steps: Task['steps']): readonly Task[] =>
      found.scenario.tasks.map((task, j) => (j === i ? { ...task, steps } : task));
    await thin(
      () => found.scenario.tasks[i]?.steps ?? [],
      (steps) => ({ ...found.scenario, tasks: others(steps) }),
    );
  }
  await thin(
    () => found.scenario.begins,
    (begins) => ({ ...found.scenario, begins }),
  );
  return found;
}
