// Does a flat copy carry each triangle's own normal, whatever form the source's attributes have?
import {
  BufferAttribute,
  BufferGeometry,
  InterleavedBuffer,
  InterleavedBufferAttribute,
} from 'three';
import { describe, expect, it, vi } from 'vitest';
import { updateFlatGeometry } from '../../../src/extras/models/mesh-animation.js';
import { flatGeometry } from '../../../src/phong/material/flat-geometry.js';

const TRIANGLE = [0, 0, 0, 2, 0, 0, 0, 3, 0];

function fromPositions(values: readonly number[]) {
  return new BufferGeometry().setAttribute(
    'position',
    new BufferAttribute(new Float32Array(values), 3),
  );
}

const listed = (geometry: BufferGeometry, name: string) =>
  Array.from(geometry.getAttribute(name).array);

describe('flatGeometry', () => {
  it.each([
    ['a triangle its own unit normal, by its winding', TRIANGLE, 1],
    ['a triangle wound the other way the opposite one', [0, 0, 0, 0, 3, 0, 2, 0, 0], -1],
    ['a triangle as small as float32 allows its direction', TRIANGLE.map((x) => x * 1e-30), 1],
    ['a triangle as large as float32 allows its direction', TRIANGLE.map((x) => x * 1e15), 1],
    ['a triangle without area a zero normal', [1, 1, 1, 2, 2, 2, 3, 3, 3], 0],
  ])('gives the corners of %s', (_, positions, z) => {
    const flat = flatGeometry(fromPositions(positions));
    expect(flat.index).toBeNull();
    expect(listed(flat, 'normal')).toEqual([0, 0, z, 0, 0, z, 0, 0, z]);
    expect(flat.getAttribute('position').array).toEqual(new Float32Array(positions));
  });

  it('expands an index, with a normal for each triangle, and keeps texture coordinates and colours', () => {
    const source = fromPositions([0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0]);
    source.setIndex([0, 1, 2, 0, 3, 2]);
    source.setAttribute('uv', new BufferAttribute(new Float32Array([0, 0, 1, 0, 1, 1, 0, 1]), 2));
    source.setAttribute(
      'color',
      new BufferAttribute(new Uint8Array([255, 0, 0, 0, 255, 0, 0, 0, 255, 51, 51, 51]), 3, true),
    );
    const flat = flatGeometry(source);
    expect(listed(flat, 'normal').filter((_, i) => i % 3 === 2)).toEqual([1, 1, 1, -1, -1, -1]);
    expect(listed(flat, 'uv')).toEqual([0, 0, 1, 0, 1, 1, 0, 0, 0, 1, 1, 1]);
    const color = flat.getAttribute('color');
    expect([color.getX(4), color.getY(4), color.getZ(4)]).toEqual([0.2, 0.2, 0.2]);
    // Joints that mirror a triangle turn it.
    source.index!.array.set([0, 2, 1]);
    source.index!.needsUpdate = true;
    updateFlatGeometry(flat, source);
    expect(listed(flat, 'uv')).toEqual([0, 0, 1, 1, 1, 0, 0, 0, 0, 1, 1, 1]);
  });

  it('reads interleaved and normalised positions', () => {
    const buffer = new InterleavedBuffer(
      new Int16Array([0, 0, 0, 9, 32767, 0, 0, 9, 0, 32767, 0, 9]),
      4,
    );
    const source = new BufferGeometry();
    source.setAttribute('position', new InterleavedBufferAttribute(buffer, 3, 0, true));
    const flat = flatGeometry(source);
    const position = flat.getAttribute('position');
    const places = [0, 1, 2].map((i) => [position.getX(i), position.getY(i), position.getZ(i)]);
    expect(places).toEqual([[0, 0, 0], [1, 0, 0], [0, 1, 0]]); // oxfmt-ignore
    expect(listed(flat, 'normal').slice(0, 3)).toEqual([0, 0, 1]);
  });

  it('makes one copy per source, which is freed with the source', () => {
    const source = fromPositions(TRIANGLE);
    const flat = flatGeometry(source);
    const dispose = vi.spyOn(flat, 'dispose');
    expect(flatGeometry(source)).toBe(flat);
    source.dispose();
    expect(dispose).toHaveBeenCalledTimes(1);
    // Sources are drawn again after their GPU memory was given back, and so are their copies.
    expect(flatGeometry(source)).toBe(flat);
    source.dispose();
    expect(dispose).toHaveBeenCalledTimes(2);
  });
});
