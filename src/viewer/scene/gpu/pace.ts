// Fewer pixels a side while something moves and drawing takes too long, as where a processor stands
// in for a GPU. By what drawing takes, never by the device's name. A late frame is only the
// occasion to measure: the page's own work makes frames late too. A fence tells when the GPU has
// drawn, and frames wait for it meanwhile: the page's thread does not. Milliseconds.
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
  /** Share of the pixels a side that was drawn in this frame, or in the one that is measured. */
  #largest = 0;
  /** Null until something is drawn, and once the context is closed: it would keep its canvas. */
  gl: WebGL2RenderingContext | null = null;
  /**
   * Of a measurement. 1: the GPU draws what was sent before. 2: it has, and the next frame is the
   * measured one. 3: it draws that. Frames wait in 1 and 3. 0: nothing is measured.
   */
  #phase = 0;

  /** Share of the pixels a side, for a picture that moves. */
  get share(): number {
    return SHARES[this.#step]!;
  }

  /** Call before a frame draws a scene. True: not in this one, as drawing is being measured. */
  holds(): boolean {
    const isFree = this.gl !== null && this.#phase === 0 && this.#largest === 0;
    if (isFree && this.#begin(performance.now())) {
      void this.#drain();
    }
    return this.#phase % 2 > 0;
  }

  /** Call before each drawing of a scene, with its share of the pixels a side. */
  draws(renderer: WebGLRenderer, share: number): void {
    if (this.#largest === 0) {
      this.gl = renderer.getContext() as WebGL2RenderingContext;
      queueMicrotask(this.#endFrame);
    }
    this.#largest = Math.max(this.#largest, share);
  }

  readonly #endFrame = (): void => {
    if (this.#phase === 2) {
      void this.#drain();
    } else {
      this.#largest = 0;
    }
  };

  /** Once before the frame that is measured, and once after it. */
  async #drain(): Promise<void> {
    const gl = this.gl!;
    const fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    this.#phase += 1;
    const sent = performance.now();
    let time = 0; // in a busy page rather too short
    while (
      fence !== null && // the context is not lost
      gl.clientWaitSync(fence, gl.SYNC_FLUSH_COMMANDS_BIT, 0) === gl.TIMEOUT_EXPIRED
    ) {
      time = performance.now() - sent;
      await new Promise((resolve) => setTimeout(resolve));
    }
    gl.deleteSync(fence);
    this.#phase = (this.#phase + 1) % 4;
    if (this.#phase > 0) return;
    this.#end(time, performance.now());
    this.#largest = 0;
  }

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
