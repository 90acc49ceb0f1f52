// Watcher, size, printing and pixel ratio for all viewers of a document, by observers of the
// document's own window, which may be that of an iframe or a popup. They observe nothing while no
// element is watched.
import { frameLoopOf } from '../../scene/frame-loop.js';

/** The longest that a page's pictures make printing wait, once each is drawn. */
const PRINT_MS = 3000;

/** An element whose place and size are watched. */
interface Watcher {
  intersected(entry: IntersectionObserverEntry): void;
  /** The same for the surroundings of the view, {@link PageObservers.margin} wide. */
  neared(entry: IntersectionObserverEntry): void;
  resized(entry: ResizeObserverEntry): void;
  /** The document was shown or hidden. */
  shown(): void;
  /** The pixel ratio has changed. */
  scaled(): void;
  /** Before printing, which waits until `deadline`: a time of `performance.now()`. */
  printed(deadline: number): void;
  /** The element's window was closed, or its frame removed. */
  closed(): void;
}

export class PageObservers {
  readonly view: PageWindow;
  readonly #watched = new Map<Element, Watcher>();
  /** One for the view, and one for its surroundings. */
  readonly #intersection: readonly IntersectionObserver[];
  readonly #resize: ResizeObserver;
  #listeners = new AbortController();

  constructor(view: PageWindow) {
    this.view = view;
    const intersection = (report: 'intersected' | 'neared', init: IntersectionObserverInit) =>
      new view.IntersectionObserver((entries) => {
        for (const entry of entries) {
          this.#watched.get(entry.target)?.[report](entry);
        }
      }, init);
    this.#intersection = [
      // Two boxes that only touch, as the slides of a carousel do, intersect with a ratio of 0: the
      // second threshold detects that.
      intersection('intersected', { threshold: [0, 1e-6] }),
      intersection('neared', this.#surroundings),
    ];
    this.#resize = new view.ResizeObserver((entries) => {
      for (const entry of entries) {
        this.#watched.get(entry.target)?.resized(entry);
      }
      frameLoopOf(view).drawResized();
    });
  }

  /**
   * How far from the view an element counts as near, CSS pixels: the screen's height. The window's
   * height would be no measure in an iframe that is as high as its content.
   */
  get margin(): number {
    return this.view.screen.height;
  }

  /**
   * `scrollMargin` widens the window, iframes and scroll containers alike, in browsers that have
   * it. The others, and iframes of other origins, only let the view of their own document be
   * widened, as their root.
   */
  get #surroundings(): IntersectionObserverInit {
    const { view } = this;
    const margin = `${String(this.margin)}px`;
    const isKnown = 'scrollMargin' in view.IntersectionObserver.prototype;
    const isForeign = view.parent !== view && view.frameElement === null;
    return isKnown && !isForeign
      ? { scrollMargin: margin }
      : { root: view.document, rootMargin: margin };
  }

  watch(element: Element, watcher: Watcher): void {
    if (this.#watched.size === 0) {
      this.#listen();
    }
    this.#watched.set(element, watcher);
    for (const observer of this.#intersection) {
      observer.observe(element);
    }
    try {
      // In whole device pixels, exactly.
      this.#resize.observe(element, { box: 'device-pixel-content-box' });
    } catch {
      this.#resize.observe(element);
    }
  }

  /** Reports where the element is after the next frame. */
  reportAgain(element: Element): void {
    for (const observer of this.#intersection) {
      observer.unobserve(element);
      observer.observe(element);
    }
  }

  unwatch(element: Element): void {
    if (!this.#watched.delete(element)) return;
    for (const observer of [...this.#intersection, this.#resize]) {
      observer.unobserve(element);
    }
    if (this.#watched.size === 0) {
      // By a text: an error as the reason would keep the callers on its stack, and so the last
      // viewer.
      this.#listeners.abort('unwatched');
    }
  }

  #listen() {
    const { view } = this;
    const { signal } = (this.#listeners = new AbortController());
    view.document.addEventListener('visibilitychange', () => this.#each('shown'), { signal });
    view.addEventListener('beforeprint', this.#printed, { signal });
    // Not for the window that runs this code: nothing is left to clean up when it closes.
    if (view !== window) {
      view.addEventListener('pagehide', () => this.#each('closed'), {
        signal,
      });
    }
    this.#watchRatio(signal);
  }

  /**
   * Observers do not always report a new pixel ratio. A query matches one ratio, so each change
   * needs a new query.
   */
  #watchRatio(signal: AbortSignal) {
    const query = this.view.matchMedia(`(resolution: ${String(this.view.devicePixelRatio)}dppx)`);
    const changed = () => {
      this.#watchRatio(signal);
      this.#each('scaled');
    };
    query.addEventListener('change', changed, { once: true, signal });
  }

  readonly #printed = () => {
    this.#each('printed', performance.now() + PRINT_MS);
  };

  /** One broken viewer, as with objects of the page's own, must not stop the others. */
  #each(report: 'shown' | 'scaled' | 'closed' | 'printed', deadline = 0) {
    // A copy: watchers may come and go meanwhile.
    for (const watcher of [...this.#watched.values()]) {
      try {
        watcher[report](deadline);
      } catch (error) {
        reportError(error);
      }
    }
  }
}

type PageWindow = Window & typeof globalThis;

/** By document: an iframe's window stays the same when a page replaces its first, empty one. */
const pages = new WeakMap<Document, PageObservers>();

/** The observers of a document; null if it is shown in no window. */
export function pageOf(document: Document): PageObservers | null {
  const view = document.defaultView;
  if (view === null) return null;
  const page = pages.get(document) ?? new PageObservers(view);
  pages.set(document, page);
  return page;
}
