// Shows how far the picture is from the equation in float64, on a canvas over it: once the picture has been still for a
// moment, coarse first. A new frame ends the measurement.
import { create } from '../../element/dom.js';
import type { ExtraHost } from '../../element/viewer/extras.js';
import type { LightValues } from '../../light/light-state.js';
import { scaleColor } from '../../material/view/scale.js';
import { lazyCode } from '../../model/lazy-code.js';
import { Slices } from '../../model/slices.js';
import { ErrorMeasure, type PixelCode } from './error-measure.js';
import { type PictureSnapshot, snapshotOf } from './picture-snapshot.js';

/** Milliseconds without a new frame until the picture counts as still. */
const STILL_MS = 100;

/** Milliseconds of a task: 8 less what painting the canvas and the last pixel take. */
const TASK_MS = 6;

const equationCode = lazyCode(() => import('../../reference/index.js'), 'the error view');
const pixelCode = lazyCode(() => import('../../element/viewer/shade-at.js'), 'the error view');

export interface ErrorViewHost extends ExtraHost {
  /** The lights that the picture is drawn with. */
  lights(): readonly Readonly<LightValues>[];
  /** The difference that has the scale's last colour, in steps of 1/255. */
  readonly end: number;
  /** `done`: share of the pixels that are measured; null while the picture moves. `largest` is NaN until all are. */
  progress(done: number | null, largest: number): void;
}

export class ErrorView {
  readonly #host: ErrorViewHost;
  readonly #canvas = create('canvas', { class: 'view-error', 'aria-hidden': 'true' });
  #waiting: ReturnType<typeof setTimeout> | undefined;
  /** Ends the measurement that runs. */
  #abort: AbortController | null = null;
  /** The pixels that the canvas shows the error of, once all are measured. */
  #measured: ImageData | null = null;
  /** Versions of camera and lights in the last frame. */
  #versions = '';
  #capturing = false;

  constructor(host: ErrorViewHost) {
    this.#host = host;
    host.tree.layer.prepend(this.#canvas);
  }

  /** A frame was drawn, or may be drawn soon. */
  update(): void {
    if (this.#capturing) return;
    this.#end();
    const { orbit, lighting } = this.#host.viewport;
    const versions = `${String(orbit.version)} ${String(lighting.lights.version)}`;
    if (versions !== this.#versions) this.#hide();
    this.#versions = versions;
    this.#waiting = setTimeout(() => {
      void this.#start();
    }, STILL_MS);
  }

  dispose(): void {
    this.#end();
    this.#canvas.remove();
  }

  #end(): void {
    clearTimeout(this.#waiting);
    this.#abort?.abort();
    this.#abort = null;
  }

  /** The canvas shows another picture's error. */
  #hide(): void {
    this.#measured = null;
    this.#canvas.hidden = true;
    this.#host.progress(null, NaN);
  }

  async #start(): Promise<void> {
    const host = this.#host;
    const { viewport, end } = host;
    const { width, height } = viewport;
    if (width === 0 || height === 0) return;
    const drawn = this.#capture(width, height);
    if (drawn === null || isSame(drawn, this.#measured)) return;
    this.#hide();
    const { signal } = (this.#abort = new AbortController());
    const { scene, lights } = snapshotOf(viewport, drawn, host.lights());
    Object.assign(this.#canvas, { width, height });
    const context = this.#canvas.getContext('2d');
    if (context === null) return;
    try {
      const measure = new ErrorMeasure(drawn, scene, lights, await codeOfPixels());
      const slices = new Slices(signal, TASK_MS);
      await slices.pause(); // capturing took a task of its own
      const shown = context.createImageData(width, height);
      await measure.run(slices, painter(shown, null, end), () => {
        this.#canvas.hidden = false;
        context.putImageData(shown, 0, 0);
        host.progress(measure.done, measure.largest);
      });
      this.#measured = drawn;
      this.#abort = null;
    } catch (error) {
      if (signal.aborted) return;
      console.warn(`<phong-viewer view="error">: ${(error as Error).message}`);
    }
  }

  /**
   * The picture as it is drawn now; null without a context. Capturing may draw the viewer again, which is no change.
   */
  #capture(width: number, height: number): ImageData | null {
    this.#capturing = true;
    try {
      return pixelsOf(this.#host.viewport.capture(width, height));
    } catch {
      return null; // the context is lost: another frame follows once it is back
    } finally {
      this.#capturing = false;
    }
  }
}

async function codeOfPixels(): Promise<PixelCode> {
  const [pixel, equation] = await Promise.all([pixelCode(), equationCode()]);
  return { ...pixel, equation };
}

/** Draws the error of a picture over the picture. Pixels without a known error stay. */
export async function drawError(
  picture: HTMLCanvasElement,
  { scene, lights }: PictureSnapshot,
  end: number,
): Promise<void> {
  const drawn = pixelsOf(picture);
  const shown = new ImageData(new Uint8ClampedArray(drawn.data), drawn.width, drawn.height);
  const measure = new ErrorMeasure(drawn, scene, lights, await codeOfPixels());
  const slices = new Slices(new AbortController().signal, TASK_MS);
  await measure.run(slices, painter(shown, drawn, end), () => undefined);
  picture.getContext('2d')?.putImageData(shown, 0, 0);
}

/** Paints a block; where no error is known, the pixels of `drawn`, or nothing. */
function painter(shown: ImageData, drawn: ImageData | null, end: number) {
  const { width, height, data } = shown;
  return (left: number, top: number, side: number, error: number): void => {
    const color = Number.isNaN(error)
      ? null
      : scaleColor(error / end).map((channel) => Math.round(255 * channel));
    for (let y = top; y < Math.min(top + side, height); y++) {
      for (let x = left; x < Math.min(left + side, width); x++) {
        const at = 4 * (y * width + x);
        if (color === null) data.set(drawn?.data.subarray(at, at + 4) ?? CLEAR, at);
        else {
          data.set(color, at);
          data[at + 3] = 255;
        }
      }
    }
  };
}

const CLEAR = [0, 0, 0, 0];

/**
 * From a copy that the browser keeps in memory: it warns about reading twice from a canvas on the GPU, and capturing
 * reads once.
 */
function pixelsOf(picture: HTMLCanvasElement): ImageData {
  const { width, height } = picture;
  const context = Object.assign(document.createElement('canvas'), { width, height }).getContext('2d', {
    willReadFrequently: true,
  });
  if (context === null) throw new Error('this browser gives no 2D canvas to read the picture with');
  context.drawImage(picture, 0, 0);
  return context.getImageData(0, 0, width, height);
}

function isSame(a: ImageData, b: ImageData | null): boolean {
  return a.width === b?.width && a.height === b.height && a.data.every((code, i) => code === b.data[i]);
}
