// Decides when pictures are drawn. At most one animation frame is pending for each window, and none
// while nothing changes. A frame has three phases, and every picture finishes one before any
// picture starts the next. Then text follows the pictures.

/** A picture that takes part in frames. */
interface FrameUser {
  /** It has another size since it was drawn. */
  readonly resized: boolean;
  /** First phase: reads the page's layout. */
  prepare(): void;
  /** Second phase: moves what moves by itself. True requests another frame. `now` in ms. */
  advance(now: number): boolean;
  /** Third phase. */
  draw(): void;
}

type Act = () => unknown;

/** Milliseconds of a frame for texts; the others wait for their next one. */
const TEXTS = 0.5;

export class FrameLoop {
  readonly #source: Window;
  #waiting = new Set<FrameUser>();
  /** The pictures of the running frame; empty between frames. */
  #running = new Set<FrameUser>();
  #pending = 0;
  readonly #texts = new Set<Act>();
  readonly #explanations = new Set<Act>();
  /** In the last frame. */
  #wroteTexts = false;

  constructor(source: Window) {
    this.#source = source;
  }

  /** Requests a frame for `viewport`. Any number of requests in one task make one frame. */
  request(viewport: FrameUser): void {
    this.#waiting.add(viewport);
    this.#ask();
  }

  /** See {@link afterPictures}. */
  follow(act: Act, alone: boolean): void {
    (alone ? this.#explanations : this.#texts).add(act);
    this.#ask();
  }

  #ask(): void {
    if (this.#pending === 0 && this.#isWanted) {
      this.#pending = this.#source.requestAnimationFrame(this.#run);
    }
  }

  cancel(viewport: FrameUser): void {
    this.#waiting.delete(viewport);
    if (this.#isWanted) return;
    this.#source.cancelAnimationFrame(this.#pending);
    this.#pending = 0;
  }

  readonly #run = (now: number): void => {
    this.#pending = 0;
    [this.#waiting, this.#running] = [this.#running, this.#waiting];
    this.#each('prepare');
    this.#each('advance', now);
    this.#each('draw');
    this.#running.clear();
    this.#write();
  };

  get #isWanted(): boolean {
    return this.#waiting.size + this.#texts.size + this.#explanations.size > 0;
  }

  /**
   * Nobody reads digits that change 60 times a second, and laying them out takes longer than
   * drawing: texts are written in every other frame, and one explanation between them.
   */
  #write(): void {
    this.#wroteTexts = !this.#wroteTexts && this.#texts.size > 0;
    const acts = this.#wroteTexts ? this.#texts : this.#explanations;
    const end = performance.now() + TEXTS;
    try {
      for (const act of [...acts]) {
        acts.delete(act);
        act();
        if (!this.#wroteTexts || performance.now() >= end) break;
      }
    } finally {
      this.#ask(); // one that throws must not stop the others
    }
  }

  /**
   * Draws the waiting pictures of another size between layout and paint: later they would be
   * stretched in a frame.
   */
  drawResized(): void {
    for (const viewport of this.#waiting) {
      if (!viewport.resized) continue;
      this.cancel(viewport);
      this.#running.add(viewport);
    }
    this.#each('draw');
    this.#running.clear();
  }

  /** One broken picture must not stop the others of the page. */
  #each(phase: 'prepare' | 'advance' | 'draw', now = 0): void {
    for (const viewport of this.#running) {
      try {
        if (viewport[phase](now) === true) {
          this.request(viewport);
        }
      } catch (error) {
        reportError(error);
      }
    }
  }
}

const loops = new WeakMap<Window, FrameLoop>();

/**
 * The frame loop of the window that shows a picture: another one may be hidden, minimised or
 * closed.
 */
export function frameLoopOf(source: Window): FrameLoop {
  const loop = loops.get(source) ?? new FrameLoop(source);
  loops.set(source, loop);
  return loop;
}

/**
 * Runs `act` once after the pictures of one of the next frames, however often it was asked.
 * `alone`: where no others run.
 */
export function afterPictures(
  { ownerDocument: { defaultView } }: Element,
  act: Act,
  alone = false,
): void {
  if (defaultView !== null) {
    frameLoopOf(defaultView).follow(act, alone);
  }
}
