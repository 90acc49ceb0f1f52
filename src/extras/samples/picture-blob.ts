// A picture as a file: checks type and quality, and encodes. Fetched with the first use of toBlob.

import type { PictureOptions } from '../../viewer/extra.js';

/**
 * Rejects where type or quality is wrong, or the file cannot be made. @param markup what a PNG holds
 * besides; empty for nothing.
 */
export async function pictureBlob(
  picture: HTMLCanvasElement,
  { type = 'image/png', quality }: PictureOptions,
  markup: string,
): Promise<Blob> {
  if (typeof type !== 'string') {
    throw new TypeError(`toBlob: type must be text, got ${String(type)}`);
  }
  if (quality !== undefined && !(quality >= 0 && quality <= 1)) {
    throw new RangeError(`toBlob: quality must be from 0 to 1, got ${String(quality)}`);
  }
  if (type.toLowerCase() === 'image/jpeg') {
    fillBehind(picture, 'white');
  }
  const blob = await new Promise<Blob | null>((resolve) => picture.toBlob(resolve, type, quality));
  if (blob === null) {
    const size = `${String(picture.width)} × ${String(picture.height)}`;
    throw new RangeError(`toBlob: ${size} pixels are too many to encode`);
  }
  if (markup === '' || blob.type !== 'image/png') return blob;
  const { withMarkup } = await import('../png/chunks.js');
  return new Blob([withMarkup(new Uint8Array(await blob.arrayBuffer()), markup)], {
    type: blob.type,
  });
}

/** JPEG has no alpha, and browsers would fill transparent pixels with black. */
function fillBehind(picture: HTMLCanvasElement, color: string): void {
  const context = picture.getContext('2d');
  if (context === null) return;
  context.globalCompositeOperation = 'destination-over';
  context.fillStyle = color;
  context.fillRect(0, 0, picture.width, picture.height);
}
