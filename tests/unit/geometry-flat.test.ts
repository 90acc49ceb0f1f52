// Does a flat copy carry each triangle's own normal, whatever form the source's attributes have?
import {
  BoxGeometry,
  BufferAttribute,
  BufferGeometry,
  InterleavedBuffer,
  InterleavedBufferAttribute,
  SphereGeometry,
} from 'three';
import { describe, expect, it, vi } from 'vitest';
import { flatGeometry } from '../../src/material/flat-geometry.js';

const TRIANGLE = [0, 0, 0, 2, 0, 0, 0, 3, 0];

function fromPositions(values: readonly number[]): BufferGeometry {
  return new BufferGeometry().setAttribute('position', new BufferAttribute(new Float32Array(values), 3));
}

const listed = (geometry: BufferGeometry, name: string): number[] =>
  Array.from(geometry.getAttribute(name).array);

describe('flatGeometry', () => {
  it('gives the corners of a triangle its own unit normal, by its winding', () => {
    const flat = flatGeometry(fromPositions(TRIANGLE));
    expect(flat.index).toBeNull();
    expect(listed(flat, 'normal')).toEqual([0, 0, 1, 0, 0, 1, 0, 0, 1]);
    expect(listed(flat, 'position')).toEqual(TRIANGLE);
  });

  it('expands an index and keeps texture coordinates and colours', () => {
    const source = fromPositions([0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0]);
    source.setIndex([0, 1, 2, 2, 3, 0]);
    source.setAttribute('uv', new BufferAttribute(new Float32Array([0, 0, 1, 0, 1, 1, 0, 1]), 2));
    source.setAttribute(
      'color',
      new BufferAttribute(new Uint8Array([255, 0, 0, 0, 255, 0, 0, 0, 255, 51, 51, 51]), 3, true),
    );
    const flat = flatGeometry(source);
    expect(listed(flat, 'uv')).toEqual([0, 0, 1, 0, 1, 1, 1, 1, 0, 1, 0, 0]);
    const color = flat.getAttribute('color');
    expect([color.getX(4), color.getY(4), color.getZ(4)]).toEqual([0.2, 0.2, 0.2]);
  });

  it('reads interleaved and normalised positions', () => {
    const buffer = new InterleavedBuffer(new Int16Array([0, 0, 0, 9, 32767, 0, 0, 9, 0, 32767, 0, 9]), 4);
    const source = new BufferGeometry();
    source.setAttribute('position', new InterleavedBufferAttribute(buffer, 3, 0, true));
    const flat = flatGeometry(source);
    const position = flat.getAttribute('position');
    const places = [0, 1, 2].map((i) => [position.getX(i), position.getY(i), position.getZ(i)]);
    expect(places).toEqual([[0, 0, 0], [1, 0, 0], [0, 1, 0]]); // prettier-ignore
    expect(listed(flat, 'normal').slice(0, 3)).toEqual([0, 0, 1]);
  });

  it('gives a triangle without area a zero normal', () => {
    const flat = flatGeometry(fromPositions([1, 1, 1, 2, 2, 2, 3, 3, 3]));
    expect(listed(flat, 'normal')).toEqual(new Array(9).fill(0));
  });

  it('keeps the direction of triangles as small or large as float32 allows', () => {
    for (const size of [1e-30, 1e15]) {
      const flat = flatGeometry(fromPositions(TRIANGLE.map((v) => v * size)));
      expect(listed(flat, 'normal').slice(0, 3)).toEqual([0, 0, 1]);
    }
  });

  it('points every face of a box and a sphere outward', () => {
    for (const source of [new BoxGeometry(), new SphereGeometry(1, 16, 8)]) {
      const flat = flatGeometry(source);
      const position = flat.getAttribute('position');
      const normal = flat.getAttribute('normal');
      for (let i = 0; i < position.count; i += 1) {
        const outward =
          position.getX(i) * normal.getX(i) +
          position.getY(i) * normal.getY(i) +
          position.getZ(i) * normal.getZ(i);
        expect(outward).toBeGreaterThan(0);
      }
    }
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
