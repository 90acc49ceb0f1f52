// A picture for `toBlob({ samples })`: the mean of its samples at any size, tile by tile, in batches that leave the
// page its frames. Works in hidden documents, where animation frames do not come.
import type { WebGLRenderer, WebGLRenderTarget } from 'three';
import { type Region, type Size, tilesOf } from '../gpu/atlas.js';
import { SAFE_SIDE } from '../gpu/context.js';
import { contextLost, stage } from '../gpu/stage.js';
import type { Picture } from '../picture.js';
import type { Viewport } from '../viewport.js';
import { Batches, sendBatch } from './batches.js';
import { canSum, MOST_SUMMED, pictureTarget, SampleSum } from './sample-sum.js';
import { copyPart } from './screen-pass.js';

/** Milliseconds until the GPU is asked again whether it has finished a batch. */
const PAUSE = 4;

/** Times that a capture begins again because its scene has changed. The last time it is drawn in one task. */
const RESTARTS = 4;

/** The page's last capture. One is drawn after the other: only the first has float buffers. */
let last: Promise<unknown> = Promise.resolve();

/** Rejects with RangeError if no canvas can hold the picture, and where the context is lost. */
export function captureSamples(subject: Viewport, size: Size, samples: number): Promise<HTMLCanvasElement> {
  const picture = last.then(() => draw(subject, size, samples));
  last = picture.catch(() => undefined);
  return picture;
}

async function draw(subject: Viewport, size: Size, samples: number): Promise<HTMLCanvasElement> {
  for (let restarts = 0; ; restarts++) {
    const { version } = subject.picture;
    // Nothing keeps the context of a detached viewer open from one task to the next.
    const atOnce = restarts === RESTARTS || !subject.attached;
    const batches = drawBatches(subject.picture, size, samples, atOnce);
    subject.releaseUnlessAttached();
    try {
      while (atOnce || subject.picture.version === version) {
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
  picture: Picture,
  size: Size,
  samples: number,
  atOnce: boolean,
): Generator<void, HTMLCanvasElement> {
  const target = stage.newTarget(size);
  for (const tile of tilesOf(size, MOST_SUMMED, SAFE_SIDE)) {
    const piece = yield* drawTile(picture, size, tile, samples, atOnce);
    target.drawImage(piece, tile.x, tile.y);
  }
  return target.canvas;
}

function* drawTile(
  picture: Picture,
  size: Size,
  tile: Region,
  samples: number,
  atOnce: boolean,
): Generator<void, HTMLCanvasElement> {
  const plain = (): HTMLCanvasElement => {
    picture.make(size, 1);
    return stage.capture(tile, (renderer, { x, y, width, height }) =>
      picture.draw(renderer, { x: tile.x + x, y: tile.y + y, width, height }),
    );
  };
  let sum: SampleSum | null = null;
  let batches: Batches | null = null;
  let into: WebGLRenderTarget | null = null;
  try {
    const renderer = stage.open(tile);
    if (!canSum(renderer)) return plain();
    sum = new SampleSum(renderer);
    if (!sum.begin(tile)) return plain();
    const [mean, sent] = [sum, (batches = new Batches(renderer.getContext() as WebGL2RenderingContext, 1))];
    while (sum.count < samples) {
      if (atOnce || batches.ended)
        aside((r) => {
          picture.make(size, samples); // another frame may have been drawn since
          sendBatch(sent, mean, samples, tile, r, picture);
        });
      if (!atOnce) yield;
    }
    const { texture } = (into = pictureTarget(tile.width, tile.height));
    aside(() => mean.resolve(into!, { ...tile, x: 0, y: 0 }));
    return stage.capture(tile, (r, part) => copyPart(r, texture, part, tile.height));
  } finally {
    batches?.cancel();
    sum?.dispose();
    into?.dispose();
  }
}

function aside(draw: (renderer: WebGLRenderer) => void): void {
  if (!stage.drawAside(draw)) throw contextLost();
}
