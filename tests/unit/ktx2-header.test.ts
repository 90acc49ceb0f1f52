// Are claims of KTX2 files checked before anything is unpacked?
import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { imageSize } from '../../src/model/image-size.js';
import { checkKtx2, isKtx2 } from '../../src/model/ktx2/decode-ktx2.js';

/** The texture in a fixture: its last buffer view. */
function textureOf(name: string): Uint8Array {
  const file = readFileSync(new URL(`../fixtures/models/${name}.glb`, import.meta.url));
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

  it('is not found in a PNG, nor in nothing', () => {
    for (const bytes of [[0x89, 0x50, 0x4e, 0x47], []]) expect(isKtx2(Uint8Array.from(bytes))).toBe(false);
  });
});
