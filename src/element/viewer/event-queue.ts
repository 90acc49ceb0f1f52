// Dispatches a viewer's events at the end of the task. Several events of one type become one with the last detail,
// where each only says how things are now; one `light-change` covers all lights.
import type { LightState } from '../../light/light-state.js';
import type { PhongViewerEventMap } from '../events.js';
import type { Signal } from '../../fields/signal.js';
import type { PhongLight } from '../elements.js';
import { ElementLight } from '../phong-light.js';

interface WaitingEvent {
  readonly type: keyof PhongViewerEventMap;
  detail: unknown;
}

/** Its detail is made when it is dispatched. */
const LIGHT_CHANGE: WaitingEvent = { type: 'light-change', detail: null };

/** Counts the `light-change` events of all viewers: a light may go from one viewer to another. */
let batches = 0;

export class EventQueue {
  readonly #element: EventTarget;
  readonly #lightsReported: Signal<readonly PhongLight[]>;
  #waiting: WaitingEvent[] = [];
  /** Written to since the last `light-change`, each once. */
  #lights: PhongLight[] = [];
  #batch = (batches += 1);

  /** `lightsReported` is given before each `light-change`: a listener of the event costs more than the event itself. */
  constructor(element: EventTarget, lightsReported: Signal<readonly PhongLight[]>) {
    this.#element = element;
    this.#lightsReported = lightsReported;
  }

  /** Dispatches a `CustomEvent` at the end of the task, in place of one of this type that waits already. */
  enqueue<K extends keyof PhongViewerEventMap>(type: K, detail: PhongViewerEventMap[K]['detail']): void {
    for (const event of this.#waiting) {
      if (event.type !== type) continue;
      event.detail = detail;
      return;
    }
    this.append(type, detail);
  }

  /** Dispatches a `CustomEvent` at the end of the task, after those of its type that wait already. */
  append<K extends keyof PhongViewerEventMap>(type: K, detail: PhongViewerEventMap[K]['detail']): void {
    this.#append({ type, detail });
  }

  /** A light was written to, or (null) lights came, went or changed places. Hundreds may do so per frame. */
  enqueueLight(light: LightState | null): void {
    if ((light === null || this.#lights.length === 0) && !this.#waiting.includes(LIGHT_CHANGE))
      this.#append(LIGHT_CHANGE);
    if (!(light instanceof ElementLight) || light.element === null || light.batch === this.#batch) return;
    light.batch = this.#batch;
    this.#lights.push(light.element);
  }

  #append(event: WaitingEvent): void {
    if (this.#waiting.length === 0) void Promise.resolve().then(this.#dispatch); // queueMicrotask takes ten times as long
    this.#waiting.push(event);
  }

  readonly #dispatch = (): void => {
    const waiting = this.#waiting;
    const lights = Object.freeze(this.#lights);
    this.#waiting = [];
    this.#lights = [];
    this.#batch = batches += 1;
    for (const event of waiting) {
      if (event === LIGHT_CHANGE) this.#lightsReported.emit(lights);
      const detail = event === LIGHT_CHANGE ? { lights } : event.detail;
      this.#element.dispatchEvent(new CustomEvent(event.type, { detail }));
    }
  };
}
