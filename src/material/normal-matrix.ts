// Normals from model to shading space: the cofactor matrix, which unlike the inverse transpose is defined for
// flattened meshes, times the determinant's sign, which keeps normals outside on mirrored ones. Float64, scaled to
// a largest entry of 1, so that any scale fits a float32. See shared formulas: cofactor(M) = det(M) · M^-T.
import type { Matrix3, Matrix4 } from 'three';

/** Writes the normal matrix of `model` into `out`; zero where the model is flattened to a line or a point. */
export function normalMatrix(model: Matrix4, out: Matrix3): void {
  const m = model.elements;
  // Entries are scaled first: the products of a mesh scaled by 1e±12 stay far from a double's ends either way.
  const largest = Math.max(
    Math.abs(m[0]), Math.abs(m[1]), Math.abs(m[2]),
    Math.abs(m[4]), Math.abs(m[5]), Math.abs(m[6]),
    Math.abs(m[8]), Math.abs(m[9]), Math.abs(m[10]),
  ); // prettier-ignore
  const s = largest > 0 ? 1 / largest : 0;
  const a = m[0] * s, b = m[1] * s, c = m[2] * s; // prettier-ignore
  const d = m[4] * s, e = m[5] * s, f = m[6] * s; // prettier-ignore
  const g = m[8] * s, h = m[9] * s, i = m[10] * s; // prettier-ignore
  const c0 = e * i - f * h, c1 = f * g - d * i, c2 = d * h - e * g; // prettier-ignore
  const c3 = h * c - i * b, c4 = i * a - g * c, c5 = g * b - h * a; // prettier-ignore
  const c6 = b * f - c * e, c7 = c * d - a * f, c8 = a * e - b * d; // prettier-ignore
  const determinant = a * c0 + b * c1 + c * c2;
  const top = Math.max(
    Math.abs(c0), Math.abs(c1), Math.abs(c2), Math.abs(c3), Math.abs(c4), Math.abs(c5),
    Math.abs(c6), Math.abs(c7), Math.abs(c8),
  ); // prettier-ignore
  const k = top > 0 ? (determinant < 0 ? -1 : 1) / top : 0;
  out.set(c0 * k, c3 * k, c6 * k, c1 * k, c4 * k, c7 * k, c2 * k, c5 * k, c8 * k);
}
