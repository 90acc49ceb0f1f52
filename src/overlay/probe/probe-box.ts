// The probe's box: the colour, the table of its sum, and the steps of one light, in a box at the picture's lower or
// upper edge, whichever is away from the point.
import { html, noChange, nothing, type TemplateResult } from 'lit';
import { phrase, type ViewerTexts } from '../../element/fields/texts.js';
import type { FragmentExplanation } from '../../element/explanation.js';
import type { Box } from '../drawing/label-layout.js';
import type { Room } from '../drawing/room.js';
import { SvgLayer } from '../drawing/svg-layer.js';
import { layoutOf, type TableLayout } from './columns.js';
import { PLANE, planeOf } from './plane.js';
import { type Sum, type SumRow, tripleText } from './sum.js';
import { type Chosen, STEPS, SumTable } from './sum-table.js';
import { FILTERED, GOURAUD, stepsText, UNLIT } from './words.js';

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
  /** A message stands in place of a sum. Null: nothing is shown. */
  readonly content: BoxContent | string | null;
  /** The point stays where it is. The box takes the pointer then; otherwise the picture below it can be reached. */
  readonly pinned: boolean;
  /** The user has pinned it. */
  readonly releasable: boolean;
  readonly texts: ViewerTexts | null;
}

/** The most of the room's height that the box has; see probe.css. */
const HIGHEST = 0.48;

/** Pixels between the box and the point, where the other edge leaves more: room for arrows. */
const CLEARANCE = 60;

/** Pixels by which the edge that the box is not at must be better. */
const GAIN = 12;

/** The edge of the picture that the box can be at. */
export type Edge = 'low' | 'high';

/** From the box to the room's edge; see probe.css. CSS pixels. */
const MARGIN = 8;

/** Rooms narrower than this have smaller margins; see probe.css. In font sizes. */
const ROOMY = 40;

/** Margins, paddings and borders on both sides of the table, and a scroll bar. CSS pixels. */
const SPACE = { roomy: 36, small: 22, scrollBar: 12 } as const;

/** The least room beside the table for the angles side on; see probe.css. In font sizes. */
const BESIDE = { width: 58, height: 33 } as const;

/** Largest height of a table's line, and of head and steps around the table. In font sizes. */
const LINES = { row: 1.6, around: 6 } as const;

export class ProbeBox {
  /** The angles side on, where there is room. */
  readonly #plane = new SvgLayer('plane', PLANE);
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
  readonly #room: Room;
  readonly #changed: () => void;
  readonly #release: () => void;

  /**
   * `changed`: another light was chosen, or the box has another size. `release`: the button that takes the pin away was
   * pressed.
   */
  constructor(room: Room, changed: () => void, release: () => void) {
    this.#room = room;
    this.#changed = changed;
    this.#release = release;
    this.#table = new SumTable(changed);
  }

  get chosen(): Chosen {
    return this.#table.chosen;
  }

  template({ content, pinned, releasable, texts }: BoxState): TemplateResult {
    const isEmpty = content === null || typeof content === 'string';
    const layout = isEmpty ? null : this.#layoutOf(content.sum, texts);
    const kinds = {
      pinned,
      alone: !isEmpty && layout === null,
      narrow: layout?.narrow === true,
    };
    // What is hidden keeps its elements.
    return html`<div
      class=${`box ${this.#edge} ${classMap(kinds)}`}
      part="probe"
      role="group"
      ?hidden=${content === null}
      data-empty=${isEmpty ? '' : nothing}
      aria-label=${phrase(texts, 'Probe')}
    >
      <p class="head">
        ${isEmpty ? noChange : colorTemplate(content, texts, layout?.digits ?? 0)}
        <button
          class="release"
          type="button"
          aria-label=${phrase(texts, 'Unpin')}
          ?hidden=${!releasable}
          .textContent=${'×'}
          @click=${this.#release}
        ></button>
      </p>
      <p class="note" dir="auto" .textContent=${isEmpty ? (content ?? '') : noteOf(content, texts)}></p>
      ${isEmpty || layout === null ? noChange : this.#sumTemplate(content, texts, layout)}
    </div>`;
  }

  #sumTemplate(content: BoxContent, texts: ViewerTexts | null, layout: TableLayout): TemplateResult {
    const { fragment, sum, row, halfway } = content;
    this.#plane.show(row === null ? [] : planeOf(fragment, row, halfway));
    return html`
      <div class="beside">
        <div class="scroll">${this.#table.template(sum, row, texts, layout)}</div>
        ${this.#plane.element}
      </div>
      <p
        class="steps"
        id=${STEPS}
        dir="auto"
        .textContent=${row === null ? '' : stepsOf(content, row, texts)}
      ></p>
    `;
  }

  /** The box is in this tree now. */
  follow(root: ParentNode): void {
    this.#resized.observe(root.querySelector('.box')!);
  }

  /** The columns that fit into the room beside everything else in the box. */
  #layoutOf(sum: Sum, texts: ViewerTexts | null): TableLayout | null {
    const { box, fontSize } = this.#room;
    const [width, height] = [box.right - box.left, box.bottom - box.top];
    const lines = sum.rows.length + sum.totals.length + 1;
    const scrolls = (lines * LINES.row + LINES.around) * fontSize > HIGHEST * height;
    const hasPlane = width >= BESIDE.width * fontSize && height >= BESIDE.height * fontSize;
    const around = width < ROOMY * fontSize ? SPACE.small : SPACE.roomy;
    const beside = (scrolls ? SPACE.scrollBar : 0) + (hasPlane ? (PLANE.width / 12 + 1) * fontSize : 0);
    return layoutOf(sum, { width, room: width - around - beside, fontSize }, texts);
  }

  /**
   * Chooses the edge for a point at `y`: the preferred one unless the point is near it and the other one leaves more
   * room. Returns what the box covers of the layer.
   */
  keepAwayFrom(y: number, rtl: boolean, preferred: Edge): Box {
    const { width, height } = this.#size;
    const { box } = this.#room;
    const room = { low: box.bottom - y, high: y - box.top };
    const other = preferred === 'low' ? 'high' : 'low';
    // The current place is preferred by a margin, so that the box does not jump back and forth.
    const lead = this.#edge === other ? GAIN : -GAIN;
    const near = room[preferred] - lead < height + MARGIN + CLEARANCE;
    this.#edge = near && room[other] + lead > room[preferred] ? other : preferred;
    const top = this.#edge === 'high' ? box.top : box.bottom - height - MARGIN;
    const left = rtl ? box.right - width - MARGIN : box.left;
    return { left, right: left + width + MARGIN, top, bottom: top + height + MARGIN };
  }

  dispose(): void {
    this.#resized.disconnect();
  }
}

const classMap = (kinds: Readonly<Record<string, boolean>>): string =>
  Object.keys(kinds)
    .filter((kind) => kinds[kind])
    .join(' ');

function noteOf({ fragment, gouraud }: BoxContent, texts: ViewerTexts | null): string {
  const notes: string[] = [];
  if (fragment.unlit) notes.push(phrase(texts, UNLIT));
  else if (gouraud) notes.push(phrase(texts, GOURAUD));
  if (fragment.filtered) notes.push(phrase(texts, FILTERED));
  return notes.join(' ');
}

/** Under Gouraud shading the row has the corners' terms, so the steps say whose they are. */
function stepsOf({ fragment, halfway, gouraud }: BoxContent, row: SumRow, texts: ViewerTexts | null): string {
  const steps = stepsText(texts, row, fragment, halfway);
  return gouraud ? phrase(texts, 'At the point itself, {steps}', { steps }) : steps;
}

// The colour as a property: a strict CSP refuses style attributes.
const colorTemplate = (
  { fragment, sum: { color } }: BoxContent,
  texts: ViewerTexts | null,
  digits: number,
): TemplateResult => html`
  <span class="swatch" .style=${`background-color: rgb(${color.map((x) => x.toFixed(2)).join(' ')})`}></span>
  <span class="codes" dir="ltr">${fragment.filtered ? '≈ ' : ''}${tripleText(color, digits)}</span>
  <span class="scale" aria-hidden="true">${phrase(texts, 'of 255')}</span>
`;
