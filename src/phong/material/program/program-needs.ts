// What the programs of a picture depend on besides its materials: features of its lights, and what
// draws it.
import type { WebGLRenderer } from 'three';
import { declaredFeatures } from '../../light/light-features.js';
import type { LightSet } from '../../light/light-set.js';
import { type Device, deviceOf } from '../device.js';

export class ProgramNeeds {
  readonly #lights: LightSet;
  #version = 0;
  #declared = 0;
  /** The version of the lights that were declared. */
  #lightVersion = -1;
  #device: Device | null = null;
  #capacity = 0;

  constructor(lights: LightSet) {
    this.#lights = lights;
  }

  /** Goes up with what decides which general programs are needed. */
  get version(): number {
    return this.#version;
  }

  /** Other programs may be needed. */
  restyled(): void {
    this.#version += 1;
  }

  /** What all lights since load need: see {@link declaredFeatures}. Bits are only ever added. */
  get declared(): number {
    return this.#declared;
  }

  /** Adds the features of all lights to {@link declared}. */
  declare(): void {
    const { values, version } = this.#lights;
    if (version === this.#lightVersion) return;
    this.#lightVersion = version;
    const declared = this.#declared | declaredFeatures(values);
    if (declared === this.#declared) return;
    this.#declared = declared;
    this.#version += 1;
  }

  /** What {@link renderer} draws on. */
  get device(): Device | null {
    return this.#device;
  }

  /** What drew last; null: nothing, or it is to be sent everything again. */
  get renderer(): WebGLRenderer | null {
    return this.#device?.renderer ?? null;
  }

  set renderer(renderer: WebGLRenderer | null) {
    this.#device = renderer === null ? null : deviceOf(renderer);
    this.#capacity = 0;
  }

  /** Rows of the uniform array in general programs, or 0 for a texture. */
  get capacity(): number {
    return this.#device?.capacities[this.#capacity] ?? 0;
  }

  /** Makes the uniform array long enough. It never shrinks: lights that come and go compile once. */
  fit(rows: number): void {
    const capacities = this.#device?.capacities ?? [];
    while (rows > (capacities[this.#capacity] ?? Infinity)) {
      this.#capacity += 1;
    }
  }
}
