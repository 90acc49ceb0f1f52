// Films what a viewer shows, frame by frame, as codes that tests can compare.

import type { Locator, Page } from '@playwright/test';
import type { PhongViewer } from './viewer.js';

export const LIGHT = '<phong-light position="1 2 3 0" ambient="40"></phong-light>';

/** A viewer that takes this many samples once it is still. */
export const viewerOf = (samples: number, attributes = 'geometry="torus"'): string =>
  `<phong-viewer alt="A shape" antialias="full" samples="${String(samples)}" ${attributes}>${LIGHT}</phong-viewer>`;

/** A frame of a viewer as the page shows it. Colours are codes, premultiplied. */
interface Frame {
  readonly samples: number;
  /** Of each channel over the picture. */
  readonly mean: readonly number[];
  /**
   * Pixels inside surfaces, not in outlines, that differ by more than three codes from the first
   * frame.
   */
  readonly inside: number;
}

/**
 * Reads the viewer's canvas after each animation frame, until `stop`. The first frame is the one
 * that is shown now, or the one that shows a turn to `theta`.
 */
export async function film(
  viewer: Locator,
  theta: number | null = null,
): Promise<{ stop(): Promise<readonly Frame[]> }> {
  const filmed = await viewer.evaluateHandle(async (element: PhongViewer, azimuth) => {
    const frames: Frame[] = [];
    if (azimuth !== null) {
      element.theta = azimuth;
      await new Promise((resolve) => element.addEventListener('render', resolve, { once: true }));
    }
    const copy = new OffscreenCanvas(1, 1).getContext('2d', { willReadFrequently: true })!;
    let first: Uint8ClampedArray | null = null;
    let running = true;
    const outline = (data: Uint8ClampedArray, width: number, pixel: number) => {
      const beside = [0, -1, 1, -width, width].map((by) => 4 * (pixel + by));
      return [0, 1, 2, 3].some((channel) => {
        const codes = beside.map((at) => data[at + channel] ?? 0);
        return Math.max(...codes) - Math.min(...codes) > 24;
      });
    };
    const read = () => {
      const canvas = element.shadowRoot!.querySelector('canvas');
      if (!running || canvas === null) return; // null: it was moved after the page was shown
      const { width, height } = canvas;
      Object.assign(copy.canvas, { width, height });
      copy.drawImage(canvas, 0, 0);
      const { data } = copy.getImageData(0, 0, width, height);
      for (let i = 0; i < data.length; i++) {
        if (i % 4 !== 3) {
          data[i]! *= data[i - (i % 4) + 3]! / 255;
        }
      }
      if (first?.length !== data.length) {
        first = data;
      }
      const mean = [0, 0, 0, 0];
      data.forEach((code, i) => (mean[i % 4]! += (4 * code) / data.length));
      let inside = 0;
      for (let pixel = 0; pixel < width * height; pixel++) {
        const differs = [0, 1, 2, 3].some(
          (k) => Math.abs(data[4 * pixel + k]! - first![4 * pixel + k]!) > 3,
        );
        if (differs && !outline(first, width, pixel)) {
          inside += 1;
        }
      }
      frames.push({ samples: element.stats.samples, mean, inside });
    };
    // Once the page has been shown.
    const { port1, port2 } = new MessageChannel();
    port1.onmessage = read;
    const next = () => {
      if (!running) return;
      port2.postMessage(null);
      requestAnimationFrame(next);
    };
    read();
    requestAnimationFrame(next);
    return { frames, stop: () => (running = false) };
  }, theta);
  return {
    stop: () =>
      filmed.evaluate(({ frames, stop }) => {
        stop();
        return frames;
      }),
  };
}

/** WebGL canvases keep their pixels after a frame. */
export const keepPixels = (page: Page): Promise<unknown> =>
  page.addInitScript(() => {
    const real = HTMLCanvasElement.prototype.getContext as (
      this: unknown,
      ...given: unknown[]
    ) => unknown;
    HTMLCanvasElement.prototype.getContext = function (
      this: unknown,
      kind: string,
      options?: object,
    ) {
      return real.call(
        this,
        kind,
        kind === 'webgl2' ? { ...options, preserveDrawingBuffer: true } : options,
      );
    } as typeof HTMLCanvasElement.prototype.getContext;
  });
