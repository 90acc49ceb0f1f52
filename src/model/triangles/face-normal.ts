// Twice the area of a triangle as a vector along its normal, in float64; the side from which its corners turn left is
// outside.

export interface FaceVector {
  x: number;
  y: number;
  z: number;
}

/**
 * Writes the cross product of two edges to `out` and returns its length. `a`, `b` and `c` are the corners' places in
 * `positions`.
 */
export function faceVector(
  positions: Float32Array,
  a: number,
  b: number,
  c: number,
  out: FaceVector,
): number {
  const ax = positions[a] ?? 0;
  const ay = positions[a + 1] ?? 0;
  const az = positions[a + 2] ?? 0;
  const ux = (positions[b] ?? 0) - ax;
  const uy = (positions[b + 1] ?? 0) - ay;
  const uz = (positions[b + 2] ?? 0) - az;
  const vx = (positions[c] ?? 0) - ax;
  const vy = (positions[c + 1] ?? 0) - ay;
  const vz = (positions[c + 2] ?? 0) - az;
  out.x = uy * vz - uz * vy;
  out.y = uz * vx - ux * vz;
  out.z = ux * vy - uy * vx;
  return Math.hypot(out.x, out.y, out.z);
}
