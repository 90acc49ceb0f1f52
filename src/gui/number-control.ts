// How does the user edit a single number? With a slider over the usual range, which grows to include other values, and a field that
// accepts every value that the element accepts. Knows no light, mesh or camera.
import { Controller, type GUI } from 'lil-gui';
import type { ViewerText } from '../element/fields/text-list.js';
import type { Bound } from './bound.js';
import { nameRow } from './label.js';
import { NumberField } from './number-field.js';
import { Slider } from './slider.js';
import type { Travel } from './travel.js';

export class NumberControl extends Controller {
  readonly #slider: Slider;
  readonly #field: NumberField;

  constructor(folder: GUI, bound: Bound<number>, name: ViewerText, travel: Travel) {
    super(folder, bound, 'value', 'lil-number');
    nameRow(this, name);
    this.#slider = new Slider(bound, travel);
    this.#field = new NumberField(bound, travel);
    for (const { input } of [this.#slider, this.#field]) {
      input.setAttribute('aria-labelledby', this.$name.id);
      this.$widget.append(input);
    }
    this.$disable = this.#field.input;
    // The field does everything by keyboard that the slider does, so one tab stop per row is enough.
    this.#slider.input.tabIndex = -1;
    this.updateDisplay();
  }

  /** The slider's scale, while the value lies within it. */
  set travel(travel: Travel) {
    this.#slider.travel = travel;
  }

  override updateDisplay(): this {
    this.#field.travel = this.#slider.update();
    this.#field.update();
    return this;
  }
}
