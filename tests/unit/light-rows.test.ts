// Packed lights on their way to the GPU: only what changed is sent, to the texture that loops read and to the block that
// programs for exactly these lights read.

import fc from 'fast-check';
import type { ExternalTexture } from 'three';
import { beforeEach, describe, expect, it, vi } from 'vitest';
import { BLOCK_ROWS, LARGE_BLOCK_ROWS, TEXTURE_ROWS_LOG2 } from '../../src/light/light-layout.js';
import { emptyPack, type PackedLights } from '../../src/light/pack-lights.js';
import { lightBlockOf } from '../../src/material/light-block.js';
import { LightRows } from '../../src/material/light-buffer.js';
import { FakeRenderer } from './fake-renderer.js';

const WIDTH = 2 ** TEXTURE_ROWS_LOG2;

let gpu = new FakeRenderer();
beforeEach(() => {
  gpu = new FakeRenderer();
});

/** Rows that all differ, each float from the next. */
const packed = (rows: number, first = 1): PackedLights => ({
  ...emptyPack(),
  data: Float32Array.from({ length: rows * 4 + 8 }, (_, i) => first + i),
  rows,
});

/** The same with some floats changed. */
function changed(rows: number, ...floats: number[]): PackedLights {
  const pack = packed(rows);
  for (const i of floats) pack.data[i] = -1 - i;
  return pack;
}

/** The pieces of the block that would be sent in this frame; sent, as three.js does it, by reading their values. */
function sendBlock(rows: LightRows): Float32Array[] {
  lightBlockOf(rows).send();
  return lightBlockOf(rows).group.uniforms.map((uniform) => (uniform as { value: Float32Array }).value);
}

/** A draw that reads the texture. */
const draw = (rows: LightRows): ExternalTexture => rows.sendTexture(gpu.renderer);

/** Rows that the GPU has seen, in both places. */
function settled(count: number): LightRows {
  const rows = new LightRows();
  rows.write(packed(count));
  sendBlock(rows);
  draw(rows);
  gpu.patches = [];
  return rows;
}

const floatsOf = ({ data, rows }: PackedLights): number[] => [...data.slice(0, rows * 4)];

describe('the uniform block', () => {
  it('is sent whole at first, so that the GPU has all of its 16 KiB', () => {
    const rows = new LightRows();
    const pieces = sendBlock(rows);
    expect(pieces.reduce((sum, piece) => sum + piece.length, 0)).toBe(BLOCK_ROWS * 4);
    expect(sendBlock(rows)).toStrictEqual([]);
  });

  it('is made for the first program that reads it, of rows that were there before', () => {
    const rows = new LightRows();
    rows.write(packed(10));
    expect(rows.block).toBeNull();
    expect(sendBlock(rows)[0]!.slice(0, 40)).toStrictEqual(packed(10).data.slice(0, 40));
    expect(lightBlockOf(rows)).toBe(rows.block);
  });

  it('is measured whole by three.js before anything is sent', () => {
    const { uniforms } = lightBlockOf(new LightRows()).group;
    expect(uniforms.flat().map(({ value }) => (value as Float32Array).length)).toStrictEqual([
      256, 768, 3072,
    ]);
  });

  it('is three calls at most, and 1 KiB for a few lights', () => {
    expect(sendBlock(new LightRows())).toHaveLength(3);
    const rows = settled(BLOCK_ROWS);
    rows.write(changed(BLOCK_ROWS, 0, 63 * 4 + 3));
    expect(sendBlock(rows).map((piece) => piece.byteLength)).toStrictEqual([1024]);
    rows.write(packed(BLOCK_ROWS, 9));
    expect(sendBlock(rows)).toHaveLength(3);
  });

  it('holds the rows in order, across pieces', () => {
    const rows = new LightRows();
    rows.write(packed(300));
    const all = sendBlock(rows).flatMap((piece) => [...piece]);
    expect(all.slice(0, 1200)).toStrictEqual(floatsOf(packed(300)));
    expect(all.slice(1200).every((x) => x === 0)).toBe(true);
  });

  it.each([
    [0, 0],
    [64 * 4 - 1, 0],
    [64 * 4, 1],
    [256 * 4 - 1, 1],
    [256 * 4, 2],
    [BLOCK_ROWS * 4 - 1, 2],
  ])('sends for float %i piece %i alone', (float, piece) => {
    const rows = settled(BLOCK_ROWS);
    const sizes = sendBlock(new LightRows()).map(({ length }) => length);
    rows.write(changed(BLOCK_ROWS, float));
    const sent = sendBlock(rows);
    expect(sent.map(({ length }) => length)).toStrictEqual([sizes[piece]]);
    expect(sent[0]).toContain(-1 - float);
    expect(sendBlock(rows)).toStrictEqual([]);
  });

  it('sends nothing where nothing changed, and does not count it', () => {
    const rows = settled(200);
    expect(rows.uploads).toBe(2); // the block and the texture
    rows.write(packed(200));
    expect(sendBlock(rows)).toStrictEqual([]);
    expect(rows.uploads).toBe(2);
    rows.write(changed(200, 5));
    sendBlock(rows);
    expect(rows.uploads).toBe(3);
  });

  it('keeps what waits until it is read, however many frames that takes', () => {
    const rows = settled(10);
    rows.write(packed(10, 5));
    lightBlockOf(rows).send();
    lightBlockOf(rows).send();
    expect(lightBlockOf(rows).group.uniforms).toHaveLength(1);
    expect(sendBlock(rows)).toHaveLength(1);
    expect(sendBlock(rows)).toStrictEqual([]);
  });

  it('waits for nothing beyond its last row', () => {
    const rows = settled(LARGE_BLOCK_ROWS + 10);
    rows.write(changed(LARGE_BLOCK_ROWS + 10, LARGE_BLOCK_ROWS * 4));
    expect(sendBlock(rows)).toStrictEqual([]);
  });

  it('is a larger one where the rows outgrow it, measured whole and sent anew, up to the largest', () => {
    const rows = settled(BLOCK_ROWS);
    const dispose = vi.spyOn(lightBlockOf(rows).group, 'dispose');
    rows.write(packed(2 * WIDTH));
    expect(dispose).toHaveBeenCalledTimes(1);
    expect(lightBlockOf(rows).group.uniforms).toHaveLength(4);
    expect(sendBlock(rows).map(({ length }) => length)).toStrictEqual([256, 768, 3072, 4096]);
    rows.write(packed(5 * WIDTH));
    const floats = sendBlock(rows).reduce((sum, { length }) => sum + length, 0);
    expect(floats).toBe(LARGE_BLOCK_ROWS * 4);
  });

  it('is declared as small as its lights allow, and never larger than its buffer', () => {
    const rows = settled(10);
    expect(lightBlockOf(rows).rowsFor(10)).toBe(BLOCK_ROWS);
    rows.write(packed(2 * WIDTH));
    expect(lightBlockOf(rows).rowsFor(2 * WIDTH)).toBe(2 * WIDTH);
    expect(lightBlockOf(rows).rowsFor(BLOCK_ROWS)).toBe(BLOCK_ROWS);
    rows.write(packed(3 * WIDTH));
    expect(lightBlockOf(rows).rowsFor(3 * WIDTH)).toBe(LARGE_BLOCK_ROWS);
    rows.write(packed(9 * WIDTH));
    expect(lightBlockOf(rows).rowsFor(LARGE_BLOCK_ROWS)).toBe(LARGE_BLOCK_ROWS);
  });

  it('has a version that goes up with its numbers alone', () => {
    const rows = settled(10);
    const { version } = rows;
    rows.write(packed(10));
    expect(rows.version).toBe(version);
    rows.write(changed(10, 7));
    expect(rows.version).toBe(version + 1);
  });

  it('follows the rows into the memory that they grow into', () => {
    const rows = settled(10);
    rows.write(packed(2 * WIDTH));
    expect(sendBlock(rows).flatMap((piece) => [...piece])).toStrictEqual(floatsOf(packed(2 * WIDTH)));
    rows.write(changed(2 * WIDTH, 7));
    expect(sendBlock(rows)[0]![7]).toBe(-8);
  });
});

describe('what has changed', () => {
  it('does not include floats beyond the last row', () => {
    const rows = settled(10);
    rows.write(changed(10, 10 * 4));
    expect(sendBlock(rows)).toStrictEqual([]);
    draw(rows);
    expect(gpu.patches).toStrictEqual([]);
  });

  it('includes a value that differs by one bit', () => {
    const rows = settled(10);
    const next = packed(10);
    next.data[7] = 8 + 2 ** -20;
    rows.write(next);
    expect(sendBlock(rows)).toHaveLength(1);
    draw(rows);
    expect(gpu.patches).toHaveLength(1);
  });

  it('is nothing of what others write, once it was taken', () => {
    const rows = new LightRows();
    const pack = packed(10);
    rows.write(pack);
    pack.data[0] = 99;
    expect(sendBlock(rows)[0]![0]).toBe(1);
  });
});

describe('the texture', () => {
  it('is made once, and sent the rows that there are', () => {
    const rows = new LightRows();
    rows.write(packed(10));
    const texture = draw(rows);
    rows.write(packed(10, 2));
    expect(draw(rows)).toBe(texture);
    expect(gpu.textures).toBe(1);
    expect(gpu.patches).toStrictEqual([1, 2].map(() => ({ x: 0, y: 0, width: 10, height: 1 })));
    expect(rows.uploads).toBe(2);
  });

  it('is sent to no draw where nothing changed', () => {
    const rows = settled(10);
    const { uploads } = rows;
    for (let frame = 0; frame < 3; frame++) {
      rows.write(packed(10));
      draw(rows);
    }
    expect(gpu.patches).toStrictEqual([]);
    expect(rows.uploads).toBe(uploads);
  });

  it.each<[string, number[], object]>([
    ['one float', [4 * 5 + 2], { x: 5, y: 0, width: 1, height: 1 }],
    ['two rows and what lies between', [4 * 5, 4 * 9 + 3], { x: 5, y: 0, width: 5, height: 1 }],
    ['the last row of a line', [4 * (WIDTH - 1)], { x: WIDTH - 1, y: 0, width: 1, height: 1 }],
    ['the first row of the next line', [4 * WIDTH], { x: 0, y: 1, width: 1, height: 1 }],
    ['part of a later line', [4 * (2 * WIDTH + 7)], { x: 7, y: 2, width: 1, height: 1 }],
    ['across two lines', [4 * (WIDTH - 1), 4 * WIDTH], { x: 0, y: 0, width: WIDTH, height: 2 }],
    ['a whole line', [4 * WIDTH, 4 * (2 * WIDTH - 1)], { x: 0, y: 1, width: WIDTH, height: 1 }],
  ])('takes a change of %s by one call, of exactly that', (_, floats, patch) => {
    const rows = settled(3 * WIDTH);
    rows.write(changed(3 * WIDTH, ...floats));
    draw(rows);
    expect(gpu.patches).toStrictEqual([patch]);
  });

  it('sends the changes of several frames that drew without it by one call', () => {
    const rows = settled(100);
    rows.write(changed(100, 4 * 80));
    rows.write(changed(100, 4 * 80, 4 * 20));
    rows.write(changed(100, 4 * 80, 4 * 20, 4 * 30));
    draw(rows);
    expect(gpu.patches).toStrictEqual([{ x: 20, y: 0, width: 61, height: 1 }]);
  });

  it('is patched as it is: not flipped, not multiplied, by whole floats', () => {
    const rows = settled(10);
    rows.write(packed(10, 2));
    draw(rows);
    expect([...gpu.unpack]).toStrictEqual([
      [4, false],
      [5, false],
      [6, 4],
    ]);
  });

  it('has on the GPU, after any changes, what was written last', () => {
    const sizes = fc.oneof(fc.integer({ min: 1, max: 40 }), fc.integer({ min: WIDTH - 2, max: 3 * WIDTH }));
    const change = fc.record({ rows: sizes, first: fc.integer({ min: 1, max: 5 }), draws: fc.boolean() });
    fc.assert(
      fc.property(fc.array(change, { minLength: 1, maxLength: 12 }), (changes) => {
        gpu = new FakeRenderer();
        const rows = new LightRows();
        for (const { rows: count, first, draws } of changes) {
          const pack = packed(count, first);
          rows.write(pack);
          if (!draws) continue;
          const before = gpu.patches.length;
          const pixels = gpu.pixels(draw(rows));
          expect(gpu.patches.length - before).toBeLessThanOrEqual(1);
          expect(pixels.slice(0, count * 4)).toStrictEqual(floatsOf(pack));
        }
      }),
      { numRuns: 60 },
    );
  });

  it('grows by doubling, and frees the smaller one', () => {
    const rows = settled(10);
    const texture = draw(rows);
    const sizes = [WIDTH + 1, 2 * WIDTH, 2 * WIDTH + 1, 20 * WIDTH].map((count) => {
      rows.write(packed(count));
      return gpu.sizeOf(draw(rows));
    });
    expect(sizes).toStrictEqual([2, 2, 4, 20].map((height) => ({ width: WIDTH, height })));
    expect(gpu.textures).toBe(1);
    expect(draw(rows)).toBe(texture); // so that materials keep what they have been given
  });

  it('is made again where it grows by nothing but zeros', () => {
    const rows = settled(10);
    const pack = { ...packed(WIDTH + 1), data: new Float32Array((WIDTH + 1) * 4) };
    pack.data.set(packed(10).data.subarray(0, 40));
    rows.write(pack);
    expect(gpu.pixels(draw(rows)).slice(0, 40)).toStrictEqual(floatsOf(packed(10)));
  });

  it('stays for a scene that shrinks and grows again', () => {
    const rows = settled(2000);
    const size = gpu.sizeOf(draw(rows));
    rows.write(packed(10));
    rows.write(packed(2000));
    expect(gpu.sizeOf(draw(rows))).toStrictEqual(size);
    expect(gpu.patches).toStrictEqual([]);
  });
});

describe('a lost context', () => {
  it('sends everything again, block and texture', () => {
    const rows = settled(2000);
    const texture = draw(rows);
    expect(sendBlock(rows)).toStrictEqual([]);
    gpu.loseContext();
    rows.restore();
    expect(lightBlockOf(rows).group.uniforms).toHaveLength(4); // three.js measures the block anew before anything is sent
    expect(sendBlock(rows)).toHaveLength(4);
    expect(draw(rows)).toBe(texture);
    expect(gpu.pixels(texture).slice(0, 8000)).toStrictEqual(floatsOf(packed(2000)));
  });

  it('sends what was there before', () => {
    const rows = settled(200);
    rows.restore();
    const all = sendBlock(rows).flatMap((piece) => [...piece]);
    expect(all.slice(0, 800)).toStrictEqual(floatsOf(packed(200)));
  });
});

describe('what is given back', () => {
  it('is all that was taken', () => {
    const rows = settled(2000);
    const group = vi.spyOn(lightBlockOf(rows).group, 'dispose');
    rows.dispose();
    expect(gpu.textures).toBe(0);
    expect(group).toHaveBeenCalledTimes(1);
  });

  it('comes again with the next draw', () => {
    const rows = settled(2000);
    rows.dispose();
    expect(gpu.pixels(draw(rows)).slice(0, 8000)).toStrictEqual(floatsOf(packed(2000)));
    expect(sendBlock(rows)).toHaveLength(4);
  });
});
