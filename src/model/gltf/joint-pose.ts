// The joints of a skeleton: their matrices as plain numbers, which deformations read, and a version that says when one
// has changed.
import { type Bone, Matrix4, type Skeleton } from 'three';
import { COORDINATE_LIMIT } from './attributes.js';

/**
 * The matrices of a skeleton's joints, from the mesh's bind space to the model's. Shared by all meshes with that
 * skeleton.
 */
export class JointPose {
  /** 16 numbers for each joint. */
  readonly matrices: Float64Array;
  /** Increments when a matrix has changed. */
  version = 0;
  readonly #skeleton: Skeleton;
  readonly #matrix = new Matrix4();
  /** Joints that lie outside the scene that is shown, each once. */
  readonly #roots: ReadonlySet<Bone>;

  constructor(skeleton: Skeleton) {
    this.#skeleton = skeleton;
    this.#roots = new Set(skeleton.bones.filter((bone) => bone.parent === null));
    this.matrices = new Float64Array(skeleton.bones.length * 16);
  }

  /**
   * World matrices must be up to date within the scene. A joint whose matrix leaves the domain of coordinates stays
   * where it was.
   */
  update(): void {
    const { bones, boneInverses } = this.#skeleton;
    const { matrices } = this;
    let changes = 0;
    for (const bone of this.#roots) bone.updateWorldMatrix(false, true);
    bones.forEach((bone, i) => {
      const { elements } = this.#matrix.multiplyMatrices(bone.matrixWorld, boneInverses[i] ?? IDENTITY);
      if (!elements.every((element) => Math.abs(element) <= COORDINATE_LIMIT)) return;
      for (let j = 0; j < 16; j += 1) {
        if (matrices[i * 16 + j] !== elements[j]) changes += 1;
        matrices[i * 16 + j] = elements[j]!;
      }
    });
    if (changes > 0) this.version += 1;
  }
}

const IDENTITY = /* @__PURE__ */ new Matrix4();
