// Pointer, wheel and key events on a picture, turned into numbers for the pure functions of this
// folder. Each event is handled synchronously; no frame is requested and nothing is drawn. CSS
// pixels.
import { keyPose, keyStep, wheelZoom } from './drag.js';
import { type GestureHost, PointerGesture } from './gesture.js';
import { keepDrag, SLOP } from './kept-drag.js';
import type { Pose } from './orbit.js';
import { writtenPose } from './written-pose.js';

export interface OrbitInputHost extends GestureHost {
  /** The user moved the camera. Called synchronously for each event that changed it. */
  moved(source: 'pointer' | 'wheel' | 'key'): void;
  /** Home was pressed: the host returns to the declared camera and reports that itself. */
  reset(): void;
  /** The wheel zooms while this element or anything in it has the focus. Default: the surface. */
  readonly focusArea?: Element;
  /** A drag began or ended. A turntable pauses meanwhile. */
  held?(dragging: boolean): void;
}

/** Buttons of pointer events, as `button` has them. */
const PRIMARY = 0;
const SECONDARY = 2;

/**
 * Milliseconds after a secondary drag in which its context menu is suppressed: Windows opens it at
 * the release.
 */
const MENU_DELAY = 300;

/**
 * CSS pixels that a finger can move mainly up or down before the camera turns, so that scrolling
 * past does not tilt the picture. Within its own slop (15 px in Chromium 156) the browser may still
 * make the stroke a scroll and cancel the pointer.
 */
const SCROLL_SLOP = 32;

/**
 * Connects a surface to an orbit. The surface holds the picture and nothing else that needs
 * pointers (the panel is its sibling). It must be focusable, with `touch-action: pan-y` and
 * `user-select: none` in its CSS.
 */
export class OrbitInput {
  readonly #surface: HTMLElement;
  readonly #host: OrbitInputHost;
  readonly #gesture: PointerGesture;
  #listeners: AbortController | undefined;
  #button = PRIMARY;
  #touching = false;
  /** Where a finger pressed, until it is clear whether it scrolls the page or drags. */
  #undecided: { readonly x: number; readonly y: number } | undefined;
  #menuUntil = -1;
  /** The menu of the drag in progress has been suppressed: none follows its release. */
  #menuCame = false;
  /** Where the drag began, and whether a pointer has moved away from there since. */
  #start = { x: 0, y: 0, left: false };
  #release: ((moved: boolean) => void) | undefined;

  constructor(surface: HTMLElement, host: OrbitInputHost) {
    this.#surface = surface;
    this.#host = host;
    this.#gesture = new PointerGesture(host);
  }

  get dragging(): boolean {
    return this.#gesture.active;
  }

  /** Starts listening. A second call does nothing. */
  connect(): void {
    if (this.#listeners !== undefined) return;
    this.#listeners = new AbortController();
    const { signal } = this.#listeners;
    const surface = this.#surface;
    const active = { signal, passive: false };
    for (const type of Object.keys(this.#handlers)) {
      // Respect preventDefault() of the page's scripts, but always track where the pointers are.
      const claimable = /down|wheel/.test(type);
      const listener = (event: Event) => {
        if (!claimable || !event.defaultPrevented) {
          this.take(event);
        }
      };
      surface.addEventListener(type, listener, active);
    }
    // A drag must not select text: that would cancel the pointer.
    surface.addEventListener('selectstart', (event) => this.dragging && event.preventDefault(), {
      signal,
    });
    for (const type of ['touchstart', 'touchmove'] as const) {
      surface.addEventListener(type, (event) => this.#onTouch(event), active);
    }
    const view = surface.ownerDocument.defaultView;
    view?.addEventListener('blur', () => this.#end(), { signal });
    // On the window, because a drag can end outside the surface.
    view?.addEventListener('contextmenu', (event) => this.#onMenu(event), { signal });
  }

  /** Handles a pointer, wheel or keyboard event that arrived before {@link connect} was called. */
  take(event: Event): void {
    this.#handlers[event.type]?.(event);
  }

  /** Releases listeners and captured pointers and ends a drag. `connect` can follow. */
  disconnect(): void {
    this.#listeners?.abort('detached');
    this.#listeners = undefined;
    this.#end();
  }

  /**
   * Call when something else has changed the camera or the picture: a drag in progress continues
   * from the current camera.
   */
  reanchor(): void {
    if (this.#gesture.active) {
      this.#gesture.reanchor();
    }
  }

  readonly #handlers: Readonly<Record<string, (event: Event) => void>> = {
    pointerdown: (event) => this.#onPress(event as PointerEvent),
    pointermove: (event) => this.#onMove(event as PointerEvent),
    pointerup: (event) => this.#onLift(event as PointerEvent),
    pointercancel: (event) => this.#onLift(event as PointerEvent),
    lostpointercapture: (event) => this.#onLift(event as PointerEvent),
    wheel: (event) => this.#onWheel(event as WheelEvent),
    keydown: (event) => this.#onKey(event as KeyboardEvent),
  };

  #onPress(event: PointerEvent) {
    const { orbit, zoom } = this.#host.allows();
    const touch = event.pointerType === 'touch';
    if ((!orbit && !zoom) || (event.button !== PRIMARY && event.button !== SECONDARY)) return;
    this.#surface.focus({ preventScroll: true });
    this.#menuUntil = -1;
    // A pointer that presses again was released without an event.
    if (this.#gesture.has(event.pointerId)) {
      this.#lift(event.pointerId);
    }
    // Only a second finger joins a drag; a mouse does not join a pen. With `orbit` off, one finger
    // waits for a pinch.
    const begins = !this.#gesture.active;
    const isAllowed = touch ? begins || this.#touching : begins && orbit;
    if (!isAllowed) return;
    const kind = event.button === SECONDARY || event.shiftKey ? 'shift' : 'turn';
    if (!this.#gesture.press(event.pointerId, event.clientX, event.clientY, kind)) return;
    this.#button = event.button;
    this.#menuCame = false;
    this.#touching = touch;
    this.#undecided = touch && begins ? { x: event.clientX, y: event.clientY } : undefined;
    try {
      this.#surface.setPointerCapture(event.pointerId);
    } catch {
      // The pointer is gone already or was made by a script: drag without capture.
    }
    if (!begins) return;
    this.#start = { x: event.clientX, y: event.clientY, left: false };
    this.#release = keepDrag(this.#surface.ownerDocument.defaultView);
    this.#host.held?.(true);
  }

  #onMove(event: PointerEvent) {
    if (!this.#gesture.has(event.pointerId)) return;
    // The button was released without an event (over another window, under a menu, while another
    // button is down).
    const mask = this.#button === SECONDARY ? 2 : 1;
    if ((event.buttons & mask) === 0) {
      this.#lift(event.pointerId);
      return;
    }
    if (this.#leavesToPage(event)) return;
    const slop = this.#touching ? SLOP.touch : SLOP.mouse;
    this.#start.left ||=
      Math.hypot(event.clientX - this.#start.x, event.clientY - this.#start.y) > slop;
    if (this.#gesture.move(event.pointerId, event.clientX, event.clientY)) {
      this.#host.moved('pointer');
    }
  }

  /**
   * Leaves the first pixels of a vertical touch to the page, which may scroll. True while it does;
   * from the first move beyond these on the touch drags.
   */
  #leavesToPage(event: PointerEvent): boolean {
    if (this.#undecided === undefined) return false;
    const across = Math.abs(event.clientX - this.#undecided.x);
    const along = Math.abs(event.clientY - this.#undecided.y);
    if (along > across && along < SCROLL_SLOP) return true;
    this.#undecided = undefined;
    return false;
  }

  #onLift(event: PointerEvent) {
    if (!this.#gesture.has(event.pointerId)) return;
    this.#lift(event.pointerId);
    if (this.#button === SECONDARY && this.#gesture.dragged && !this.#menuCame) {
      this.#menuUntil = event.timeStamp + MENU_DELAY;
    }
  }

  /**
   * Suppresses the context menu while the secondary button drags and once after a drag. Linux and
   * macOS open it at the press, when it is not yet known whether a drag follows: it is suppressed
   * there too.
   */
  #onMenu(event: MouseEvent) {
    const wanted =
      !(this.#gesture.active && this.#button === SECONDARY) &&
      !(event.timeStamp <= this.#menuUntil);
    this.#menuUntil = -1;
    if (!wanted) {
      this.#menuCame = true;
      event.preventDefault();
    }
    // An open menu captures the mouse. Touch is different: a long press fires `contextmenu` even if
    // no menu opens.
    else if (!this.#touching) {
      this.#end();
    }
  }

  /** Two fingers move the camera: `touch-action: pan-y` alone would let them scroll the page. */
  #onTouch(event: TouchEvent) {
    if (event.cancelable && event.targetTouches.length > 1 && this.#gesture.active) {
      event.preventDefault();
    }
  }

  #onWheel(event: WheelEvent) {
    // Horizontal scrolling is left to the page.
    if (event.deltaY === 0 || !this.#host.allows().zoom || !this.#focused()) return;
    event.preventDefault();
    const { orbit } = this.#host;
    this.#moveTo(
      wheelZoom(orbit.pose, event, this.#host.size().height, this.#host.radiusLimits()),
      'wheel',
    );
  }

  #onKey(event: KeyboardEvent) {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    const step = keyStep(event.key, event.shiftKey);
    const { orbit, zoom } = this.#host.allows();
    if (step === undefined) return;
    if (!{ turn: orbit, zoom, reset: orbit || zoom }[step.kind]) return;
    event.preventDefault();
    event.stopPropagation(); // slides would turn to the next page
    if (step.kind === 'reset') {
      this.#host.reset();
      this.reanchor();
    } else {
      this.#moveTo(keyPose(this.#host.orbit.pose, step, this.#host.radiusLimits()), 'key');
    }
  }

  #moveTo(pose: Pose, source: 'wheel' | 'key') {
    const { orbit } = this.#host;
    const before = orbit.version;
    orbit.set(writtenPose(pose));
    if (orbit.version === before) return;
    this.reanchor();
    this.#host.moved(source);
  }

  #focused(): boolean {
    const area = this.#host.focusArea ?? this.#surface;
    // Asks the area's own tree, where an element with the focus in its shadow tree is the active
    // one.
    const { activeElement } = area.getRootNode() as Document | ShadowRoot;
    return area.contains(activeElement);
  }

  #lift(pointerId: number) {
    this.#gesture.lift(pointerId);
    if (this.#surface.hasPointerCapture(pointerId)) {
      this.#surface.releasePointerCapture(pointerId);
    }
    if (this.#gesture.active) return;
    this.#release?.(this.#gesture.dragged && this.#start.left);
    this.#host.held?.(false);
  }

  #end() {
    for (const id of this.#gesture.pointers) {
      this.#lift(id);
    }
  }
}
