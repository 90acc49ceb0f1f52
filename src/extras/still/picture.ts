// Means over the pixels' squares of what the equation writes there.
//
// First nine points of each pixel are taken: corners, middles of sides, and the middle; neighbours
// share them, so that they cost four samples a pixel. If all are of one piece (one object, one
// side, the same lights' cones and horizons), Simpson's rule agrees with a rule of lower order to a
// quarter of a code, and nothing bends much, its mean is right to some hundredths; across the edge
// of a texel to 1.5 codes (measured). A curve that enters between two of the points, half a pixel
// apart, and leaves again cuts off 0.01 / r of the pixel, r being its radius in pixels. Not where
// highlights may be that narrow, and not where a triangle enters that lies apart from what the
// points meet: rods, dots and wires may be thinner.
//
// All other pixels take 16, 64, 256 or 1,024 samples, the more the colours vary, at the places
// where the screen takes that many: its picture differs by rounding where it draws the same
// surface. Where an edge passes, 256 samples have an RMS error of 0.005 of its codes
// (`phong/math/pixel-offsets.ts`). `tests/extras/still/caster.test.ts` measures it.
import { centredOffset } from '../../phong/math/pixel-offsets.js';
import type { CastOptions } from './cast-scene.js';
import { NOTHING, type Sample, type Tracer } from './tracer.js';

/** Samples of a pixel that nine points do not settle. */
const COUNTS = [16, 64, 256, 1024];

/** The fewest where something may be small and alone, or an edge. */
const CAREFUL = 64;

/** Whether `count` samples are enough for colours that differ by `range` codes. */
const isEnough = (count: number, range: number, isSmooth: boolean): boolean =>
  isSmooth
    ? count >= 7.2 * range
    : count >= CAREFUL && 2 * count * Math.sqrt(count) >= range * range;

/** Most codes between Simpson's rule and that of lower order. */
const AGREEMENT = 0.25;

/**
 * Most codes of a second difference through the middle. Both rules give the same where two colours
 * meet between two columns of the points, or two rows: up to a third of their difference off.
 */
const MOST_BEND = 3;

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
  const means = new Float64Array(4 * width * (to - from));
  const { starts } = tracer.lists;
  let bottom = new Line(tracer, width, from);
  for (let row = from; row < to; row++) {
    const top = bottom;
    const middle = new Line(tracer, width, row + 0.5);
    bottom = new Line(tracer, width, row + 1);
    for (let column = 0; column < width; column++) {
      const pixel = row * width + column;
      if (starts[pixel] === starts[pixel + 1]) continue; // no ray through it meets anything
      const piece = middle.pieceAt(2 * column + 1);
      const isSmooth =
        middle.isAll(piece, column) &&
        top.isAll(piece, column) &&
        bottom.isAll(piece, column) &&
        !tracer.isCrossed(column, row);
      if (isSmooth && piece === NOTHING) continue;
      if (!isSmooth || tracer.isNarrow || !bySimpson(top, middle, bottom, column)) {
        castPixel(tracer, column, row, samples, isSmooth, piece);
      }
      means.set(mean, 4 * (pixel - from * width));
    }
  }
  return means;
}

/** Samples half a pixel apart along a row, each taken when it is first needed. */
class Line {
  readonly colors: Float64Array;
  readonly #tracer: Tracer;
  readonly #y: number;
  /** NaN until its sample is taken. */
  readonly #pieces: Float64Array;

  constructor(tracer: Tracer, width: number, y: number) {
    const count = 2 * width + 1;
    this.#tracer = tracer;
    this.#y = y;
    this.colors = new Float64Array(4 * count);
    this.#pieces = new Float64Array(count).fill(NaN);
  }

  pieceAt(i: number): number {
    if (Number.isNaN(this.#pieces[i])) {
      this.#tracer.sampleAt(i / 2, this.#y, scratch);
      this.#pieces[i] = scratch.piece;
      this.colors.set(scratch.color, 4 * i);
    }
    return this.#pieces[i]!;
  }

  /** Whether its three samples of a pixel are of this piece. */
  isAll(piece: number, column: number): boolean {
    const i = 2 * column;
    return (
      this.pieceAt(i + 1) === piece && this.pieceAt(i) === piece && this.pieceAt(i + 2) === piece
    );
  }
}

/** Writes {@link mean}. False where it may not be exact enough. */
function bySimpson(
  { colors: top }: Line,
  { colors: middle }: Line,
  { colors: bottom }: Line,
  column: number,
): boolean {
  for (let k = 0; k < 4; k++) {
    const left = 8 * column + k;
    const [center, right] = [left + 4, left + 8];
    const corners = top[left]! + top[right]! + bottom[left]! + bottom[right]!;
    const sides = top[center]! + bottom[center]! + middle[left]! + middle[right]!;
    const value = (corners + 4 * sides + 16 * middle[center]!) / 36;
    const twice = 2 * middle[center]!;
    if (Math.abs(middle[left]! + middle[right]! - twice) > MOST_BEND) return false;
    if (Math.abs(top[center]! + bottom[center]! - twice) > MOST_BEND) return false;
    // Without the sides it is exact for polynomials of the second degree.
    if (Math.abs(value - (corners + 8 * middle[center]!) / 12) > AGREEMENT) return false;
    mean[k] = value;
  }
  return true;
}

/** Writes {@link mean}. `isSmooth`: all points so far are of this piece. */
function castPixel(
  tracer: Tracer,
  column: number,
  row: number,
  most: number,
  isSmooth: boolean,
  piece: number,
): void {
  for (const count of COUNTS) {
    if (count < CAREFUL && !isSmooth && count < most) continue;
    const taken = Math.min(count, most);
    isSmooth = meanOf(tracer, column, row, taken, piece) && isSmooth;
    const range = Math.max(...high.map((value, k) => value - low[k]!));
    if (taken === most || isEnough(count, range, isSmooth)) return;
  }
}

const mean = new Float64Array(4);
const low = new Float64Array(4);
const high = new Float64Array(4);
const scratch: Sample = { color: [0, 0, 0, 0], piece: 0 };

/**
 * Writes the mean, the lowest and the highest values of the samples. Returns whether all are of the
 * same piece.
 */
function meanOf(
  tracer: Tracer,
  column: number,
  row: number,
  count: number,
  piece: number,
): boolean {
  let isOne = true;
  mean.fill(0);
  low.fill(Infinity);
  high.fill(-Infinity);
  for (const { x, y } of offsetsOf(count)) {
    tracer.sampleAt(column + 0.5 + x, row + 0.5 + y, scratch);
    isOne &&= scratch.piece === piece;
    for (let k = 0; k < 4; k++) {
      const value = scratch.color[k as 0];
      mean[k]! += value / count;
      low[k] = Math.min(low[k]!, value);
      high[k] = Math.max(high[k]!, value);
    }
  }
  return isOne;
}

/** By count, from a pixel's centre. */
const offsets: ReturnType<typeof centredOffset>[][] = [];

const offsetsOf = (count: number) =>
  (offsets[count] ??= Array.from({ length: count }, (_, i) => centredOffset(i, count)));
