// How does a row show text that the user cannot edit? Knows nothing about the text.
import { Controller, type GUI } from 'lil-gui';
import type { ViewerText } from '../element/fields/text-list.js';
import { bound } from './bound.js';
import { nameRow } from './label.js';

export class Readout extends Controller {
  constructor(folder: GUI, text: () => string, name: ViewerText) {
    super(folder, bound(text), 'value', 'readout');
    nameRow(this, name);
    this.updateDisplay();
  }

  override updateDisplay(): this {
    this.$widget.textContent = this.getValue() as string;
    return this;
  }
}
