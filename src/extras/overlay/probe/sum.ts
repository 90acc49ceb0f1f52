// The sum at a fragment: its rows, with colours in codes (255 is full), its numbers as text, and
// the words for screen readers, which see neither arrows nor table, and for the line below the
// table.
import {
  type FragmentExplanation,
  localNumber,
  phrase,
  type ViewerText,
  type ViewerTexts,
} from '../../../viewer/extra.js';
import { TERMS } from '../../../phong/light/light-state.js';
import { LEAST_EXPONENT } from '../../../phong/light/precision.js';
import { cosDegrees, radians } from '../../../phong/math/angle.js';
import { isBlack, srgbDecode } from '../../../phong/math/color.js';
import { add, clamp, length, map, type Vec3 } from '../../../phong/math/vector.js';

/**
 * Why a light adds less than its surroundings suggest; null if it adds its diffuse and specular
 * terms.
 */
type Absence = 'outside its cone' | 'behind the surface' | 'no direction' | 'no normal' | null;

/** One active light's row: its explanation, with the three terms in codes. */
export type LightExplanation = NonNullable<FragmentExplanation['shares'][number]>;

export interface SumRow extends LightExplanation {
  /**
   * At the point itself, whatever the terms: under Gouraud shading they are those of the corners.
   */
  readonly absence: Absence;
  /** Sum of the three terms. */
  readonly total: Vec3;
}

/** A row below the lights. */
interface TotalRow {
  readonly label: 'base colour' | 'emissive' | 'sum' | 'encoded' | 'clamped';
  readonly color: Vec3;
}

export interface Sum {
  readonly rows: readonly SumRow[];
  /** Added to the rows: what the surface emits. */
  readonly own: Vec3;
  readonly totals: readonly TotalRow[];
  /** The colour that is drawn, 0–255. */
  readonly color: Vec3;
}

/**
 * `linear`: the viewer shades in linear light, so terms and sum are decoded and the sum is encoded
 * last.
 */
export function probeSum(fragment: FragmentExplanation, linear: boolean): Sum {
  const { shares, unlit, emissive, sum, color } = fragment;
  const hasNormal = length(fragment.N) > 0;
  const rows = unlit
    ? []
    : shares.filter((share) => share !== null).map((share) => rowOf(share, hasNormal));
  const own = map(unlit ? fragment.baseColor : emissive, (x) => 255 * (linear ? srgbDecode(x) : x));
  const totals: TotalRow[] = [];
  if (unlit) {
    totals.push({ label: 'base colour', color: own });
  } else {
    if (!isBlack(own)) {
      totals.push({ label: 'emissive', color: own });
    }
    totals.push({ label: 'sum', color: rows.reduce((all, row) => add(all, row.total), own) });
  }
  const encoded = codes(sum);
  if (linear) {
    totals.push({ label: 'encoded', color: encoded });
  }
  const shown = codes(color);
  if (shown.some((x, i) => x !== encoded[i])) {
    totals.push({ label: 'clamped', color: shown });
  }
  return { rows, own, totals, color: shown };
}

function rowOf(share: LightExplanation, hasNormal: boolean): SumRow {
  const ambient = codes(share.ambient);
  const diffuse = codes(share.diffuse);
  const specular = codes(share.specular);
  const total = add(add(ambient, diffuse), specular);
  return { ...share, ambient, diffuse, specular, total, absence: absenceOf(share, hasNormal) };
}

function absenceOf({ insideCone, L, NoL }: LightExplanation, hasNormal: boolean): Absence {
  if (!insideCone) return 'outside its cone';
  if (length(L) === 0) return 'no direction';
  if (!hasNormal) return 'no normal';
  return NoL > 0 ? null : 'behind the surface';
}

/**
 * The absence that a row's terms show; null where they show another one than the point itself has.
 */
export function shownAbsence({ absence, ambient, diffuse, specular }: SumRow): Absence {
  const missing =
    absence === 'outside its cone' ? [ambient, diffuse, specular] : [diffuse, specular];
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
  color
    .map((x) => shortNumber(x, digits, texts))
    .join(digits > 0 && localNumber('.', texts) === ',' ? '\u2002' : ' ');

/** A term that adds nothing is one zero: most are, and the others are easier to find. */
export const termText = (color: Vec3, digits: number, texts: ViewerTexts | null): string =>
  isBlack(color) ? localNumber('0', texts) : tripleText(color, digits, texts);

/** The sum of the parts, with ≈ where their digits do not give its own. */
export function sumText(parts: readonly Vec3[], digits: number, texts: ViewerTexts | null): string {
  const shown = parts.map((part) => map(part, (x) => Number(shortNumber(x, digits, null))));
  const [added, sum] = [shown.reduce(add), parts.reduce(add)];
  const sign = tripleText(added, digits, null) === tripleText(sum, digits, null) ? '' : '≈ ';
  return sign + termText(sum, digits, texts);
}

/** The angle whose cosine this is, in degrees. */
export const degreesOf = (cosine: number): number => Math.acos(clamp(cosine, -1, 1)) / radians(1);

export const degreesText = (cosine: number, digits: number, texts: ViewerTexts | null): string =>
  `${shortNumber(degreesOf(cosine), digits, texts)}°`;

/** Lights that an announcement names. It is heard in one go; the table has all of them. */
const NAMED = 3;

/** The point, its colour, and the sum of the lights that add most. */
export function fragmentText(
  texts: ViewerTexts | null,
  fragment: FragmentExplanation,
  sum: Sum,
): string {
  const [red = '', green = '', blue = ''] = sum.color.map((x) => shortNumber(x, 0, texts));
  const parts = [
    phrase(texts, 'Point {point}.', { point: placeText(texts, fragment) }),
    phrase(texts, 'Colour: red {red}, green {green}, blue {blue}.', { red, green, blue }),
    ...notesOf(fragment, false, texts),
  ];
  const rows = byShare(sum.rows);
  parts.push(...rows.slice(0, NAMED).map((row) => rowText(texts, row)));
  const more = rows.length - NAMED;
  if (more > 0) {
    parts.push(
      `${phrase(texts, 'More lights: {number}', { number: localNumber(String(more), texts) })}.`,
    );
  }
  return parts.join(' ');
}

const UNLIT = 'Unlit: the colour is the base colour, whatever the lights.';
const GOURAUD = 'Gouraud: the terms are those of the triangle’s corners, interpolated.';
const FILTERED =
  'The picture averages the texture here; these numbers read it at one point, so they can differ.';
export const HIDDEN = 'Another surface hides the point.';
export const OUTSIDE = 'The point is outside the picture.';
/** What a cross-hair says of itself. */
export const KEYS =
  'Arrow keys move it by a pixel, with Shift by ten. Enter pins it to the surface, Escape releases it.';

export const NO_SURFACE = 'No surface there.';

/** What is special about the colour. */
export function notesOf(
  { unlit, filtered }: FragmentExplanation,
  gouraud: boolean,
  texts: ViewerTexts | null,
): string[] {
  const notes: ViewerText[] = [];
  if (unlit) {
    notes.push(UNLIT);
  } else if (gouraud) {
    notes.push(GOURAUD);
  }
  if (filtered) {
    notes.push(FILTERED);
  }
  return notes.map((note) => phrase(texts, note));
}

function rowText(texts: ViewerTexts | null, row: SumRow): string {
  const terms = TERMS.map((term) => [term, tripleText(row[term], 0, texts)] as const);
  const text = phrase(texts, '{name}: ambient {ambient}, diffuse {diffuse}, specular {specular}', {
    name: row.name,
    ...Object.fromEntries(terms),
  });
  const absence = shownAbsence(row);
  return absence === null ? `${text}.` : `${text}, ${phrase(texts, absence)}.`;
}

const placeText = (texts: ViewerTexts | null, { p }: FragmentExplanation): string =>
  p.map((x) => localNumber(String(Number(x.toPrecision(3))), texts).replace('-', '−')).join(' ');

/** The steps from a light's vectors through its cosines to its terms, at the point itself. */
export function stepsText(
  texts: ViewerTexts | null,
  row: SumRow,
  { shininess }: FragmentExplanation,
  halfway: boolean,
): string {
  const { light, name, absence, c } = row;
  if (absence === 'outside its cone') {
    const isOutside = (digits: number) =>
      light === null || rounded(degreesOf(c), digits) > light.aperture;
    return phrase(texts, '{name}: {angle} from its axis, outside its cone, so it adds nothing.', {
      name,
      angle: degreesText(c, decimals(0, isOutside), texts),
    });
  }
  const normal = { name, ...normalWords(texts, row) };
  if (absence !== null) return phrase(texts, ONLY_AMBIENT[absence], normal);
  return `${phrase(texts, '{name}: N·L = cos {angle} = {cosine};', normal)} ${lobeText(texts, row.RoV, shininess, halfway)}`;
}

const ONLY_AMBIENT = {
  'no direction': '{name}: no direction, so only ambient.',
  'no normal': '{name}: no normal here, so only ambient.',
  'behind the surface': '{name}: N·L = cos {angle} = {cosine} is not above 0, so only ambient.',
} as const;

function lobeText(
  texts: ViewerTexts | null,
  cosine: number,
  shininess: number,
  halfway: boolean,
): string {
  const cosines = halfway ? 'N·H' : 'R·V';
  const exponent = exponentOf(shininess);
  if (exponent > 0 && cosine <= 0) {
    return phrase(texts, '{cosines} = {cosine} is not above 0: no highlight.', {
      cosines,
      cosine: shortNumber(cosine, 3, texts),
    });
  }
  return phrase(texts, '{cosines} = cos {angle} = {cosine}, to the power of {exponent}: {power}.', {
    cosines,
    ...lobeWords(texts, cosine, shininess),
    exponent: localNumber(String(Number(exponent.toPrecision(6))), texts),
    power: shortNumber(cosine ** exponent, 3, texts),
  });
}

/** As the equation's table of limits has it: x^0 is 1 for every x. */
export const exponentOf = (shininess: number): number =>
  shininess < LEAST_EXPONENT ? 0 : shininess;

export const normalWords = (texts: ViewerTexts | null, { NoL }: LightExplanation): CosineWords =>
  cosineWords(texts, NoL, 3);

/** R·V or N·H, and its angle, with the decimals that it takes to have the power shown. */
export function lobeWords(
  texts: ViewerTexts | null,
  cosine: number,
  shininess: number,
): CosineWords {
  const exponent = exponentOf(shininess);
  const power = (x: number) => rounded(Math.max(x, 0) ** exponent, 3);
  return cosineWords(
    texts,
    cosine,
    decimals(3, (n) => power(rounded(cosine, n)) === power(cosine)),
  );
}

type CosineWords = Readonly<Record<'angle' | 'cosine', string>>;

/** A cosine with this many decimals, and its angle with as many as it takes to have that cosine. */
function cosineWords(texts: ViewerTexts | null, cosine: number, digits: number): CosineWords {
  const text = shortNumber(cosine, digits, null);
  const hasCosine = (n: number) =>
    shortNumber(cosDegrees(rounded(degreesOf(cosine), n)), digits, null) === text;
  return {
    angle: degreesText(cosine, decimals(0, hasCosine), texts),
    cosine: shortNumber(cosine, digits, texts),
  };
}

/** The fewest decimals, from `least` to nine, that make a statement of rounded numbers true. */
export function decimals(least: number, isTrue: (digits: number) => boolean): number {
  let digits = least;
  while (digits < 9 && !isTrue(digits)) {
    digits += 1;
  }
  return digits;
}

export const rounded = (x: number, digits: number): number => Number(x.toFixed(digits));
