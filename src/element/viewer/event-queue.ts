// Dispatches a viewer's events at the end of the task. Several events of one type about one subject become one, with the
// last detail; one `light-change` covers all lights. Knows nothing of what the events mean.
import type { PhongViewerEventMap } from '../events.js';
import type { PhongLight } from '../phong-light.js';

export class EventQueue {
  readonly #element: EventTarget;
  /** Type to subject to detail. */
  #waiting = new Map<string, Map<unknown, unknown>>();
  readonly #lights = new Set<PhongLight>();

  constructor(element: EventTarget) {
    this.#element = element;
  }

  /** Dispatches a `CustomEvent` at the end of the task: one per type and subject. */
  enqueue<K extends keyof PhongViewerEventMap>(
    type: K,
    detail: PhongViewerEventMap[K]['detail'],
    subject: unknown = null,
  ): void {
    if (this.#waiting.size === 0) void Promise.resolve().then(this.#dispatch); // queueMicrotask takes ten times as long
    const subjects = this.#waiting.get(type) ?? new Map<unknown, unknown>();
    this.#waiting.set(type, subjects.set(subject, detail));
  }

  /** A light was written to, or (null) lights came, went or changed places. Hundreds may do so per frame. */
  enqueueLight(light: PhongLight | null): void {
    if (light === null || this.#lights.size === 0) this.enqueue('light-change', { lights: [] });
    if (light !== null) this.#lights.add(light);
  }

  readonly #dispatch = (): void => {
    const waiting = this.#waiting;
    this.#waiting = new Map();
    waiting.get('light-change')?.set(null, { lights: Object.freeze([...this.#lights]) });
    this.#lights.clear();
    for (const [type, subjects] of waiting) {
      for (const detail of subjects.values()) this.#element.dispatchEvent(new CustomEvent(type, { detail }));
    }
  };
}
