// A row in which the user selects one of several values. Its list can change, and stays open while the value stays the
// same.
import { Controller, type GUI } from 'lil-gui';
import type { ViewerText } from '../element/fields/texts.js';
import { sameValue } from '../fields/field-store.js';
import type { Bound } from './bound.js';
import { label, nameRow, type Say } from './label.js';

export class SelectControl<T extends string | null> extends Controller {
  readonly #listed: () => readonly T[];
  readonly #text: (value: T, say: Say) => string;
  readonly #select = document.createElement('select');
  #values: readonly T[] = [];

  /** `listed`: the values, in their order in the list; read again at each update. */
  constructor(
    folder: GUI,
    bound: Bound<T>,
    name: ViewerText,
    listed: () => readonly T[],
    text: (value: T, say: Say) => string,
  ) {
    super(folder, bound, 'value', 'lil-option');
    nameRow(this, name);
    this.#listed = listed;
    this.#text = text;
    this.#select.setAttribute('aria-labelledby', this.$name.id);
    this.#select.addEventListener('change', () => (bound.value = this.#values[this.#select.selectedIndex]!));
    this.$widget.append(this.#select);
    this.updateDisplay();
  }

  override updateDisplay(): this {
    const values = this.#listed();
    if (!sameValue(values, this.#values)) this.#fill(values);
    const index = values.indexOf(this.getValue() as T);
    // Assigning the index, even the same one, would close an open list.
    if (this.#select.selectedIndex !== index) this.#select.selectedIndex = index;
    return this;
  }

  #fill(values: readonly T[]): void {
    this.#values = values;
    this.#select.replaceChildren(...values.map(() => document.createElement('option')));
    label(this.#select, (say) =>
      values.forEach((value, i) => (this.#select.options[i]!.textContent = this.#text(value, say))),
    );
  }
}
