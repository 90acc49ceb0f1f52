// Writes small GLB and PNG files from parts, sound or not: what a document claims need not be in
// its bytes. Runs in Node.
import { deflateSync, gzipSync } from 'node:zlib';
import { glbFile } from '../bench/glb.mjs';

export type Json = Record<string, unknown>;

/**
 * A GLB of this document, or of a text in its place, and this binary chunk; both are padded to
 * whole words.
 */
export const glbOf = (json: object | string, body: Uint8Array = new Uint8Array()): Buffer =>
  Buffer.from(glbFile(json, body).buffer);

/** The document and the binary chunk of a sound GLB. */
export function openGlb(file: Buffer): { json: Json; body: Buffer } {
  const size = file.readUInt32LE(12);
  return {
    json: JSON.parse(file.toString('utf8', 20, 20 + size)) as Json,
    body: file.subarray(28 + size),
  };
}

/**
 * A PNG of this size in one colour. @param bits per pixel: 1 is black and white, 32 is colour with
 * alpha.
 */
export function pngOf(width: number, height: number, bits: 1 | 32): Buffer {
  const row = 1 + Math.ceil((width * bits) / 8);
  return pngWith(width, height, bits, deflateSync(Buffer.alloc(row * height), { level: 1 }));
}

/** A PNG whose header claims this size, whatever its data hold. */
export function pngWith(width: number, height: number, bits: 1 | 32, data: Uint8Array): Buffer {
  const header = Buffer.alloc(13);
  header.writeUInt32BE(width);
  header.writeUInt32BE(height, 4);
  header[8] = bits === 1 ? 1 : 8;
  header[9] = bits === 1 ? 0 : 6;
  const parts = [
    pngChunk('IHDR', header),
    pngChunk('IDAT', data),
    pngChunk('IEND', new Uint8Array()),
  ];
  return Buffer.concat([Buffer.from('\x89PNG\r\n\x1a\n', 'latin1'), ...parts]);
}

/** A progressive JPEG, in headers and markers only, of so many scans. */
export function jpegWith(width: number, height: number, scans: number): Buffer {
  const size = Buffer.alloc(4);
  size.writeUInt16BE(height);
  size.writeUInt16BE(width, 2);
  const frame = Buffer.concat([
    Buffer.from([0xff, 0xd8, 0xff, 0xc2, 0, 11, 8]),
    size,
    Buffer.from([1, 1, 0x11, 0]),
  ]);
  // Data with a stuffed byte and a restart, which are no markers of scans, and a fill byte.
  const scan = Buffer.from([
    0xff, 0xda, 0, 8, 1, 1, 0, 0, 0, 0, 7, 0xff, 0, 0xda, 0xff, 0xd3, 7, 0xff,
  ]);
  return Buffer.concat([frame, ...Array<Buffer>(scans).fill(scan), Buffer.from([0xff, 0xd9])]);
}

/** Buffer views end to end in one binary chunk. */
export function viewsOf(blobs: readonly Uint8Array[]) {
  let byteOffset = 0;
  const padded = blobs.map((blob) => Buffer.concat([blob, Buffer.alloc(-blob.length & 3)]));
  const bufferViews: Json[] = padded.map(({ length }, i) => {
    const view = { buffer: 0, byteOffset, byteLength: blobs[i]!.length };
    byteOffset += length;
    return view;
  });
  return {
    bufferViews,
    buffers: [{ byteLength: byteOffset }] as Json[],
    body: Buffer.concat(padded),
  };
}

export const floats = (...values: readonly number[]): Buffer =>
  Buffer.from(Float32Array.from(values).buffer);

function pngChunk(type: string, data: Uint8Array): Buffer {
  const named = Buffer.concat([Buffer.from(type), data]);
  const [length, sum] = [Buffer.alloc(4), Buffer.alloc(4)];
  length.writeUInt32BE(data.length);
  sum.writeUInt32BE(crc32(named));
  return Buffer.concat([length, named, sum]);
}

/**
 * The checksum of PNG chunks (ISO 3309): gzip's too, at its end. Node has `crc32` from version 22
 * on only.
 */
const crc32 = (bytes: Uint8Array) => gzipSync(bytes).subarray(-8).readUInt32LE();
