// The life of the page's one WebGL context: opened with the first drawing, lost and restored, refused and tried again,
// closed with the last picture. Sizes its canvas.
import type { WebGLRenderer } from 'three';
import { deviceOf } from '../../material/device.js';
import type { AtlasLimit, Size } from './atlas.js';
import {
  canBeCopied,
  closeContext,
  largestSideOf,
  type NoWebGL2Error,
  openContext,
  rendererOf,
  SAFE_SIDE,
} from './context.js';
import { checkLinks } from './link-check.js';

interface ContextEvents {
  /** The GPU has lost everything. */
  lost(): void;
  /** Drawing is possible after {@link lost} or {@link missing}. Everything has to be uploaded. */
  restored(): void;
  /** The browser gives no context. */
  missing(error: NoWebGL2Error): void;
  /** The next drawing tries to open a context again. */
  retrying(): void;
}

/**
 * closed → open ⇄ lost. An opening that fails ends in `refused`; `retrying` opens with the next drawing, like `closed`.
 * A refused context is tried again when a viewer connects and when the document becomes visible. A browser refuses when
 * it is out of memory or restarts its GPU process, and no event says that this is over.
 */
type State = 'closed' | 'open' | 'lost' | 'refused' | 'retrying';

const NO_LIMIT: AtlasLimit = { side: Infinity, area: Infinity };

export class SharedContext {
  readonly #events: ContextEvents;
  #state: State = 'closed';
  /** Null unless open or lost. */
  #gl: WebGL2RenderingContext | null = null;
  #renderer: WebGLRenderer | null = null;
  #limit = NO_LIMIT;

  constructor(events: ContextEvents) {
    this.#events = events;
  }

  /** Null unless open. */
  get renderer(): WebGLRenderer | null {
    return this.#renderer;
  }

  /** There is no context, and drawing would not open one. By events: WebGL is not called. */
  get unavailable(): boolean {
    return this.#state === 'lost' || this.#state === 'refused';
  }

  /**
   * Limits of one drawing. The area shrinks to what the browser really gives. Infinite before the first context is
   * open.
   */
  get limit(): AtlasLimit {
    return this.#limit;
  }

  /** The renderer; null while the context is lost. `size` is that of the first drawing. Throws NoWebGL2Error. */
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
    if (wasRefused && !this.unavailable) this.#events.restored();
    return this.#renderer;
  }

  /** {@link open} has failed: reports that and waits for an occasion to try again. */
  refuse(error: NoWebGL2Error): void {
    this.#state = 'refused';
    document.addEventListener('visibilitychange', this.#onVisible);
    this.#events.missing(error);
  }

  /** Lets the next drawing try to open a refused context again. */
  retry(): void {
    if (this.#state !== 'refused') return;
    this.#state = 'retrying';
    this.#events.retrying();
  }

  /** Whether the context is lost. WebGL knows before the event arrives; the call does not wait for the GPU. */
  noticeLoss(): boolean {
    if (this.#state === 'open' && this.#gl?.isContextLost() === true) this.#lose();
    return this.#state === 'lost';
  }

  /** Reports programs that do not link. Call after drawing. */
  checkLinks(): void {
    if (this.#renderer !== null) checkLinks(this.#renderer);
  }

  /**
   * Gives the canvas of an open context exactly this size. False: the browser has no memory for that and gave a smaller
   * drawing buffer. {@link limit} is lower from then on, and the canvas has one pixel.
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
    if (area > 0) this.#limit = { ...this.#limit, area: Math.min(this.#limit.area, area) };
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
  #start(gl: WebGL2RenderingContext): void {
    this.#state = 'open';
    document.removeEventListener('visibilitychange', this.#onVisible);
    try {
      this.#limit = { ...this.#limit, side: largestSideOf(gl) };
      this.#renderer = rendererOf(gl);
      deviceOf(this.#renderer); // in the first frame the answer would wait for the commands before it
    } catch (error) {
      if (!this.noticeLoss()) throw error;
    }
    this.noticeLoss();
  }

  #lose(): void {
    this.#state = 'lost';
    this.#events.lost();
    // Now, while the context is lost: deleting these objects on the restored context would be an error.
    this.#disposeRenderer();
  }

  #release(): void {
    this.#state = 'closed';
    const gl = this.#gl;
    if (gl === null) return;
    this.#gl = null;
    gl.canvas.removeEventListener('webglcontextlost', this.#onLost);
    gl.canvas.removeEventListener('webglcontextrestored', this.#onRestored);
    this.#disposeRenderer();
    closeContext(gl);
  }

  #disposeRenderer(): void {
    this.#renderer?.dispose();
    this.#renderer = null;
  }

  readonly #onVisible = (): void => {
    if (document.visibilityState === 'visible') this.retry();
  };

  // three.js must not see either event: it would write to the console, and a restored context gets a new renderer
  // anyway.
  readonly #onLost = (event: Event): void => {
    event.stopImmediatePropagation();
    event.preventDefault(); // otherwise the context is never restored
    if (this.#state === 'open') this.#lose();
  };

  readonly #onRestored = (event: Event): void => {
    event.stopImmediatePropagation();
    if (this.#gl === null) return;
    const { canvas } = this.#gl;
    // The size may be why the context was lost, and the same size would lose it again.
    if (canvas.width * canvas.height > SAFE_SIDE ** 2) this.#limit = { ...this.#limit, area: SAFE_SIDE ** 2 };
    canvas.width = canvas.height = 1; // its buffer may be smaller than the canvas
    // A context that has been lost again comes back by another event.
    if (canBeCopied(this.#gl) || this.#gl.isContextLost()) this.#start(this.#gl);
    else this.#release(); // the next drawing opens another
    if (!this.unavailable) this.#events.restored();
  };
}
