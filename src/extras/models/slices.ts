// Keeps the page responsive: long loops run in slices and let the browser handle input and frames
// between them.
import type { ModelBudget } from '../../phong/model/model-budget.js';

/** Half a frame at 60 Hz. */
const TASK_MS = 8;

/**
 * Items between two looks at the clock. Even the costliest item, a skinned vertex, takes less than
 * a microsecond.
 */
const SLICE = 3 * 2 ** 13;

/** Items between two looks at the clock in loops that call {@link Slices.took}. */
const TOOK = 2 ** 11;

/** Items between two claims of work. */
const CLAIMED = 2 ** 18;

/** Items between two looks at the clock in {@link Slices.map}, less one. */
const MAP_MASK = 0xf;

/** Loops that share a clock and end when the load is aborted. */
export class Slices {
  readonly #signal: AbortSignal;
  readonly #budget: ModelBudget | null;
  #since = performance.now();
  /** Items since the last look at the clock, and since the last claim. */
  #work = 0;
  #unclaimed = 0;

  /** `budget` gets the work that {@link took} counts. */
  constructor(signal: AbortSignal, budget: ModelBudget | null = null) {
    this.#signal = signal;
    this.#budget = budget;
  }

  /**
   * Calls `work` for consecutive ranges from 0 to `count`, all a multiple of 3 long but the last.
   * @param cost of an item, where it takes that many times as long as a usual one.
   * @throws the signal's reason after an abort.
   */
  async over(count: number, work: (from: number, to: number) => void, cost = 1): Promise<void> {
    const step = 3 * Math.ceil(SLICE / cost / 3);
    for (let from = 0; from < count; from += step) {
      work(from, Math.min(from + step, count));
      await this.pauseIfDue();
    }
  }

  /** The results of `work`, whose steps take at most 300 µs each, for all items. */
  async map<Item, Result>(
    items: readonly Item[],
    work: (item: Item, i: number) => Result,
  ): Promise<Result[]> {
    const results: Result[] = [];
    for (const [i, item] of items.entries()) {
      results.push(work(item, i));
      if ((i & MAP_MASK) === MAP_MASK) {
        await this.pauseIfDue();
      }
    }
    return results;
  }

  async joined(pieces: readonly Uint8Array[]): Promise<Uint8Array<ArrayBuffer>> {
    const bytes = new Uint8Array(pieces.reduce((sum, { byteLength }) => sum + byteLength, 0));
    let at = 0;
    for (const piece of pieces) {
      bytes.set(piece, at);
      at += piece.byteLength;
      await this.pauseIfDue();
    }
    return bytes;
  }

  /** Whether the task has taken long enough: call {@link pause}. */
  get due() {
    return performance.now() - this.#since > TASK_MS;
  }

  /**
   * Counts work done, in items of a microsecond at most. True where it is time to call {@link
   * pause}: for loops that call it only then, as waiting costs more than an item.
   * @throws ModelError `too-large` where that is more work than the budget has.
   */
  took(items = 1): boolean {
    this.#work += items;
    if (this.#work < TOOK) return false;
    this.#unclaimed += this.#work;
    this.#work = 0;
    if (this.#unclaimed >= CLAIMED) {
      this.#budget?.add({ work: Math.ceil(this.#unclaimed) });
      this.#unclaimed = 0;
    }
    return this.due;
  }

  /** Call between pieces of work that know no number of items. */
  async pauseIfDue(): Promise<void> {
    if (this.due) {
      await this.pause();
    }
  }

  /**
   * Lets other tasks run. Faster than a timer, which browsers delay by 4 ms where timers are nested
   * (https://html.spec.whatwg.org/multipage/timers-and-user-prompts.html), and by a second in
   * hidden pages.
   */
  async pause(): Promise<void> {
    await new Promise<void>((resolve) => {
      const { port1, port2 } = new MessageChannel();
      port1.onmessage = () => {
        port1.close();
        resolve();
      };
      port2.postMessage(null);
    });
    this.#signal.throwIfAborted();
    this.#since = performance.now();
  }
}
