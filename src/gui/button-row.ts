// How are several buttons shown in one row? Knows nothing about what they do.
import { Controller, type GUI } from 'lil-gui';
import { bound } from './bound.js';

export class ButtonRow extends Controller {
  /** `label`: accessible name of the group. */
  constructor(folder: GUI, label: string) {
    super(
      folder,
      bound(() => null),
      'value',
      'buttons',
    );
    this.$name.remove();
    this.domElement.setAttribute('role', 'group');
    this.domElement.setAttribute('aria-label', label);
  }

  /** `name`: accessible name and tooltip, where the text is a symbol. */
  add(text: string, press: () => void, name = text): HTMLButtonElement {
    const button = document.createElement('button');
    button.type = 'button';
    button.textContent = text;
    if (name !== text) {
      button.setAttribute('aria-label', name);
      button.title = name;
    }
    button.addEventListener('click', () => {
      // Not `disabled`, which would drop the focus.
      if (button.getAttribute('aria-disabled') !== 'true') press();
    });
    this.$widget.append(button);
    return button;
  }
}
