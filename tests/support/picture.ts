// Pictures of viewers as numbers: read through `toBlob`, compared channel by channel, held against
// baselines. Channels are 8-bit codes 0-255, straight alpha, rows from the top.

import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { dirname } from 'node:path';
import { fileURLToPath } from 'node:url';
import { expect, test as base, type Locator, type Page } from '@playwright/test';
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
  /** Root of the mean squared difference, in codes. */
  readonly rmse: number;
}

/**
 * How far a picture may be from its baseline: rasterization and rounding differ between machines.
 */
const baselineTolerance = { codes: 2, share: 0.005 } as const;

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
  let squares = 0;
  for (let i = 0; i < a.data.length; i++) {
    const difference = Math.abs(a.data[i]! - b.data[i]!);
    if (difference > max) {
      max = difference;
    }
    if (difference > tolerance) {
      beyond++;
    }
    squares += difference * difference;
  }
  return { max, share: beyond / a.data.length, rmse: Math.sqrt(squares / a.data.length) };
}

/**
 * Holds a picture against tests/visual/baselines/<name>.png. With UPDATE_PICTURES=1 it becomes the
 * baseline. On failure the picture and its difference (16 times as strong) lie among the test's
 * results.
 */
export function expectPicture(name: string, actual: Picture): void {
  const baseline = fileURLToPath(new URL(`../visual/baselines/${name}.png`, import.meta.url));
  if (process.env['UPDATE_PICTURES'] === '1') {
    write(baseline, actual);
    return;
  }
  if (!existsSync(baseline)) {
    const path = write(base.info().outputPath(`${name}-actual.png`), actual);
    throw new Error(
      `No baseline ${name}.png. If ${path} is right, run again with UPDATE_PICTURES=1.`,
    );
  }
  const expected = decodePng(readFileSync(baseline));
  expect(`${actual.width}×${actual.height}`, `size of ${name}`).toBe(
    `${expected.width}×${expected.height}`,
  );
  const difference = compare(actual, expected, baselineTolerance.codes);
  if (difference.share <= baselineTolerance.share) return;
  const path = write(base.info().outputPath(`${name}-actual.png`), actual);
  write(base.info().outputPath(`${name}-difference.png`), differencePicture(actual, expected));
  const { share, max, rmse } = difference;
  throw new Error(
    `${name}: ${(100 * share).toFixed(2)} % of the channels are off by more than ${baselineTolerance.codes} codes ` +
      `(largest ${max}, rmse ${rmse.toFixed(2)}); see ${path}`,
  );
}

function differencePicture(a: Picture, b: Picture): Picture {
  const data = new Uint8Array(a.data.length).fill(255);
  for (let i = 0; i < data.length; i++) {
    if (i % 4 !== 3) {
      data[i] = Math.min(255, 16 * Math.abs(a.data[i]! - b.data[i]!));
    }
  }
  return { width: a.width, height: a.height, data };
}

export function decodePng(png: Buffer): Picture {
  const { width, height, data } = PNG.sync.read(png);
  return { width, height, data };
}

function write(path: string, { width, height, data }: Picture): string {
  const png = new PNG({ width, height });
  png.data = Buffer.from(data);
  mkdirSync(dirname(path), { recursive: true });
  writeFileSync(path, PNG.sync.write(png));
  return path;
}
