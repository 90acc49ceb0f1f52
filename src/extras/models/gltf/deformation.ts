// The vertices of a mesh with joints or morph targets, computed on the CPU, at load and whenever
// the pose changes, so that bounds, culling and picking read the vertices that are drawn
// (src/decisions/skinning-on-the-cpu.md).
import {
  type Bone,
  Box3,
  BufferAttribute,
  type BufferGeometry,
  DynamicDrawUsage,
  Matrix4,
  type Skeleton,
  Sphere,
} from 'three';
import { LIMITS } from '../../../phong/light/light-state.js';
import { writeFaceNormals } from '../../../phong/material/flat-geometry.js';
import type { Slices } from '../slices.js';
import { type Attribute, requireCoordinates } from './attributes.js';

/** The attributes that move. */
const MOVING = ['position', 'normal', 'tangent'] as const;
type MovingName = (typeof MOVING)[number];

/** What a morph target adds to each vertex at weight 1: plain floats, three per vertex. */
export type MorphTarget = Readonly<Partial<Record<MovingName, Attribute | undefined>>>;

interface Rig {
  readonly joints: {
    readonly pose: JointPose;
    /** Of four joints each. three.js has brought the first weights to a sum of 1. */
    readonly sets: readonly { readonly indices: Attribute; readonly weights: Attribute }[];
  } | null;
  readonly targets: readonly MorphTarget[];
  /** Weight of each target; overwritten when the pose changes. */
  readonly weights: Float64Array;
  /** The geometry has a normal for each triangle, and no index. */
  readonly flat: boolean;
}

/** An attribute that moves. */
interface Moving {
  readonly name: MovingName;
  /** As in the file. */
  readonly rest: Float32Array;
  readonly attribute: BufferAttribute;
}

/** Joints in a set. */
const JOINTS = 4;

/** Deforms one geometry, whose attributes at construction are those of the undeformed mesh. */
export class Deformation {
  readonly #geometry: BufferGeometry;
  readonly #rig: Rig;
  readonly #moving: readonly Moving[];
  readonly #position: Float32Array;
  readonly #normal: Float32Array | null;
  readonly #tangent: Float32Array | null;
  /** Joints of a vertex. */
  readonly #joints: number;
  readonly #indices: Uint16Array;
  readonly #weights: Float32Array;
  readonly #applied: Float64Array;
  /** 1 for each vertex that its joints mirror. */
  readonly #mirrored: Uint8Array;
  /** {@link #mirrored} has changed since the triangles were turned. */
  #turned = false;
  /** The file's own order of corners; null if each vertex is a corner. */
  readonly #order: ArrayLike<number> | null;
  #version = -1;
  /** Two, in turns: a new object says that the bounds have changed. */
  readonly #bounds = [new Box3(), new Box3()] as const;

  constructor(geometry: BufferGeometry, rig: Rig) {
    this.#geometry = geometry;
    this.#rig = rig;
    this.#moving = MOVING.flatMap((name) => {
      if (!geometry.hasAttribute(name)) return [];
      const shared = geometry.getAttribute(name) as BufferAttribute;
      // Other geometries can share the attribute.
      const attribute = shared.clone();
      geometry.setAttribute(name, attribute);
      return { name, rest: shared.array as Float32Array, attribute };
    });
    const own = (name: MovingName) =>
      (geometry.attributes[name]?.array ?? null) as Float32Array | null;
    this.#position = own('position')!;
    this.#normal = own('normal');
    this.#tangent = own('tangent');
    const count = rig.joints === null ? 0 : this.#position.length / 3;
    this.#joints = JOINTS * (rig.joints?.sets.length ?? 0);
    this.#indices = new Uint16Array(count * this.#joints);
    this.#weights = new Float32Array(count * this.#joints);
    this.#mirrored = new Uint8Array(count);
    this.#applied = new Float64Array(rig.weights.length);
    this.#order = geometry.index?.array ?? null;
  }

  /**
   * The first pose, in slices. Rejects with an Error if a vertex leaves the domain of coordinates.
   */
  async load(slices: Slices): Promise<void> {
    const count = this.#position.length / 3;
    await slices.over(count, (from, to) => this.#link(from, to));
    const deform = (from: number, to: number) => this.#deform(from, to);
    await slices.over(count, deform, 1 + this.#rig.targets.length);
    await slices.over(count / 3, (from, to) => this.#writeFaceNormals(from, to));
    await requireCoordinates(this.#position, slices);
    const index = this.#turnedIndex();
    if (index !== null) {
      await slices.over(index.length, (from, to) => this.#turnFaces(index, from, to));
    }
    this.#remember();
  }

  /**
   * Marks the vertices as changing: the GPU keeps them where they are quick to replace, and
   * snapshots copy them.
   */
  keep(): void {
    for (const { attribute } of this.#moving) {
      attribute.setUsage(DynamicDrawUsage);
    }
  }

  /**
   * Steps of an update: each vertex once, and once for each target that may have a weight. 0 where
   * nothing moves it. @param weighted 1 for each target that animations give a weight; null if none
   * names this mesh's.
   */
  workOf(weighted: Uint8Array | null): number {
    const { joints, weights, targets } = this.#rig;
    if (joints === null && weighted === null) return 0;
    const used = targets.filter((_, i) => weights[i] !== 0 || weighted?.[i] === 1).length;
    const sets = this.#joints > JOINTS ? 2 : 1;
    return (this.#position.length / 3) * (sets + used) + targets.length;
  }

  /** The weights of the targets. */
  get weights() {
    return this.#rig.weights;
  }

  /** Updates the geometry if joints or weights have changed. */
  update(): void {
    const { joints, weights } = this.#rig;
    const still = this.#version === (joints?.pose.version ?? 0);
    if (still && weights.every((weight, i) => weight === this.#applied[i])) return;
    const count = this.#position.length / 3;
    this.#deform(0, count);
    this.#writeFaceNormals(0, count / 3);
    const index = this.#turnedIndex();
    if (index !== null) {
      this.#turnFaces(index, 0, index.length);
    }
    this.#measure();
    for (const { attribute } of this.#moving) {
      attribute.needsUpdate = true;
    }
    this.#remember();
  }

  /** Those of triangles that the joints mirror are turned as their corners are. */
  #writeFaceNormals(from: number, to: number) {
    const normals = this.#normal;
    if (!this.#rig.flat || normals === null) return;
    writeFaceNormals(this.#position, normals, from, to);
    if (this.#mirrored.length === 0) return;
    for (let face = from; face < to; face += 1) {
      if (!this.#isMirrored(3 * face, 3 * face + 1, 3 * face + 2)) continue;
      for (let i = 9 * face; i < 9 * face + 9; i += 1) {
        normals[i] = -normals[i]!;
      }
    }
  }

  #isMirrored(a: number, b: number, c: number): boolean {
    const mirrored = this.#mirrored;
    return mirrored[a]! + mirrored[b]! + mirrored[c]! >= 2;
  }

  /** An index of this geometry alone if triangles must be turned, else null. */
  #turnedIndex(): Uint16Array | Uint32Array | null {
    if (!this.#turned) return null;
    this.#turned = false;
    const geometry = this.#geometry;
    if (geometry.index === null || geometry.index.array === this.#order) {
      const count = this.#position.length / 3;
      const Type = count > 0xffff ? Uint32Array : Uint16Array;
      geometry.setIndex(new BufferAttribute(new Type(this.#order?.length ?? count), 1));
    }
    const index = geometry.index!;
    index.needsUpdate = true;
    return index.array as Uint16Array | Uint32Array;
  }

  /**
   * Triangles that the joints mirror name their corners the other way round: their outside stays
   * outside.
   */
  #turnFaces(index: Uint16Array | Uint32Array, from: number, to: number) {
    const cornerAt = (i: number) => this.#order?.[i] ?? i;
    for (let i = from; i < to; i += 3) {
      const [a, b, c] = [cornerAt(i), cornerAt(i + 1), cornerAt(i + 2)];
      const mirrored = this.#isMirrored(a, b, c);
      index[i] = a;
      index[i + 1] = mirrored ? c : b;
      index[i + 2] = mirrored ? b : c;
    }
  }

  #remember() {
    this.#version = this.#rig.joints?.pose.version ?? 0;
    this.#applied.set(this.#rig.weights);
  }

  /** Reads joints and weights. A joint that does not exist has no weight. */
  #link(from: number, to: number) {
    const { joints } = this.#rig;
    if (joints === null) return;
    const { pose, sets } = joints;
    const count = pose.matrices.length / 16;
    for (let i = from; i < to; i += 1) {
      // All weights of a vertex have the sum 1: what the second set has, the first has not.
      let left = 1;
      for (let set = sets.length - 1; set >= 0; set -= 1) {
        const { indices, weights } = sets[set]!;
        const scale = set === 0 ? Math.max(left, 0) : 1;
        for (let k = 0; k < JOINTS; k += 1) {
          const joint = indices.getComponent(i, k);
          const weight = weights.getComponent(i, k);
          left -= weight > 0 ? weight : 0;
          if (!(weight > 0 && joint < count)) continue;
          this.#indices[i * this.#joints + set * JOINTS + k] = joint;
          this.#weights[i * this.#joints + set * JOINTS + k] = scale * weight;
        }
      }
    }
  }

  /**
   * Always from the file's own numbers, so that no error accumulates. Normals use the cofactors of
   * the blended matrix, which are right for any scale, including 0.
   */
  #deform(from: number, to: number) {
    this.#morph(from, to);
    const { joints } = this.#rig;
    if (joints !== null) {
      this.#skin(joints.pose.matrices, from, to);
    } else if (this.#normal !== null) {
      normalizeAll(this.#normal, 3, from, to);
    }
    if (this.#tangent !== null) {
      normalizeAll(this.#tangent, 4, from, to);
    }
  }

  #morph(from: number, to: number) {
    for (const { name, rest, attribute } of this.#moving) {
      const values = attribute.array as Float32Array;
      const stride = attribute.itemSize;
      values.set(rest.subarray(from * stride, to * stride), from * stride);
      this.#rig.targets.forEach((target, i) =>
        add(target[name], this.#rig.weights[i]!, values, stride, from, to),
      );
    }
  }

  #skin(bones: Float64Array, from: number, to: number) {
    const [positions, normals, tangents] = [this.#position, this.#normal, this.#tangent];
    const [indices, weights] = [this.#indices, this.#weights];
    for (let i = from; i < to; i += 1) {
      let a = 0;
      let b = 0;
      let c = 0;
      let d = 0;
      let e = 0;
      let f = 0;
      let g = 0;
      let h = 0;
      let j = 0;
      let tx = 0;
      let ty = 0;
      let tz = 0;
      for (let k = i * this.#joints; k < (i + 1) * this.#joints; k += 1) {
        const weight = weights[k]!;
        if (weight === 0) continue;
        const at = indices[k]! * 16;
        a += weight * bones[at]!;
        b += weight * bones[at + 1]!;
        c += weight * bones[at + 2]!;
        d += weight * bones[at + 4]!;
        e += weight * bones[at + 5]!;
        f += weight * bones[at + 6]!;
        g += weight * bones[at + 8]!;
        h += weight * bones[at + 9]!;
        j += weight * bones[at + 10]!;
        tx += weight * bones[at + 12]!;
        ty += weight * bones[at + 13]!;
        tz += weight * bones[at + 14]!;
      }
      const x = positions[i * 3]!;
      const y = positions[i * 3 + 1]!;
      const z = positions[i * 3 + 2]!;
      positions[i * 3] = a * x + d * y + g * z + tx;
      positions[i * 3 + 1] = b * x + e * y + h * z + ty;
      positions[i * 3 + 2] = c * x + f * y + j * z + tz;
      const ax = e * j - f * h;
      const ay = f * g - d * j;
      const az = d * h - e * g;
      const mirrored = a * ax + b * ay + c * az < 0 ? 1 : 0;
      if (mirrored !== this.#mirrored[i]) {
        this.#mirrored[i] = mirrored;
        this.#turned = true;
      }
      const sign = 1 - 2 * mirrored;
      if (normals !== null) {
        const nx = sign * normals[i * 3]!;
        const ny = sign * normals[i * 3 + 1]!;
        const nz = sign * normals[i * 3 + 2]!;
        const mx = ax * nx + (c * h - b * j) * ny + (b * f - c * e) * nz;
        const my = ay * nx + (a * j - c * g) * ny + (c * d - a * f) * nz;
        const mz = az * nx + (b * g - a * h) * ny + (a * e - b * d) * nz;
        const size = Math.sqrt(mx * mx + my * my + mz * mz);
        const valid = size > 0 && size < Infinity;
        normals[i * 3] = valid ? mx / size : 0;
        normals[i * 3 + 1] = valid ? my / size : 0;
        normals[i * 3 + 2] = valid ? mz / size : 0;
      }
      if (tangents !== null) {
        const ux = tangents[i * 4]!;
        const uy = tangents[i * 4 + 1]!;
        const uz = tangents[i * 4 + 2]!;
        tangents[i * 4] = a * ux + d * uy + g * uz;
        tangents[i * 4 + 1] = b * ux + e * uy + h * uz;
        tangents[i * 4 + 2] = c * ux + f * uy + j * uz;
        tangents[i * 4 + 3] = sign * tangents[i * 4 + 3]!;
      }
    }
  }

  /** The box of all vertices and the sphere around that box. */
  #measure() {
    const geometry = this.#geometry;
    const [one, other] = this.#bounds;
    const box = geometry.boundingBox === one ? other : one;
    geometry.boundingBox = box.setFromArray(this.#position);
    geometry.boundingSphere = box.getBoundingSphere(geometry.boundingSphere ?? new Sphere());
  }
}

/** Adds `weight` times the first three numbers of each vertex. */
function add(
  source: Attribute | undefined,
  weight: number,
  into: Float32Array,
  stride: number,
  from: number,
  to: number,
): void {
  if (source === undefined || weight === 0) return;
  const { array } = source; // plain: see MorphTarget
  for (let i = from; i < to; i += 1) {
    for (let c = 0; c < 3; c += 1) {
      into[i * stride + c]! += weight * array[i * 3 + c]!;
    }
  }
}

/** Brings vectors of three numbers to unit length; those without direction become zero. */
function normalizeAll(values: Float32Array, stride: number, from: number, to: number) {
  for (let i = from * stride; i < to * stride; i += stride) {
    const [x, y, z] = [values[i]!, values[i + 1]!, values[i + 2]!];
    const length = Math.sqrt(x * x + y * y + z * z);
    const valid = length > 0 && length < Infinity;
    values[i] = valid ? x / length : 0;
    values[i + 1] = valid ? y / length : 0;
    values[i + 2] = valid ? z / length : 0;
  }
}

/**
 * The matrices of a skeleton's joints, from the mesh's bind space to the model's. Shared by all its
 * meshes.
 */
export class JointPose {
  /** 16 numbers for each joint. */
  readonly matrices: Float64Array;
  /** Increments when a matrix has changed. */
  version = 0;
  readonly #skeleton: Skeleton;
  readonly #matrix = new Matrix4();
  /** Joints that lie outside the scene that is shown, each once. */
  readonly roots: ReadonlySet<Bone>;

  constructor(skeleton: Skeleton) {
    this.#skeleton = skeleton;
    this.roots = new Set(skeleton.bones.filter((bone) => bone.parent === null));
    this.matrices = new Float64Array(skeleton.bones.length * 16);
  }

  /**
   * World matrices must be up to date, those of {@link roots} too. A joint whose matrix leaves the
   * domain of coordinates stays where it was.
   */
  update(): void {
    const { bones, boneInverses } = this.#skeleton;
    const { matrices } = this;
    let changes = 0;
    bones.forEach((bone, i) => {
      const { elements } = this.#matrix.multiplyMatrices(
        bone.matrixWorld,
        boneInverses[i] ?? IDENTITY,
      );
      if (!elements.every((element) => Math.abs(element) <= LIMITS.coordinate)) return;
      for (let j = 0; j < 16; j += 1) {
        if (matrices[i * 16 + j] !== elements[j]) {
          changes += 1;
        }
        matrices[i * 16 + j] = elements[j]!;
      }
    });
    if (changes > 0) {
      this.version += 1;
    }
  }
}

const IDENTITY = /* @__PURE__ */ new Matrix4();
