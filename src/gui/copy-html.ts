// The button that copies the scene's markup. Where the clipboard is refused, the markup itself, selected, to be copied by
// hand. Knows nothing of what the markup says.
import type { GUI } from 'lil-gui';
import { addButton } from './rows.js';

const LABEL = 'copy HTML';

/** How long the button says what happened, ms. */
const SAID_FOR = 2000;

export class CopyButton {
  readonly #button;
  readonly #text = document.createElement('textarea');
  #timer = 0;

  constructor(gui: GUI, markup: () => string) {
    this.#button = addButton(gui, LABEL, () => {
      void this.#copy(markup());
    });
    this.#button.$name.setAttribute('aria-live', 'polite');
    this.#text.readOnly = true;
    this.#text.className = 'markup';
    this.#text.rows = 6;
    this.#text.setAttribute('aria-label', "The scene's HTML");
    // As for lil-gui's own fields: keys typed here are nobody else's.
    this.#text.addEventListener('keydown', (event) => {
      event.stopPropagation();
    });
  }

  dispose(): void {
    clearTimeout(this.#timer);
  }

  async #copy(markup: string): Promise<void> {
    try {
      await navigator.clipboard.writeText(markup);
      this.#text.remove();
      this.#say('copied ✓');
    } catch {
      // Refused, or not there at all: pages without TLS have no clipboard.
      this.#text.value = markup;
      this.#button.domElement.after(this.#text);
      this.#text.select();
      this.#text.scrollIntoView({ block: 'nearest' });
      this.#say('select and copy below');
    }
  }

  #say(what: string): void {
    clearTimeout(this.#timer);
    this.#button.name(what);
    this.#timer = window.setTimeout(() => this.#button.name(LABEL), SAID_FOR);
  }
}
