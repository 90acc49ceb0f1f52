// The promise that a viewer is ready: all requested is drawn, or cannot be seen. Never rejects,
// never stays pending.
import type { ViewerSignals } from './viewer-context.js';

export class Readiness {
  readonly #settled: () => boolean;
  #promise: Promise<void> = Promise.resolve();
  #resolve: (() => void) | null = null;

  constructor(signals: ViewerSignals, settled: () => boolean) {
    this.#settled = settled;
    for (const signal of [signals.ended, signals.frameEnded, signals.viewChanged]) {
      signal.listen(() => this.check());
    }
  }

  /** The current promise; a new one if something was requested since the last one resolved. */
  get promise(): Promise<void> {
    this.check();
    if (this.#resolve === null && !this.#settled()) {
      this.#renew();
    }
    return this.#promise;
  }

  /** Something newer is requested: resolves the old promise and replaces it. */
  supersede(): void {
    if (this.#resolve !== null) {
      this.#renew();
    }
  }

  check(): void {
    const resolve = this.#resolve;
    if (resolve === null || !this.#settled()) return;
    resolve();
    // #settled() may have ended loads, which call this method as well.
    if (this.#resolve === resolve) {
      this.#resolve = null;
    }
  }

  #renew() {
    this.#resolve?.();
    this.#promise = new Promise((resolve) => (this.#resolve = resolve));
  }
}
