// The probe's box: the colour, the table of its sum, and the steps of one light. A column in wide
// pictures, else a strip, away from the point. The style sheet gives its size; what does not fit is
// left out in a fixed order, by trying.
import { html, noChange, nothing, render, type TemplateResult } from 'lit';
import {
  type AnswerDetail,
  create,
  type FragmentExplanation,
  phrase,
  type ViewerTexts,
} from '../../../viewer/extra.js';
import type { Rect } from '../drawing/label-layout.js';
import type { Point } from '../drawing/projection.js';
import type { Room } from '../drawing/room.js';
import type { Equation } from './equations.js';
import { type Sum, type SumRow, tripleText, FILTERED, GOURAUD, stepsText, UNLIT } from './sum.js';
import {
  type Chosen,
  columnsOf,
  MOST_LEFT,
  NO_AMBIENT,
  STEPS,
  SumTable,
  type TableShape,
} from './sum-table.js';
import { Tutor } from './tutor.js';

/** A fragment with its sum. */
export interface BoxContent {
  readonly fragment: FragmentExplanation;
  readonly sum: Sum;
  /** The row that the figure is about. */
  readonly row: SumRow | null;
  readonly halfway: boolean;
  readonly gouraud: boolean;
  /** They replace the table. */
  readonly equations: readonly Equation[] | null;
  /** Their results are questions. */
  readonly asks: boolean;
}

export interface BoxState {
  /** A message stands in place of a sum. Null: nothing is shown. */
  readonly content: BoxContent | string | null;
  /** The point on the layer. */
  readonly at: Point;
  /**
   * The point stays where it is. The box takes the pointer then; otherwise the picture below it can
   * be reached.
   */
  readonly pinned: boolean;
  /** The user has pinned it. */
  readonly releasable: boolean;
  readonly texts: ViewerTexts | null;
}

/** One way to show it. */
interface Form {
  /** Null: there is only room for the colour. */
  readonly shape: TableShape | null;
  /** Lights with a row of their own; without a table, those that are named as a number. */
  readonly lights: number;
  readonly note: boolean;
  readonly steps: boolean;
}

/**
 * What is left out, in this order, where room lacks. `least`: lights with a row of their own; the
 * others share one.
 */
const LEVELS = [
  { note: true, steps: true, least: Infinity },
  { note: false, steps: true, least: Infinity },
  { note: false, steps: true, least: 3 },
  { note: false, steps: false, least: 0 },
] as const;

/** Width of the picture's free part from which on the box is a column, CSS pixels. */
const WIDE = 560;

/**
 * Pixels by which the point has to cross the middle before the box changes sides: it does not jump
 * back and forth.
 */
const GAIN = 4;

export class ProbeBox {
  /** Holds the box, in the free part of the picture. */
  readonly place = create('div', { class: 'probe-place' });
  readonly #table: SumTable;
  readonly #tutor: Tutor;
  readonly #room: Room;
  readonly #release: () => void;
  #isColumn = false;
  /** The point is in the half where text begins, and in the upper half. */
  #isAtStart = false;
  #isAbove = true;

  /**
   * `changed`: another light was chosen. `release`: the button that takes the pin away was pressed.
   */
  constructor(
    room: Room,
    changed: () => void,
    release: () => void,
    report: (detail: AnswerDetail) => void,
  ) {
    this.#tutor = new Tutor(changed, report);
    this.#room = room;
    this.#release = release;
    this.#table = new SumTable(changed);
  }

  get chosen(): Chosen {
    return this.#table.chosen;
  }

  /** Shows this, and gives what the box covers of the layer. Forces a layout, of this box alone. */
  show(state: BoxState): Rect {
    const { left, right, top, bottom } = this.#room.box;
    const across = (state.at.x - (left + right) / 2) * (this.place.matches(':dir(rtl)') ? -1 : 1);
    const down = state.at.y - (top + bottom) / 2;
    if (Math.abs(across) > GAIN) {
      this.#isAtStart = across < 0;
    }
    if (Math.abs(down) > GAIN) {
      this.#isAbove = down < 0;
    }
    this.#isColumn = right - left >= WIDE;
    const { content } = state;
    const hasSum = content !== null && typeof content !== 'string' && content.equations === null;
    if (!hasSum || !this.#fits(state, content)) {
      this.#render(state, { shape: null, lights: 0, note: true, steps: true });
    }
    return this.#room.rectOf(this.#element);
  }

  get #element(): HTMLElement {
    return this.place.firstElementChild as HTMLElement;
  }

  /** Shows the first form that fits. False if none does. */
  #fits(state: BoxState, { sum, gouraud }: BoxContent): boolean {
    const all = sum.rows.length;
    const shape = (left: number, digits: number, stacked = false): TableShape => ({
      columns: columnsOf(sum, left, !gouraud),
      digits,
      stacked,
    });
    const fits = (form: Form, isAcross = false): boolean => {
      this.#render(state, form);
      const { scrollWidth, clientWidth, scrollHeight, clientHeight } = this.#element;
      return scrollWidth <= clientWidth && (isAcross || scrollHeight <= clientHeight);
    };
    /** With as many lights as fit, never all but one: its row is as high as that of the others. */
    const fitsWithFewer = (form: Form, least: number): boolean => {
      let [low, high] = [least, all - 2];
      if (low > high || !fits({ ...form, lights: low })) return false;
      while (low < high) {
        const middle = Math.ceil((low + high) / 2);
        if (fits({ ...form, lights: middle })) {
          low = middle;
        } else {
          high = middle - 1;
        }
      }
      return fits({ ...form, lights: low });
    };
    const rows = [
      shape(0, 1),
      ...Array.from({ length: MOST_LEFT + 1 }, (_, left) => shape(left, 0)),
    ];
    const full = { ...LEVELS[0], lights: all };
    const widest = this.#isColumn
      ? shape(NO_AMBIENT, 0)
      : rows.find((each) => fits({ ...full, shape: each }, true));
    const fewest = [...(widest === undefined ? [] : [widest]), shape(NO_AMBIENT, 0, true)];
    const most = this.#isColumn
      ? [...rows.slice(0, 2), shape(0, 1, true), shape(0, 0, true)]
      : fewest.slice(0, -1);
    const fitsAt = ({ least, ...level }: (typeof LEVELS)[number]): boolean =>
      (least === Infinity ? most : fewest).some((each) => {
        const form = { ...level, lights: all, shape: each };
        return fits(form) || fitsWithFewer(form, least);
      });
    return LEVELS.some(fitsAt) || fits({ ...full, shape: null });
  }

  #render(state: BoxState, form: Form): void {
    render(this.#template(state, form), this.place);
  }

  #template({ content, pinned, releasable, texts }: BoxState, form: Form): TemplateResult {
    const isEmpty = content === null || typeof content === 'string';
    const { shape, lights, note, steps } = form;
    const kinds = {
      pinned,
      ...(this.#isColumn
        ? { column: true, end: this.#isAtStart }
        : { strip: true, low: this.#isAbove, high: !this.#isAbove }),
      tutor: !isEmpty && content.equations !== null,
      asks: !isEmpty && content.asks,
      alone: !isEmpty && content.equations === null && shape === null,
      stacked: shape?.stacked === true,
      fine: shape?.digits === 1,
      'no-note': !note,
      'no-steps': !steps,
    };
    // What is hidden keeps its elements.
    return html`<div
      class=${`box ${classMap(kinds)}`}
      part="probe"
      role="group"
      ?hidden=${content === null}
      data-empty=${isEmpty ? '' : nothing}
      aria-label=${phrase(texts, 'Probe')}
    >
      <p class="head">
        ${isEmpty ? noChange : colorTemplate(content, texts, shape?.digits ?? 0)}
        ${shape === null && lights > 0 ? phrase(texts, '+ {number} lights', { number: String(lights) }) : nothing}
        <button
          class="release"
          type="button"
          aria-label=${phrase(texts, 'Unpin')}
          ?hidden=${!releasable}
          .textContent=${'×'}
          @click=${this.#release}
        ></button>
      </p>
      <p
        class="note"
        dir="auto"
        .textContent=${isEmpty ? (content ?? '') : noteOf(content, texts)}
      ></p>
      ${
        !isEmpty && content.equations !== null
          ? this.#tutor.template(content.equations, content.asks, texts)
          : isEmpty || shape === null
            ? noChange
            : this.#sumTemplate(content, texts, shape, lights)
      }
    </div>`;
  }

  #sumTemplate(
    content: BoxContent,
    texts: ViewerTexts | null,
    shape: TableShape,
    lights: number,
  ): TemplateResult {
    const { sum, row } = content;
    return html`
      ${this.#table.template(sum, row, texts, shape, lights)}
      <p
        class="steps"
        id=${STEPS}
        dir="auto"
        .textContent=${row === null ? '' : stepsOf(content, row, texts)}
      ></p>
    `;
  }
}

const classMap = (kinds: Readonly<Record<string, boolean>>): string =>
  Object.keys(kinds)
    .filter((kind) => kinds[kind])
    .join(' ');

function noteOf({ fragment, gouraud }: BoxContent, texts: ViewerTexts | null): string {
  const notes: string[] = [];
  if (fragment.unlit) {
    notes.push(phrase(texts, UNLIT));
  } else if (gouraud) {
    notes.push(phrase(texts, GOURAUD));
  }
  if (fragment.filtered) {
    notes.push(phrase(texts, FILTERED));
  }
  return notes.join(' ');
}

/** Under Gouraud shading the row has the corners' terms, so the steps say whose they are. */
function stepsOf(
  { fragment, halfway, gouraud }: BoxContent,
  row: SumRow,
  texts: ViewerTexts | null,
): string {
  const steps = stepsText(texts, row, fragment, halfway);
  return gouraud ? phrase(texts, 'At the point itself, {steps}', { steps }) : steps;
}

// The colour as a property: a strict CSP refuses style attributes.
const colorTemplate = (
  { fragment, sum: { color } }: BoxContent,
  texts: ViewerTexts | null,
  digits: number,
): TemplateResult => html`
  <span
    class="swatch"
    .style=${`background-color: rgb(${color.map((x) => x.toFixed(2)).join(' ')})`}
  ></span>
  <span class="codes" dir="ltr"
    >${fragment.filtered ? '≈ ' : ''}${tripleText(color, digits, texts)}</span
  >
  <span class="scale" aria-hidden="true">${phrase(texts, 'of 255')}</span>
`;
