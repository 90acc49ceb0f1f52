// Camera poses of a gesture with one or two pointers, from the pose at the anchor and where each
// finger was then and is now: returning to the start restores the start pose exactly. Client
// coordinates in CSS pixels; travel is measured along the picture's own axes.
import { type PictureFrame, pinch, type RadiusLimits, shift, turn } from './drag.js';
import { type Orbit, type Pose, samePose } from './orbit.js';
import { writtenPose } from './written-pose.js';

/** The picture's box, and the directions of its axes on the page. */
export interface PictureBox {
  /** Before transforms, CSS pixels. */
  readonly width: number;
  readonly height: number;
  /**
   * Client coordinates of one of the box's own pixels: x and y of a pixel to the right, x and y of
   * a pixel down. CSS transforms of the box or its parents change them. Default: 1, 0, 0, 1.
   */
  readonly axes?: PictureAxes;
}

export type PictureAxes = readonly [rightX: number, rightY: number, downX: number, downY: number];

const UPRIGHT: PictureAxes = [1, 0, 0, 1];

/**
 * Browsers place transformed boxes in float32: scrolling changes axes by about 1e-7 per pixel of
 * their size.
 */
const AXIS_NOISE = 1e-5;

/** What a gesture reads from its surroundings, at every move. */
export interface GestureHost {
  readonly orbit: Orbit;
  /** The picture's box. */
  size(): PictureBox;
  /** Vertical field of view, degrees. */
  fov(): number;
  radiusLimits(): RadiusLimits;
  /**
   * `orbit`: one pointer can turn and shift, two fingers can shift. `zoom`: two fingers can pinch.
   */
  allows(): { readonly orbit: boolean; readonly zoom: boolean };
}

/** What a single pointer does while it moves. Two fingers always shift and pinch. */
type DragKind = 'turn' | 'shift';

interface Finger {
  readonly id: number;
  /** Where it was at the anchor. */
  anchorX: number;
  anchorY: number;
  x: number;
  y: number;
}

/** The state that travel is measured from. */
interface Anchor {
  readonly pose: Pose;
  readonly view: PictureFrame;
  readonly axes: PictureAxes;
  readonly orbit: boolean;
  readonly zoom: boolean;
  /**
   * The orbit's after this gesture's last move: a different version means that something else moved
   * the camera.
   */
  version: number;
}

export class PointerGesture {
  readonly #host: GestureHost;
  #fingers: readonly Finger[] = [];
  #kind: DragKind = 'turn';
  #anchor: Anchor | undefined;
  #dragged = false;

  constructor(host: GestureHost) {
    this.#host = host;
  }

  get pointers(): readonly number[] {
    return this.#fingers.map((finger) => finger.id);
  }

  /** Whether any pointer is down. */
  get active(): boolean {
    return this.#fingers.length > 0;
  }

  /** Whether the camera has moved since the first pointer pressed. */
  get dragged(): boolean {
    return this.#dragged;
  }

  has(id: number): boolean {
    return this.#fingers.some((finger) => finger.id === id);
  }

  /**
   * A pointer presses. Returns false and ignores it if two are down already or a coordinate is not
   * finite.
   */
  press(id: number, x: number, y: number, kind: DragKind): boolean {
    if (this.#fingers.length >= 2 || this.has(id) || !Number.isFinite(x + y)) return false;
    if (!this.active) {
      this.#dragged = false;
    }
    this.#kind = this.active ? 'turn' : kind; // whichever finger lifts first, the other one turns
    this.#fingers = [...this.#fingers, { id, anchorX: x, anchorY: y, x, y }];
    this.reanchor();
    return true;
  }

  /** A pointer has moved. Returns whether that moved the camera. */
  move(id: number, x: number, y: number): boolean {
    const finger = this.#fingers.find((f) => f.id === id);
    if (finger === undefined || !Number.isFinite(x + y)) return false;
    let anchor = this.#anchor;
    if (anchor === undefined || this.#outdated(anchor)) {
      anchor = this.reanchor();
    }
    finger.x = x;
    finger.y = y;
    const { orbit } = this.#host;
    const pose = this.#pose(anchor);
    // The picture that stays is the one that markup gives; back at its start a drag has moved
    // nothing.
    orbit.set(samePose(pose, anchor.pose) ? pose : writtenPose(pose));
    const moved = orbit.version !== anchor.version;
    anchor.version = orbit.version;
    this.#dragged ||= moved;
    return moved;
  }

  /** A finger that stays down continues from here. */
  lift(id: number): void {
    if (!this.has(id)) return;
    this.#fingers = this.#fingers.filter((finger) => finger.id !== id);
    if (this.active) {
      this.reanchor();
    }
  }

  /** Sets a new anchor: the drag continues from the current camera and pointer positions. */
  reanchor(): Anchor {
    for (const finger of this.#fingers) {
      finger.anchorX = finger.x;
      finger.anchorY = finger.y;
    }
    const { orbit } = this.#host;
    const { width, height, axes = UPRIGHT } = this.#host.size();
    const view = { width, height, fov: this.#host.fov() };
    this.#anchor = { pose: orbit.pose, view, axes, ...this.#host.allows(), version: orbit.version };
    return this.#anchor;
  }

  /** Whether the same travel would now mean something else than at the anchor. */
  #outdated({ view, axes: before, orbit, zoom, version }: Anchor): boolean {
    const { width, height, axes = UPRIGHT } = this.#host.size();
    const allows = this.#host.allows();
    const sameView =
      view.width === width && view.height === height && view.fov === this.#host.fov();
    const sameAxes = axes.every((x, i) => Math.abs(x - before[i]!) < AXIS_NOISE);
    const sameRights = allows.orbit === orbit && allows.zoom === zoom;
    return !sameView || !sameAxes || !sameRights || this.#host.orbit.version !== version;
  }

  #pose({ pose, view, axes, orbit, zoom }: Anchor): Pose {
    const [first, second] = this.#fingers;
    if (first === undefined) return pose;
    const dx = first.x - first.anchorX;
    const dy = first.y - first.anchorY;
    if (second === undefined) {
      if (!orbit) return pose;
      const travel = alongAxes(axes, dx, dy);
      return this.#kind === 'turn' ? turn(pose, ...travel, view) : shift(pose, ...travel, view);
    }
    const startGap = Math.hypot(second.anchorX - first.anchorX, second.anchorY - first.anchorY);
    const gap = Math.hypot(second.x - first.x, second.y - first.y);
    const pinched = zoom ? pinch(pose, startGap, gap, this.#host.radiusLimits()) : pose;
    if (!orbit) return pinched;
    // Shift at the pinched radius: the target follows the midpoint of the fingers.
    const middleX = (dx + second.x - second.anchorX) / 2;
    const middleY = (dy + second.y - second.anchorY) / 2;
    return shift(pinched, ...alongAxes(axes, middleX, middleY), view);
  }
}

/**
 * A pointer's travel in pixels of the picture. None where the picture is seen edge-on: nothing can
 * be pressed there.
 */
export function alongAxes(
  [rightX, rightY, downX, downY]: PictureAxes = UPRIGHT,
  x: number,
  y: number,
): [number, number] {
  const area = rightX * downY - rightY * downX;
  return area === 0 ? [0, 0] : [(x * downY - y * downX) / area, (y * rightX - x * rightY) / area];
}

/**
 * Pixels of the page, as of pointer events, for each CSS pixel of an element: CSS zoom. Not all
 * browsers say it.
 */
export const zoomOf = (element: Element): number =>
  (element as { currentCSSZoom?: number }).currentCSSZoom ?? 1;
