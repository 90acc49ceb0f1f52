// Copies the equations as text and as LaTeX, or shows what could not be copied, selected.
import { phrase, type ViewerText, type ViewerTexts } from '../../viewer/extra.js';
import { html, type TemplateResult } from 'lit';
import { latexOf } from './math.js';

/** How long a button shows the result, ms. */
const RESULT_MS = 2000;

export class CopyButtons {
  readonly #uncopied = Object.assign(document.createElement('textarea'), {
    readOnly: true,
    hidden: true,
    rows: 3,
    dir: 'ltr',
  });

  template(written: string, texts: ViewerTexts | null): TemplateResult {
    const latex = latexOf(written);
    this.#uncopied.hidden = ![written, latex].includes(this.#uncopied.value);
    return html`<p class="copy">
      ${this.#button('Copy as text', written, texts)} ${this.#button('Copy as LaTeX', latex, texts)}
      ${this.#uncopied}
    </p>`;
  }

  #button(label: ViewerText, text: string, texts: ViewerTexts | null): TemplateResult {
    const copy = async (button: HTMLButtonElement): Promise<void> => {
      const field = this.#uncopied;
      field.value = '';
      field.hidden = true;
      try {
        await navigator.clipboard.writeText(text);
      } catch {
        // Pages without TLS have no clipboard; a frame without the permission rejects.
        field.value = text;
        field.hidden = false;
        field.ariaLabel = phrase(texts, label);
        field.select();
        field.scrollIntoView({ block: 'nearest' });
      }
      button.textContent = phrase(texts, field.hidden ? 'copied ✓' : 'select and copy below');
      setTimeout(() => (button.textContent = phrase(texts, label)), RESULT_MS);
    };
    return html`<button
      part="button"
      type="button"
      aria-live="polite"
      .textContent=${phrase(texts, label)}
      @click=${(event: Event) => void copy(event.currentTarget as HTMLButtonElement)}
    ></button>`;
  }
}
