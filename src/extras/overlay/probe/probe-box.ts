// The probe's box: the colour, the table of its sum, and the steps of one light. A column in wide
// pictures, else a strip, away from the point. The style sheet hides columns and lines that have no
// room; lights that have none share a row.
import { localNumber, phrase, type ViewerTexts } from '../../../viewer/extra.js';
import { html, noChange, nothing, render, type TemplateResult } from 'lit';
import { sameValue } from '../../../phong/fields/field-store.js';
import type { Point } from '../drawing/projection.js';
import type { Room } from '../drawing/room.js';
import {
  type Chosen,
  colorTemplate,
  stepsTemplate,
  type SumContent,
  SumTable,
} from './sum-table.js';
import { notesOf } from './sum.js';
import { createElement } from '../drawing/dom.js';

interface BoxState {
  /** A message stands in place of a sum. Null: nothing is shown. */
  readonly content: SumContent | string | null;
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

/**
 * Width of the picture's free part from which on the box is a column, CSS pixels: half of it has room
 * for all terms.
 */
const WIDE = 900;

/**
 * Pixels by which the point has to cross the middle before the box changes sides: it does not jump
 * back and forth.
 */
const GAIN = 4;

export class ProbeBox {
  /** Holds the box, in the free part of the picture. */
  readonly place = createElement('div', { class: 'probe-place' });
  readonly #table: SumTable;
  readonly #room: Room;
  readonly #release: () => void;
  /** The point is in the half where text begins, and in the upper half. */
  #isAtStart = false;
  #isAbove = true;
  /** What rows and steps were fitted to. */
  #fitted: readonly unknown[] = [];
  /** Rows of their own that fit. */
  #lights = 0;

  /**
   * `changed`: another light was chosen. `release`: the button that takes the pin away was pressed.
   */
  constructor(room: Room, changed: () => void, release: () => void) {
    this.#room = room;
    this.#release = release;
    this.#table = new SumTable(changed);
  }

  get chosen(): Chosen {
    return this.#table.chosen;
  }

  /** After a layout: has its text grown out of it? */
  get isHigh(): boolean {
    const { scrollHeight, clientHeight } = this.place.firstElementChild!;
    return scrollHeight > clientHeight;
  }

  /**
   * Shows this. Rows and steps are fitted, which forces a layout of the box, only where more than
   * numbers and side has changed since they were, or `anew`.
   */
  show(state: BoxState, anew = false): void {
    const { box: free, fontSize } = this.#room;
    const { left, right, top, bottom } = free;
    const across = (state.at.x - (left + right) / 2) * (this.place.matches(':dir(rtl)') ? -1 : 1);
    const down = state.at.y - (top + bottom) / 2;
    if (Math.abs(across) > GAIN) {
      this.#isAtStart = across < 0;
    }
    if (Math.abs(down) > GAIN) {
      this.#isAbove = down < 0;
    }
    const [width, height] = [right - left, bottom - top];
    const side =
      width >= WIDE
        ? `column ${this.#isAtStart ? 'end' : ''}`
        : `strip ${this.#isAbove ? 'low' : 'high'}`;
    const { content, texts, releasable } = state;
    const sum = content === null || typeof content === 'string' ? null : content;
    const all = sum?.sum.rows.length ?? 0;
    const message = sum === null ? content : null;
    const fitted = [width, height, fontSize, texts, releasable, message, all];
    if (content === null || (!anew && sameValue(fitted, this.#fitted))) {
      this.#render(state, side, this.#lights);
      return;
    }
    this.#fitted = fitted;
    this.#render(state, side, (this.#lights = all));
    const box = this.place.firstElementChild as HTMLElement;
    // Rows say more than the steps of one light.
    box.removeAttribute('data-brief');
    box.toggleAttribute('data-brief', this.isHigh);
    if (all > 1 && this.isHigh) {
      this.#render(state, side, (this.#lights = this.#lightsThatFit(box, all)));
    }
  }

  /** Rows of their own, by the height of what is shown. Never all but one: its row is as high. */
  #lightsThatFit({ scrollHeight, clientHeight }: HTMLElement, all: number): number {
    const rows = this.place.querySelector('tbody')!.offsetHeight;
    const free = clientHeight - (scrollHeight - rows);
    return Math.max(0, Math.min(Math.floor((free * all) / rows) - 1, all - 2));
  }

  #render({ content, pinned, releasable, texts }: BoxState, side: string, lights: number): void {
    const isEmpty = content === null || typeof content === 'string';
    const more = isEmpty ? 0 : content.sum.rows.length;
    // What is hidden keeps its elements.
    const box: TemplateResult = html`<div
      class=${`box ${side} ${pinned ? 'pinned' : ''}`}
      part="probe"
      role="group"
      ?hidden=${content === null}
      data-empty=${isEmpty ? '' : nothing}
      aria-label=${phrase(texts, 'Probe')}
    >
      <p class="head">
        ${isEmpty ? noChange : colorTemplate(content, texts)}
        <span class="count" ?hidden=${more === 0}
          >${phrase(texts, '+ {number} lights', { number: localNumber(String(more), texts) })}</span
        >
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
        .textContent=${isEmpty ? (content ?? '') : notesOf(content.fragment, content.gouraud, texts).join(' ')}
      ></p>
      ${isEmpty ? noChange : html`${this.#table.template(content, texts, lights)}${stepsTemplate(content, texts)}`}
    </div>`;
    render(box, this.place);
  }
}
