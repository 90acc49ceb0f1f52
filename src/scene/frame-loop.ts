// When does a picture draw? One animation frame at most is pending for the whole page, and none while nothing has
// asked for one. Knows nothing of what is drawn.

export interface Framed {
  /** Reads what it needs of the page's layout. All pictures read before the first one draws and so writes to it. */
  prepare(): void;
  /** Draws if there is something to draw; true asks for another frame. `now` in milliseconds, as animation frames. */
  frame(now: number): boolean;
}

class FrameLoop {
  readonly #waiting = new Set<Framed>();
  #pending = 0;
  /** Asked last, and is still to be drawn: lights that move ask one by one. */
  #last: Framed | null = null;

  /** Asks for a frame for `picture`: any number of requests in one task make one frame. */
  request(picture: Framed): void {
    if (picture === this.#last) return;
    this.#last = picture;
    this.#waiting.add(picture);
    if (this.#pending === 0) this.#pending = requestAnimationFrame(this.#run);
  }

  /** Takes a request back; with the last one goes the animation frame. */
  cancel(picture: Framed): void {
    this.#waiting.delete(picture);
    if (picture === this.#last) this.#last = null;
    if (this.#waiting.size > 0 || this.#pending === 0) return;
    cancelAnimationFrame(this.#pending);
    this.#pending = 0;
  }

  readonly #run = (now: number): void => {
    this.#pending = 0;
    this.#last = null;
    const pictures = [...this.#waiting];
    this.#waiting.clear();
    for (const picture of pictures) {
      guarded(() => {
        picture.prepare();
      });
    }
    for (const picture of pictures) {
      guarded(() => {
        if (picture.frame(now)) this.request(picture);
      });
    }
  };
}

/** One broken picture must not stop the others of the page. */
function guarded(action: () => void): void {
  try {
    action();
  } catch (error) {
    reportError(error);
  }
}

/** The page's frame loop. */
export const frameLoop = new FrameLoop();
