// Shows a sum as a table. A light is chosen by the pointer on its row or by its button's focus, and
// kept by a press.
import { html, nothing, type TemplateResult } from 'lit';
import { localNumber, type PhongLight, phrase, type ViewerTexts } from '../../../viewer/extra.js';
import { type Term, TERMS } from '../../../phong/light/light-state.js';
import { isBlack } from '../../../phong/math/color.js';
import { add } from '../../../phong/math/vector.js';
import {
  byShare,
  shortNumber,
  shownAbsence,
  type Sum,
  type SumRow,
  termText,
  tripleText,
} from './sum.js';

/** Undefined for no light. Null is the head-light. */
export type Chosen = PhongLight | null | undefined;

/** A column after the light's name. "…" stands for terms that are in the sum but have no column. */
export type Column = Term | 'att' | 'decay' | 'sum' | '…';

export interface TableShape {
  readonly columns: readonly Column[];
  /** Decimals of its codes. */
  readonly digits: number;
  /** Each light's numbers stand below its name. */
  readonly stacked: boolean;
}

/** Id of the element with the steps to the chosen light's terms. */
export const STEPS = 'probe-steps';

export class SumTable {
  readonly #choose: () => void;
  /** The lights of the rows, in their order. */
  #lights: readonly (PhongLight | null)[] = [];
  /** Under the pointer, or with the focus. */
  #pointed: Chosen;
  /** Pressed. */
  #kept: Chosen;
  /** Lights that presses on the row of the others have passed over. */
  #turned = 0;

  /** `choose` is called when another light is chosen. */
  constructor(choose: () => void) {
    this.#choose = choose;
  }

  /** The light whose row the user has chosen. */
  get chosen(): Chosen {
    return [this.#pointed, this.#kept].find(
      (light) => light !== undefined && this.#lights.includes(light),
    );
  }

  /** `shown`: the light that the figure is about. `most`: lights with a row of their own. */
  template(
    sum: Sum,
    shown: SumRow | null,
    texts: ViewerTexts | null,
    shape: TableShape,
    most: number,
  ): TemplateResult {
    const { columns, digits } = shape;
    const own = this.#own(sum.rows, most);
    const others = sum.rows.filter((row) => !own.has(row));
    this.#lights = sum.rows.map(({ light }) => light);
    // One Tab stop: the row shown, else the first one.
    const stop = shown !== null && own.has(shown) ? shown : sum.rows.find((row) => own.has(row));
    const cells = (row: SumRow): readonly TemplateResult[] =>
      columns.map(
        (column) =>
          html`<td
            role="cell"
            dir="ltr"
            class=${isIdle(row, column) ? 'idle' : nothing}
            data-column=${column}
            data-title=${columnTitle(column, texts)}
            .textContent=${cellText(row, column, shape, texts)}
          ></td>`,
      );
    return html`<table
      role="table"
      class=${shape.stacked ? 'stacked' : nothing}
      @pointerover=${this.#point}
      @pointerleave=${this.#leave}
      @focusin=${this.#point}
      @focusout=${this.#leave}
      @click=${this.#press}
      @keydown=${this.#moveFocus}
    >
      <caption class="reader">
        ${phrase(texts, 'Red, green and blue of each term; 255 is full')}
      </caption>
      <thead class=${shape.stacked ? 'reader' : nothing} role="rowgroup">
        <tr role="row">
          <th role="columnheader" scope="col">${phrase(texts, 'light')}</th>
          ${columns.map((column) => html`<th role="columnheader" scope="col">${columnTitle(column, texts)}</th>`)}
        </tr>
      </thead>
      <tbody role="rowgroup">
        ${sum.rows.map(
          (row) =>
            html`<tr role="row" class=${row === shown ? 'shown' : nothing} ?hidden=${!own.has(row)}>
              <th role="rowheader" scope="row">${this.#headTemplate(row, row === stop, texts)}</th>
              ${cells(row)}
            </tr>`,
        )}
        ${
          others.length === 0
            ? nothing
            : html`<tr role="row" class="others">
                <th role="rowheader" scope="row">
                  <button
                    type="button"
                    tabindex=${own.size === 0 ? 0 : -1}
                    .textContent=${phrase(texts, '+ {number} lights', {
                      number: localNumber(String(others.length), texts),
                    })}
                    @click=${() => this.#turn(most)}
                  ></button>
                </th>
                ${cells(addedRow(others))}
              </tr>`
        }
      </tbody>
      <tfoot role="rowgroup">
        ${sum.totals.map(
          ({ label, color }) =>
            html`<tr role="row">
              <th role="rowheader" scope="row" colspan=${columns.length}>
                ${phrase(texts, label)}
              </th>
              <td role="cell" dir="ltr">${tripleText(color, digits, texts)}</td>
            </tr>`,
        )}
      </tfoot>
    </table>`;
  }

  /** The lights that add most. A press on the row of the others shows the next ones. */
  #own(rows: readonly SumRow[], most: number): ReadonlySet<SumRow> {
    const order = byShare(rows);
    return new Set(
      [...order.slice(this.#turned % Math.max(rows.length, 1)), ...order].slice(0, most),
    );
  }

  #turn(by: number): void {
    this.#turned += Math.max(by, 1);
    this.#choose();
  }

  /** The light's name, and why it adds less than one might expect. */
  #headTemplate(row: SumRow, isStop: boolean, texts: ViewerTexts | null): TemplateResult {
    const { light, name } = row;
    const absence = shownAbsence(row);
    return html`<button
        type="button"
        aria-describedby=${STEPS}
        dir="auto"
        tabindex=${isStop ? 0 : -1}
        aria-pressed=${this.#kept !== undefined && this.#kept === light}
        .textContent=${name}
      ></button
      ><small .textContent=${absence === null ? '' : phrase(texts, absence)}></small>`;
  }

  #lightAt(target: EventTarget | null): Chosen {
    const row = (target as Element | null)?.closest<HTMLTableRowElement>('tbody > tr');
    return row === null || row === undefined ? undefined : this.#lights[row.sectionRowIndex];
  }

  readonly #point = ({ target }: Event): void => this.#look(this.#lightAt(target));

  readonly #leave = (): void => this.#look(undefined);

  #look(light: Chosen): void {
    if (light === this.#pointed) return;
    this.#pointed = light;
    // Not at once: a row that is being removed loses the focus in the middle of a template.
    queueMicrotask(this.#choose);
  }

  readonly #press = ({ target }: Event): void => {
    const light = this.#lightAt(target);
    if (light === undefined) return;
    this.#kept = light === this.#kept ? undefined : light;
    this.#choose();
  };

  readonly #moveFocus = (event: KeyboardEvent): void => {
    const step = { ArrowDown: 'nextElementSibling', ArrowUp: 'previousElementSibling' } as const;
    const row = (event.target as Element).closest('tbody > tr');
    if (!(event.key in step) || row === null) return;
    event.preventDefault();
    const sibling = step[event.key as keyof typeof step];
    let next = row[sibling];
    while (next !== null && (next as HTMLElement).hidden) {
      next = next[sibling];
    }
    next?.querySelector('button')?.focus();
  };
}

/** Several lights as one row, without factors. */
const addedRow = ([first, ...rest]: readonly SumRow[]): SumRow =>
  rest.reduce(
    (all, { ambient, diffuse, specular, total }) => ({
      ...all,
      ambient: add(all.ambient, ambient),
      diffuse: add(all.diffuse, diffuse),
      specular: add(all.specular, specular),
      total: add(all.total, total),
    }),
    { ...first!, att: NaN, decay: NaN },
  );

/**
 * What is in a cell: numbers, which keep their order in languages that are written from the right.
 */
export function cellText(
  row: SumRow,
  column: Column,
  { columns, digits }: TableShape,
  texts: ViewerTexts | null,
): string {
  if (column === '…') {
    return TERMS.some((term) => !columns.includes(term) && !isBlack(row[term])) ? column : '';
  }
  if (column === 'sum') return termText(row.total, digits, texts);
  if (column !== 'att' && column !== 'decay') return termText(row[column], digits, texts);
  // 1 for most lights.
  return Number.isNaN(row[column])
    ? ''
    : shortNumber(row[column], row[column] === 1 ? 0 : 2, texts);
}

/** A number that a stacked table leaves out. */
const isIdle = (row: SumRow, column: Column): boolean =>
  column === 'ambient'
    ? isBlack(row.ambient)
    : (column === 'att' || column === 'decay') && row[column] === 1;

const columnTitle = (column: Column, texts: ViewerTexts | null): string =>
  column === '…' ? column : phrase(texts, column);

/** The first one is left out first. */
const DISPENSABLE: readonly Column[] = ['decay', 'att', 'ambient', 'specular', 'diffuse'];

/**
 * All columns but the first `left` of the dispensable ones. `factors`: att and decay belong to the
 * terms.
 */
export function columnsOf({ rows }: Sum, left: number, factors: boolean): readonly Column[] {
  const all: readonly Column[] = [...TERMS, ...(factors ? (['att', 'decay'] as const) : []), 'sum'];
  const columns = all.filter((column) => !DISPENSABLE.slice(0, left).includes(column));
  const hasMore = TERMS.some(
    (term) => !columns.includes(term) && rows.some((row) => !isBlack(row[term])),
  );
  return hasMore ? ['…', ...columns] : columns;
}

/** The number of columns left out with ambient. */
export const NO_AMBIENT = DISPENSABLE.indexOf('ambient') + 1;

export const MOST_LEFT = DISPENSABLE.length;
