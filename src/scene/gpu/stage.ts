// The page's one WebGL context and where its pixels go. A picture alone on the page shows the WebGL canvas itself. Several
// pictures are drawn next to each other into an atlas on that canvas, and each is then copied into a canvas of its own.
// Knows nothing of scenes, lights or elements. Reasons and figures: src/decisions/one-context.md.
import type { WebGLRenderer } from 'three';
import { AtlasCopies, type CopyClient, screenPixels } from './atlas-copies.js';
import { closeContext, maxSizeOf, openContext, rendererOf } from './context.js';
import { LinkCheck } from './link-check.js';
import { type AtlasLayout, layOutAtlas, type Place, type Size } from './atlas.js';

export { NoWebGL2Error } from './context.js';

/** A picture that draws with the shared context. Sizes are in device pixels. */
export interface StageClient extends CopyClient {
  /** Drawing now would change nothing. */
  readonly upToDate: boolean;
  /** Draw again now, before the browser shows the page. */
  redraw(): void;
  /** The GPU has lost everything: release it. */
  contextLost(): void;
  /** The context is back: everything has to be uploaded again. */
  contextRestored(): void;
}

/** Frames in a row that may leave three quarters of the canvas unused before it shrinks: half a second of motion. */
const FRAMES_BEFORE_SHRINKING = 30;

class Stage {
  readonly #clients = new Set<StageClient>();
  readonly #copies = new AtlasCopies();
  #renderer: WebGLRenderer | null = null;
  #linkCheck: LinkCheck | null = null;
  #maxSize = Infinity;
  /** Places reserved for pictures that have not been drawn yet in this frame. */
  readonly #places = new Map<StageClient, Place>();
  /** Pictures in the atlas that have not been copied yet. */
  readonly #drawn = new Map<StageClient, Place>();
  #contextLost = false;
  #wastefulFrames = 0;
  #inFrame = false;
  #viewersDrawn = 0;

  add(client: StageClient): void {
    if (this.#clients.has(client)) return;
    this.#clients.add(client);
    // The first picture shows the shared canvas itself, and the others are about to draw on it.
    if (this.#clients.size === 2) this.#invalidateAll();
  }

  remove(client: StageClient): void {
    if (!this.#clients.delete(client)) return;
    this.#showDrawn();
    this.#copies.drop(client);
    client.holder.replaceChildren();
    if (this.#clients.size === 1) this.#invalidateAll();
    // The canvas may have been large only for this picture. The next frame finds the size again.
    else if (this.#clients.size > 1 && this.#renderer !== null) resize(this.#renderer, 1, 1);
    // An element that only moves within the page is back before the microtask.
    if (this.#clients.size === 0) queueMicrotask(this.#closeIfEmpty);
  }

  /** According to events: `isContextLost()` is a call into WebGL, and every change of a scene reads this. */
  get lost(): boolean {
    return this.#contextLost;
  }

  /** Programs on the GPU, for `stats`. */
  get programs(): number {
    return this.#renderer?.info.programs?.length ?? 0;
  }

  /** Pictures drawn in the page's last frame, or so far in the present one. */
  get viewersDrawn(): number {
    return this.#viewersDrawn;
  }

  /** Scale, at most 1, that makes a picture fit the GPU's largest drawing. 1 until the context is open. */
  shareOf({ width, height }: Size): number {
    return Math.min(1, this.#maxSize / Math.max(width, height, 1));
  }

  /**
   * Draws one client's picture with `render`, which must not clear, and shows it before the browser shows the page. The
   * first call opens the context. Throws NoWebGL2Error.
   */
  draw(client: StageClient, render: (renderer: WebGLRenderer) => void): void {
    // The canvas stays in its own document: a picture in a popup is a copy too.
    const alone = this.#clients.size === 1 && client.holder.ownerDocument === document;
    const renderer = this.#renderer ?? this.#open(alone ? client : this.#layOut(client).atlas);
    this.#count();
    if (alone) {
      this.#showDrawn();
      const { width, height } = client;
      resize(renderer, width, height);
      clear(renderer);
      drawInto(renderer, { x: 0, y: 0, width, height }, render);
      this.#copies.drop(client);
      const { domElement } = renderer;
      if (client.holder.firstChild !== domElement) client.holder.replaceChildren(domElement);
    } else {
      const place = this.#placeOf(client, renderer);
      drawInto(renderer, place, render);
      this.#drawn.set(client, place);
    }
    this.#linkCheck?.check(renderer);
  }

  /**
   * Draws a picture that is not shown into a 2D canvas of exactly `width` × `height` pixels, in tiles where it is larger
   * than the context can hold. `render` draws the given part and must not clear. Throws RangeError where no canvas can
   * hold the picture.
   */
  capture(
    { width, height }: Size,
    render: (renderer: WebGLRenderer, part: Region) => void,
  ): HTMLCanvasElement {
    if (this.lost) throw new Error('the graphics context is lost: there is no picture until it comes back');
    const picture = document.createElement('canvas');
    picture.width = width;
    picture.height = height;
    const context = picture.getContext('2d');
    if (context === null || !hasMemory(context, width, height)) {
      throw new RangeError(`a picture of ${String(width)} × ${String(height)} is too large`);
    }
    const opened = this.#renderer === null;
    const firstTile = { width: Math.min(width, LARGEST_PART), height: Math.min(height, LARGEST_PART) };
    const renderer = this.#renderer ?? this.#open(firstTile);
    this.#showDrawn(); // the capture overwrites it
    const canvas = renderer.domElement;
    const before = { width: canvas.width, height: canvas.height };
    const step = Math.min(this.#maxSize, LARGEST_PART);
    for (let y = 0; y < height; y += step) {
      for (let x = 0; x < width; x += step) {
        const part = { x, y, width: Math.min(step, width - x), height: Math.min(step, height - y) };
        resize(renderer, Math.max(canvas.width, part.width), Math.max(canvas.height, part.height));
        clear(renderer);
        drawInto(renderer, { x: 0, y: 0, width: part.width, height: part.height }, (r) => {
          render(r, part);
        });
        const top = canvas.height - part.height;
        context.drawImage(canvas, 0, top, part.width, part.height, x, y, part.width, part.height);
      }
    }
    this.#linkCheck?.check(renderer);
    // The capture has overwritten the canvas that a lone picture shows.
    if (this.#clients.size === 1) for (const client of this.#clients) client.redraw();
    else resize(renderer, before.width, before.height); // else it would stay large
    if (opened) queueMicrotask(this.#closeIfEmpty);
    return picture;
  }

  #invalidateAll(): void {
    for (const client of this.#clients) client.invalidate();
  }

  /** Where `client` draws. The first picture of a frame starts an atlas and reserves places for all that are out of date. */
  #placeOf(client: StageClient, renderer: WebGLRenderer): Place {
    const reserved = this.#places.get(client);
    this.#places.delete(client); // a second drawing needs a cleared place
    if (reserved?.width === client.width && reserved.height === client.height) return reserved;
    this.#showDrawn();
    const { pictures, atlas } = this.#layOut(client);
    this.#makeRoom(renderer, atlas);
    // Once for all places: 20 clears of 256 × 180 cost as much as drawing a box in each (25 ms of CPU in software).
    clear(renderer);
    atlas.places.forEach((place, i) => {
      const picture = pictures[i];
      if (picture !== undefined && picture !== client) this.#places.set(picture, place);
    });
    return { x: 0, y: 0, width: client.width, height: client.height }; // the first place
  }

  /** The pictures that are out of date and their places, `client` first. */
  #layOut(client: StageClient): { pictures: readonly StageClient[]; atlas: AtlasLayout } {
    const pictures = [client];
    for (const one of this.#clients) if (one !== client && one.drawable && !one.upToDate) pictures.push(one);
    return { pictures, atlas: layOutAtlas(pictures, { side: this.#maxSize, area: screenPixels() }) };
  }

  /** Makes the canvas at least this large. A new size costs new buffers, so a canvas that is too large stays for a while. */
  #makeRoom(renderer: WebGLRenderer, { width, height }: Size): void {
    const canvas = renderer.domElement;
    const fits = width <= canvas.width && height <= canvas.height;
    const wasteful = fits && 4 * width * height < canvas.width * canvas.height;
    this.#wastefulFrames = wasteful ? this.#wastefulFrames + 1 : 0;
    if (fits && this.#wastefulFrames < FRAMES_BEFORE_SHRINKING) return;
    this.#wastefulFrames = 0;
    const both = { width: Math.max(width, canvas.width), height: Math.max(height, canvas.height) };
    if (!fits && both.width * both.height <= screenPixels()) resize(renderer, both.width, both.height);
    else resize(renderer, width, height);
  }

  /** Copies what has been drawn into the pictures' own canvases. */
  #showDrawn(): void {
    this.#places.clear();
    if (this.#drawn.size === 0) return;
    const source = this.#renderer?.domElement;
    if (source !== undefined)
      for (const [client, place] of this.#drawn) this.#copies.show(client, source, place);
    this.#drawn.clear();
  }

  #count(): void {
    if (!this.#inFrame) {
      this.#inFrame = true;
      this.#viewersDrawn = 0;
      void Promise.resolve().then(this.#endFrame); // still before the browser shows the page
    }
    this.#viewersDrawn += 1;
  }

  readonly #endFrame = (): void => {
    this.#inFrame = false;
    this.#showDrawn();
    this.#copies.trim();
  };

  /** `size` is that of the first drawing. */
  #open(size: Size): WebGLRenderer {
    const context = openContext(size);
    const canvas = context.canvas as HTMLCanvasElement;
    canvas.addEventListener('webglcontextlost', this.#lost);
    canvas.addEventListener('webglcontextrestored', this.#restored);
    this.#maxSize = maxSizeOf(context);
    return this.#use(rendererOf(context));
  }

  #use(renderer: WebGLRenderer): WebGLRenderer {
    this.#renderer = renderer;
    this.#linkCheck = new LinkCheck(renderer);
    return renderer;
  }

  // three.js must not see either event: it would write to the console, and a restored context gets a new renderer anyway.
  readonly #lost = (event: Event): void => {
    event.stopImmediatePropagation();
    event.preventDefault(); // otherwise the context is never restored
    this.#contextLost = true;
    this.#drawn.clear();
    this.#places.clear();
    for (const client of this.#clients) client.contextLost();
    // Now, while the context is lost: deleting these objects on the restored context would be an error.
    this.#renderer?.dispose();
  };

  readonly #restored = (event: Event): void => {
    event.stopImmediatePropagation();
    if (this.#renderer === null) return;
    this.#contextLost = false;
    this.#use(rendererOf(this.#renderer.getContext() as WebGL2RenderingContext));
    for (const client of this.#clients) client.contextRestored();
  };

  readonly #closeIfEmpty = (): void => {
    const renderer = this.#renderer;
    if (renderer === null || this.#clients.size > 0) return;
    this.#renderer = null;
    this.#linkCheck = null;
    this.#contextLost = false;
    renderer.domElement.removeEventListener('webglcontextlost', this.#lost);
    renderer.domElement.removeEventListener('webglcontextrestored', this.#restored);
    closeContext(renderer);
  };
}

function resize(renderer: WebGLRenderer, width: number, height: number): void {
  const canvas = renderer.domElement;
  if (canvas.width !== width || canvas.height !== height) renderer.setSize(width, height, false);
}

/**
 * Clears the whole canvas to transparent. Unscissored, which the GPU does without drawing. A scene with a background colour
 * leaves three.js's clear colour changed.
 */
function clear(renderer: WebGLRenderer): void {
  renderer.setScissorTest(false);
  renderer.setClearColor(0x000000, 0);
  renderer.clear(true, true, false);
}

/** Draws one part of the canvas and leaves the others alone. */
function drawInto(
  renderer: WebGLRenderer,
  { x, y, width, height }: Place,
  render: (renderer: WebGLRenderer) => void,
): void {
  const whole = renderer.domElement.width === width && renderer.domElement.height === height;
  renderer.setViewport(x, y, width, height);
  renderer.setScissor(x, y, width, height);
  renderer.setScissorTest(!whole);
  render(renderer);
}

/** A part of a picture: pixels from its top left corner. */
export interface Region {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
}

/** Largest side of one tile in pixels. Every GPU has memory for this size with 4 samples per pixel. */
const LARGEST_PART = 4096;

/** Whether a canvas really has its pixels: browsers return canvases without memory, and only a drawn pixel shows it. */
function hasMemory(context: CanvasRenderingContext2D, width: number, height: number): boolean {
  if (context.canvas.width !== width || context.canvas.height !== height) return false;
  const corner = [width - 1, height - 1, 1, 1] as const;
  try {
    context.fillRect(...corner);
    const drawn = context.getImageData(...corner).data[3] === 255;
    context.clearRect(...corner);
    return drawn;
  } catch {
    return false;
  }
}

/** The page's stage. */
export const stage = new Stage();
