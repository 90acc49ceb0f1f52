// Where are the vertices of a skinned mesh? Skinned meshes are not animated: the file's pose is applied once, at load. In: positions
// and normals of the mesh. Out: positions and normals in the model's space.
import { BufferAttribute, Matrix4, type SkinnedMesh } from 'three';
import { unitNormals } from './attributes.js';

export interface Posed {
  readonly position: BufferAttribute;
  readonly normal: BufferAttribute | null;
}

/** Blends bone matrices in float64. Normals use the cofactors of the blend, which are right for any scale, including 0. */
export function posed(mesh: SkinnedMesh, position: BufferAttribute, normal: BufferAttribute | null): Posed {
  const bones = boneMatrices(mesh);
  const indices = mesh.geometry.getAttribute('skinIndex');
  const weights = mesh.geometry.getAttribute('skinWeight');
  if (Math.min(indices.count, weights.count) < position.count) throw new Error('a skin has too few weights');
  const positions = new Float32Array(position.count * 3);
  const normals = normal && new Float32Array(position.count * 3);
  const blend = new Array<number>(16);
  for (let i = 0; i < position.count; i += 1) {
    blend.fill(0);
    for (let k = 0; k < 4; k += 1) {
      const weight = weights.getComponent(i, k);
      const bone = weight > 0 ? bones[indices.getComponent(i, k)] : undefined;
      if (bone) for (let j = 0; j < 16; j += 1) blend[j] = (blend[j] ?? 0) + weight * (bone[j] ?? 0);
    }
    const [a, b, c, , d, e, f, , g, h, j, , tx, ty, tz] = blend as Sixteen;
    const x = position.getX(i);
    const y = position.getY(i);
    const z = position.getZ(i);
    positions.set(
      [a * x + d * y + g * z + tx, b * x + e * y + h * z + ty, c * x + f * y + j * z + tz],
      i * 3,
    );
    if (!normal || !normals) continue;
    const nx = normal.getX(i);
    const ny = normal.getY(i);
    const nz = normal.getZ(i);
    const sign = Math.sign(a * (e * j - f * h) - d * (b * j - c * h) + g * (b * f - c * e)) || 1;
    normals[i * 3] = sign * ((e * j - f * h) * nx + (c * h - b * j) * ny + (b * f - c * e) * nz);
    normals[i * 3 + 1] = sign * ((f * g - d * j) * nx + (a * j - c * g) * ny + (c * d - a * f) * nz);
    normals[i * 3 + 2] = sign * ((d * h - e * g) * nx + (b * g - a * h) * ny + (a * e - b * d) * nz);
  }
  return {
    position: new BufferAttribute(positions, 3),
    normal: normals && unitNormals(new BufferAttribute(normals, 3)),
  };
}

type Sixteen = [
  ...[number, number, number, number],
  ...[number, number, number, number],
  ...[number, number, number, number],
  ...[number, number, number, number],
];

function boneMatrices({ skeleton }: SkinnedMesh): readonly (readonly number[])[] {
  return skeleton.bones.map((bone, i) => {
    // A joint can lie outside the scene that is shown.
    bone.updateWorldMatrix(true, false);
    const inverse = skeleton.boneInverses[i] ?? new Matrix4();
    return new Matrix4().multiplyMatrices(bone.matrixWorld, inverse).elements;
  });
}
