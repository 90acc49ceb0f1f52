// The page's one WebGL context and where its pixels go. A picture alone on the page shows the WebGL canvas itself;
// several share it, each copying its part into a canvas of its own. Knows nothing of scenes, lights or elements.
import { WebGLRenderer } from 'three';

/** A picture that draws with the shared context. Sizes are in device pixels. */
export interface StageClient {
  /** The element that holds the picture's canvas, and nothing else. */
  readonly holder: HTMLElement;
  readonly width: number;
  readonly height: number;
  /** What was drawn is gone or belongs into another canvas: draw again. */
  invalidate(): void;
  /** Draw again now, before the browser shows the page. */
  redraw(): void;
  /** Let go of everything that the GPU held. */
  contextLost(): void;
  /** The context is back; everything has to be sent again. */
  contextRestored(): void;
}

/** The browser gave no WebGL 2 context. */
export class NoWebGL2Error extends Error {
  override readonly name = 'NoWebGL2Error';
}

const CONTEXT: WebGLContextAttributes = {
  alpha: true,
  antialias: true,
  depth: true,
  stencil: false,
  premultipliedAlpha: true,
};

class Stage {
  readonly #clients = new Set<StageClient>();
  readonly #copies = new WeakMap<StageClient, HTMLCanvasElement>();
  #renderer: WebGLRenderer | null = null;
  #maxSize = Infinity;

  /** Throws {@link NoWebGL2Error}. */
  add(client: StageClient): void {
    this.#renderer ??= this.#createRenderer();
    if (this.#clients.has(client)) return;
    this.#clients.add(client);
    // The one that was alone shows the shared canvas, which others are about to draw on.
    if (this.#clients.size === 2) this.#invalidateAll();
  }

  remove(client: StageClient): void {
    if (!this.#clients.delete(client)) return;
    client.holder.replaceChildren();
    this.#copies.delete(client);
    if (this.#clients.size === 1) this.#invalidateAll();
    // An element that only moves is back before the microtask.
    if (this.#clients.size === 0) queueMicrotask(this.#closeIfEmpty);
  }

  get lost(): boolean {
    return this.#renderer?.getContext().isContextLost() ?? false;
  }

  /** Facts for `stats`. */
  get programs(): number {
    return this.#renderer?.info.programs?.length ?? 0;
  }

  /** The largest side of one drawing, in pixels; without limit while nothing draws. */
  get maxSize(): number {
    return this.#maxSize;
  }

  /** Draws one client's picture by `render` and shows it. */
  draw(client: StageClient, render: (renderer: WebGLRenderer) => void): void {
    const renderer = this.#need();
    const { width, height } = client;
    if (this.#clients.size === 1) {
      this.#resize(renderer, width, height);
      this.#renderRegion(renderer, width, height, render);
      show(client, renderer.domElement);
      this.#copies.delete(client);
      return;
    }
    const canvas = renderer.domElement;
    this.#resize(renderer, Math.max(canvas.width, width), Math.max(canvas.height, height));
    this.#renderRegion(renderer, width, height, render);
    this.#copy(client, canvas);
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
    const renderer = (this.#renderer ??= this.#createRenderer());
    const canvas = renderer.domElement;
    const before = { width: canvas.width, height: canvas.height };
    const step = Math.min(this.maxSize, LARGEST_PART);
    for (let y = 0; y < height; y += step) {
      for (let x = 0; x < width; x += step) {
        const part = { x, y, width: Math.min(step, width - x), height: Math.min(step, height - y) };
        this.#resize(renderer, Math.max(canvas.width, part.width), Math.max(canvas.height, part.height));
        this.#renderRegion(renderer, part.width, part.height, (r) => {
          render(r, part);
        });
        const top = canvas.height - part.height;
        context.drawImage(canvas, 0, top, part.width, part.height, x, y, part.width, part.height);
      }
    }
    // The drawing went over what the one picture of the page was showing.
    if (this.#clients.size === 1) for (const client of this.#clients) client.redraw();
    else this.#resize(renderer, before.width, before.height); // a large one would stay large
    if (borrowed) queueMicrotask(this.#closeIfEmpty);
    return picture;
  }

  #invalidateAll(): void {
    for (const client of this.#clients) client.invalidate();
  }

  #need(): WebGLRenderer {
    if (this.#renderer === null) throw new NoWebGL2Error('no picture of this page draws');
    return this.#renderer;
  }

  #resize(renderer: WebGLRenderer, width: number, height: number): void {
    const canvas = renderer.domElement;
    if (canvas.width !== width || canvas.height !== height) renderer.setSize(width, height, false);
  }

  #renderRegion(
    renderer: WebGLRenderer,
    width: number,
    height: number,
    render: (renderer: WebGLRenderer) => void,
  ): void {
    const whole = renderer.domElement.width === width && renderer.domElement.height === height;
    renderer.setViewport(0, 0, width, height);
    renderer.setScissor(0, 0, width, height);
    renderer.setScissorTest(!whole);
    render(renderer);
  }

  #copy(client: StageClient, canvas: HTMLCanvasElement): void {
    const { width, height } = client;
    const copy = this.#copies.get(client) ?? document.createElement('canvas');
    this.#copies.set(client, copy);
    if (copy.width !== width || copy.height !== height) {
      copy.width = width;
      copy.height = height;
    }
    const context = copy.getContext('2d');
    if (context === null) return; // no memory for it: the picture stays as it was
    context.globalCompositeOperation = 'copy';
    context.drawImage(canvas, 0, canvas.height - height, width, height, 0, 0, width, height);
    show(client, copy);
  }

  #createRenderer(): WebGLRenderer {
    const canvas = document.createElement('canvas');
    const context = canvas.getContext('webgl2', CONTEXT);
    if (context === null) throw new NoWebGL2Error('this browser gives no WebGL 2 context');
    canvas.addEventListener('webglcontextlost', this.#lost);
    canvas.addEventListener('webglcontextrestored', this.#restored);
    this.#maxSize = maxSizeOf(context);
    return rendererOf(canvas, context);
  }

  // three.js would write both to the console. It need not know: a restored context gets a new renderer.
  readonly #lost = (event: Event): void => {
    event.stopImmediatePropagation();
    event.preventDefault(); // else it is never restored
    for (const client of this.#clients) client.contextLost();
    // While the context is lost: what is deleted after it has come back is not its own, and that is an error.
    this.#renderer?.dispose();
  };

  readonly #restored = (event: Event): void => {
    event.stopImmediatePropagation();
    const old = this.#need();
    this.#renderer = rendererOf(old.domElement, old.getContext() as WebGL2RenderingContext);
    for (const client of this.#clients) client.contextRestored();
  };

  readonly #closeIfEmpty = (): void => {
    const renderer = this.#renderer;
    if (renderer === null || this.#clients.size > 0) return;
    this.#renderer = null;
    renderer.domElement.removeEventListener('webglcontextlost', this.#lost);
    renderer.domElement.removeEventListener('webglcontextrestored', this.#restored);
    renderer.dispose();
    // Browsers keep few contexts: give it back now rather than at some garbage collection.
    renderer.getContext().getExtension('WEBGL_lose_context')?.loseContext();
  };
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

function rendererOf(canvas: HTMLCanvasElement, context: WebGL2RenderingContext): WebGLRenderer {
  const renderer = new WebGLRenderer({ canvas, context, antialias: true, alpha: true });
  renderer.setPixelRatio(1); // sizes here are device pixels already
  renderer.setClearColor(0x000000, 0);
  return renderer;
}

function maxSizeOf(gl: WebGL2RenderingContext): number {
  const viewport = gl.getParameter(gl.MAX_VIEWPORT_DIMS) as Int32Array;
  return Math.min(viewport[0] ?? 0, viewport[1] ?? 0, gl.getParameter(gl.MAX_RENDERBUFFER_SIZE) as number);
}

function show(client: StageClient, canvas: HTMLCanvasElement): void {
  if (client.holder.firstChild !== canvas) client.holder.replaceChildren(canvas);
}

/** The page's stage. */
export const stage = new Stage();
