// How large is a geometry? three.js would find out in the first frame, in one task. Knows no format.
import { Box3, type BufferGeometry, Sphere, Vector3 } from 'three';
import type { Slices } from './slices.js';

/** Sets the box and the sphere of a geometry with plain, finite positions. */
export async function setBounds(geometry: BufferGeometry, slices: Slices): Promise<void> {
  const { array, count } = geometry.getAttribute('position');
  const box = new Box3();
  const point = new Vector3();
  await slices.over(count, (from, to) => {
    for (let i = from; i < to; i += 1) box.expandByPoint(point.fromArray(array, i * 3));
  });
  const center = box.getCenter(new Vector3());
  let farthest = 0;
  await slices.over(count, (from, to) => {
    for (let i = from; i < to; i += 1) {
      farthest = Math.max(farthest, center.distanceToSquared(point.fromArray(array, i * 3)));
    }
  });
  geometry.boundingBox = box;
  geometry.boundingSphere = new Sphere(center, Math.sqrt(farthest));
}
