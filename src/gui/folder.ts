// A folder of the panel. Its rows are built when it is first opened and refreshed only while they are visible. It opens
// without animation, so it requests no frame.
import type { GUI } from 'lil-gui';
import type { ViewerText } from '../element/fields/texts.js';
import { label } from './label.js';
import { type AddedRow, addRows, type Editable, type RowContext, type Rows } from './rows.js';

export class Folder<E extends Editable> {
  readonly gui: GUI;
  readonly #place: RowContext<E>;
  readonly #table: Rows<E>;
  readonly #built: (gui: GUI) => void;
  #rows: ReadonlyMap<string, AddedRow<E>> | null = null;
  #stale = true;

  /** Starts closed. `title`: null if the caller writes it. `built`: adds what stands below the table's rows. */
  constructor(
    parent: GUI,
    title: ViewerText | null,
    place: RowContext<E>,
    table: Rows<E>,
    built: (gui: GUI) => void = () => undefined,
  ) {
    this.gui = addGroup(parent, title).close();
    this.#place = place;
    this.#table = table;
    this.#built = built;
  }

  /** Marks the rows as outdated and refreshes them if they are visible. */
  update(): void {
    this.#stale = true;
    this.refreshVisible();
  }

  /** Refreshes outdated rows if they are visible. To be called whenever a folder around it opens. */
  refreshVisible(): void {
    if (!this.#stale || this.gui.domElement.closest('.lil-closed') !== null) return;
    this.#stale = false;
    if (this.#rows === null) {
      this.#rows = addRows(this.gui, this.#place, this.#table);
      this.#built(this.gui);
    }
    showRows(this.#place.element, [...this.#rows.values()]);
    for (const control of this.gui.controllers) control.updateDisplay();
  }

  /** Opens the folder with its rows. */
  open(): void {
    this.gui.open();
    this.refreshVisible();
  }

  /** Opens the folder and puts the focus into a field's row. */
  edit(field: string): void {
    this.open();
    const [control] = this.#rows?.get(field)?.controls ?? [];
    control?.domElement.querySelector('input')?.focus();
  }
}

/** Shows the rows whose condition holds. One stays while it, or a row under the same condition, is being edited. */
export function showRows<E>(element: E, rows: readonly AddedRow<E>[]): void {
  for (const { row, controls } of rows) {
    const { shown } = row;
    if (shown === undefined) continue;
    const together = rows.filter((other) => other.row.shown === shown).flatMap((other) => other.controls);
    const visible = shown(element) || together.some(({ domElement }) => domElement.matches(':focus-within'));
    for (const control of controls) control.show(visible);
  }
}

/** A folder of folders. Starts open. `title`: null if the caller writes it. */
export function addGroup(parent: GUI, title: ViewerText | null): GUI {
  const gui = withoutAnimation(parent.addFolder(''));
  if (title !== null) label(gui.$title, (say) => gui.title(say(title)));
  return gui;
}

/** Makes a GUI open and close without animation. */
export function withoutAnimation(gui: GUI): GUI {
  gui.openAnimated = (open = true) => gui.open(open);
  return gui;
}
