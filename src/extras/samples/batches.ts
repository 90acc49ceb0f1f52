// How many samples are drawn at once: as many as the GPU finishes in 12 ms, so that input and the
// page's own frames never wait longer. The next batch follows at once: a small one ends long before
// the next frame.
import type { WebGLRenderer } from 'three';
import { centredOffset } from '../../phong/math/pixel-offsets.js';
import type { SampledViewport } from '../../viewer/extra.js';
import type { SampleSum } from './sample-sum.js';
import { type Region, type Size } from '../../phong/math/region.js';

const BATCH_MS = 12;

/**
 * Share of a batch after which the next one may be sent. The page hears of it 2 to 3 ms later: the
 * GPU never idles.
 */
const NEAR_END = 3 / 4;

/** Time from one look at the GPU to the next, and the same once the batch is late. */
const LOOK_MS = 1;
const LATE_LOOK_MS = 4;

/**
 * A sample that takes longer makes the rest minutes, in which a software renderer draws nothing
 * else of the browser: 20,000 triangles in one place take 11 s at 400 × 300 on two cores.
 */
const SLOWEST_MS = 3000;

export class Batches {
  readonly #gl: WebGL2RenderingContext;
  readonly #next: (() => void) | undefined;
  #size: number;
  #sent = 0;
  #isFirst = true;
  #fence: WebGLSync | null = null;
  #timer = 0;
  #start = 0;
  /** Milliseconds after its start at which the last batch was seen running, and seen finished. */
  #running = 0;
  #finished = Infinity;

  /**
   * `size`: samples of the first batch. `next`: a batch has nearly ended; another one may be sent.
   */
  constructor(gl: WebGL2RenderingContext, size: number, next?: () => void) {
    this.#gl = gl;
    this.#size = size;
    this.#next = next;
  }

  get size(): number {
    return this.#size;
  }

  /**
   * True once the GPU has nearly finished the last batch, whose time then decides the next size.
   * Does not wait for the GPU.
   */
  poll(): boolean {
    if (this.#fence === null) return true;
    if (!this.#signalled) return false;
    this.#finished = Math.min(this.#finished, performance.now() - this.#start);
    this.cancel();
    this.#fit();
    this.#isFirst = false;
    return true;
  }

  /** Samples of the last batch took longer than {@link SLOWEST_MS}. */
  get tooSlow(): boolean {
    return this.#running > SLOWEST_MS * this.#sent;
  }

  /**
   * Draws at most `left` samples by `draw`; fewer than {@link size} where the script alone takes
   * too long.
   */
  send(left: number, draw: () => void): void {
    this.cancel();
    const gl = this.#gl;
    const fence = () => gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    const start = (this.#start = performance.now());
    const wanted = Math.min(this.#size, left);
    let drawn = 0;
    do {
      draw();
      drawn += 1;
      if (drawn === Math.ceil(NEAR_END * wanted)) {
        this.#fence = fence();
      }
    } while (drawn < wanted && performance.now() - start < BATCH_MS);
    this.#sent = drawn;
    this.#running = 0;
    this.#finished = Infinity;
    this.#fence ??= fence();
    gl.flush();
    this.#look();
  }

  cancel(): void {
    clearTimeout(this.#timer);
    if (this.#fence !== null) {
      this.#gl.deleteSync(this.#fence);
    }
    this.#fence = null;
  }

  #look(): void {
    clearTimeout(this.#timer);
    this.#timer = window.setTimeout(
      () => {
        const elapsed = performance.now() - this.#start;
        if (this.#signalled) {
          this.#finished = elapsed;
          this.#next?.();
          return;
        }
        this.#running = elapsed;
        inNextTask(() => {
          if (this.#fence !== null) {
            this.#look();
          }
        });
      },
      performance.now() - this.#start < BATCH_MS ? LOOK_MS : LATE_LOOK_MS,
    );
  }

  /**
   * Chooses a size that takes about {@link BATCH_MS}, as far as it is known how long the last one
   * took.
   */
  #fit(): void {
    const wanted = this.#sent * BATCH_MS; // over the time that was taken
    if (this.#finished < BATCH_MS) {
      this.#size = Math.min(Math.ceil(wanted / this.#finished), 2 * this.#size);
    }
    // Not the first one, which compiles, allocates or wakes the GPU: the next may take a tenth of
    // its time.
    else if (this.#running > BATCH_MS && !this.#isFirst) {
      this.#size = Math.max(1, this.#size >> 1, Math.floor(wanted / this.#running));
    }
  }

  get #signalled(): boolean {
    const gl = this.#gl;
    return this.#fence !== null && gl.getSyncParameter(this.#fence, gl.SYNC_STATUS) === gl.SIGNALED;
  }
}

/**
 * A message instead of a timer: browsers call nested timers no sooner than after 4 ms
 * (https://html.spec.whatwg.org/multipage/timers-and-user-prompts.html). The port is closed because
 * an open one is never collected. `Slices.pause` does the same; a file for both would be a request
 * of its own.
 */
function inNextTask(work: () => void): void {
  const { port1, port2 } = new MessageChannel();
  port1.onmessage = () => {
    port1.close();
    work();
  };
  port2.postMessage(null);
}

/**
 * Adds a batch of a picture of this size to `sum`, the one of `tile`, which gets `samples` samples
 * in all; or builds finer shapes for as long as a batch, if some are missing. A batch with all of
 * them took 100 ms on a processor of a fourth of the speed.
 */
export function sendBatch(
  batches: Batches,
  sum: SampleSum,
  samples: number,
  size: Size,
  tile: Region,
  renderer: WebGLRenderer,
  picture: SampledViewport['picture'],
): void {
  // Another frame may have been drawn since.
  picture.make(size, samples, 1, performance.now() + BATCH_MS);
  if (picture.levels.isPaused) return;
  const { side } = sum;
  const wanted = Math.ceil(samples / side ** 2);
  const drawn = () => sum.count / side ** 2;
  batches.send(wanted - drawn(), () => {
    const { x, y } = centredOffset(drawn(), wanted);
    sum.add(() => picture.draw(renderer, { ...tile, x: tile.x + x / side, y: tile.y + y / side }));
  });
}
