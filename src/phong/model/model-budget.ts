// What one model claims. Every format claims what a file says before it allocates or reads it; past
// a limit the result is `too-large`. Apart from the viewer's budget because no first frame needs
// it: only readers of models do.
import { type Amounts, type Claims, NO_CLAIMS, plus, requireWithin } from './budget.js';

/** Adds up what a model claims. One instance per model. */
export class ModelBudget {
  #claimed = NO_CLAIMS;
  readonly #onClaim: ((claimed: Amounts) => void) | undefined;

  /** @param onClaim called with all that is claimed so far. What it throws ends the load. */
  constructor(onClaim?: (claimed: Amounts) => void) {
    this.#onClaim = onClaim;
  }

  /** @throws ModelError `too-large` past a limit: only readers of models do. Call before allocating. */
  add(claims: Claims): void {
    const claimed = plus(this.#claimed, claims);
    requireWithin(claimed);
    this.#onClaim?.(claimed);
    this.#claimed = claimed;
  }
}
