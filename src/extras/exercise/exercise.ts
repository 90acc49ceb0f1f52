// What a <phong-exercise> does: it shows an editor, runs the function when somebody presses *run*,
// and says what the judge found. Loaded with the first one on a page.
import { html, nothing, render, type TemplateResult } from 'lit';
import { KINDS, type LightKind } from '../../phong/light/light-state.js';
import {
  ExtraElement,
  hostOf,
  localNumber,
  type PhongViewer,
  phrase,
  type ViewerText,
  type ViewerTexts,
} from '../../viewer/extra.js';
import { check, type Failure, type Verdict } from './check.js';
import { EXERCISE_FIELDS, type ExerciseValues } from './exercise-fields.js';
import styles from './exercise.css?inline';
import { kindOf } from '../../phong/mistakes/judge.js';
import { paint } from './paint.js';
import { type PicturePoints, pointsOf, underScene } from './picture.js';
import { type SceneName, SCENES, type Task } from '../../phong/mistakes/sheet.js';
import { GIVEN_GLSL, solutionFor, STARTING_GLSL } from './solution.js';
import { sentencesFor } from './words.js';

/** What a run has shown. */
interface Shown {
  readonly verdict: Verdict;
  readonly picture: PicturePoints | null;
}

class Exercise extends ExtraElement<ExerciseValues> {
  /** What was written; null while it is the text to begin with. */
  #written: string | null = null;
  #running = false;
  /** The viewer whose texts are followed. */
  #followed: PhongViewer | null = null;
  /** Why there is no verdict. */
  #failure: Failure | null = null;
  /** Beside a failure of the run: of the page. */
  #problem = '';
  #shown: Shown | null = null;
  #wasRight = false;

  constructor(element: HTMLElement) {
    super(element, EXERCISE_FIELDS, [ExtraElement.block, styles]);
  }

  protected override declared(): void {
    this.#render();
    this.found();
  }

  /** The viewer and its texts may come later. */
  protected override found(): void {
    const viewer = this.#viewer;
    if (viewer === null || viewer === this.#followed) return;
    this.#followed = viewer;
    let { texts } = viewer;
    const hostUpdated = (): void => {
      if (viewer.texts === texts) return;
      ({ texts } = viewer);
      this.#render();
    };
    viewer.addController({ hostUpdated });
    this.#render();
  }

  protected override left(): void {
    // What was written stays.
  }

  protected override complain(): void {
    // A run says what is missing.
  }

  get value(): string {
    return this.#written ?? this.#given;
  }

  set value(text: string) {
    this.#written = text;
    this.#render();
  }

  /** The text to begin with, without the indentation that all its lines share. */
  get #given(): string {
    const script = this.element.querySelector<HTMLScriptElement>('script[type="text/plain"]');
    if (script === null) return STARTING_GLSL;
    const lines = script.text.replace(/^\s*\n|\s+$/g, '').split('\n');
    const depths = lines.map((line) => line.search(/\S/)).filter((depth) => depth >= 0);
    return lines.map((line) => line.slice(Math.min(...depths))).join('\n');
  }

  get #viewer(): PhongViewer | null {
    return this.viewerById(this.values.for);
  }

  get #texts(): ViewerTexts | null {
    return this.textsOf(this.#viewer);
  }

  #say(text: string, values: Readonly<Record<string, string | number>> = {}): string {
    const texts = this.#texts;
    const words = Object.entries(values).map(([key, value]) => [
      key,
      typeof value === 'number' ? localNumber(grouped(value), texts) : value,
    ]);
    return phrase(texts, text as ViewerText, Object.fromEntries(words) as Record<string, string>);
  }

  #task(lights: readonly LightKind[]): Task {
    const { terms, kinds } = this.values;
    const reflection = this.#viewer?.reflection ?? 'phong';
    return { terms, kinds: kinds ?? KINDS.filter((kind) => lights.includes(kind)), reflection };
  }

  startAgain(): void {
    this.#written = null;
    this.#failure = null;
    this.root.querySelector('textarea')!.value = this.#given;
    this.#render();
  }

  /** With `scene`: the picture under a lamp of the sheet. */
  async #run(scene: SceneName | null = null): Promise<void> {
    if (this.#running) return;
    this.#running = true;
    this.#failure = null;
    this.#problem = '';
    this.#render();
    try {
      await this.#judge(this.value, scene);
    } finally {
      this.#running = false;
      this.#render();
    }
  }

  async #judge(source: string, scene: SceneName | null): Promise<void> {
    const viewer = this.#viewer;
    if (viewer === null) {
      this.#problem = this.#say('There is no phong-viewer with the id {id}.', {
        id: JSON.stringify(this.values.for),
      });
      return;
    }
    await viewer.ready;
    const snapshot = hostOf(viewer).snapshot();
    const task = this.#task(kindsOf(snapshot.lights.map(({ values }) => values)));
    const own = await pointsOf(snapshot, task);
    const [exponent] = own?.exponents ?? [];
    if (exponent !== undefined) {
      this.#problem = this.#say(
        'The exponent is {n} in this picture: an exercise needs 1 to 256.',
        {
          n: exponent,
        },
      );
      return;
    }
    const picture =
      own === null || scene === null ? own : underScene(own, SCENES[scene], task.terms);
    const result = await check(source, task, picture);
    const isVerdict = 'right' in result;
    if (isVerdict) {
      this.#shown = { verdict: result, picture };
      this.#wasRight ||= result.right;
    } else {
      this.#failure = result;
    }
    const { right, mistakes, share } = isVerdict ? result : NO_VERDICT;
    if (scene === null) {
      this.element.dispatchEvent(
        new CustomEvent('check', { detail: { right, mistakes, share, source } }),
      );
    }
  }

  #render(): void {
    const { value } = this;
    const isMissing =
      this.values.required && (this.#written === null || this.#written.trim() === '');
    render(this.#template(value), this.root);
    const area = this.root.querySelector('textarea')!;
    this.internals.setFormValue(value, this.#written ?? '');
    this.internals.setValidity(
      { valueMissing: isMissing },
      isMissing ? this.#say('Write the function first.') : '',
      area,
    );
    if (this.#shown !== null) {
      paint(this.root, this.#shown.verdict.colors, this.#shown.picture);
    }
  }

  #template(value: string): TemplateResult {
    const lines = Math.min(value.split('\n').length, MOST_LINES);
    const faults = this.#faults();
    const bad = new Set(faults.map(({ line }) => line));
    const help = this.#say(
      'The function returns the light of one lamp at one point. It is not clamped: the sum over the lamps is. Colours are from 0 to 1; angles are in degrees; p, normal and eye are in world space. normal and axis have any length but zero; position.w is 0 for a direction and 1 for a place; aperture is the angle from the axis to the edge of the cone, 180 without one; the exponent is from 1 to 256.',
    );
    return html`<div class="editor" part="editor">
        <label for="code">${this.#say('Your function')}</label>
        <div class="code">
          <div class="numbers" aria-hidden="true">
            ${Array.from({ length: lines }, (_, i) =>
              bad.has(i + 1) ? html`<b>${i + 1}</b>` : html`<span>${i + 1}</span>`,
            )}
          </div>
          <textarea
            id="code"
            rows=${lines + 1}
            wrap="off"
            spellcheck="false"
            autocapitalize="off"
            autocomplete="off"
            aria-describedby="faults"
            ?disabled=${this.element.matches(':disabled')}
            aria-invalid=${faults.length > 0}
            .value=${value}
            @input=${this.#input}
            @keydown=${this.#key}
          ></textarea>
        </div>
        <pre class="printed">${value}</pre>
        <div id="faults" role="alert">
          ${faults.map(
            ({ line, text }) =>
              html`<p>
                ${line === null ? text : this.#say('Line {line}: {message}', { line, message: text })}
              </p>`,
          )}
        </div>
        <p class="buttons">
          <button part="button" aria-disabled=${this.#running} @click=${() => this.#run()}>
            ${this.#say('Run')}
          </button>
          <button part="button" @click=${() => this.startAgain()}>
            ${this.#say('Start again')}
          </button>
        </p>
        <details>
          <summary>${this.#say('What the function gets')}</summary>
          <pre tabindex="0">${GIVEN_GLSL}</pre>
          <p>${help}</p>
        </details>
      </div>
      <div class="verdict" part="verdict" role="status">${this.#verdict()}</div>
      ${this.#pictures()} ${this.#solution()}`;
  }

  readonly #input = ({ target }: Event): void => {
    this.value = (target as HTMLTextAreaElement).value;
  };

  readonly #key = (event: KeyboardEvent): void => {
    if (event.key === 'Enter' && (event.ctrlKey || event.metaKey)) {
      event.preventDefault();
      void this.#run();
    }
  };

  #faults(): readonly { readonly line: number | null; readonly text: string }[] {
    const { fault, messages = [] } = this.#failure ?? {};
    return fault === undefined
      ? messages
      : [{ line: fault.line, text: this.#say(fault.text, fault.values) }];
  }

  #verdict(): TemplateResult | typeof nothing {
    if (this.#running) return html`<p>${this.#say('Running …')}</p>`;
    const { stop } = this.#failure ?? {};
    const failed = stop === undefined ? this.#problem : this.#say(STOPS[stop]);
    if (failed !== '') return html`<p>${failed}</p>`;
    const { hint } = this.values;
    if (this.#shown === null || this.#failure !== null || hint === 'none') return nothing;
    const { verdict } = this.#shown;
    const say = (text: string, values?: Readonly<Record<string, string | number>>): string =>
      this.#say(text, values);
    const [first, ...rest] = sentencesFor(verdict, hint, say);
    const { scene } = verdict;
    return html`<p class=${verdict.right ? 'right' : 'wrong'}><strong>${first}</strong></p>
      ${rest.map((text) => html`<p>${text}</p>`)}
      ${
        scene === null || hint === 'verdict'
          ? nothing
          : html`<p class="buttons">
              <button part="button" @click=${() => this.#run(scene)}>
                ${this.#say(DEMONSTRATIONS[scene] ?? 'Use another light')}
              </button>
            </p>`
      }`;
  }

  #pictures(): TemplateResult | typeof nothing {
    const { picture } = this.#shown ?? {};
    if (picture === undefined || picture === null) return nothing;
    const { hint } = this.values;
    const { width, height } = picture;
    const canvas = (id: string, label: string): TemplateResult =>
      html`<canvas
        id=${id}
        width=${width}
        height=${height}
        role="img"
        aria-label=${this.#say(label)}
      ></canvas>`;
    const isCompared = hint !== 'none';
    return html`<div class="pictures" part="pictures">
      <figure>
        <div class="split">
          ${canvas('own', 'Your picture')}
          ${isCompared ? canvas('exact', 'The exact picture') : nothing}
        </div>
        ${
          isCompared
            ? html`<input
                type="range"
                min="0"
                max="100"
                value="50"
                aria-label=${this.#say('Divider')}
                @input=${this.#divide}
              />`
            : nothing
        }
        <figcaption>
          ${this.#say(isCompared ? 'Left of the line your picture, right of it the exact one' : 'Your picture')}
        </figcaption>
      </figure>
      ${
        hint === 'what' || hint === 'where'
          ? html`<figure>
              ${canvas('difference', 'The difference')}
              <figcaption>${this.#say('The difference')}</figcaption>
            </figure>`
          : nothing
      }
      ${picture.isGouraud ? html`<p>${this.#say(GOURAUD)}</p>` : nothing}
    </div>`;
  }

  readonly #divide = ({ target }: Event): void => {
    const exact = this.root.querySelector<HTMLElement>('.split')!;
    exact.style.setProperty('--at', `${(target as HTMLInputElement).value}%`);
  };

  #solution(): TemplateResult | typeof nothing {
    const { solution, kinds } = this.values;
    if (!solution || !this.#wasRight) return nothing;
    const lights = this.#viewer?.lights ?? [];
    const task = this.#task(kinds ?? kindsOf(lights));
    return html`<details open>
      <summary>${this.#say('The exact function')}</summary>
      <pre tabindex="0">${solutionFor(task)}</pre>
    </details>`;
  }
}

const own = ExtraElement.codeOf('phong-exercise', EXERCISE_FIELDS, Exercise);

/** The exercise has come to the page, or is disabled. */
export const follow = (element: HTMLElement): void => own(element).start();

/** The page has come back, with what was written; empty: with nothing, or the form is reset. */
export const restore = (element: HTMLElement, written: string): void => {
  const exercise = own(element);
  if (written === '') {
    exercise.startAgain();
  } else {
    exercise.value = written;
  }
};

/** A longer text scrolls: each line number is an element. */
const MOST_LINES = 500;

const GOURAUD =
  'The viewer shades at the corners of triangles (Gouraud); these pictures do at each pixel.' satisfies ViewerText;

/** 41208 as 41 208: the same in every language. */
const grouped = (value: number): string =>
  value >= 10_000 ? String(value).replace(/\B(?=(\d{3})+$)/g, '\u202f') : String(value);

const NO_VERDICT = { right: false, mistakes: [], share: 0 } as const;

const STOPS = {
  slow: 'The function takes too long: drawing stopped after two seconds.',
  lost: 'The graphics driver has stopped. The next run starts anew.',
  'no-webgl2': 'An exercise needs WebGL 2.',
} as const satisfies Record<NonNullable<Failure['stop']>, ViewerText>;

const DEMONSTRATIONS: Partial<Record<SceneName, ViewerText>> = {
  behind: 'Turn the light behind the object',
  dull: 'Turn the light behind the object',
  near: 'Bring the lamp close',
  cone: 'Use a narrow spot',
  narrow: 'Use a narrow spot',
  spot: 'Use a narrow spot',
};

const kindsOf = (
  lights: readonly (Parameters<typeof kindOf>[0] & { readonly active: boolean })[],
): LightKind[] => lights.filter(({ active }) => active).map(kindOf);
