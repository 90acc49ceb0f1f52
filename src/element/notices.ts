// Telling others what happened, at the end of the task: what is told several times of one subject is told once, with
// the last detail. Knows nothing of what the events mean.
import type { PhongViewerEventMap } from './events.js';

interface Notice {
  readonly type: string;
  readonly subject: unknown;
  detail: unknown;
}

export class Notices {
  readonly #element: EventTarget;
  #waiting: Notice[] = [];

  constructor(element: EventTarget) {
    this.#element = element;
  }

  /** Dispatches a `CustomEvent` at the task's end: one for each type and subject. */
  tell<K extends keyof PhongViewerEventMap>(
    type: K,
    detail: PhongViewerEventMap[K]['detail'],
    subject: unknown = null,
  ): void {
    const same = this.#waiting.find((notice) => notice.type === type && notice.subject === subject);
    if (same !== undefined) {
      same.detail = detail;
      return;
    }
    if (this.#waiting.length === 0) queueMicrotask(this.#dispatch);
    this.#waiting.push({ type, subject, detail });
  }

  readonly #dispatch = (): void => {
    const notices = this.#waiting;
    this.#waiting = [];
    for (const { type, detail } of notices) this.#element.dispatchEvent(new CustomEvent(type, { detail }));
  };
}
