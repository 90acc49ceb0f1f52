// Real roots of polynomials up to the fourth degree, by isolation: between two neighbouring zeros
// of its derivative a polynomial has one root at most. Slower than a formula, and exact to
// float64's rounding, at double roots too.

/**
 * Writes the real roots of the sum of c[i]·x^i in (low, high) to `out`, ascending, and returns how
 * many there are.
 */
export function rootsIn(
  c: readonly number[],
  low: number,
  high: number,
  out: Float64Array,
): number {
  const degree = c.length - 1;
  if (degree === 1) {
    const x = -c[0]! / c[1]!;
    if (!(x > low && x < high)) return 0;
    out[0] = x;
    return 1;
  }
  const { slopes, turns } = SCRATCH[degree]!;
  for (let i = 1; i <= degree; i++) {
    slopes[i - 1] = c[i]! * i;
  }
  const count = rootsIn(slopes, low, high, turns);
  turns[count] = high;
  let found = 0;
  let from = low;
  let atFrom = valueAt(c, low);
  for (let i = 0; i <= count; i++) {
    const to = turns[i]!;
    const atTo = valueAt(c, to);
    if (atFrom === 0 && from > low) {
      out[found++] = from;
    } else if (atFrom < 0 ? atTo > 0 : atTo < 0) {
      out[found++] = rootBetween(c, slopes, from, to, atFrom);
    }
    from = to;
    atFrom = atTo;
  }
  return found;
}

/** By degree. */
const SCRATCH = [0, 1, 2, 3, 4].map((degree) => ({
  slopes: new Array<number>(degree).fill(0),
  turns: new Float64Array(degree),
}));

function valueAt(c: readonly number[], x: number): number {
  let sum = 0;
  for (let i = c.length - 1; i >= 0; i--) {
    sum = sum * x + c[i]!;
  }
  return sum;
}

/**
 * Newton's steps, and a bisection wherever one leaves the interval. The signs at its ends differ.
 */
function rootBetween(
  c: readonly number[],
  slopes: readonly number[],
  from: number,
  to: number,
  atFrom: number,
): number {
  let [low, high, x] = [from, to, (from + to) / 2];
  for (let step = 0; step < 100; step++) {
    const value = valueAt(c, x);
    if (value === 0) return x;
    if (value < 0 === atFrom < 0) {
      low = x;
    } else {
      high = x;
    }
    let next = x - value / valueAt(slopes, x);
    if (!(next > low && next < high)) {
      next = (low + high) / 2;
    }
    // Two roundings: steps may alternate between neighbouring numbers for ever.
    if (Math.abs(next - x) <= 2 * Number.EPSILON * Math.abs(x)) return next;
    x = next;
  }
  return x;
}
