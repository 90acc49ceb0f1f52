// What does the probe say beside the arrows? The colour, the table of its sum, and the steps of one light, in a box at the picture's lower or
// upper edge, whichever is away from the point. Knows neither the scene nor the pointer.
import { phrase, type ViewerTexts } from '../../element/fields/texts.js';
import type { FragmentExplanation } from '../../element/viewer/shade-at.js';
import { create, set } from '../../element/viewer/template.js';
import { type Sum, type SumRow, tripleText } from './sum.js';
import { type Chosen, SumTable } from './sum-table.js';
import { GOURAUD, stepsText, UNLIT } from './words.js';

/** What the box shows. */
export interface BoxContent {
  readonly fragment: FragmentExplanation;
  readonly sum: Sum;
  /** The row that the figure is about. */
  readonly row: SumRow | null;
  readonly halfway: boolean;
  readonly gouraud: boolean;
}

/** Layers narrower than this have codes without decimals. CSS pixels. */
const WIDE = 600;

/** The box takes at most 40 % of the height (probe.css). It changes sides where the point comes within 44 % of its edge. */
const NEAR_EDGE = 0.44;

export class ProbeBox {
  readonly element = create('div', { class: 'box low', part: 'probe', role: 'group' });
  readonly #swatch = create('span', { class: 'swatch' });
  readonly #codes = create('span', { class: 'codes', dir: 'ltr' });
  readonly #release = create('button', { class: 'release', type: 'button' });
  readonly #scroll = create('div', { class: 'scroll' });
  readonly #steps = create('p', { class: 'steps' });
  readonly #message = create('p', { class: 'message-line' });
  readonly #table: SumTable;

  /** `choose`: another light was chosen. `release`: the button that takes the pin away was pressed. */
  constructor(choose: () => void, release: () => void) {
    this.#table = new SumTable(choose);
    const head = create('p', { class: 'head' });
    head.append(this.#swatch, this.#codes, this.#release);
    this.#scroll.append(this.#table.element);
    this.#release.append('×');
    this.#release.addEventListener('click', release);
    this.element.append(head, this.#message, this.#scroll, this.#steps);
  }

  get chosen(): Chosen {
    return this.#table.chosen;
  }

  /** Shows a message in place of a sum. */
  showMessage(text: string, texts: ViewerTexts | null): void {
    this.#label(texts);
    set(this.element, 'data-empty', '');
    write(this.#message, text);
  }

  show({ fragment, sum, row, halfway, gouraud }: BoxContent, texts: ViewerTexts | null, width: number): void {
    const digits = width < WIDE ? 0 : 1;
    this.#label(texts);
    set(this.element, 'data-empty', null);
    // By script: a strict CSP refuses style attributes.
    this.#swatch.style.backgroundColor = `rgb(${sum.color.map((x) => x.toFixed(2)).join(' ')})`;
    write(this.#codes, tripleText(sum.color, digits));
    write(this.#message, fragment.unlit ? phrase(texts, UNLIT) : gouraud ? phrase(texts, GOURAUD) : '');
    this.#table.show(sum, row, texts, digits);
    write(this.#steps, row === null ? '' : stepsText(texts, row, fragment, halfway));
  }

  set pinned(pinned: boolean) {
    this.element.classList.toggle('pinned', pinned);
    this.#release.hidden = !pinned;
  }

  /** The point is at `y` of `height`. */
  keepAwayFrom(y: number, height: number): void {
    const { classList } = this.element;
    const low = classList.contains('low');
    if (low ? y > (1 - NEAR_EDGE) * height : y < NEAR_EDGE * height) {
      classList.toggle('low', !low);
      classList.toggle('high', low);
    }
  }

  #label(texts: ViewerTexts | null): void {
    set(this.element, 'aria-label', phrase(texts, 'Probe'));
    set(this.#release, 'aria-label', phrase(texts, 'Unpin'));
  }
}

function write(element: Element, text: string): void {
  if (element.textContent !== text) element.textContent = text;
}
