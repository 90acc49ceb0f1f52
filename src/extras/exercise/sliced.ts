// Runs a long computation in tasks that leave the page time to answer.
import type { Work } from '../../phong/mistakes/judge.js';

/** Milliseconds of a task: two steps of a usual computation after it are still below 50. */
const SLICE = 25;

/** Begins in a task of its own. Throws the signal's reason after an abort. */
export async function sliced<Result>(work: Work<Result>, signal: AbortSignal): Promise<Result> {
  for (;;) {
    await new Promise((resolve) => setTimeout(resolve));
    signal.throwIfAborted();
    const end = performance.now() + SLICE;
    while (performance.now() < end) {
      const { done, value } = work.next();
      if (done === true) return value;
    }
  }
}
