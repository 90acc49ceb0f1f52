// Runs a long computation in short tasks, so that the page can answer between them.

/** A computation that yields after each piece of about a millisecond. */
type Steps<Result> = Iterator<unknown, Result, undefined>;

/** Milliseconds of a task: half a frame at 60 Hz. */
const TASK = 8;

/** The first task begins at once. Throws the signal's reason after an abort. */
export async function inTasks<Result>(steps: Steps<Result>, signal?: AbortSignal): Promise<Result> {
  for (;;) {
    signal?.throwIfAborted();
    const step = runFor(TASK, steps);
    if (step.done === true) return step.value;
    await nextTask();
  }
}

/** Runs steps until the time is over, one at least. Returns the last one. */
export function runFor<Result>(
  milliseconds: number,
  steps: Steps<Result>,
): IteratorResult<unknown, Result> {
  const end = performance.now() + milliseconds;
  let step = steps.next();
  while (step.done !== true && performance.now() < end) {
    step = steps.next();
  }
  return step;
}

/**
 * Timers of timers wait 4 ms, messages do not. `Slices.pause` is the same; sharing it would take a
 * request.
 */
const nextTask = (): Promise<void> =>
  new Promise((resolve) => {
    const { port1, port2 } = new MessageChannel();
    port1.onmessage = () => {
      port1.close();
      resolve();
    };
    port2.postMessage(null);
  });
