// Writes a PNG: 8 bits for r, g, b and a, straight alpha, sRGB. The same bytes for the same pixels.
import { zlibSync } from 'fflate';
import { chunk, joined, SIGNATURE } from '../png/chunks.js';

/** `pixels`: rows from the top. */
export function encodePng(
  width: number,
  height: number,
  pixels: Uint8Array,
): Uint8Array<ArrayBuffer> {
  const header = new Uint8Array(13);
  const view = new DataView(header.buffer);
  view.setUint32(0, width);
  view.setUint32(4, height);
  header.set([8, 6], 8); // bits, and r g b a
  const data = zlibSync(filtered(width, height, pixels), { level: 6, mem: 9 });
  return joined([
    SIGNATURE,
    chunk('IHDR', header),
    chunk('sRGB', Uint8Array.of(0)),
    chunk('IDAT', data),
    chunk('IEND', new Uint8Array()),
  ]);
}

/**
 * Each pixel's difference from the one to its left. Three posters of 760 × 420 are 3 to 5 % larger so
 * than with the best filter for each row.
 */
function filtered(width: number, height: number, pixels: Uint8Array): Uint8Array {
  const size = 4 * width;
  const out = new Uint8Array((size + 1) * height);
  for (let y = 0; y < height; y++) {
    const row = out.subarray((size + 1) * y, (size + 1) * (y + 1));
    row[0] = 1;
    for (let i = 0; i < size; i++) {
      const at = size * y + i;
      row[i + 1] = pixels[at]! - (i < 4 ? 0 : pixels[at - 4]!);
    }
  }
  return out;
}
