// A probed point in words. For screen readers, which see neither arrows nor table, and for the line below the table.
// Plain functions from values to text.
import { localNumber } from '../../element/page/local-number.js';
import { phrase, type ViewerTexts } from '../../element/fields/texts.js';
import type { FragmentExplanation } from '../../element/explanation.js';
import { LEAST_EXPONENT } from '../../light/light-layout.js';
import { byShare, degreesText, numberText, type Sum, type SumRow, tripleText } from './sum.js';

/** Lights that an announcement names. It is heard in one go; the table has all of them. */
const NAMED = 3;

/** The point, its colour, and the sum of the lights that add most. */
export function fragmentText(texts: ViewerTexts | null, fragment: FragmentExplanation, sum: Sum): string {
  const [red = '', green = '', blue = ''] = sum.color.map((x) => numberText(x, 0));
  const parts = [
    phrase(texts, 'Point {point}.', { point: placeText(fragment) }),
    phrase(texts, 'Colour: red {red}, green {green}, blue {blue}.', { red, green, blue }),
  ];
  if (fragment.unlit) parts.push(phrase(texts, UNLIT));
  const shown = byShare(sum.rows).slice(0, NAMED);
  for (const row of shown) parts.push(rowText(texts, row));
  const more = sum.rows.length - shown.length;
  if (more > 0) parts.push(`${phrase(texts, 'More lights: {number}', { number: String(more) })}.`);
  return parts.join(' ');
}

export const UNLIT = 'Unlit: the colour is the base colour, whatever the lights.';
export const GOURAUD = 'Gouraud: the terms are those of the triangle’s corners, interpolated.';
export const HIDDEN = 'Another surface hides the point.';
export const OUTSIDE = 'The point is outside the picture.';
export const NOTHING = 'No surface there.';

function rowText(texts: ViewerTexts | null, row: SumRow): string {
  const values = {
    name: row.name,
    ambient: tripleText(row.ambient, 0),
    diffuse: tripleText(row.diffuse, 0),
    specular: tripleText(row.specular, 0),
  };
  const text = phrase(texts, '{name}: ambient {ambient}, diffuse {diffuse}, specular {specular}', values);
  return row.absence === null ? `${text}.` : `${text}, ${phrase(texts, row.absence)}.`;
}

const placeText = ({ p }: FragmentExplanation): string =>
  p.map((x) => localNumber(String(Number(x.toPrecision(3)))).replace('-', '−')).join(' ');

/** The steps from a light's vectors through its cosines to its terms. */
export function stepsText(
  texts: ViewerTexts | null,
  { share, name, absence }: SumRow,
  { shininess }: FragmentExplanation,
  halfway: boolean,
): string {
  if (absence === 'outside its cone')
    return phrase(texts, '{name}: {angle} from its axis, outside its cone, so it adds nothing.', {
      name,
      angle: degreesText(share.c),
    });
  if (absence === 'no direction') return phrase(texts, '{name}: no direction, so only ambient.', { name });
  const normal = { name, angle: degreesText(share.NoL), cosine: numberText(share.NoL, 3) };
  if (absence !== null)
    return phrase(texts, '{name}: N·L = cos {angle} = {cosine} is not above 0, so only ambient.', normal);
  const lobe = {
    cosines: halfway ? 'N·H' : 'R·V',
    angle: degreesText(share.RoV),
    cosine: numberText(share.RoV, 3),
    exponent: localNumber(String(Number(shininess.toPrecision(3)))),
    power: numberText(powerOf(share.RoV, shininess), 3),
  };
  return [
    phrase(texts, '{name}: N·L = cos {angle} = {cosine};', normal),
    phrase(texts, '{cosines} = cos {angle} = {cosine}, to the power of {exponent}: {power}.', lobe),
  ].join(' ');
}

/** As the equation's table of limits has it: x^0 is 1 for every x. */
const powerOf = (cosine: number, exponent: number): number =>
  exponent < LEAST_EXPONENT ? 1 : Math.max(cosine, 0) ** exponent;
