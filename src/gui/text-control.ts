// Rows of text: a field that writes while the user types, and text that the user cannot edit.
import { Controller, type GUI } from 'lil-gui';
import { write } from '../element/dom.js';
import type { ViewerText } from '../element/fields/texts.js';
import { accepted, bound, type Bound } from './bound.js';
import { nameRow } from './label.js';

export class TextControl extends Controller {
  readonly #field: TextField;
  readonly #placeholder: () => string;

  /** `placeholder`: shown in the empty field; read again at each update. */
  constructor(folder: GUI, bound: Bound<string>, name: ViewerText, placeholder: () => string) {
    super(folder, bound, 'value', 'text');
    nameRow(this, name);
    this.#field = new TextField(
      () => bound.value,
      (text) => accepted(() => (bound.value = text)),
    );
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

/** Text that the user cannot edit. */
export class Readout extends Controller {
  readonly #stop = new AbortController();

  /** `followed`: each picture of this viewer may change the text. */
  constructor(folder: GUI, text: () => string, name: ViewerText, followed: HTMLElement | null) {
    super(folder, bound(text), 'value', 'readout');
    nameRow(this, name);
    followed?.addEventListener('render', () => this.updateDisplay(), { signal: this.#stop.signal });
    this.updateDisplay();
  }

  override updateDisplay(): this {
    write(this.$widget, this.getValue() as string);
    return this;
  }

  override destroy(): void {
    this.#stop.abort();
    super.destroy();
  }
}

/**
 * Accepted text is written at once, refused text is marked. Nothing overwrites the text while the user types;
 * afterwards the field shows the value.
 */
export class TextField {
  readonly input = document.createElement('input');
  readonly #read: () => string;
  #typing = false;

  /** `read`: the value as text. `write` returns false for a text that is refused. */
  constructor(read: () => string, write: (text: string) => boolean) {
    this.#read = read;
    const { input } = this;
    input.type = 'text';
    input.autocomplete = 'off';
    input.spellcheck = false;
    input.addEventListener('focus', () => input.select());
    input.addEventListener('input', () => {
      this.#typing = true;
      this.#valid = write(input.value);
    });
    input.addEventListener('keydown', (event) => {
      if (event.key === 'Enter') input.blur();
    });
    input.addEventListener('blur', () => this.settle());
  }

  /** Shows the value, unless the user types. */
  update(): void {
    if (this.#typing) return;
    const text = this.#read();
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
