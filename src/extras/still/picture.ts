// Means of samples over the pixels' squares. Each pixel is cut into equal squares, with one sample
// at a random place in each: the error of the mean falls with the samples to the power of −3/4
// where an edge passes, and faster elsewhere.
//
// Quiet pixels get 16 samples or 64. Such a pixel is one piece (one object, one side, the same
// lights' cones and horizons) at all its samples and at eight points around it, on a square an
// eighth of a pixel outside its own. A curve that enters between two of those, 5/8 of a pixel apart
// at most, without reaching one has a radius below 0.4 pixels. And no channel varies by 2 codes
// over 16 samples, or 8 over 64. Where the colour is linear, the mean then has a standard error
// below 2 / √16 / √12 / √16 = 0.036 codes; rounding to 8 bits has 0.29. `tests/extras/still/caster.test.ts`
// measures it.
import type { CastOptions } from './cast-scene.js';
import { NOTHING, type Sample, type Tracer } from './tracer.js';

/** Sides of the squares of samples that quiet pixels get. */
const FEW = [4, 8];

/** Points around a quiet pixel, from its top left corner. */
const AROUND = [-1 / 8, 1 / 2, 9 / 8].flatMap((x) =>
  [-1 / 8, 1 / 2, 9 / 8].filter((y) => x !== 1 / 2 || y !== 1 / 2).map((y) => [x, y] as const),
);

/**
 * The means of rows `from` to `to` (excluded): r, g, b, a of each pixel; see {@link castPicture}.
 */
export function castRows(
  tracer: Tracer,
  options: CastOptions,
  from: number,
  to: number,
): Float64Array {
  const { width, samples = 1024 } = options;
  const side = Math.sqrt(samples);
  if (!Number.isInteger(side) || side < 1) {
    throw new RangeError('samples must be the square of a whole number');
  }
  const means = new Float64Array(4 * width * (to - from));
  for (let row = from; row < to; row++) {
    for (let column = 0; column < width; column++) {
      if (!tracer.mayMeet(column, row)) continue;
      const mean = means.subarray(4 * ((row - from) * width + column)).subarray(0, 4);
      const pixel = row * width + column;
      const few = FEW.filter((least) => least < side);
      if (isQuiet(tracer, column, row, few, randomFrom(~pixel), mean)) continue;
      mean.fill(0);
      forSamples(tracer, column, row, side, randomFrom(pixel), ({ color }) => {
        for (let i = 0; i < 4; i++) {
          mean[i]! += color[i as 0];
        }
      });
      for (let i = 0; i < 4; i++) {
        mean[i]! /= samples;
      }
    }
  }
  return means;
}

/** Writes the mean of few samples; false where it may not be good enough. */
function isQuiet(
  tracer: Tracer,
  column: number,
  row: number,
  sides: readonly number[],
  random: () => number,
  mean: Float64Array,
): boolean {
  if (sides.length === 0) return false;
  tracer.sampleAt(column + 0.5, row + 0.5, scratch);
  const middle = scratch.piece;
  for (const [x, y] of AROUND) {
    tracer.sampleAt(column + x, row + y, scratch);
    if (scratch.piece !== middle) return false;
  }
  if (middle === NOTHING) {
    sides = [sides.at(-1)!]; // what is small and alone shows in many samples only
  }
  for (const side of sides) {
    const most = (side * side) / 8;
    let others = 0;
    mean.fill(0);
    low.fill(Infinity);
    high.fill(-Infinity);
    forSamples(tracer, column, row, side, random, ({ color, piece }) => {
      if (piece !== middle) {
        others++;
      }
      for (let i = 0; i < 4; i++) {
        const value = color[i as 0];
        mean[i]! += value / (side * side);
        if (value < low[i]!) {
          low[i] = value;
        }
        if (value > high[i]!) {
          high[i] = value;
        }
      }
    });
    if (others > 0) return false;
    if (high.every((value, i) => value - low[i]! < most)) return true;
  }
  return false;
}

const low = new Float64Array(4);
const high = new Float64Array(4);

function forSamples(
  tracer: Tracer,
  column: number,
  row: number,
  side: number,
  random: () => number,
  visit: (sample: Sample) => void,
): void {
  for (let j = 0; j < side; j++) {
    for (let i = 0; i < side; i++) {
      tracer.sampleAt(column + (i + random()) / side, row + (j + random()) / side, scratch);
      visit(scratch);
    }
  }
}

const scratch: Sample = { color: [0, 0, 0, 0], piece: 0 };

/**
 * Numbers in [0, 1) that depend on the pixel alone, however rows are shared among threads:
 * Mulberry32.
 */
function randomFrom(pixel: number): () => number {
  let state = Math.imul(pixel + 1, 0x9e3779b1);
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let x = Math.imul(state ^ (state >>> 15), state | 1);
    x ^= x + Math.imul(x ^ (x >>> 7), x | 61);
    return ((x ^ (x >>> 14)) >>> 0) / 4294967296;
  };
}
