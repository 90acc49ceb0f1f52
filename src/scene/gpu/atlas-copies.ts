// The canvases of pictures that share one context: each shows a copy of its part. A picture that cannot be seen keeps its
// copy for when it is scrolled back to, up to a bound for all of them together. Sizes are in device pixels.
import type { Place, Size } from './atlas.js';

/** Whose picture it is. */
export interface CopyClient extends Size {
  /** The element that holds the picture's canvas, and nothing else. */
  readonly holder: HTMLElement;
  /** It can be seen, as far as anybody knows. */
  readonly drawable: boolean;
  /** What was drawn is gone: draw again when it can be seen. */
  invalidate(): void;
}

/** What unseen pictures may keep, in screens: scrolling a page up and down again shows them at once. */
const KEPT_SCREENS = 2;

/** The screen's pixels: what can be seen at a time. */
export const screenPixels = (): number => screen.width * screen.height * devicePixelRatio ** 2;

export class AtlasCopies {
  /** The one drawn longest ago comes first. */
  readonly #canvases = new Map<CopyClient, HTMLCanvasElement>();
  /** Shown since the last trimming. */
  readonly #fresh = new Set<CopyClient>();

  /**
   * Shows a part of `source`. Into a 2D canvas, so that one drawing of all pictures of a frame serves them all: with 16
   * and 64 boxes of 110 × 80 that all move, on software GL, CPU time of all processes is 0.83 and 0.80 of drawing and
   * copying them one by one (0.67 and 0.60 at 40 × 30). One by one, bitmaps handed over from a context of the picture's own
   * size cost 0.89 of 2D canvases, createImageBitmap 0.97.
   */
  show(client: CopyClient, source: HTMLCanvasElement, { x, y, width, height }: Place): void {
    const canvas = this.#canvases.get(client) ?? document.createElement('canvas');
    this.#canvases.delete(client);
    this.#canvases.set(client, canvas);
    this.#fresh.add(client);
    if (canvas.width !== width || canvas.height !== height) {
      canvas.width = width;
      canvas.height = height;
    }
    const context = canvas.getContext('2d');
    if (context === null) return; // no memory for it: the picture stays as it was
    context.globalCompositeOperation = 'copy';
    context.drawImage(source, x, source.height - y - height, width, height, 0, 0, width, height);
    if (client.holder.firstChild !== canvas) client.holder.replaceChildren(canvas);
  }

  /** Gives the pixels of one copy back, now rather than at some garbage collection. */
  drop(client: CopyClient): void {
    const canvas = this.#canvases.get(client);
    if (canvas === undefined) return;
    this.#canvases.delete(client);
    this.#fresh.delete(client);
    canvas.remove();
    canvas.width = 0;
    canvas.height = 0;
  }

  /**
   * After a frame: of the pictures that cannot be seen, those drawn longest ago give back what is beyond the bound. None
   * that this frame has shown: what is drawn unseen will be printed.
   */
  trim(): void {
    if (this.#fresh.size === 0) return; // asking for the screen's size is a call to the browser
    const spared = (client: CopyClient): boolean => client.drawable || this.#fresh.has(client);
    let surplus = -KEPT_SCREENS * screenPixels();
    for (const [client, { width, height }] of this.#canvases) if (!spared(client)) surplus += width * height;
    for (const [client, { width, height }] of this.#canvases) {
      if (surplus <= 0) break;
      if (spared(client)) continue;
      surplus -= width * height;
      this.drop(client);
      client.invalidate();
    }
    this.#fresh.clear();
  }
}
