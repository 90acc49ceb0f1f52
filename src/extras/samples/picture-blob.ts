// A picture as a file: checks the options and encodes. Fetched with the first use of toBlob.

import { MOST_SAMPLES } from '../../viewer/element/fields/viewer-fields.js';
import type { PictureOptions } from '../../viewer/element/elements.js';

/**
 * Null stands for an invalid size or number of samples. Rejects where options are wrong or the file
 * cannot be made.
 */
export async function pictureBlob(
  picture: HTMLCanvasElement | null,
  { width, height, type = 'image/png', quality, samples }: PictureOptions,
): Promise<Blob> {
  if (picture === null) {
    if (
      samples !== undefined &&
      !(Number.isInteger(samples) && samples >= 1 && samples <= MOST_SAMPLES)
    ) {
      throw new RangeError(
        `toBlob: samples must be a whole number from 1 to ${String(MOST_SAMPLES)}, got ${String(samples)}`,
      );
    }
    const asked = `${String(width ?? 'default')} × ${String(height ?? 'default')}`;
    throw new RangeError(
      `toBlob: width and height must be whole numbers of pixels from 1, got ${asked}`,
    );
  }
  if (typeof type !== 'string') {
    throw new TypeError(`toBlob: type must be text, got ${String(type)}`);
  }
  if (quality !== undefined && !(quality >= 0 && quality <= 1)) {
    throw new RangeError(`toBlob: quality must be from 0 to 1, got ${String(quality)}`);
  }
  if (type.toLowerCase() === 'image/jpeg') {
    fillBehind(picture, 'white');
  }
  return new Promise((resolve, reject) =>
    picture.toBlob(
      (blob) => {
        if (blob !== null) {
          resolve(blob);
        } else {
          const size = `${String(picture.width)} × ${String(picture.height)}`;
          reject(new RangeError(`toBlob: ${size} pixels are too many to encode`));
        }
      },
      type,
      quality,
    ),
  );
}

/** JPEG has no alpha, and browsers would fill transparent pixels with black. */
function fillBehind(picture: HTMLCanvasElement, color: string): void {
  const context = picture.getContext('2d');
  if (context === null) return;
  context.globalCompositeOperation = 'destination-over';
  context.fillStyle = color;
  context.fillRect(0, 0, picture.width, picture.height);
}
