// Judges an answer: right, right but too coarse, or wrong by a mistake that gives this number and
// no other. A diagnosis is given only where the digits typed tell its value from 0, from the right
// one and from those of all other mistakes.
import {
  type AnswerDetail,
  phrase,
  type ViewerText,
  type ViewerTexts,
} from '../../viewer/extra.js';
import { add, cross, normalize, perpendicular, scale, subtract } from '../../phong/math/vector.js';
import { type Form, MISTAKES, type MistakeId, NO_MISTAKE } from '../../phong/mistakes/mistakes.js';
import { isLeftOut, SLIPS, type SlipId } from '../../phong/mistakes/slips.js';
import { evaluate, type Given, lampOf } from '../../phong/mistakes/steps.js';
import { decimals, degreesText, rounded, shortNumber } from '../overlay/probe/sum.js';
import {
  coefficientOf,
  drawn,
  type Equation,
  givenOf,
  local,
  ownOf,
  plain,
  type TermAt,
} from './equations.js';

type AnswerMistake = NonNullable<AnswerDetail['mistake']>;

/** What somebody who makes a usual mistake gets. */
export interface Wrong {
  readonly mistake: AnswerMistake;
  readonly value: number;
  readonly text: string;
}

/** One number that is asked for. */
export interface Question {
  readonly equation: Equation;
  readonly channel: number;
  readonly expected: number;
  readonly wrongs: readonly Wrong[];
  /** What it can be answered from. */
  readonly given: string;
  readonly facts: string;
}

/** Mistakes of a function that can be made on paper too, with the numbers that a question gives. */
const ON_PAPER = [
  'no-clamp',
  'no-gate',
  'light-not-unit',
  'light-reversed',
  'blinn-for-phong',
  'phong-for-blinn',
  'times-for-power',
  'specular-times-cosine',
  'ambient-attenuated',
  'distance-not-squared',
  'attenuation-not-clamped',
  'whole-aperture',
  'no-cone',
  'cutoff-not-shifted',
  'colours-added',
] as const satisfies readonly MistakeId[];

/** Not of the sum. */
export function questionOf(equation: Equation, channel: number): Question {
  return {
    equation,
    channel,
    expected: equation.value[channel]!,
    wrongs: wrongsOf(equation.at!, channel),
    ...givenOf(equation, channel),
  };
}

/** The question for the sum. Only left-out lines are known as mistakes. */
export function sumQuestion(
  equation: Equation,
  lines: readonly Equation[],
  of: Pick<TermAt, 'fragment' | 'linear' | 'texts'>,
  channel: number,
): Question {
  const { fragment, linear, texts } = of;
  const own = ownOf(fragment, linear);
  const total = lines.reduce((all, line) => add(all, line.value), own);
  const without = (factor: string, value: number): Wrong => ({
    mistake: 'left-out',
    value,
    text: phrase(texts, 'That is the value without {factor}.', { factor }),
  });
  const wrongs = lines.map((line) =>
    without(
      `${phrase(texts, line.term)} (${line.name})`,
      drawn(subtract(total, line.value), linear)[channel]!,
    ),
  );
  wrongs.push(
    without('E', drawn(subtract(total, own), linear)[channel]!),
    without(linear ? 'sRGB' : 'min(…, 1)', total[channel]!),
  );
  const x = own[channel]!;
  const sum = x > 0 ? `Σ + ${local(plain(x, 4), texts)}` : 'Σ';
  const given = linear ? `sRGB(${sum})` : sum;
  return { equation, channel, expected: equation.value[channel]!, wrongs, given, facts: '' };
}

function wrongsOf(at: TermAt, channel: number): Wrong[] {
  const { term, texts, share } = at;
  const given = givenAt(at);
  const right = evaluate(given)[term][channel]!;
  const wrong = (mistake: AnswerMistake, sentence: ViewerText, forms: readonly Form[]): Wrong[] =>
    forms.map((form) => ({
      mistake,
      value: evaluate(given, form)[term][channel]!,
      text: phrase(texts, sentence, wordsOf(mistake, at)),
    }));
  const all = [
    ...Object.entries(SLIPS).flatMap(([id, { sentence, forms }]) =>
      wrong(id as SlipId, sentence, forms),
    ),
    ...ON_PAPER.flatMap((id) => wrong(id, MISTAKES[id].sentence, MISTAKES[id].forms)),
    // On paper a negative number is seen, so it is written as often as it is clamped.
    ...wrong('light-reversed', MISTAKES['light-reversed'].sentence, [
      { lambert: ({ NoL }) => -NoL },
    ]),
  ];
  // Steps and explanation are two ways to the same number. Where they part, as between the corners
  // of a triangle, no mistake can be told.
  const isSame = Math.abs(right - share[term][channel]!) <= 1e-6 * Math.abs(right) + 1e-12;
  return isSame ? all.filter(({ value }) => Number.isFinite(value)) : [];
}

/**
 * The same light and point for the steps of the equation. Angles and lengths are those of the
 * scene.
 */
function givenAt({ fragment, share, light, linear, halfway, term }: TermAt): Given {
  const { p, N, V } = fragment;
  const { L, d, c } = share;
  const isPlace = light.position[3] === 1;
  const [x, y, z] = isPlace ? add(p, scale(L, d)) : scale(L, Math.hypot(...light.position));
  // Lights turn with the camera or an object: an axis at the same angle to L.
  const side = normalize(cross(L, perpendicular(L)));
  const axis = add(scale(L, -c), scale(side, Math.sqrt(Math.max(1 - c * c, 0))));
  return {
    light: { ...lampOf(light, linear), position: [x, y, z, isPlace ? 1 : 0], axis },
    material: {
      ka: coefficientOf(fragment, 'ambient'),
      kd: coefficientOf(fragment, 'diffuse'),
      ks: coefficientOf(fragment, 'specular'),
      shininess: fragment.shininess,
    },
    p,
    normal: N,
    eye: add(p, V),
    reflection: halfway ? 'blinn-phong' : 'phong',
    terms: [term],
  };
}

/** The words in braces. */
function wordsOf(
  mistake: AnswerMistake,
  { fragment, share, term, halfway, texts }: TermAt,
): Readonly<Record<string, string>> {
  const name = term[0]!;
  const lobe = halfway ? 'N · H' : 'R · V';
  const cosine = term === 'diffuse' ? 'N · L' : lobe;
  const angle = degreesText(term === 'diffuse' ? share.NoL : share.RoV, 1, texts);
  const power = term === 'diffuse' ? 'max(N · L, 0)' : `max(${lobe}, 0)^n`;
  const factor = {
    'without-coefficient': `K${name}`,
    'coefficient-alone': `K${name}`,
    'without-intensity': `I${name}`,
    'without-att': 'att',
    'without-decay': 'decay',
    'without-cosine': power,
    'cosine-alone': power,
  }[mistake as string];
  const [wrong = '', right = ''] =
    {
      sine: ['sin', 'cos'],
      'lambert-for-lobe': ['N · L', lobe],
      'att-inverted': ['1 / att', 'att'],
    }[mistake as string] ?? [];
  const n = shortNumber(fragment.shininess, Number.isInteger(fragment.shininess) ? 0 : 2, texts);
  return {
    factor: factor ?? '',
    wrong,
    right,
    cosine,
    n,
    angle: mistake === 'radians' ? angle.slice(0, -1) : angle,
    number: shortNumber(255, 0, texts),
  };
}

export type Verdict = Pick<AnswerDetail, 'value' | 'correct' | 'mistake'> & {
  readonly text: string;
};

interface Typed {
  readonly value: number;
  /** The value of its last digit; 0 for a fraction, which is exact. */
  readonly unit: number;
}

/**
 * A number as people write it: any script's digits, a comma, percent, a fraction, a power of ten.
 * Null for none.
 */
export function typedNumber(text: string): Typed | null {
  const plain = text
    .replace(/(?<=\p{Nd})(?=[\p{No}⁻])/u, '^') // 10⁻³ is a power, 1½ no fraction of 11
    .normalize('NFKC') // full width, ½
    .trim()
    .replace(/(?<!\p{Nd})۰\//u, '0.') // Persian keyboards have no other decimal sign
    .replace(/\p{Nd}/gu, digitOf)
    .replace(/[−–]/g, '-')
    .replace(/[,٫،]/g, '.')
    .replace('٪', '%')
    .replace('⁄', '/')
    .replace(/^[=≈~]\s*|\.$/g, '')
    .replace(/^%\s*(.*)/, '$1%') // Turkish and Basque
    .replace(/\s*[·⋅×x*]\s*10\s*\^\s*(?=[+-]?\d+$)/, 'e');
  const match =
    /^([+-]?(?:\d+\.?\d*|\.\d+))(?:e([+-]?\d+))?\s*(?:(%)|\/\s*(\d+\.?\d*|\.\d+))?$/i.exec(plain);
  if (match === null) return null;
  const [, number = '', power = '0', percent, under] = match;
  const by = (percent === undefined ? Number(under ?? 1) : 100) / 10 ** Number(power);
  const value = Number(number) / by;
  if (!Number.isFinite(value)) return null;
  const unit = under === undefined ? 10 ** -(number.split('.')[1]?.length ?? 0) / by : 0;
  return { value, unit };
}

/**
 * 0 to 9 of a decimal digit. The digits of a script follow each other in Unicode, from its 0 on.
 */
function digitOf(digit: string): string {
  const code = digit.codePointAt(0)!;
  let value = 0;
  while (/\p{Nd}/u.test(String.fromCodePoint(code - value - 1))) {
    value += 1;
  }
  return String(value % 10);
}

/** Nobody sees this difference: an eighth of a code. */
const UNSEEN = 0.0005;

/**
 * Rounding of given numbers on the way: a share of the value. It adds to the rounding of what is
 * typed: 0.1015, computed from rounded numbers, may be typed as 0.102 where 0.10149 is right.
 */
const SLACK = 0.002;

export function judge(typed: string, question: Question, texts: ViewerTexts | null): Verdict {
  const number = typedNumber(typed);
  if (number === null) {
    const text = phrase(texts, 'Type a number, such as 0.35.');
    return { value: null, correct: false, mistake: null, text };
  }
  const { value, unit } = number;
  const { expected } = question;
  const isNear = (x: number) =>
    Math.abs(value - x) <= (0.5 * unit + SLACK * Math.abs(x)) * (1 + 1e-9) + 1e-12;
  /** Digits that would fit many numbers. */
  const isCoarse = (x: number, by = 0.5) =>
    Math.abs(value - x) > UNSEEN && by * unit > 0.1 * Math.abs(x) + 0.001;
  // A bare 0 or 1 is an answer, not a rounded one.
  if (isNear(expected) && !([0, 1].includes(value) && isCoarse(expected))) {
    const correct = !isCoarse(expected);
    const text = phrase(texts, correct ? NO_MISTAKE : 'Right so far: give more digits.');
    return { value, correct, mistake: correct ? null : 'digits', text };
  }
  // One digit meets one of the many mistakes by chance in every fifth answer.
  const wrong = diagnosis(number, (x) => isNear(x) && !isCoarse(x, 1), question);
  if (wrong !== null) return { value, correct: false, mistake: wrong.mistake, text: wrong.text };
  if (value > 1 && expected <= 1) {
    return { value, correct: false, mistake: 'above-full', text: phrase(texts, 'Here 1 is full.') };
  }
  const off = Math.abs(value - expected);
  const difference = shortNumber(
    off,
    decimals(2, (n) => rounded(off, n) > 0),
    texts,
  );
  const side =
    value > expected
      ? 'Not yet: too large by {difference}.'
      : 'Not yet: too small by {difference}.';
  return { value, correct: false, mistake: null, text: phrase(texts, side, { difference }) };
}

/** The one mistake that gives this number; null if none or several do. */
function diagnosis(
  { unit }: Typed,
  isNear: (x: number) => boolean,
  { expected, wrongs }: Question,
): Wrong | null {
  const isApart = (a: number, b: number) => Math.abs(a - b) > unit + 2 * SLACK * Math.abs(a);
  // A left out factor is likelier than the rest. What could be meant too leaves the answer untold.
  for (const among of [wrongs.filter(({ mistake }) => isLeftOut(mistake)), wrongs]) {
    const first = among.find(({ value }) => isNear(value));
    if (first === undefined) continue;
    const isTold =
      isApart(first.value, 0) &&
      isApart(first.value, expected) &&
      among.every(({ text, value }) => text === first.text || isApart(first.value, value));
    return isTold ? first : null;
  }
  return null;
}
