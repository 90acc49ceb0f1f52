// 4×4 matrices by columns.
import type { Vec3 } from '../../src/phong/math/vector.js';

export const translation = ([x, y, z]: Vec3): readonly number[] => [
  ...[1, 0, 0, 0],
  ...[0, 1, 0, 0],
  ...[0, 0, 1, 0],
  ...[x, y, z, 1],
];

export const IDENTITY = translation([0, 0, 0]);
