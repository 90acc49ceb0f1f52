// Can an element be seen, and how many device pixels is it? Looks once when asked and then listens; nothing polls.
// Knows nothing of what the element shows.
import type { ReactiveController } from 'lit';
import { pageObservers, type Sighted } from './page-observers.js';

export interface Sight {
  readonly visible: boolean;
  /** Only the picture of this very moment will be seen. */
  readonly printing: boolean;
  /** CSS pixels. */
  readonly width: number;
  readonly height: number;
  /** Device pixels, whole. */
  readonly pixelWidth: number;
  readonly pixelHeight: number;
}

/** Watches `element` between {@link hostConnected} and {@link hostDisconnected} and tells `seen` what changed. */
export class Visibility implements ReactiveController, Sighted {
  readonly #element: HTMLElement;
  readonly #seen: (sight: Sight) => void;
  #onScreen: boolean | null = null;
  #size = { width: 0, height: 0, pixelWidth: 0, pixelHeight: 0 };

  constructor(element: HTMLElement, seen: (sight: Sight) => void) {
    this.#element = element;
    this.#seen = seen;
  }

  get size(): { readonly width: number; readonly height: number } {
    return this.#size;
  }

  /** Somebody has looked, or nobody could: a hidden document tells nothing until it is shown. */
  get known(): boolean {
    return this.#onScreen !== null || document.visibilityState === 'hidden';
  }

  /** {@link look} has been called, or an observer has answered, since the element was connected. */
  get looked(): boolean {
    return this.#onScreen !== null;
  }

  hostConnected(): void {
    pageObservers.watch(this.#element, this);
    // CSS `visibility` moves no box, so no observer tells of it; the element's style sheet gives it a transition that does.
    for (const type of TRANSITION_EVENTS) this.#element.addEventListener(type, this.#onTransition);
  }

  hostDisconnected(): void {
    pageObservers.unwatch(this.#element);
    for (const type of TRANSITION_EVENTS) this.#element.removeEventListener(type, this.#onTransition);
    this.#onScreen = null;
  }

  /** Looks now, by layout: observers only answer after a frame. */
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

  /** Paper has no below the fold: everything is seen for a moment. */
  printed(): void {
    this.#measure(this.#element.clientWidth, this.#element.clientHeight);
    this.#seen({ visible: true, printing: true, ...this.#size });
    this.shown();
  }

  intersected(entry: IntersectionObserverEntry): void {
    this.#onScreen = entry.isIntersecting;
    this.shown();
  }

  resized(entry: ResizeObserverEntry): void {
    const { width, height } = entry.contentRect;
    this.#measure(width, height);
    // Absent where the browser does not know the box, whatever the types say.
    const box = (entry.devicePixelContentBoxSize as readonly ResizeObserverSize[] | undefined)?.[0];
    if (box !== undefined) this.#refine(box);
    this.shown();
  }

  scaled(): void {
    this.#measure(this.#size.width, this.#size.height);
    this.shown();
  }

  /** Tells what can be seen: the document, the place on it or its style may have changed. */
  shown(): void {
    if (this.#onScreen === null) return;
    const visible = this.#onScreen && document.visibilityState === 'visible' && isPainted(this.#element);
    this.#seen({ visible, printing: false, ...this.#size });
  }

  readonly #onTransition = ({ propertyName }: TransitionEvent): void => {
    if (propertyName === 'visibility') this.shown();
  };

  /** The browser's own whole pixels, where they round what was measured: an emulated ratio does not reach the box. */
  #refine(box: ResizeObserverSize): void {
    const upright = getComputedStyle(this.#element).writingMode.startsWith('horizontal');
    const width = upright ? box.inlineSize : box.blockSize;
    const height = upright ? box.blockSize : box.inlineSize;
    if (Math.abs(width - this.#size.pixelWidth) > 1 || Math.abs(height - this.#size.pixelHeight) > 1) return;
    this.#size.pixelWidth = width;
    this.#size.pixelHeight = height;
  }

  #measure(width: number, height: number): void {
    // CSS zoom is in neither: an element inside zoom: 2 covers twice the pixels that its own CSS pixels say.
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

/** Neither `visibility: hidden` nor inside what is skipped: a closed <details>, `content-visibility: hidden`. */
function isPainted(element: Element): boolean {
  // Absent where the browser does not know it yet, whatever the types say.
  const { checkVisibility } = element as { checkVisibility?: Element['checkVisibility'] };
  return checkVisibility?.call(element, { visibilityProperty: true }) ?? true;
}
