// Several buttons in one row.
import { Controller, type GUI } from 'lil-gui';
import type { ViewerText } from '../../viewer/extra.js';
import { bound } from './bound.js';
import { label } from './label.js';

export class ButtonRow extends Controller {
  /** `name`: accessible name of the group. */
  constructor(folder: GUI, name: ViewerText) {
    super(
      folder,
      bound(() => null),
      'value',
      'buttons',
    );
    this.$name.remove();
    this.domElement.setAttribute('role', 'group');
    label(this.domElement, (say) => this.domElement.setAttribute('aria-label', say(name)));
  }

  add(text: ViewerText, press: () => void): HTMLButtonElement {
    const button = this.#add(press);
    label(button, (say) => (button.textContent = say(text)));
    return button;
  }

  /** `name`: accessible name and tooltip. */
  addSymbol(symbol: string, name: ViewerText, press: () => void): void {
    const button = this.#add(press);
    button.textContent = symbol;
    label(button, (say) => {
      button.title = say(name);
      button.setAttribute('aria-label', button.title);
    });
  }

  #add(press: () => void): HTMLButtonElement {
    const button = document.createElement('button');
    button.type = 'button';
    button.addEventListener('click', () => {
      // Not `disabled`, which would drop the focus.
      if (button.getAttribute('aria-disabled') !== 'true') {
        press();
      }
    });
    this.$widget.append(button);
    return button;
  }
}
