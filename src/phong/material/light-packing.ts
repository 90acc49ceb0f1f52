// Packs the lights of a picture when lights, origin or colour space have changed.
import { Matrix4 } from 'three';
import type { LightSet } from '../light/light-set.js';
import { packLights } from '../light/pack-lights.js';
import type { Vec3 } from '../math/vector.js';
import { LightBuffer } from './light-buffer.js';
import { type ShadingFrame, writeCamera } from './shading-space.js';
import type { PictureView } from './views.js';

export class LightPacking {
  /** All lights, packed. */
  readonly buffer = new LightBuffer();
  /** The last {@link update} changed a packed number. */
  changed = false;
  /**
   * Shown in place of the shaded colour; null: nothing. Materials need a call of `setStyle`
   * afterwards.
   */
  view: PictureView | null = null;
  readonly #lights: LightSet;
  /** The version of the light set, and what else the lights were last packed for. */
  readonly #packedFor = {
    lights: -1,
    origin: null as Vec3 | null,
    view: null as PictureView | null,
    linear: false,
  };
  /** A light turns with the eye, active or not. */
  #followsCamera = false;
  readonly #worldToShading = new Matrix4();
  readonly #cameraToShading = new Matrix4();
  readonly space = {
    worldToShading: this.#worldToShading.elements,
    cameraToShading: this.#cameraToShading.elements,
    /** As {@link PhongLighting.linear}. */
    linear: false,
  };

  constructor(lights: LightSet) {
    this.#lights = lights;
  }

  /** A frame begins. `origin` is another array if it is another place. */
  update(frame: ShadingFrame, origin: Vec3): void {
    const { values, version } = this.#lights;
    const { view, space } = this;
    const { linear } = space;
    const last = this.#packedFor;
    const isStyled = view === last.view && linear === last.linear;
    if (version !== last.lights) {
      this.#followsCamera = values.some(({ space }) => space === 'camera');
    }
    this.changed = false;
    const isSame = isStyled && origin === last.origin && version === last.lights;
    if (isSame && !this.#followsCamera) return;
    last.lights = version;
    last.origin = origin;
    last.view = view;
    last.linear = linear;
    const { packed, revision } = this.buffer;
    this.#worldToShading.makeTranslation(-origin[0], -origin[1], -origin[2]);
    writeCamera(this.#cameraToShading, frame, frame.eye);
    if (view === null) {
      packLights(values, space, packed);
    } else {
      view.pack(values, space, packed);
    }
    this.buffer.changed();
    this.changed = this.buffer.revision !== revision;
  }
}
