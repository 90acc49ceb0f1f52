// `phong-viewer/still`: the picture of a viewer's markup, without a browser and a GPU, and the same
// bytes on every machine.
import { withMarkup } from '../png/chunks.js';
import { castSceneOf } from './build-scene.js';
import { readMarkup } from './markup.js';
import { encodePng } from './png.js';
import { castHere, castOnThreads } from './threads.js';

export interface StillOptions {
  /** Pixels. Whole numbers from 1. */
  readonly width: number;
  readonly height: number;
  /** What addresses in the markup are relative to: a `file:` or `http:` address. */
  readonly base?: URL | string;
  /** r, g and b from 0 to 255, behind what is transparent. Default: nothing. */
  readonly background?: readonly [number, number, number];
  /** Hears of each file that is read: models and their images. */
  readonly onFile?: (url: URL, bytes: Uint8Array) => void;
  /** Hears what a browser's console would say of the markup. Default: `console.warn`. */
  readonly warn?: (message: string) => void;
  /** Most threads in Node. They change no pixel. Default: one for each core; 1: the caller's own. */
  readonly threads?: number;
}

export interface Still {
  readonly width: number;
  readonly height: number;
  /** r, g, b, a of each pixel, 0–255, straight alpha, rows from the top. */
  readonly pixels: Uint8Array;
  /** The same as a file, which holds the markup too: dropped on a `droppable` viewer it opens. */
  readonly png: Uint8Array;
}

/**
 * Samples of pixels at edges, the same as those of a screen with `samples="256"`: an RMS error of 1.2
 * codes where white meets black. 1,024 would leave 0.4 and take twice the time.
 */
const SAMPLES = 256;

/** Larger pictures than this take more than a gigabyte. */
const MOST_PIXELS = 33554432;

/**
 * What a viewer of this size with `antialias="full"` converges to. Bad values warn and are left
 * out, as in a browser.
 * @throws TypeError, RangeError or ModelError for what cannot be drawn, and names it.
 */
export async function still(markup: string, options: StillOptions): Promise<Still> {
  const { width, height, base, background, onFile, warn = console.warn } = options;
  // A file that is read without its encoding is none.
  if (typeof markup !== 'string') throw new TypeError('the markup of a still must be a string');
  if (
    ![width, height].every((n) => Number.isInteger(n) && n >= 1) ||
    width * height > MOST_PIXELS
  ) {
    throw new RangeError(`a still has whole numbers of pixels, at most ${String(MOST_PIXELS)}`);
  }
  if ([...(background ?? [])].some((code) => !(code >= 0 && code <= 255))) {
    throw new RangeError('background: r, g and b must be from 0 to 255');
  }
  const size = { width, height, samples: SAMPLES };
  const scene = await castSceneOf(readMarkup(markup, warn), size, { base, warn, onFile });
  const threads = Math.min(options.threads ?? Infinity, await cores());
  const means =
    threads > 1 ? await castOnThreads(scene, size, threads, WORKER) : castHere(scene, size);
  const pixels = straight(means, background);
  const png = withMarkup(encodePng(width, height, pixels), markup.trim());
  return { width, height, pixels, png };
}

/** Beside this file once it is built. */
const WORKER = new URL(/* @vite-ignore */ './still-worker.js', import.meta.url);

/** 1 in browsers. */
async function cores(): Promise<number> {
  if (!('process' in globalThis)) return 1;
  const { availableParallelism } = await import('node:os');
  return availableParallelism();
}

/** Premultiplied means as 8-bit codes with straight alpha, before the background if there is one. */
function straight(means: Float64Array, background: StillOptions['background']): Uint8Array {
  const pixels = new Uint8Array(means.length);
  for (let i = 0; i < means.length; i += 4) {
    const cover = means[i + 3]!;
    const alpha = background === undefined ? cover : 255;
    pixels[i + 3] = Math.round(alpha);
    if (pixels[i + 3] === 0) continue;
    for (let k = 0; k < 3; k++) {
      const behind = (1 - cover / 255) * (background?.[k as 0] ?? 0);
      pixels[i + k] = Math.round(Math.min((255 * (means[i + k]! + behind)) / alpha, 255));
    }
  }
  return pixels;
}
