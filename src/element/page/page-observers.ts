// Visibility, size, printing and pixel ratio, observed for all viewers of a page by one set of observers and listeners.
// There are none while no element is watched. Knows nothing of what is watched.

/** Watches one element. */
export interface Watcher {
  /** The element was scrolled into or out of view, or its display has changed. */
  intersected(entry: IntersectionObserverEntry): void;
  resized(entry: ResizeObserverEntry): void;
  /** The document was shown or hidden. */
  shown(): void;
  /** The page is about to be printed. */
  printed(): void;
  /** The device's pixels per CSS pixel have changed. */
  scaled(): void;
}

interface Observers {
  readonly intersection: IntersectionObserver;
  readonly resize: ResizeObserver;
  readonly listeners: AbortController;
}

class PageObservers {
  readonly #watched = new Map<Element, Watcher>();
  #observers: Observers | null = null;

  watch(element: Element, watcher: Watcher): void {
    this.#observers ??= this.#open();
    this.#watched.set(element, watcher);
    const { intersection, resize } = this.#observers;
    intersection.observe(element);
    try {
      // In whole device pixels, exactly.
      resize.observe(element, { box: 'device-pixel-content-box' });
    } catch {
      resize.observe(element);
    }
  }

  unwatch(element: Element): void {
    if (!this.#watched.delete(element) || this.#observers === null) return;
    const { intersection, resize, listeners } = this.#observers;
    intersection.unobserve(element);
    resize.unobserve(element);
    if (this.#watched.size > 0) return;
    this.#observers = null;
    intersection.disconnect();
    resize.disconnect();
    listeners.abort();
  }

  #open(): Observers {
    const listeners = new AbortController();
    const { signal } = listeners;
    document.addEventListener('visibilitychange', () => this.#notify('shown'), { signal });
    window.addEventListener('beforeprint', () => this.#notify('printed'), { signal });
    this.#watchRatio(signal);
    return {
      intersection: new IntersectionObserver((entries) => {
        for (const entry of entries) this.#watched.get(entry.target)?.intersected(entry);
      }),
      resize: new ResizeObserver((entries) => {
        for (const entry of entries) this.#watched.get(entry.target)?.resized(entry);
      }),
      listeners,
    };
  }

  /** Observers do not always report a new pixel ratio. A query matches one ratio, so each change needs a new query. */
  #watchRatio(signal: AbortSignal): void {
    const query = matchMedia(`(resolution: ${String(window.devicePixelRatio)}dppx)`);
    const changed = (): void => {
      this.#watchRatio(signal);
      this.#notify('scaled');
    };
    query.addEventListener('change', changed, { once: true, signal });
  }

  #notify(what: 'shown' | 'printed' | 'scaled'): void {
    // A copy: watchers may come and go meanwhile.
    for (const watcher of [...this.#watched.values()]) watcher[what]();
  }
}

/** One for the page. */
export const pageObservers = new PageObservers();
