// Is only what changed sent to the GPU, and do keys change exactly when programs have to?

import fc from 'fast-check';
import type { ExternalTexture } from 'three';
import { beforeEach, describe, expect, it } from 'vitest';
import { TEXTURE_ROWS_LOG2 } from '../../src/light/light-layout.js';
import type { LightValues } from '../../src/light/light-state.js';
import { emptyPack, type PackedLights, packLights } from '../../src/light/pack-lights.js';
import { LightBuffer } from '../../src/material/light-buffer.js';
import { light } from './arbitraries.js';
import { FakeRenderer } from './fake-renderer.js';
import { WORLD } from './packed-reader.js';

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

/** Packs into the buffer. */
function write(buffer: LightBuffer, next: PackedLights): void {
  Object.assign(buffer.packed, next);
  buffer.changed();
}

/** A draw that reads the texture. */
const draw = (rows: LightBuffer): ExternalTexture => rows.sendTexture(gpu.renderer);

/** Rows that the GPU has seen. */
function settled(count: number): LightBuffer {
  const rows = new LightBuffer();
  write(rows, packed(count));
  draw(rows);
  gpu.patches = [];
  return rows;
}

const floatsOf = ({ data, rows }: PackedLights): number[] => [...data.slice(0, rows * 4)];

describe('the rows for a uniform array', () => {
  it('are a copy of what was packed, to the last row', () => {
    const rows = settled(10);
    expect([...rows.rows]).toStrictEqual(floatsOf(packed(10)));
    rows.packed.data[0] = 99;
    expect(rows.rows[0]).toBe(1);
    write(rows, packed(3 * WIDTH));
    expect([...rows.rows]).toStrictEqual(floatsOf(packed(3 * WIDTH)));
  });

  it('are the same array while their number stays', () => {
    const rows = settled(10);
    const { rows: array } = rows;
    write(rows, changed(10, 7));
    expect(rows.rows).toBe(array);
    expect(rows.rows[7]).toBe(-8);
  });
});

describe('the revision', () => {
  it('increases with every change of a number, and with nothing else', () => {
    const rows = settled(10);
    const { revision } = rows;
    write(rows, changed(10, 40));
    expect(rows.revision).toBe(revision);
    const next = packed(10);
    next.data[7] = 8 + 2 ** -20;
    write(rows, next);
    expect(rows.revision).toBeGreaterThan(revision);
  });

  it('increases when lights are removed', () => {
    const rows = new LightBuffer();
    packInto(rows, [light(), light()]);
    const { revision } = rows;
    packInto(rows, [light()]);
    expect(rows.revision).toBeGreaterThan(revision);
  });

  it('is no other buffer’s', () => {
    expect(settled(10).revision).not.toBe(settled(10).revision);
  });
});

const packInto = (buffer: LightBuffer, lights: readonly LightValues[]): void => {
  packLights(lights, WORLD, buffer.packed);
  buffer.changed();
};

describe('the feature key', () => {
  const lamp = { position: [1, 2, 3, 1] } as const;
  const keyOf = (...lights: Partial<LightValues>[]): string => {
    const buffer = new LightBuffer();
    packInto(buffer, lights.map(light));
    return buffer.featureKey;
  };

  it('does not change when lights move or change colour', () => {
    const moved = { position: [7, 8, 9, 1], diffuse: [9, 9, 9] } as const;
    expect(keyOf(moved, {})).toBe(keyOf(lamp, {}));
  });

  it.each<[string, Partial<LightValues>[]]>([
    ['one more light', [lamp, lamp]],
    ['another kind', [{}]],
    ['attenuation', [{ ...lamp, attenuation: [1, 1, 0] }]],
    ['a tint', [{ ...lamp, diffuse: [9, 8, 7] }]],
  ])('is another for %s', (_, lights) => {
    expect(keyOf(...lights)).not.toBe(keyOf(lamp));
  });
});

describe('the texture', () => {
  it('is created once, with all rows', () => {
    const rows = new LightBuffer();
    write(rows, packed(10));
    const texture = draw(rows);
    write(rows, packed(10, 2));
    expect(draw(rows)).toBe(texture);
    expect(gpu.textures).toBe(1);
    expect(gpu.patches).toStrictEqual([1, 2].map(() => ({ x: 0, y: 0, width: 10, height: 1 })));
  });

  it('does not repeat: a GPU takes twice as long to read a texture of floats that does', () => {
    settled(10);
    expect(gpu.sampling.get('wrap s')).toBe('clamp');
    expect(gpu.sampling.get('wrap t')).toBe('clamp');
  });

  it('is not sent again while nothing changes', () => {
    const rows = settled(10);
    for (let frame = 0; frame < 3; frame++) {
      write(rows, packed(10));
      draw(rows);
    }
    expect(gpu.patches).toStrictEqual([]);
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
    write(rows, changed(3 * WIDTH, ...floats));
    draw(rows);
    expect(gpu.patches).toStrictEqual([patch]);
  });

  it('receives the changes of several frames by one call', () => {
    const rows = settled(100);
    write(rows, changed(100, 4 * 80));
    write(rows, changed(100, 4 * 80, 4 * 20));
    write(rows, changed(100, 4 * 80, 4 * 20, 4 * 30));
    draw(rows);
    expect(gpu.patches).toStrictEqual([{ x: 20, y: 0, width: 61, height: 1 }]);
  });

  it('is written without flipping and without premultiplying', () => {
    const rows = settled(10);
    write(rows, packed(10, 2));
    draw(rows);
    expect([...gpu.unpack]).toStrictEqual([
      [4, false],
      [5, false],
      [6, 4],
    ]);
  });

  it('holds the latest rows on the GPU after any changes', () => {
    const sizes = fc.oneof(fc.integer({ min: 1, max: 40 }), fc.integer({ min: WIDTH - 2, max: 3 * WIDTH }));
    const change = fc.record({ rows: sizes, first: fc.integer({ min: 1, max: 5 }), draws: fc.boolean() });
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
      write(rows, packed(count));
      return gpu.sizeOf(draw(rows));
    });
    expect(sizes).toStrictEqual([2, 2, 4, 20].map((height) => ({ width: WIDTH, height })));
    expect(gpu.textures).toBe(1);
    expect(draw(rows)).toBe(texture); // so that materials keep what they have been given
  });

  it('is created again when it grows, even by zeros alone', () => {
    const rows = settled(10);
    const pack = { ...packed(WIDTH + 1), data: new Float32Array((WIDTH + 1) * 4) };
    pack.data.set(packed(10).data.subarray(0, 40));
    write(rows, pack);
    expect(gpu.pixels(draw(rows)).slice(0, 40)).toStrictEqual(floatsOf(packed(10)));
  });

  it('stays for a scene that shrinks and grows again', () => {
    const rows = settled(2000);
    const size = gpu.sizeOf(draw(rows));
    write(rows, packed(10));
    write(rows, packed(2000));
    expect(gpu.sizeOf(draw(rows))).toStrictEqual(size);
    expect(gpu.patches).toStrictEqual([]);
  });
});

describe('a buffer that was disposed of', () => {
  it('keeps the rows of lights that are switched off', () => {
    const rows = settled(20);
    write(rows, packed(10));
    rows.dispose();
    draw(rows);
    write(rows, packed(20));
    expect(gpu.pixels(draw(rows)).slice(0, 80)).toStrictEqual(floatsOf(packed(20)));
  });

  it('frees its texture, and sends everything with the next draw', () => {
    const rows = settled(2000);
    const texture = draw(rows);
    rows.dispose();
    expect(gpu.textures).toBe(0);
    expect(draw(rows)).toBe(texture);
    expect(gpu.pixels(texture).slice(0, 8000)).toStrictEqual(floatsOf(packed(2000)));
  });
});
