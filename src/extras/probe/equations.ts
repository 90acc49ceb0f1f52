// The equation at a fragment with its numbers put in: one line for each term of each light, for all
// three channels, and one for the sum. 1 is full. The digits shown give the digits shown.
import {
  type FragmentExplanation,
  localNumber,
  type PhongLight,
  phrase,
  type ViewerTexts,
} from '../../viewer/extra.js';
import {
  falloff,
  LIGHT_FIELDS,
  type LightValues,
  type Term,
  type ShadedValue,
} from '../../phong/light/light-state.js';
import { cosDegrees } from '../../phong/math/angle.js';
import { srgbEncode } from '../../phong/math/color.js';
import { add, clamp, map, multiply, type Vec3 } from '../../phong/math/vector.js';
import { lampOf, power } from '../../phong/mistakes/steps.js';
import { decoded, sumOf } from '../../phong/reference/equation.js';
import {
  decimals,
  degreesOf,
  exponentOf,
  rounded,
  type LightExplanation,
} from '../overlay/probe/sum.js';

export interface EquationOptions {
  /** By the index of their shares. */
  readonly lights: readonly Readonly<LightValues>[];
  readonly linear: boolean;
  readonly halfway: boolean;
  readonly terms: readonly Term[];
}

/** A term of a light, or the sum. */
export interface Equation {
  readonly term: Term | 'sum';
  readonly light: PhongLight | null;
  readonly name: string;
  readonly symbols: string;
  readonly numbers: string;
  readonly result: string;
  /** `≈` where four digits of the numbers do not give the result. */
  readonly sign: '=' | '≈';
  readonly value: Vec3;
  /** Null for the sum. */
  readonly at: TermAt | null;
  readonly factors: readonly Factor[];
}

/** One term of a light at a fragment. */
export interface TermAt {
  readonly fragment: FragmentExplanation;
  readonly share: LightExplanation;
  readonly light: Readonly<LightValues>;
  readonly term: Term;
  readonly linear: boolean;
  readonly halfway: boolean;
  readonly texts: ViewerTexts | null;
}

/** Why a question can be answered: a number of the scene, from which the factor follows. */
interface Fact {
  text(digits: number): string;
  /** The factor that follows from the rounded number. */
  value(digits: number): number;
}

export interface Factor {
  readonly symbol: string;
  readonly value: Vec3;
  /** The exponent, where a power is shown. */
  readonly exponent?: number;
  /** A negative number is shown as max(…, 0). */
  readonly clamped?: boolean;
  /** A question gives the number itself. */
  readonly given?: boolean;
  readonly fact?: Fact;
}

/** The most digits of a number that a reader computes with. */
const MOST = 4;

const NAMES = { ambient: 'a', diffuse: 'd', specular: 's' } as const;

export const coefficientOf = (fragment: FragmentExplanation, term: Term): Vec3 =>
  fragment[`k${NAMES[term]}`];

export function equationsOf(
  fragment: FragmentExplanation,
  options: EquationOptions,
  texts: ViewerTexts | null,
): Equation[] {
  const { lights, linear, halfway, terms } = options;
  const lines = fragment.shares.flatMap((share, i) => {
    const light = lights[i];
    if (share === null || light === undefined) return [];
    return terms
      .filter((term) => multiply(light[term], coefficientOf(fragment, term)).some((x) => x > 0))
      .map((term) => product({ fragment, share, light, term, linear, halfway, texts }));
  });
  return [...lines, sumLine(lines, fragment, linear, texts)];
}

type FactorOf = (at: TermAt) => Factor | null;

const intensity: FactorOf = ({ light, term, linear }) => ({
  symbol: `I${NAMES[term]}`,
  value: lampOf(light, linear)[term],
  given: true,
});

/**
 * The factor that each value of a light makes, in the order of the formula; null where it is 1, or
 * where another one includes it. A value of the equation without an entry does not compile, and
 * LIGHT_FIELDS says which terms it enters.
 */
const FACTORS: Readonly<Record<ShadedValue, FactorOf | null>> = {
  ambient: intensity,
  diffuse: intensity,
  specular: intensity,
  attenuation: attenuationAt,
  cutoff: decayAt,
  axis: null, // in the decay
  aperture: null, // in the decay
  position: cosineAt,
};

function factorsOf(at: TermAt): Factor[] {
  const { fragment, term } = at;
  const factors: Factor[] = [
    { symbol: `K${NAMES[term]}`, value: coefficientOf(fragment, term), given: true },
  ];
  for (const [key, factorOf] of Object.entries(FACTORS)) {
    const terms: readonly Term[] = LIGHT_FIELDS[key as ShadedValue].shading.terms;
    const factor = terms.includes(term) ? factorOf?.(at) : null;
    if (factor) {
      factors.push(factor);
    }
  }
  return factors;
}

function attenuationAt({ share: { att, d }, light }: TermAt): Factor | null {
  const [kc, kl, kq] = light.attenuation;
  const isFading = light.position[3] === 1 && (kl > 0 || kq > 0);
  if (att === 1 && !isFading) return null;
  const parts = [kc, kl, kq].flatMap((k, i) => {
    const power = ['', 'd', 'd²'][i]!;
    if (k === 0) return [];
    return k === 1 && i > 0 ? power : `${exact(k)}\u00a0${power}`.trim();
  });
  const formula = `att = 1 / max(${parts.join(' + ')}, 1)`;
  return {
    symbol: 'att',
    value: grey(att),
    fact: {
      text: (digits) => (isFading ? `d = ${plain(d, digits)}, ${formula}` : formula),
      value: (digits) => 1 / Math.max(falloff(light, rounded(d, digits)), 1),
    },
  };
}

function decayAt({ share: { decay, c, insideCone }, light, texts }: TermAt): Factor | null {
  const hasCone = light.aperture < 180;
  if (insideCone && decay === 1 && !hasCone) return null;
  const angle = degreesOf(c);
  const axis = phrase(texts, 'axis');
  const aperture = phrase(texts, 'aperture °').replace(/\s*°$/, '');
  return {
    symbol: 'decay',
    value: grey(insideCone ? decay : 0),
    fact: {
      text: (digits) => {
        const degrees = `${plain(angle, digits)}°`;
        const cone = hasCone ? `, ${aperture} ${exact(light.aperture)}°` : '';
        return `∠(L,\u00a0−${axis}) = ${degrees}${cone}, decay = ((1 + cos ${degrees}) / 2)^${exact(light.cutoff)}`;
      },
      value: (digits) => {
        const x = rounded(angle, digits);
        if (hasCone && x > light.aperture) return 0;
        return power((1 + cosDegrees(x)) / 2, light.cutoff);
      },
    },
  };
}

function cosineAt({ fragment, share: { NoL, RoV }, term, halfway }: TermAt): Factor | null {
  if (term === 'ambient') return null;
  const cosine = (name: string, x: number, n: number): Fact => ({
    text: (digits) => `∠(${name}) = ${plain(degreesOf(x), digits)}°`,
    value: (digits) => power(cosDegrees(rounded(degreesOf(x), digits)), n),
  });
  const incidence = cosine('N,\u00a0L', NoL, 1);
  if (term === 'diffuse') {
    return { symbol: 'max(N · L, 0)', value: grey(NoL), clamped: true, fact: incidence };
  }
  const exponent = exponentOf(fragment.shininess);
  const symbol = `max(${halfway ? 'N · H' : 'R · V'}, 0)^n`;
  if (NoL <= 0) return { symbol, value: grey(0), fact: { ...incidence, value: () => 0 } };
  const fact = cosine(halfway ? 'N,\u00a0H' : 'R,\u00a0V', RoV, exponent);
  return {
    symbol,
    value: grey(RoV),
    clamped: true,
    exponent: Number(exact(exponent)), // as it is shown
    fact,
  };
}

const grey = (x: number): Vec3 => [x, x, x];

export const valueOf = ({ value, exponent, clamped }: Factor, channel: number): number => {
  const x = value[channel]!;
  if (exponent !== undefined) return power(x, exponent);
  return clamped === true ? Math.max(x, 0) : x;
};

/** Digits and a point; a number of the author in full. */
const exact = (x: number) => String(Number(x.toPrecision(6)));

/** 0 and 1 are exact. Extreme numbers are powers of ten. */
export function plain(x: number, digits: number): string {
  if (x === 0 || x === 1) return String(x);
  return Math.abs(x) < 1e6 ? x.toFixed(digits) : x.toExponential(digits);
}

/** The three channels' numbers. */
const textsOf = (color: Vec3, digits: number): readonly string[] =>
  [...color].map((x) => plain(x, digits).replace(/^-(0(\.0*)?)$/, '$1'));

/** One where they are the same. */
const joined = (texts: readonly string[]) =>
  new Set(texts).size === 1 ? texts[0]! : `(${texts.join(' ')})`;

function factorText({ value, exponent, clamped }: Factor, digits: number): string {
  const text = joined(textsOf(value, digits));
  const base = clamped === true && value[0] < 0 ? `max(${text}, 0)` : text;
  return exponent === undefined ? base : `${base}^${exact(exponent)}`;
}

/** What a reader computes with. */
const shownValue = (factor: Factor, digits: number, channel: number): number => {
  const x = Number(textsOf(factor.value, digits)[channel]);
  return valueOf({ ...factor, value: grey(x) }, 0);
};

/** Typographic minus, and the digits of the language. */
export const local = (text: string, texts: ViewerTexts | null) =>
  localNumber(text.replace(/-(?=\d)/g, '−'), texts);

/** Two digits that are not zeros, of the least channel that is not black: two to four decimals. */
const resultDigits = (value: Vec3) =>
  decimals(
    2,
    (n) => n === MOST || value.every((x) => x === 0 || Math.abs(x) >= 0.95 * 10 ** (1 - n)),
  );

/**
 * The least digits whose numbers give the result, up to {@link MOST}. `computed`: what a reader
 * gets with that many.
 */
function fitted(
  value: Vec3,
  computed: (digits: number, channel: number) => number,
): Pick<Equation, 'result' | 'sign'> & { readonly digits: number } {
  const places = resultDigits(value);
  const results = textsOf(value, places);
  const isTrue = (digits: number) =>
    value.every((_, channel) => {
      const result = Number(results[channel]);
      const size = Math.floor(Math.log10(Math.max(Math.abs(result), 1)));
      const unit = 10 ** ((size < 6 ? 0 : size) - places);
      // Half a digit of the result, and what float64 rounds in a product.
      return Math.abs(computed(digits, channel) - result) <= (0.5 + 1e-9) * unit;
    });
  let digits = 2;
  while (digits < MOST && !isTrue(digits)) {
    digits += 1;
  }
  // What is there, however little, is not 0.
  const isNothing = value.some((x, i) => x !== 0 && Number(results[i]) === 0);
  return { digits, result: joined(results), sign: isTrue(digits) && !isNothing ? '=' : '≈' };
}

function product(at: TermAt): Equation {
  const { share, term, texts } = at;
  const factors = factorsOf(at);
  // What is drawn, not the product: with a factor too few the line would say ≈.
  const value = share[term];
  const { digits, result, sign } = fitted(value, (n, channel) =>
    factors.reduce((all, factor) => all * shownValue(factor, n, channel), 1),
  );
  return {
    term,
    light: share.light,
    name: share.name,
    symbols: factors.map(({ symbol }) => symbol).join(' · '),
    numbers: local(factors.map((factor) => factorText(factor, digits)).join(' · '), texts),
    result: local(result, texts),
    sign,
    value,
    at,
    factors,
  };
}

/** The sum as it is drawn: encoded, then clamped. */
export const drawn = (sum: Vec3, linear: boolean): Vec3 =>
  map(sum, (x) => clamp(linear ? srgbEncode(x) : x, 0, 1));

export const ownOf = ({ emissive }: FragmentExplanation, linear: boolean): Vec3 =>
  decoded(emissive, linear);

function sumLine(
  lines: readonly Equation[],
  fragment: FragmentExplanation,
  linear: boolean,
  texts: ViewerTexts | null,
): Equation {
  const own = ownOf(fragment, linear);
  const parts = lines.map((line) => line.value);
  const isGlowing = own.some((x) => x > 0);
  if (isGlowing) {
    parts.push(own);
  }
  const total = parts.reduce(add, grey(0));
  const value = drawn(total, linear);
  const { digits, result, sign } = fitted(value, (n, channel) => {
    const sum = parts.reduce((all, part) => all + Number(textsOf(part, n)[channel]), 0);
    return drawn(grey(sum), linear)[0];
  });
  const inner = parts.map((part) => joined(textsOf(part, digits))).join(' + ') || '0';
  const encoded = linear ? `sRGB(${inner})` : inner;
  const isClamped = total.some((x) => x > 1);
  return {
    term: 'sum',
    light: null,
    name: '',
    symbols: isGlowing ? 'Σ + E' : 'Σ',
    numbers: local(isClamped ? `min(${encoded}, 1)` : encoded, texts),
    result: local(result, texts),
    sign,
    value,
    at: null,
    factors: [],
  };
}

export const CHANNELS = ['red', 'green', 'blue'] as const;

/**
 * The channel in which most of the lines are to be seen, and of such channels the brightest: by so
 * small a power a dim line counts nearly as much as a bright one.
 */
export function askedChannel(lines: readonly Equation[]): number {
  const seen = lines.map(({ value }) => map(value, (x) => x ** 0.01)).reduce(add);
  return seen.indexOf(Math.max(...seen));
}

export const isGrey = ({ value: [r, g, b] }: Equation) =>
  Math.abs(r - g) < 1e-9 && Math.abs(g - b) < 1e-9;

/** The light, the term, and the channel where channels differ. */
export const titleOf = (
  equation: Equation,
  channel: number | null,
  texts: ViewerTexts | null,
): string => {
  const { name, term } = equation;
  const color = channel === null || isGrey(equation) ? '' : phrase(texts, CHANNELS[channel]!);
  return [name, phrase(texts, term), color].filter((part) => part !== '').join(' · ');
};

/** Share of a factor by which the number that a question gives may change it. */
const EXACT = 0.00025;

/** What a question gives of a term: numbers, and facts from which the other factors follow. */
export function givenOf(
  { factors, at }: Equation,
  channel: number,
): { readonly given: string; readonly facts: string; readonly values: readonly number[] } {
  const texts = at?.texts ?? null;
  const facts: string[] = [];
  const values: number[] = [];
  const given = factors.map((factor) => {
    const value = valueOf(factor, channel);
    const isClose = (x: number) => Math.abs(x - value) <= EXACT * Math.abs(value);
    if (factor.given === true) {
      const digits = decimals(2, (n) => isClose(rounded(value, n)));
      values.push(Number(plain(value, digits)));
      return plain(value, digits);
    }
    const { fact, symbol } = factor;
    if (fact !== undefined) {
      const digits = decimals(symbol === 'att' ? 0 : 1, (n) => isClose(fact.value(n)));
      facts.push(fact.text(digits));
      values.push(fact.value(digits));
    }
    return symbol.replace(/n$/, exact(exponentOf(at!.fragment.shininess)));
  });
  return {
    given: local(given.join(' · '), texts),
    facts: local(facts.join(', '), texts),
    values,
  };
}

/** The same fragment with other coefficients, and all terms as these make them. */
export function withCoefficients(
  fragment: FragmentExplanation,
  linear: boolean,
  change: (k: Vec3) => Vec3,
): FragmentExplanation {
  const { ka, kd, ks } = fragment;
  const next = { ka: change(ka), kd: change(kd), ks: change(ks) };
  const again = (term: Vec3, k: Vec3, now: Vec3) =>
    multiply(term, [0, 1, 2].map((i) => (k[i] === 0 ? 0 : now[i]! / k[i]!)) as unknown as Vec3);
  const shares = fragment.shares.map(
    (share) =>
      share && {
        ...share,
        ambient: again(share.ambient, ka, next.ka),
        diffuse: again(share.diffuse, kd, next.kd),
        specular: again(share.specular, ks, next.ks),
      },
  );
  return { ...fragment, ...next, shares, ...sumOf(shares, fragment, linear) };
}
