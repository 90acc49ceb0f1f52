// Which lights there are, in which order, and whether anything about them has changed. Knows neither the DOM nor
// how lights are packed.
import type { LightState, LightValues } from './light-state.js';

/** The lights of one picture, in order. */
export class LightSet {
  readonly #lights: LightState[] = [];
  readonly #values: Readonly<LightValues>[] = [];
  readonly #listeners = new Map<LightState, () => void>();
  readonly #changed: (light: LightState | null) => void;
  #version = 0;

  /** `changed` is called after each change: with the light written to, or null when lights came, went or moved. */
  constructor(changed: (light: LightState | null) => void = () => undefined) {
    this.#changed = changed;
  }

  /** Goes up with every change: whoever packed an older version packs again. */
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

  /** Makes these the lights, in this order. A light tells the set that took it last. */
  assign(lights: readonly LightState[]): void {
    if (lights.length === this.#lights.length && lights.every((light, i) => light === this.#lights[i]))
      return;
    for (const [light, listener] of this.#listeners) light.unlisten(listener);
    this.#listeners.clear();
    this.#lights.splice(0, Infinity, ...lights);
    this.#values.splice(0, Infinity, ...lights.map(({ values }) => values));
    for (const light of lights) this.#listen(light);
    this.#bump(null);
  }

  add(light: LightState): void {
    this.assign([...this.#lights, light]);
  }

  remove(light: LightState): void {
    this.assign(this.#lights.filter((other) => other !== light));
  }

  #listen(light: LightState): void {
    const listener = (): void => {
      this.#bump(light);
    };
    light.listen(listener);
    this.#listeners.set(light, listener);
  }

  #bump(light: LightState | null): void {
    this.#version += 1;
    this.#changed(light);
  }
}
