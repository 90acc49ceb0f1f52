// Telling others what happened, at the end of the task: what is told several times of one subject is told once, with
// the last detail. Knows nothing of what the events mean.
import type { PhongViewerEventMap } from './events.js';

export class Notices {
  readonly #element: EventTarget;
  /** Type to subject to detail. */
  #waiting = new Map<string, Map<unknown, unknown>>();

  constructor(element: EventTarget) {
    this.#element = element;
  }

  /** Dispatches a `CustomEvent` at the task's end: one for each type and subject. A detail that is a function is asked for then. */
  tell<K extends keyof PhongViewerEventMap>(
    type: K,
    detail: PhongViewerEventMap[K]['detail'] | (() => PhongViewerEventMap[K]['detail']),
    subject: unknown = null,
  ): void {
    if (this.#waiting.size === 0) void Promise.resolve().then(this.#dispatch); // queueMicrotask takes ten times as long
    const subjects = this.#waiting.get(type) ?? new Map<unknown, unknown>();
    this.#waiting.set(type, subjects.set(subject, detail));
  }

  readonly #dispatch = (): void => {
    const waiting = this.#waiting;
    this.#waiting = new Map();
    for (const [type, subjects] of waiting) {
      for (const told of subjects.values()) {
        const detail: unknown = typeof told === 'function' ? told() : told;
        this.#element.dispatchEvent(new CustomEvent(type, { detail }));
      }
    }
  };
}
