// Whether an element is in view or near it, and its device pixels: measured when asked, then as
// observers report.
import type { LitElement, ReactiveController } from 'lit';
import type { Signal } from '../../../phong/fields/signal.js';
import { zoomOf } from '../../../phong/camera/gesture.js';
import { type PageObservers, pageOf } from './page-observers.js';

/** As last measured, so that reading it lays nothing out. */
export interface BoxSize {
  /** CSS pixels. */
  readonly width: number;
  readonly height: number;
  /** Pixels of the page, as of pointer events, for each of these. */
  readonly zoom: number;
}

export interface ElementView {
  /** Displayed in a document that is shown, wherever it is on the page. */
  readonly painted: boolean;
  /** Painted, and in view or less than a screen height away from it. */
  readonly near: boolean;
  readonly visible: boolean;
  /**
   * The page is about to be printed, and waits until this time, as of `performance.now()`: only the
   * picture of this moment counts. Null: it is not.
   */
  readonly printsAt: number | null;
  /** Device pixels, whole. */
  readonly pixelWidth: number;
  readonly pixelHeight: number;
}

/**
 * Watches `element` while its host is connected and gives `changed` after each change. `closed`:
 * see there.
 */
export class Visibility implements ReactiveController {
  /** The element's window was closed, or its iframe removed. No element is disconnected by that. */
  readonly closed: () => void;
  readonly #host: LitElement;
  readonly #element: HTMLElement;
  readonly #changed: Signal<ElementView>;
  #page: PageObservers | null = null;
  /** By layout, whatever hides the element there; null until it is known. */
  #inView: boolean | null = null;
  #near: boolean | null = null;
  /** When its layout was last read, as of the window's `performance.now()`. Infinity: not yet. */
  #located = Infinity;
  #size = { width: 0, height: 0, zoom: 1, pixelWidth: 0, pixelHeight: 0 };
  #maxRatio = Infinity;
  /** In device pixels, as the observer reported it last. Missing in browsers without such boxes. */
  #box: ResizeObserverSize | undefined;

  constructor(
    host: LitElement,
    element: HTMLElement,
    changed: Signal<ElementView>,
    closed: () => void,
  ) {
    this.#host = host;
    this.#element = element;
    this.#changed = changed;
    this.closed = closed;
    // No observer reports CSS `visibility`, which changes no box. A transition in the element's
    // style sheet does.
    for (const type of TRANSITION_EVENTS) {
      element.addEventListener(type, ({ propertyName }) => {
        if (propertyName === 'visibility') {
          this.shown();
        }
      });
    }
  }

  get size(): BoxSize {
    return this.#size;
  }

  /** Most pixels per CSS pixel, whatever the device has. Above 0. */
  set maxRatio(ratio: number) {
    if (ratio === this.#maxRatio) return;
    this.#maxRatio = ratio;
    this.scaled();
  }

  /** The host is connected to a document that is shown in a window. */
  get connected(): boolean {
    return this.#page !== null;
  }

  /** {@link look} was called, or an observer has reported, since the element was connected. */
  get measured(): boolean {
    return this.#inView !== null || this.#near !== null;
  }

  hostConnected(): void {
    const { ownerDocument } = this.#host;
    this.#page = pageOf(ownerDocument);
    // The first time it is outside the host's shadow tree, and belongs to the script's document.
    if (this.#element.ownerDocument !== ownerDocument) {
      ownerDocument.adoptNode(this.#element);
    }
    this.#page?.watch(this.#element, this);
  }

  hostDisconnected(): void {
    this.#page?.unwatch(this.#element);
    this.#page = null;
    this.#inView = null;
    this.#near = null;
    this.#located = Infinity;
  }

  /** Measures now, by layout: observers report only after a frame. */
  measureNow(): void {
    if (this.#page === null) return;
    this.#locate(this.#page);
    this.#measure(this.#element.clientWidth, this.#element.clientHeight);
    this.shown();
  }

  /**
   * Before printing, which waits until `deadline`. On paper everything is seen, wherever it is on
   * the page.
   */
  printed(deadline: number): void {
    this.#measure(this.#element.clientWidth, this.#element.clientHeight);
    const visible = this.#inView === true;
    this.#changed.emit({ painted: true, near: true, visible, printsAt: deadline, ...this.#size });
    this.shown();
  }

  /** The element was scrolled into or out of view, or its display has changed. */
  intersected(entry: IntersectionObserverEntry): void {
    this.#inView = entry.isIntersecting && entry.intersectionRatio > 0;
    this.#reported(entry);
  }

  /** The same for the surroundings of the view, {@link PageObservers.margin} wide. */
  neared(entry: IntersectionObserverEntry): void {
    this.#near = entry.isIntersecting;
    this.#reported(entry);
  }

  resized(entry: ResizeObserverEntry): void {
    const { width, height } = entry.contentRect;
    // The other observers report an element that is shown again only after this frame.
    if (this.#near === false && this.#page !== null) {
      this.#locate(this.#page);
    }
    // Missing in browsers without this box, whatever the types say.
    this.#box = (entry.devicePixelContentBoxSize as readonly ResizeObserverSize[] | undefined)?.[0];
    this.#measure(width, height);
    this.shown();
  }

  /** The pixels per CSS pixel have changed, or their limit. */
  scaled(): void {
    this.#measure(this.#size.width, this.#size.height);
    this.shown();
  }

  /**
   * The document was shown or hidden, or the element's place in it or its style may have changed.
   */
  shown(): void {
    if (!this.measured) return;
    const painted =
      this.#host.ownerDocument.visibilityState !== 'hidden' && isPainted(this.#element);
    const visible = painted && this.#inView === true;
    const near = visible || (painted && this.#near === true && !isCollapsed(this.#element));
    this.#changed.emit({ painted, near, visible, printsAt: null, ...this.#size });
  }

  /**
   * Reports come after their frame: meanwhile the element may have been shown. Browsers round both
   * times, so equal ones may be that late too.
   */
  #reported({ time }: IntersectionObserverEntry) {
    if (time <= this.#located && this.#page !== null) {
      this.#locate(this.#page);
      this.#page.reportAgain(this.#element);
    }
    this.shown();
  }

  #locate({ margin, view }: PageObservers) {
    this.#located = view.performance.now();
    const distance = distanceFromView(this.#element);
    this.#inView = distance < 0;
    this.#near = distance < margin;
  }

  #measure(width: number, height: number) {
    // Neither includes CSS zoom: inside zoom 2 an element covers twice as many pixels per CSS
    // pixel.
    const zoom = zoomOf(this.#element);
    const ratio = Math.min((this.#page?.view.devicePixelRatio ?? 1) * zoom, this.#maxRatio);
    // A low limit leaves one pixel at least.
    const pixels = (length: number) =>
      Math.max(Math.round(length * ratio), Math.round(Math.min(length, 1)));
    this.#size = {
      width,
      height,
      zoom,
      pixelWidth: pixels(width),
      pixelHeight: pixels(height),
    };
    this.#refine();
  }

  /**
   * Uses the browser's pixels if they round what was measured: an emulated pixel ratio does not
   * reach the box.
   */
  #refine() {
    if (this.#box === undefined) return;
    const { inlineSize: width, blockSize: height } = this.#box; // see own-text.css
    const { pixelWidth, pixelHeight } = this.#size;
    if (Math.abs(width - pixelWidth) > 1 || Math.abs(height - pixelHeight) > 1) return;
    this.#size = { ...this.#size, pixelWidth: width, pixelHeight: height };
  }
}

/** Hidden at the end of its transition, visible from its start. */
const TRANSITION_EVENTS = ['transitionrun', 'transitionend', 'transitioncancel'] as const;

/**
 * Neither `visibility: hidden` nor inside skipped content: a closed <details>, `content-visibility:
 * hidden`.
 */
export function isPainted(element: Element): boolean {
  // Missing in older browsers, whatever the types say.
  const { checkVisibility } = element as { checkVisibility?: Element['checkVisibility'] };
  return checkVisibility?.call(element, { visibilityProperty: true }) ?? true;
}

/**
 * CSS pixels out of the scroll containers and windows around it; negative in view, Infinity without
 * a size.
 */
function distanceFromView(element: Element): number {
  const view = element.ownerDocument.defaultView;
  const place = element.getBoundingClientRect();
  if (view === null || place.width === 0 || place.height === 0) return Infinity;
  let distance = gap(place, { top: 0, left: 0, bottom: view.innerHeight, right: view.innerWidth });
  let { position } = view.getComputedStyle(element);
  for (let box = parentOf(element); box !== null && position !== 'fixed'; box = parentOf(box)) {
    const style = view.getComputedStyle(box);
    if (position === 'absolute' && style.position === 'static') continue; // not its containing block: clips nothing
    ({ position } = style);
    if (style.overflow !== 'visible' && !isPage(box)) {
      distance = Math.max(distance, gap(place, box.getBoundingClientRect()));
    }
  }
  return view.frameElement === null
    ? distance
    : Math.max(distance, distanceFromView(view.frameElement));
}

/** The overflow of these is the window's. */
const isPage = (box: Element) =>
  box === box.ownerDocument.documentElement || box === box.ownerDocument.body;

type Edges = Pick<DOMRect, 'top' | 'left' | 'bottom' | 'right'>;

const gap = (a: Edges, b: Edges) =>
  Math.max(a.top - b.bottom, b.top - a.bottom, a.left - b.right, b.left - a.right);

/**
 * In a closed box, such as an accordion's: no width or no height, and nothing shows outside it. By
 * its distance from the view its content would count as near.
 */
export function isCollapsed(element: Element): boolean {
  const view = element.ownerDocument.defaultView;
  for (let box: Element | null = element; box !== null; box = parentOf(box)) {
    const flat = box.clientWidth === 0 || box.clientHeight === 0;
    if (flat && view?.getComputedStyle(box).overflow.includes('visible') === false) return true;
  }
  return false;
}

const parentOf = (element: Element): Element | null =>
  element.assignedSlot ??
  element.parentElement ??
  (element.getRootNode() as Partial<ShadowRoot>).host ??
  null;
