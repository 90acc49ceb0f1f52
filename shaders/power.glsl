// Powers x^k of numbers in [0, 1]. log2 has an absolute error near 1, which the exponent
// multiplies: large exponents need the series, small ones do not.

const float LOG2_E = 1.4426950408889634;

/**
 * x^k for x in [0, 1] and any k >= 0. y = 1 - x is passed too, to its own precision (from a chord,
 * say). k below LEAST_EXPONENT gives 1, 0^0 included; x = 0 gives 0 for any other k.
 */
float powNearOne(float x, float y, float k) {
  if (k < LEAST_EXPONENT) return 1.0;
  if (!(x >= TINY)) return 0.0; // log2 is undefined at 0, and for numbers that a device may flush to 0
  // log(1 - y) = -2 artanh(z), z = y/(2 - y). For y < 1/4, z < 1/7 and the terms after the fourth
  // add up to 2e-8.
  float z = y / (2.0 - y);
  float z2 = z * z;
  float series = -2.0 * LOG2_E * z * (1.0 + z2 * (1.0 / 3.0 + z2 * (1.0 / 5.0 + z2 * (1.0 / 7.0))));
  float log2x = y < 0.25 ? series : log2(x);
  return exp2(k * log2x);
}

/**
 * x^k as powNearOne, for k up to LARGEST_MILD_POWER: log2's error near 1 is too small there to need
 * the series.
 */
float powMild(float x, float k) {
  float power = exp2(k * log2(max(x, TINY)));
  return x >= TINY || k < LEAST_EXPONENT ? power : 0.0;
}

/**
 * The same for k from 1 to LARGEST_MILD_CUTOFF, where a base near 0 gives a result near 0. x may be
 * negative by rounding.
 */
float powFrom1(float x, float k) {
  return exp2(k * log2(max(x, TINY)));
}

/**
 * x^k for an integer k from 1 to LARGEST_INTEGER_POWER. Pass k as a literal: only its
 * multiplications are left then. A relative error of x is multiplied by k.
 */
float powInteger(float x, int k) {
  float result = (k & 1) != 0 ? x : 1.0;
  float square = x * x;
  if ((k & 2) != 0) result *= square;
  square *= square;
  if ((k & 4) != 0) result *= square;
  square *= square;
  if ((k & 8) != 0) result *= square;
  square *= square;
  if ((k & 16) != 0) result *= square;
  square *= square;
  if ((k & 32) != 0) result *= square;
  square *= square;
  return (k & 64) != 0 ? result * square : result;
}
