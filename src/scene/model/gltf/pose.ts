// Where are the vertices of a skinned mesh? Skinned meshes are not animated: the file's pose is applied once, at load. In: positions
// and normals of the mesh. Out: positions and normals in the model's space.
import { BufferAttribute, Matrix4, type Skeleton } from 'three';
import type { Slices } from '../slices.js';
import { type Attribute, unitNormals } from './attributes.js';

export interface Posed {
  readonly position: BufferAttribute;
  readonly normal: BufferAttribute | null;
}

export interface Bound {
  readonly position: Attribute;
  readonly normal: Attribute | null;
  readonly joints: Attribute;
  readonly weights: Attribute;
}

export type BoneMatrices = readonly (readonly number[])[];

/** Blends bone matrices in float64. Normals use the cofactors of the blend, which are right for any scale, including 0. */
export async function posed(bound: Bound, bones: BoneMatrices, slices: Slices): Promise<Posed> {
  const { position, normal, joints, weights } = bound;
  const positions = new Float32Array(position.count * 3);
  const normals = normal && new Float32Array(position.count * 3);
  const blend = new Array<number>(16);
  await slices.over(position.count, (from, to) => {
    for (let i = from; i < to; i += 1) {
      blend.fill(0);
      for (let k = 0; k < 4; k += 1) {
        const weight = weights.getComponent(i, k);
        const bone = weight > 0 ? bones[joints.getComponent(i, k)] : undefined;
        if (bone) for (let j = 0; j < 16; j += 1) blend[j] = (blend[j] ?? 0) + weight * (bone[j] ?? 0);
      }
      const [a, b, c, , d, e, f, , g, h, j, , tx, ty, tz] = blend as Sixteen;
      const x = position.getX(i);
      const y = position.getY(i);
      const z = position.getZ(i);
      positions[i * 3] = a * x + d * y + g * z + tx;
      positions[i * 3 + 1] = b * x + e * y + h * z + ty;
      positions[i * 3 + 2] = c * x + f * y + j * z + tz;
      if (!normal || !normals) continue;
      const nx = normal.getX(i);
      const ny = normal.getY(i);
      const nz = normal.getZ(i);
      const sign = Math.sign(a * (e * j - f * h) - d * (b * j - c * h) + g * (b * f - c * e)) || 1;
      normals[i * 3] = sign * ((e * j - f * h) * nx + (c * h - b * j) * ny + (b * f - c * e) * nz);
      normals[i * 3 + 1] = sign * ((f * g - d * j) * nx + (a * j - c * g) * ny + (c * d - a * f) * nz);
      normals[i * 3 + 2] = sign * ((d * h - e * g) * nx + (b * g - a * h) * ny + (a * e - b * d) * nz);
    }
  });
  return {
    position: new BufferAttribute(positions, 3),
    normal: normals && (await unitNormals(new BufferAttribute(normals, 3), slices)),
  };
}

type Sixteen = [
  ...[number, number, number, number],
  ...[number, number, number, number],
  ...[number, number, number, number],
  ...[number, number, number, number],
];

/** Matrices from the mesh's space to the model's. World matrices must be up to date within the scene. */
export function boneMatrices({ bones, boneInverses }: Skeleton): BoneMatrices {
  return bones.map((bone, i) => {
    // A joint can lie outside the scene that is shown.
    if (bone.parent === null) bone.updateWorldMatrix(false, false);
    const inverse = boneInverses[i] ?? new Matrix4();
    return new Matrix4().multiplyMatrices(bone.matrixWorld, inverse).elements;
  });
}
