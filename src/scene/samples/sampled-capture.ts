// A picture for `toBlob({ samples })`: the mean of its samples at any size, tile by tile, in batches that leave the page
// its frames. Works in hidden documents, where animation frames do not come.
import type { WebGLRenderer, WebGLRenderTarget } from 'three';
import type { Size } from '../gpu/atlas.js';
import { newTarget } from '../gpu/capture-target.js';
import { SAFE_SIDE } from '../gpu/context.js';
import { contextLost, type Region, stage } from '../gpu/stage.js';
import { Batches, sendBatch } from './batches.js';
import { copyPart } from './picture-copy.js';
import { canSum, MOST_SUMMED, pictureTarget, SampleSum } from './sample-sum.js';
import { tilesOf } from './tiles.js';

/** Milliseconds until the GPU is asked again whether it has finished a batch. */
const PAUSE = 4;

/** Times that a capture begins again because its scene has changed. The last time it is drawn in one task. */
const RESTARTS = 4;

/**
 * Draws a part of the picture into the renderer's present target. `part` need not lie on whole pixels. `samples`: so
 * many such pictures are averaged.
 */
export type PaintPart = (renderer: WebGLRenderer, part: Region, samples: number) => void;

export interface Captured {
  /** Counts the changes of its scene. */
  readonly changes: number;
  /** False: nothing keeps the context open from one task to the next. */
  readonly attached: boolean;
  /** Returns what draws samples of the scene as it is now, all of them in this task. `begin`: they are the first. */
  sampler(size: Size, begin: boolean): PaintPart;
}

/** The page's last capture. One is drawn after the other: only the first has float buffers. */
let last: Promise<unknown> = Promise.resolve();

/** Rejects with RangeError if no canvas can hold the picture, and where the context is lost. */
export function captureSamples(subject: Captured, size: Size, samples: number): Promise<HTMLCanvasElement> {
  const picture = last.then(() => draw(subject, size, samples));
  last = picture.catch(() => undefined);
  return picture;
}

async function draw(subject: Captured, size: Size, samples: number): Promise<HTMLCanvasElement> {
  for (let restarts = 0; ; restarts++) {
    const { changes } = subject;
    const atOnce = restarts === RESTARTS || !subject.attached;
    const batches = drawBatches(subject, size, samples, atOnce);
    try {
      while (atOnce || subject.changes === changes) {
        const { done, value } = batches.next();
        if (done === true) return value;
        if (!atOnce) await new Promise((resolve) => setTimeout(resolve, PAUSE));
      }
    } finally {
      batches.return(undefined as never); // frees the buffers
    }
  }
}

/** Stops after each batch, unless `atOnce`. */
function* drawBatches(
  subject: Captured,
  size: Size,
  samples: number,
  atOnce: boolean,
): Generator<void, HTMLCanvasElement> {
  const { width, height } = size;
  const target = newTarget(width, height);
  if (target === null) throw new RangeError(`a picture of ${String(width)} × ${String(height)} is too large`);
  let begin = true;
  const sampler = (): PaintPart => {
    const paint = subject.sampler(size, begin);
    begin = false;
    return paint;
  };
  for (const tile of tilesOf(size, MOST_SUMMED, SAFE_SIDE)) {
    const piece = yield* drawTile(tile, samples, sampler, atOnce);
    target.drawImage(piece, tile.x, tile.y);
  }
  return target.canvas;
}

function* drawTile(
  tile: Region,
  samples: number,
  sampler: () => PaintPart,
  atOnce: boolean,
): Generator<void, HTMLCanvasElement> {
  const plain = (): HTMLCanvasElement => {
    const paint = sampler();
    return stage.capture(tile, (renderer, { x, y, width, height }) => {
      paint(renderer, { x: tile.x + x, y: tile.y + y, width, height }, 1);
    });
  };
  let sum: SampleSum | null = null;
  let batches: Batches | null = null;
  let picture: WebGLRenderTarget | null = null;
  try {
    const renderer = stage.open(tile);
    if (!canSum(renderer)) return plain();
    sum = new SampleSum(renderer);
    if (!sum.begin(tile)) return plain();
    const [mean, sent] = [sum, (batches = new Batches(renderer.getContext() as WebGL2RenderingContext, 1))];
    while (sum.count < samples) {
      if (atOnce || batches.ended)
        aside((r) => {
          sendBatch(sent, mean, samples, tile, r, sampler());
        });
      if (!atOnce) yield;
    }
    const into = (picture = pictureTarget(tile.width, tile.height));
    aside(() => {
      mean.resolve(into, { ...tile, x: 0, y: 0 });
    });
    return stage.capture(tile, (r, part) => {
      copyPart(r, into.texture, part, tile.height);
    });
  } finally {
    batches?.cancel();
    sum?.dispose();
    picture?.dispose();
  }
}

function aside(draw: (renderer: WebGLRenderer) => void): void {
  if (!stage.drawAside(draw)) throw contextLost();
}
