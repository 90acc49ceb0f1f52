// The equation at a fragment with its numbers put in, and the wrong values that usual mistakes
// give. 1 is full. One notation for everything: "Kd · max(N · L, 0)^8".
import {
  type AnswerDetail,
  type FragmentExplanation,
  type LightExplanation,
  type PhongLight,
  phrase,
  type ViewerTexts,
} from '../../../viewer/extra.js';
import type { LightValues, Term } from '../../../phong/light/light-state.js';
import { radians } from '../../../phong/math/angle.js';
import { srgbDecode, srgbEncode } from '../../../phong/math/color.js';
import { add, clamp, dot, map, normalize, scale, subtract } from '../../../phong/math/vector.js';
import { degreesOf, degreesText, shortNumber, decimals, exponentOf, rounded } from './sum.js';

/**
 * What somebody who makes a usual mistake gets. `text` states only where the number comes from, so
 * it is true.
 */
export interface Wrong {
  readonly mistake: NonNullable<AnswerDetail['mistake']>;
  readonly value: number;
  readonly text: string;
}

/** A term of a light, or the sum, in one channel. */
export interface Equation {
  readonly term: Term | 'sum';
  readonly light: PhongLight | null;
  readonly name: string;
  /** Null: all channels are equal. */
  readonly channel: AnswerDetail['channel'];
  readonly symbols: string;
  /** With what a question gives: coefficients, intensities and the exponent. */
  readonly given: string;
  /** Angles and distance, for a question. */
  readonly facts: string;
  readonly numbers: string;
  readonly value: number;
  readonly result: string;
  readonly wrongs: readonly Wrong[];
}

export interface EquationOptions {
  /** By the index of their shares. */
  readonly lights: readonly Readonly<LightValues>[];
  readonly linear: boolean;
  readonly halfway: boolean;
  readonly terms: readonly Term[];
}

interface Factor {
  readonly symbol: string;
  readonly value: number;
  /** Its number at this many decimals; the value by default. */
  readonly text?: (digits: number) => string;
  readonly isGiven?: boolean;
  readonly given?: string;
  readonly wrongs?: readonly Wrong[];
}

const CHANNELS = ['red', 'green', 'blue'] as const;
const NAMES = { ambient: 'a', diffuse: 'd', specular: 's' } as const;

export function equationsOf(
  fragment: FragmentExplanation,
  options: EquationOptions,
  texts: ViewerTexts | null,
): Equation[] {
  const own = map(fragment.emissive, (x) => (options.linear ? srgbDecode(x) : x));
  const parts = [0, 1, 2].map((channel) => {
    const products = fragment.shares.flatMap((share, i) =>
      share === null
        ? []
        : options.terms
            .filter((term) => isLit(fragment, options.lights[i]!, term))
            .map((term) =>
              product({
                ...options,
                fragment,
                share,
                light: options.lights[i]!,
                term,
                channel: channel as 0,
                texts,
              }),
            ),
    );
    return [
      ...products,
      sumLine(products, own[channel]!, fragment.color[channel]!, options.linear, texts),
    ];
  });
  return parts[0]!.flatMap((first, i) => {
    const each = parts.map((equations) => equations[i]!);
    if (
      each.every(
        ({ numbers, value }) => numbers === first.numbers && Math.abs(value - first.value) < 1e-9,
      )
    ) {
      return [first];
    }
    return each.map((equation, c) => ({ ...equation, channel: CHANNELS[c]! }));
  });
}

/** A black coefficient or intensity has no equation. */
const isLit = (fragment: FragmentExplanation, light: Readonly<LightValues>, term: Term): boolean =>
  light[term].some((x, channel) => x > 0 && fragment[`k${NAMES[term]}`][channel]! > 0);

/** One term of a light in one channel. */
interface TermAt extends EquationOptions {
  readonly fragment: FragmentExplanation;
  readonly share: LightExplanation;
  readonly light: Readonly<LightValues>;
  readonly term: Term;
  readonly channel: 0 | 1 | 2;
  readonly texts: ViewerTexts | null;
}

function factorsOf({
  fragment,
  share,
  light,
  term,
  channel,
  linear,
  halfway,
  texts,
}: TermAt): readonly Factor[] {
  const intensity = light[term][channel] / 255;
  const factors: Factor[] = [
    { symbol: `K${NAMES[term]}`, value: fragment[`k${NAMES[term]}`][channel], isGiven: true },
    { symbol: `I${NAMES[term]}`, value: linear ? srgbDecode(intensity) : intensity, isGiven: true },
  ];
  const wrongOf = wrongIn(texts);
  const instead = (wrong: string, right: string, value: number): Wrong =>
    wrongOf('other-value', value, 'That is the value with {wrong} in place of {right}.', {
      wrong,
      right,
    });
  const { att, decay, c, insideCone, NoL, RoV, L } = share;
  if (term === 'ambient') {
    const text = 'The attenuation does not touch the ambient term.';
    factors.push({ symbol: '', value: 1, wrongs: [wrongOf('attenuation', att, text)] });
  } else if (att !== 1) {
    factors.push({ symbol: 'att', value: att, wrongs: [instead('1 / att', 'att', 1 / att)] });
  }
  if (!insideCone) {
    const wrongs = [decay, 1].map((value) =>
      wrongOf('cone', value, 'The point is outside the cone.'),
    );
    factors.push({ symbol: 'decay', value: 0, wrongs });
  } else if (decay !== 1 || light.aperture < 180) {
    const wrongs = [
      instead(`c^${light.cutoff}`, `((1 + c) / 2)^${light.cutoff}`, Math.max(c, 0) ** light.cutoff),
    ];
    if (degreesOf(c) > light.aperture / 2) {
      wrongs.push(
        wrongOf(
          'aperture',
          0,
          'The aperture is the angle from the axis to the edge, not across the cone.',
        ),
      );
    }
    factors.push({ symbol: 'decay', value: decay, wrongs });
  }
  const cosineWrongs = (symbol: string, cosine: number, power: number): Wrong[] => {
    const degrees = degreesOf(cosine);
    const angle = degreesText(cosine, 1, texts);
    const radiansText = 'That is the cosine of {angle} radians; the angle is in degrees.';
    return [
      ...(cosine < 0 ? [without(texts, 'max(…, 0)', cosine ** power, 'unclamped')] : []),
      ...[degrees, radians(degrees)].map((value) =>
        wrongOf('angle', value ** power, '{cosine} is a cosine: the angle is {angle}.', {
          cosine: symbol,
          angle,
        }),
      ),
      wrongOf('radians', Math.cos(degrees) ** power, radiansText, { angle: angle.slice(0, -1) }),
      { ...instead('sin', 'cos', Math.sin(radians(degrees)) ** power), mistake: 'sine' },
    ];
  };
  const clamped = (cosine: number) => (digits: number) => {
    const text = shortNumber(cosine, digits, texts);
    return cosine < 0 ? `max(${text}, 0)` : text;
  };
  if (term === 'diffuse') {
    factors.push({
      symbol: 'max(N · L, 0)',
      value: Math.max(NoL, 0),
      text: clamped(NoL),
      wrongs: cosineWrongs('N · L', NoL, 1),
    });
  }
  if (term === 'specular') {
    const n = exponentOf(fragment.shininess);
    const exponent = shortNumber(n, Number.isInteger(n) ? 0 : 2, texts);
    const [symbol, other] = halfway ? ['N · H', 'R · V'] : ['R · V', 'N · H'];
    const { N, V } = fragment;
    const otherCosine = halfway
      ? dot(subtract(scale(N, 2 * NoL), L), V)
      : dot(N, normalize(add(L, V)));
    const power = (x: number): number => (n === 0 ? 1 : Math.max(x, 0) ** n);
    const isBehind = NoL <= 0;
    const bare = Math.max(RoV, 0);
    factors.push({
      symbol: `max(${symbol}, 0)^n`,
      given: `max(${symbol}, 0)^${exponent}`,
      value: isBehind ? 0 : power(RoV),
      text: (digits) =>
        isBehind ? shortNumber(0, 0, texts) : `${clamped(RoV)(digits)}^${exponent}`,
      wrongs: isBehind
        ? [wrongOf('behind', power(RoV), 'The light is behind the surface: no highlight.')]
        : [
            instead(other, symbol, power(otherCosine)),
            wrongOf('exponent', bare, 'That is the value without the exponent {n}.', {
              n: exponent,
            }),
            wrongOf('times-exponent', n * RoV, 'The exponent is a power, not a factor.'),
            instead('N · L', symbol, power(NoL)),
            ...cosineWrongs(symbol, RoV, n),
          ],
    });
  }
  return factors;
}

function product(of: TermAt): Equation {
  const { fragment, share, light, term, halfway, texts } = of;
  const { decay, RoV } = share;
  const factors = factorsOf(of);
  const value = factors.reduce((all, factor) => all * factor.value, 1);
  const wrongs = factors.flatMap((factor) => {
    const rest = factors.reduce((all, each) => (each === factor ? all : all * each.value), 1);
    const { symbol, wrongs: own = [] } = factor;
    const all =
      symbol === '' || own[0]?.mistake === 'cone'
        ? own
        : [without(texts, symbol, 1, 'left-out'), ...own];
    return all.map((wrong) => ({ ...wrong, value: rest * wrong.value }));
  });
  const shown = factors.filter(({ symbol }) => symbol !== '');
  const numberOf = (factor: Factor, digits: number): string =>
    factor.text?.(digits) ??
    shortNumber(factor.value, factor.value === 0 || factor.value === 1 ? 0 : digits, texts);
  // As many decimals as make the product of the rounded numbers round to the result.
  const roundedTo = ({ symbol, value: x }: Factor, digits: number): number =>
    symbol.endsWith('^n') && x > 0
      ? Math.max(rounded(RoV, digits), 0) ** fragment.shininess
      : rounded(x, digits);
  const isTrue = (digits: number): boolean =>
    Math.abs(shown.reduce((all, factor) => all * roundedTo(factor, digits), 1) - value) < 0.005;
  const digits = decimals(2, isTrue);
  return {
    term,
    light: share.light,
    name: share.name,
    channel: null,
    value,
    wrongs,
    facts: term === 'ambient' && decay === 1 ? '' : factsOf(share, light, term, halfway, texts),
    symbols: shown.map(({ symbol }) => symbol).join(' · '),
    given: shown
      .map(
        (factor) => factor.given ?? (factor.isGiven === true ? numberOf(factor, 4) : factor.symbol),
      )
      .join(' · '),
    numbers: shown.map((factor) => numberOf(factor, digits)).join(' · '),
    result: resultText(value, texts),
  };
}

const wrongIn =
  (texts: ViewerTexts | null) =>
  (
    mistake: Wrong['mistake'],
    value: number,
    text: keyof ViewerTexts,
    values: Readonly<Record<string, string>> = {},
  ): Wrong => ({ mistake, value, text: phrase(texts, text, values) });

const without = (
  texts: ViewerTexts | null,
  factor: string,
  value: number,
  mistake: Wrong['mistake'],
): Wrong => wrongIn(texts)(mistake, value, 'That is the value without {factor}.', { factor });

function factsOf(
  { NoL, RoV, d, c, att, decay, insideCone }: LightExplanation,
  { attenuation, aperture, cutoff }: Readonly<LightValues>,
  term: Term,
  halfway: boolean,
  texts: ViewerTexts | null,
): string {
  const number = (x: number): string => {
    const isClose = (digits: number): boolean => Math.abs(rounded(x, digits) - x) <= 0.0005 * x;
    return shortNumber(x, decimals(0, isClose), texts);
  };
  const facts: string[] = [];
  if (term === 'diffuse') {
    facts.push(`N ∠L ${degreesText(NoL, 1, texts)}`);
  }
  if (term === 'specular') {
    facts.push(`${halfway ? 'N ∠H' : 'R ∠V'} ${degreesText(RoV, 2, texts)}`);
  }
  if (term !== 'ambient' && att !== 1) {
    const sum = ['', ' d', ' d²'].flatMap((power, i) =>
      attenuation[i] === 0 ? [] : `${number(attenuation[i]!)}${power}`,
    );
    facts.push(`d = ${number(d)}`, `att = 1 / (${sum.join(' + ')})`);
  }
  if (decay !== 1 || !insideCone) {
    facts.push(
      `${phrase(texts, 'axis')} ∠L ${degreesText(c, 1, texts)}`,
      `${phrase(texts, 'aperture °').replace(/\s*°$/, '')} ${number(aperture)}°`,
      `${phrase(texts, 'cutoff')} ${number(cutoff)}`,
    );
  }
  return facts.join(', ');
}

function sumLine(
  parts: readonly Equation[],
  own: number,
  value: number,
  linear: boolean,
  texts: ViewerTexts | null,
): Equation {
  const total = parts.reduce((all, part) => all + part.value, own);
  const encode = (x: number): number => (linear ? srgbEncode(Math.max(x, 0)) : x);
  const finish = (x: number): number => clamp(encode(x), 0, 1);
  const without = (factor: string, x: number, mistake: Wrong['mistake'] = 'left-out'): Wrong =>
    wrongIn(texts)(mistake, x, 'That is the value without {factor}.', { factor });
  const wrongs: Wrong[] = [without('min(…, 1)', encode(total), 'unclamped')];
  if (linear) {
    wrongs.push(without(phrase(texts, 'encoded'), total));
  }
  if (own > 0) {
    wrongs.push(without('E', finish(total - own)));
  }
  for (const part of parts) {
    const rest = total - part.value;
    if (part.value > 0) {
      wrongs.push(without(`${phrase(texts, part.term)} (${part.name})`, finish(rest)));
    }
    for (const wrong of part.wrongs) {
      wrongs.push({ ...wrong, value: finish(rest + wrong.value) });
    }
  }
  const list = [...parts.map((part) => part.result), ...(own > 0 ? [resultText(own, texts)] : [])];
  const inner = list.length === 0 ? '0' : list.join(' + ');
  const isClamped = encode(total) > 1;
  return {
    term: 'sum',
    light: null,
    name: '',
    channel: null,
    value,
    wrongs,
    facts: '',
    symbols: own > 0 ? 'Σ + E' : 'Σ',
    given: own > 0 ? 'Σ + E' : 'Σ',
    numbers: linear ? `sRGB(${inner})` : isClamped ? `min(${inner}, 1)` : inner,
    result: resultText(value, texts),
  };
}

/** Two decimals, or up to four where these would be zeros. */
const resultText = (value: number, texts: ViewerTexts | null): string => {
  const isShown = (digits: number): boolean =>
    digits === 4 || Math.abs(value) >= 0.5 * 10 ** (1 - digits);
  return shortNumber(value, value === 0 || value === 1 ? 0 : decimals(2, isShown), texts);
};

export type Verdict = Pick<AnswerDetail, 'value' | 'correct' | 'mistake'> & {
  readonly text: string;
};

/** Nobody sees this difference: an eighth of a code. */
const UNSEEN = 0.0005;

/** Rounding of given numbers on the way: a share of the value. */
const SLACK = 0.002;

export function judge(
  typed: string,
  { value, wrongs }: Equation,
  texts: ViewerTexts | null,
): Verdict {
  const match = /^([+-]?(?:\d+\.?\d*|\.\d+))\s*(%?)$/.exec(
    typed.trim().replace('−', '-').replace(',', '.'),
  );
  if (match === null) {
    return {
      value: null,
      correct: false,
      mistake: null,
      text: phrase(texts, 'Type a number, such as 0.35.'),
    };
  }
  const [, number = '', percent] = match;
  const unit = 10 ** -(number.split('.')[1]?.length ?? 0) / (percent === '%' ? 100 : 1);
  const answer = Number(number) / (percent === '%' ? 100 : 1);
  const isNear = (x: number): boolean =>
    Math.abs(answer - x) <= Math.max(0.5 * unit, SLACK * Math.abs(x)) * (1 + 1e-9) + 1e-12;
  /** Digits that would fit many numbers. */
  const isCoarse = (x: number): boolean =>
    Math.abs(answer - x) > UNSEEN && 0.5 * unit > 0.1 * Math.abs(x) + 0.001;
  // A bare 0 is an answer, not a rounded one.
  if (isNear(value) && !(answer === 0 && isCoarse(value))) {
    const correct = !isCoarse(value);
    const text = phrase(texts, correct ? 'Right.' : 'Right so far: give more digits.');
    return { value: answer, correct, mistake: correct ? null : 'digits', text };
  }
  const scaled = [255, 255 * 255, 100].map((full) =>
    wrongIn(texts)('scale', value * full, 'Here 1 is full, not {number}.', {
      number: shortNumber(full, 0, texts),
    }),
  );
  const found = [...wrongs, ...(value === 0 ? [] : scaled)].filter(
    (wrong) => isNear(wrong.value) && !isCoarse(wrong.value),
  );
  const said = [...new Set(found.map(({ text }) => text))].slice(0, 2);
  const difference = resultText(Math.abs(answer - value), texts);
  const side =
    answer > value ? 'Not yet: too large by {difference}.' : 'Not yet: too small by {difference}.';
  const text =
    said.length > 0 ? said.join(` ${phrase(texts, 'Or:')} `) : phrase(texts, side, { difference });
  return { value: answer, correct: false, mistake: found[0]?.mistake ?? null, text };
}
