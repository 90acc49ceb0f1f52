// How does the user edit text? In one field, written while the user types. Knows nothing about the text.
import { Controller, type GUI } from 'lil-gui';
import type { ViewerText } from '../element/fields/text-list.js';
import type { Bound } from './bound.js';
import { nameRow } from './label.js';
import { accepted, TextField } from './text-field.js';

export class TextControl extends Controller {
  readonly #field: TextField;

  constructor(folder: GUI, bound: Bound<string>, name: ViewerText) {
    super(folder, bound, 'value', 'text');
    nameRow(this, name);
    this.#field = new TextField({
      read: () => bound.value,
      write: (text) => accepted(() => (bound.value = text)),
    });
    this.input.setAttribute('aria-labelledby', this.$name.id);
    this.$widget.append(this.input);
    this.updateDisplay();
  }

  get input(): HTMLInputElement {
    return this.#field.input;
  }

  override updateDisplay(): this {
    this.#field.update();
    return this;
  }
}
