// Measures a model's geometries in slices. The first frame would do it in one task.
import { Box3, type BufferGeometry, Sphere, Vector3 } from 'three';
import { findExtremePoints } from './extreme-points.js';
import type { Model } from './model.js';
import { Slices } from './slices.js';

/** Computes all bounds that framing and culling will need. @throws the signal's reason after an abort. */
export async function measureModel({ parts }: Model, signal: AbortSignal): Promise<void> {
  const slices = new Slices(signal);
  for (const geometry of new Set(parts.map((part) => part.geometry))) {
    if (geometry.boundingSphere === null) await setBounds(geometry, slices);
    await findExtremePoints(geometry, () => (slices.due ? slices.pause() : null));
  }
}

/** Sets the box and the sphere of a geometry with plain, finite positions. */
async function setBounds(geometry: BufferGeometry, slices: Slices): Promise<void> {
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
