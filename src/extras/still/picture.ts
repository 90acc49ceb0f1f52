// Means of samples over the pixels' squares. Each pixel is cut into equal squares, with one sample
// at a random place in each, and the more the colours vary, the more squares there are.
//
// A pixel is smooth if it is one piece (one object, one side, the same lights' cones and horizons)
// at all its samples and at nine points in it and around it, on a square an eighth of a pixel
// outside its own. A curve that enters between two of those, 5/8 of a pixel apart at most, without
// reaching one has a radius below 0.4 pixels. Where colours are linear and differ by c codes, the
// mean of s² samples has a standard error of c / (√12 s²): 0.04 codes by the rule below. Where an
// edge of c codes passes, some √2 s squares are cut, which leave about 0.29 c / s^1.5: 0.4 codes.
// `tests/extras/still/caster.test.ts` measures it.
import type { CastOptions } from './cast-scene.js';
import { NOTHING, type Sample, type Tracer } from './tracer.js';

/** Sides of the squares of samples. */
const SIDES = [4, 8, 12, 16, 24, 32];

/** The fewest where something may be small and alone, or an edge. */
const CAREFUL = 8;

/** Whether a square of this side is enough for colours that differ by so many codes. */
const isEnough = (side: number, range: number, isSmooth: boolean): boolean =>
  isSmooth ? side * side >= 7.2 * range : 2 * side * side * side >= range * range;

/** Places in a pixel and around it, from its top left corner. */
const AROUND = [-1 / 8, 1 / 2, 9 / 8].flatMap((x) =>
  [-1 / 8, 1 / 2, 9 / 8].map((y) => [x, y] as const),
);

/**
 * The mean over each pixel's square of what the equation writes there, clamped and encoded but not
 * rounded, of rows `from` to `to` (excluded): r, g, b, a of each pixel, codes 0–255, premultiplied.
 */
export function castRows(
  tracer: Tracer,
  { width, samples = 1024 }: CastOptions,
  from: number,
  to: number,
): Float64Array {
  const most = Math.sqrt(samples);
  if (!Number.isInteger(most) || most < 1) {
    throw new RangeError('samples must be the square of a whole number');
  }
  const means = new Float64Array(4 * width * (to - from));
  for (let row = from; row < to; row++) {
    for (let column = 0; column < width; column++) {
      if (!tracer.mayMeet(column, row)) continue;
      const at = 4 * ((row - from) * width + column);
      castPixel(tracer, column, row, most, randomFrom(row * width + column));
      means.set(mean, at);
    }
  }
  return means;
}

/** Writes {@link mean}. */
function castPixel(
  tracer: Tracer,
  column: number,
  row: number,
  most: number,
  random: () => number,
): void {
  tracer.sampleAt(column + 0.5, row + 0.5, scratch);
  const middle = scratch.piece;
  let isSmooth = most > SIDES[0]!;
  for (let i = 0; i < AROUND.length && isSmooth; i++) {
    tracer.sampleAt(column + AROUND[i]![0], row + AROUND[i]![1], scratch);
    isSmooth = scratch.piece === middle;
  }
  for (const side of SIDES) {
    if (side < CAREFUL && (!isSmooth || middle === NOTHING) && side < most) continue;
    const taken = Math.min(side, most);
    isSmooth = meanOf(tracer, column, row, taken, middle, random) && isSmooth;
    const range = Math.max(...high.map((value, i) => value - low[i]!));
    const least = isSmooth ? 0 : CAREFUL;
    if (taken === most || (side >= least && isEnough(side, range, isSmooth))) return;
  }
}

const mean = new Float64Array(4);
const low = new Float64Array(4);
const high = new Float64Array(4);
const scratch: Sample = { color: [0, 0, 0, 0], piece: 0 };

/**
 * Writes the mean, the lowest and the highest values of a square of samples. Whether all are of the
 * same piece.
 */
function meanOf(
  tracer: Tracer,
  column: number,
  row: number,
  side: number,
  piece: number,
  random: () => number,
): boolean {
  let isOne = true;
  mean.fill(0);
  low.fill(Infinity);
  high.fill(-Infinity);
  for (let j = 0; j < side; j++) {
    for (let i = 0; i < side; i++) {
      tracer.sampleAt(column + (i + random()) / side, row + (j + random()) / side, scratch);
      isOne &&= scratch.piece === piece;
      for (let k = 0; k < 4; k++) {
        const value = scratch.color[k as 0];
        mean[k]! += value;
        low[k] = Math.min(low[k]!, value);
        high[k] = Math.max(high[k]!, value);
      }
    }
  }
  for (let k = 0; k < 4; k++) {
    mean[k]! /= side * side;
  }
  return isOne;
}

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
