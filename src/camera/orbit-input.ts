// What do pointers, wheel and keys on a picture do to its camera? The only file of this folder that knows the DOM: it turns
// events into the numbers of the laws, and tells the host what moved. Each event is worked off at once, by arithmetic alone; it
// asks for no frame and draws nothing. CSS pixels. Must not know what the picture shows.

import { PointerGesture } from './gesture.js';
import type { GripHost } from './gesture.js';
import type { Pose } from './orbit.js';
import { keyPose, keyStep, wheelZoom } from './step.js';

export interface OrbitInputHost extends GripHost {
  /** The camera was moved by a hand; called at each event that changed it, before the event returns. */
  moved(source: 'pointer' | 'wheel' | 'key'): void;
  /** Home was pressed: back to the declared camera. What that reports is the host's. */
  reset(): void;
  /** A drag began or ended: the moment for a turntable to rest or to go on. */
  held?(dragging: boolean): void;
}

const PRIMARY = 0;
const SECONDARY = 2;

/** How long after a secondary drag the menu of its release may still come, ms: Windows opens it at the release. */
const MENU_DELAY = 300;

/**
 * How far a finger may go mainly up or down before it turns anything, CSS pixels. The browser takes such a stroke for scrolling
 * within its own slop (15 in Chromium) and cancels the pointer: scrolling past must not tilt the picture.
 */
const SCROLL_SLOP = 32;

/**
 * Connects a surface to an orbit. The surface holds the picture and nothing that wants pointers of its own (a panel lies
 * beside it); it is focusable, its CSS says `touch-action: pan-y` and `user-select: none`.
 */
export class OrbitInput {
  readonly #surface: HTMLElement;
  readonly #host: OrbitInputHost;
  readonly #grip: PointerGesture;
  #listeners: AbortController | undefined;
  #button = PRIMARY;
  #touching = false;
  /** Where a finger pressed that may yet scroll the page. */
  #undecided: { readonly x: number; readonly y: number } | undefined;
  #menuUntil = -1;

  constructor(surface: HTMLElement, host: OrbitInputHost) {
    this.#surface = surface;
    this.#host = host;
    this.#grip = new PointerGesture(host);
  }

  get dragging(): boolean {
    return this.#grip.held;
  }

  /** Starts listening. Nothing happens where it listens already. */
  connect(): void {
    if (this.#listeners !== undefined) return;
    this.#listeners = new AbortController();
    const { signal } = this.#listeners;
    const surface = this.#surface;
    const active = { signal, passive: false };
    for (const type of Object.keys(this.#handlers)) {
      // What a script has dealt with does nothing here; moves and lifts say where a pointer is all the same.
      const claimable = /down|wheel/.test(type);
      surface.addEventListener(
        type,
        (event) => {
          if (!claimable || !event.defaultPrevented) this.take(event);
        },
        active,
      );
    }
    // A drag must neither select the page's text nor carry a selection away: the latter would cancel the pointer.
    for (const type of ['selectstart', 'dragstart'] as const) {
      surface.addEventListener(type, (event) => this.#keepWhileHeld(event), { signal });
    }
    surface.addEventListener('touchstart', (event) => this.#onTouch(event), active);
    surface.addEventListener('touchmove', (event) => this.#onTouch(event), active);
    const view = surface.ownerDocument.defaultView;
    view?.addEventListener('blur', () => this.#end(), { signal });
    // On the window, because a drag may be let go outside the surface.
    view?.addEventListener('contextmenu', (event) => this.#onMenu(event), { signal });
  }

  /** Works off a pointer event, a turn of the wheel or a key that came before {@link connect} did. */
  take(event: Event): void {
    this.#handlers[event.type]?.(event);
  }

  /** Gives everything back: listeners, captured pointers, a drag in progress. `connect` may follow. */
  disconnect(): void {
    this.#listeners?.abort();
    this.#listeners = undefined;
    this.#end();
  }

  /** The camera or the picture was changed by something else: a drag in progress goes on from what is shown now. */
  renote(): void {
    if (this.#grip.held) this.#grip.renote();
  }

  readonly #lifted = (event: Event): void => {
    this.#onLift(event as PointerEvent);
  };

  readonly #handlers: Readonly<Record<string, (event: Event) => void>> = {
    pointerdown: (event) => {
      this.#onPress(event as PointerEvent);
    },
    pointermove: (event) => {
      this.#onMove(event as PointerEvent);
    },
    pointerup: this.#lifted,
    pointercancel: this.#lifted,
    lostpointercapture: this.#lifted,
    wheel: (event) => {
      this.#onWheel(event as WheelEvent);
    },
    keydown: (event) => {
      this.#onKey(event as KeyboardEvent);
    },
  };

  #onPress(event: PointerEvent): void {
    const { orbit, zoom } = this.#host.allows();
    const touch = event.pointerType === 'touch';
    if (!orbit && !zoom) return;
    if (event.button !== PRIMARY && event.button !== SECONDARY) return;
    this.#surface.focus({ preventScroll: true });
    this.#menuUntil = -1;
    // A pointer that presses again was let go unseen.
    if (this.#grip.holds(event.pointerId)) this.#lift(event.pointerId);
    // Only fingers join: a mouse beside a pen would be a second hand on the same drag. Without `orbit` they wait for a pinch.
    if (touch ? this.#grip.held && !this.#touching : this.#grip.held || !orbit) return;
    const begins = !this.#grip.held;
    const hold = event.button === SECONDARY || event.shiftKey ? 'shift' : 'turn';
    if (!this.#grip.press(event.pointerId, event.clientX, event.clientY, hold)) return;
    this.#button = event.button;
    this.#touching = touch;
    this.#undecided = touch && begins ? { x: event.clientX, y: event.clientY } : undefined;
    this.#capture(event.pointerId);
    if (begins) this.#host.held?.(true);
  }

  #onMove(event: PointerEvent): void {
    if (!this.#grip.holds(event.pointerId)) return;
    // Its button was let go where no event told of it (over another window, under a menu, beside another button).
    const mask = this.#button === SECONDARY ? 2 : 1;
    if ((event.buttons & mask) === 0) this.#lift(event.pointerId);
    else if (this.#mayScroll(event)) return;
    else if (this.#grip.move(event.pointerId, event.clientX, event.clientY)) this.#host.moved('pointer');
  }

  #mayScroll(event: PointerEvent): boolean {
    if (this.#undecided === undefined) return false;
    const across = Math.abs(event.clientX - this.#undecided.x);
    const along = Math.abs(event.clientY - this.#undecided.y);
    if (along > across && along < SCROLL_SLOP) return true;
    this.#undecided = undefined;
    return false;
  }

  #onLift(event: PointerEvent): void {
    if (!this.#grip.holds(event.pointerId)) return;
    this.#lift(event.pointerId);
    if (this.#button === SECONDARY && this.#grip.dragged) this.#menuUntil = event.timeStamp + MENU_DELAY;
  }

  /**
   * The menu stays away while the secondary button drags, and once after it has dragged. Where the system opens it at the
   * press already, as on Linux and macOS, nobody knows yet whether a drag follows: it stays away there too.
   */
  #onMenu(event: MouseEvent): void {
    const wanted = !(this.#grip.held && this.#button === SECONDARY) && !(event.timeStamp <= this.#menuUntil);
    this.#menuUntil = -1;
    if (!wanted) event.preventDefault();
    // A menu that opens takes the pointer. Not a finger: a long press tells of a menu where none may open.
    else if (!this.#touching) this.#end();
  }

  /** Two fingers are the camera's: `touch-action: pan-y` alone would let them scroll the page. */
  #onTouch(event: TouchEvent): void {
    if (event.cancelable && event.targetTouches.length > 1 && this.#grip.held) event.preventDefault();
  }

  #keepWhileHeld(event: Event): void {
    if (this.#grip.held) event.preventDefault();
  }

  #onWheel(event: WheelEvent): void {
    // A trackpad's pinch arrives as a wheel with Ctrl: it zooms as well. A sideways turn stays the page's.
    if (event.deltaY === 0) return;
    if (!this.#host.allows().zoom || !this.#focused()) return;
    event.preventDefault();
    const { orbit } = this.#host;
    this.#moveTo(wheelZoom(orbit.pose, event, this.#host.size().height, this.#host.radiusLimits()), 'wheel');
  }

  #onKey(event: KeyboardEvent): void {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    const step = keyStep(event.key, event.shiftKey);
    const { orbit, zoom } = this.#host.allows();
    if (step === undefined || !(step.kind === 'turn' ? orbit : step.kind === 'zoom' ? zoom : orbit || zoom))
      return;
    event.preventDefault();
    if (step.kind === 'reset') {
      this.#host.reset();
      this.renote();
    } else {
      this.#moveTo(keyPose(this.#host.orbit.pose, step, this.#host.radiusLimits()), 'key');
    }
  }

  #moveTo(pose: Pose, source: 'wheel' | 'key'): void {
    const { orbit } = this.#host;
    const before = orbit.version;
    orbit.set(pose);
    if (orbit.version === before) return;
    this.renote();
    this.#host.moved(source);
  }

  #focused(): boolean {
    const surface = this.#surface;
    if (surface.matches(':focus')) return true;
    const root = surface.getRootNode() as Document | ShadowRoot;
    return surface.contains(root.activeElement);
  }

  #capture(pointerId: number): void {
    try {
      this.#surface.setPointerCapture(pointerId);
    } catch {
      // A pointer that is gone already, or one made by a script: it drags without capture.
    }
  }

  #lift(pointerId: number): void {
    this.#grip.lift(pointerId);
    if (this.#surface.hasPointerCapture(pointerId)) this.#surface.releasePointerCapture(pointerId);
    if (!this.#grip.held) this.#host.held?.(false);
  }

  #end(): void {
    for (const id of this.#grip.pointers) this.#lift(id);
  }
}
