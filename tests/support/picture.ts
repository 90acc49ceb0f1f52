// Pictures of viewers as numbers: read through `toBlob`, compared channel by channel.
// Channels are 8-bit codes 0-255, straight alpha, rows from the top.

import { expect, type Locator, type Page } from '@playwright/test';
import { PNG } from 'pngjs';

export interface Picture {
  readonly width: number;
  readonly height: number;
  /** r, g, b, a of each pixel. */
  readonly data: Uint8Array;
}

interface Difference {
  /** Largest difference of a channel, in codes. */
  readonly max: number;
  /** Share (0-1) of the channels that differ by more than the tolerance. */
  readonly share: number;
}

/** The part of `<phong-viewer>` that the helpers use. */
export interface ViewerLike extends HTMLElement {
  readonly ready: Promise<unknown>;
  toBlob(options?: { width?: number; height?: number; type?: string }): Promise<Blob>;
}

/** The viewer's `toBlob` at this size; default: the canvas's own. */
export async function pixels(
  viewer: Locator,
  size: { width?: number; height?: number; helpers?: boolean; samples?: number } = {},
): Promise<Picture> {
  const base64 = await viewer.evaluate(async (element, options) => {
    const blob = await (element as ViewerLike).toBlob({ ...options, type: 'image/png' });
    return new Promise<string>((resolve, reject) => {
      const reader = new FileReader();
      reader.onload = () => resolve((reader.result as string).split(',')[1] ?? '');
      reader.onerror = () => reject(reader.error ?? new Error('unreadable blob'));
      reader.readAsDataURL(blob);
    });
  }, size);
  return decodePng(Buffer.from(base64, 'base64'));
}

/** A PNG, JPEG or WebP as the browser decodes it. */
export async function decodeInPage(page: Page, file: Buffer): Promise<Picture> {
  const { width, height, codes } = await page.evaluate(async (text) => {
    const bytes = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
    const image = await createImageBitmap(new Blob([bytes]), { colorSpaceConversion: 'none' });
    const { width, height } = image;
    const context = new OffscreenCanvas(width, height).getContext('2d')!;
    context.drawImage(image, 0, 0);
    return { width, height, codes: context.getImageData(0, 0, width, height).data };
  }, file.toString('base64'));
  return { width, height, data: new Uint8Array(codes) };
}

/** The pictures are equal to the bit. */
export const same = (a: Picture, b: Picture, what?: string): void =>
  expect(compare(a, b).max, what).toBe(0);

/** The codes of one pixel, x to the right and y down from the top left. */
export function pixelAt(
  { width, height, data }: Picture,
  x: number,
  y: number,
): [number, number, number, number] {
  if (x < 0 || y < 0 || x >= width || y >= height) throw new RangeError(`no pixel ${x}, ${y}`);
  const at = 4 * (y * width + x);
  return [data[at]!, data[at + 1]!, data[at + 2]!, data[at + 3]!];
}

/** @param tolerance codes below or at which a channel counts as equal for `share`; default 0. */
export function compare(a: Picture, b: Picture, tolerance = 0): Difference {
  if (a.width !== b.width || a.height !== b.height) {
    throw new RangeError(`sizes differ: ${a.width}×${a.height} and ${b.width}×${b.height}`);
  }
  let max = 0;
  let beyond = 0;
  for (let i = 0; i < a.data.length; i++) {
    const difference = Math.abs(a.data[i]! - b.data[i]!);
    if (difference > max) {
      max = difference;
    }
    if (difference > tolerance) {
      beyond++;
    }
  }
  return { max, share: beyond / a.data.length };
}

export function decodePng(png: Buffer): Picture {
  const { width, height, data } = PNG.sync.read(png);
  return { width, height, data };
}
