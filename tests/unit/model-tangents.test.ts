// Do computed tangents agree with three.js's own, which follow the same published method?
import type { BufferGeometry } from 'three';
import { SphereGeometry, Vector4 } from 'three';
import { describe, expect, it } from 'vitest';
import { addTangents } from '../../src/scene/model/gltf/tangents.js';
import { Slices } from '../../src/scene/model/slices.js';

const slices = (): Slices => new Slices(new AbortController().signal);

const vectors = (geometry: BufferGeometry): Vector4[] => {
  const { array, count } = geometry.getAttribute('tangent');
  return Array.from({ length: count }, (_, i) => new Vector4().fromArray(array, 4 * i));
};

const sphere = (): BufferGeometry => new SphereGeometry(1, 20, 10);
const mirrored = (): BufferGeometry => {
  const geometry = sphere();
  const { array } = geometry.getAttribute('uv');
  for (let i = 0; i < array.length; i += 2) array[i]! *= -1;
  return geometry;
};

describe('computed tangents', () => {
  it.each([
    ['a sphere', sphere()],
    ['a sphere with a mirrored picture', mirrored()],
    ['separate triangles', sphere().toNonIndexed()],
  ])('are those of three.js on %s', async (_, geometry) => {
    const theirs = geometry.clone();
    if (theirs.index === null) theirs.setIndex(Array.from({ length: theirs.getAttribute('position').count }, (_, i) => i)); // prettier-ignore
    theirs.computeTangents();
    await addTangents(geometry, 'uv', slices());
    const ours = vectors(geometry);
    for (const [i, expected] of vectors(theirs).entries()) {
      const used = expected.w !== 0; // the poles of a sphere have vertices without triangles
      if (used) expect(ours[i]!.sub(expected).length()).toBeLessThan(1e-6);
    }
  });

  it('are zero where the texture coordinates give no direction', async () => {
    const geometry = sphere();
    geometry.getAttribute('uv').array.fill(0.5);
    await addTangents(geometry, 'uv', slices());
    expect(vectors(geometry).every(({ x, y, z, w }) => x === 0 && y === 0 && z === 0 && w === 1)).toBe(true);
  });
});
