// How does the user copy the scene's markup? A button that writes it to the clipboard, or shows it selected if the clipboard is
// not available. Knows nothing about the markup.
import type { ViewerText } from '../element/fields/text-list.js';
import type { ButtonRow } from './button-row.js';
import { label } from './label.js';

const LABEL = 'copy HTML';

/** How long the button shows the result, ms. */
const RESULT_MS = 2000;

export class CopyButton {
  readonly #row: ButtonRow;
  readonly #button: HTMLButtonElement;
  readonly #text = document.createElement('textarea');
  #timer = 0;

  constructor(row: ButtonRow, markup: () => string) {
    this.#row = row;
    this.#button = row.add(LABEL, () => {
      void this.#copy(markup());
    });
    this.#button.setAttribute('aria-live', 'polite');
    this.#text.readOnly = true;
    this.#text.className = 'markup';
    this.#text.rows = 6;
    // As in lil-gui's own fields: keys typed here must not reach the camera.
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
      this.#showResult('copied ✓');
    } catch {
      // Refused, or missing: pages without TLS have no clipboard.
      this.#text.value = markup;
      this.#row.domElement.after(this.#text);
      label(this.#text, (say) => {
        this.#text.setAttribute('aria-label', say("The scene's HTML"));
      });
      this.#text.select();
      this.#text.scrollIntoView({ block: 'nearest' });
      this.#showResult('select and copy below');
    }
  }

  #showResult(what: ViewerText): void {
    clearTimeout(this.#timer);
    this.#show(what);
    this.#timer = window.setTimeout(() => {
      this.#show(LABEL);
    }, RESULT_MS);
  }

  #show(text: ViewerText): void {
    label(this.#button, (say) => (this.#button.textContent = say(text)));
  }
}
