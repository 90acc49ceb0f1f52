// How a viewer's camera gets where it is: declared properties, hands on the picture, the turntable, and back. Knows
// neither lights nor meshes.
import type { ReactiveController } from 'lit';
import type { OrbitInputHost } from '../../camera/orbit-input.js';
import { newBasis } from '../../camera/orbit.js';
import type { Turntable } from '../../camera/turntable.js';
import { wrapDegrees } from '../../math/angle.js';
import type { Vec3 } from '../../math/vector.js';
import type { Viewport } from '../../scene/viewport.js';
import { fetched } from './fetched.js';
import { LazyInput } from './lazy-input.js';
import type { CameraValues, ViewerValues } from '../fields/viewer-fields.js';

export type CameraSource = 'pointer' | 'wheel' | 'key' | 'panel' | 'script' | 'auto';

/** The camera as it is now. Frozen. Angles in degrees, lengths in scene units, vectors in world space. */
export interface CameraState {
  readonly eye: Vec3;
  readonly target: Vec3;
  readonly up: Vec3;
  /** In [-180, 180). */
  readonly theta: number;
  readonly phi: number;
  readonly radius: number;
}

export interface CameraHost {
  readonly values: Readonly<ViewerValues>;
  readonly viewport: Viewport;
  /** CSS pixels. */
  readonly size: () => { readonly width: number; readonly height: number };
  moved(source: CameraSource): void;
}

const CAMERA_KEYS: ReadonlySet<string> = new Set<keyof CameraValues>(['theta', 'phi', 'radius', 'target']);

export class ViewerCamera implements ReactiveController {
  readonly #host: CameraHost;
  #turntable: Turntable | null = null;
  #fetchingTurntable = false;
  readonly #stillness: MediaQueryList | null;
  #input: LazyInput | null = null;
  #source: CameraSource = 'script';

  constructor(host: CameraHost) {
    this.#host = host;
    this.#stillness =
      typeof matchMedia === 'function' ? matchMedia('(prefers-reduced-motion: reduce)') : null;
  }

  /** The element that hands act on: the picture without the panel. */
  listenTo(surface: HTMLElement): void {
    this.#input = new LazyInput(surface, this.#inputHost());
    this.#input.connect();
  }

  hostConnected(): void {
    this.#input?.connect();
    this.#stillness?.addEventListener('change', this.#motionMayChange);
  }

  hostDisconnected(): void {
    this.#input?.disconnect();
    this.#turntable?.rest();
    this.#stillness?.removeEventListener('change', this.#motionMayChange);
  }

  get state(): CameraState {
    const { viewport } = this.#host;
    viewport.settle();
    const { orbit } = viewport;
    const { theta, phi, radius, target } = orbit.pose;
    const { up } = orbit.basis(newBasis());
    return Object.freeze({
      eye: Object.freeze(orbit.eye()),
      target,
      up: Object.freeze(up),
      theta: wrapDegrees(theta),
      phi,
      radius,
    });
  }

  /** A property was assigned: whatever it says is where the camera goes, the same value too. */
  assigned(key: string): void {
    if (!CAMERA_KEYS.has(key)) return;
    const { values, viewport } = this.#host;
    const { theta, phi, radius, target } = values;
    const { orbit } = viewport;
    const before = orbit.version;
    if (key === 'theta' || key === 'phi') {
      orbit.set(key === 'theta' ? { theta } : { phi });
      // A hand on the panel is a hand as well: nothing fits the camera to the scene any more.
      if (this.#source === 'panel') viewport.framing = null;
    } else {
      const { pose } = orbit;
      const kept = viewport.framing ?? { radius: pose.radius, target: pose.target };
      viewport.framing = key === 'radius' ? { ...kept, radius } : { ...kept, target };
      viewport.settle();
      if (this.#source === 'panel' && values[key as 'radius' | 'target'] !== 'auto') viewport.framing = null;
    }
    this.#input?.reanchor();
    if (orbit.version !== before) this.#told(this.#source);
  }

  /** Back to the declared camera. */
  reset(source: CameraSource = 'script'): void {
    const { values, viewport } = this.#host;
    const { theta, phi, radius, target } = values;
    const before = viewport.orbit.version;
    viewport.orbit.set({ theta, phi });
    viewport.framing = { radius, target };
    viewport.settle();
    this.#input?.reanchor();
    if (viewport.orbit.version !== before) this.#told(source);
  }

  /** Whatever `write` assigns counts as moved by `source`. */
  from(source: CameraSource, write: () => void): void {
    const outer = this.#source;
    this.#source = source;
    try {
      write();
    } finally {
      this.#source = outer;
    }
  }

  /** The picture's size changed in mid-drag: the drag goes on from here. */
  resized(): void {
    this.#input?.reanchor();
  }

  /** A step of what moves by itself; true where it goes on. */
  frame(now: number): boolean {
    if (!this.turning) {
      this.#turntable?.rest();
      return false;
    }
    if (this.#turntable === null) {
      void this.#fetchTurntable();
      return false;
    }
    const { viewport, values } = this.#host;
    if (this.#turntable.step(viewport.orbit, now, values.autoRotate)) this.#told('auto');
    return true;
  }

  /** Time that nobody sees does not turn the scene. */
  rest(): void {
    this.#turntable?.rest();
  }

  get turning(): boolean {
    return (
      this.#host.values.autoRotate !== 0 &&
      this.#stillness?.matches !== true &&
      this.#input?.dragging !== true
    );
  }

  async #fetchTurntable(): Promise<void> {
    if (this.#fetchingTurntable) return;
    this.#fetchingTurntable = true;
    const code = await fetched(() => import('../../camera/turntable.js'), 'auto-rotate');
    if (code === null) return;
    this.#turntable = new code.Turntable();
    this.#motionMayChange();
  }

  readonly #motionMayChange = (): void => {
    if (this.turning) this.#host.viewport.animate();
  };

  #told(source: CameraSource): void {
    this.#host.viewport.invalidate();
    this.#host.moved(source);
  }

  #inputHost(): OrbitInputHost {
    const { viewport, values, size } = this.#host;
    return {
      orbit: viewport.orbit,
      size,
      fov: () => viewport.fov,
      radiusLimits: () => viewport.zoomLimits,
      allows: () => ({ orbit: values.orbit, zoom: values.zoom }),
      moved: (source) => {
        // From now on the camera is the user's: nothing fits it to the scene any more.
        viewport.framing = null;
        this.#told(source);
      },
      reset: () => {
        this.reset('key');
      },
      held: (dragging) => {
        if (!dragging) this.#motionMayChange();
      },
    };
  }
}
