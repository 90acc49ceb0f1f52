// How does a row show text that the user cannot edit? Knows nothing about the text.
import { Controller, type GUI } from 'lil-gui';
import { bound } from './bound.js';

export class Readout extends Controller {
  constructor(folder: GUI, text: () => string, label: string) {
    super(folder, bound(text), 'value', 'readout');
    this.name(label);
    this.updateDisplay();
  }

  override updateDisplay(): this {
    this.$widget.textContent = this.getValue() as string;
    return this;
  }
}
