// What a <phong-exercise> does: it shows an editor, runs the function when somebody presses *run*,
// and says what the judge found. Loaded with the first one on a page.
import { html, nothing, render, type TemplateResult } from 'lit';
import { KINDS, TERMS } from '../../phong/light/light-state.js';
import {
  ExtraElement,
  hostOf,
  localNumber,
  type PhongViewer,
  phrase,
  type ViewerText,
} from '../../viewer/extra.js';
import { check, type Verdict } from './check.js';
import { EXERCISE_FIELDS, type ExerciseValues } from './exercise-fields.js';
import styles from './exercise.css?inline';
import { kindOf } from '../../phong/light/light-features.js';
import { type Fault, Refused, refused } from './guard.js';
import { inTasks } from '../explain/in-tasks.js';
import { type Images, paint } from './paint.js';
import { pointsOf, underScene } from './picture.js';
import { type SceneName, SCENES, type Task } from '../../phong/mistakes/sheet.js';
import { GIVEN_GLSL, solutionFor, STARTING_GLSL } from './solution.js';
import { sentencesFor } from './words.js';

class Exercise extends ExtraElement<ExerciseValues> {
  /** What was written; null while it is the text to begin with. */
  #written: string | null = null;
  /** What was there before it was started again. */
  #former: string | null = null;
  /** Of the run that goes on. */
  #running: AbortController | null = null;
  /** The viewer whose texts are followed; while it is missing, any other one. */
  #followed: PhongViewer | null = null;
  /** Of that viewer, as they are shown. */
  #texts: PhongViewer['texts'] | undefined;
  #faults: readonly Fault[] = [];
  #shown: Verdict | null = null;
  /** What a right function was asked for. */
  #solved: Task | null = null;

  constructor(element: HTMLElement) {
    super(element, EXERCISE_FIELDS, [ExtraElement.block, styles]);
    this.internals.role = 'group';
  }

  protected override declared(): void {
    this.found();
    this.#render();
  }

  /** The viewer and its texts may come later, and others in their place. */
  protected override found(): void {
    const { isConnected, ownerDocument } = this.element;
    const any = ownerDocument.querySelector<PhongViewer>('phong-viewer:defined');
    const viewer = isConnected ? (this.#viewer ?? any) : null;
    if (viewer !== this.#followed) {
      this.#followed?.removeController(this.#follower);
      viewer?.addController(this.#follower);
      this.#followed = viewer;
    }
    this.#follower.hostUpdated();
  }

  readonly #follower = {
    hostUpdated: () => {
      // One of several on a page; the author's label comes first.
      this.internals.ariaLabel = this.#viewer?.alt ?? null;
      // Not at each update: a page may move a viewer in each frame.
      if (this.#followed?.texts === this.#texts) return;
      this.#texts = this.#followed?.texts;
      this.#render();
    },
  };

  protected override left(): void {
    this.#stop();
    this.found();
  }

  protected override complain(): void {
    // A run says what is missing.
  }

  get value(): string {
    return this.#written ?? this.#given;
  }

  set value(text: string) {
    if (text !== this.value) {
      this.#stop();
    }
    this.#written = text;
    this.#former = null;
    this.#render();
  }

  /** The text to begin with; all its lines without the indentation of the first. */
  get #given(): string {
    const script = this.element.querySelector<HTMLScriptElement>('script[type="text/plain"]');
    if (script === null) return STARTING_GLSL;
    const text = `\n${script.text.replace(/^\s*\n|\s+$/g, '')}`;
    const [start] = /^\s+/.exec(text)!;
    return text.replaceAll(start, '\n').slice(1);
  }

  get #viewer() {
    return this.viewerById(this.values.for);
  }

  readonly #say = (text: string, values: Fault['values'] = {}) => {
    const texts = this.textsOf(this.#followed);
    const words = Object.entries(values).map(([key, value]) => [
      key,
      typeof value === 'number' ? localNumber(grouped(value), texts) : value,
    ]);
    return phrase(texts, text as ViewerText, Object.fromEntries(words) as Record<string, string>);
  };

  /** What was written stays. */
  #stop() {
    this.#running?.abort('stopped');
    this.#running = null;
  }

  startAgain(): void {
    this.#stop();
    this.#former = this.#written ?? this.#former;
    this.#written = null;
    this.#faults = [];
    this.#shown = null;
    this.#render();
  }

  /** With `scene`: the picture under a lamp of the sheet. */
  async #run(scene: SceneName | null = null) {
    if (this.#running !== null) return;
    const running = new AbortController();
    this.#running = running;
    this.#faults = [];
    this.#render();
    try {
      const source = this.value;
      const { right, mistakes, share, pixel } = await this.#judge(
        source,
        scene,
        running.signal,
      ).catch((error: unknown) => {
        if (!(error instanceof Refused)) throw error;
        this.#faults = error.faults;
        // Sentences and pictures of an earlier run would look like this one's.
        this.#shown = null;
        return NO_VERDICT;
      });
      if (scene === null) {
        const detail = { right, mistakes, share, pixel, source };
        this.element.dispatchEvent(new CustomEvent('check', { detail }));
      }
    } catch (error) {
      if (!running.signal.aborted) throw error;
    } finally {
      if (this.#running === running) {
        this.#running = null;
        this.#render();
      }
    }
  }

  /** Sets what is shown. Throws {@link Refused} where there is no verdict. */
  async #judge(source: string, scene: SceneName | null, signal: AbortSignal): Promise<Verdict> {
    const viewer = this.#viewer;
    if (viewer === null) {
      const id = JSON.stringify(this.values.for);
      throw refused('There is no phong-viewer with the id {id}.', null, { id });
    }
    await viewer.ready;
    const snapshot = hostOf(viewer).snapshot();
    const { terms, kinds } = this.values;
    // Where nothing is asked any function would be right: lights that are off count too.
    const present = snapshot.lights.map(({ values }) => kindOf(values));
    const task = {
      terms: terms.length > 0 ? terms : TERMS,
      kinds: [kinds ?? [], present, KINDS].find((list) => list.length > 0)!,
      reflection: viewer.reflection,
    };
    const own = await inTasks(pointsOf(snapshot, task), signal);
    const picture =
      own === null || scene === null ? own : underScene(own, SCENES[scene], task.terms);
    this.#shown = await check(source, task, picture, signal);
    if (this.#shown.right) {
      this.#solved = task;
    }
    return this.#shown;
  }

  #render() {
    const { value } = this;
    const written = this.#written ?? '';
    render(this.#template(value), this.root);
    this.internals.setFormValue(value, written);
    this.internals.setValidity(
      { valueMissing: this.values.required && written.trim() === '' },
      this.#say('Write the function first.'),
      this.root.querySelector('textarea')!,
    );
    paint(this.root, this.#shown?.images ?? {});
  }

  #template(value: string): TemplateResult {
    const lines = value.split('\n').slice(0, MOST_LINES);
    const help = this.#say(
      'The function returns the light of one lamp at one point. It is not clamped: the sum over the lamps is. Colours are from 0 to 1; angles are in degrees; p, normal and eye are in world space. normal and axis have any length but zero; position.w is 0 for a direction and 1 for a place; aperture is the angle from the axis to the edge of the cone, 180 without one; the exponent is from 1 to 256.',
    );
    return html`<div class="editor" part="editor">
        <label for="code">${this.#say('Your function')}</label>
        <div class="code">
          <div class="lines" aria-hidden="true">
            ${lines.map((text, i) => {
              const isFaulty = this.#faults.some(({ line }) => line === i + 1);
              return html`<b class=${isFaulty ? 'faulty' : nothing}>${i + 1}</b
                ><span>${text}</span>`;
            })}
          </div>
          <textarea
            id="code"
            spellcheck="false"
            autocapitalize="off"
            autocomplete="off"
            aria-describedby="faults"
            ?disabled=${this.element.matches(':disabled')}
            aria-invalid=${this.#faults.length > 0}
            .value=${value}
            @input=${this.#input}
            @keydown=${this.#key}
          ></textarea>
        </div>
        <pre class="printed">${value}</pre>
        <div id="faults" role="alert">
          ${this.#faults.map(({ text, values, line }) => {
            const message = this.#say(text, values);
            return html`<p>
              ${line === null ? message : this.#say('Line {line}: {message}', { line, message })}
            </p>`;
          })}
        </div>
        <p class="buttons">
          <button part="button" aria-disabled=${this.#running !== null} @click=${() => this.#run()}>
            ${this.#say('Run')}
          </button>
          <button part="button" @click=${() => this.startAgain()}>
            ${this.#say('Start again')}
          </button>
          ${
            this.#former === null
              ? nothing
              : html`<button part="button" @click=${this.#undo}>${this.#say('Undo')}</button>`
          }
        </p>
        <details>
          <summary>${this.#say('What the function gets')}</summary>
          <pre>${GIVEN_GLSL}</pre>
          <p>${help}</p>
        </details>
      </div>
      <div class="verdict" part="verdict" role="status">${this.#verdict()}</div>
      ${this.#pictures()} ${this.#solution()}`;
  }

  readonly #undo = () => {
    this.value = this.#former!;
    // The button is gone.
    this.element.focus();
  };

  readonly #input = ({ target }: Event): void => {
    this.value = (target as HTMLTextAreaElement).value;
  };

  readonly #key = (event: KeyboardEvent): void => {
    if (event.key === 'Enter' && (event.ctrlKey || event.metaKey)) {
      event.preventDefault();
      void this.#run();
    }
  };

  #verdict(): TemplateResult | typeof nothing {
    if (this.#running !== null) return html`<p>${this.#say('Running …')}</p>`;
    const { hint } = this.values;
    const verdict = this.#shown;
    if (verdict === null || hint === 'none') return nothing;
    const [first, ...rest] = sentencesFor(verdict, hint, this.#say);
    const { scene } = verdict;
    return html`<p class=${verdict.right ? 'right' : 'wrong'}><strong>${first}</strong></p>
      ${rest.map((text) => html`<p>${text}</p>`)}
      ${
        scene === null || hint === 'verdict'
          ? nothing
          : html`<p class="buttons">
              <button
                part="button"
                @click=${() => {
                  // This button is gone while it runs.
                  this.root.querySelector('button')!.focus();
                  void this.#run(scene);
                }}
              >
                ${this.#say(DEMONSTRATIONS[scene] ?? 'Use another light')}
              </button>
            </p>`
      }`;
  }

  #pictures(): TemplateResult | typeof nothing {
    const images = this.#shown?.images;
    if (!images) return nothing;
    const { hint } = this.values;
    const { width, height } = images.own;
    const canvas = (name: keyof Images, label: ViewerText) =>
      html`<canvas
        class=${name}
        width=${width}
        height=${height}
        role="img"
        aria-label=${this.#say(label)}
      ></canvas>`;
    const isCompared = hint !== 'none';
    const own = canvas('own', 'Your picture');
    const exact = isCompared ? canvas('exact', 'The exact picture') : nothing;
    return html`<div class="pictures" part="pictures">
      <figure>
        <div class="split">${own}${exact}</div>
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
              <div class="difference" aria-hidden="true">${own}${exact}</div>
              <figcaption>${this.#say('The difference')}</figcaption>
            </figure>`
          : nothing
      }
      ${this.#viewer?.shading === 'gouraud' ? html`<p>${this.#say('The viewer shades at the corners of triangles (Gouraud); these pictures do at each pixel.')}</p>` : nothing}
    </div>`;
  }

  readonly #divide = ({ target }: Event): void => {
    const exact = this.root.querySelector<HTMLElement>('.split')!;
    exact.style.setProperty('--at', `${(target as HTMLInputElement).value}%`);
  };

  #solution(): TemplateResult | typeof nothing {
    if (!this.values.solution || this.#solved === null) return nothing;
    return html`<details open>
      <summary>${this.#say('The exact function')}</summary>
      <pre>${solutionFor(this.#solved)}</pre>
    </details>`;
  }
}

const own = ExtraElement.codeOf('phong-exercise', EXERCISE_FIELDS, Exercise);

/** The exercise has come to the page, or is disabled. */
export const follow = (element: HTMLElement) => own(element).start();

/** The page has come back, with what was written; empty: with nothing, or the form is reset. */
export const restore = (element: HTMLElement, written: string): void => {
  const exercise = own(element);
  if (written === '') {
    exercise.startAgain();
  } else {
    exercise.value = written;
  }
};

/** A longer text scrolls: each line is an element. */
const MOST_LINES = 500;

/** 41208 as 41 208: the same in every language. */
const grouped = (value: number) =>
  value >= 10_000 ? String(value).replace(/\B(?=(\d{3})+$)/g, '\u202f') : String(value);

const NO_VERDICT = { right: false, mistakes: [], share: 0, pixel: null } as const;

const DEMONSTRATIONS: Partial<Record<SceneName, ViewerText>> = {
  behind: 'Turn the light behind the object',
  dull: 'Turn the light behind the object',
  near: 'Bring the lamp close',
  cone: 'Use a narrow spot',
  narrow: 'Use a narrow spot',
  spot: 'Use a narrow spot',
};
