// A picture as a file: sizes and formats checked, then drawn and encoded. Knows nothing of scenes.
import type { Viewport } from '../scene/viewport.js';

export interface PictureOptions {
  /** Pixels, whole, at least 1. Default: the canvas's own size, at least 1. */
  readonly width?: number;
  readonly height?: number;
  /** Any type that the browser's canvas can write; others give PNG, as there. Default `image/png`. */
  readonly type?: string;
  /** 0–1, for lossy types. Default: the browser's. */
  readonly quality?: number;
}

/** Rejects with RangeError or TypeError for options outside their domain, and where no canvas is that large. */
export async function pictureBlob(viewport: Viewport, options: PictureOptions = {}): Promise<Blob> {
  const width = side('width', options.width, viewport.width);
  const height = side('height', options.height, viewport.height);
  const { type = 'image/png', quality } = options;
  if (typeof type !== 'string') throw new TypeError(`toBlob: type must be text, got ${String(type)}`);
  if (quality !== undefined && !(quality >= 0 && quality <= 1)) {
    throw new RangeError(`toBlob: quality must be from 0 to 1, got ${String(quality)}`);
  }
  const picture = viewport.capture(width, height);
  if (type.toLowerCase() === 'image/jpeg') fillBehind(picture, 'white');
  return new Promise((resolve, reject) => {
    picture.toBlob(
      (blob) => {
        if (blob !== null) resolve(blob);
        else
          reject(
            new RangeError(`toBlob: ${String(width)} × ${String(height)} pixels are too many to encode`),
          );
      },
      type,
      quality,
    );
  });
}

function side(name: string, asked: number | undefined, own: number): number {
  const pixels = asked ?? Math.max(own, 1);
  if (!Number.isInteger(pixels) || pixels < 1) {
    throw new RangeError(`toBlob: ${name} must be a whole number of pixels from 1, got ${String(pixels)}`);
  }
  return pixels;
}

/** JPEG has no alpha, and browsers would put black where there is none. */
function fillBehind(picture: HTMLCanvasElement, color: string): void {
  const context = picture.getContext('2d');
  if (context === null) return;
  context.globalCompositeOperation = 'destination-over';
  context.fillStyle = color;
  context.fillRect(0, 0, picture.width, picture.height);
}
