// How do a fragment's numbers become table rows? Its vectors, the colours that add up to its own, and the steps of the equation with
// one column per light. Knows neither viewers nor when anything changes.
import type { FragmentExplanation, LightExplanation, Vec3 } from 'phong-viewer';
import { planeOf } from './drawing.js';

const TERMS = ['ambient', 'diffuse', 'specular'] as const;

/** With a typographic minus, and none before a zero. */
export const number = (x: number, digits: number): string =>
  x === Infinity
    ? '∞'
    : x
        .toFixed(digits)
        .replace(/^-(?!0\.?0*$)/, '−')
        .replace('-', '');

/** In 255ths, as in the tables. */
export const codes = (color: Vec3): string => color.map((x) => number(255 * x, 2)).join(' ');

/** One row each for p, N and V. */
export const vectorRows = ({ p, N, V }: FragmentExplanation): HTMLElement[] =>
  Object.entries({ p, N, V }).map(([name, vector]) =>
    row([head('row', name), ...vector.map((x) => cell(number(x, 3)))]),
  );

/** All terms of all lights, then their sum. 0–255 with two decimals, so that a reader can add them up. */
export function sumRows({ shares, sum, color }: FragmentExplanation): HTMLElement[] {
  const rows = shares.flatMap((share) =>
    TERMS.map((term, i) => {
      if (share === null) return null;
      const name = head('rowgroup', share.name);
      name.rowSpan = TERMS.length;
      return row([...(i === 0 ? [name] : []), head('row', term, term), ...colorCells(share[term])]);
    }),
  );
  const totals = Object.entries({ sum, clamped: color }).map(([name, total]) =>
    row([wide(head('row', name)), ...colorCells(total)], 'total'),
  );
  return [...rows.filter((each) => each !== null), ...totals];
}

/** The pixel's 8-bit colour next to the clamped colour: equal up to rounding, except at an edge. */
export function pixelRow(color: Vec3, pixel: Vec3 | null): HTMLElement {
  const same = pixel?.every((code, i) => Math.abs(code - 255 * color[i]!) < 1) === true;
  const name = wide(head('row', pixel === null || same ? 'the pixel' : 'the pixel, at an edge'));
  const cells = pixel === null ? Array.from('....', () => cell('')) : colorCells(pixel, 1);
  return row([name, ...cells], 'total');
}

interface Step {
  readonly name: string;
  readonly formula: string;
  readonly of: (share: LightExplanation, fragment: FragmentExplanation) => string | Node;
}

const STEPS: readonly Step[] = [
  {
    name: 'The plane of N and L',
    formula: 'V as seen in it',
    of: (share, fragment) => planeOf(fragment, share),
  },
  { name: 'L', formula: 'toward the light', of: ({ L }) => components(L) },
  { name: 'd', formula: 'distance', of: ({ d }) => number(d, 3) },
  { name: 'att', formula: '1 / max(kc + kl d + kq d², 1)', of: ({ att }) => number(att, 3) },
  { name: 'c', formula: 'L · (−axis / |axis|)', of: cone },
  { name: 'decay', formula: '((c + 1) / 2)^cutoff', of: ({ decay }) => number(decay, 3) },
  { name: 'N·L', formula: 'below 0: the light is behind the surface', of: ({ NoL }) => number(NoL, 3) },
  { name: 'R·V', formula: 'R = 2 (N·L) N − L', of: ({ RoV }) => number(RoV, 3) },
];

/** The steps of the equation in order, one column per light; empty for a light that is off. */
export const stepRows = (fragment: FragmentExplanation): HTMLElement[] =>
  STEPS.map(({ name, formula, of }) => {
    const title = head('row', name);
    const words = document.createElement('span');
    words.textContent = formula;
    title.append(words);
    return row([title, ...fragment.shares.map((share) => cell(share === null ? '' : of(share, fragment)))]);
  });

/** The axis of a light without cone and decay has no effect. */
function cone({ light, c, insideCone }: LightExplanation): string {
  if (light === null || (light.aperture === 180 && light.cutoff === 0)) return '–';
  return `${number(c, 3)}, ${insideCone ? 'inside' : 'outside'} the cone`;
}

/** `full`: the scale of the numbers, 255 or 1. */
function colorCells(color: Vec3, full = 255): HTMLElement[] {
  const [r, g, b] = color.map((x) => x * full);
  const swatch = cell('');
  const chip = document.createElement('span');
  chip.className = 'chip';
  // Set from script: a strict CSP refuses style attributes.
  chip.style.backgroundColor = `rgb(${r} ${g} ${b})`;
  swatch.append(chip);
  return [swatch, ...[r!, g!, b!].map((x) => cell(full === 1 ? String(x) : number(x, 2)))];
}

function components(v: Vec3): Node {
  const all = document.createDocumentFragment();
  for (const x of v) {
    const part = document.createElement('span');
    part.className = 'component';
    part.textContent = number(x, 3);
    all.append(part, ' ');
  }
  return all;
}

function row(cells: readonly Node[], kind = ''): HTMLElement {
  const element = document.createElement('tr');
  element.className = kind;
  element.append(...cells);
  return element;
}

function head(scope: string, text: string, kind = ''): HTMLTableCellElement {
  const element = document.createElement('th');
  element.scope = scope;
  element.className = kind;
  element.textContent = text;
  return element;
}

function wide(element: HTMLTableCellElement): HTMLTableCellElement {
  element.colSpan = 2;
  return element;
}

function cell(content: string | Node): HTMLTableCellElement {
  const element = document.createElement('td');
  element.append(content);
  return element;
}
