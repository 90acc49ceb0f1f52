// Pictures of a page converge one after the other: the first is finished sooner, and one set of
// float buffers serves all of them. Pictures in view come first, and otherwise those that have
// stood still longer.
import type { WebGLRenderer } from 'three';
import { SampleSum } from './sample-sum.js';

/** A picture that takes turns. */
interface Taker {
  /** Now: scrolling changes it. */
  readonly inView: boolean;
  /** Stops until it is woken. */
  pause(): void;
  /** A turn is free. */
  wake(): void;
}

let active: Taker | null = null;
let waiting = new Set<Taker>();
/**
 * While somebody turns a knob, one picture follows the other. Allocating takes 60 ms at 1600 × 900
 * (H100, OpenGL).
 */
const KEPT_MS = 1000;

let freeing = 0;
let shared: { readonly renderer: WebGLRenderer; readonly sum: SampleSum } | null = null;

/** It will take its turn soon: whoever comes before it is known then. */
export function queue(one: Taker): void {
  if (active !== one) {
    waiting.add(one);
  }
}

/** Whether it is this one's turn. If not, it is woken once it may be. */
export function take(one: Taker): boolean {
  queue(one);
  const next = nextWaiting();
  if (active?.inView === false && next?.inView === true) {
    const interrupted = active;
    interrupted.pause();
    waiting = new Set([interrupted, ...waiting]);
  }
  if (active === null && next === one) {
    active = one;
    waiting.delete(one);
  } else if (active === null) {
    next?.wake();
  }
  return active === one;
}

function nextWaiting(): Taker | undefined {
  for (const one of waiting) {
    if (one.inView) return one;
  }
  const [first] = waiting;
  return first;
}

export function seize(one: Taker): void {
  if (active !== one) {
    active?.pause();
  }
  active = one;
  waiting.delete(one);
}

/** It needs no turn any more, or not now. */
export function release(one: Taker): void {
  if (active === one) {
    active = null;
  } else if (!waiting.delete(one)) {
    return;
  }
  if (active !== null) return;
  const next = nextWaiting();
  clearTimeout(freeing);
  if (next !== undefined) {
    next.wake();
  } else {
    freeing = window.setTimeout(() => {
      if (active === null) {
        shared?.sum.free();
      }
    }, KEPT_MS);
  }
}

/** The buffers of the active picture. A restored context has another renderer. */
export function sharedSum(renderer: WebGLRenderer): SampleSum {
  clearTimeout(freeing);
  if (shared?.renderer !== renderer) {
    shared?.sum.dispose();
    shared = { renderer, sum: new SampleSum(renderer) };
  }
  return shared.sum;
}
