// Decides when pictures are drawn. At most one animation frame is pending for each window, and none while nothing
// changes. A frame has three phases, and every picture finishes one before any picture starts the next.
import type { Viewport } from './viewport.js';

export class FrameLoop {
  readonly #source: Window;
  #waiting = new Set<Viewport>();
  /** The pictures of the running frame; empty between frames. */
  #running = new Set<Viewport>();
  #pending = 0;

  constructor(source: Window) {
    this.#source = source;
  }

  /** Requests a frame for `picture`. Any number of requests in one task make one frame. */
  request(picture: Viewport): void {
    this.#waiting.add(picture);
    if (this.#pending === 0) this.#pending = this.#source.requestAnimationFrame(this.#run);
  }

  cancel(picture: Viewport): void {
    this.#waiting.delete(picture);
    if (this.#waiting.size > 0 || this.#pending === 0) return;
    this.#source.cancelAnimationFrame(this.#pending);
    this.#pending = 0;
  }

  readonly #run = (now: number): void => {
    this.#pending = 0;
    [this.#waiting, this.#running] = [this.#running, this.#waiting];
    this.#each((picture) => picture.prepare());
    this.#each((picture) => {
      if (picture.advance(now)) this.request(picture);
    });
    this.#each((picture) => picture.draw());
    this.#running.clear();
  };

  /** Draws the waiting pictures of another size between layout and paint: later they would be stretched in a frame. */
  drawResized(): void {
    for (const picture of this.#waiting) {
      if (!picture.resized) continue;
      this.cancel(picture);
      this.#running.add(picture);
    }
    this.#each((picture) => picture.draw());
    this.#running.clear();
  }

  /** One broken picture must not stop the others of the page. */
  #each(action: (picture: Viewport) => void): void {
    for (const picture of this.#running) {
      try {
        action(picture);
      } catch (error) {
        reportError(error);
      }
    }
  }
}

const loops = new WeakMap<Window, FrameLoop>();

/** The frame loop of the window that shows a picture: another one may be hidden, minimised or closed. */
export function frameLoopOf(source: Window): FrameLoop {
  const loop = loops.get(source) ?? new FrameLoop(source);
  loops.set(source, loop);
  return loop;
}
