// Copies the equations as text and as LaTeX, or shows what could not be copied, selected.
import { copyText, phrase, type ViewerText, type ViewerTexts } from '../../viewer/extra.js';
import { html, type TemplateResult } from 'lit';
import { latexOf } from './math.js';

export class CopyButtons {
  readonly #uncopied = Object.assign(document.createElement('textarea'), {
    readOnly: true,
    hidden: true,
    rows: 3,
    dir: 'ltr',
  });

  template(written: string, texts: ViewerTexts | null): TemplateResult {
    const latex = latexOf(written);
    this.#uncopied.hidden ||= ![written, latex].includes(this.#uncopied.value);
    return html`<p class="copy">
      ${this.#button('Copy as text', written, texts)} ${this.#button('Copy as LaTeX', latex, texts)}
      ${this.#uncopied}
    </p>`;
  }

  #button(label: ViewerText, text: string, texts: ViewerTexts | null): TemplateResult {
    const copy = ({ currentTarget }: Event): void => {
      const button = currentTarget as HTMLButtonElement;
      this.#uncopied.ariaLabel = phrase(texts, label);
      const show = (what: ViewerText) => (button.textContent = phrase(texts, what));
      void copyText(text, this.#uncopied, label, show);
    };
    return html`<button
      part="button"
      type="button"
      aria-live="polite"
      .textContent=${phrase(texts, label)}
      @click=${copy}
    ></button>`;
  }
}
