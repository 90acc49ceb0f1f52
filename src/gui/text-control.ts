// Rows of text: a field that writes while the user types, and text that the user cannot edit.
import { Controller, type GUI } from 'lil-gui';
import { write } from '../element/dom.js';
import type { ViewerText } from '../element/fields/text-list.js';
import { accepted, bound, type Bound } from './bound.js';
import { nameRow } from './label.js';

export class TextControl extends Controller {
  readonly #field: TextField;
  readonly #placeholder: () => string;

  /** `placeholder`: shown in the empty field; read again at each update. */
  constructor(folder: GUI, bound: Bound<string>, name: ViewerText, placeholder: () => string) {
    super(folder, bound, 'value', 'text');
    nameRow(this, name);
    this.#field = new TextField({
      read: () => bound.value,
      write: (text) => accepted(() => (bound.value = text)),
    });
    this.#placeholder = placeholder;
    const { input } = this.#field;
    input.setAttribute('aria-labelledby', this.$name.id);
    this.$widget.append(input);
    this.updateDisplay();
  }

  override updateDisplay(): this {
    this.#field.input.placeholder = this.#placeholder();
    this.#field.update();
    return this;
  }
}

/** Text that follows the pictures of a viewer. */
export class Readout extends Controller {
  readonly #viewer: HTMLElement;

  constructor(folder: GUI, text: () => string, name: ViewerText, viewer: HTMLElement) {
    super(folder, bound(text), 'value', 'readout');
    this.#viewer = viewer;
    nameRow(this, name);
    viewer.addEventListener('render', this.#update);
    this.#update();
  }

  override updateDisplay(): this {
    this.#update();
    return this;
  }

  override destroy(): void {
    this.#viewer.removeEventListener('render', this.#update);
    super.destroy();
  }

  readonly #update = (): void => write(this.$widget, this.getValue() as string);
}

interface TextBinding {
  /** The value as text. */
  read(): string;
  /** Writes the text's value. Returns false if it is refused. */
  write(text: string): boolean;
}

/**
 * Accepted text is written at once, refused text is marked. Nothing overwrites the text while the user types;
 * afterwards the field shows the value.
 */
export class TextField {
  readonly input = document.createElement('input');
  readonly #binding: TextBinding;
  #typing = false;

  constructor(binding: TextBinding) {
    this.#binding = binding;
    const { input } = this;
    input.type = 'text';
    input.autocomplete = 'off';
    input.spellcheck = false;
    input.addEventListener('focus', () => input.select());
    input.addEventListener('input', () => {
      this.#typing = true;
      this.#valid = binding.write(input.value);
    });
    input.addEventListener('keydown', (event) => {
      if (event.key === 'Enter') input.blur();
    });
    input.addEventListener('blur', () => this.settle());
  }

  /** Shows the value, unless the user types. */
  update(): void {
    if (this.#typing) return;
    const text = this.#binding.read();
    if (this.input.value !== text) this.input.value = text;
  }

  /** Ends typing: shows the value. */
  settle(): void {
    this.#typing = false;
    this.#valid = true;
    this.update();
  }

  set #valid(valid: boolean) {
    if (valid) this.input.removeAttribute('aria-invalid');
    else this.input.setAttribute('aria-invalid', 'true');
  }
}
