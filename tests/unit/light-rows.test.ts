// Packed lights on their way to the GPU: only what changed waits, and the storage follows the number of rows.

import { DataTexture } from 'three';
import { describe, expect, it, vi } from 'vitest';
import { BLOCK_ROWS, TEXTURE_ROWS_LOG2 } from '../../src/light/light-layout.js';
import type { PackedLights } from '../../src/light/pack-lights.js';
import { LightRows } from '../../src/material/light-rows.js';

const PIECE_ROWS = 64;
const WIDTH = 2 ** TEXTURE_ROWS_LOG2;

/** Rows that all differ, each float from the next. */
function packed(rows: number, first = 1): PackedLights {
  return { data: Float32Array.from({ length: rows * 4 + 8 }, (_, i) => first + i), rows, active: 0, sent: 0 };
}

/** Which pieces of the block would be sent in this frame; sending them, as three.js does, by reading their values. */
function send(rows: LightRows): Float32Array[] {
  rows.prepare();
  return rows.group.uniforms.map((uniform) => (uniform as { value: Float32Array }).value);
}

const settled = (count: number): LightRows => {
  const rows = new LightRows();
  rows.write(packed(count));
  send(rows);
  return rows;
};

describe('the uniform block', () => {
  it('is sent whole at first, so that the GPU has all of its 16 KiB', () => {
    const rows = new LightRows();
    const pieces = send(rows);
    expect(pieces.reduce((sum, piece) => sum + piece.length, 0)).toBe(BLOCK_ROWS * 4);
    expect(send(rows)).toStrictEqual([]);
  });

  it('holds the rows in order, across pieces', () => {
    const rows = new LightRows();
    rows.write(packed(200));
    const all = send(rows).flatMap((piece) => [...piece]);
    expect(all.slice(0, 800)).toStrictEqual([...packed(200).data.slice(0, 800)]);
    expect(all.slice(800).every((x) => x === 0)).toBe(true);
  });

  it('sends nothing where nothing changed, and does not count it', () => {
    const rows = settled(200);
    expect(rows.uploads).toBe(1);
    rows.write(packed(200));
    expect(send(rows)).toStrictEqual([]);
    expect(rows.uploads).toBe(1);
  });

  it('sends only the piece that changed', () => {
    const rows = settled(200);
    const next = packed(200);
    next.data[(PIECE_ROWS + 3) * 4] = -1;
    rows.write(next);
    const pieces = send(rows);
    expect(pieces).toHaveLength(1);
    expect(pieces[0]![3 * 4]).toBe(-1);
    expect(rows.uploads).toBe(2);
  });

  it('keeps what waits until it is read, however many frames that takes', () => {
    const rows = settled(10);
    rows.write(packed(10, 5));
    rows.prepare();
    rows.prepare();
    expect(rows.group.uniforms).toHaveLength(1);
    expect(send(rows)).toHaveLength(1);
    expect(send(rows)).toStrictEqual([]);
  });

  it('does not look at floats beyond the last row', () => {
    const rows = settled(10);
    const next = packed(10);
    next.data[10 * 4] = -1;
    rows.write(next);
    expect(send(rows)).toStrictEqual([]);
  });

  it('sees a value that differs by one bit', () => {
    const rows = settled(10);
    const next = packed(10);
    next.data[7] = 8 + 2 ** -20;
    rows.write(next);
    expect(send(rows)).toHaveLength(1);
  });
});

describe('the texture', () => {
  it('takes over above what the block holds, and hands back below', () => {
    const rows = new LightRows();
    rows.write(packed(BLOCK_ROWS));
    expect(rows.storage).toBe('block');
    expect(rows.texture.value).toBeNull();
    rows.write(packed(BLOCK_ROWS + 1));
    expect(rows.storage).toBe('texture');
    rows.write(packed(BLOCK_ROWS, 7));
    expect(rows.storage).toBe('block');
    expect(send(rows)[0]![0]).toBe(7);
  });

  it('has a row of lights to a texel, by shift and mask', () => {
    const rows = new LightRows();
    const many = packed(3 * WIDTH + 5);
    rows.write(many);
    const { image } = rows.texture.value!;
    expect(image.width).toBe(WIDTH);
    expect(image.height).toBeGreaterThanOrEqual(4);
    const data = image.data as Float32Array;
    expect(data).toHaveLength(image.width * image.height * 4);
    for (const row of [0, WIDTH - 1, WIDTH, 3 * WIDTH + 4]) {
      const texel = ((row >> TEXTURE_ROWS_LOG2) * image.width + (row & (WIDTH - 1))) * 4;
      expect(data[texel]).toBe(many.data[row * 4]);
      expect(data[texel + 3]).toBe(many.data[row * 4 + 3]);
    }
  });

  it('is sent again only where a row changed', () => {
    const rows = new LightRows();
    rows.write(packed(2000));
    const texture = rows.texture.value!;
    const { version } = texture;
    rows.write(packed(2000));
    expect(texture.version).toBe(version);
    rows.write(packed(2000, 2));
    expect(rows.texture.value).toBe(texture);
    expect(texture.version).toBe(version + 1);
    expect(rows.uploads).toBe(2);
  });

  it('grows by doubling, and frees the smaller one', () => {
    const rows = new LightRows();
    rows.write(packed(1500));
    const first = rows.texture.value!;
    const freed = vi.fn();
    first.addEventListener('dispose', freed);
    rows.write(packed(2 * WIDTH + 1));
    const second = rows.texture.value!;
    expect(freed).toHaveBeenCalledTimes(1);
    expect(second.image.height).toBe(4);
    rows.write(packed(4 * WIDTH));
    expect(rows.texture.value).toBe(second);
  });

  it('stays for a scene that shrinks and grows again', () => {
    const rows = new LightRows();
    rows.write(packed(2000));
    const texture = rows.texture.value;
    rows.write(packed(10));
    rows.write(packed(2000));
    expect(rows.texture.value).toBe(texture);
  });
});

describe('a lost context', () => {
  it('sends everything again, block and texture', () => {
    const rows = new LightRows();
    rows.write(packed(2000));
    rows.write(packed(200));
    send(rows);
    const { version } = rows.texture.value!;
    rows.restore();
    expect(send(rows)).toHaveLength(BLOCK_ROWS / PIECE_ROWS);
    expect(rows.texture.value!.version).toBe(version + 1);
  });

  it('sends what was there before', () => {
    const rows = settled(200);
    rows.restore();
    const all = send(rows).flatMap((piece) => [...piece]);
    expect(all.slice(0, 800)).toStrictEqual([...packed(200).data.slice(0, 800)]);
  });
});

it('gives back all that it took', () => {
  const rows = new LightRows();
  rows.write(packed(2000));
  const freed = vi.spyOn(DataTexture.prototype, 'dispose');
  const group = vi.spyOn(rows.group, 'dispose');
  rows.dispose();
  expect(freed).toHaveBeenCalledTimes(1);
  expect(group).toHaveBeenCalledTimes(1);
  freed.mockRestore();
});
