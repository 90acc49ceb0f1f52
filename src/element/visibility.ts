// Can an element be seen, and how many device pixels is it? Looks once when asked and then listens; nothing polls.
// Knows nothing of what the element shows.
import type { ReactiveController } from 'lit';

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
export class Visibility implements ReactiveController {
  readonly #element: HTMLElement;
  readonly #seen: (sight: Sight) => void;
  #intersection: IntersectionObserver | null = null;
  #resize: ResizeObserver | null = null;
  #listening: AbortController | null = null;
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
    this.#listening = new AbortController();
    const { signal } = this.#listening;
    document.addEventListener('visibilitychange', this.#tell, { signal });
    window.addEventListener('beforeprint', this.#onPrint, { signal });
    this.#intersection = new IntersectionObserver(this.#onIntersection);
    this.#intersection.observe(this.#element);
    this.#resize = new ResizeObserver(this.#onResize);
    try {
      // Whole device pixels, exactly.
      this.#resize.observe(this.#element, { box: 'device-pixel-content-box' });
    } catch {
      this.#resize.observe(this.#element);
    }
    this.#watchRatio(signal);
  }

  hostDisconnected(): void {
    this.#listening?.abort();
    this.#intersection?.disconnect();
    this.#resize?.disconnect();
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
    this.#tell();
  }

  /** Paper has no below the fold: everything is seen for a moment. */
  readonly #onPrint = (): void => {
    this.#measure(this.#element.clientWidth, this.#element.clientHeight);
    this.#seen({ visible: true, printing: true, ...this.#size });
    this.#tell();
  };

  readonly #onIntersection = (entries: readonly IntersectionObserverEntry[]): void => {
    this.#onScreen = entries.at(-1)?.isIntersecting ?? false;
    this.#tell();
  };

  readonly #onResize = (entries: readonly ResizeObserverEntry[]): void => {
    const entry = entries.at(-1);
    if (entry === undefined) return;
    const { width, height } = entry.contentRect;
    this.#measure(width, height);
    // Absent where the browser does not know the box, whatever the types say.
    const box = (entry.devicePixelContentBoxSize as readonly ResizeObserverSize[] | undefined)?.[0];
    if (box !== undefined) this.#refine(box);
    this.#tell();
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

  /** Observers do not always tell of another ratio. A query matches one ratio: each change makes the next. */
  #watchRatio(signal: AbortSignal): void {
    const query = matchMedia(`(resolution: ${String(window.devicePixelRatio)}dppx)`);
    const changed = (): void => {
      this.#measure(this.#size.width, this.#size.height);
      this.#tell();
      this.#watchRatio(signal);
    };
    query.addEventListener('change', changed, { once: true, signal });
  }

  readonly #tell = (): void => {
    if (this.#onScreen === null) return;
    const visible = this.#onScreen && document.visibilityState === 'visible';
    this.#seen({ visible, printing: false, ...this.#size });
  };
}
