// Markup in PNG files: what is written is read again, and files made to attack are refused.
import { deflateSync } from 'node:zlib';
import { PNG } from 'pngjs';
import { describe, expect, it } from 'vitest';
import { markupIn } from 'phong-viewer/still/markup';
import { still } from 'phong-viewer/still';
import { chunk, joined, SIGNATURE, withMarkup } from '../../../src/extras/png/chunks.js';

const plain = new Uint8Array(PNG.sync.write(new PNG({ width: 2, height: 2 })));
const SCENE = '<phong-viewer alt="Ümlaut 🫖" geometry="box"></phong-viewer>';
const bytes = (...parts: (string | number | readonly number[])[]): Uint8Array =>
  joined(
    parts.map((part) =>
      typeof part === 'string'
        ? new TextEncoder().encode(part)
        : Uint8Array.from(typeof part === 'number' ? [part] : part),
    ),
  );
const text = (...data: Parameters<typeof bytes>): Uint8Array =>
  chunk('iTXt', bytes('phong-viewer', 0, ...data));
/** A PNG with these chunks after its header. */
const png = (...chunks: readonly Uint8Array[]): Uint8Array =>
  joined([plain.subarray(0, 33), ...chunks, plain.subarray(33)]);
const changed = (file: Uint8Array, at: number, ...values: readonly number[]): Uint8Array => {
  const copy = file.slice();
  copy.set(values, at);
  return copy;
};
const whole = withMarkup(plain.slice(), SCENE);
const NONE = 'holds no scene: only';
const DAMAGED = 'the file is damaged';
const LARGE = 'too large to open';

describe('the markup in a PNG', () => {
  it('is read as it was written, and the picture is still one', async () => {
    expect(await markupIn(whole)).toBe(SCENE);
    expect(await markupIn(new Blob([whole]))).toBe(SCENE);
    expect(PNG.sync.read(Buffer.from(whole))).toMatchObject({ width: 2, height: 2 });
  });

  it('is read where another program has put it elsewhere', async () => {
    const other = chunk('tEXt', bytes('phong-viewer', 0, 'other'));
    expect(await markupIn(png(other, text([0, 0, 0, 0], SCENE)))).toBe(SCENE);
  });

  it('is in each still', async () => {
    const made = await still(` ${SCENE}\n`, { width: 3, height: 2, threads: 1 });
    expect(await markupIn(made.png)).toBe(SCENE);
  });

  it('is left out where it could not be opened', () => {
    expect(withMarkup(plain.slice(), ' '.repeat(100_001))).toEqual(plain);
  });

  it.each<readonly [what: string, file: Uint8Array, message: string]>([
    ['an empty file', new Uint8Array(), NONE],
    ['another format', bytes('GIF89a'), NONE],
    ['a signature alone', SIGNATURE, DAMAGED],
    ['a PNG without a text', plain, NONE],
    [
      'a text with another keyword',
      png(chunk('iTXt', bytes('Comment', [0, 0, 0, 0, 0], 'x'))),
      NONE,
    ],
    ['a longer keyword', png(chunk('iTXt', bytes('phong-viewer2', [0, 0, 0, 0, 0], 'x'))), NONE],
    ['a text of another kind', png(chunk('tEXt', bytes('phong-viewer', 0, SCENE))), NONE],
    ['a file cut inside the text', whole.subarray(0, 80), DAMAGED],
    ['a file cut after the text', whole.subarray(0, -12), DAMAGED],
    ['a length of four gigabytes', changed(whole, 33, 255, 255, 255, 255), DAMAGED],
    ['a length of two gigabytes', changed(whole, 33, 127, 255, 255, 255), DAMAGED],
    ['a length one too short', changed(whole, 36, whole[36]! - 1), DAMAGED],
    ['a wrong checksum', changed(whole, 70, whole[70]! ^ 1), DAMAGED],
    ['two markups', png(text([0, 0, 0, 0], SCENE), text([0, 0, 0, 0], SCENE)), DAMAGED],
    ['no end of the language', png(text([0, 0], 'en')), NONE],
    ['a keyword alone', png(text()), NONE],
    ['a head that is cut', png(text([0, 0, 0])), NONE],
    ['a compressed text', png(text([1, 0, 0, 0], [...deflateSync(SCENE)])), NONE],
    ['invalid UTF-8', png(text([0, 0, 0, 0], '<phong-viewer>', [0xc3, 0x28])), DAMAGED],
    ['half a surrogate pair', png(text([0, 0, 0, 0], [0xed, 0xa0, 0x80])), DAMAGED],
    ['a text of a megabyte', png(text([0, 0, 0, 0], ' '.repeat(2 ** 20))), LARGE],
    ['100,001 characters', png(text([0, 0, 0, 0], 'a'.repeat(100_001))), LARGE],
    ['three million empty texts', png(Buffer.alloc(36e6, chunk('iTXt', bytes()))), NONE],
  ])('is refused in %s', async (_what, file, message) => {
    const before = process.resourceUsage().maxRSS;
    await expect(markupIn(file)).rejects.toThrow(message);
    expect(process.resourceUsage().maxRSS - before).toBeLessThan(1e5);
  });
});
