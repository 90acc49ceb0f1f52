// Fits a shape into the unit box: centred on the origin, largest extent 1. Normals keep their directions.
import type { BufferGeometry } from 'three';

/** Scales (uniformly) and moves the positions in place, in float64 until the last rounding. */
export function fitToUnitBox(geometry: BufferGeometry): BufferGeometry {
  const position = geometry.getAttribute('position');
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < position.count; i += 1) {
    for (let axis = 0; axis < 3; axis += 1) {
      const value = position.getComponent(i, axis);
      low[axis] = Math.min(low[axis] ?? value, value);
      high[axis] = Math.max(high[axis] ?? value, value);
    }
  }
  const extent = low.map((value, axis) => (high[axis] ?? value) - value);
  const center = low.map((value, axis) => ((high[axis] ?? value) + value) / 2);
  const scale = 1 / Math.max(...extent);
  for (let i = 0; i < position.count; i += 1) {
    for (let axis = 0; axis < 3; axis += 1) {
      position.setComponent(i, axis, (position.getComponent(i, axis) - (center[axis] ?? 0)) * scale);
    }
  }
  geometry.boundingBox = null;
  geometry.boundingSphere = null;
  return geometry;
}
