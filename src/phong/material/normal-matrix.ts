// Normals from model to shading space: the cofactor matrix, which unlike the inverse transpose is
// defined for flattened meshes, times the determinant's sign, which keeps normals outside on
// mirrored ones. Float64, scaled to a largest entry of 1, so that any scale fits a float32.
// cofactor(M) = det(M) · M^-T.
import type { Matrix3, Matrix4 } from 'three';

/**
 * Writes the normal matrix of `model` into `out`; zero where the model is flattened to a line or a
 * point.
 */
export function normalMatrix(model: Matrix4, out: Matrix3): void {
  const m = model.elements;
  // Entries are scaled first: the products of a mesh scaled by 1e±12 stay far from a double's ends
  // either way.
  const largest = Math.max(
    Math.abs(m[0]),
    Math.abs(m[1]),
    Math.abs(m[2]),
    Math.abs(m[4]),
    Math.abs(m[5]),
    Math.abs(m[6]),
    Math.abs(m[8]),
    Math.abs(m[9]),
    Math.abs(m[10]),
  );
  if (!(largest > 0)) {
    out.elements.fill(0);
    return;
  }
  // Divided, not multiplied by 1/largest: that would overflow for the smallest scales of the
  // domain.
  const a = m[0] / largest,
    b = m[1] / largest,
    c = m[2] / largest;
  const d = m[4] / largest,
    e = m[5] / largest,
    f = m[6] / largest;
  const g = m[8] / largest,
    h = m[9] / largest,
    i = m[10] / largest;
  const c0 = e * i - f * h,
    c1 = f * g - d * i,
    c2 = d * h - e * g;
  const c3 = h * c - i * b,
    c4 = i * a - g * c,
    c5 = g * b - h * a;
  const c6 = b * f - c * e,
    c7 = c * d - a * f,
    c8 = a * e - b * d;
  const determinant = a * c0 + b * c1 + c * c2;
  out.set(c0, c3, c6, c1, c4, c7, c2, c5, c8);
  const { elements } = out;
  let top = 0;
  for (let k = 0; k < 9; k++) {
    top = Math.max(top, Math.abs(elements[k]!));
  }
  // Flattened to a line or a point: no normal is left.
  const signed = top > 0 ? (determinant < 0 ? -top : top) : 1;
  for (let k = 0; k < 9; k++) {
    elements[k]! /= signed;
  }
}
