// What a viewer shows: its shadow tree, with the surface that holds the picture; poster,
// description, message and panel over it; and the slots. Brings it, and the custom states, in step
// with what is loaded and what has failed.
import { html, nothing, type TemplateResult } from 'lit';
import { checkedTexts, phrase, type ViewerTexts } from '../fields/texts.js';
import type { PhongViewer } from '../elements.js';
import { pageTexts, textsOver } from '../page/page-texts.js';
import { CORNER_MARKS } from '../page/picture-box.js';
import { ViewerAnnouncements } from './announcements.js';
import type { ViewerContext } from './viewer-context.js';
import type { ViewerExtras } from './extras.js';
import type { ViewerTree } from './viewer-tree.js';
import type { Failure, ViewerFailure } from './failure.js';
import type { ViewerLoading } from './loading.js';
import { surfaceName } from './description.js';

export class ViewerDisplay {
  readonly #viewer: PhongViewer;
  readonly #context: ViewerContext;
  readonly #loading: ViewerLoading;
  readonly #failure: ViewerFailure;
  readonly #states: Set<string> | undefined;
  readonly #announcements: ViewerAnnouncements;
  readonly #extras: ViewerExtras;
  /** Null before the element is connected for the first time. */
  #tree: ViewerTree | null = null;
  /** The viewer's own. */
  #texts: ViewerTexts | null = null;
  /** Those over the page's; null if they have to be put together again. */
  #used: { readonly page: ViewerTexts | null; readonly texts: ViewerTexts | null } | null = null;
  #badPoster = '';
  #revealed = false;
  #empty = false;

  constructor(
    context: ViewerContext,
    loading: ViewerLoading,
    failure: ViewerFailure,
    extras: ViewerExtras,
  ) {
    const { viewer, signals } = (this.#context = context);
    this.#viewer = viewer;
    this.#loading = loading;
    this.#failure = failure;
    this.#extras = extras;
    this.#states = customStates(viewer);
    this.#announcements = new ViewerAnnouncements(context);
    for (const part of [this.#announcements, extras]) {
      viewer.addController(part);
    }
    signals.meshesChanged.listen(() => this.#checkEmpty());
    signals.drawn.listen(() => {
      this.#checkEmpty();
      this.#reveal();
    });
    signals.ended.listen(() => this.#reveal());
    signals.shown.listen(() => viewer.dispatchEvent(new CustomEvent('render')));
  }

  template(): TemplateResult {
    const viewer = this.#viewer;
    const { texts } = this;
    const { bar, pending } = this.#loading;
    const failure = this.#failure.newest;
    const { poster } = viewer;
    if (poster !== this.#badPoster) {
      this.#badPoster = '';
    }
    const hasPoster = poster !== '' && this.#badPoster === '';
    const name = surfaceName(viewer, texts);
    return html`
      <div
        part="surface"
        class=${viewer.orbit ? 'surface' : 'surface fixed'}
        tabindex=${name.keys === '' ? nothing : 0}
        role=${name.keys === '' ? 'img' : 'application'}
        aria-hidden=${name.hidden ? 'true' : nothing}
        aria-label=${name.label}
        aria-description=${this.#announcements.description}
        aria-keyshortcuts=${name.keys || nothing}
        aria-busy=${pending ? 'true' : nothing}
        .ariaLabelledByElements=${name.labelledBy}
      >
        ${this.#context.viewport.holder}${CORNER_MARKS}
      </div>
      ${this.#revealed ? nothing : html`<slot name="poster" class="poster">${hasPoster ? html`<img part="poster" alt="" src=${poster} @error=${this.#dropPoster} />` : nothing}</slot>`}
      <div class="reader" ?hidden=${name.hidden}>${this.#announcements.template()}</div>
      <div class="layer">
        <div class="room">
          ${failure === null ? nothing : this.#messageTemplate(failure)}
          <div class="free"></div>
        </div>
      </div>
      ${bar === undefined ? nothing : this.#progressTemplate(bar)}
      <div class="panel" part="panel"></div>
      <slot></slot>
    `;
  }

  /** `share`: what has arrived, 0 to 1, or null if that is not known. */
  #progressTemplate(share: number | null): TemplateResult {
    const percent = share === null ? null : String(Math.round(share * 100));
    // The style as a property: a strict CSP refuses style attributes.
    return html`<slot name="progress" .style=${pageText(this.#viewer)}>
      <div
        class="progress"
        part="progress"
        role="progressbar"
        aria-label=${phrase(this.texts, 'Loading')}
        aria-valuenow=${percent ?? nothing}
      >
        <div
          class=${percent === null ? 'arrived unknown' : 'arrived'}
          .style=${percent === null ? '' : `inline-size: ${percent}%`}
        ></div>
      </div>
    </slot>`;
  }

  #messageTemplate({ fact, detail: { code, url } }: Failure): TemplateResult {
    const { texts } = this;
    const { retryable, dismissible } = this.#failure;
    return html`<div class=${dismissible ? 'message own' : 'message'} role="alert">
      <slot name="error" .style=${pageText(this.#viewer)}>
        <p
          class="notice"
          part="notice"
          dir="auto"
          data-code=${code}
          data-url=${url ?? nothing}
          .textContent=${texts?.[code] === undefined ? fact : phrase(texts, code, { message: fact, url: url ?? '' })}
        ></p>
        <button
          class="retry"
          part=${dismissible ? 'dismiss' : 'retry'}
          type="button"
          aria-label=${dismissible ? phrase(texts, 'Close') : nothing}
          ?hidden=${!retryable && !dismissible}
          .textContent=${dismissible ? '×' : phrase(texts, 'Try again')}
          @click=${this.#onButton}
        ></button>
      </slot>
    </div>`;
  }

  readonly #onButton = () => {
    if (!this.#loading.dismiss()) {
      this.#loading.retry();
    }
  };

  readonly #onKey = (event: Event) => {
    // Escape must do nothing else then, such as closing a dialog around the viewer.
    const escapes = (event as KeyboardEvent).key === 'Escape' && !event.defaultPrevented;
    if (escapes && this.#loading.dismiss()) {
      event.preventDefault();
    }
    if (isUsed(event as KeyboardEvent)) {
      event.stopPropagation();
    }
  };

  readonly #dropPoster = () => {
    this.#badPoster = this.#viewer.poster;
    this.#viewer.requestUpdate();
  };

  /**
   * The shadow tree is there for the first time. Returns the surface: the picture, without the
   * panel.
   */
  connect(root: ParentNode): HTMLElement {
    this.#tree = {
      surface: root.querySelector('.surface')!,
      layer: root.querySelector('.layer')!,
      room: root.querySelector('.room')!,
      free: root.querySelector('.free')!,
      panel: root.querySelector('.panel')!,
    };
    root.addEventListener('keydown', this.#onKey);
    this.#announcements.connect(this.#tree);
    this.#extras.connect(this.#tree);
    this.#extras.apply();
    return this.#tree.surface;
  }

  /** Before the tree is rendered: a focused message that goes leaves its focus to the picture. */
  keepFocus(root: ParentNode): void {
    if (this.#failure.newest !== null) return;
    if (root.querySelector('.message')?.matches(':focus-within') === true) {
      this.#tree?.surface.focus({ preventScroll: true });
    }
  }

  get panel(): HTMLElement | null {
    return this.#tree?.panel ?? null;
  }

  /** Those in use: the viewer's own, then the page's. */
  get texts(): ViewerTexts | null {
    const page = pageTexts();
    if (this.#used === null || this.#used.page !== page) {
      this.#used = { page, texts: textsOver(this.#texts, page) };
    }
    return this.#used.texts;
  }

  set texts(texts: ViewerTexts | null | undefined) {
    this.#texts = checkedTexts(texts);
    this.#used = null;
    this.#viewer.requestUpdate('texts');
  }

  /**
   * The tree was rendered. `changed`: not for a text beside the picture alone, which extras do not
   * depend on.
   */
  updated(changed: boolean): void {
    this.#empty = this.#isEmpty;
    this.#setState('loading', this.#loading.pending);
    this.#setState('error', this.#failure.newest !== null);
    this.#setState('empty', this.#empty);
    if (changed) {
      this.#extras.apply();
    }
  }

  #setState(state: 'loading' | 'error' | 'empty', on: boolean) {
    this.#states?.[on ? 'add' : 'delete'](state);
  }

  /**
   * Removes the poster and its slot once everything requested has been drawn for the first time, or is known to
   * fail.
   */
  #reveal() {
    if (this.#revealed || this.#loading.pending || !this.#context.viewport.upToDate) return;
    if (this.#failure.newest !== null && !this.#loading.shows) return;
    this.#revealed = true;
    this.#viewer.requestUpdate();
  }

  /** Objects of the scene may have come or gone. Cheap: called for each frame. */
  #checkEmpty() {
    if (this.#isEmpty !== this.#empty) {
      this.#viewer.requestUpdate();
    }
  }

  get #isEmpty(): boolean {
    return !this.#loading.wanted && this.#context.picture.scene.children.length === 0;
  }
}

/**
 * Style of slotted content: the text size around a viewer and the comparison that it is in, which
 * have their own.
 */
function pageText(viewer: HTMLElement): string {
  const outermost = viewer.closest('phong-compare') ?? viewer;
  const around = outermost.parentElement ?? (outermost.getRootNode() as Partial<ShadowRoot>).host;
  return `--phong-page: ${around === undefined ? '' : getComputedStyle(around).fontSize}`;
}

/**
 * Custom states, by which CSS learns what a viewer is doing: `phong-viewer:state(loading)`.
 * Undefined in browsers without them, and where they are refused: Chrome before 125 accepts only
 * names that begin with two dashes (https://chromestatus.com/feature/5586433790443520), and a tag
 * with an attribute `is` has none.
 */
function customStates(element: HTMLElement): Set<string> | undefined {
  try {
    const { states } = element.attachInternals() as { readonly states?: Set<string> };
    states?.add('loading');
    states?.delete('loading');
    return states;
  } catch {
    return undefined;
  }
}

/**
 * Whether a key has done something inside the viewer. Such keys do not reach the page: they would
 * turn a slide.
 */
function isUsed(event: KeyboardEvent): boolean {
  if (event.defaultPrevented) return true;
  if (
    event.ctrlKey ||
    event.altKey ||
    event.metaKey ||
    event.key === 'Tab' ||
    event.key === 'Escape'
  ) {
    return false;
  }
  const [target] = event.composedPath() as [Element];
  // What is slotted is the page's own.
  return (
    target.getRootNode() === event.currentTarget &&
    target.matches('button, input, select, textarea')
  );
}
