// Writes a PNG: 8 bits for r, g, b and a, straight alpha, sRGB. The same bytes for the same pixels.
import { zlibSync } from 'fflate';

/** `pixels`: rows from the top. */
export function encodePng(width: number, height: number, pixels: Uint8Array): Uint8Array {
  const header = new Uint8Array(13);
  const view = new DataView(header.buffer);
  view.setUint32(0, width);
  view.setUint32(4, height);
  header.set([8, 6], 8); // bits, and r g b a
  const data = zlibSync(filtered(width, height, pixels), { level: 6, mem: 9 });
  const none = new Uint8Array();
  const parts = [
    Uint8Array.of(0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a),
    chunk('IHDR', header),
    chunk('sRGB', Uint8Array.of(0)),
    chunk('IDAT', data),
    chunk('IEND', none),
  ];
  const png = new Uint8Array(parts.reduce((sum, { length }) => sum + length, 0));
  let at = 0;
  for (const part of parts) {
    png.set(part, at);
    at += part.length;
  }
  return png;
}

function chunk(type: string, data: Uint8Array): Uint8Array {
  const bytes = new Uint8Array(data.length + 12);
  const view = new DataView(bytes.buffer);
  view.setUint32(0, data.length);
  bytes.set(
    Array.from(type, (letter) => letter.charCodeAt(0)),
    4,
  );
  bytes.set(data, 8);
  let crc = -1;
  for (const byte of bytes.subarray(4, -4)) {
    crc = CRC[(crc ^ byte) & 0xff]! ^ (crc >>> 8);
  }
  view.setInt32(bytes.length - 4, ~crc);
  return bytes;
}

const CRC = Int32Array.from({ length: 256 }, (_, i) => {
  let crc = i;
  for (let bit = 0; bit < 8; bit++) {
    crc = (crc & 1) === 1 ? 0xedb88320 ^ (crc >>> 1) : crc >>> 1;
  }
  return crc;
});

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
