// Fewer pixels a side while something moves and drawing takes too long, as where a processor stands
// in for a GPU. By what drawing takes, never by the device's name. A late frame is only the
// occasion to measure: the page's own work makes frames late too. Milliseconds.
import type { WebGLRenderer } from 'three';

/** Shares of the pixels a side. */
const SHARES = [1, 2 / 3, 1 / 2, 1 / 3] as const;

/** Milliseconds after the frame before it from which a frame is late. */
const LATE = 50;
/**
 * Drawing that takes less is not why a frame is late. Less than {@link LATE}: the browser has to
 * show the picture as well, which takes about half as long again (software).
 */
const SLOW = 33;
/** What drawing may take with fewer pixels. */
const WANTED = 20;
/**
 * Milliseconds: the share is raised if no frame of them would have been late with the larger one.
 */
const BEFORE_RAISING = 500;
/** Frames farther apart are no motion. */
const FAR = 10_000;
/** Milliseconds that drawing counts as quick after it was measured as quick. */
const TRUSTED = 2000;
/**
 * If fewer pixels leave drawing more than this share of its time, vertices are the cause, and all
 * pixels come back. Round shapes have fewer vertices by then.
 */
const VAIN = 0.9;
/**
 * Milliseconds until fewer pixels are tried again: a try costs sharpness. In software a triangle
 * takes 1.5 µs, whatever its pixels.
 */
const VAIN_FOR = 10_000;

class Pace {
  #step = 0;
  #begun = -Infinity;
  /** In a row, since the last measurement. */
  #frames = 0;
  /** Frames since the share was lowered, or looked at. */
  #since = { time: 0, frames: 0 };
  #quickUntil = 0;
  /** What drawing took before the share was lowered; 0 once that has helped. */
  #before = 0;
  #inFrame = false;
  /** What draws the present frame, if its drawing is measured. */
  #measured: WebGLRenderer | null = null;
  #largest = 0;

  /** Share of the pixels a side, for a picture that moves. */
  get share(): number {
    return SHARES[this.#step]!;
  }

  /** Call before each drawing of a scene, with its share of the pixels a side. */
  draws(renderer: WebGLRenderer, share: number): void {
    this.#largest = Math.max(this.#largest, share);
    if (this.#inFrame) return;
    this.#inFrame = true;
    if (this.#begin(performance.now())) {
      this.#measured = renderer;
      waitFor(renderer);
    }
    queueMicrotask(this.#endFrame);
  }

  readonly #endFrame = (): void => {
    this.#inFrame = false;
    if (this.#measured !== null) {
      const sent = performance.now();
      waitFor(this.#measured);
      this.#measured = null;
      this.#end(performance.now() - sent, sent);
    }
    this.#largest = 0;
  };

  /** True: its drawing is to be measured. */
  #begin(now: number): boolean {
    const interval = now - this.#begun;
    this.#begun = now;
    this.#frames = interval < FAR ? this.#frames + 1 : 0;
    this.#since.frames += 1;
    const passed = now - this.#since.time;
    if (passed > BEFORE_RAISING) {
      const growth = (SHARES[this.#step - 1] ?? Infinity) / this.share;
      if ((passed / this.#since.frames) * growth ** 2 < LATE) {
        this.#step -= 1;
      }
      this.#since = { time: now, frames: 0 };
    }
    const isLate = interval > LATE && now > this.#quickUntil;
    return isLate && this.#frames > 1 && (this.#before > 0 || this.#step < SHARES.length - 1);
  }

  #end(time: number, now: number): void {
    const before = this.#before;
    this.#frames = this.#before = 0;
    if (time < SLOW) {
      this.#quickUntil = now + TRUSTED;
    } else if (this.#largest < 1 && time > VAIN * before && before > 0) {
      this.#step = 0;
      this.#quickUntil = now + VAIN_FOR;
    } else {
      const whole = time / this.#largest ** 2; // with all pixels
      const fitting = SHARES.findIndex((share) => whole * share ** 2 <= WANTED);
      const step = Math.max(this.#step, fitting < 0 ? SHARES.length - 1 : fitting);
      this.#before = step > this.#step ? time : 0;
      this.#step = step;
      this.#since = { time: now, frames: 0 };
    }
  }
}

/** The page's: its pictures share one context. */
export const pace = new Pace();

/** Until it has drawn all that was sent: reading a pixel needs it. */
function waitFor(renderer: WebGLRenderer): void {
  const gl = renderer.getContext();
  gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
}

/** Made once: where memory is short, a measurement must not fail a frame. */
const pixel = new Uint8Array(4);
