// The 2D canvases of pictures that share one context, in device pixels: each shows a copy of its
// place in the atlas. Pictures out of sight keep theirs up to a common bound, so that scrolling
// back shows them at once.
import type { Region, Size } from '../../../phong/math/region.js';

/** Pixels that pictures out of sight may keep together, in screens. */
const KEPT_SCREENS = 2;

/** The screen's device pixels: the most that is visible at once. */
export const screenPixels = (): number => screen.width * screen.height * devicePixelRatio ** 2;

/**
 * Screens that one picture on the page may cover: enough to scroll and zoom in one that is larger
 * than its window.
 */
const MOST_SCREENS = 4;

/**
 * The size in device pixels that a picture of this size on the page has: a very large one has fewer
 * pixels.
 */
export function sizeOnPage({ width, height }: Size): Size {
  // Zoomed out, some browsers give the screen without the zoom.
  const most = MOST_SCREENS * screen.width * screen.height * Math.max(devicePixelRatio, 1) ** 2;
  const share = Math.min(1, Math.sqrt(most / Math.max(width * height, 1)));
  return { width: Math.ceil(width * share), height: Math.ceil(height * share) };
}

/** A picture that is copied from the atlas. */
export interface CopiedPicture {
  /** Holds the picture's canvas, and nothing else. */
  readonly holder: HTMLElement;
  /** It is drawn when it changes. */
  readonly drawable: boolean;
  /** Its canvas no longer shows it: draws it again once it is visible. */
  repaint(): void;
}

export class AtlasCopies {
  /** In the order of their last drawing, oldest first. */
  readonly #canvases = new Map<CopiedPicture, HTMLCanvasElement>();
  /** Shown since the last call of {@link trim}. */
  readonly #fresh = new Set<CopiedPicture>();

  /**
   * Shows one place of the atlas on `source`. Straight from the WebGL canvas: the browser resolves
   * it once for all copies that follow each other, and no intermediate canvas or bitmap was faster
   * (src/decisions/one-context.md).
   */
  show(viewport: CopiedPicture, source: HTMLCanvasElement, { x, y, width, height }: Region): void {
    const present = this.#canvases.get(viewport);
    const canvas = present ?? this.#newCanvas(viewport);
    this.#canvases.delete(viewport);
    this.#canvases.set(viewport, canvas);
    this.#fresh.add(viewport);
    const resized = canvas.width !== width || canvas.height !== height;
    if (resized) {
      canvas.width = width;
      canvas.height = height;
    }
    const blank = present === undefined || resized;
    const context = canvas.getContext('2d');
    if (context === null) return; // out of memory: the picture stays as it was
    // For print, Chromium 156 replays what was drawn since the last frame. There, `copy` erases all
    // that lies below: the CSS background.
    context.globalCompositeOperation = blank ? 'source-over' : 'copy';
    context.drawImage(source, x, source.height - y - height, width, height, 0, 0, width, height);
    if (viewport.holder.firstChild !== canvas) {
      viewport.holder.replaceChildren(canvas);
    }
  }

  /**
   * A crash of the GPU process clears 2D canvases too, and may give them back later than the WebGL
   * context.
   */
  #newCanvas(viewport: CopiedPicture): HTMLCanvasElement {
    const canvas = viewport.holder.ownerDocument.createElement('canvas');
    canvas.addEventListener('contextrestored', () => {
      if (this.#canvases.get(viewport) === canvas) {
        viewport.repaint();
      }
    });
    return canvas;
  }

  /** Releases one copy's pixels now. Garbage collection would release them late. */
  drop(viewport: CopiedPicture): void {
    const canvas = this.#canvases.get(viewport);
    if (canvas === undefined) return;
    this.#canvases.delete(viewport);
    this.#fresh.delete(viewport);
    canvas.remove();
    canvas.width = 0;
    canvas.height = 0;
  }

  /**
   * Call after a frame. Releases the copies of invisible pictures beyond the bound, oldest first.
   * Copies of this frame are kept: an invisible picture is drawn only to be printed.
   */
  trim(): void {
    if (this.#fresh.size === 0) return; // reading the screen's size is a call into the browser
    const isKept = (viewport: CopiedPicture) => viewport.drawable || this.#fresh.has(viewport);
    let surplus = -KEPT_SCREENS * screenPixels();
    for (const [viewport, { width, height }] of this.#canvases) {
      if (!isKept(viewport)) {
        surplus += width * height;
      }
    }
    for (const [viewport, { width, height }] of this.#canvases) {
      if (surplus <= 0) break;
      if (isKept(viewport)) continue;
      surplus -= width * height;
      this.drop(viewport);
      viewport.repaint();
    }
    this.#fresh.clear();
  }
}
