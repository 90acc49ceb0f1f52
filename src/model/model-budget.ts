// What one model claims. Every format claims what a file says before it allocates or reads it; past a limit the result
// is `too-large`. Apart from the viewer's budget because no first frame needs it.
import { type Amounts, type Claims, NO_CLAIMS, plus, requireWithin } from './budget.js';

export { requireAtMost } from './budget.js';

/** Adds up what a model claims. One instance per model. */
export class ModelBudget {
  #claimed = NO_CLAIMS;
  readonly #onClaim: ((claimed: Amounts) => void) | undefined;

  /**
   * @param onClaim called with all that is claimed so far. What it throws ends the load: for what other models take.
   */
  constructor(onClaim?: (claimed: Amounts) => void) {
    this.#onClaim = onClaim;
  }

  /** @throws ModelError `too-large` past a limit. Call before allocating. */
  add(claims: Claims): void {
    const claimed = plus(this.#claimed, claims);
    requireWithin(claimed);
    this.#onClaim?.(claimed);
    this.#claimed = claimed;
  }

  /**
   * Claims time: call before items are visited that no other claim counts (keys of animations, entries of lists, tokens
   * of a text), for many at once. An item takes some 10 ns. @throws ModelError `too-large`.
   */
  claimWork(items: number): void {
    this.add({ work: items });
  }
}
