// The promise that a viewer is ready: resolved once all that was asked for is drawn, or cannot be seen; never rejected,
// never pending for ever. Knows nothing of what is drawn.

export class Readiness {
  readonly #settled: () => boolean;
  #promise: Promise<void> = Promise.resolve();
  #resolve: (() => void) | null = null;

  /** `settled` says whether everything asked for so far is there. */
  constructor(settled: () => boolean) {
    this.#settled = settled;
  }

  /** The current promise; a new one where something has been asked for since the last was kept. */
  get promise(): Promise<void> {
    this.check();
    if (this.#resolve === null && !this.#settled()) this.#renew();
    return this.#promise;
  }

  /** Something newer is asked for: whoever waits for the old waits no longer. */
  supersede(): void {
    if (this.#resolve !== null) this.#renew();
  }

  /** After anything that may have settled it. */
  check(): void {
    const resolve = this.#resolve;
    if (resolve === null || !this.#settled()) return;
    resolve();
    // Finding out may have brought loads to their end, and those check as well.
    if (this.#resolve === resolve) this.#resolve = null;
  }

  #renew(): void {
    this.#resolve?.();
    this.#promise = new Promise((resolve) => {
      this.#resolve = resolve;
    });
  }
}
