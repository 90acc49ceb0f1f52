// How does a long loop keep the page responsive? It ends its task now and then. Knows nothing of what the loop does.

/** Time between two pauses. A task of 50 ms is what browsers call long; what a step does after the check needs room too. */
const SLICE_MS = 20;

/** Steps of a loop between two looks at the clock: a power of two, minus 1. */
export const PAUSE_MASK = 0x7ff;

export class Pauses {
  readonly #signal: AbortSignal;
  #end = performance.now() + SLICE_MS;

  /** A pause throws the signal's reason after an abort. */
  constructor(signal: AbortSignal) {
    this.#signal = signal;
  }

  /** Whether it is time for a pause. */
  get due(): boolean {
    return performance.now() >= this.#end;
  }

  get aborted(): boolean {
    return this.#signal.aborted;
  }

  async pause(): Promise<void> {
    await nextTask();
    this.#signal.throwIfAborted();
    this.#end = performance.now() + SLICE_MS;
  }
}

/** Not by a timer: browsers delay nested timers by 4 ms, and those of hidden pages by a second. */
function nextTask(): Promise<void> {
  return new Promise((resolve) => {
    const { port1, port2 } = new MessageChannel();
    port1.onmessage = () => {
      port1.close();
      resolve();
    };
    port2.postMessage(null);
  });
}
