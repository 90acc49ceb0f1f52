// The probe: the point that a viewer explains, under the mouse or the cross-hair, or pinned in the
// scene. The camera takes the same events. Explains at most once a frame, and never while nothing
// changes.
import {
  afterPictures,
  type Extra,
  type ExtraHost,
  phrase,
  type PictureOptions,
  type ViewerTexts,
} from '../../../viewer/extra.js';
import { SLOP } from '../../../phong/camera/kept-drag.js';
import { sameValue } from '../../../phong/fields/field-store.js';
import type { Vec3 } from '../../../phong/math/vector.js';
import { ARROWS, inside, type Point, reportProbe } from '../drawing/projection.js';
import { ProbeView, type ProbedPoint } from './probe-view.js';
import { HIDDEN, NO_SURFACE, OUTSIDE } from './sum.js';

/**
 * Another surface hides a pinned point if it is nearer to the eye by more than the width of this
 * many pixels there. Nearer by less, it is the same surface at the centre of the pixel, at most
 * 0.71 pixels away: it can lean by 80 degrees.
 */
const IN_FRONT = 4;

/** CSS pixels per press of an arrow key, and with Shift. */
const STEP = { fine: 1, coarse: 10 } as const;

export const create = (host: ExtraHost): Extra => new Probe(host);

class Probe implements Extra {
  readonly #host: ExtraHost;
  readonly #view: ProbeView;
  readonly #listening = new AbortController();
  /** `probe-at` at the last update. */
  #declared: Vec3 | null;
  /** Where the mouse or the cross-hair is, if the user has pinned nothing. */
  #free: Point | null = null;
  /** The fragment here gets pinned with its explanation. */
  #toPin: Point | null = null;
  /**
   * The user has pointed or pressed something since the last explanation. Only such explanations
   * are announced.
   */
  #acted = false;
  #busy = false;
  #again = false;

  constructor(host: ExtraHost) {
    this.#host = host;
    this.#declared = host.values.probeAt;
    this.#view = new ProbeView(host, () => this.#release());
    this.#listenToPointer();
    this.#listenToKeys();
    this.#view.show(null, false);
  }

  update(): void {
    const { probeAt } = this.#host.values;
    if (!sameValue(probeAt, this.#declared)) {
      // As with the camera, an assignment replaces what the user did.
      this.#declared = probeAt;
      this.#host.pin = this.#free = null;
    }
    this.#explain();
  }

  /** Explains the point again, because the picture may have changed. */
  async drawOver(picture: HTMLCanvasElement, { helpers }: PictureOptions): Promise<void> {
    if (helpers !== true) return;
    const draw = this.#view.drawerOf(picture);
    const fragment = (await this.#chosen())?.fragment ?? null;
    if (fragment !== null) {
      draw(fragment);
    }
  }

  dispose(): void {
    this.#listening.abort('disposed');
    // Like the camera, the pin stays with a viewer that leaves the page.
    if (!this.#host.values.probe) {
      this.#host.pin = null;
    }
    this.#view.dispose();
  }

  #on<K extends keyof HTMLElementEventMap>(
    target: HTMLElement,
    type: K,
    listener: (event: HTMLElementEventMap[K]) => void,
  ): void {
    target.addEventListener(type, listener, { signal: this.#listening.signal });
  }

  #listenToPointer(): void {
    const { surface } = this.#host.tree;
    let pressed: Point = { x: 0, y: 0 };
    let steady = false;
    const placeOf = ({ offsetX, offsetY }: MouseEvent) => ({
      x: offsetX / this.#zoom,
      y: offsetY / this.#zoom,
    });

    this.#on(surface, 'pointerdown', ({ clientX, clientY, isPrimary }) => {
      pressed = { x: clientX, y: clientY };
      steady = isPrimary; // a second finger pinches
    });
    this.#on(surface, 'pointermove', (event) => {
      const { clientX, clientY, buttons, pointerType } = event;
      if (buttons === 0) {
        if (pointerType !== 'touch') {
          this.#moveTo(placeOf(event));
        }
        return;
      }
      const slop = pointerType === 'touch' ? SLOP.touch : SLOP.mouse;
      steady &&= Math.hypot(clientX - pressed.x, clientY - pressed.y) <= slop;
      if (!steady) {
        this.#moveTo(null);
      }
    });
    this.#on(surface, 'pointerleave', () => this.#moveTo(null));
    this.#on(surface, 'click', (event) => {
      if (steady) {
        this.#pinAt(placeOf(event));
      }
      steady = false;
    });
  }

  #listenToKeys(): void {
    const { surface } = this.#host.tree;
    const { cursor, root, place } = this.#view;
    const boxes = [root, place];
    this.#on(cursor, 'focus', () => {
      if (this.#host.pin !== null || this.#declared !== null) return;
      this.#free ??= this.#view.middle;
      this.#follow();
    });
    for (const box of boxes) {
      this.#on(box, 'focusout', ({ relatedTarget }) => {
        if (!boxes.some((each) => each.contains(relatedTarget as Node | null))) {
          this.#moveTo(null);
        }
      });
    }
    this.#on(cursor, 'keydown', (event) => {
      if (event.ctrlKey || event.altKey || event.metaKey) return;
      const arrow = ARROWS[event.key];
      const pixels = event.shiftKey ? STEP.coarse : STEP.fine;
      if (arrow !== undefined) {
        this.#step(arrow[0] * pixels, arrow[1] * pixels);
      } else if (event.key !== 'Enter') {
        return;
      } else if (this.#free !== null) {
        this.#pinAt(this.#free);
      }
      event.preventDefault();
    });
    // Escape that removes a pin must do nothing else, such as closing a dialog around the viewer.
    for (const target of [surface, ...boxes]) {
      this.#on(target, 'keydown', (event) => {
        if (event.key === 'Escape' && this.#release()) {
          event.preventDefault();
        }
      });
    }
  }

  /**
   * `at`: where the mouse is; null once it has left, or drags, or neither cross-hair nor table has
   * the focus any more.
   */
  #moveTo(at: Point | null): void {
    if (this.#host.pin !== null || (at === null && this.#free === null)) return;
    // The cross-hair stays where it is while it has the focus.
    if (at === null && this.#view.hasFocus) return;
    this.#free = at;
    afterPictures(this.#host.viewer, this.#follow, true);
  }

  #pinAt(at: Point): void {
    this.#toPin = at;
    this.#follow();
  }

  /** Removes the pin. False if there is none. */
  #release(): boolean {
    if (this.#host.pin === null) return false;
    this.#host.pin = null;
    this.#free =
      this.#view.hasFocus && this.#declared === null ? (this.#view.shown?.at ?? null) : null;
    this.#follow();
    return true;
  }

  /** Moves the cross-hair. */
  #step(across: number, down: number): void {
    const { x, y } = this.#free ?? this.#view.shown?.at ?? this.#view.middle;
    this.#host.pin = null;
    // Half a pixel inside: there is nothing to explain on the far edges.
    this.#free = inside({ x: x + across, y: y + down }, this.#view.size, 0.5);
    this.#follow();
  }

  /** Pixels of pointer events, and so of shadeAt, for each pixel of the layer. */
  get #zoom(): number {
    return this.#host.size().zoom;
  }

  /** The user chose another point. */
  readonly #follow = () => {
    this.#acted = true;
    this.#explain();
  };

  #explain(): void {
    this.#again = this.#busy;
    if (this.#busy || this.#listening.signal.aborted) return;
    this.#busy = true;
    void this.#explained().then((shown) => {
      if (this.#listening.signal.aborted) return;
      const before = this.#view.shown;
      this.#view.show(shown, this.#host.pin !== null);
      if (this.#acted) {
        this.#view.announce();
      }
      this.#acted = false;
      if (shown !== before) {
        const { fragment = null, at = null, pinned = false } = shown ?? {};
        reportProbe(this.#host, fragment, at, pinned);
      }
      // Not at once: a listener may have changed the viewer, which would never end. By the frames
      // of the window that shows the viewer: the opener of a popup may be hidden.
      this.#host.viewer.ownerDocument.defaultView?.requestAnimationFrame(() => {
        this.#busy = false;
        if (this.#again) {
          this.#explain();
        }
      });
    });
  }

  /** The place that was pressed, else {@link #chosen}. */
  async #explained(): Promise<ProbedPoint | null> {
    // Before the first picture there is nothing to explain.
    if (this.#host.viewport.frames === 0) return null;
    const toPin = this.#toPin;
    if (toPin !== null) {
      const shown = await this.#at(toPin);
      if (this.#listening.signal.aborted) return null;
      if (this.#toPin === toPin) {
        this.#toPin = null;
      }
      this.#host.pin = shown.fragment?.p ?? null;
      // A press beside the shape takes the pin away.
      this.#free = this.#host.pin === null && this.#view.hasFocus ? toPin : null;
      if (this.#host.pin !== null) return { ...shown, pinned: true };
    }
    return this.#chosen();
  }

  /** The user's pin, else the place of mouse or cross-hair, else the declared point. */
  async #chosen(): Promise<ProbedPoint | null> {
    if (this.#host.pin === null && this.#free !== null) {
      const shown = await this.#at(this.#free);
      if (shown.fragment !== null || shown.message !== '') return shown;
      if (this.#view.hasFocus) {
        return { ...shown, message: phrase(this.#host.viewer.texts, NO_SURFACE) };
      }
    }
    const point = this.#host.pin ?? this.#declared;
    return point === null ? null : this.#ofPoint(point);
  }

  /** The fragment at this place; the message is that of an error. */
  async #at(at: Point): Promise<ProbedPoint> {
    const shown = { at, fragment: null, message: '', pinned: false };
    try {
      return {
        ...shown,
        fragment: await this.#host.viewer.shadeAt(at.x * this.#zoom, at.y * this.#zoom),
      };
    } catch (error) {
      return { ...shown, message: (error as Error).message };
    }
  }

  /** The fragment at the pixel of a point of the scene; null while the scene is not there yet. */
  async #ofPoint(point: Vec3): Promise<ProbedPoint | null> {
    const { viewer, viewport } = this.#host;
    // As shadeAt does: an `auto` camera may not have followed the scene yet.
    viewport.picture.settle();
    const { projection } = this.#view;
    const at = projection.pointInside(point);
    const without = (text: keyof ViewerTexts): ProbedPoint => ({
      at,
      fragment: null,
      pinned: true,
      message: phrase(viewer.texts, text),
    });
    if (at === null) return without(OUTSIDE);
    const shown = { ...(await this.#at(at)), pinned: true };
    const { fragment, message } = shown;
    if (fragment === null) {
      if (message !== '') return shown;
      return viewer.loaded ? without(NO_SURFACE) : null;
    }
    const depth = projection.depthOf(point);
    if (projection.depthOf(fragment.p) < depth - IN_FRONT / projection.pixelsPerUnit(depth)) {
      return without(HIDDEN);
    }
    return shown;
  }
}
