// A row for a colour: a picker, text as in HTML (`200 80 60`, `#c85`, `orange`), and a slider for its brightness. 255
// is full, more is brighter.
import { Controller, type GUI } from 'lil-gui';
import { parseText } from '../element/fields/attribute-text.js';
import type { ViewerText } from '../element/fields/text-list.js';
import { sameValue } from '../fields/field-store.js';
import { LIGHT_FIELDS } from '../light/light-state.js';
import type { Vec3 } from '../math/vector.js';
import { accepted, bound, type Bound } from './bound.js';
import { brightnessOf, colorOf, ColorMix, hexOf } from './color-mix.js';
import { explain, label, nameRow } from './label.js';
import { Slider } from './number-controls.js';
import { TextField } from './text-control.js';
import { linear, numberText } from './travel.js';

/** Reads and checks text as every colour attribute does. */
const COLOR = LIGHT_FIELDS.diffuse;

export class ColorControl extends Controller {
  readonly #bound: Bound<Vec3>;
  readonly #picker = document.createElement('input');
  readonly #field: TextField;
  readonly #slider: Slider;
  readonly #mix = new ColorMix();
  /** Text that the user typed, shown while the value stays the same. */
  #typed: { readonly text: string; readonly value: Vec3 } | null = null;

  /** `usual`: the end of the brightness slider; 1 is 255. */
  constructor(folder: GUI, value: Bound<Vec3>, name: ViewerText, usual: number) {
    super(folder, value, 'value', 'color');
    nameRow(this, name);
    this.#bound = value;
    this.#addPicker(name);
    this.#field = new TextField({ read: () => this.#text, write: (text) => this.#write(text) });
    this.#field.input.setAttribute('aria-labelledby', this.$name.id);
    const brightness = bound(
      () => brightnessOf(value.value),
      (factor) => (value.value = this.#mix.brighten(value.value, factor)),
    );
    this.#slider = new Slider(brightness, linear(0, usual, 0.01));
    const { input } = this.#slider;
    this.$widget.append(this.#field.input, input);
    explain(this.#field.input, 'r g b, #rgb or a name; 255 is full');
    label(input, (say) => {
      input.title = say('{color} brightness', { color: say(name) });
      input.setAttribute('aria-label', input.title);
    });
    this.updateDisplay();
  }

  override updateDisplay(): this {
    const hex = hexOf(this.#mix.split(this.#bound.value).color);
    if (this.#picker.value !== hex) this.#picker.value = hex;
    this.#field.update();
    this.#slider.update();
    return this;
  }

  #addPicker(name: ViewerText): void {
    const picker = this.#picker;
    picker.type = 'color';
    picker.addEventListener('input', () => {
      const { value } = this.#bound;
      this.#bound.value = this.#mix.recolor(value, colorOf(picker.value));
    });
    this.$widget.append(picker);
    label(picker, (say) => picker.setAttribute('aria-label', say('{color} picker', { color: say(name) })));
  }

  get #text(): string {
    const { value } = this.#bound;
    if (this.#typed !== null && sameValue(this.#typed.value, value)) return this.#typed.text;
    return value.map((channel) => numberText(channel)).join(' ');
  }

  #write(text: string): boolean {
    return accepted(() => {
      this.#bound.value = COLOR.check(parseText(text, COLOR));
      this.#typed = { text: text.trim(), value: this.#bound.value };
    });
  }
}
