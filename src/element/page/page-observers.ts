// What the page tells its viewers of: one observer of each kind and one set of listeners for all of them, none while
// there is nobody to tell. Knows nothing of what is watched.

export interface Sighted {
  /** Scrolled into or out of view, or displayed or not any more. */
  intersected(entry: IntersectionObserverEntry): void;
  resized(entry: ResizeObserverEntry): void;
  /** The document was shown or hidden. */
  shown(): void;
  /** The page is about to be printed. */
  printed(): void;
  /** The device's pixels per CSS pixel have changed. */
  scaled(): void;
}

interface Senses {
  readonly intersection: IntersectionObserver;
  readonly resize: ResizeObserver;
  readonly listening: AbortController;
}

class PageObservers {
  readonly #watched = new Map<Element, Sighted>();
  #senses: Senses | null = null;

  watch(element: Element, sighted: Sighted): void {
    this.#senses ??= this.#open();
    this.#watched.set(element, sighted);
    const { intersection, resize } = this.#senses;
    intersection.observe(element);
    try {
      // Whole device pixels, exactly.
      resize.observe(element, { box: 'device-pixel-content-box' });
    } catch {
      resize.observe(element);
    }
  }

  unwatch(element: Element): void {
    if (!this.#watched.delete(element) || this.#senses === null) return;
    const { intersection, resize, listening } = this.#senses;
    intersection.unobserve(element);
    resize.unobserve(element);
    if (this.#watched.size > 0) return;
    this.#senses = null;
    intersection.disconnect();
    resize.disconnect();
    listening.abort();
  }

  #open(): Senses {
    const listening = new AbortController();
    const { signal } = listening;
    document.addEventListener('visibilitychange', () => this.#tell('shown'), { signal });
    window.addEventListener('beforeprint', () => this.#tell('printed'), { signal });
    this.#watchRatio(signal);
    return {
      intersection: new IntersectionObserver((entries) => {
        for (const entry of entries) this.#watched.get(entry.target)?.intersected(entry);
      }),
      resize: new ResizeObserver((entries) => {
        for (const entry of entries) this.#watched.get(entry.target)?.resized(entry);
      }),
      listening,
    };
  }

  /** Observers do not always tell of another ratio. A query matches one ratio: each change makes the next. */
  #watchRatio(signal: AbortSignal): void {
    const query = matchMedia(`(resolution: ${String(window.devicePixelRatio)}dppx)`);
    const changed = (): void => {
      this.#watchRatio(signal);
      this.#tell('scaled');
    };
    query.addEventListener('change', changed, { once: true, signal });
  }

  /** Who is told may leave, or bring others. */
  #tell(what: 'shown' | 'printed' | 'scaled'): void {
    for (const sighted of [...this.#watched.values()]) sighted[what]();
  }
}

/** The page's one. */
export const pageObservers = new PageObservers();
