// The probe's box: the colour, the table of its sum, and the steps of one light, in a box at the picture's lower or
// upper edge, whichever is away from the point.
import { html, noChange, nothing, type TemplateResult } from 'lit';
import { phrase, type ViewerTexts } from '../../element/fields/texts.js';
import type { FragmentExplanation } from '../../element/explanation.js';
import type { Box } from '../drawing/label-layout.js';
import { SvgLayer } from '../drawing/svg-layer.js';
import { planeOf } from './plane.js';
import { type Sum, type SumRow, tripleText } from './sum.js';
import { type Chosen, STEPS, SumTable } from './sum-table.js';
import { GOURAUD, stepsText, UNLIT } from './words.js';

/** A fragment with its sum. */
export interface BoxContent {
  readonly fragment: FragmentExplanation;
  readonly sum: Sum;
  /** The row that the figure is about. */
  readonly row: SumRow | null;
  readonly halfway: boolean;
  readonly gouraud: boolean;
}

/** What the box shows. */
export interface BoxState {
  /** A message stands in place of a sum. */
  readonly content: BoxContent | string;
  /** The point stays where it is. The box takes the pointer then; otherwise the picture below it can be reached. */
  readonly pinned: boolean;
  /** The user has pinned it. */
  readonly releasable: boolean;
  readonly texts: ViewerTexts | null;
  /** CSS pixels of the layer. */
  readonly width: number;
}

/** Layers narrower than this have codes without decimals. CSS pixels. */
const WIDE = 600;

/** Pixels between the box and the point, where the other edge leaves more: room for arrows. */
const CLEARANCE = 60;

/** Pixels by which the edge that the box is not at must be better. */
const GAIN = 12;

/** The edge of the picture that the box can be at. */
export type Edge = 'low' | 'high';

/** From the box to the layer's edge; see probe.css. */
const MARGIN = 8;

export class ProbeBox {
  /** The angles side on, where there is room. */
  readonly #plane = new SvgLayer('plane');
  readonly #table: SumTable;
  readonly #resized = new ResizeObserver(([entry]) => {
    const [size] = entry?.borderBoxSize ?? [];
    if (size === undefined || size.blockSize === 0) return;
    this.#size = { width: size.inlineSize, height: size.blockSize };
    this.#changed();
  });
  /** Size of the box as it was last laid out: reading it here would cost a layout per frame. */
  #size = { width: 0, height: 0 };
  #edge: Edge = 'low';
  readonly #changed: () => void;
  readonly #release: () => void;

  /**
   * `changed`: another light was chosen, or the box has another size. `release`: the button that takes the pin away was
   * pressed.
   */
  constructor(changed: () => void, release: () => void) {
    this.#changed = changed;
    this.#release = release;
    this.#table = new SumTable(changed);
  }

  get chosen(): Chosen {
    return this.#table.chosen;
  }

  template({ content, pinned, releasable, texts, width }: BoxState): TemplateResult {
    const isEmpty = typeof content === 'string';
    // What is hidden keeps its elements.
    return html`<div
      class=${`box ${this.#edge}${pinned ? ' pinned' : ''}`}
      part="probe"
      role="group"
      data-empty=${isEmpty ? '' : nothing}
      aria-label=${phrase(texts, 'Probe')}
    >
      <p class="head">
        ${isEmpty ? noChange : colorTemplate(content.sum.color, texts, width < WIDE ? 0 : 1)}
        <button
          class="release"
          type="button"
          aria-label=${phrase(texts, 'Unpin')}
          ?hidden=${!releasable}
          .textContent=${'×'}
          @click=${this.#release}
        ></button>
      </p>
      <p class="note" dir="auto" .textContent=${isEmpty ? content : noteOf(content, texts)}></p>
      ${isEmpty ? noChange : this.#sumTemplate(content, texts, width < WIDE ? 0 : 1)}
    </div>`;
  }

  #sumTemplate(content: BoxContent, texts: ViewerTexts | null, digits: number): TemplateResult {
    const { fragment, sum, row, halfway } = content;
    this.#plane.show(row === null ? [] : planeOf(fragment, row, halfway));
    return html`
      <div class="beside">
        <div class="scroll">${this.#table.template(sum, row, texts, digits)}</div>
        ${this.#plane.element}
      </div>
      <p
        class="steps"
        id=${STEPS}
        dir="auto"
        .textContent=${row === null ? '' : stepsText(texts, row, fragment, halfway)}
      ></p>
    `;
  }

  /** The box is in this tree now. */
  follow(root: ParentNode): void {
    this.#resized.observe(root.querySelector('.box')!);
  }

  /**
   * Chooses the edge for a point at `y`: the preferred one unless the point is near it and the other one leaves more
   * room. Returns what the box covers of a layer of this size.
   */
  keepAwayFrom(
    y: number,
    layer: { readonly width: number; readonly height: number; readonly rtl: boolean },
    preferred: Edge,
  ): Box {
    const { width, height } = this.#size;
    const room = { low: layer.height - y, high: y };
    const other = preferred === 'low' ? 'high' : 'low';
    // The current place is preferred by a margin, so that the box does not jump back and forth.
    const lead = this.#edge === other ? GAIN : -GAIN;
    const near = room[preferred] - lead < height + MARGIN + CLEARANCE;
    this.#edge = near && room[other] + lead > room[preferred] ? other : preferred;
    const top = this.#edge === 'high' ? 0 : layer.height - height - MARGIN;
    const left = layer.rtl ? layer.width - width - MARGIN : 0;
    return { left, right: left + width + MARGIN, top, bottom: top + height + MARGIN };
  }

  dispose(): void {
    this.#resized.disconnect();
  }
}

const noteOf = ({ fragment, gouraud }: BoxContent, texts: ViewerTexts | null): string =>
  fragment.unlit ? phrase(texts, UNLIT) : gouraud ? phrase(texts, GOURAUD) : '';

// The colour as a property: a strict CSP refuses style attributes.
const colorTemplate = (
  color: Sum['color'],
  texts: ViewerTexts | null,
  digits: number,
): TemplateResult => html`
  <span class="swatch" .style=${`background-color: rgb(${color.map((x) => x.toFixed(2)).join(' ')})`}></span>
  <span class="codes" dir="ltr">${tripleText(color, digits)}</span>
  <span class="scale" aria-hidden="true">${phrase(texts, 'of 255')}</span>
`;
