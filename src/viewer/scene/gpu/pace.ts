// Fewer pixels a side while something moves and drawing takes too long, as where a processor stands
// in for a GPU. By what drawing takes, never by the device's name. Fences tell how late the GPU is:
// the browser queues up to 1.5 s of drawing while frames come in time. Frames wait while drawing is
// measured. The page's thread waits only where it is busy too long to watch a fence. Milliseconds.
import type { WebGLRenderer } from 'three';

/** Shares of the pixels a side. */
const SHARES = [1, 2 / 3, 1 / 2, 1 / 3] as const;

/** Drawing is measured once a frame or the GPU is so late: more than two frames at 60 a second. */
const LATE = 40;
/** After such a rest of the page's thread a frame is no motion. */
const FAR = 2000;
/**
 * Drawing that takes less is quick enough. Less than 50: the browser has to show the picture as
 * well, which takes about half as long again (software).
 */
const SLOW = 33;
/** What drawing may take with fewer pixels. */
const WANTED = 20;
/** The share is raised after so long with frames that close together: 56 for 1.5² times the pixels. */
const BEFORE_RAISING = 500;
const CLOSE = 25;
/** Milliseconds without a measurement after one that has changed nothing. */
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

/** Made once: where memory is short, a measurement must not fail a frame. */
const pixel = new Uint8Array(4);

class Pace {
  #step = 0;
  #begun = 0;
  /** When the page's thread was free after the last frame: the browser may wait for seconds. */
  #free = 0;
  /** From when on frames have been close together. */
  #since = 0;
  #trustedUntil = 0;
  /** What drawing took before the share was lowered; 0 once that has helped. */
  #before = 0;
  #isDrawing = false;
  /** Largest share of the pixels a side that the last frame has drawn. */
  #drawn = 0;
  #gl: WebGL2RenderingContext | null = null;
  /** What was drawn before it was {@link #sent}, once the GPU passes it. */
  #fence: WebGLSync | null = null;
  #sent = 0;
  /** Frames that were drawn since, or since the GPU had nothing to draw. */
  #behind = 0;
  /** Frames wait until the GPU has drawn what was sent. */
  #waits = false;
  /** This frame's drawing is measured. */
  #measures = false;
  /**
   * The page's thread was busy while the last measurement waited, so it says nothing, and the next
   * one keeps the thread. Without GPU compositing browsers do so themselves after each picture.
   */
  #keepsThread = false;

  /** Share of the pixels a side, for a picture that moves. */
  get share(): number {
    return SHARES[this.#step]!;
  }

  /** Call before a frame draws a scene. True: not in this one, as drawing is being measured. */
  holds(): boolean {
    if (this.#waits || this.#isDrawing) return this.#waits;
    const now = performance.now();
    const interval = now - this.#begun;
    this.#begun = now;
    if (interval > CLOSE || this.#step === 0) {
      this.#since = now;
    } else if (now - this.#since > BEFORE_RAISING) {
      this.#step -= 1;
      this.#since = this.#trustedUntil = now;
    }
    if (now < this.#trustedUntil) return false;
    this.#measures = this.#passed() && interval > LATE && now - this.#free < FAR;
    if (this.#measures && this.#keepsThread) {
      this.#wait(); // what was drawn before does not count
    }
    if (this.#fence !== null && now - this.#sent > LATE) {
      void this.#measure();
    }
    return this.#waits;
  }

  /** Call before each drawing of a scene, with its share of the pixels a side. */
  draws(renderer: WebGLRenderer, share: number): void {
    if (!this.#isDrawing) {
      this.#isDrawing = true;
      this.#drawn = 0;
      this.#gl = renderer.getContext() as WebGL2RenderingContext;
      queueMicrotask(this.#endFrame);
    }
    this.#drawn = Math.max(this.#drawn, share);
  }

  /** The context is lost or closed: its fences are gone, and it would keep its canvas. */
  forget(): void {
    this.#gl = this.#fence = null;
  }

  readonly #endFrame = () => {
    this.#isDrawing = false;
    setTimeout(() => (this.#free = performance.now()));
    const measures = this.#measures;
    this.#measures = false;
    if (measures && this.#keepsThread) {
      this.#keepsThread = false;
      this.#end(this.#wait());
    } else if (measures) {
      this.#behind += 1;
      void this.#measure();
    } else if (this.#fence !== null) {
      this.#behind += 1;
    } else if (performance.now() > Math.max(this.#sent + LATE, this.#trustedUntil)) {
      this.#mark(); // not in each frame: a fence takes 0.3 ms of the page's thread (software)
    }
  };

  /**
   * What the GPU takes until it has nothing left to draw. Reading a pixel makes the page's thread
   * wait for it.
   */
  #wait(): number {
    const gl = this.#gl; // null after a loss
    const begun = performance.now();
    gl?.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
    return performance.now() - begun;
  }

  #mark() {
    const gl = this.#gl;
    this.#fence = gl && gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    gl?.flush(); // nothing else may follow for seconds
    this.#sent = performance.now();
  }

  /** The GPU has passed the fence, or there is none. */
  #passed(): boolean {
    const gl = this.#gl!;
    const fence = this.#fence;
    if (fence === null) return true;
    if (gl.clientWaitSync(fence, 0, 0) === gl.TIMEOUT_EXPIRED) return false;
    gl.deleteSync(fence);
    this.#fence = null;
    this.#behind = 0;
    return true;
  }

  /** What the GPU takes to pass the fence, as long as the page's thread was not busy. */
  async #drain(): Promise<number> {
    let time = 0;
    while (!this.#passed()) {
      time = performance.now() - this.#sent;
      await new Promise((resolve) => setTimeout(resolve));
    }
    return time;
  }

  /** By the frames behind the fence, where there is one: before it may be uploads and programs. */
  async #measure(): Promise<void> {
    const frames = this.#behind;
    this.#waits = true;
    if (this.#fence !== null) {
      await this.#drain();
    }
    if (frames > 0) {
      this.#mark();
      const time = await this.#drain();
      this.#keepsThread = performance.now() - this.#sent - time > LATE;
      if (!this.#keepsThread) {
        this.#end(time / frames);
      }
    }
    this.#waits = false;
  }

  #end(time: number) {
    const isVain = this.#drawn < 1 && this.#before > 0 && time > VAIN * this.#before;
    let trusted = isVain ? VAIN_FOR : TRUSTED;
    this.#before = 0;
    if (isVain) {
      this.#step = 0;
    } else if (time > SLOW) {
      while ((this.share / this.#drawn) ** 2 * time > WANTED && this.#step < SHARES.length - 1) {
        this.#step += 1;
        this.#before = time;
        trusted = 0;
      }
    }
    this.#trustedUntil = performance.now() + trusted;
  }
}

/** The page's: its pictures share one context. */
export const pace = new Pace();
