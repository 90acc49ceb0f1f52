// What do the pointers that hold the picture do to the camera? The noted pose, where each finger started, where it is now.
// Everything follows from those, so that back at the start is exactly the start. Client coordinates in CSS pixels. Knows no
// events; the caller says which pointers press, move and lift.

import { pinch, shift, turn } from './drag.js';
import type { RadiusLimits, View } from './drag.js';
import type { Orbit, Pose } from './orbit.js';

/** What the grip asks its surroundings, live at every move. */
export interface GripHost {
  readonly orbit: Orbit;
  /** Size of the picture, CSS pixels. */
  size(): { readonly width: number; readonly height: number };
  /** Vertical field of view, degrees. */
  fov(): number;
  radiusLimits(): RadiusLimits;
  /** `orbit` lets one pointer turn and shift, and two fingers shift; `zoom` lets two fingers pinch. */
  allows(): { readonly orbit: boolean; readonly zoom: boolean };
}

/** What one pointer does while it travels; two fingers always shift and pinch. */
export type Hold = 'turn' | 'shift';

interface Finger {
  readonly id: number;
  startX: number;
  startY: number;
  x: number;
  y: number;
}

interface Note {
  readonly pose: Pose;
  readonly view: View;
  readonly orbit: boolean;
  readonly zoom: boolean;
  /** The orbit's version that this grip knows of; another one means that someone else moved the camera. */
  version: number;
}

export class PointerGesture {
  readonly #host: GripHost;
  #fingers: readonly Finger[] = [];
  #hold: Hold = 'turn';
  #note: Note | undefined;
  #dragged = false;

  constructor(host: GripHost) {
    this.#host = host;
  }

  get pointers(): readonly number[] {
    return this.#fingers.map((finger) => finger.id);
  }

  get held(): boolean {
    return this.#fingers.length > 0;
  }

  /** Whether the camera has moved since the first pointer pressed. */
  get dragged(): boolean {
    return this.#dragged;
  }

  holds(id: number): boolean {
    return this.#fingers.some((finger) => finger.id === id);
  }

  /** A pointer presses. Gives false, and takes no note of it, beyond two or where it has no place. */
  press(id: number, x: number, y: number, hold: Hold): boolean {
    if (this.#fingers.length >= 2 || this.holds(id) || !Number.isFinite(x + y)) return false;
    if (!this.held) this.#dragged = false;
    this.#hold = this.held ? 'turn' : hold; // whichever finger is lifted first, the other turns
    this.#fingers = [...this.#fingers, { id, startX: x, startY: y, x, y }];
    this.renote();
    return true;
  }

  /** A pointer is now there. Gives true where that moved the camera. */
  move(id: number, x: number, y: number): boolean {
    const finger = this.#fingers.find((f) => f.id === id);
    if (finger === undefined || !Number.isFinite(x + y)) return false;
    let note = this.#note;
    if (note === undefined || this.#outdated(note)) note = this.#noteAnew();
    finger.x = x;
    finger.y = y;
    const { orbit } = this.#host;
    orbit.set(this.#pose(note));
    const moved = orbit.version !== note.version;
    note.version = orbit.version;
    this.#dragged ||= moved;
    return moved;
  }

  /** A pointer lets go; one that is left goes on from here. */
  lift(id: number): void {
    if (!this.holds(id)) return;
    this.#fingers = this.#fingers.filter((finger) => finger.id !== id);
    if (this.held) this.renote();
  }

  drop(): void {
    this.#fingers = [];
  }

  /** Notes the camera and the places of all fingers anew: the drag goes on from what is shown now. */
  renote(): void {
    this.#noteAnew();
  }

  #noteAnew(): Note {
    for (const finger of this.#fingers) {
      finger.startX = finger.x;
      finger.startY = finger.y;
    }
    const { orbit } = this.#host;
    const { width, height } = this.#host.size();
    const view = { width, height, fov: this.#host.fov() };
    this.#note = { pose: orbit.pose, view, ...this.#host.allows(), version: orbit.version };
    return this.#note;
  }

  /** The same travel would mean something else than when it was noted. */
  #outdated({ view, orbit, zoom, version }: Note): boolean {
    const { width, height } = this.#host.size();
    const allows = this.#host.allows();
    const sameView = view.width === width && view.height === height && view.fov === this.#host.fov();
    return (
      !sameView || allows.orbit !== orbit || allows.zoom !== zoom || this.#host.orbit.version !== version
    );
  }

  #pose({ pose, view, orbit, zoom }: Note): Pose {
    const [first, second] = this.#fingers;
    if (first === undefined) return pose;
    const dx = first.x - first.startX;
    const dy = first.y - first.startY;
    if (second === undefined) {
      if (!orbit) return pose;
      return this.#hold === 'turn' ? turn(pose, dx, dy, view) : shift(pose, dx, dy, view);
    }
    const startGap = Math.hypot(second.startX - first.startX, second.startY - first.startY);
    const gap = Math.hypot(second.x - first.x, second.y - first.y);
    const pinched = zoom ? pinch(pose, startGap, gap, this.#host.radiusLimits()) : pose;
    if (!orbit) return pinched;
    // At the pinched radius: what was the target goes as far over the picture as the fingers' middle.
    return shift(pinched, (dx + second.x - second.startX) / 2, (dy + second.y - second.startY) / 2, view);
  }
}
