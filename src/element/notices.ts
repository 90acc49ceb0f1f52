// Telling others what happened, once a task: events of one kind become one with the last one's detail. Knows nothing
// of what the events mean.
import type { PhongViewerEventMap } from './events.js';

export class Notices {
  readonly #element: EventTarget;
  readonly #events = new Map<string, unknown>();

  constructor(element: EventTarget) {
    this.#element = element;
  }

  /** Dispatches a `CustomEvent` at the task's end. */
  tell<K extends keyof PhongViewerEventMap>(type: K, detail: PhongViewerEventMap[K]['detail']): void {
    if (this.#events.size === 0) queueMicrotask(this.#dispatch);
    this.#events.set(type, detail);
  }

  readonly #dispatch = (): void => {
    const events = [...this.#events];
    this.#events.clear();
    for (const [type, detail] of events) this.#element.dispatchEvent(new CustomEvent(type, { detail }));
  };
}
