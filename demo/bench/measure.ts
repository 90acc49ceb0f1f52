// Measures all ways to write the light loop in this browser, in turns, in tasks so short that the
// page stays responsive. Knows nothing of how results are shown.
import { largest } from '../../tests/bench/front/errors.js';
import { ERROR_SIDE, type Front, openFront } from '../../tests/bench/front/front.js';
import { rendererName } from '../../tests/bench/pages/timing.js';
import {
  type Accuracy,
  type AccuracyPoint,
  type ErrorPicture,
  MAGNIFIED,
  PICTURED,
  PLAIN_WAY,
  WAYS,
  type WayName,
} from '../../tests/bench/accuracy-words.mjs';
import { median, pairedRatios } from '../../tests/bench/statistics.mjs';

/** Duration of a sample: long beside the timer's own cost, short enough not to be noticed. */
const SAMPLE_MS = 25;
const MOST_FRAMES = 400;
const LEAST_ROUNDS = 2;
/**
 * Pixels of a frame. Software takes about as long for the smaller picture as a GPU for the larger
 * one.
 */
const SIZES = { gpu: [960, 720], software: [160, 120] } as const;

const isSoftware = (renderer: string): boolean =>
  /SwiftShader|llvmpipe|Software|Basic Render/i.test(renderer);

/** The driver's name for itself. Throws where this browser has no WebGL 2. */
export function rendererHere(): string {
  const gl = document.createElement('canvas').getContext('webgl2');
  if (gl === null) throw new Error('this browser has no WebGL 2');
  const name = rendererName(gl);
  gl.getExtension('WEBGL_lose_context')?.loseContext();
  return name;
}

/**
 * `holder` has to be on screen. `progress` gets what has been measured so far and the share that is
 * done, 0 to 1, after each round. @param ms for each exponent @param exponents of the highlight
 */
export async function measureAccuracy(
  holder: HTMLElement,
  ms: number,
  exponents: readonly number[],
  signal: AbortSignal,
  progress: (accuracy: Accuracy, done: number) => void,
): Promise<Accuracy> {
  const renderer = rendererHere();
  const software = isSoftware(renderer);
  const size = SIZES[software ? 'software' : 'gpu'];
  const points: AccuracyPoint[] = [];
  const pictures: ErrorPicture[] = [];
  const date = new Date().toISOString().slice(0, 10);
  const so = (more: readonly AccuracyPoint[] = []): Accuracy => {
    const about = { renderer, browser: navigator.userAgent, date, size: [...size] };
    return { ...about, points: [...points, ...more], pictures };
  };
  for (const [i, exponent] of exponents.entries()) {
    const front = openFront(holder, exponent, size, software);
    try {
      const errors = await front.errors(signal);
      if (exponent === PICTURED.exponent) {
        pictures.push(...PICTURED.ways.map((way) => ({ way, png: pngOf(errors[way]) })));
      }
      const time = (way: WayName, frames: number): Promise<number> =>
        sample(front, way, frames, software, signal);
      let last: AccuracyPoint[] = [];
      await inTurns(ms, time, (times, done) => {
        last = WAYS.map(({ way }) => ({
          way,
          exponent,
          ms: rounded(median(times[way])),
          time: rounded(median(pairedRatios(times[way], times[PLAIN_WAY]))),
          error: rounded(largest(errors[way])),
        }));
        progress(so(last), (i + done) / exponents.length);
      });
      points.push(...last);
    } finally {
      front.close();
    }
  }
  return so();
}

const rounded = (x: number): number => Number(x.toPrecision(4));

type Times = Record<WayName, number[]>;

/** Samples of one frame of each way, round by round until the time is over. */
async function inTurns(
  ms: number,
  time: (way: WayName, frames: number) => Promise<number>,
  progress: (times: Times, done: number) => void,
): Promise<void> {
  const until = performance.now() + ms;
  const counts = new Map<WayName, number>();
  for (const { way } of WAYS) {
    counts.set(way, await framesFor((frames) => time(way, frames)));
  }
  const times = Object.fromEntries(WAYS.map(({ way }) => [way, []])) as unknown as Times;
  for (let round = 0; round < LEAST_ROUNDS || performance.now() < until; round++) {
    // Every other round backwards: no way always follows the same one.
    for (const { way } of round % 2 === 0 ? WAYS : WAYS.toReversed()) {
      const frames = counts.get(way)!;
      times[way].push((await time(way, frames)) / frames);
    }
    progress(times, Math.min(1, 1 - (until - performance.now()) / ms));
  }
}

/** So many frames that a sample is long enough. */
async function framesFor(time: (frames: number) => Promise<number>): Promise<number> {
  await time(1); // compiles
  let count = 1;
  for (;;) {
    const taken = await time(count);
    if (taken >= SAMPLE_MS || count >= MOST_FRAMES) return count;
    count = Math.min(
      MOST_FRAMES,
      Math.ceil(count * Math.min(8, (1.3 * SAMPLE_MS) / Math.max(taken, 0.1))),
    );
  }
}

/**
 * Milliseconds, by the GPU's timer where the browser has one. Waits while the page is in the
 * background.
 */
async function sample(
  front: Front,
  way: WayName,
  frames: number,
  software: boolean,
  signal: AbortSignal,
): Promise<number> {
  signal.throwIfAborted();
  while (document.hidden) {
    await new Promise((resolve) => {
      document.addEventListener('visibilitychange', resolve, { once: true });
    });
  }
  await new Promise((resolve) => setTimeout(resolve)); // the page's turn
  return front.hasTimer && !software ? front.time(way, frames) : front.draw(way, frames);
}

/** Errors magnified as a picture: black is exact. A data address. */
function pngOf(errors: Float64Array): string {
  const canvas = document.createElement('canvas');
  canvas.width = canvas.height = ERROR_SIDE;
  const context = canvas.getContext('2d')!;
  const picture = context.createImageData(ERROR_SIDE, ERROR_SIDE);
  for (let i = 0; i < ERROR_SIDE * ERROR_SIDE; i++) {
    const [column, row] = [i % ERROR_SIDE, Math.floor(i / ERROR_SIDE)];
    const at = 4 * (column + ERROR_SIDE * (ERROR_SIDE - 1 - row));
    for (let channel = 0; channel < 3; channel++) {
      picture.data[at + channel] = MAGNIFIED * errors[3 * i + channel]!; // clamps and rounds
    }
    picture.data[at + 3] = 255;
  }
  context.putImageData(picture, 0, 0);
  return canvas.toDataURL('image/png');
}
