// Which lights there are, in which order, and whether anything about them has changed.
import { sameValue } from '../fields/field-store.js';
import { Signal } from '../fields/signal.js';
import type { LightState, LightValues } from './light-state.js';

/** The lights of one picture, in order. */
export class LightSet {
  readonly #lights: LightState[] = [];
  readonly #values: Readonly<LightValues>[] = [];
  readonly #listeners = new Map<LightState, () => void>();
  #version = 0;

  /**
   * Given after each change, hundreds of times a frame: with the light that was written to, or null
   * when lights were added, removed or reordered.
   */
  readonly changed = new Signal<LightState | null>();

  /** Increments with every change. Lights packed for an older version are out of date. */
  get version(): number {
    return this.#version;
  }

  get lights(): readonly LightState[] {
    return this.#lights;
  }

  /** The lights' values, in order; live. */
  get values(): readonly Readonly<LightValues>[] {
    return this.#values;
  }

  /** Makes these the lights, in this order. A light notifies only the set that took it last. */
  assign(lights: readonly LightState[]): void {
    if (sameValue(lights, this.#lights)) return;
    for (const [light, listener] of this.#listeners) {
      light.unlisten(listener);
    }
    this.#listeners.clear();
    this.#lights.splice(0, Infinity, ...lights);
    this.#values.splice(0, Infinity, ...lights.map(({ values }) => values));
    for (const light of lights) {
      this.#listen(light);
    }
    this.#bump(null);
  }

  /** Adds a light at the end, in constant time. */
  add(light: LightState): void {
    this.#lights.push(light);
    this.#values.push(light.values);
    this.#listen(light);
    this.#bump(null);
  }

  remove(light: LightState): void {
    const listener = this.#listeners.get(light);
    if (listener === undefined) return;
    light.unlisten(listener);
    this.#listeners.delete(light);
    for (let index = this.#lights.indexOf(light); index >= 0; index = this.#lights.indexOf(light)) {
      this.#lights.splice(index, 1);
      this.#values.splice(index, 1);
    }
    this.#bump(null);
  }

  #listen(light: LightState) {
    const listener = (): void => this.#bump(light);
    light.listen(listener);
    this.#listeners.set(light, listener);
  }

  #bump(light: LightState | null) {
    this.#version += 1;
    this.changed.emit(light);
  }
}
