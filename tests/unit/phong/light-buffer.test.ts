// Is only what changed sent to the GPU?

import fc from 'fast-check';
import { beforeEach, describe, expect, it } from 'vitest';
import { TEXTURE_ROWS_LOG2 } from '../../../src/phong/light/light-layout.js';
import { emptyPack, type PackedLights } from '../../../src/phong/light/pack-lights.js';
import { LightBuffer } from '../../../src/phong/material/light-buffer.js';
import { FakeRenderer } from '../fake-renderer.js';

const WIDTH = 2 ** TEXTURE_ROWS_LOG2;

let gpu = new FakeRenderer();
beforeEach(() => {
  gpu = new FakeRenderer();
});

/** Rows that all differ, each float from the next. */
const packed = (rows: number, first = 1) => ({
  ...emptyPack(),
  data: Float32Array.from({ length: rows * 4 + 8 }, (_, i) => first + i),
  rows,
});

/** Packs into the buffer. */
function write(buffer: LightBuffer, next: PackedLights) {
  Object.assign(buffer.packed, next);
  buffer.changed();
}

/** A draw that reads the texture. */
const draw = (rows: LightBuffer) => rows.sendTexture(gpu.renderer);

/** Rows that the GPU has seen. */
function settled(count: number) {
  const rows = new LightBuffer();
  write(rows, packed(count));
  draw(rows);
  gpu.patches = [];
  return rows;
}

describe('the texture', () => {
  it('does not repeat: a GPU takes twice as long to read a texture of floats that does', () => {
    settled(10);
    expect(gpu.sampling.get('wrap s')).toBe('clamp');
    expect(gpu.sampling.get('wrap t')).toBe('clamp');
  });

  it.each([
    ['one float', [4 * 5 + 2], { x: 5, y: 0, width: 1, height: 1 }],
    ['two rows and what lies between', [4 * 5, 4 * 9 + 3], { x: 5, y: 0, width: 5, height: 1 }],
    ['part of a later line', [4 * (2 * WIDTH + 7)], { x: 7, y: 2, width: 1, height: 1 }],
    ['across two lines', [4 * (WIDTH - 1), 4 * WIDTH], { x: 0, y: 0, width: WIDTH, height: 2 }],
    ['a whole line', [4 * WIDTH, 4 * (2 * WIDTH - 1)], { x: 0, y: 1, width: WIDTH, height: 1 }],
  ])('takes a change of %s by one call, of exactly that', (_, floats, patch) => {
    const rows = settled(3 * WIDTH);
    const pack = packed(3 * WIDTH);
    for (const i of floats) {
      pack.data[i] = -1 - i;
    }
    write(rows, pack);
    draw(rows);
    expect(gpu.patches).toStrictEqual([patch]);
  });

  it('holds the latest rows on the GPU after any changes', () => {
    const sizes = fc.oneof(
      fc.integer({ min: 1, max: 40 }),
      fc.integer({ min: WIDTH - 2, max: 3 * WIDTH }),
    );
    const change = fc.record({
      rows: sizes,
      first: fc.integer({ min: 1, max: 5 }),
      draws: fc.boolean(),
    });
    fc.assert(
      fc.property(fc.array(change, { minLength: 1, maxLength: 12 }), (changes) => {
        gpu = new FakeRenderer();
        const rows = new LightBuffer();
        for (const { rows: count, first, draws } of changes) {
          const pack = packed(count, first);
          write(rows, pack);
          if (!draws) continue;
          const before = gpu.patches.length;
          const pixels = gpu.pixels(draw(rows));
          expect(gpu.patches.length - before).toBeLessThanOrEqual(1);
          expect(pixels.slice(0, count * 4)).toStrictEqual([...pack.data.slice(0, count * 4)]);
        }
      }),
      { numRuns: 60 },
    );
  });

  it('grows by doubling, and frees the smaller one', () => {
    const rows = settled(10);
    const texture = draw(rows);
    const sizes = [WIDTH + 1, 2 * WIDTH, 2 * WIDTH + 1, 20 * WIDTH].map((count) => {
      write(rows, packed(count));
      return gpu.sizeOf(draw(rows));
    });
    expect(sizes).toStrictEqual([2, 2, 4, 20].map((height) => ({ width: WIDTH, height })));
    expect(gpu.textures).toBe(1);
    expect(draw(rows)).toBe(texture); // so that materials keep what they have been given
  });
});
