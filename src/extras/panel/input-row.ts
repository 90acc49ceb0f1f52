// Rows of inputs: a field of text that writes while the user types, a choice, and text that the
// user cannot edit.
import { Controller, type GUI } from 'lil-gui';
import type { ViewerText } from '../../viewer/extra.js';
import { sameValue } from '../../phong/fields/field-store.js';
import { accepted, bound, type Bound } from './bound.js';
import { label, nameRow, show, type Say } from './label.js';

/** An input of a row; `update` shows the value. */
export interface RowInput {
  readonly input: HTMLElement;
  update(): void;
}

export class InputRow extends Controller {
  readonly #inputs: readonly RowInput[];

  constructor(
    folder: GUI,
    bound: object,
    className: string,
    name: ViewerText,
    inputs: readonly RowInput[],
  ) {
    super(folder, bound, 'value', className);
    nameRow(this, name);
    this.#inputs = inputs;
    for (const { input } of inputs) {
      input.setAttribute('aria-labelledby', this.$name.id);
      this.$widget.append(input);
    }
    this.updateDisplay();
  }

  override updateDisplay(): this {
    for (const each of this.#inputs) {
      each.update();
    }
    return this;
  }
}

/** Names an input that is one of several in its row, in a tooltip too. */
export function nameInput(input: HTMLElement, name: (say: Say) => string): void {
  input.removeAttribute('aria-labelledby');
  label(input, (say) => {
    input.title = name(say);
    input.setAttribute('aria-label', input.title);
  });
}

/** `placeholder`: shown in the empty field; read again at each update. */
export function addText(
  folder: GUI,
  bound: Bound<string>,
  name: ViewerText,
  placeholder: () => string,
): void {
  const field = new TextField(
    () => bound.value,
    (text) => accepted(() => (bound.value = text)),
  );
  const { input } = field;
  const update = (): void => {
    input.placeholder = placeholder();
    field.update();
  };
  new InputRow(folder, bound, 'text', name, [{ input, update }]);
}

/**
 * One of several values. The list stays open while `listed`, read at each update, and the value
 * stay the same.
 */
export function addSelect<T extends string | null>(
  folder: GUI,
  bound: Bound<T>,
  name: ViewerText,
  listed: () => readonly T[],
  text: (value: T, say: Say) => string,
): InputRow {
  const input = document.createElement('select');
  let values: readonly T[] = [];
  input.addEventListener('change', () => (bound.value = values[input.selectedIndex]!));
  const update = (): void => {
    const now = listed();
    if (!sameValue(now, values)) {
      values = now;
      input.replaceChildren(...now.map(() => document.createElement('option')));
      label(input, (say) =>
        now.forEach((value, i) => (input.options[i]!.textContent = text(value, say))),
      );
    }
    const index = values.indexOf(bound.value);
    // Assigning the index, even the same one, would close an open list.
    if (input.selectedIndex !== index) {
      input.selectedIndex = index;
    }
  };
  return new InputRow(folder, bound, 'lil-option', name, [{ input, update }]);
}

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
    show(this.$widget, this.getValue() as string);
    return this;
  }

  override destroy(): void {
    this.#stop.abort('destroyed');
    super.destroy();
  }
}

/**
 * Writes accepted text at once and marks refused text. Nothing overwrites the text while the user
 * types.
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
      if (event.key === 'Enter') {
        input.blur();
      }
    });
    input.addEventListener('blur', () => this.settle());
  }

  update(): void {
    if (this.#typing) return;
    const text = this.#read();
    if (this.input.value !== text) {
      this.input.value = text;
    }
  }

  /** Ends typing. */
  settle(): void {
    this.#typing = false;
    this.#valid = true;
    this.update();
  }

  set #valid(valid: boolean) {
    if (valid) {
      this.input.removeAttribute('aria-invalid');
    } else {
      this.input.setAttribute('aria-invalid', 'true');
    }
  }
}
