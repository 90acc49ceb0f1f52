// The worst driver that is still lawful: the same GLSL with each built-in replaced by one that errs
// by its whole allowance, and gives NaN wherever its result is undefined. Allowances are those of
// the Vulkan specification for 32-bit floats ("Precision and Operation of SPIR-V Instructions"),
// which WebGL's own only loosen.

/** Which way results err: all up, all down, or either way by chance, as their bits fall. */
export type Driver = 'shipped' | 'up' | 'down' | 'either';
export const WORST_DRIVERS = ['up', 'down', 'either'] as const satisfies readonly Driver[];

/**
 * Statements for the end of a pass: NaN where any result was undefined, even one that nothing came
 * of here. It could have been any number, and a compiler that assumes no NaN is free to decide by
 * it.
 */
export const spoiledBy = (driver: Driver): string =>
  driver === 'shipped' ? '' : '\n  if (worst_undefined) result = vec4(worst_nan());';

/**
 * Largest error of x^k for x to 1 and exponents to `most`, by log2's allowance of 2^-21. Twice: a
 * worst driver errs on top of the driver that runs it.
 */
export const mildPowerError = (most: number): number => 2 * most * Math.LN2 * 2 ** -21;

const SIGN: Readonly<Record<Exclude<Driver, 'shipped'>, string>> = {
  up: '1',
  down: '-1',
  either: '((uint(floatBitsToInt(x)) * 2654435761u) >> 31) == 0u ? 1 : -1',
};

const REPLACED = [
  'exp2',
  'log2',
  'inversesqrt',
  'sqrt',
  'sin',
  'cos',
  'pow',
  'exp',
  'log',
] as const;

/** `glsl` on the worst driver; what cannot be made worse yet (another built-in) throws. */
export function onDriver(glsl: string, driver: Driver): string {
  if (driver === 'shipped') return glsl;
  const bare = glsl.replace(/\/\*[^]*?\*\/|\/\/[^\n]*/g, ' ');
  const unknown =
    /\b(tan|asin|acos|atan|sinh|cosh|tanh|normalize|length|distance|reflect|refract|mod)\s*\(/.exec(
      bare,
    );
  if (unknown !== null) throw new Error(`no allowance is known here for ${unknown[1]!}`);
  const renamed = bare.replace(new RegExp(`\\b(${REPLACED.join('|')})\\s*\\(`, 'g'), 'worst_$1(');
  return worstBuiltIns(driver) + divisionsAsCalls(renamed);
}

/**
 * `a / b` as `worst_divide(a, b)`; directives are left alone. Operands are names, numbers, calls
 * and parentheses.
 */
export function divisionsAsCalls(glsl: string): string {
  return glsl
    .split(/(^#.*$)/m)
    .map((part) => (part.startsWith('#') ? part : rewriteDivisions(part)))
    .join('');
}

function rewriteDivisions(text: string) {
  let rest = text;
  for (;;) {
    const at = rest.search(/(?<!\/)\/(?![/=*])/);
    if (at < 0) return rest;
    const from = operandStart(rest, at);
    const to = operandEnd(rest, at + 1);
    const [left, right] = [rest.slice(from, at).trim(), rest.slice(at + 1, to).trim()];
    rest = `${rest.slice(0, from)}worst_divide(${left}, ${right})${rest.slice(to)}`;
  }
}

const NAME = /[\w.]/;

function operandStart(text: string, slash: number) {
  let i = slash - 1;
  while (/\s/.test(text[i]!)) {
    i -= 1;
  }
  if (text[i] === ')' || text[i] === ']') {
    i = matching(text, i, -1) - 1;
  }
  while (i >= 0 && NAME.test(text[i]!)) {
    i -= 1;
  }
  return i + 1;
}

function operandEnd(text: string, from: number) {
  let i = from;
  while (/\s/.test(text[i]!)) {
    i += 1;
  }
  while (i < text.length && NAME.test(text[i]!)) {
    i += 1;
  }
  if (text[i] === '(' || text[i] === '[') {
    i = matching(text, i, 1) + 1;
  }
  return i;
}

/** The index of the bracket that closes (step 1) or opens (step −1) the one at `i`. */
function matching(text: string, i: number, step: 1 | -1) {
  let depth = 0;
  for (let k = i; k >= 0 && k < text.length; k += step) {
    if ('(['.includes(text[k]!)) {
      depth += step;
    }
    if (')]'.includes(text[k]!)) {
      depth -= step;
    }
    if (depth === 0) return k;
  }
  throw new Error(`unbalanced brackets: ${text.slice(Math.max(0, i - 40), i + 40)}`);
}

function worstBuiltIns(driver: Exclude<Driver, 'shipped'>) {
  return `
const float WORST_LEAST = 1e-37; // smaller numbers may be flushed; literals of 1.2e-38 and less are zero to Firefox on Mesa
bool worst_undefined = false;
float worst_nan() {
  worst_undefined = true;
  return uintBitsToFloat(0x7fc00000u);
}
int worst_sign(float x) { return ${SIGN[driver]}; }
float worst_flush(float x) { return abs(x) < WORST_LEAST ? 0.0 : x; }
/** x off by this many of its last places. */
float worst_ulps(float x, float ulps) {
  if (abs(x) < WORST_LEAST) return 0.0;
  // Away from or toward zero by the bits; the sign is of the value's error, not of its size.
  int steps = int(ulps) * worst_sign(x) * (x < 0.0 ? -1 : 1);
  return worst_flush(intBitsToFloat(floatBitsToInt(x) + steps));
}
float worst_exp2(float x) {
  if (!(abs(x) < 3.4e38)) return worst_nan();
  if (x < -126.0) return 0.0;
  if (x > 127.99) return worst_nan();
  return worst_ulps(exp2(x), 3.0 + 2.0 * abs(x));
}
float worst_log2(float x) {
  if (!(x >= WORST_LEAST && x < 3.4e38)) return worst_nan();
  float exact = log2(x);
  if (x >= 0.5 && x <= 2.0) return exact + float(worst_sign(x)) * 4.76837158203125e-7; // 2^-21
  return worst_ulps(exact, 3.0);
}
float worst_inversesqrt(float x) {
  if (!(x >= WORST_LEAST && x < 3.4e38)) return worst_nan();
  return worst_ulps(inversesqrt(x), 2.0);
}
/** Half a place is left to the rounding of the result itself. */
float worst_divide(float x, float y) {
  // Divisors beyond 2^±126 are undefined.
  if (!(abs(y) >= WORST_LEAST && abs(y) <= 8.507059173023462e37) || !(abs(x) < 3.4e38)) return worst_nan();
  return worst_ulps(x / y, 2.0);
}
vec3 worst_divide(vec3 x, float y) { return vec3(worst_divide(x.x, y), worst_divide(x.y, y), worst_divide(x.z, y)); }
vec3 worst_divide(vec3 x, vec3 y) { return vec3(worst_divide(x.x, y.x), worst_divide(x.y, y.y), worst_divide(x.z, y.z)); }
float worst_sqrt(float x) {
  // Inherited from 1 / inversesqrt(x).
  return x == 0.0 ? 0.0 : worst_divide(1.0, worst_inversesqrt(x));
}
float worst_sin(float x) { return sin(x) + float(worst_sign(x)) * 4.8828125e-4; } // 2^-11
float worst_cos(float x) { return cos(x) + float(worst_sign(x)) * 4.8828125e-4; }
/** Inherited from exp2(y · log2(x)): undefined for x < 0, and for x = 0 as log2 is. */
float worst_pow(float x, float y) { return worst_exp2(y * worst_log2(x)); }
vec3 worst_pow(vec3 x, vec3 y) { return vec3(worst_pow(x.x, y.x), worst_pow(x.y, y.y), worst_pow(x.z, y.z)); }
float worst_exp(float x) { return worst_exp2(x * 1.4426950408889634); }
float worst_log(float x) { return worst_log2(x) * 0.6931471805599453; }
`;
}
