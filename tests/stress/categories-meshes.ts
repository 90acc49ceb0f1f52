// Normals of meshes under any matrix: mirrored, flattened, sheared, scaled by 1e±12, through the shipped normal matrix.
import { Euler, Matrix3, Matrix4, Quaternion, Vector3 } from 'three';
import { normalMatrix } from '../../src/material/normal-matrix.js';
import { cross, dot, normalize, scale, type Vec3 } from '../../src/math/vector.js';
import type { StressCase } from './case.js';
import { categories } from './category.js';
import { anyLight, colors, seen, stressCase, surface } from './fragments.js';
import { float32, type Random } from './random.js';

const matrix3 = new Matrix3();

/** A mesh's matrix and a normal on it; `tangents` are two directions in the surface. */
function onMesh(random: Random, matrix: Matrix4): StressCase {
  const fragment = seen(random);
  const normal = float32(random.unit());
  const N = normalize(normal);
  const first = random.around(N, Math.PI / 2);
  normalMatrix(matrix, matrix3);
  return {
    ...stressCase({ ...fragment, normal }, surface(random, random.from(1, 64)), [
      anyLight(random, fragment.p, colors(random)),
    ]),
    normalMatrix: matrix3.elements.map(Math.fround),
    exactNormal: movedNormal(matrix, first, cross(N, first)),
  };
}

/**
 * The normal of a moved surface from what a normal is: across both moved tangents, which is the cofactor matrix
 * applied; a mirror turns the cross product round, and the determinant's sign turns it back.
 */
function movedNormal(matrix: Matrix4, first: Vec3, second: Vec3): Vec3 {
  const e = matrix.elements;
  const largest = Math.max(...e.slice(0, 11).map(Math.abs));
  if (largest === 0) return [0, 0, 0];
  const column = (i: number): Vec3 => [e[i]! / largest, e[i + 1]! / largest, e[i + 2]! / largest];
  const [x, y, z] = [column(0), column(4), column(8)];
  const through = (v: Vec3): Vec3 => [0, 1, 2].map((k) => x[k]! * v[0] + y[k]! * v[1] + z[k]! * v[2]) as never;
  const across = cross(through(first), through(second));
  return scale(normalize(across), dot(cross(x, y), z) < 0 ? -1 : 1);
}

function turned(random: Random, size: Vec3): Matrix4 {
  const turn = new Quaternion().setFromEuler(new Euler(...random.vector(-3, 3)));
  return new Matrix4().compose(new Vector3(), turn, new Vector3(...size));
}

const anySize = (random: Random): number => random.sign() * random.magnitude(0.1, 10);

/** As a mesh element can place one: turned, and scaled by as much as attributes allow. */
function placed(random: Random): StressCase {
  const uniform = random.pick([1e-12, 1e12, 1, random.magnitude(1e-12, 1e12)]);
  const size: Vec3 = [uniform * anySize(random), uniform * anySize(random), uniform * anySize(random)];
  return onMesh(random, turned(random, float32(size)));
}

/** Flattened along an axis, or nearly. */
function flattened(random: Random): StressCase {
  const size: [number, number, number] = [anySize(random), anySize(random), anySize(random)];
  size[random.pick([0, 1, 2])] = random.pick([0, 1e-12, -1e-12, 1e-6]);
  return onMesh(random, turned(random, size));
}

/** One inside another, both scaled unevenly: the inner one's axes are no longer square to each other. */
function sheared(random: Random): StressCase {
  const uneven = (): Matrix4 => turned(random, [anySize(random), anySize(random), anySize(random)]);
  return onMesh(random, uneven().multiply(uneven()));
}

export const meshCategories = categories({
  'mesh-scale': { title: 'meshes turned, mirrored and scaled, to 1e±12', make: placed },
  'mesh-flat': { title: 'meshes flattened along an axis', make: flattened },
  'mesh-shear': { title: 'meshes sheared by others that they are in', make: sheared },
});
