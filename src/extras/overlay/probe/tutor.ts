// The probe's equations, as MathML with numbers or with fields for answers, and as text and LaTeX
// for the clipboard.
import { html, mathml, nothing, type TemplateResult } from 'lit';
import {
  type AnswerDetail,
  create,
  phrase,
  type ViewerText,
  type ViewerTexts,
} from '../../../viewer/extra.js';
import { type Equation, judge, type Verdict } from './equations.js';

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
  /** The text that could not be copied, to be copied by hand. */
  readonly #uncopied = create('textarea', { readonly: '', rows: '3', dir: 'ltr' });

  constructor(changed: () => void, report: (detail: AnswerDetail) => void) {
    this.#changed = changed;
    this.#report = report;
  }

  template(
    equations: readonly Equation[],
    asks: boolean,
    texts: ViewerTexts | null,
  ): TemplateResult {
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
    const written = equations
      .map(({ symbols, numbers, result }) => `${symbols} = ${numbers} = ${result}`)
      .join('\n');
    const latex = latexOf(written);
    this.#uncopied.hidden = asks || ![written, latex].includes(this.#uncopied.value);
    return html`<ul class="equations">
        ${lines}
      </ul>
      ${
        asks
          ? nothing
          : html`<p>
              ${this.#copyButton('Copy as text', written, texts)}
              ${this.#copyButton('Copy as LaTeX', latex, texts)} ${this.#uncopied}
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
      this.#report({
        term,
        light,
        channel,
        text: attempt.typed,
        expected,
        value,
        correct,
        mistake,
      });
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

  #copyButton(label: ViewerText, text: string, texts: ViewerTexts | null): TemplateResult {
    const copy = async (button: HTMLButtonElement): Promise<void> => {
      let said: ViewerText = 'copied ✓';
      try {
        await navigator.clipboard.writeText(text);
      } catch {
        // Pages without TLS have no clipboard; a frame without the permission rejects.
        said = 'select and copy below';
        this.#uncopied.value = text;
      }
      this.#uncopied.hidden = said === 'copied ✓';
      this.#uncopied.setAttribute('aria-label', phrase(texts, label));
      if (!this.#uncopied.hidden) {
        this.#uncopied.select();
        this.#uncopied.scrollIntoView({ block: 'nearest' });
      }
      button.textContent = phrase(texts, said);
      setTimeout(() => (button.textContent = phrase(texts, label)), RESULT_MS);
    };
    return html`<button
      type="button"
      aria-live="polite"
      .textContent=${phrase(texts, label)}
      @click=${(event: Event) => void copy(event.currentTarget as HTMLButtonElement)}
    ></button>`;
  }
}

/** How long a button shows the result, ms. */
const RESULT_MS = 2000;

const equationTitle = ({ name, term, channel }: Equation, texts: ViewerTexts | null): string =>
  [name, phrase(texts, term), channel === null ? '' : phrase(texts, channel)]
    .filter((part) => part !== '')
    .join(' · ');

const TOKENS = /[KI][ads](?![a-z])|[\p{L}]+|[\d.,\u066b]*\d(?:e[+−]?\d+)?%?|\S/gu;

/** An equation, such as "Kd · max(N · L, 0)^8". */
const mathOf = (text: string): TemplateResult =>
  html`<math alttext=${text}>${rowOf(text.match(TOKENS) ?? [])}</math>`;

function rowOf(tokens: readonly string[]): TemplateResult {
  const parts: TemplateResult[] = [];
  const open: number[] = [];
  // What a power is of: the last token, or the last parentheses with the function before them.
  let base = 0;
  for (let i = 0; i < tokens.length; i++) {
    const token = tokens[i]!;
    if (token === '^') {
      const power = atomOf(tokens[++i] ?? '');
      parts.push(mathml`<msup><mrow>${parts.splice(base)}</mrow>${power}</msup>`);
      continue;
    }
    base = parts.length;
    if (token === '(') {
      open.push(/^m(ax|in)$/.test(tokens[i - 1] ?? '') ? base - 1 : base);
    }
    if (token === ')') {
      base = open.pop() ?? base;
    }
    parts.push(atomOf(token));
  }
  return mathml`<mrow>${parts}</mrow>`;
}

function atomOf(token: string): TemplateResult {
  if (/^[KI][ads]$/.test(token)) {
    return mathml`<msub><mi>${token[0]}</mi><mi>${token[1]}</mi></msub>`;
  }
  if (/^\d/.test(token)) return mathml`<mn>${token}</mn>`;
  return /^\p{L}/u.test(token) ? mathml`<mi>${token}</mi>` : mathml`<mo>${token}</mo>`;
}

export const latexOf = (text: string): string =>
  text
    .replace(/\b([KI])([ads])\b/g, '$1_$2')
    .replace(/\b(max|min)\b/g, '\\$1')
    .replace(/\b(att|decay|sRGB)\b/g, '\\mathrm{$1}')
    .replace(/(\d),(\d)/g, '$1{,}$2')
    .replace(/\^([\w.{},]+)/g, '^{$1}')
    .replace(/·/g, '\\cdot')
    .replace(/Σ/g, '\\Sigma')
    .replace(/−/g, '-');
