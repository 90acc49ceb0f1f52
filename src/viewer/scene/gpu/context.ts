// The page's one WebGL 2 context, its canvas and three.js's renderer: opened with the first
// drawing, closed at the end.
import { getConsoleFunction, type RenderItem, setConsoleFunction, WebGLRenderer } from 'three';
import { NoWebGL2Error } from '../../../phong/material/device.js';
import { checkLinks } from '../../../phong/material/program/three-programs.js';
import { SAFE_SIDE, type Size } from '../../../phong/math/region.js';
import type { AtlasLimit } from './atlas.js';

/**
 * The method that is called on every picture. `repaint`: the next drawing tries to open a refused
 * context again.
 */
type Consequence = 'contextLost' | 'contextRestored' | 'repaint';

/**
 * closed → open ⇄ lost. An opening that fails ends in `refused`: the browser is out of memory or
 * restarts its GPU process, and no event says that this is over. `retrying`, after a viewer
 * connects or the document becomes visible, opens with the next drawing, like `closed`.
 */
type State = 'closed' | 'open' | 'lost' | 'refused' | 'retrying';

const NO_LIMIT: AtlasLimit = { side: Infinity, area: Infinity };

export class SharedContext {
  readonly #changed: (consequence: Consequence) => void;
  #state: State = 'closed';
  /** Null unless open or lost. */
  #gl: WebGL2RenderingContext | null = null;
  #renderer: WebGLRenderer | null = null;
  #limit = NO_LIMIT;

  constructor(changed: (consequence: Consequence) => void) {
    this.#changed = changed;
  }

  get renderer(): WebGLRenderer | null {
    return this.#renderer;
  }

  /** There is no context, and drawing would not open one. By events: WebGL is not called. */
  get unavailable(): boolean {
    return this.#state === 'lost' || this.#state === 'refused';
  }

  /**
   * Limits of one drawing: infinite before the first context; the area shrinks to what the browser
   * gives.
   */
  get limit(): AtlasLimit {
    return this.#limit;
  }

  /**
   * The renderer; null while the context is lost. `size` is that of the first drawing. Throws
   * NoWebGL2Error.
   */
  open(size: Size): WebGLRenderer | null {
    if (this.#renderer !== null || this.#state === 'lost') return this.#renderer;
    if (this.#gl === null) {
      this.#gl = openContext(size);
      const { canvas } = this.#gl;
      canvas.addEventListener('webglcontextlost', this.#onLost);
      canvas.addEventListener('webglcontextrestored', this.#onRestored);
    }
    const wasRefused = this.#state === 'refused' || this.#state === 'retrying';
    this.#start(this.#gl);
    if (wasRefused && !this.unavailable) {
      this.#changed('contextRestored');
    }
    return this.#renderer;
  }

  /** {@link open} has failed: waits for an occasion to try again. */
  refuse(): void {
    this.#state = 'refused';
    document.addEventListener('visibilitychange', this.#onVisible);
  }

  /** Lets the next drawing try to open a refused context again. */
  retry(): void {
    if (this.#state !== 'refused') return;
    this.#state = 'retrying';
    this.#changed('repaint');
  }

  /**
   * Whether the context is lost. WebGL knows before the event arrives; the call does not wait for
   * the GPU.
   */
  noticeLoss(): boolean {
    if (this.#state === 'open' && this.#gl?.isContextLost() === true) {
      this.#lose();
    }
    return this.#state === 'lost';
  }

  checkLinks(): void {
    if (this.#renderer !== null) {
      checkLinks(this.#renderer);
    }
  }

  /**
   * Gives the canvas of an open context exactly this size. False: the browser has no memory for
   * that and gave a smaller drawing buffer. {@link limit} is lower from then on, and the canvas has
   * one pixel.
   */
  resize({ width, height }: Size): boolean {
    const renderer = this.#renderer;
    if (renderer === null) return false;
    const canvas = renderer.domElement;
    if (canvas.width === width && canvas.height === height) return true;
    renderer.setSize(width, height, false);
    const { drawingBufferWidth, drawingBufferHeight } = renderer.getContext();
    if (drawingBufferWidth >= width && drawingBufferHeight >= height) return true;
    const area = drawingBufferWidth * drawingBufferHeight; // 0 if the context has been lost
    if (area > 0) {
      this.#limit = { ...this.#limit, area: Math.min(this.#limit.area, area) };
    }
    renderer.setSize(1, 1, false); // the canvas never differs from its drawing buffer
    return false;
  }

  /** Releases everything. {@link open} can follow. */
  close(): void {
    document.removeEventListener('visibilitychange', this.#onVisible);
    this.#limit = NO_LIMIT;
    this.#release();
  }

  /** Makes a renderer, unless the context is lost already. */
  #start(gl: WebGL2RenderingContext) {
    this.#state = 'open';
    document.removeEventListener('visibilitychange', this.#onVisible);
    try {
      this.#limit = { ...this.#limit, side: largestSideOf(gl) };
      this.#renderer = rendererOf(gl);
    } catch (error) {
      if (!this.noticeLoss()) throw error;
    }
    this.noticeLoss();
  }

  #lose() {
    this.#state = 'lost';
    this.#changed('contextLost');
    // Now, while the context is lost: deleting these objects on the restored context would be an
    // error.
    this.#disposeRenderer();
  }

  #release() {
    this.#state = 'closed';
    const gl = this.#gl;
    if (gl === null) return;
    this.#gl = null;
    gl.canvas.removeEventListener('webglcontextlost', this.#onLost);
    gl.canvas.removeEventListener('webglcontextrestored', this.#onRestored);
    this.#disposeRenderer();
    closeContext(gl);
  }

  #disposeRenderer() {
    this.#renderer?.dispose();
    this.#renderer = null;
  }

  readonly #onVisible = () => {
    if (document.visibilityState === 'visible') {
      this.retry();
    }
  };

  // three.js must see neither event: it would write to the console, and a restored context gets a
  // new renderer.
  readonly #onLost = (event: Event) => {
    event.stopImmediatePropagation();
    event.preventDefault(); // otherwise the context is never restored
    if (this.#state === 'open') {
      this.#lose();
    }
  };

  readonly #onRestored = (event: Event) => {
    event.stopImmediatePropagation();
    if (this.#gl === null) return;
    const { canvas } = this.#gl;
    // The size may be why the context was lost, and the same size would lose it again.
    if (canvas.width * canvas.height > SAFE_SIDE ** 2) {
      this.#limit = { ...this.#limit, area: SAFE_SIDE ** 2 };
    }
    canvas.width = canvas.height = 1; // its buffer may be smaller than the canvas
    // A context that has been lost again comes back by another event.
    if (canBeCopied(this.#gl) || this.#gl.isContextLost()) {
      this.#start(this.#gl);
    } else {
      this.#release(); // the next drawing opens another
    }
    if (!this.unavailable) {
      this.#changed('contextRestored');
    }
  };
}

/**
 * Opens the context at the size of the first drawing: opening small and growing takes 6 ms longer
 * at 600 × 400 and at 1920 × 1080 (medians of 24, software). A drawing beyond {@link SAFE_SIDE}
 * starts with one pixel: Chromium 156 with software GL gives no context for 8192 × 8192, nor any
 * other to this page afterwards; one that grows gets a smaller buffer at worst.
 */
function openContext({ width, height }: Size): WebGL2RenderingContext {
  const canvas = document.createElement('canvas');
  const isSafe = Math.max(width, height) <= SAFE_SIDE;
  canvas.width = isSafe ? width : 1;
  canvas.height = isSafe ? height : 1;
  let cause: unknown;
  try {
    const context = canvas.getContext('webgl2'); // by default with alpha, premultiplied, depth and multisampling
    if (context !== null) return context;
  } catch (error) {
    cause = error; // some privacy tools replace getContext by a function that throws
  }
  throw new NoWebGL2Error('this browser gives no WebGL 2 context', { cause });
}

/** Throws if the context is lost, or gets lost meanwhile. */
function rendererOf(context: WebGL2RenderingContext): WebGLRenderer {
  const canvas = context.canvas as HTMLCanvasElement;
  // three.js logs what it cannot read, and a lost context answers null. The stage reports the loss.
  const log = getConsoleFunction() as ConsoleFunction | null; // null if none was set, whatever the types say
  setConsoleFunction((type, ...parts) => {
    if (context.isContextLost()) return;
    if (log === null) {
      console.warn(...parts);
    } else {
      log(type, ...parts);
    }
  });
  let renderer: WebGLRenderer;
  try {
    // The canvas gives three.js the same context again. Given it, three.js would touch
    // WebGLRenderingContext, whose interface the browser builds at the first touch (35 kB of heap).
    renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true });
  } finally {
    setConsoleFunction(log as ConsoleFunction);
  }
  renderer.debug.checkShaderErrors = false; // see checkLinks
  renderer.autoClear = false; // the stage clears once for all pictures of a frame
  renderer.setOpaqueSort(byScene);
  renderer.setTransparentSort(fromBehind);
  return renderer;
}

type ConsoleFunction = ReturnType<typeof getConsoleFunction>;

/**
 * Keeps the scene's order (sorting is stable): where surfaces coincide, the last one in the markup
 * shows. three.js would sort by material, in the order in which materials were created.
 */
const byScene = (a: RenderItem, b: RenderItem) =>
  a.groupOrder - b.groupOrder || a.renderOrder - b.renderOrder;

/**
 * Farther objects first. At equal depth this keeps the scene's order; three.js would sort by
 * creation.
 */
const fromBehind = (a: RenderItem, b: RenderItem) => byScene(a, b) || b.z - a.z;

/**
 * Longest side of a drawing, in pixels, by what the GPU says. Whether there is memory shows when
 * the canvas has that size.
 */
function largestSideOf(gl: WebGL2RenderingContext): number {
  // A lost context answers null.
  const viewport = (gl.getParameter(gl.MAX_VIEWPORT_DIMS) as Int32Array | null) ?? [];
  const sides = [
    ...viewport,
    gl.getParameter(gl.MAX_RENDERBUFFER_SIZE),
    gl.getParameter(gl.MAX_TEXTURE_SIZE),
  ];
  return Math.min(...sides.map(Number));
}

/**
 * Whether 2D canvases get the pixels of a restored context. In Chromium 156 they get none after a
 * crash of the GPU process, however often the context draws: only a new canvas helps. Overwrites
 * one drawing.
 */
function canBeCopied(gl: WebGL2RenderingContext): boolean {
  gl.clearColor(1, 1, 1, 1);
  gl.clear(gl.COLOR_BUFFER_BIT);
  const copy = document.createElement('canvas').getContext('2d', { willReadFrequently: true });
  copy?.drawImage(gl.canvas, 0, 0);
  return copy?.getImageData(0, 0, 1, 1).data[3] === 255;
}

/**
 * Releases the context now, or as soon as it is restored. Browsers allow few, and garbage
 * collection would release it late.
 */
function closeContext(gl: WebGL2RenderingContext) {
  const close = (): void => gl.getExtension('WEBGL_lose_context')?.loseContext(); // null while the context is lost
  gl.canvas.addEventListener('webglcontextrestored', close, { once: true });
  close();
}
