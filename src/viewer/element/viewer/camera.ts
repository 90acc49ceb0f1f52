// How a viewer's camera moves: declared properties, pointer, wheel, keys, turntable, reset. Also
// when models may move.
import type { ReactiveController } from 'lit';
import { zoomLimits } from '../../../phong/camera/fit.js';
import { OrbitInput, type OrbitInputHost } from '../../../phong/camera/orbit-input.js';
import { newBasis, type Pose } from '../../../phong/camera/orbit.js';
import { Turntable } from '../../../phong/camera/turntable.js';
import { wrapDegrees } from '../../../phong/math/angle.js';
import type { Framing } from '../../../phong/geometry/framing.js';
import type { CameraSource, CameraState } from '../elements.js';
import { pictureBox } from '../page/picture-box.js';
import type { ViewerValues } from '../fields/viewer-fields.js';
import type { ViewerContext } from './viewer-context.js';

/** Where the camera is and whether it fits the scene, apart from what is declared. */
export interface CameraPlacement {
  readonly pose: Pose;
  /** What is `auto`; null once the user has moved the camera. */
  readonly framing: Framing | null;
}

/** The group of this camera, whose code is a chunk. */
type CameraLink = Readonly<{
  moved: (camera: ViewerCamera, source: CameraSource) => void;
  turns: (camera: ViewerCamera) => boolean;
}>;

/** Values that act when they are assigned: the viewer needs no update for them. */
export const CAMERA_KEYS: ReadonlySet<string> = new Set<keyof ViewerValues>([
  'theta',
  'phi',
  'radius',
  'target',
]);

export class ViewerCamera implements ReactiveController {
  readonly #context: ViewerContext;
  readonly #turntable = new Turntable();
  #reducedMotion: MediaQueryList | null = null;
  #inView = false;
  #input: OrbitInput | null = null;
  /** Null, the default: this camera moves alone. */
  link: CameraLink | null = null;

  constructor(context: ViewerContext) {
    const { signals } = (this.#context = context);
    signals.moveTo = (now) => {
      signals.orderNeeded.emit();
      return this.#frame(now);
    };
    signals.fitted.listen((isFirst) => {
      if (isFirst) return;
      signals.cameraMoved.emit({ source: 'auto', linked: false }); // in the frame that is being drawn
      this.link?.moved(this, 'auto');
    });
    signals.viewChanged.listen(({ visible }) => {
      this.#input?.reanchor(); // a drag in progress continues at the new size
      this.#setInView(visible);
    });
  }

  listenTo(surface: HTMLElement): void {
    this.#input = new OrbitInput(surface, this.#inputHost(surface));
    this.#input.connect();
  }

  hostConnected(): void {
    this.#input?.connect();
    const view = this.#context.viewport.holder.ownerDocument.defaultView;
    this.#reducedMotion = view?.matchMedia('(prefers-reduced-motion: reduce)') ?? null;
    this.#reducedMotion?.addEventListener('change', this.#startMotion);
  }

  hostDisconnected(): void {
    this.#input?.disconnect();
    this.#setInView(false);
    this.#reducedMotion?.removeEventListener('change', this.#startMotion);
  }

  state(): CameraState {
    const { picture } = this.#context;
    picture.settle();
    const { orbit } = picture;
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

  placement(): CameraPlacement {
    const { picture } = this.#context;
    picture.settle();
    return { pose: picture.orbit.pose, framing: picture.fit.framing };
  }

  /**
   * Moves the camera as the user does: the declared values stay. `linked`: by another camera of its
   * group.
   */
  place({ pose, framing }: CameraPlacement, source: CameraSource, linked = false): void {
    const { orbit, fit } = this.#context.picture;
    const write = () => {
      orbit.set(pose);
      if (framing !== fit.framing) {
        fit.framing = framing;
      }
      fit.settle();
    };
    this.#move(source, write, linked);
  }

  /** A property was assigned. Moves the camera there, even if the value is the same as before. */
  assigned(key: string): void {
    if (!CAMERA_KEYS.has(key)) return;
    const { values, picture } = this.#context;
    const { theta, phi, radius, target } = values;
    const { orbit } = picture;
    this.#move('script', () => {
      if (key === 'theta' || key === 'phi') {
        orbit.set(key === 'theta' ? { theta } : { phi });
      } else {
        const kept = picture.fit.framing ?? orbit.pose;
        picture.fit.framing =
          key === 'radius' ? { target: kept.target, radius } : { target, radius: kept.radius };
        picture.fit.settle();
      }
    });
  }

  reset(source: CameraSource = 'script'): void {
    const { values, picture } = this.#context;
    const { theta, phi, radius, target } = values;
    this.#move(source, () => {
      picture.orbit.set({ theta, phi });
      picture.fit.framing = { target, radius };
      picture.fit.settle();
    });
  }

  /**
   * Turns the scene and plays animations to where they are at `now`. True while something keeps
   * moving.
   */
  #frame(now: number): boolean {
    const { picture, values } = this.#context;
    const plays = picture.animations.playing && this.mayMove; // in this order: a media query takes 0.2 µs
    if (plays) {
      picture.animations.step(now);
      picture.invalidate();
    } else {
      picture.animations.rest();
    }
    if (!this.turning) {
      this.#turntable.rest();
      return plays;
    }
    if (this.link?.turns(this) === false) {
      this.#turntable.rest();
    } else if (this.#turntable.step(picture.orbit, now, values.autoRotate)) {
      this.#moved('auto');
    }
    return true;
  }

  /** Whether the picture is in view. Time that passes elsewhere does not turn the scene. */
  #setInView(inView: boolean) {
    this.#inView = inView;
    if (inView) {
      this.#startMotion();
    } else {
      this.#turntable.rest();
      this.#context.picture.animations.rest();
    }
  }

  /** Whether things may move by themselves: in view, unless the user prefers reduced motion. */
  get mayMove(): boolean {
    return this.#inView && this.#reducedMotion?.matches !== true;
  }

  get turning(): boolean {
    const { autoRotate } = this.#context.values;
    return autoRotate !== 0 && this.mayMove && !this.dragging;
  }

  get dragging(): boolean {
    return this.#input?.dragging === true;
  }

  get moving(): boolean {
    return this.turning || (this.mayMove && this.#context.picture.animations.playing);
  }

  readonly #startMotion = () => {
    if (this.moving) {
      this.#context.viewport.animate();
    }
  };

  /**
   * Counts as a move if `write` changes where the camera is. A drag in progress continues from
   * there.
   */
  #move(source: CameraSource, write: () => void, linked = false) {
    const { picture } = this.#context;
    const before = picture.orbit.version;
    write();
    this.#input?.reanchor();
    if (picture.orbit.version !== before) {
      this.#changed(source, linked);
    }
    if (!linked) {
      this.link?.moved(this, source);
    }
  }

  #moved(source: CameraSource) {
    this.#changed(source, false);
    this.link?.moved(this, source);
  }

  #changed(source: CameraSource, linked: boolean) {
    this.#context.picture.invalidate();
    this.#context.signals.cameraMoved.emit({ source, linked });
  }

  #inputHost(surface: HTMLElement): OrbitInputHost {
    const { picture, values } = this.#context;
    const { orbit } = picture;
    return {
      orbit,
      size: () => pictureBox(surface),
      // The whole element, panel included.
      focusArea: (surface.getRootNode() as ShadowRoot).host,
      fov: () => picture.fit.fov,
      radiusLimits: () => zoomLimits(picture.measure()),
      allows: () => ({ orbit: values.orbit, zoom: values.zoom }),
      moved: (source) => {
        // The camera is the user's now: nothing fits it to the scene any more.
        picture.fit.framing = null;
        this.#moved(source);
      },
      reset: () => this.reset('key'),
      held: (dragging) => {
        if (!dragging) {
          this.#startMotion();
        }
      },
    };
  }
}
