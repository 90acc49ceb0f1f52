// The probe's equations in its box, with the numbers put in or with fields for answers.
import { html, nothing, type TemplateResult } from 'lit';
import type { AnswerDetail } from '../../element/events.js';
import { phrase, type ViewerTexts } from '../../element/fields/texts.js';
import { type Equation, judge, type Verdict } from './equations.js';
import { latexOf, mathOf } from './notation.js';

interface Attempt {
  typed: string;
  verdict: Verdict | null;
  shown: boolean;
}

export class Tutor {
  readonly #changed: () => void;
  readonly #report: (detail: AnswerDetail) => void;
  /** By question and right answer: another point begins anew. */
  #attempts = new Map<string, Attempt>();

  constructor(changed: () => void, report: (detail: AnswerDetail) => void) {
    this.#changed = changed;
    this.#report = report;
  }

  template(equations: readonly Equation[], asks: boolean, texts: ViewerTexts | null): TemplateResult {
    const before = this.#attempts;
    this.#attempts = new Map();
    const lines = equations.map((equation, i) => {
      const key = `${i} ${equation.term} ${equation.value.toPrecision(9)}`;
      const attempt = before.get(key) ?? { typed: '', verdict: null, shown: false };
      this.#attempts.set(key, attempt);
      const isOpen = !asks || attempt.shown;
      const sides = isOpen
        ? [equation.symbols, `= ${equation.numbers}`, `= ${equation.result}`]
        : [equation.given, '='];
      return html`<li>
        <span class="title" dir="auto">${equationTitle(equation, texts)}</span>
        ${asks && equation.facts !== '' ? html`<small dir="ltr">${equation.facts}</small>` : nothing}
        ${sides.map((side) => html`${mathOf(side)} `)}
        ${asks && !attempt.shown ? this.#question(equation, attempt, texts) : nothing}
      </li>`;
    });
    return html`<ul class="equations">
        ${lines}
      </ul>
      ${
        asks
          ? nothing
          : html`<p>
              ${this.#copyButton('Copy as text', equations, plainOf, texts)}
              ${this.#copyButton('Copy as LaTeX', equations, (text) => latexOf(plainOf(text)), texts)}
            </p>`
      }`;
  }

  #question(equation: Equation, attempt: Attempt, texts: ViewerTexts | null): TemplateResult {
    const { verdict } = attempt;
    const submit = (event: Event): void => {
      event.preventDefault();
      attempt.verdict = judge(attempt.typed, equation, texts);
      const { value, correct, mistake } = attempt.verdict;
      const { term, light, channel, value: expected } = equation;
      this.#report({ term, light, channel, text: attempt.typed, expected, value, correct, mistake });
      this.#changed();
    };
    const show = (): void => {
      attempt.shown = true;
      this.#changed();
    };
    return html`<form @submit=${submit}>
      <input
        inputmode="decimal"
        autocomplete="off"
        size="7"
        aria-label=${equationTitle(equation, texts)}
        .value=${attempt.typed}
        @input=${(event: Event) => (attempt.typed = (event.target as HTMLInputElement).value)}
      /><button type="submit">${phrase(texts, 'Check')}</button>
      ${verdict === null ? nothing : html`<button type="button" @click=${show}>${phrase(texts, 'Show')}</button>`}
      <output dir="auto">${verdict?.text}</output>
    </form>`;
  }

  #copyButton(
    label: 'Copy as text' | 'Copy as LaTeX',
    equations: readonly Equation[],
    write: (equation: string) => string,
    texts: ViewerTexts | null,
  ): TemplateResult {
    const copy = (): void => {
      const lines = equations.map(({ symbols, numbers, result }) => write(`${symbols} = ${numbers} = ${result}`));
      // Pages without TLS have no clipboard; a frame without the permission rejects.
      const { clipboard } = navigator as { readonly clipboard?: Clipboard };
      void clipboard?.writeText(lines.join('\n')).catch(() => undefined);
    };
    return html`<button type="button" @click=${copy}>${phrase(texts, label)}</button>`;
  }
}

const plainOf = (equation: string): string => equation;

const equationTitle = ({ name, term, channel }: Equation, texts: ViewerTexts | null): string =>
  [name, phrase(texts, term), channel === null ? '' : phrase(texts, channel)].filter((part) => part !== '').join(' · ');
