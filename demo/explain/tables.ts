// Turns a fragment's numbers into table rows: its vectors, and the steps of the equation with one
// column per light. Knows neither viewers nor when anything changes.
import type { FragmentExplanation, LightExplanation, Vec3 } from 'phong-viewer';

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
    row([head(name), ...vector.map((x) => cell(number(x, 3)))]),
  );

interface Step {
  readonly name: string;
  readonly formula: string;
  readonly of: (share: LightExplanation) => string | Node;
}

const STEPS: readonly Step[] = [
  { name: 'L', formula: 'toward the light', of: ({ L }) => components(L) },
  { name: 'd', formula: 'distance', of: ({ d }) => number(d, 3) },
  { name: 'att', formula: '1 / max(kc + kl d + kq d², 1)', of: ({ att }) => number(att, 3) },
  { name: 'c', formula: 'L · (−axis / |axis|)', of: cone },
  { name: 'decay', formula: '((c + 1) / 2)^cutoff', of: ({ decay }) => number(decay, 3) },
  {
    name: 'N·L',
    formula: 'below 0: the light is behind the surface',
    of: ({ NoL }) => number(NoL, 3),
  },
  { name: 'R·V', formula: 'R = 2 (N·L) N − L', of: ({ RoV }) => number(RoV, 3) },
];

/** The steps of the equation in order, one column per light; empty for a light that is off. */
export const stepRows = (fragment: FragmentExplanation): HTMLElement[] =>
  STEPS.map(({ name, formula, of }) => {
    const title = head(name);
    const words = document.createElement('span');
    words.textContent = formula;
    title.append(words);
    return row([title, ...fragment.shares.map((share) => cell(share === null ? '' : of(share)))]);
  });

/** The axis of a light without cone and decay has no effect. */
function cone({ light, c, insideCone }: LightExplanation): string {
  if (light === null || (light.aperture === 180 && light.cutoff === 0)) return '–';
  return `${number(c, 3)}, ${insideCone ? 'inside' : 'outside'} the cone`;
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

function row(cells: readonly Node[]): HTMLElement {
  const element = document.createElement('tr');
  element.append(...cells);
  return element;
}

function head(text: string): HTMLTableCellElement {
  const element = document.createElement('th');
  element.scope = 'row';
  element.textContent = text;
  return element;
}

function cell(content: string | Node): HTMLTableCellElement {
  const element = document.createElement('td');
  element.append(content);
  return element;
}
