// How does a sum look as a table? A real one, with a caption and headers. Cells are kept from sum to sum and only texts that differ are
// written, so that it can follow the pointer. One light can be chosen: by the pointer on its row, by its button's focus, and kept by a
// press. Knows neither the scene nor where the table is.
import { phrase, type ViewerTexts } from '../../element/fields/texts.js';
import type { PhongLight } from '../../element/phong-light.js';
import { create, set, write } from '../../element/viewer/template.js';
import type { Vec3 } from '../../math/vector.js';
import { numberText, type Sum, type SumRow, tripleText } from './sum.js';

/** Undefined for no light. Null is the head-light. */
export type Chosen = PhongLight | null | undefined;

/** Id of the element with the steps to the chosen light's terms. */
export const STEPS = 'probe-steps';

interface Row {
  readonly element: HTMLTableRowElement;
  readonly cells: readonly HTMLTableCellElement[];
}

interface LightRow extends Row {
  readonly button: HTMLButtonElement;
  /** Why the light adds less than one might expect. */
  readonly note: HTMLElement;
}

const COLUMNS = ['light', 'ambient', 'diffuse', 'specular', 'att', 'decay', 'sum'] as const;

export class SumTable {
  readonly element = create('table', {});
  readonly #caption = create('caption', { class: 'reader' });
  readonly #heads = COLUMNS.map(() => create('th', { scope: 'col' }));
  readonly #body = create('tbody', {});
  readonly #foot = create('tfoot', {});
  readonly #choose: () => void;
  readonly #lightRows: LightRow[] = [];
  readonly #totalRows: Row[] = [];
  /** The lights of the rows, in their order. */
  #lights: readonly (PhongLight | null)[] = [];
  /** Under the pointer, or with the focus. */
  #looked: Chosen;
  /** Pressed. */
  #kept: Chosen;

  /** `choose` is called when another light is chosen. */
  constructor(choose: () => void) {
    this.#choose = choose;
    const head = create('tr', {});
    head.append(...this.#heads);
    const top = create('thead', {});
    top.append(head);
    this.element.append(this.#caption, top, this.#body, this.#foot);
    const { element } = this;
    element.addEventListener('pointerover', ({ target }) => this.#look(target));
    element.addEventListener('pointerleave', () => this.#look(null));
    element.addEventListener('focusin', ({ target }) => this.#look(target));
    element.addEventListener('focusout', () => this.#look(null));
    element.addEventListener('click', ({ target }) => this.#press(target));
    element.addEventListener('keydown', (event) => this.#moveFocus(event));
  }

  /** The light whose row the user has chosen. */
  get chosen(): Chosen {
    return [this.#looked, this.#kept].find((light) => light !== undefined && this.#lights.includes(light));
  }

  /** `shown`: the light that the figure is about. `digits`: decimals of the codes. */
  show(sum: Sum, shown: SumRow | null, texts: ViewerTexts | null, digits: number): void {
    this.#lights = sum.rows.map(({ light }) => light);
    write(this.#caption, phrase(texts, 'Red, green and blue of each term; 255 is full'));
    this.#heads.forEach((head, i) => write(head, phrase(texts, COLUMNS[i]!)));
    resize(this.#lightRows, sum.rows.length, () => this.#addLightRow());
    resize(this.#totalRows, sum.totals.length, () => this.#addTotalRow());
    // One Tab stop: the row shown, else the first one.
    const stop = Math.max(shown === null ? 0 : sum.rows.indexOf(shown), 0);
    sum.rows.forEach((row, i) => {
      const { element, cells, button, note } = this.#lightRows[i]!;
      set(element, 'class', row === shown ? 'shown' : null);
      set(button, 'tabindex', i === stop ? '0' : '-1');
      set(button, 'aria-pressed', String(this.#kept !== undefined && this.#kept === row.light));
      write(button, row.name);
      write(note, row.absence === null ? '' : phrase(texts, row.absence));
      contentsOf(row, digits).forEach((text, column) => write(cells[column]!, text));
    });
    sum.totals.forEach((total, i) => {
      const [head, cell] = this.#totalRows[i]!.cells;
      write(head!, phrase(texts, total.label));
      write(cell!, tripleText(total.color, digits));
    });
  }

  #addLightRow(): LightRow {
    const button = create('button', { type: 'button', 'aria-describedby': STEPS, dir: 'auto' });
    const note = create('small', {});
    const head = create('th', { scope: 'row' });
    head.append(button, note);
    // Numbers keep their order in languages that are written from the right.
    const cells = COLUMNS.slice(1).map(() => create('td', { dir: 'ltr' }));
    const element = create('tr', {});
    element.append(head, ...cells);
    this.#body.append(element);
    return { element, cells, button, note };
  }

  #addTotalRow(): Row {
    const head = create('th', { scope: 'row', colspan: String(COLUMNS.length - 1) });
    const cell = create('td', { dir: 'ltr' });
    const element = create('tr', {});
    element.append(head, cell);
    this.#foot.append(element);
    return { element, cells: [head, cell] };
  }

  #lightAt(target: EventTarget | null): Chosen {
    const index = this.#lightRows.findIndex(({ element }) => element.contains(target as Node | null));
    return index < 0 ? undefined : this.#lights[index];
  }

  #look(target: EventTarget | null): void {
    const light = target === null ? undefined : this.#lightAt(target);
    if (light === this.#looked) return;
    this.#looked = light;
    this.#choose();
  }

  #press(target: EventTarget | null): void {
    const light = this.#lightAt(target);
    if (light === undefined) return;
    this.#kept = light === this.#kept ? undefined : light;
    this.#choose();
  }

  #moveFocus(event: KeyboardEvent): void {
    const step = { ArrowDown: 1, ArrowUp: -1 }[event.key];
    const index = this.#lightRows.findIndex(({ button }) => button === event.target);
    if (step === undefined || index < 0) return;
    event.preventDefault();
    this.#lightRows[index + step]?.button.focus();
  }
}

const contentsOf = (row: SumRow, digits: number): string[] => [
  ...[row.ambient, row.diffuse, row.specular].map((color) => termText(color, digits)),
  factorText(row.att),
  factorText(row.decay),
  termText(row.total, digits),
];

/** 1 for most lights. */
const factorText = (factor: number): string => numberText(factor, factor === 1 ? 0 : 2);

/** A term that adds nothing is one zero: most are, and the others are easier to find. */
const termText = (color: Vec3, digits: number): string =>
  color.every((x) => x === 0) ? '0' : tripleText(color, digits);

function resize<Row extends { readonly element: Element }>(rows: Row[], count: number, add: () => Row): void {
  for (const { element } of rows.splice(count)) element.remove();
  while (rows.length < count) rows.push(add());
}
