// What a viewer shows around its picture: poster, progress bar, message, custom states, description. Brings the shadow
// tree in step with what is loaded and what has failed.
import type { TemplateResult } from 'lit';
import { checkedTexts, type ViewerTexts } from '../fields/texts.js';
import type { PhongViewer } from '../elements.js';
import { pageTexts, textsOver } from '../page/page-texts.js';
import { ViewerAnnouncements } from './announcements.js';
import type { ViewerContext } from './viewer-context.js';
import type { ViewerExtras } from './extras.js';
import type { ViewerFailure } from './failure.js';
import type { ViewerLoading } from './loading.js';
import { surfaceName } from './naming.js';
import { treeIn, type ViewerTree, viewerTemplate } from './template.js';

export class ViewerDisplay {
  readonly #viewer: PhongViewer;
  readonly #context: ViewerContext;
  readonly #loading: ViewerLoading;
  readonly #failure: ViewerFailure;
  readonly #states: ViewerStates;
  readonly #announcements: ViewerAnnouncements;
  readonly #extras: ViewerExtras;
  /** Null before the element is connected for the first time. */
  #tree: ViewerTree | null = null;
  /** The viewer's own. */
  #texts: ViewerTexts | null = null;
  /** Those over the page's; null if they have to be put together again. */
  #used: { readonly page: ViewerTexts | null; readonly texts: ViewerTexts | null } | null = null;
  /** The poster that could not be shown. */
  #badPoster = '';
  /** The poster has been replaced by a picture. */
  #revealed = false;
  #empty = false;

  constructor(context: ViewerContext, loading: ViewerLoading, failure: ViewerFailure, extras: ViewerExtras) {
    const { viewer, signals } = (this.#context = context);
    this.#viewer = viewer;
    this.#loading = loading;
    this.#failure = failure;
    this.#extras = extras;
    this.#states = new ViewerStates(viewer);
    this.#announcements = new ViewerAnnouncements(context);
    for (const part of [this.#announcements, extras]) viewer.addController(part);
    signals.loadingChanged.listen(() => viewer.requestUpdate());
    signals.meshesChanged.listen(() => this.#checkEmpty());
    signals.drawn.listen(() => {
      this.#checkEmpty();
      this.#reveal();
    });
    signals.ended.listen(() => this.#reveal());
    signals.shown.listen(() => viewer.dispatchEvent(new CustomEvent('render')));
  }

  /** What the shadow tree shows now. */
  template(): TemplateResult {
    const viewer = this.#viewer;
    const loading = this.#loading;
    const failure = this.#failure;
    const { poster } = viewer;
    if (poster !== this.#badPoster) this.#badPoster = '';
    const isSlotting = loading.bar !== undefined || failure.newest !== null;
    return viewerTemplate({
      holder: this.#context.viewport.holder,
      name: surfaceName(viewer, this.texts),
      description: this.#announcements.description,
      reader: this.#announcements.template(),
      fixed: !viewer.orbit,
      busy: loading.pending,
      poster: this.#revealed || poster === this.#badPoster ? '' : poster,
      onPosterError: this.#dropPoster,
      bar: loading.bar,
      pageText: isSlotting ? pageText(viewer) : '',
      failure: failure.newest,
      retryable: failure.retryable,
      dismissible: failure.dismissible,
      onButton: this.#onButton,
      texts: this.texts,
    });
  }

  readonly #onButton = (): void => {
    if (!this.#failure.dismiss()) this.#loading.retry();
  };

  readonly #onKey = (event: Event): void => {
    // Escape must do nothing else then, such as closing a dialog around the viewer.
    const escapes = (event as KeyboardEvent).key === 'Escape' && !event.defaultPrevented;
    if (escapes && this.#failure.dismiss()) event.preventDefault();
    if (isUsed(event as KeyboardEvent)) event.stopPropagation();
  };

  readonly #dropPoster = (): void => {
    this.#badPoster = this.#viewer.poster;
    this.#viewer.requestUpdate();
  };

  /** The shadow tree is there for the first time. Returns the surface: the picture, without the panel. */
  connect(root: ParentNode): HTMLElement {
    this.#tree = treeIn(root);
    root.addEventListener('keydown', this.#onKey);
    this.#announcements.connect(this.#tree);
    this.#extras.connect(this.#tree);
    this.#extras.apply();
    return this.#tree.surface;
  }

  /** Before the tree is rendered: a focused message that goes leaves its focus to the picture. */
  keepFocus(root: ParentNode): void {
    if (this.#failure.newest !== null) return;
    if (root.querySelector('.message')?.matches(':focus-within') === true)
      this.#tree?.surface.focus({ preventScroll: true });
  }

  /** The control panel's place. */
  get panel(): HTMLElement | null {
    return this.#tree?.panel ?? null;
  }

  /** Those in use: the viewer's own, then the page's. */
  get texts(): ViewerTexts | null {
    const page = pageTexts();
    if (this.#used === null || this.#used.page !== page) this.#used = { page, texts: textsOver(this.#texts, page) };
    return this.#used.texts;
  }

  set texts(texts: ViewerTexts | null | undefined) {
    this.#texts = checkedTexts(texts);
    this.#used = null;
    this.#viewer.requestUpdate('texts');
  }

  /** The tree was rendered. `changed`: not for a text beside the picture alone, which extras do not depend on. */
  updated(changed: boolean): void {
    const loading = this.#loading;
    const failure = this.#failure;
    this.#empty = this.#isEmpty;
    this.#states.set('loading', loading.pending);
    this.#states.set('error', failure.newest !== null);
    this.#states.set('empty', this.#empty);
    if (changed) this.#extras.apply();
  }

  /** Removes the poster once everything requested has been drawn for the first time, or is known to fail. */
  #reveal(): void {
    if (this.#revealed || this.#loading.pending || !this.#context.viewport.upToDate) return;
    if (this.#failure.newest !== null && !this.#loading.shows) return;
    this.#revealed = true;
    if (this.#viewer.poster !== '') this.#viewer.requestUpdate();
  }

  /** Objects of the scene may have come or gone. Cheap: called for each frame. */
  #checkEmpty(): void {
    if (this.#isEmpty !== this.#empty) this.#viewer.requestUpdate();
  }

  get #isEmpty(): boolean {
    return !this.#loading.wanted && this.#context.picture.scene.children.length === 0;
  }
}

/**
 * Text size around a viewer and the comparison that it is in, which have sizes of their own. CSS pixels with a unit.
 */
function pageText(viewer: HTMLElement): string {
  const outermost = viewer.closest('phong-compare') ?? viewer;
  const around = outermost.parentElement ?? (outermost.getRootNode() as Partial<ShadowRoot>).host;
  return around === undefined ? '' : getComputedStyle(around).fontSize;
}

/**
 * Custom states, by which CSS learns what a viewer is doing: `phong-viewer:state(loading)`. Browsers without them go
 * without.
 */
class ViewerStates {
  #states: Set<string> | undefined;

  constructor(element: HTMLElement) {
    // Missing in older browsers, whatever the types say.
    const { attachInternals } = element as Partial<HTMLElement>;
    try {
      this.#states = (attachInternals?.call(element) as Partial<ElementInternals> | undefined)?.states;
    } catch {
      // refused where the tag has an attribute `is`
    }
  }

  set(state: 'loading' | 'error' | 'empty', on: boolean): void {
    try {
      if (on) this.#states?.add(state);
      else this.#states?.delete(state);
    } catch {
      this.#states = undefined; // Chrome before 125 accepts only names that begin with two dashes
    }
  }
}

/**
 * Whether a key has done something inside the viewer: by a handler, or in a field or button. Such keys do not reach the
 * page, where they would turn a slide.
 */
function isUsed(event: KeyboardEvent): boolean {
  if (event.defaultPrevented) return true;
  if (event.ctrlKey || event.altKey || event.metaKey || event.key === 'Tab' || event.key === 'Escape') return false;
  const [target] = event.composedPath() as [Element];
  // What is slotted is the page's own.
  return target.getRootNode() === event.currentTarget && target.matches('button, input, select, textarea');
}
