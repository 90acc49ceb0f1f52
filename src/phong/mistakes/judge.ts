// Says what is wrong with a lighting function, from its colours alone: nothing, one or two usual
// mistakes that explain the colours, or where they differ. Pure; runs in Node as in pages.
import { kindOf } from '../light/light-features.js';
import { KINDS, type LightKind } from '../light/light-state.js';
import { radians } from '../math/angle.js';
import { add, clamp, length, map, normalize, scale, subtract, type Vec3 } from '../math/vector.js';
import { both, type Form, formsOf, MISTAKE_IDS, type MistakeId } from './mistakes.js';
import {
  BLACK,
  evaluate,
  type Given,
  sumOfTerms,
  toLightOf,
  type Values,
  valuesAt,
} from './steps.js';

/** A point with each lamp that lights it; its colour is the sum over them. */
export type Case = readonly Given[];

/** A long computation: at each `yield` a page may do something else. */
export type Work<Result> = Generator<unknown, Result, undefined>;

/** What a function gave, in the order of the cases; three numbers each. */
export type Colors = ArrayLike<number>;

/** An 8-bit step. */
export const STEP = 1 / 255;

/** Points of a hundred that may differ. */
const STRAY = 0.01;

/** Share of the wrong points that a mistake has to explain. */
const EXPLAINED = 0.97;

/** Below it colours are equal: a hundredth of what a function that divides by 255² gives. */
const LEAST = 1e-7;

/** From here on float32 may have no number. */
const LARGEST = 1e37;

/** With `isClamped`, of a function that keeps its own result between 0 and 1. */
export const sumAt = (at: Case, form?: Form, isClamped = false): Vec3 =>
  at.reduce<Vec3>((sum, given) => {
    const color = sumOfTerms(evaluate(given, form));
    return add(sum, isClamped ? map(color, shownValue) : color);
  }, BLACK);

const exact = new WeakMap<Case, Vec3>();

/** The right colour; each run of a function asks for the same ones again. */
export function exactAt(at: Case): Vec3 {
  const sum = exact.get(at) ?? sumAt(at);
  exact.set(at, sum);
  return sum;
}

export const colorAt = (colors: Colors, i: number): Vec3 => [
  colors[3 * i]!,
  colors[3 * i + 1]!,
  colors[3 * i + 2]!,
];

/** Within a step; above 1 in proportion. NaN is not. */
const isWithinStep = (found: Vec3, exact: Vec3) =>
  exact.every((x, k) => Math.abs(found[k]! - x) <= STEP * Math.max(1, Math.abs(x)));

/** Small colours are compared in proportion: black is not a colour divided by 255. */
function isSame(found: Vec3, expected: Vec3) {
  const size = Math.max(...expected.map(Math.abs));
  if (size > LARGEST) return !found.every((x) => Math.abs(x) < LARGEST);
  return expected.every((x, k) => Math.abs(found[k]! - x) <= STEP * size + LEAST);
}

/**
 * Whether the equation changes by more than two steps where point and normal move by as much as
 * float32 and a driver's cos() may be off: at a cone's edge, or where N·L is 0.
 */
export function jumps(at: Case, form?: Form): boolean {
  const here = sumAt(at, form);
  return [-1, 1].some((sign) =>
    isMoved(
      here,
      sumAt(
        at.map((given) => shifted(given, sign)),
        form,
      ),
    ),
  );
}

const SHIFT = 2e-5;

/** SwiftShader's cos() is off by 1.8e-4 at 25 radians. */
const COSINE = 2e-4;

const isMoved = (a: Vec3, b: Vec3) =>
  a.some((x, k) => !(Math.abs(x - b[k]!) < 2 * STEP * Math.max(1, Math.abs(x))));

function shifted(given: Given, sign: number): Given {
  const { p, normal, eye, light } = given;
  const by = sign * SHIFT;
  const { aperture } = light;
  // What the cosine of a cone's edge may be off, as an angle; a cone of half a degree is a point.
  const edge = COSINE / Math.max(Math.sin(radians(aperture)), 0.01) / radians(1);
  const reach = by * length(subtract(eye, p));
  const L = normalize(toLightOf(given));
  // Along L, so that N·L changes whatever the normal is; across the axis by three other amounts.
  const turned = add(normalize(normal), scale(L, by));
  return {
    ...given,
    light: { ...light, aperture: aperture < 180 ? aperture + sign * edge : aperture },
    p: add(p, scale([1, -0.7, 0.4], reach)),
    normal: scale(turned, length(normal)),
  };
}

/** Cases with what a function gave and what is right. */
export interface Judged {
  readonly cases: readonly Case[];
  readonly colors: Colors;
  /** Indices of the cases at which the function is wrong, and the equation does not jump. */
  readonly wrong: readonly number[];
  /** How many cases are judged. */
  readonly count: number;
  /** The points are those of the sheet, far from where any form jumps. */
  readonly isSheet: boolean;
}

/**
 * A picture shows sums that are clamped. The sheet's are not; but a function may clamp what it
 * returns, since no picture shows that: the sum of the lamps reaches 1 where one of them does.
 */
export function* compare(cases: readonly Case[], colors: Colors, isSheet = false): Work<Judged> {
  const isFine = (found: Vec3, right: Vec3) =>
    isSheet
      ? isWithinStep(found, right) || isWithinStep(found, map(right, shownValue))
      : isWithinStep(map(found, shownValue), map(right, shownValue));
  const all: number[] = [];
  for (const [i, at] of cases.entries()) {
    if (!isFine(colorAt(colors, i), exactAt(at))) {
      all.push(i);
    }
    yield;
  }
  // Where much is wrong, the few points at which the equation jumps count for nothing.
  const isFew = !isSheet && all.length < 0.2 * cases.length;
  const wrong: number[] = [];
  for (const i of all) {
    if (!isFew || !jumps(cases[i]!)) {
      wrong.push(i);
    }
    yield;
  }
  const count = cases.length - all.length + wrong.length;
  return { cases, colors, wrong, count, isSheet };
}

/** As a picture shows a sum. */
export const shownValue = (x: number): number => clamp(x, 0, 1);

export const isRight = ({ wrong, count }: Judged): boolean => wrong.length <= STRAY * count;

/**
 * The usual mistakes that together give these colours, one or two; empty where none do. Where two
 * forms explain them, the one that meets more of them.
 */
export function* mistakesIn(judged: readonly Judged[]): Work<readonly MistakeId[]> {
  for (const { cases, colors } of judged) {
    const defined = cases.filter((_, i) => !isUndefined(colorAt(colors, i)));
    if (defined.length < DEFINED * cases.length) return [];
  }
  // Else a form that this task does not show would explain them all.
  const isExplained = ({ colors, wrong }: Judged) =>
    wrong.some((i) => !isUndefined(colorAt(colors, i)));
  if (!judged.some(isExplained)) return [];
  const areClamped = judged.every(isClamped);
  // Suns shine from a few directions, which do not tell one edge of a cone from another.
  const isEdgeSeen = judged.some(({ cases }) =>
    cases.some((at) => at.some(({ light }) => light.position[3] === 1)),
  );
  for (const all of [singles(), pairs()]) {
    const candidates = all.filter(({ form }) => isEdgeSeen || !('isInside' in form));
    // What is 255 times as bright says nothing once it is clamped.
    const dim = candidates.filter(({ ids }) => areClamped && !ids.includes('scale-255'));
    const found = (yield* best(judged, candidates)) ?? (yield* best(judged, dim, true));
    if (found !== null) return found;
    // Many pairs take all light away.
    if (judged.every(({ colors }) => Array.from(colors).every((x) => Math.abs(x) <= LEAST)))
      return [];
  }
  return [];
}

const singles = (): Candidate[] => FORMS.map(({ id, form }) => ({ ids: [id], form }));

const pairs = (): Candidate[] =>
  FORMS.flatMap((first, i) =>
    FORMS.slice(i + 1).flatMap((second) => {
      const form = first.id === second.id ? undefined : both(first.form, second.form);
      return form === undefined ? [] : [{ ids: [first.id, second.id], form }];
    }),
  );

interface Candidate {
  readonly ids: readonly MistakeId[];
  readonly form: Form;
}

const FORMS = MISTAKE_IDS.flatMap((id) => formsOf(id).map((form) => ({ id, form })));

/** Whether all is between 0 and 1, where the right colours are not. */
const isClamped = ({ cases, colors, isSheet }: Judged) =>
  !isSheet ||
  (cases.some((at) => exactAt(at).some((x) => x > 1)) &&
    cases.every((_, i) => colorAt(colors, i).every((x) => !(x < 0 || x > 1))));

function* best(
  judged: readonly Judged[],
  candidates: readonly Candidate[],
  areClamped = false,
): Work<readonly MistakeId[] | null> {
  let found: readonly MistakeId[] | null = null;
  let least = Infinity;
  for (const { ids, form } of candidates) {
    let strays = 0;
    for (const part of judged) {
      strays += yield* straysOf(part, form, areClamped);
      if (strays >= least) break;
    }
    if (strays < least) {
      [found, least] = [ids, strays];
    }
    yield;
  }
  return found;
}

/** How many cases a form does not explain; Infinity where these are too many. */
function* straysOf(part: Judged, form: Form, areClamped: boolean): Work<number> {
  const { cases, colors, wrong, count, isSheet } = part;
  const differs = (i: number) => {
    const found = colorAt(colors, i);
    return (
      !isUndefined(found) &&
      !isSame(found, sumAt(cases[i]!, form, areClamped)) &&
      (isSheet || !jumps(cases[i]!, form))
    );
  };
  // Most forms fail at two of a few wrong points.
  const stride = Math.max(Math.floor(wrong.length / SAMPLE), 1);
  let strays = 0;
  for (let k = 0; k < wrong.length && wrong.length > SAMPLE; k += stride) {
    if (differs(wrong[k]!) && ++strays > 1) return Infinity;
  }
  // A picture may be right, but for its stray points.
  const most = isRight(part)
    ? STRAY * count
    : Math.min((1 - EXPLAINED) * wrong.length, STRAY * count);
  strays = 0;
  for (const i of wrong) {
    if (differs(i) && ++strays > most) return Infinity;
    yield;
  }
  const isWrong = new Set(wrong);
  for (const i of cases.keys()) {
    if (!isWrong.has(i) && differs(i) && ++strays > STRAY * count) return Infinity;
    yield;
  }
  return strays;
}

/** The power of a negative number: a mistake can bring it, and says nothing about others. */
const isUndefined = (found: Vec3) => found.some(Number.isNaN);

/** Share of points at which a function that gets a name has to be defined. */
const DEFINED = 0.5;

const SAMPLE = 8;

/** Where a function differs that no mistake explains. */
export interface Difference {
  readonly kinds: readonly LightKind[];
  readonly regions: readonly Region[];
}

export type Region = (typeof REGIONS)[number]['name'];

/** Parts of a scene by the right values. The first that holds all wrong points is named. */
const REGIONS = [
  { name: 'away', holds: ({ NoL }: Values) => NoL <= 0 },
  { name: 'outside', holds: ({ isInside }: Values) => !isInside },
  { name: 'highlight', holds: ({ spec }: Values) => spec > STEP },
  { name: 'near', holds: ({ d }: Values, given: Given) => given.light.position[3] === 1 && d < 1 },
  { name: 'lit', holds: ({ NoL, isInside }: Values) => NoL > 0 && isInside },
] as const;

/** Kinds of lights and regions that hold nearly all wrong points. */
export function differenceOf({ cases, wrong }: Judged): Difference {
  const givens = wrong.map((i) => cases[i]![0]!);
  const share = (holds: (given: Given) => boolean) =>
    givens.filter(holds).length / Math.max(givens.length, 1);
  const kinds = KINDS.filter((kind) => share(({ light }) => kindOf(light) === kind) > STRAY);
  const regions = REGIONS.filter(
    ({ holds }) => share((given) => holds(valuesAt(given), given)) > 0.98,
  );
  return { kinds, regions: regions.slice(0, 1).map(({ name }) => name) };
}
