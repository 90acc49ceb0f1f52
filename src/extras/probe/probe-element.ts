// What a <phong-probe> does: it finds its viewer, shows the sum at a point of the picture as a
// table, as equations or as questions, and is a control of forms. Loaded with the first one on a
// page.
import {
  type AnswerDetail,
  ExtraElement,
  fieldsOf,
  type FragmentExplanation,
  type PhongViewer,
  phrase,
  type ViewerTexts,
} from '../../viewer/extra.js';
import { html, nothing, render, type TemplateResult } from 'lit';
import { clip } from '../../phong/fields/clip.js';
import { didYouMean } from '../../phong/fields/nearest.js';
import { isBlack } from '../../phong/math/color.js';
import { LightState } from '../../phong/light/light-state.js';
import { NO_SURFACE, notesOf, probeSum } from '../overlay/probe/sum.js';
import {
  colorTemplate,
  isGouraud,
  isHalfway,
  rowOf,
  stepsTemplate,
  SumTable,
} from '../overlay/probe/sum-table.js';
import tableStyles from '../overlay/probe/sum-table.css?inline';
import { judge, type Question, questionOf, sumQuestion, type Verdict } from './answers.js';
import { CopyButtons } from './copy-buttons.js';
import {
  CHANNELS,
  askedChannel,
  type Equation,
  equationsOf,
  isGrey,
  titleOf,
} from './equations.js';
import { FollowedPoint } from './followed-point.js';
import { mathOf } from './math.js';
import styles from './probe-element.css?inline';
import { askedOf, formOf, isAsked, PROBE_FIELDS, type ProbeValues } from './probe-fields.js';

/** Width in em from which a table has room for decimals. */
const WIDE = 48;

const SEPARATOR = '; ';

interface Attempt {
  typed: string;
  /** The right answer that the verdict is about. */
  expected: number;
  verdict: Verdict | null;
  shown: boolean;
}

class Probe extends ExtraElement<ProbeValues> {
  readonly #place = Object.assign(document.createElement('div'), { className: 'place' });
  readonly #table = new SumTable(() => this.#render());
  readonly #attempts = new Map<string, Attempt>();
  /** Typed, or assigned before there was a question. */
  #initial: string[] = [];
  #shownKeys: string[] = [];
  #viewer: PhongViewer | null = null;
  #point: FollowedPoint | null = null;
  #texts: ViewerTexts | null = null;
  #isWide = false;
  readonly #width = new ResizeObserver(() => {
    const { fontSize } = getComputedStyle(this.#place);
    const isWide = this.#place.clientWidth > WIDE * Number.parseFloat(fontSize);
    if (isWide !== this.#isWide) {
      this.#isWide = isWide;
      this.#render();
    }
  });
  readonly #copy = new CopyButtons();

  constructor(element: HTMLElement) {
    super(element, PROBE_FIELDS, [ExtraElement.block, tableStyles, styles]);
    this.root.append(this.#place);
    this.internals.role = 'group';
    this.#width.observe(this.#place);
    // To the page's shortcuts the target is no field.
    this.#place.addEventListener('keydown', (event) => {
      if (event.target instanceof HTMLInputElement) {
        event.stopPropagation();
      }
    });
  }

  /** One that is typed with the separator in it stays one. */
  get value(): string {
    return this.#typed()
      .map((text) => text.replaceAll(SEPARATOR, ';'))
      .join(SEPARATOR);
  }

  set value(value: string) {
    this.#initial = value === '' ? [] : value.split(SEPARATOR);
    this.#attempts.clear();
    this.#render();
  }

  #typed(): readonly string[] {
    return this.#shownKeys.length === 0
      ? this.#initial
      : this.#shownKeys.map((key) => this.#attempts.get(key)!.typed.trim());
  }

  protected override declared(): void {
    this.found();
    this.#render();
    this.#point?.update();
  }

  protected override found(): void {
    const viewer = this.viewerById(this.values.for);
    if (viewer !== this.#viewer) {
      this.#follow(viewer);
    } else if (this.textsOf(viewer)?.en !== this.#texts?.en) {
      this.#render();
    }
  }

  protected override left(): void {
    this.#follow(null);
  }

  #follow(viewer: PhongViewer | null): void {
    this.#point?.stop();
    this.#viewer = viewer;
    this.#point =
      viewer &&
      new FollowedPoint(this.element, viewer, this.values, (error) => this.#explained(error));
    this.#render();
  }

  #explained(error?: Error): void {
    if (error !== undefined) {
      this.warn(error.message);
    }
    this.#render();
  }

  protected override complain(): void {
    const { for: id } = this.values;
    const tag = `<phong-probe for="${clip(id)}">`;
    if (this.#viewer !== null) return;
    if (id.trim() === '') {
      this.warn('<phong-probe>: write for="…", the id of a viewer.');
      return;
    }
    const viewers = this.element.ownerDocument.querySelectorAll('phong-viewer');
    const hint = didYouMean(
      id,
      Array.from(viewers, (viewer) => viewer.id),
    );
    this.warn(`${tag}: no viewer has the id "${clip(id)}".${hint}`);
  }

  #render(): void {
    this.#texts = this.textsOf(this.#viewer);
    this.internals.ariaLabel = phrase(this.#texts, 'Probe');
    this.#shownKeys = [];
    render(this.#template(), this.#place);
    this.#writeForm();
  }

  #template(): TemplateResult | typeof nothing {
    const viewer = this.#viewer;
    const fragment = this.#point?.fragment;
    const texts = this.#texts;
    if (viewer === null || fragment === undefined) return nothing;
    if (fragment === null) return html`<p class="note">${phrase(texts, NO_SURFACE)}</p>`;
    const linear = viewer.colorInterpolation === 'linear';
    const form = formOf(this.values);
    const halfway = isHalfway(fragment, viewer);
    const gouraud = isGouraud(fragment, viewer);
    // Corners' terms and unlit surfaces have no equation at the point: the table shows them.
    if (form === 'table' || fragment.unlit || gouraud) {
      const sum = probeSum(fragment, linear);
      const row = rowOf(sum, this.#table.chosen);
      const content = { fragment, sum, row, halfway, gouraud, digits: this.#isWide ? 1 : 0 };
      return html`<p class="head">${colorTemplate(content, texts)}</p>
        <p class="note" dir="auto">${notesOf(fragment, gouraud, texts).join(' ')}</p>
        ${this.#table.template(content, texts, Infinity)} ${stepsTemplate(content, texts)}`;
    }
    const lights = fragment.shares.map((share) =>
      share === null || share.light === null
        ? new LightState({ position: [0, 0, 1, 0] }).values
        : fieldsOf(share.light).store.values,
    );
    const { terms } = viewer;
    const equations = equationsOf(fragment, { lights, linear, halfway, terms }, texts);
    return form === 'formula'
      ? this.#formula(equations, texts)
      : this.#questions(equations, fragment, linear, texts);
  }

  #formula(equations: readonly Equation[], texts: ViewerTexts | null): TemplateResult {
    const written = equations.map((equation) => `${equation.symbols} ${numbersOf(equation)}`);
    const lines = equations.map(
      (equation, i) =>
        html`<li>
          <span class="title" part="title" dir="auto">${titleOf(equation, null, texts)}</span>
          <span class="math" dir="ltr">${mathOf(written[i]!)}</span>
        </li>`,
    );
    return html`<ul class="equations">
        ${lines}
      </ul>
      ${this.#copy.template(written.join('\n'), texts)}`;
  }

  /** The lines that `ask` names, and what they are computed from. */
  #questions(
    equations: readonly Equation[],
    fragment: FragmentExplanation,
    linear: boolean,
    texts: ViewerTexts | null,
  ): TemplateResult {
    const lines = equations.filter(({ term }) => term !== 'sum');
    const sum = equations[equations.length - 1]!;
    const asked = askedOf(this.values.ask);
    const named = lines.filter(
      (line) => asked !== null && line.term === asked.term && isAsked(asked, line),
    );
    const isSum = asked?.term === 'sum';
    const isAll = asked === null || (!isSum && named.length === 0);
    if (isAll && asked !== null) {
      this.warn(
        `<phong-probe ask="${clip(this.values.ask)}">: no light of the viewer adds such a term here; everything is asked.`,
      );
    }
    const shown = isSum || isAll ? equations : named;
    return html`<ul class="equations">
      ${shown.map((equation) => {
        // The terms of a sum are asked in its channel, but for those that are none in this one.
        const channel = askedChannel(isSum || isAll ? shown : [equation]);
        const isOpen =
          (isAll || (equation === sum) === isSum) &&
          (equation.value[channel] !== 0 || isBlack(equation.value));
        const question =
          equation === sum
            ? sumQuestion(sum, lines, { fragment, linear, texts }, channel)
            : questionOf(equation, channel);
        return this.#question(question, isOpen, texts);
      })}
    </ul>`;
  }

  #question(question: Question, isOpen: boolean, texts: ViewerTexts | null): TemplateResult {
    const { equation, channel, given, facts } = question;
    const title = titleOf(equation, channel, texts);
    return html`<li>
      <span class="title" part="title" dir="auto">${title}</span>
      ${facts === '' ? nothing : html`<span class="facts" dir="ltr">${facts}</span>`}
      <span class="math" dir="ltr">${mathOf(isOpen ? `${given} =` : given)}</span>
      ${isOpen ? this.#field(question, title, texts) : nothing}
    </li>`;
  }

  #field(question: Question, title: string, texts: ViewerTexts | null): TemplateResult {
    const attempt = this.#attemptOf(question);
    const { verdict, shown } = attempt;
    const disabled = this.element.matches(':disabled');
    const submit = (event: Event): void => {
      event.preventDefault();
      attempt.verdict = judge(attempt.typed, question, texts);
      this.#render();
      this.#report(question, attempt.typed, attempt.verdict);
    };
    const show = (): void => {
      attempt.shown = !attempt.shown;
      this.#render();
    };
    const input = (event: Event): void => {
      attempt.typed = (event.target as HTMLInputElement).value;
      this.#writeForm();
    };
    return html`<form @submit=${submit}>
        <input
          part="input"
          inputmode="decimal"
          autocomplete="off"
          size="7"
          aria-label=${title}
          aria-invalid=${verdict === null ? nothing : String(!verdict.correct)}
          ?required=${this.values.required}
          ?disabled=${disabled}
          .value=${attempt.typed}
          @input=${input}
        />
        <button part="button" type="submit" ?disabled=${disabled}>${phrase(texts, 'Check')}</button>
        ${
          verdict === null && !shown
            ? nothing
            : html`<button
                part="button"
                type="button"
                aria-expanded=${String(shown)}
                @click=${show}
              >
                ${phrase(texts, 'Show')}
              </button>`
        }
        <output
          part="verdict"
          dir="auto"
          class=${verdict === null ? nothing : verdict.correct ? 'right' : 'wrong'}
          >${verdict?.text}</output
        >
      </form>
      ${shown ? html`<span class="math" dir="ltr">${mathOf(numbersOf(question.equation))}</span>` : nothing}`;
  }

  /** What was typed so far. Another point, or another light, begins anew. */
  #attemptOf({ equation, expected }: Question): Attempt {
    const key = `${equation.term} ${equation.name} ${this.#shownKeys.length}`;
    const attempt = this.#attempts.get(key) ?? {
      typed: this.#initial[this.#shownKeys.length] ?? '',
      expected,
      verdict: null,
      shown: false,
    };
    this.#attempts.set(key, attempt);
    this.#shownKeys.push(key);
    if (Math.abs(attempt.expected - expected) > 1e-6) {
      Object.assign(attempt, { expected, verdict: null, shown: false });
    }
    return attempt;
  }

  #report({ equation, channel, expected }: Question, text: string, verdict: Verdict): void {
    const detail: AnswerDetail = {
      ...verdict,
      term: equation.term,
      light: equation.light,
      channel: isGrey(equation) ? null : CHANNELS[channel]!,
      text,
      expected,
    };
    this.element.dispatchEvent(new CustomEvent('answer', { detail }));
  }

  /** The form's entries, one for each answer, and whether one is missing. */
  #writeForm(): void {
    const { name, required } = this.values;
    const typed = this.#typed();
    const data = new FormData();
    for (const text of typed) {
      data.append(name, text);
    }
    this.internals.setFormValue(name === '' ? null : data, this.value);
    const empty = [...this.root.querySelectorAll<HTMLInputElement>('form input')].find(
      (input) => input.value.trim() === '',
    );
    if (required && empty !== undefined) {
      this.internals.setValidity({ valueMissing: true }, valueMissing(), empty);
    } else {
      this.internals.setValidity({});
    }
  }
}

/** The sum of one term is that term. */
const numbersOf = ({ numbers, sign, result }: Equation) =>
  numbers === result ? `${sign} ${result}` : `= ${numbers} ${sign} ${result}`;

/** What the browser says of an empty field, in its user's language. */
const valueMissing = (): string => {
  const input = Object.assign(document.createElement('input'), { required: true });
  return input.validationMessage || 'required';
};

const own = ExtraElement.codeOf('phong-probe', PROBE_FIELDS, Probe);

/** The probe has come to the page, or is disabled. */
export const follow = (element: HTMLElement) => own(element).start();

/** What a reset of the form, or the way back to the page, gives it. */
export const restore = (element: HTMLElement, answers: string): void => {
  own(element).value = answers;
};
