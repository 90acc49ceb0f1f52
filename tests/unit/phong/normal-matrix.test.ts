// Do normals get from model to shading space for every matrix that a mesh may have? Scales to 1e±12
// and float32: the stress categories of meshes.

import type { Vec3 } from '../../../src/phong/math/vector.js';
import fc from 'fast-check';
import { Euler, Matrix3, Matrix4, Quaternion, Vector3 } from 'three';
import { describe, expect, it } from 'vitest';
import { normalMatrix } from '../../../src/phong/material/normal-matrix.js';
import { between, plainVector, triple } from '../arbitraries.js';

function place(rotation: readonly number[], scale: readonly number[]) {
  const [x = 0, y = 0, z = 0] = rotation;
  const turn = new Quaternion().setFromEuler(new Euler(x, y, z));
  const [sx = 1, sy = 1, sz = 1] = scale;
  return new Matrix4().compose(new Vector3(5, -6, 7), turn, new Vector3(sx, sy, sz));
}

const normals = (model: Matrix4) => {
  const out = new Matrix3();
  normalMatrix(model, out);
  return out;
};

const through = (model: Matrix4, normal: Vec3) =>
  new Vector3(...normal).applyMatrix3(normals(model)).normalize();

const angles = triple(between(-4, 4));
const factor = fc.oneof(between(0.01, 100), between(-100, -0.01));
const near = (a: Vector3, b: Vector3) => {
  expect(a.distanceTo(b)).toBeLessThan(1e-9);
};

describe('the normal matrix', () => {
  it('agrees with the inverse transpose for every regular matrix, mirrored ones included', () => {
    fc.assert(
      fc.property(angles, triple(factor), plainVector, (rotation, scale, normal) => {
        const model = place(rotation, scale);
        const inverse = new Matrix3().setFromMatrix4(model).invert().transpose();
        near(through(model, normal), new Vector3(...normal).applyMatrix3(inverse).normalize());
      }),
    );
  });

  it.each([
    [0, [0, 2, 3]],
    [1, [2, 0, 3]],
    [2, [2, 3, 0]],
    [2, [-2, 3, 0]],
  ] as const)(
    'leaves the normals along axis %i alone where the scale %j flattens a mesh',
    (flat, scale) => {
      fc.assert(
        fc.property(angles, plainVector, (rotation, normal) => {
          const along = normal[flat];
          const got = new Vector3(...normal).applyMatrix3(normals(place(rotation, scale)));
          if (along === 0) {
            expect(got.length()).toBe(0);
            return;
          }
          const turned = new Vector3()
            .setComponent(flat, 1)
            .transformDirection(place(rotation, [1, 1, 1]));
          // The cofactors of the two scales that are left have their sign: it is the side that the
          // triangles face.
          const side =
            Math.sign(along) *
            Math.sign(scale.reduce((product, s) => (s === 0 ? product : product * s), 1));
          near(got.normalize(), turned.multiplyScalar(side));
        }),
      );
    },
  );

  it.each([[[1, 0, 0]], [[0, 0, 1]], [[0, 0, 0]]])(
    'is zero, never NaN, where the scale %j makes a mesh a line or a point',
    (scale) => {
      fc.assert(
        fc.property(angles, (rotation) => {
          expect(normals(place(rotation, scale)).elements.every((x) => x === 0)).toBe(true);
        }),
        { numRuns: 50 },
      );
    },
  );

  it('is finite for entries of any size and sign, mixed at will', () => {
    const size = between(5e-324, 1e27);
    const entry = fc.oneof(
      size,
      size.map((x) => -x),
      fc.constantFrom(0, 1, -1, 1e-12, 1e12),
    );
    fc.assert(
      fc.property(fc.array(entry, { minLength: 16, maxLength: 16 }), (entries) => {
        expect(normals(new Matrix4().fromArray(entries)).elements.every(Number.isFinite)).toBe(
          true,
        );
      }),
    );
  });
});
