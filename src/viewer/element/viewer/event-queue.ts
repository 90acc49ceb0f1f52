// Dispatches a viewer's events at the end of the task. Several events of one type become one with
// the last detail, where each only says how things are now; one `light-change` covers all lights.
import type { Signal } from '../../../phong/fields/signal.js';
import type { LightState } from '../../../phong/light/light-state.js';
import type { PhongLight, PhongViewerEventMap } from '../elements.js';
import { lightOf } from '../phong-light.js';

export class EventQueue {
  readonly #element: EventTarget;
  readonly #lightsReported: Signal<readonly PhongLight[]>;
  #waiting: { readonly type: keyof PhongViewerEventMap; detail: unknown }[] = [];
  /** Written to since the last `light-change`; null while none waits. */
  #lights: Set<PhongLight> | null = null;

  /**
   * `lightsReported` is given before each `light-change`: a listener of the event costs more than
   * the event itself.
   */
  constructor(element: EventTarget, lightsReported: Signal<readonly PhongLight[]>) {
    this.#element = element;
    this.#lightsReported = lightsReported;
  }

  /**
   * Dispatches a `CustomEvent` at the end of the task, in place of one of this type that waits
   * already.
   */
  enqueue<K extends keyof PhongViewerEventMap>(
    type: K,
    detail: PhongViewerEventMap[K]['detail'],
  ): void {
    const event = this.#waiting.find((waiting) => waiting.type === type);
    if (event === undefined) {
      this.append(type, detail);
    } else {
      event.detail = detail;
    }
  }

  /**
   * Dispatches a `CustomEvent` at the end of the task, after those of its type that wait already.
   */
  append<K extends keyof PhongViewerEventMap>(
    type: K,
    detail: PhongViewerEventMap[K]['detail'],
  ): void {
    if (this.#waiting.length === 0) {
      void Promise.resolve().then(this.#dispatch); // queueMicrotask takes ten times as long
    }
    this.#waiting.push({ type, detail });
  }

  /**
   * A light was written to, or (null) lights came, went or changed places. Hundreds may do so per
   * frame.
   */
  enqueueLight(light: LightState | null): void {
    if (this.#lights === null) {
      this.#lights = new Set();
      this.append('light-change', { lights: [] }); // which ones, is known when it is dispatched
    }
    const element = light === null ? null : lightOf(light);
    if (element !== null) {
      this.#lights.add(element);
    }
  }

  readonly #dispatch = () => {
    const waiting = this.#waiting;
    const lights = Object.freeze([...(this.#lights ?? [])]);
    this.#waiting = [];
    this.#lights = null;
    for (const { type, detail } of waiting) {
      const isLights = type === 'light-change';
      if (isLights) {
        this.#lightsReported.emit(lights);
      }
      this.#element.dispatchEvent(
        new CustomEvent(type, { detail: isLights ? { lights } : detail }),
      );
    }
  };
}
