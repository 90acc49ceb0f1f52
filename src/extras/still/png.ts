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

/** Each row by the filter that leaves the smallest numbers: none, sub, up, average or Paeth. */
function filtered(width: number, height: number, pixels: Uint8Array): Uint8Array {
  const size = 4 * width;
  const out = new Uint8Array((size + 1) * height);
  const row = new Uint8Array(size);
  for (let y = 0; y < height; y++) {
    let least = Infinity;
    for (let filter = 0; filter < 5; filter++) {
      let sum = 0;
      for (let i = 0; i < size; i++) {
        const at = size * y + i;
        const left = i < 4 ? 0 : pixels[at - 4]!;
        const up = y === 0 ? 0 : pixels[at - size]!;
        const corner = i < 4 || y === 0 ? 0 : pixels[at - size - 4]!;
        const value = (pixels[at]! - predicted(filter, left, up, corner)) & 0xff;
        row[i] = value;
        sum += Math.min(value, 256 - value);
      }
      if (sum >= least) continue;
      least = sum;
      out[(size + 1) * y] = filter;
      out.set(row, (size + 1) * y + 1);
    }
  }
  return out;
}

function predicted(filter: number, left: number, up: number, corner: number): number {
  if (filter < 3) return filter === 0 ? 0 : filter === 1 ? left : up;
  if (filter === 3) return (left + up) >> 1;
  const [a, b] = [Math.abs(up - corner), Math.abs(left - corner)];
  const c = Math.abs(left + up - 2 * corner);
  return a <= b && a <= c ? left : b <= c ? up : corner;
}
