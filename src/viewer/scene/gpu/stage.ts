// The page's one WebGL context and where its pixels go. A lone picture shows the WebGL canvas
// itself; several are drawn into an atlas on it, and each is copied into a canvas of its own
// (src/decisions/one-context.md).
import type { WebGLRenderer } from 'three';
import { AtlasCopies, type CopiedPicture, screenPixels } from './atlas-copies.js';
import { type Region, SAFE_SIDE, type Size, tilesOf } from '../../../phong/math/region.js';
import { type AtlasLayout, layOutAtlas } from './atlas.js';
import { NoWebGL2Error } from '../../../phong/material/device.js';
import { SharedContext } from './context.js';
import { pace } from './pace.js';

type Draw = (renderer: WebGLRenderer) => void;
type DrawPart = (renderer: WebGLRenderer, part: Region) => void;

/** A picture on the page; sizes are in device pixels. */
interface StagedPicture extends CopiedPicture, Size {
  /** Its canvas shows it as it is. */
  readonly upToDate: boolean;
  /** Draws it again now. */
  redraw(): void;
  /** What has been drawn is on the pictures' canvases. */
  shown(): void;
  contextLost(): void;
  contextRestored(): void;
  contextMissing(error: Error): void;
}

class Stage {
  readonly #viewports = new Set<StagedPicture>();
  readonly #copies = new AtlasCopies();
  readonly #context: SharedContext = new SharedContext((consequence) => {
    if (consequence === 'contextLost') {
      this.#drawn.clear();
      this.#places.clear();
      pace.forget();
    }
    for (const viewport of this.#viewports) {
      viewport[consequence]();
    }
  });
  /** Places reserved for pictures that have not been drawn yet in this frame. */
  readonly #places = new Map<StagedPicture, Region>();
  /** Pictures in the atlas that have not been copied yet. */
  readonly #drawn = new Map<StagedPicture, Region>();
  #wastefulFrames = 0;
  #inFrame = false;
  #viewersDrawn = 0;

  add(viewport: StagedPicture): void {
    if (this.#viewports.has(viewport)) return;
    this.#viewports.add(viewport);
    // The first picture shows the shared canvas itself, and the others are about to draw on it.
    if (this.#viewports.size === 2) {
      this.#repaintAll();
    }
    this.#context.retry();
  }

  retry(): void {
    this.#context.retry();
  }

  remove(viewport: StagedPicture): void {
    if (!this.#viewports.delete(viewport)) return;
    this.#showDrawn();
    this.#copies.drop(viewport);
    viewport.holder.replaceChildren();
    if (this.#viewports.size === 1) {
      this.#repaintAll();
    }
    // The canvas may have been large only for this picture. The next frame finds the size again.
    else if (this.#viewports.size > 1) {
      this.#context.resize({ width: 1, height: 1 });
    }
    // An element that only moves within the page is back before the microtask.
    queueMicrotask(this.#closeIfEmpty);
  }

  get lost(): boolean {
    return this.#context.unavailable;
  }

  get programs(): number {
    return this.#context.renderer?.info.programs?.length ?? 0;
  }

  /** Pictures drawn in the page's last frame, or so far in the present one. */
  get viewersDrawn(): number {
    return this.#viewersDrawn;
  }

  /**
   * Scale, at most 1, that makes a picture fit the GPU's largest drawing. 1 until the context is
   * open.
   */
  shareOf({ width, height }: Size): number {
    const { side, area } = this.#context.limit;
    return Math.min(
      1,
      side / Math.max(width, height, 1),
      Math.sqrt(area / Math.max(width * height, 1)),
    );
  }

  /**
   * Draws one viewport's picture with `render`, which must not clear, and shows it before the
   * browser shows the page; without `render`, opens the context only. False: there is none. All
   * viewports are notified then, and once there is.
   */
  draw(viewport: StagedPicture, render?: Draw): boolean {
    try {
      // The canvas stays in its own document: a picture in a popup is a copy too.
      const alone = this.#viewports.size === 1 && viewport.holder.ownerDocument === document;
      const renderer = this.#context.open(alone ? viewport : this.#layOut(viewport).atlas);
      if (renderer === null) return false;
      if (render === undefined) return true;
      if (alone) {
        this.#drawAlone(viewport, renderer, render);
      } else {
        const place = this.#placeOf(viewport, renderer);
        drawInto(renderer, place, render);
        this.#drawn.set(viewport, place);
      }
      if (!this.#inFrame) {
        this.#inFrame = true;
        this.#viewersDrawn = 0;
        // Before the browser shows the page, and after the pace has asked the GPU: without GPU
        // compositing a copy waits until all is drawn.
        void Promise.resolve().then(this.#endFrame);
      }
      this.#viewersDrawn += 1;
      this.#context.checkLinks();
      return true;
    } catch (error) {
      if (error instanceof NoWebGL2Error) {
        this.#context.refuse();
        for (const one of this.#viewports) {
          one.contextMissing(error);
        }
      } else if (!this.#context.noticeLoss()) throw error; // a lost context answers null: three.js throws
      return false;
    }
  }

  /** Sends what has been drawn and uploaded so far to the GPU. */
  flush(): void {
    this.#context.renderer?.getContext().flush();
  }

  /**
   * Whether the GPU has refused memory since the last question: buffers and textures are then
   * incomplete. Waits for the GPU.
   */
  outOfMemory(): boolean {
    const gl = this.#context.renderer?.getContext();
    let refused = false;
    // A context keeps each of its six kinds of errors once.
    for (let kind = 0; kind < 6 && gl !== undefined; kind++) {
      const error = gl.getError();
      if (error === gl.NO_ERROR) break;
      refused ||= error === gl.OUT_OF_MEMORY;
    }
    return refused;
  }

  /**
   * The renderer of the open context, which `size` opens where there is none. Throws where it is
   * lost.
   */
  open(size: Size): WebGLRenderer {
    queueMicrotask(this.#closeIfEmpty);
    const renderer = this.#context.open(size);
    if (renderer === null || this.#context.noticeLoss()) throw contextLost();
    return renderer;
  }

  /**
   * Lets `render` draw into targets of its own. False: there is no context, or it was lost
   * meanwhile.
   */
  drawAside(render: Draw): boolean {
    const { renderer } = this.#context;
    if (renderer === null || this.#context.noticeLoss()) return false;
    try {
      render(renderer);
      this.#context.checkLinks();
    } catch (error) {
      if (!this.#context.noticeLoss()) throw error;
    } finally {
      renderer.setRenderTarget(null);
    }
    return !this.#context.noticeLoss();
  }

  /**
   * Draws a picture that is not shown into a 2D canvas of exactly this size, in tiles where it is
   * larger than the context can hold. `render` draws the given part and must not clear. Throws
   * RangeError where no canvas can hold the picture.
   */
  capture(size: Size, render: DrawPart): HTMLCanvasElement {
    const target = this.newTarget(size);
    try {
      this.#drawTiles(this.open(tilesOf(target.canvas, Infinity, SAFE_SIDE)[0]!), target, render);
    } catch (error) {
      if (!this.#context.noticeLoss()) throw error;
    }
    // Also when it was lost between two tiles: their pictures would be empty.
    if (this.#context.noticeLoss()) throw contextLost();
    return target.canvas;
  }

  /**
   * A 2D canvas of this size in pixels, transparent. Throws RangeError where there is no memory for
   * it.
   */
  newTarget({ width, height }: Size): CanvasRenderingContext2D {
    const canvas = document.createElement('canvas');
    canvas.width = width;
    canvas.height = height;
    const context = canvas.getContext('2d');
    if (context !== null && hasMemory(context, width, height)) return context;
    // When the GPU process crashes, 2D canvases fail before WebGL notices. Any GPU has memory for
    // pictures up to this side; no browser makes a canvas beyond 65,535.
    if (this.#context.noticeLoss() || Math.max(width, height) <= SAFE_SIDE) throw contextLost();
    throw new RangeError(`a picture of ${String(width)} × ${String(height)} is too large`);
  }

  #drawAlone(viewport: StagedPicture, renderer: WebGLRenderer, render: Draw) {
    this.#beforeOverwriting();
    // The second time only if the browser gave less: the viewport's size has become smaller then.
    if (!this.#context.resize(viewport)) {
      this.#context.resize(viewport);
    }
    const { width, height } = viewport;
    clear(renderer);
    drawInto(renderer, { x: 0, y: 0, width, height }, render);
    this.#copies.drop(viewport);
    const { domElement } = renderer;
    if (viewport.holder.firstChild !== domElement) {
      viewport.holder.replaceChildren(domElement);
    }
  }

  /** Draws a capture into `target`, which has its size, tile by tile. */
  #drawTiles(renderer: WebGLRenderer, target: CanvasRenderingContext2D, render: DrawPart) {
    this.#beforeOverwriting();
    const canvas = renderer.domElement;
    const before = { width: canvas.width, height: canvas.height };
    const step = Math.min(this.#context.limit.side, SAFE_SIDE);
    for (const part of tilesOf(target.canvas, Infinity, step)) {
      const { x, y, width, height } = part;
      const fits = width <= canvas.width && height <= canvas.height;
      if (!fits && !this.#context.resize(part)) {
        throw new RangeError(
          `the GPU has no memory to draw ${String(target.canvas.width)} × ${String(target.canvas.height)} pixels`,
        );
      }
      clear(renderer);
      drawInto(renderer, { ...part, x: 0, y: 0 }, (r) => render(r, part));
      target.drawImage(canvas, 0, canvas.height - height, width, height, x, y, width, height);
    }
    this.#context.checkLinks();
    // The capture has overwritten the canvas that a lone picture shows.
    if (this.#viewports.size === 1) {
      for (const viewport of this.#viewports) {
        viewport.redraw();
      }
    } else {
      this.#context.resize(before); // else it would stay large
    }
  }

  #repaintAll() {
    for (const viewport of this.#viewports) {
      viewport.repaint();
    }
  }

  /**
   * The first picture of a frame starts an atlas and reserves places for all that are out of date.
   */
  #placeOf(viewport: StagedPicture, renderer: WebGLRenderer): Region {
    const reserved = this.#places.get(viewport);
    this.#places.delete(viewport); // a second drawing needs a cleared place
    if (reserved?.width === viewport.width && reserved.height === viewport.height) return reserved;
    this.#beforeOverwriting();
    let { pictures, atlas } = this.#layOut(viewport);
    if (!this.#makeRoom(renderer, atlas)) {
      ({ pictures, atlas } = this.#layOut(viewport)); // in less room
      this.#makeRoom(renderer, atlas);
    }
    // Once for all places: 20 clears of 256 × 180 cost as much as drawing a box in each (25 ms of
    // CPU in software).
    clear(renderer);
    atlas.places.forEach((place, i) => {
      const picture = pictures[i];
      if (picture !== undefined && picture !== viewport) {
        this.#places.set(picture, place);
      }
    });
    return { x: 0, y: 0, width: viewport.width, height: viewport.height }; // the first place
  }

  /** The pictures that are out of date and their places, `viewport` first. */
  #layOut(viewport: StagedPicture): { pictures: readonly StagedPicture[]; atlas: AtlasLayout } {
    const pictures = [viewport];
    for (const one of this.#viewports) {
      if (one !== viewport && one.drawable && !one.upToDate) {
        pictures.push(one);
      }
    }
    const { side, area } = this.#context.limit;
    return {
      pictures,
      atlas: layOutAtlas(pictures, { side, area: Math.min(area, screenPixels()) }),
    };
  }

  /**
   * Makes the canvas at least this large. A new size costs new buffers, so a canvas that is more
   * than `spare` times too large shrinks after some frames: half a second of motion with a GPU.
   * Where drawing is slow, so is what each frame does with all of the canvas. False where there is
   * no memory for it.
   */
  #makeRoom(renderer: WebGLRenderer, { width, height }: Size): boolean {
    const canvas = renderer.domElement;
    const fits = width <= canvas.width && height <= canvas.height;
    const isSlow = pace.share < 1;
    const spare = isSlow ? 1.5 : 4;
    const frames = isSlow ? 2 : 30;
    const wasteful = fits && spare * width * height < canvas.width * canvas.height;
    this.#wastefulFrames = wasteful ? this.#wastefulFrames + 1 : 0;
    if (fits && this.#wastefulFrames < frames) return true;
    this.#wastefulFrames = 0;
    const both = { width: Math.max(width, canvas.width), height: Math.max(height, canvas.height) };
    const isSmall = both.width * both.height <= Math.min(this.#context.limit.area, screenPixels());
    return this.#context.resize(!fits && isSmall ? both : { width, height });
  }

  /** Throws if the context turns out to be lost: its renderer must not upload anything any more. */
  #beforeOverwriting() {
    this.#showDrawn();
    if (this.#context.unavailable) throw contextLost();
  }

  #showDrawn() {
    if (this.#places.size > 0) {
      this.#places.clear(); // clearing allocates, even an empty map
    }
    // A lost context has no pixels: the copies keep their pictures. (A lone picture is not checked
    // in each frame.)
    if (this.#drawn.size === 0 || this.#context.noticeLoss()) return;
    const source = this.#context.renderer?.domElement;
    if (source !== undefined) {
      for (const [viewport, place] of this.#drawn) {
        this.#copies.show(viewport, source, place);
      }
    }
    this.#drawn.clear();
  }

  readonly #endFrame = () => {
    this.#inFrame = false;
    this.#showDrawn();
    this.#copies.trim();
    for (const viewport of this.#viewports) {
      viewport.shown();
    }
  };

  readonly #closeIfEmpty = () => {
    if (this.#viewports.size === 0) {
      this.#context.close();
      pace.forget();
    }
  };
}

/**
 * Unscissored, which the GPU does without drawing. A scene's background leaves three.js's clear
 * colour changed.
 */
function clear(renderer: WebGLRenderer) {
  renderer.setScissorTest(false);
  renderer.setClearColor(0x000000, 0);
  renderer.clear(true, true, false);
}

function drawInto(renderer: WebGLRenderer, { x, y, width, height }: Region, render: Draw) {
  const whole = renderer.domElement.width === width && renderer.domElement.height === height;
  renderer.setViewport(x, y, width, height);
  renderer.setScissor(x, y, width, height);
  renderer.setScissorTest(!whole);
  render(renderer);
}

/**
 * Whether a canvas really has its pixels: browsers return canvases without memory, and only a drawn
 * pixel shows it.
 */
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

const contextLost = (): Error => new Error('the graphics context is lost');

export const stage = new Stage();
