// How does a text field write a value while the user types? Accepted text is written at once, refused text is marked. While the user
// types nothing overwrites the text; afterwards the field shows the value. Knows no particular kind of value.

export interface TextBinding {
  /** The value as text. */
  read(): string;
  /** Writes the text's value. Returns false if it is refused. */
  write(text: string): boolean;
}

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
    input.addEventListener('focus', () => {
      input.select();
    });
    input.addEventListener('input', () => {
      this.#typing = true;
      this.#valid = binding.write(input.value);
    });
    input.addEventListener('keydown', (event) => {
      if (event.key === 'Enter') input.blur();
    });
    input.addEventListener('blur', () => {
      this.settle();
    });
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

/** Runs `write`. False if the element refuses the value. */
export function accepted(write: () => void): boolean {
  try {
    write();
    return true;
  } catch (error) {
    if (error instanceof RangeError || error instanceof TypeError) return false;
    throw error;
  }
}
