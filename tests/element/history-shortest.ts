// The shortest history that still fails: runs of tasks, then of steps, then viewers are left out, long runs first, and each time
// the rest is played again.

import type { Scenario, Task } from './history-steps.js';

interface Found {
  scenario: Scenario;
  /** What was wrong; empty where a history did not fail again. */
  fault: string;
}

/** Plays parts of `scenario` for about so many milliseconds. `play` gives what was wrong after which task, or null. */
export async function shortest(
  scenario: Scenario,
  play: (scenario: Scenario) => Promise<string | null>,
  ms: number,
): Promise<Readonly<Found>> {
  const end = Date.now() + ms;
  const found: Found = { scenario, fault: '' };
  const attempt = async (candidate: Scenario): Promise<void> => {
    const fault = await play(candidate);
    if (fault === null) return;
    // What comes after the look that failed is not needed.
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
      for (let at = list().length - size; at > -size && Date.now() < end; at -= size)
        await attempt(withOnly(list().filter((_, i) => i < at || i >= at + size)));
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
