// What does the probe show beside the arrows? The colour, the table of its sum, and the steps of one light, in a box at the picture's lower or
// upper edge, whichever is away from the point. Knows neither the scene nor the pointer.
import { SvgLayer } from '../drawing/svg-layer.js';
import type { Box } from '../drawing/label-layout.js';
import { phrase, type ViewerTexts } from '../../element/fields/texts.js';
import type { FragmentExplanation } from '../../element/viewer/shade-at.js';
import { create, set, write } from '../../element/viewer/template.js';
import { planeOf } from './plane.js';
import { type Sum, type SumRow, tripleText } from './sum.js';
import { type Chosen, STEPS, SumTable } from './sum-table.js';
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

/** Pixels between the box and the point, where the other edge leaves more: room for arrows. */
const CLEARANCE = 60;

/** Pixels by which the edge that the box is not at must be better. */
const GAIN = 12;

/** Of the picture, where the box can be. */
export type Edge = 'low' | 'high';

/** From the box to the layer's edge; see probe.css. */
const MARGIN = 8;

export class ProbeBox {
  readonly element = create('div', { class: 'box low', part: 'probe', role: 'group' });
  readonly #swatch = create('span', { class: 'swatch' });
  readonly #codes = create('span', { class: 'codes', dir: 'ltr' });
  readonly #scale = create('span', { class: 'scale', 'aria-hidden': 'true' });
  readonly #release = create('button', { class: 'release', type: 'button' });
  readonly #scroll = create('div', { class: 'scroll' });
  /** The angles side on, where there is room. */
  readonly #plane = new SvgLayer();
  readonly #steps = create('p', { class: 'steps', id: STEPS, dir: 'auto' });
  readonly #message = create('p', { class: 'note', dir: 'auto' });
  readonly #table: SumTable;
  readonly #resized = new ResizeObserver(([entry]) => {
    const [size] = entry?.borderBoxSize ?? [];
    if (size === undefined || size.blockSize === 0) return;
    this.#size = { width: size.inlineSize, height: size.blockSize };
    this.#changed();
  });
  /** Of the box as it was last laid out: reading it here would cost a layout per frame. */
  #size = { width: 0, height: 0 };

  readonly #changed: () => void;

  /** `changed`: another light was chosen, or the box has another size. `release`: the button that takes the pin away was pressed. */
  constructor(changed: () => void, release: () => void) {
    this.#changed = changed;
    this.#table = new SumTable(changed);
    const head = create('p', { class: 'head' });
    head.append(this.#swatch, this.#codes, this.#scale, this.#release);
    this.#scroll.append(this.#table.element);
    this.#plane.element.classList.add('plane');
    const beside = create('div', { class: 'beside' });
    beside.append(this.#scroll, this.#plane.element);
    this.#release.append('×');
    this.#release.addEventListener('click', release);
    this.#resized.observe(this.element);
    this.element.append(head, this.#message, beside, this.#steps);
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
    write(this.#scale, phrase(texts, 'of 255'));
    write(this.#codes, tripleText(sum.color, digits));
    write(this.#message, fragment.unlit ? phrase(texts, UNLIT) : gouraud ? phrase(texts, GOURAUD) : '');
    this.#table.show(sum, row, texts, digits);
    this.#plane.show(row === null ? [] : planeOf(fragment, row, halfway));
    write(this.#steps, row === null ? '' : stepsText(texts, row, fragment, halfway));
  }

  /** A pinned point's box takes the pointer. */
  setPinned(pinned: boolean, releasable: boolean): void {
    this.element.classList.toggle('pinned', pinned);
    this.#release.hidden = !releasable;
  }

  /**
   * Chooses the edge for a point at `y`: the preferred one unless the point is near it and the other one leaves more room. Returns what
   * the box covers of a layer of this size.
   */
  keepAwayFrom(y: number, layer: { readonly width: number; readonly height: number }, preferred: Edge): Box {
    const { classList } = this.element;
    const { width, height } = this.#size;
    const room = { low: layer.height - y, high: y };
    const other = preferred === 'low' ? 'high' : 'low';
    // The current place is preferred by a margin, so that the box does not jump back and forth.
    const lead = classList.contains(other) ? GAIN : -GAIN;
    const near = room[preferred] - lead < height + MARGIN + CLEARANCE;
    const edge = near && room[other] + lead > room[preferred] ? other : preferred;
    classList.toggle('low', edge === 'low');
    classList.toggle('high', edge === 'high');
    const top = edge === 'high' ? 0 : layer.height - height - MARGIN;
    const left = this.element.matches(':dir(rtl)') ? layer.width - width - MARGIN : 0;
    return { left, right: left + width + MARGIN, top, bottom: top + height + MARGIN };
  }

  dispose(): void {
    this.#resized.disconnect();
  }

  #label(texts: ViewerTexts | null): void {
    set(this.element, 'aria-label', phrase(texts, 'Probe'));
    set(this.#release, 'aria-label', phrase(texts, 'Unpin'));
  }
}
