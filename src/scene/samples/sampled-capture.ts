// A picture for `toBlob({ samples })`: the mean of its samples at any size, tile by tile, in slices that leave the page
// its frames. Works in hidden documents, where animation frames do not come.
import type { Scene, WebGLRenderer, WebGLRenderTarget } from 'three';
import type { Size } from '../gpu/atlas.js';
import { newTarget } from '../gpu/capture-target.js';
import { SAFE_SIDE } from '../gpu/context.js';
import { contextLost, type Region, stage } from '../gpu/stage.js';
import { Batches } from './batches.js';
import { ObjectPlaces } from './object-places.js';
import { copyPart } from './picture-copy.js';
import { shifted } from './pixel-offsets.js';
import { canSum, MOST_SUMMED, pictureTarget, SampleSum } from './sample-sum.js';
import { tilesOf } from './tiles.js';

/** Milliseconds until the GPU is asked again whether it has finished a batch. */
const PAUSE = 4;

/**
 * Draws a part of the picture into the renderer's present target. `part` need not lie on whole pixels. `samples`: so
 * many such pictures are averaged.
 */
export type PaintPart = (renderer: WebGLRenderer, part: Region, samples: number) => void;

export interface Captured {
  /** What {@link paint} draws. All slices show its objects where they are at the start. */
  readonly scene: Scene;
  readonly paint: PaintPart;
  /** In one slice. */
  readonly atOnce: boolean;
}

/** All of the page, in the order of their calls: only the first has float buffers. */
const queue: SampledCapture[] = [];

export class SampledCapture {
  /** Rejects with RangeError if no canvas can hold the picture, and where the context is lost. */
  readonly picture: Promise<HTMLCanvasElement>;
  readonly #slices: Iterator<void, HTMLCanvasElement>;
  #resolve: (picture: HTMLCanvasElement) => void = () => undefined;
  #reject: (reason: unknown) => void = () => undefined;
  #state: 'waiting' | 'drawing' | 'ended' = 'waiting';
  #hurried = false;

  /** Takes note of the scene in this task, and draws it after the captures before it. */
  constructor(size: Size, samples: number, { scene, paint, atOnce }: Captured) {
    const places = new ObjectPlaces(scene);
    this.#slices = this.#draw(size, samples, (renderer, part, count) => {
      places.during(() => {
        paint(renderer, part, count);
      });
    });
    this.picture = new Promise((resolve, reject) => {
      this.#resolve = resolve;
      this.#reject = reject;
    });
    queue.push(this);
    if (atOnce) this.finish();
    else void this.#run();
  }

  /** Draws all that is left now, because the scene is about to be another. */
  finish(): void {
    for (const before of queue.slice(0, queue.indexOf(this))) before.finish();
    this.#hurried = true;
    while (this.#state === 'waiting') this.#next();
  }

  async #run(): Promise<void> {
    while (this.#state !== 'ended') {
      if (queue[0] === this) this.#next();
      await new Promise((resolve) => setTimeout(resolve, PAUSE));
    }
  }

  #next(): void {
    if (this.#state !== 'waiting') return;
    this.#state = 'drawing';
    try {
      const { done, value } = this.#slices.next();
      this.#state = done === true ? 'ended' : 'waiting';
      if (done === true) this.#resolve(value);
    } catch (error) {
      this.#state = 'ended';
      this.#reject(error);
    }
    if (this.#state === 'ended') queue.splice(queue.indexOf(this), 1);
  }

  *#draw(size: Size, samples: number, paint: PaintPart): Generator<void, HTMLCanvasElement> {
    const { width, height } = size;
    const target = newTarget(width, height);
    if (target === null)
      throw new RangeError(`a picture of ${String(width)} × ${String(height)} is too large`);
    for (const tile of tilesOf(size, MOST_SUMMED, SAFE_SIDE)) {
      const piece = yield* this.#drawTile(tile, samples, paint);
      target.drawImage(piece, tile.x, tile.y);
    }
    return target.canvas;
  }

  *#drawTile(tile: Region, samples: number, paint: PaintPart): Generator<void, HTMLCanvasElement> {
    const plain = (): HTMLCanvasElement =>
      stage.capture(tile, (renderer, { x, y, width, height }) => {
        paint(renderer, { x: tile.x + x, y: tile.y + y, width, height }, 1);
      });
    let sum: SampleSum | null = null;
    let picture: WebGLRenderTarget | null = null;
    try {
      const renderer = stage.open(tile);
      if (!canSum(renderer)) return plain();
      sum = new SampleSum(renderer);
      if (!sum.begin(tile)) return plain();
      const batches = new Batches(renderer.getContext() as WebGL2RenderingContext);
      while (sum.count < samples) {
        if (this.#hurried || batches.ended) this.#drawBatch(batches, sum, samples, tile, paint);
        if (!this.#hurried) yield;
      }
      batches.cancel();
      picture = pictureTarget(tile.width, tile.height);
      const [mean, into] = [sum, picture];
      aside(() => {
        mean.resolve(into, { ...tile, x: 0, y: 0 });
      });
      return stage.capture(tile, (r, part) => {
        copyPart(r, into.texture, part, tile.height);
      });
    } finally {
      sum?.dispose();
      picture?.dispose();
    }
  }

  #drawBatch(batches: Batches, sum: SampleSum, samples: number, tile: Region, paint: PaintPart): void {
    aside((renderer) => {
      batches.send(samples - sum.count, () => {
        sum.add(() => {
          paint(renderer, shifted(tile, sum.count), samples);
        });
      });
    });
  }
}

function aside(draw: (renderer: WebGLRenderer) => void): void {
  if (!stage.drawAside(draw)) throw contextLost();
}
