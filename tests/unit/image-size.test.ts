// Is the size of an image read from its header, and is anything else refused without an exception?
import { readFileSync } from 'node:fs';
import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { imageSize } from '../../src/model/image-size.js';
import { pngOf } from '../fuzz/glb.js';

const text = (value: string): Buffer => Buffer.from(value, 'latin1');
const big = (bytes: 2 | 4, ...values: readonly number[]): Buffer =>
  Buffer.concat(values.map((value) => Buffer.from(value.toString(16).padStart(bytes * 2, '0'), 'hex')));
const box = (type: string, ...content: readonly Buffer[]): Buffer => {
  const inner = Buffer.concat(content);
  return Buffer.concat([big(4, inner.length + 8), text(type), inner]);
};
const ispe = (width: number, height: number): Buffer => box('ispe', big(4, 0, width, height));

const segment = (marker: number, content: Buffer): Buffer =>
  Buffer.concat([Buffer.from([0xff, marker]), big(2, content.length + 2), content]);
const frame = (marker: number): Buffer =>
  segment(marker, Buffer.concat([Buffer.from([8]), big(2, 480, 640), Buffer.from([3])]));
// An embedded thumbnail has a frame header of its own, inside a segment.
const exif = segment(0xe1, Buffer.concat([text('Exif\0\0'), Buffer.from([0xff, 0xd8]), frame(0xc0)]));

const webp = (chunk: Buffer): Buffer => Buffer.concat([text('RIFF\0\0\0\0WEBP'), chunk, Buffer.alloc(20)]);

describe('the size of an image', () => {
  it.each<[string, Buffer, [number, number]]>([
    ['PNG', pngOf(33, 2, 32), [33, 2]],
    [
      'baseline JPEG',
      Buffer.concat([Buffer.from([0xff, 0xd8]), exif, segment(0xc4, Buffer.alloc(9)), frame(0xc0)]),
      [640, 480],
    ],
    [
      'progressive JPEG after fill bytes',
      Buffer.concat([Buffer.from([0xff, 0xd8, 0xff, 0xff]), exif.subarray(1), frame(0xc2)]),
      [640, 480],
    ],
    [
      'lossy WebP',
      webp(Buffer.concat([text('VP8 \0\0\0\0'), Buffer.from([0, 0, 0, 0x9d, 1, 0x2a, 0x80, 0x42, 0xe0, 1])])),
      [640, 480],
    ],
    [
      'lossless WebP',
      webp(Buffer.concat([text('VP8L\0\0\0\0'), Buffer.from([0x2f, 0x7f, 0xc2, 0x77, 0])])),
      [640, 480],
    ],
    [
      'extended WebP',
      webp(Buffer.concat([text('VP8X\0\0\0\0'), Buffer.from([0, 0, 0, 0, 0x7f, 2, 1, 0xdf, 1, 0])])),
      [66176, 480],
    ],
    ['GIF', Buffer.concat([text('GIF89a'), Buffer.from([0x80, 2, 0xe0, 1])]), [640, 480]],
    [
      'AVIF, the largest of its items',
      Buffer.concat([
        box('ftyp', text('avif')),
        box(
          'meta',
          big(4, 0),
          box('hdlr'),
          box('iprp', box('ipco', ispe(64, 64), box('pixi'), ispe(640, 480))),
        ),
      ]),
      [640, 480],
    ],
  ])('is read from a %s', (_, file, [width, height]) => {
    expect(imageSize(file)).toEqual({ width, height });
  });

  it('is read where the file lies within a larger buffer', () => {
    const padded = Buffer.concat([Buffer.alloc(7), pngOf(5, 6, 1)]);
    expect(imageSize(padded.subarray(7))).toEqual({ width: 5, height: 6 });
  });

  it('is null for a side of 0 and for data that are no image', () => {
    for (const file of [
      pngOf(0, 9, 32),
      text('<svg/>'),
      Buffer.alloc(0),
      text('RIFF'),
      Buffer.from([0xff, 0xd8, 0xff]),
    ]) {
      expect(imageSize(file)).toBeNull();
    }
  });

  it('never throws or hangs, whatever bytes follow a signature', () => {
    const signatures = [
      '\x89PNG\r\n\x1a\n',
      '\xff\xd8\xff',
      'RIFF\0\0\0\0WEBPVP8X',
      '\0\0\0\x08ftyp',
      'GIF8',
      'BM',
    ].map(text);
    fc.assert(
      fc.property(fc.constantFrom(...signatures), fc.uint8Array({ maxLength: 200 }), (signature, rest) => {
        const size = imageSize(Buffer.concat([signature, rest]));
        if (size) expect(size.width * size.height).toBeGreaterThan(0);
      }),
    );
  });
});

it('the textures of the repository’s own models have sizes', () => {
  const file = readFileSync(new URL('../fixtures/models/beside/textures/four colours.png', import.meta.url));
  expect(imageSize(file)).toEqual({ width: 2, height: 2 });
});
