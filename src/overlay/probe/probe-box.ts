// The probe's box: the colour, the table of its sum, and the steps of one light. A column at the picture's side in wide
// pictures, else a strip along its upper or lower edge, whichever is away from the point. The style sheet gives it a
// size; what does not fit in there is left out in a fixed order, by trying.
import { html, noChange, nothing, render, type TemplateResult } from 'lit';
import { create } from '../../element/dom.js';
import { phrase, type ViewerTexts } from '../../element/fields/texts.js';
import type { FragmentExplanation } from '../../element/explanation.js';
import type { Rect } from '../drawing/label-layout.js';
import type { Point } from '../drawing/projection.js';
import type { Room } from '../drawing/room.js';
import type { AnswerDetail } from '../../element/events.js';
import type { Equation } from './equations.js';
import { type Sum, type SumRow, tripleText } from './sum.js';
import { type Chosen, columnsOf, MOST_LEFT, NO_AMBIENT, STEPS, SumTable, type TableShape } from './sum-table.js';
import { Tutor } from './tutor.js';
import { FILTERED, GOURAUD, stepsText, UNLIT } from './words.js';

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

/** What the box shows. */
export interface BoxState {
  /** A message stands in place of a sum. Null: nothing is shown. */
  readonly content: BoxContent | string | null;
  /** The point on the layer. */
  readonly at: Point;
  /** The point stays where it is. The box takes the pointer then; otherwise the picture below it can be reached. */
  readonly pinned: boolean;
  /** The user has pinned it. */
  readonly releasable: boolean;
  readonly texts: ViewerTexts | null;
}

/** One way to show it. */
interface Form {
  readonly isColumn: boolean;
  /** Null: there is only room for the colour. */
  readonly shape: TableShape | null;
  /** Lights with a row of their own; without a table, those that are named as a number. */
  readonly lights: number;
  readonly note: boolean;
  readonly steps: boolean;
}

/** Width of the picture's free part from which on the box is a column, CSS pixels. */
const WIDE = 560;

/** Lights that are not left out before the steps are. */
const LEAST_LIGHTS = 3;

/** Pixels by which the point has to cross the middle before the box changes sides: it does not jump back and forth. */
const GAIN = 4;

export class ProbeBox {
  /** Holds the box, in the free part of the picture. */
  readonly place = create('div', { class: 'probe-place' });
  readonly #table: SumTable;
  readonly #tutor: Tutor;
  readonly #room: Room;
  readonly #release: () => void;
  /** The point is in the half where text begins, and in the upper half. */
  #isAtStart = false;
  #isAbove = true;

  /** `changed`: another light was chosen. `release`: the button that takes the pin away was pressed. */
  constructor(room: Room, changed: () => void, release: () => void, report: (detail: AnswerDetail) => void) {
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
    this.#keepAwayFrom(state.at);
    this.#fit(state);
    return this.#room.rectOf(this.#element);
  }

  get #element(): HTMLElement {
    return this.place.firstElementChild as HTMLElement;
  }

  #keepAwayFrom({ x, y }: Point): void {
    const { left, right, top, bottom } = this.#room.box;
    const across = (x - (left + right) / 2) * (this.place.matches(':dir(rtl)') ? -1 : 1);
    const down = y - (top + bottom) / 2;
    if (Math.abs(across) > GAIN) this.#isAtStart = across < 0;
    if (Math.abs(down) > GAIN) this.#isAbove = down < 0;
  }

  /** The first form that fits. Without a sum there is one. */
  #fit(state: BoxState): void {
    const { box } = this.#room;
    const isWide = box.right - box.left >= WIDE;
    const { content } = state;
    const bare: Form = { isColumn: isWide, shape: null, lights: 0, note: true, steps: true };
    if (content === null || typeof content === 'string' || content.equations !== null) {
      this.#render(state, bare);
      return;
    }
    const { sum, gouraud } = content;
    const shape = (left: number, digits: number, stacked = false): TableShape => ({
      columns: columnsOf(sum, left, !gouraud),
      digits,
      stacked,
    });
    const all = sum.rows.length;
    const fits = (form: Form, isAcross = false): boolean => {
      this.#render(state, form);
      const { scrollWidth, clientWidth, scrollHeight, clientHeight } = this.#element;
      return scrollWidth <= clientWidth && (isAcross || scrollHeight <= clientHeight);
    };
    /** With as many lights as fit, at least `least` and never all but one: its row is as high as that of the others. */
    const fitsWithFewer = (form: Form, least: number): boolean => {
      let [low, high] = [least, all - 2];
      if (low > high || !fits({ ...form, lights: low })) return false;
      while (low < high) {
        const middle = Math.ceil((low + high) / 2);
        if (fits({ ...form, lights: middle })) low = middle;
        else high = middle - 1;
      }
      this.#render(state, { ...form, lights: low });
      return true;
    };
    const fitsSomehow = (isColumn: boolean, shapes: readonly TableShape[], last: readonly TableShape[]): boolean => {
      const full: Form = { ...bare, isColumn, lights: all };
      return (
        [true, false].some((note) => shapes.some((each) => fits({ ...full, note, shape: each }))) ||
        [true, false].some((steps) =>
          last.some((each) => {
            const form: Form = { ...full, note: false, steps, shape: each };
            return fits(form) || fitsWithFewer(form, steps ? LEAST_LIGHTS : 0);
          }),
        )
      );
    };
    const column = [shape(0, 1), shape(0, 0), shape(0, 1, true), shape(0, 0, true)];
    if (isWide && fitsSomehow(true, column, [shape(NO_AMBIENT, 0), shape(NO_AMBIENT, 0, true)])) return;
    const strips = [shape(0, 1), ...Array.from({ length: MOST_LEFT + 1 }, (_, left) => shape(left, 0))];
    const strip = strips
      .filter((each) => fits({ ...bare, isColumn: false, lights: all, shape: each }, true))
      .slice(0, 1);
    const last = [...strip, shape(NO_AMBIENT, 0, true)];
    // The colour alone, with the number of lights behind it where that fits.
    const alone: Form = { ...bare, isColumn: false };
    if (fitsSomehow(false, strip, last) || fits({ ...alone, lights: all })) return;
    this.#render(state, alone);
  }

  #render(state: BoxState, form: Form): void {
    render(this.#template(state, form), this.place);
  }

  #template({ content, pinned, releasable, texts }: BoxState, form: Form): TemplateResult {
    const isEmpty = content === null || typeof content === 'string';
    const { isColumn, shape, note, steps } = form;
    const kinds = {
      pinned,
      ...(isColumn
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
        ${
          shape === null && form.lights > 0
            ? phrase(texts, '+ {number} lights', { number: String(form.lights) })
            : nothing
        }
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
      ${
        !isEmpty && content.equations !== null
          ? this.#tutor.template(content.equations, content.asks, texts)
          : isEmpty || shape === null
            ? noChange
            : this.#sumTemplate(content, texts, shape, form.lights)
      }
    </div>`;
  }

  #sumTemplate(content: BoxContent, texts: ViewerTexts | null, shape: TableShape, lights: number): TemplateResult {
    const { sum, row } = content;
    return html`
      ${this.#table.template(sum, row, texts, shape, lights)}
      <p class="steps" id=${STEPS} dir="auto" .textContent=${row === null ? '' : stepsOf(content, row, texts)}></p>
    `;
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
  <span class="codes" dir="ltr">${fragment.filtered ? '≈ ' : ''}${tripleText(color, digits, texts)}</span>
  <span class="scale" aria-hidden="true">${phrase(texts, 'of 255')}</span>
`;
