// Is an element visible, and how many device pixels does it cover? Measures once when asked, then follows the page's
// observers; nothing polls. Knows nothing of what the element shows.
import type { ReactiveController } from '@lit/reactive-element';
import { pageObservers, type Watcher } from './page-observers.js';

export interface ElementView {
  readonly visible: boolean;
  /** The page is about to be printed: only the picture of this moment counts. */
  readonly printing: boolean;
  /** CSS pixels. */
  readonly width: number;
  readonly height: number;
  /** Device pixels, whole. */
  readonly pixelWidth: number;
  readonly pixelHeight: number;
}

/** Watches `element` while its host is connected and calls `changed` after each change. */
export class Visibility implements ReactiveController, Watcher {
  readonly #element: HTMLElement;
  readonly #changed: (view: ElementView) => void;
  #onScreen: boolean | null = null;
  #size = { width: 0, height: 0, pixelWidth: 0, pixelHeight: 0 };

  constructor(element: HTMLElement, changed: (view: ElementView) => void) {
    this.#element = element;
    this.#changed = changed;
  }

  get size(): { readonly width: number; readonly height: number } {
    return this.#size;
  }

  /** Visibility is known, or cannot be: observers report nothing while the document is hidden. */
  get known(): boolean {
    return this.#onScreen !== null || document.visibilityState === 'hidden';
  }

  /** {@link look} was called, or an observer has reported, since the element was connected. */
  get looked(): boolean {
    return this.#onScreen !== null;
  }

  hostConnected(): void {
    pageObservers.watch(this.#element, this);
    // No observer reports CSS `visibility`, which changes no box. A transition in the element's style sheet does.
    for (const type of TRANSITION_EVENTS) this.#element.addEventListener(type, this.#onTransition);
  }

  hostDisconnected(): void {
    pageObservers.unwatch(this.#element);
    for (const type of TRANSITION_EVENTS) this.#element.removeEventListener(type, this.#onTransition);
    this.#onScreen = null;
  }

  /** Measures now, by layout: observers report only after a frame. */
  look(): void {
    const box = this.#element.getBoundingClientRect();
    this.#onScreen =
      box.width > 0 &&
      box.height > 0 &&
      box.bottom > 0 &&
      box.right > 0 &&
      box.top < window.innerHeight &&
      box.left < window.innerWidth;
    this.#measure(this.#element.clientWidth, this.#element.clientHeight);
    this.shown();
  }

  /** On paper everything is visible, wherever it is on the page. */
  printed(): void {
    this.#measure(this.#element.clientWidth, this.#element.clientHeight);
    this.#changed({ visible: true, printing: true, ...this.#size });
    this.shown();
  }

  intersected(entry: IntersectionObserverEntry): void {
    this.#onScreen = entry.isIntersecting;
    this.shown();
  }

  resized(entry: ResizeObserverEntry): void {
    const { width, height } = entry.contentRect;
    this.#measure(width, height);
    // Missing in browsers without this box, whatever the types say.
    const box = (entry.devicePixelContentBoxSize as readonly ResizeObserverSize[] | undefined)?.[0];
    if (box !== undefined) this.#refine(box);
    this.shown();
  }

  scaled(): void {
    this.#measure(this.#size.width, this.#size.height);
    this.shown();
  }

  /** The document, the element's place in it or its style may have changed. */
  shown(): void {
    if (this.#onScreen === null) return;
    const visible = this.#onScreen && document.visibilityState === 'visible' && isPainted(this.#element);
    this.#changed({ visible, printing: false, ...this.#size });
  }

  readonly #onTransition = ({ propertyName }: TransitionEvent): void => {
    if (propertyName === 'visibility') this.shown();
  };

  /** Uses the browser's own whole pixels if they round what was measured: an emulated pixel ratio does not reach the box. */
  #refine(box: ResizeObserverSize): void {
    const upright = getComputedStyle(this.#element).writingMode.startsWith('horizontal');
    const width = upright ? box.inlineSize : box.blockSize;
    const height = upright ? box.blockSize : box.inlineSize;
    if (Math.abs(width - this.#size.pixelWidth) > 1 || Math.abs(height - this.#size.pixelHeight) > 1) return;
    this.#size.pixelWidth = width;
    this.#size.pixelHeight = height;
  }

  #measure(width: number, height: number): void {
    // Neither includes CSS zoom: inside zoom 2 an element covers twice as many pixels per CSS pixel.
    const ratio =
      window.devicePixelRatio * ((this.#element as { currentCSSZoom?: number }).currentCSSZoom ?? 1);
    this.#size = {
      width,
      height,
      pixelWidth: Math.round(width * ratio),
      pixelHeight: Math.round(height * ratio),
    };
  }
}

/** Hidden at the end of its transition, visible from its start. */
const TRANSITION_EVENTS = ['transitionrun', 'transitionend', 'transitioncancel'] as const;

/** Neither `visibility: hidden` nor inside skipped content: a closed <details>, `content-visibility: hidden`. */
function isPainted(element: Element): boolean {
  // Missing in older browsers, whatever the types say.
  const { checkVisibility } = element as { checkVisibility?: Element['checkVisibility'] };
  return checkVisibility?.call(element, { visibilityProperty: true }) ?? true;
}
