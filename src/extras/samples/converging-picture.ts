// The picture of one viewport while nothing changes: its samples are drawn batch by batch, and
// their mean replaces the plain picture, until all are there. And pictures for `toBlob({ samples
// })`. Fetched with the first use of either.
import type { WebGLRenderer, WebGLRenderTarget } from 'three';
import { type SampledViewport, stage } from '../../viewer/extra.js';
import { Batches, sendBatch } from './batches.js';
import { MOST_SUMMED, pictureTarget, SampleSum } from './sample-sum.js';
import { copyPart, fromBelow } from './screen-pass.js';
import { queue, release, seize, sharedSum, take } from './turns.js';
import { type Region, type Size, SAFE_SIDE, tilesOf } from '../../phong/math/region.js';

/**
 * Animation frames without a change before the first sample of a drag: a slow drag has frames in
 * which nothing moves.
 */
const STILL_FRAMES = 3;

/** A change belongs to no drag after all samples, or this long after the last standstill began. */
const LONE_MS = 200;

/** Samples of the first mean that is shown. Multisampling has smoother edges than fewer. */
const FIRST_SHOWN = 16;

/** Samples that are sent to the GPU before its end is waited for, when all are drawn at once. */
const WAITS_AFTER = 8;

/**
 * A mean is shown again once its samples have multiplied by this: each time costs a copy to the
 * page.
 */
const SHOWN_AGAIN = 4;

export class ConvergingPicture {
  readonly #viewport: SampledViewport;
  readonly #wanted: number;
  /** Samples of the picture that is shown; 0: the plain one. */
  #samples = 0;
  #picture: WebGLRenderTarget | null = null;
  #stillFrames = 0;
  /** When the last standstill began, and whether changes have followed it as those of a drag do. */
  #stood = -Infinity;
  #dragged = false;
  /** Samples of the first batch: as many as the last run of this size ended with. */
  #pace = 1;
  #run: Run | null = null;
  /** Not possible on this GPU, or not with this scene, or too slow. */
  #failed = false;

  constructor(viewport: SampledViewport, wanted: number) {
    this.#viewport = viewport;
    this.#wanted = wanted;
  }

  get samples(): number {
    return this.#samples;
  }

  /** More samples are to come, as long as nothing changes. */
  get pending(): boolean {
    return !this.#failed && this.#samples < this.#wanted;
  }

  get converged(): boolean {
    return this.#samples >= this.#wanted;
  }

  /** Call in an animation frame without a change. True: call again in the next one. */
  step(): boolean {
    if (!this.pending) return false;
    if (this.#stillFrames === 0) {
      this.#stood = performance.now();
      queue(this);
    }
    this.#stillFrames += 1;
    // Pictures in view come first.
    if (this.#stillFrames <= (this.#dragged ? STILL_FRAMES : Number(!this.inView))) return true;
    if (!take(this)) return false; // its turn comes with an animation frame
    const before = this.#samples;
    this.#aside(this.#draw);
    if (this.#samples > before) {
      this.#viewport.show(this.converged);
    }
    return this.#run !== null;
  }

  /**
   * While it is pending: draws what is missing now, without turns and frames, up to a time of
   * `performance.now()`.
   */
  finish(deadline: number): void {
    seize(this);
    const before = this.#samples;
    while (this.pending && performance.now() < deadline && this.#aside(this.#drawNow)) {}
    this.pause();
    if (this.#samples > before) {
      this.#viewport.show(this.converged);
    }
  }

  reset(): void {
    if (this.#stillFrames > 0) {
      this.#dragged = !this.converged && performance.now() - this.#stood < LONE_MS;
    }
    this.#stillFrames = 0;
    this.#samples = 0;
    this.#failed = false;
    this.pause();
  }

  /** Stops for as long as nobody can see the picture. What is shown stays. */
  pause(): void {
    this.#run?.batches.cancel();
    this.#run = null;
    release(this);
  }

  /** Now: scrolling changes it. */
  get inView(): boolean {
    return this.#viewport.visible;
  }

  /** A turn is free: {@link step} takes it, or {@link pause} gives it up. */
  wake(): void {
    this.#viewport.animate();
  }

  dispose(): void {
    this.reset();
    this.#picture?.dispose();
    this.#picture = null;
  }

  /**
   * Fills the renderer's present viewport with the kept picture, or with the part of it that `part`
   * is.
   */
  copy(renderer: WebGLRenderer, part?: Region): void {
    const { width, height } = this.#viewport;
    copyPart(renderer, this.#picture!.texture, part ?? { x: 0, y: 0, width, height }, height);
  }

  /** Between two animation frames: draws the next batch. The next frame shows it. */
  readonly #goOn = (): void => {
    if (this.#run!.sum.count < this.#wanted) {
      this.#aside(this.#drawMore);
    }
  };

  /** False: there is no context, and the samples drawn so far are forgotten. */
  #aside(draw: (renderer: WebGLRenderer) => void): boolean {
    try {
      const drawn = stage.drawAside(draw);
      if (!drawn) {
        this.pause();
      }
      return drawn;
    } catch (error) {
      this.#fail();
      throw error;
    }
  }

  readonly #draw = (renderer: WebGLRenderer): void => {
    const run = this.#run ?? this.#begin(renderer);
    if (run !== null) {
      this.#advance(renderer, run, true);
    }
  };

  readonly #drawMore = (renderer: WebGLRenderer): void =>
    this.#advance(renderer, this.#run!, false);

  readonly #drawNow = (renderer: WebGLRenderer): void => {
    const run = this.#run ?? this.#begin(renderer);
    if (run === null) return;
    // The deadline is the GPU's too: reading a pixel waits for it.
    if (run.sum.count % WAITS_AFTER === 0) {
      run.sum.wait();
    }
    run.batches.cancel();
    this.#advance(renderer, run, true);
  };

  /** Null where the GPU has no float targets, or no memory for them. */
  #begin(renderer: WebGLRenderer): Run | null {
    const { width, height } = this.#viewport;
    if (this.#picture?.width !== width || this.#picture.height !== height) {
      this.#picture?.dispose();
      this.#picture = pictureTarget(width, height);
      this.#pace = 1;
    }
    const tiles = tilesOf({ width, height }, MOST_SUMMED, SAFE_SIDE);
    const sum = sharedSum(renderer);
    if (!sum.begin(tiles[0]!, this.#viewport.picture.samplesASide)) {
      this.#fail();
      return null;
    }
    const batches = new Batches(
      renderer.getContext() as WebGL2RenderingContext,
      this.#pace,
      this.#goOn,
    );
    return (this.#run = { batches, sum, tiles, tile: 0, nextShown: FIRST_SHOWN });
  }

  /**
   * Draws a batch if the last one has ended, and ends what is complete. `shown`: the page can show
   * the mean now.
   */
  #advance(renderer: WebGLRenderer, run: Run, shown: boolean): void {
    const { batches, sum, tiles } = run;
    const tile = tiles[run.tile]!;
    if (sum.count < this.#wanted && batches.poll()) {
      if (batches.tooSlow) {
        this.#fail();
        return;
      }
      sendBatch(batches, sum, this.#wanted, this.#viewport, tile, renderer, this.#viewport.picture);
    }
    const complete = sum.count >= this.#wanted;
    const isLast = complete && run.tile === tiles.length - 1;
    const shows = shown && (isLast || (tiles.length === 1 && sum.count >= run.nextShown));
    if (shows || (complete && !isLast)) {
      sum.resolve(this.#picture!, fromBelow(tile, this.#viewport.height));
    }
    if (complete && !isLast) {
      run.tile += 1;
      if (!sum.begin(tiles[run.tile]!, sum.side)) {
        this.#fail();
      }
    }
    if (!shows) return;
    run.nextShown = sum.count * SHOWN_AGAIN;
    this.#samples = Math.max(this.#samples, sum.count);
    if (!isLast) return;
    this.#pace = batches.size;
    this.pause();
  }

  #fail(): void {
    this.#failed = true;
    this.pause();
  }
}

/**
 * The samples of one standstill: of tile number `tile` now. From `nextShown` on the mean is shown
 * again.
 */
interface Run {
  readonly batches: Batches;
  readonly sum: SampleSum;
  readonly tiles: readonly Region[];
  tile: number;
  nextShown: number;
}

/** Milliseconds until the GPU is asked again whether it has finished a batch. */
const PAUSE = 4;

/**
 * Times that a capture begins again because its scene has changed. The last time it is drawn in one
 * task.
 */
const RESTARTS = 4;

/** The page's last capture. One is drawn after the other: only the first has float buffers. */
let last: Promise<unknown> = Promise.resolve();

/**
 * The mean of the samples at any size, tile by tile, in batches; also without animation frames, as
 * in hidden documents. Rejects with RangeError if no canvas can hold it, and without a context.
 */
export function captureSamples(
  viewport: SampledViewport,
  size: Size,
  samples: number,
): Promise<HTMLCanvasElement> {
  const picture = last.then(() => draw(viewport, size, samples));
  last = picture.then(nothing, nothing); // not the picture: this promise stays
  return picture;
}

const nothing = (): void => undefined;

async function draw(
  viewport: SampledViewport,
  size: Size,
  samples: number,
): Promise<HTMLCanvasElement> {
  for (let restarts = 0; ; restarts++) {
    const { version } = viewport.picture;
    // Nothing keeps the context of a detached viewer open from one task to the next.
    const atOnce = restarts === RESTARTS || !viewport.attached;
    const batches = drawBatches(viewport.picture, size, samples, atOnce);
    viewport.releaseUnlessAttached();
    try {
      while (atOnce || viewport.picture.version === version) {
        const { done, value } = batches.next();
        if (done === true) return value ?? viewport.capture(size);
        if (!atOnce) {
          await new Promise((resolve) => setTimeout(resolve, PAUSE));
        }
      }
    } finally {
      batches.return(undefined as never); // frees the buffers
    }
  }
}

/**
 * Stops after each batch, unless `atOnce`. Null where the GPU has no float targets, or no memory
 * for them, or no context: then the plain picture cannot be drawn either.
 */
function* drawBatches(
  picture: SampledViewport['picture'],
  size: Size,
  samples: number,
  atOnce: boolean,
): Generator<void, HTMLCanvasElement | null> {
  const target = stage.newTarget(size);
  picture.updateMatrices();
  for (const tile of tilesOf(size, MOST_SUMMED, SAFE_SIDE)) {
    const renderer = stage.open(tile);
    const batches = new Batches(renderer.getContext() as WebGL2RenderingContext, 1);
    const sum = new SampleSum(renderer);
    const mean = pictureTarget(tile.width, tile.height);
    try {
      if (!sum.begin(tile, picture.samplesASide)) return null;
      while (sum.count < samples) {
        if (atOnce || batches.poll()) {
          if (!stage.drawAside((r) => sendBatch(batches, sum, samples, size, tile, r, picture))) {
            return null;
          }
        }
        if (!atOnce) {
          yield;
        }
      }
      if (!stage.drawAside(() => sum.resolve(mean, { ...tile, x: 0, y: 0 }))) return null;
      const piece = stage.capture(tile, (r, part) => copyPart(r, mean.texture, part, tile.height));
      target.drawImage(piece, tile.x, tile.y);
    } finally {
      batches.cancel();
      sum.dispose();
      mean.dispose();
    }
  }
  return target.canvas;
}
