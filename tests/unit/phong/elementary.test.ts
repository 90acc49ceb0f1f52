// The functions that take the place of the engine's own, against 70-digit arithmetic with whole
// numbers.
import { describe, expect, it } from 'vitest';
import {
  acos,
  atan2,
  cosSmall,
  exp,
  log,
  log1p,
  pow,
  sinSmall,
} from '../../../src/phong/math/elementary.js';

/** Fixed-point numbers with so many bits after the point. */
const BITS = 256n;
const ONE = 1n << BITS;
const times = (a: bigint, b: bigint) => (a * b) >> BITS;
const over = (a: bigint, b: bigint) => (a << BITS) / b;

/** A float64 exactly: those of the tests have no bit below 2^-256. */
function fixed(x: number) {
  let [shift, whole] = [0n, x];
  while (!Number.isInteger(whole)) {
    whole *= 2;
    shift += 1n;
  }
  return (BigInt(whole) << BITS) >> shift;
}

/** The nearest float64 but for some roundings of its last bit's thousandth. */
const float = (a: bigint) => {
  const cut = BigInt(Math.max(0, a.toString(2).length - 64));
  return Number(a >> cut) * 2 ** Number(cut - BITS);
};

const artanh = (z: bigint) => {
  let [sum, power] = [0n, z];
  for (let n = 1n; power !== 0n; n += 2n) {
    sum += power / n;
    power = times(times(power, z), z);
  }
  return sum;
};
const LN2 = 2n * artanh(ONE / 3n);
const exactLog = (x: bigint) => {
  let [k, m] = [0n, x];
  for (; m > 2n * ONE; k += 1n) {
    m >>= 1n;
  }
  for (; m < ONE; k -= 1n) {
    m <<= 1n;
  }
  return k * LN2 + 2n * artanh(over(m - ONE, m + ONE));
};
const series = (x: bigint, first: bigint, from: bigint, step: bigint, sign: bigint) => {
  let [sum, term] = [0n, first];
  for (let n = from; term !== 0n; n += step) {
    sum += term;
    for (let i = 1n; i <= step; i += 1n) {
      term = times(term, x) / (n + i);
    }
    term *= sign;
  }
  return sum;
};
const exactExp = (x: bigint) => {
  let k = x / LN2;
  const r = series(x - k * LN2, ONE, 0n, 1n, 1n);
  return k >= 0n ? r << k : r >> (k = -k);
};
const exactSin = (x: bigint) => series(x, x, 1n, 2n, -1n);
const exactCos = (x: bigint) => series(x, ONE, 0n, 2n, -1n);
/** Euler's series; t from 0 to 1. */
const exactArctan = (t: bigint) => {
  const w = over(times(t, t), ONE + times(t, t));
  let [sum, term] = [0n, over(t, ONE + times(t, t))];
  for (let n = 1n; term !== 0n; n += 1n) {
    sum += term;
    term = (times(term, w) * 2n * n) / (2n * n + 1n);
  }
  return sum;
};
const PI = 4n * exactArctan(ONE);

/** The largest relative error of `f` over seeded numbers from `low` to `high`. */
function worst(low: number, high: number, f: (x: number) => number, exact: (x: bigint) => bigint) {
  let [state, error] = [SEED, 0];
  for (let i = 0; i < 2000; i++) {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    const x = low + ((high - low) * state) / 2 ** 32;
    const truth = exact(fixed(x));
    const apart = over(fixed(f(x)) - truth, truth);
    error = Math.max(error, float(apart < 0n ? -apart : apart));
  }
  return error;
}

const SEED = 20261128;

describe(`elementary functions, seed ${SEED}`, () => {
  it('are right to 4e-16 of their value', () => {
    expect(worst(0.5, 2, log, exactLog)).toBeLessThan(4e-16);
    expect(worst(1e-9, 1e9, log, exactLog)).toBeLessThan(4e-16);
    expect(worst(0.999999, 1.000001, log, exactLog)).toBeLessThan(4e-16);
    expect(worst(-0.5, 0.5, log1p, (x) => exactLog(ONE + x))).toBeLessThan(6e-16);
    expect(worst(-1e-8, 1e-8, log1p, (x) => exactLog(ONE + x))).toBeLessThan(6e-16);
    expect(worst(-50, 100, exp, exactExp)).toBeLessThan(4e-16);
    expect(worst(-Math.PI / 4, Math.PI / 4, sinSmall, exactSin)).toBeLessThan(4e-16);
    expect(worst(-Math.PI / 4, Math.PI / 4, cosSmall, exactCos)).toBeLessThan(4e-16);
  });

  it('have angles that are right to 1e-15', () => {
    const slopes = (x: number) => atan2(x, 1);
    expect(worst(0, 1, slopes, exactArctan)).toBeLessThan(1e-15);
    expect(worst(1e-9, 1e-6, slopes, exactArctan)).toBeLessThan(1e-15);
    const steep = (x: bigint) => PI / 2n - exactArctan(over(ONE, x));
    expect(worst(1, 1e6, slopes, steep)).toBeLessThan(1e-15);
    expect(
      worst(
        0,
        3,
        (x) => atan2(-x, -4),
        (x) => exactArctan(x / 4n) - PI,
      ),
    ).toBeLessThan(1e-15);
    expect(
      worst(
        0.1,
        3.1,
        (x) => acos(Math.cos(x)),
        (x) => x,
      ),
    ).toBeLessThan(1e-14);
  });

  it('have powers that are right to 1e-13', () => {
    for (const n of [2.4, 1 / 2.4, 32, 1000]) {
      const power = (x: bigint) => exactExp(times(fixed(n), exactLog(x)));
      const least = 1 - 30 / (n + 30);
      expect(
        worst(least, 1, (x) => pow(x, n), power),
        String(n),
      ).toBeLessThan(1e-13);
    }
    const million = (x: bigint) => exactExp(1_000_000n * exactLog(x));
    expect(worst(0.99997, 1, (x) => pow(x, 1e6), million)).toBeLessThan(1e-13);
  });

  it('are the textbook’s at the ends of their domains', () => {
    expect([log(0), log(1), log(Infinity), log(-1)]).toEqual([-Infinity, 0, Infinity, NaN]);
    expect([exp(0), exp(-Infinity), exp(-1e9), exp(1e9), exp(NaN)]).toEqual([
      1,
      0,
      0,
      Infinity,
      NaN,
    ]);
    expect([pow(0, 0), pow(0, 3), pow(1, 1e6), pow(2, 10)]).toEqual([1, 0, 1, 1024]);
    expect([atan2(0, 0), atan2(0, -1), atan2(1, 0)]).toEqual([0, Math.PI, Math.PI / 2]);
    expect([acos(1), acos(-1)]).toEqual([0, Math.PI]);
    expect(log(5e-324)).toBeCloseTo(Math.log(5e-324), 10);
    expect(exp(709)).toBeCloseTo(Math.exp(709), -300);
  });
});
