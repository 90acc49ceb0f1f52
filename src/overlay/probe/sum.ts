// The rows of the sum at a fragment, and the light that it is about. Plain values from an explanation of shadeAt.
// Colours in codes: 255 is full.
import type { FragmentExplanation, LightExplanation } from '../../element/explanation.js';
import { localNumber, type ViewerTexts } from '../../element/fields/texts.js';
import { isBlack, srgbDecode } from '../../math/color.js';
import { radians } from '../../math/angle.js';
import { add, length, map, type Vec3 } from '../../math/vector.js';

/** Why a light adds less than its surroundings suggest; null if it adds its diffuse and specular terms. */
export type Absence = 'outside its cone' | 'behind the surface' | 'no direction' | 'no normal' | null;

/** One active light's row: its explanation, with the three terms in codes. */
export interface SumRow extends LightExplanation {
  /** At the point itself, whatever the terms: under Gouraud shading they are those of the corners. */
  readonly absence: Absence;
  /** Sum of the three terms. */
  readonly total: Vec3;
}

/** A row below the lights. */
export interface TotalRow {
  readonly label: 'base colour' | 'emissive' | 'sum' | 'encoded' | 'clamped';
  readonly color: Vec3;
}

export interface Sum {
  readonly rows: readonly SumRow[];
  readonly totals: readonly TotalRow[];
  /** The colour that is drawn, 0–255. */
  readonly color: Vec3;
}

/** `linear`: the viewer shades in linear light, so terms and sum are decoded and the sum is encoded last. */
export function probeSum(fragment: FragmentExplanation, linear: boolean): Sum {
  const { shares, unlit, emissive, sum, color } = fragment;
  const hasNormal = length(fragment.N) > 0;
  const rows = unlit ? [] : shares.filter((share) => share !== null).map((share) => rowOf(share, hasNormal));
  const own = map(unlit ? fragment.baseColor : emissive, (x) => 255 * (linear ? srgbDecode(x) : x));
  const totals: TotalRow[] = [];
  if (unlit) totals.push({ label: 'base colour', color: own });
  else if (own.some((x) => x > 0)) totals.push({ label: 'emissive', color: own });
  const added = rows.reduce((total, row) => add(total, row.total), own);
  if (!unlit) totals.push({ label: 'sum', color: added });
  const encoded = codes(sum);
  if (linear) totals.push({ label: 'encoded', color: encoded });
  const shown = codes(color);
  if (shown.some((x, i) => x !== encoded[i])) totals.push({ label: 'clamped', color: shown });
  return { rows, totals, color: shown };
}

function rowOf(share: LightExplanation, hasNormal: boolean): SumRow {
  const [ambient, diffuse, specular] = [codes(share.ambient), codes(share.diffuse), codes(share.specular)];
  const total = add(add(ambient, diffuse), specular);
  return { ...share, ambient, diffuse, specular, total, absence: absenceOf(share, hasNormal) };
}

function absenceOf({ insideCone, L, NoL }: LightExplanation, hasNormal: boolean): Absence {
  if (!insideCone) return 'outside its cone';
  if (length(L) === 0) return 'no direction';
  if (!hasNormal) return 'no normal';
  return NoL > 0 ? null : 'behind the surface';
}

/** The absence that a row's terms show; null where they show another one than the point itself has. */
export function shownAbsence({ absence, ambient, diffuse, specular }: SumRow): Absence {
  const missing = absence === 'outside its cone' ? [ambient, diffuse, specular] : [diffuse, specular];
  return missing.every(isBlack) ? absence : null;
}

/** The rows by what they add, the largest first. Equal ones keep their order. */
export const byShare = (rows: readonly SumRow[]): SumRow[] =>
  [...rows].sort((a, b) => brightness(b.total) - brightness(a.total));

const brightness = ([r, g, b]: Vec3): number => r + g + b;

const codes = (color: Vec3): Vec3 => map(color, (x) => 255 * x);

/** In the language of the texts, with a typographic minus; zero has no sign. */
export function shortNumber(value: number, digits: number, texts: ViewerTexts | null): string {
  if (!Number.isFinite(value)) return value > 0 ? '∞' : '−∞';
  // Larger numbers, from extreme lights, would not fit with all digits.
  const text = Math.abs(value) < 1e6 ? value.toFixed(digits) : value.toExponential(1);
  return localNumber(text.replace(/^-(?!0(\.0*)?$)/, '−').replace(/^-/, ''), texts);
}

/** Three numbers with a space between: a wider one where a comma would run into it. */
export const tripleText = (color: Vec3, digits: number, texts: ViewerTexts | null): string =>
  color.map((x) => shortNumber(x, digits, texts)).join(digits > 0 && localNumber('.', texts) === ',' ? '\u2002' : ' ');

/** A term that adds nothing is one zero: most are, and the others are easier to find. */
export const termText = (color: Vec3, digits: number, texts: ViewerTexts | null): string =>
  isBlack(color) ? localNumber('0', texts) : tripleText(color, digits, texts);

/** The angle whose cosine this is, in degrees. */
export const degreesOf = (cosine: number): number => Math.acos(Math.min(Math.max(cosine, -1), 1)) / radians(1);

export const degreesText = (cosine: number, digits: number, texts: ViewerTexts | null): string =>
  `${shortNumber(degreesOf(cosine), digits, texts)}°`;
