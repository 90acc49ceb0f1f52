// Powers and trigonometry that are the same bits in every engine: engines differ in their own
// `Math.pow`, `Math.sin` and so on, and agree in + − × ÷ and `Math.sqrt` only. Relative errors are
// below 4e-16 unless a function says otherwise (`tests/unit/phong/elementary.test.ts`).

const LN2_HIGH = 6.9314718036912381649e-1; // its last 21 bits are 0: a whole number times it is exact
const LN2_LOW = 1.90821492927058770002e-10;
const LOG2_E = 1.4426950408889634;

const bits = new Float64Array(1);
const words = new Int32Array(bits.buffer);
/** Index of the word that has sign and exponent. */
const HIGH = new Uint8Array(new Uint32Array([1]).buffer)[0] === 1 ? 1 : 0;

/** 2^k for whole k, −1022 to 1023. */
function powerOfTwo(k: number): number {
  words[1 - HIGH] = 0;
  words[HIGH] = (k + 1023) << 20;
  return bits[0]!;
}

/** 2^54: makes subnormal numbers normal. */
const TWO54 = 18014398509481984;

/** The natural logarithm of x > 0. −Infinity at 0. */
export function log(x: number): number {
  if (x === Infinity || !(x > 0)) return x === 0 ? -Infinity : x > 0 ? x : NaN;
  let k = 0;
  if (x < 2.3e-308) {
    x *= TWO54;
    k = -54;
  }
  bits[0] = x;
  const high = words[HIGH]!;
  // x = 2^k m with m from √½ to √2, so that near 1 nothing cancels.
  const up = (high & 0xfffff) > 0x6a09e ? 1 : 0;
  k += (high >>> 20) - 1023 + up;
  words[HIGH] = (high & 0xfffff) | ((1023 - up) << 20);
  const f = bits[0] - 1;
  // log(1 + f) = 2 artanh(z) = f − z (f − series), with f² / 2 kept apart: Tang's form.
  const z = f / (2 + f);
  const w = z * z;
  const series =
    w *
    (2 / 3 +
      w *
        (2 / 5 +
          w *
            (2 / 7 +
              w *
                (2 / 9 +
                  w * (2 / 11 + w * (2 / 13 + w * (2 / 15 + w * (2 / 17 + w * (2 / 19)))))))));
  const half = 0.5 * f * f;
  return k * LN2_HIGH - (half - (z * (half + series) + k * LN2_LOW) - f);
}

/** log(1 + x) for x > −1, without cancellation near 0: Kahan's correction. */
export function log1p(x: number): number {
  const sum = 1 + x;
  return sum === 1 ? x : (log(sum) * x) / (sum - 1);
}

/** e^x; 0 below −708, where results would be subnormal. */
export function exp(x: number): number {
  if (x > 709.7) return Infinity;
  if (!(x >= -708)) return x < 0 ? 0 : NaN;
  const k = Math.round(x * LOG2_E);
  const r = x - k * LN2_HIGH - k * LN2_LOW;
  let sum = 1 / 6227020800;
  for (const factorial of FACTORIALS) {
    sum = sum * r + factorial;
  }
  return k === 1024 ? sum * powerOfTwo(1023) * 2 : sum * powerOfTwo(k);
}

/** 1 / n! for n = 12 to 0. */
const FACTORIALS = [
  1 / 479001600,
  1 / 39916800,
  1 / 3628800,
  1 / 362880,
  1 / 40320,
  1 / 5040,
  1 / 720,
  1 / 120,
  1 / 24,
  1 / 6,
  1 / 2,
  1,
  1,
];

/**
 * x^y for x >= 0. x^0 is 1. Relative error below 3e-16 · max(1, |y log x|): 1e-13 for results from
 * 1e-140 to 1e140.
 */
export function pow(x: number, y: number): number {
  if (y === 0) return 1;
  if (x === 0) return y > 0 ? 0 : Infinity;
  return exp(y * log(x));
}

/** sin(x) for |x| <= π/4. */
export function sinSmall(x: number): number {
  const w = x * x;
  let sum = 0;
  for (const c of SIN) {
    sum = sum * w + c;
  }
  return x + x * w * sum;
}

/** cos(x) for |x| <= π/4. */
export function cosSmall(x: number): number {
  const w = x * x;
  let sum = 0;
  for (const c of COS) {
    sum = sum * w + c;
  }
  return 1 - (0.5 * w - w * w * sum);
}

/** −1/3!, 1/5!, … and 1/4!, −1/6!, …, from the last. */
const SIN = [
  1 / 355687428096000,
  -1 / 1307674368000,
  1 / 6227020800,
  -1 / 39916800,
  1 / 362880,
  -1 / 5040,
  1 / 120,
  -1 / 6,
];
const COS = [
  1 / 20922789888000,
  -1 / 87178291200,
  1 / 479001600,
  -1 / 3628800,
  1 / 40320,
  -1 / 720,
  1 / 24,
];

/** The angle of (x, y) from the x axis in radians, −π to π; 0 for (0, 0). */
export function atan2(y: number, x: number): number {
  const a = Math.abs(x);
  const b = Math.abs(y);
  if (a === 0 && b === 0) return 0;
  const first = b <= a ? arctan(b / a) : Math.PI / 2 - arctan(a / b);
  const angle = x < 0 ? Math.PI - first : first;
  return y < 0 ? -angle : angle;
}

/** For 0 to 1: the angle is halved twice, which leaves a short series. */
function arctan(t: number): number {
  const half = t / (1 + Math.sqrt(1 + t * t));
  const z = half / (1 + Math.sqrt(1 + half * half));
  const w = z * z;
  const end = 1 / 17 - w * (1 / 19 - w * (1 / 21 - w * (1 / 23)));
  const middle = 1 / 9 - w * (1 / 11 - w * (1 / 13 - w * (1 / 15 - w * end)));
  return 4 * (z - z * w * (1 / 3 - w * (1 / 5 - w * (1 / 7 - w * middle))));
}

/** The angle from 0 to π whose cosine is x, −1 to 1. */
export const acos = (x: number): number => atan2(Math.sqrt((1 - x) * (1 + x)), x);
