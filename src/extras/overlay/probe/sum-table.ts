// Shows a sum as a table. A light is chosen by the pointer on its row or by its button's focus, and
// kept by a press.
import {
  localNumber,
  phrase,
  type ViewerTexts,
  type PhongLight,
  type PhongViewer,
  type FragmentExplanation,
} from '../../../viewer/extra.js';
import { html, nothing, type TemplateResult } from 'lit';
import { type Term, TERMS } from '../../../phong/light/light-state.js';
import { isBlack } from '../../../phong/math/color.js';
import { add } from '../../../phong/math/vector.js';
import { ARROWS } from '../drawing/projection.js';
import {
  byShare,
  shortNumber,
  shownAbsence,
  stepsText,
  type Sum,
  type SumRow,
  sumText,
  termText,
  tripleText,
} from './sum.js';

/** Undefined for no light. Null is the head-light. */
export type Chosen = PhongLight | null | undefined;

/**
 * A column after the light's name. The style sheet hides columns where they have no room. "…" then
 * stands for terms that are in the sum but have no column.
 */
type Column = Term | 'att' | 'decay' | 'sum' | '…';

/** Id of the element with the steps to the chosen light's terms. */
export const STEPS = 'probe-steps';

export class SumTable {
  readonly #choose: () => void;
  /** The lights of the rows, in their order. */
  #lights: readonly Chosen[] = [];
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
    return [this.#pointed, this.#kept].find((light) => this.#lights.includes(light));
  }

  /** Lights that have no row of their own stand in one together: `most` have one. */
  template(
    { sum, row: shown, gouraud, digits = 0 }: SumContent,
    texts: ViewerTexts | null,
    most: number,
  ) {
    const columns = COLUMNS.filter(
      (column) => !gouraud || (column !== 'att' && column !== 'decay'),
    );
    const own = this.#own(sum.rows, most);
    const others = sum.rows.filter((row) => !own.has(row));
    const together = others.length === 0 ? [] : [addedRow(others)];
    const shares = [...own, ...together].map(({ total }) => total);
    this.#lights = sum.rows.map(({ light }) => light);
    // One Tab stop: the row shown, else the first one.
    const stop = shown !== null && own.has(shown) ? shown : sum.rows.find((row) => own.has(row));
    const cells = (row: SumRow) =>
      columns.map(
        (column) =>
          html`<td
            role="cell"
            class=${column === '…' ? termsOf(row) : nothing}
            data-column=${column}
          >
            <bdi dir="ltr" .textContent=${cellText(row, column, texts, digits)}></bdi>
          </td>`,
      );
    return html`<table
      role="table"
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
      <thead role="rowgroup">
        <tr role="row">
          <th role="columnheader" scope="col">${phrase(texts, 'light')}</th>
          ${columns.map((column) => html`<th role="columnheader" scope="col" data-column=${column}>${column === '…' ? column : phrase(texts, column)}</th>`)}
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
        ${together.map(
          (row) =>
            html`<tr role="row" class="others">
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
              ${cells(row)}
            </tr>`,
        )}
      </tbody>
      <tfoot role="rowgroup">
        ${sum.totals.map(
          ({ label, color }) =>
            html`<tr role="row">
              <th role="rowheader" scope="row">${phrase(texts, label)}</th>
              <td role="cell" colspan=${columns.length}>
                <bdi dir="ltr"
                  >${label === 'encoded' ? '≈ ' : ''}${sumText(label === 'sum' ? [...shares, sum.own] : [color], digits, texts)}</bdi
                >
              </td>
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
      ><small dir="auto" .textContent=${absence === null ? '' : phrase(texts, absence)}></small>`;
  }

  #lightAt(target: EventTarget | null): Chosen {
    const row = (target as Element | null)?.closest<HTMLTableRowElement>('tbody > tr');
    return this.#lights[row?.sectionRowIndex ?? -1];
  }

  readonly #point = ({ target }: Event): void => this.#setPointed(this.#lightAt(target));

  readonly #leave = (): void => this.#setPointed(undefined);

  #setPointed(light: Chosen): void {
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
    const [, down = 0] = ARROWS[event.key] ?? [];
    const table = event.currentTarget as Element;
    const shown = 'tbody > tr:not([hidden]) button';
    const buttons = [...table.querySelectorAll<HTMLElement>(shown)];
    const at = buttons.indexOf(event.target as HTMLElement);
    if (down === 0 || at < 0) return;
    event.preventDefault();
    buttons[at + down]?.focus();
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
  texts: ViewerTexts | null,
  digits = 0,
): string {
  if (column === '…') return ''; // the style sheet writes it where one of the terms has no column
  if (column === 'sum') {
    return sumText(
      TERMS.map((term) => row[term]),
      digits,
      texts,
    );
  }
  if (column !== 'att' && column !== 'decay') return termText(row[column], digits, texts);
  // 1 for most lights.
  return Number.isNaN(row[column])
    ? ''
    : shortNumber(row[column], row[column] === 1 ? 0 : 2, texts);
}

export const termsOf = (row: SumRow): string =>
  TERMS.filter((term) => !isBlack(row[term])).join(' ');

const COLUMNS: readonly Column[] = ['…', ...TERMS, 'att', 'decay', 'sum'];

/** A fragment with its sum. */
export interface SumContent {
  readonly fragment: FragmentExplanation;
  readonly sum: Sum;
  /** The row that the steps are about. */
  readonly row: SumRow | null;
  readonly halfway: boolean;
  readonly gouraud: boolean;
  /** Decimals of the colours in the table. Default 0. */
  readonly digits?: number;
}

/**
 * The steps from the vectors of the row's light to its terms. Under Gouraud shading the row has the
 * corners' terms, so the steps say whose they are.
 */
export function stepsTemplate(
  { fragment, row, halfway, gouraud }: SumContent,
  texts: ViewerTexts | null,
): TemplateResult {
  const steps = row === null ? '' : stepsText(texts, row, fragment, halfway);
  const text =
    row !== null && gouraud ? phrase(texts, 'At the point itself, {steps}', { steps }) : steps;
  return html`<p class="steps" id=${STEPS} dir="auto" .textContent=${text}></p>`;
}

// The colour as a property: a strict CSP refuses style attributes.
export const colorTemplate = (
  { fragment, sum: { color } }: SumContent,
  texts: ViewerTexts | null,
): TemplateResult => html`
  <span
    class="swatch"
    .style=${`background-color: rgb(${color.map((x) => x.toFixed(2)).join(' ')})`}
  ></span>
  <span class="codes" dir="ltr"
    >${fragment.filtered ? '≈ ' : ''}${tripleText(color, 0, texts)}</span
  >
  <span class="scale" aria-hidden="true">${phrase(texts, 'of 255')}</span>
`;

/** The row that the steps and the figure are about: the chosen light, or the one that adds most. */
export const rowOf = ({ rows }: Sum, chosen: Chosen): SumRow | null =>
  (chosen === undefined ? byShare(rows)[0] : rows.find(({ light }) => light === chosen)) ?? null;

export const isHalfway = ({ mesh }: FragmentExplanation, viewer: PhongViewer): boolean =>
  (mesh.reflection ?? viewer.reflection) === 'blinn-phong';

export const isGouraud = ({ mesh }: FragmentExplanation, viewer: PhongViewer): boolean =>
  (mesh.shading ?? viewer.shading) === 'gouraud';
