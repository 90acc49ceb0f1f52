// The line under the picture: one pixel as the sum of what each light adds to it.
import { shownSum, type Triple } from './digits.js';

type Viewer = HTMLElementTagNameMap['phong-viewer'];
type Fragment = NonNullable<Awaited<ReturnType<Viewer['shadeAt']>>>;

interface Cell {
  /** What stands before it. */
  readonly sign: string;
  readonly kind: string;
  readonly label: string;
  readonly digits: readonly string[];
  /** 1 is full. */
  readonly color: Triple;
}

export function showSum(line: HTMLElement, fragment: Fragment): void {
  const cells = cellsOf(fragment);
  const labels = cells.map(({ sign, label }) => sign + label).join();
  if (line.dataset['labels'] !== labels) {
    line.dataset['labels'] = labels;
    line.replaceChildren(...cells.flatMap(made));
  }
  const all = line.querySelectorAll<HTMLElement>('.cell');
  for (const [i, { digits, color }] of cells.entries()) {
    const cell = all[i]!;
    const swatch = cell.querySelector<HTMLElement>('.swatch')!;
    swatch.style.background = `rgb(${color.map((value) => 255 * value).join(' ')})`;
    const text = digits.join(' ');
    const shown = cell.querySelector('.digits')!;
    if (shown.textContent !== text) {
      shown.textContent = text;
    }
  }
}

/** For a pixel that shows no surface any more. */
export function showNone(line: HTMLElement): void {
  line.dataset['labels'] = '';
  line.textContent = 'This pixel shows no surface now. Point at one.';
}

function cellsOf({ shares, color }: Fragment): readonly Cell[] {
  const lights = shares.filter((share) => share !== null);
  const ambient = [0, 1, 2].map((i) => lights.reduce((all, light) => all + light.ambient[i]!, 0));
  const terms = [
    { kind: 'ambient', label: 'ambient', color: ambient as unknown as Triple },
    ...lights.flatMap(({ name, diffuse, specular }) => [
      { kind: 'diffuse', label: `${name} diffuse`, color: diffuse },
      { kind: 'specular', label: `${name} specular`, color: specular },
    ]),
  ];
  const shown = shownSum(terms.map((term) => term.color));
  const drawn = color.map((value) => Math.round(255 * value)) as unknown as Triple;
  const isDrawn = shown.sum.join() === drawn.join();
  const isCut = shown.sum.map((value) => Math.min(value, 255)).join() === drawn.join();
  const pixel = { kind: 'pixel', digits: drawn.map(String), color };
  return [
    { ...pixel, sign: '', label: 'this pixel' },
    ...terms.map((term, i) => ({ ...term, sign: i === 0 ? '=' : '+', digits: shown.terms[i]! })),
    ...(isDrawn
      ? []
      : [
          {
            kind: 'pixel',
            sign: '=',
            label: isCut ? 'cut at 255' : 'then encoded',
            digits: shown.sum.map(String),
            color,
          },
        ]),
    { ...pixel, sign: isDrawn ? '=' : '→', label: 'red green blue' },
  ];
}

function made({ sign, kind, label }: Cell): Node[] {
  const cell = document.createElement('span');
  cell.className = `cell ${kind}`;
  for (const name of ['swatch', 'label', 'digits']) {
    const part = document.createElement('span');
    part.className = name;
    cell.append(part, ' ');
  }
  cell.querySelector('.label')!.textContent = label;
  if (sign === '') return [cell];
  // With its sign, so that no line begins or ends between them.
  const mark = document.createElement('span');
  mark.className = 'sign';
  mark.textContent = sign;
  cell.prepend(mark, ' ');
  return [cell, document.createTextNode(' ')];
}
