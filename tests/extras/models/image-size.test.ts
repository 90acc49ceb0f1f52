// Is the size of an image read from its header, is anything else refused without an exception, and
// are claims of KTX2 files checked before anything is unpacked?
import { readFileSync } from 'node:fs';
import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { imageSize } from '../../../src/extras/models/image.js';
import { checkKtx2, isKtx2 } from '../../../src/extras/models/ktx2/decode-ktx2.js';
import { pngOf } from '../../fuzz/glb.js';

const text = (value: string): Buffer => Buffer.from(value, 'latin1');
const big = (bytes: 2 | 4, ...values: readonly number[]): Buffer =>
  Buffer.concat(
    values.map((value) => Buffer.from(value.toString(16).padStart(bytes * 2, '0'), 'hex')),
  );
const segment = (marker: number, content: Buffer): Buffer =>
  Buffer.concat([Buffer.from([0xff, marker]), big(2, content.length + 2), content]);
const frame = (marker: number, height = 480): Buffer =>
  segment(marker, Buffer.concat([Buffer.from([8]), big(2, height, 640), Buffer.from([3])]));
// An embedded thumbnail has a frame header of its own, inside a segment.
const exif = segment(
  0xe1,
  Buffer.concat([text('Exif\0\0'), Buffer.from([0xff, 0xd8]), frame(0xc0)]),
);

const jpeg = (...segments: readonly Buffer[]): Buffer =>
  Buffer.concat([Buffer.from([0xff, 0xd8]), ...segments, segment(0xda, Buffer.alloc(10))]);
const chunk = (name: string, ...content: readonly number[]): Buffer =>
  Buffer.concat([text(name), Buffer.from([content.length, 0, 0, 0]), Buffer.from(content)]);
const webp = (...chunks: readonly Buffer[]): Buffer =>
  Buffer.concat([text('RIFF\0\0\0\0WEBP'), ...chunks]);
/** Canvas and frame of 640 × 480, and frames of an animation. */
const lossy = chunk('VP8 ', 0, 0, 0, 0x9d, 1, 0x2a, 0x80, 0x42, 0xe0, 1);
const lossless = chunk('VP8L', 0x2f, 0x7f, 0xc2, 0x77, 0, 0);
const canvas = chunk('VP8X', 0, 0, 0, 0, 0x7f, 2, 0, 0xdf, 1, 0);
const animated = (x: number): Buffer =>
  chunk('ANMF', x, 0, 0, 0, 0, 0, 0x7f, 2, 0, 0xdf, 1, 0, ...Array<number>(4).fill(0));
const png = pngOf(640, 480, 1);
const [signature, header, rest] = [png.subarray(0, 8), png.subarray(8, 33), png.subarray(33)];

describe('the size of an image', () => {
  it.each<[string, Buffer, [number, number]]>([
    ['PNG', pngOf(33, 2, 32), [33, 2]],
    [
      'PNG within a larger buffer',
      Buffer.concat([Buffer.alloc(7), pngOf(5, 6, 1)]).subarray(7),
      [5, 6],
    ],
    ['baseline JPEG', jpeg(exif, segment(0xc4, Buffer.alloc(9)), frame(0xc0)), [640, 480]],
    ['progressive JPEG after fill bytes', jpeg(Buffer.from([0xff]), exif, frame(0xc2)), [640, 480]],
    ['lossy WebP', webp(lossy), [640, 480]],
    ['lossless WebP', webp(lossless), [640, 480]],
    ['extended WebP', webp(canvas, chunk('ICCP', 1), Buffer.alloc(1), lossy), [640, 480]],
    [
      'animated WebP',
      webp(canvas, chunk('ANIM', ...Array<number>(6).fill(0)), animated(0)),
      [640, 480],
    ],
  ])('is read from a %s', (_, file, [width, height]) => {
    expect(imageSize(file)).toEqual({ width, height });
  });

  it.each<[string, Buffer]>([
    [
      'PNG with two headers',
      Buffer.concat([signature, header, pngOf(9, 9, 1).subarray(8, 33), rest]),
    ],
    [
      'PNG whose header comes late',
      Buffer.concat([signature, text('\0\0\0\0tEXt\0\0\0\0'), header, rest]),
    ],
    ['PNG without pixels', Buffer.concat([signature, header])],
    ['PNG of no width', pngOf(0, 9, 32)],
    ['JPEG with two frame headers', jpeg(frame(0xc0), frame(0xc2))],
    ['JPEG whose height comes later', jpeg(frame(0xc0, 0))],
    ['JPEG without pixels', jpeg(frame(0xc0)).subarray(0, -14)],
    ['JPEG cut short', Buffer.from([0xff, 0xd8, 0xff])],
    [
      'WebP whose frame is not its canvas',
      webp(chunk('VP8X', 0, 0, 0, 0, 9, 0, 0, 9, 0, 0), lossy),
    ],
    ['WebP with two canvases', webp(canvas, canvas, lossy)],
    ['animated WebP whose frame leaves its canvas', webp(canvas, animated(1))],
    ['animated WebP without a canvas', webp(animated(0))],
    ['WebP cut short', text('RIFF')],
    ['GIF: its frames have sizes of their own', text('GIF89a\x80\x02\xe0\x01')],
    ['BMP', Buffer.concat([text('BM'), Buffer.alloc(16), Buffer.from([1, 0, 0, 0, 1, 0, 0, 0])])],
    ['file without bytes', Buffer.alloc(0)],
  ])('is null for a %s', (_, file) => {
    expect(imageSize(file)).toBeNull();
  });

  it('never throws or hangs, whatever bytes follow a signature', () => {
    const signatures = ['\x89PNG\r\n\x1a\n', '\xff\xd8\xff', 'RIFF\0\0\0\0WEBPVP8X'].map(text);
    fc.assert(
      fc.property(
        fc.constantFrom(...signatures),
        fc.uint8Array({ maxLength: 200 }),
        (start, bytes) => {
          const size = imageSize(Buffer.concat([start, bytes]));
          if (size) {
            expect(size.width * size.height).toBeGreaterThan(0);
          }
        },
      ),
    );
  });
});

/** The texture in a fixture: its last buffer view. */
function textureOf(name: string): Uint8Array {
  const file = readFileSync(new URL(`../../fixtures/models/${name}.glb`, import.meta.url));
  return new Uint8Array(file.subarray(file.indexOf('\xabKTX 20', 0, 'latin1')));
}

const GOOD = textureOf('ktx2');

function changed(at: number, value: number): Uint8Array {
  const bytes = GOOD.slice();
  new DataView(bytes.buffer).setUint32(at, value, true);
  return bytes;
}

describe('the header of a KTX2 file', () => {
  it.each(['ktx2', 'ktx2-etc1s'])('of %s is accepted, and tells the size', (name) => {
    const bytes = textureOf(name);
    expect(isKtx2(bytes)).toBe(true);
    expect(imageSize(bytes)).toEqual({ width: 8, height: 8 });
    expect(() => checkKtx2(bytes)).not.toThrow();
  });

  it.each([
    ['a format of its own', changed(12, 37), /format of its own/],
    ['a volume', changed(28, 4), /no single picture/],
    ['an array', changed(32, 2), /no single picture/],
    ['a cube', changed(36, 6), /no single picture/],
    ['more levels than there are sizes', changed(40, 17), /cut short/],
    ['a level beyond its end', changed(80, 1e6), /cut short/],
    ['a level longer than the file', changed(88, 1e6), /cut short/],
    ['a level of gigabytes', changed(100, 1), /unpacks to more/],
    ['a level larger than its picture', changed(96, 100), /unpacks to more/],
    ['a header without its end', GOOD.slice(0, 79), /ends inside its header/],
    ['no levels at all', GOOD.slice(0, 90), /cut short/],
  ])('is refused with %s', (_, bytes, message) => {
    expect(() => checkKtx2(bytes)).toThrow(message);
  });
});
