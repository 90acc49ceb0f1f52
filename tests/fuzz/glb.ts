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
const crc32 = (bytes: Uint8Array): number => gzipSync(bytes).subarray(-8).readUInt32LE();
