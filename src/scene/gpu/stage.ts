// The page's one WebGL context and where its pixels go. A picture alone on the page shows the WebGL canvas itself; where
// there are several, those of one frame are drawn beside each other and each is copied into a canvas of its own. Knows
// nothing of scenes, lights or elements.
import type { WebGLRenderer } from 'three';
import { AtlasCopies, type CopyClient, screenPixels } from './atlas-copies.js';
import { closeContext, maxSizeOf, openContext, rendererOf } from './context.js';
import { LinkCheck } from './link-check.js';
import { layOutAtlas, type Place, type AtlasLayout, type Size } from './atlas.js';

export { NoWebGL2Error } from './context.js';

/** A picture that draws with the shared context. Sizes are in device pixels. */
export interface StageClient extends CopyClient {
  /** It shows what it would draw now. */
  readonly upToDate: boolean;
  /** Draw again now, before the browser shows the page. */
  redraw(): void;
  /** Let go of everything that the GPU held. */
  contextLost(): void;
  /** The context is back; everything has to be sent again. */
  contextRestored(): void;
}

/** How many frames in a row may leave three quarters of the canvas unused before it shrinks: half a second of motion. */
const SPARING_FRAMES = 30;

class Stage {
  readonly #clients = new Set<StageClient>();
  readonly #copies = new AtlasCopies();
  #renderer: WebGLRenderer | null = null;
  #linkCheck: LinkCheck | null = null;
  #maxSize = Infinity;
  /** Where the pictures that are still to come in this frame will be. */
  readonly #places = new Map<StageClient, Place>();
  /** What lies on the canvas and is not shown yet. */
  readonly #drawn = new Map<StageClient, Place>();
  #lostContext = false;
  #sparing = 0;
  #inFrame = false;
  #viewersDrawn = 0;

  add(client: StageClient): void {
    if (this.#clients.has(client)) return;
    this.#clients.add(client);
    // The one that was alone shows the shared canvas, which others are about to draw on.
    if (this.#clients.size === 2) this.#invalidateAll();
  }

  remove(client: StageClient): void {
    if (!this.#clients.delete(client)) return;
    this.#showDrawn();
    this.#copies.drop(client);
    client.holder.replaceChildren();
    if (this.#clients.size === 1) this.#invalidateAll();
    // It may have been the one that the canvas is so large for; the next frame finds the size anew.
    else if (this.#clients.size > 1 && this.#renderer !== null) resize(this.#renderer, 1, 1);
    // An element that only moves is back before the microtask.
    if (this.#clients.size === 0) queueMicrotask(this.#closeIfEmpty);
  }

  /** By what the events have told: asking the context is a call to it, and this is asked with every change. */
  get lost(): boolean {
    return this.#lostContext;
  }

  /** Facts for `stats`. */
  get programs(): number {
    return this.#renderer?.info.programs?.length ?? 0;
  }

  /** How many pictures the page's last frame has drawn, or the present one so far. */
  get viewersDrawn(): number {
    return this.#viewersDrawn;
  }

  /** What a picture's sides are multiplied by, that one drawing can hold it: 1 until something has been drawn. */
  shareOf({ width, height }: Size): number {
    return Math.min(1, this.#maxSize / Math.max(width, height, 1));
  }

  /** Draws one client's picture by `render` and shows it by the end of the task. The first opens the context: throws NoWebGL2Error. */
  draw(client: StageClient, render: (renderer: WebGLRenderer) => void): void {
    const alone = this.#clients.size === 1;
    const renderer = this.#renderer ?? this.#open(alone ? client : this.#layOutAtlas(client).sheet);
    this.#count();
    if (alone) {
      this.#showDrawn();
      const { width, height } = client;
      resize(renderer, width, height);
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
   * Draws a picture that is not shown, piece by piece where it is larger than the context can hold, into a canvas of
   * exactly `width` × `height` pixels. `render` is told which part it draws.
   */
  capture(
    size: { readonly width: number; readonly height: number },
    render: (renderer: WebGLRenderer, part: Region) => void,
  ): HTMLCanvasElement {
    if (this.lost) throw new Error('the graphics context is lost: there is no picture until it comes back');
    const { width, height } = size;
    const picture = document.createElement('canvas');
    picture.width = width;
    picture.height = height;
    const context = picture.getContext('2d');
    if (context === null || !holds(context, width, height)) {
      throw new RangeError(`a picture of ${String(width)} × ${String(height)} is too large`);
    }
    const borrowed = this.#renderer === null;
    const most = { width: Math.min(width, LARGEST_PART), height: Math.min(height, LARGEST_PART) };
    const renderer = this.#renderer ?? this.#open(most);
    this.#showDrawn(); // what follows goes over it
    const canvas = renderer.domElement;
    const before = { width: canvas.width, height: canvas.height };
    const step = Math.min(this.#maxSize, LARGEST_PART);
    for (let y = 0; y < height; y += step) {
      for (let x = 0; x < width; x += step) {
        const part = { x, y, width: Math.min(step, width - x), height: Math.min(step, height - y) };
        resize(renderer, Math.max(canvas.width, part.width), Math.max(canvas.height, part.height));
        drawInto(renderer, { x: 0, y: 0, width: part.width, height: part.height }, (r) => {
          render(r, part);
        });
        const top = canvas.height - part.height;
        context.drawImage(canvas, 0, top, part.width, part.height, x, y, part.width, part.height);
      }
    }
    this.#linkCheck?.check(renderer);
    // The drawing went over what the one picture of the page was showing.
    if (this.#clients.size === 1) for (const client of this.#clients) client.redraw();
    else resize(renderer, before.width, before.height); // a large one would stay large
    if (borrowed) queueMicrotask(this.#closeIfEmpty);
    return picture;
  }

  #invalidateAll(): void {
    for (const client of this.#clients) client.invalidate();
  }

  /** Where on the canvas `client` draws; with the first of a frame all that wait for it get their places. */
  #placeOf(client: StageClient, renderer: WebGLRenderer): Place {
    const kept = this.#places.get(client);
    this.#places.delete(client); // one drawing each
    if (kept?.width === client.width && kept.height === client.height) return kept;
    this.#showDrawn();
    const { waiting, sheet } = this.#layOutAtlas(client);
    this.#makeRoom(renderer, sheet);
    sheet.places.forEach((place, i) => {
      const one = waiting[i];
      if (one !== undefined && one !== client) this.#places.set(one, place);
    });
    return { x: 0, y: 0, width: client.width, height: client.height }; // the first place of all
  }

  /** All that wait for this frame beside each other, `client` first. */
  #layOutAtlas(client: StageClient): { waiting: readonly StageClient[]; sheet: AtlasLayout } {
    const waiting = [client];
    for (const one of this.#clients) if (one !== client && one.drawable && !one.upToDate) waiting.push(one);
    return { waiting, sheet: layOutAtlas(waiting, { side: this.#maxSize, area: screenPixels() }) };
  }

  /** At least this many pixels; another size costs new buffers, so what fits stays for a while. */
  #makeRoom(renderer: WebGLRenderer, { width, height }: Size): void {
    const canvas = renderer.domElement;
    const fits = width <= canvas.width && height <= canvas.height;
    const sparing = fits && 4 * width * height < canvas.width * canvas.height;
    this.#sparing = sparing ? this.#sparing + 1 : 0;
    if (fits && this.#sparing < SPARING_FRAMES) return;
    this.#sparing = 0;
    const both = { width: Math.max(width, canvas.width), height: Math.max(height, canvas.height) };
    if (!fits && both.width * both.height <= screenPixels()) resize(renderer, both.width, both.height);
    else resize(renderer, width, height);
  }

  /** AtlasCopies what has been drawn to where it is seen. */
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

  /** `size` is what is about to be drawn. */
  #open(size: Size): WebGLRenderer {
    const context = openContext(size);
    const canvas = context.canvas as HTMLCanvasElement;
    canvas.addEventListener('webglcontextlost', this.#lost);
    canvas.addEventListener('webglcontextrestored', this.#restored);
    this.#maxSize = maxSizeOf(context);
    return this.#draws(rendererOf(context));
  }

  #draws(renderer: WebGLRenderer): WebGLRenderer {
    this.#renderer = renderer;
    this.#linkCheck = new LinkCheck(renderer);
    return renderer;
  }

  // three.js would write both to the console. It need not know: a restored context gets a new renderer.
  readonly #lost = (event: Event): void => {
    event.stopImmediatePropagation();
    event.preventDefault(); // else it is never restored
    this.#lostContext = true;
    this.#drawn.clear();
    this.#places.clear();
    for (const client of this.#clients) client.contextLost();
    // While the context is lost: what is deleted after it has come back is not its own, and that is an error.
    this.#renderer?.dispose();
  };

  readonly #restored = (event: Event): void => {
    event.stopImmediatePropagation();
    if (this.#renderer === null) return;
    this.#lostContext = false;
    this.#draws(rendererOf(this.#renderer.getContext() as WebGL2RenderingContext));
    for (const client of this.#clients) client.contextRestored();
  };

  readonly #closeIfEmpty = (): void => {
    const renderer = this.#renderer;
    if (renderer === null || this.#clients.size > 0) return;
    this.#renderer = null;
    this.#linkCheck = null;
    this.#lostContext = false;
    renderer.domElement.removeEventListener('webglcontextlost', this.#lost);
    renderer.domElement.removeEventListener('webglcontextrestored', this.#restored);
    closeContext(renderer);
  };
}

function resize(renderer: WebGLRenderer, width: number, height: number): void {
  const canvas = renderer.domElement;
  if (canvas.width !== width || canvas.height !== height) renderer.setSize(width, height, false);
}

/** Draws onto one part of the canvas and leaves the others alone. */
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

/** Larger pictures are drawn in parts: four times the memory of this many pixels squared is lent by every GPU. */
const LARGEST_PART = 4096;

/** Browsers hand out canvases that they have no memory for: only what was drawn on one tells. */
function holds(context: CanvasRenderingContext2D, width: number, height: number): boolean {
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
