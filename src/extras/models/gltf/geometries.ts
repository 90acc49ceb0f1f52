// Turns the geometries from three's glTF loader into those that are drawn, in the file's pose.
// Shared ones stay shared.
import type { ModelBudget } from '../../../phong/model/model-budget.js';
import {
  BufferAttribute,
  BufferGeometry,
  type Mesh,
  type MeshStandardMaterial,
  type Object3D,
  type Skeleton,
  type SkinnedMesh,
  type Texture,
} from 'three';
import { faceNormals } from '../model-reader.js';
import type { Slices } from '../slices.js';
import {
  type Attribute,
  type Conversion,
  clampedColors,
  floatPositions,
  floatUvs,
  gathered,
  unitNormals,
  unitTangents,
} from './attributes.js';
import type { Accessor } from './accessors.js';
import { Deformation, type MorphTarget, JointPose } from './deformation.js';
import type { GltfDocument } from './document.js';
import { addTangents, findNormals, takeFileNormals } from './computed-vectors.js';
import { cornersOf, FANS, type MorphAccessors, STRIPS, TRIANGLES } from './primitives.js';
import { mapsOf, uvNameOf } from './materials.js';

/** Where the file describes an object. */
export interface FileIndices {
  readonly nodes?: number;
  readonly meshes?: number;
  readonly primitives?: number;
}

/** What the loader's scene does not say. */
export interface GeometrySource extends Pick<GltfDocument, 'primitives' | 'weights' | 'instances'> {
  /** Undefined for an object that no node and no mesh of the file stands for. */
  indicesOf(object: Object3D): FileIndices | undefined;
  /** The numbers of an accessor that was counted. */
  readonly accessor: (accessor: Accessor) => Promise<Attribute>;
  readonly budget: ModelBudget;
}

/** The index of the node that an object is, or is part of. */
export function nodeOf(
  object: Object3D,
  source: Pick<GeometrySource, 'indicesOf'>,
): number | undefined {
  for (let node: Object3D | null = object; node !== null; node = node.parent) {
    const index = source.indicesOf(node)?.nodes;
    if (index !== undefined) return index;
  }
  return undefined;
}

/**
 * The loader makes a mesh skinned for all nodes that share it. Those without a skin have no
 * skeleton.
 */
export const isSkinned = (mesh: Mesh): mesh is SkinnedMesh =>
  (mesh as Partial<SkinnedMesh>).skeleton !== undefined;

export class Geometries {
  readonly deformations: Deformation[] = [];
  readonly joints = new Map<Skeleton, JointPose>();
  readonly weights = new Map<number, Float64Array>();
  readonly #source: GeometrySource;
  readonly #slices: Slices;
  readonly #cache = new Map<string, BufferGeometry>();
  readonly #roots = new Set<Object3D>();
  readonly #converted = new Map<Conversion, Map<Attribute, BufferAttribute>>();

  constructor(source: GeometrySource, slices: Slices) {
    this.#source = source;
    this.#slices = slices;
  }

  async of(mesh: Mesh<BufferGeometry, MeshStandardMaterial>): Promise<BufferGeometry> {
    const { normalMap, ...maps } = mapsOf(mesh.material, mesh.geometry);
    const uvs = [
      ...new Set([...Object.values(maps), normalMap].flatMap((map) => (map ? uvNameOf(map) : []))),
    ];
    normalMap?.updateMatrix();
    const tangents = [normalMap?.channel, normalMap?.matrix.elements];
    const skin = isSkinned(mesh) ? mesh.skeleton.uuid : '';
    const { meshes = -1, primitives = -1 } = this.#source.indicesOf(mesh) ?? {};
    const { mode = TRIANGLES, targets = [] } = this.#source.primitives[meshes]?.[primitives] ?? {};
    // The weights of morph targets belong to a node.
    const own = targets.length > 0 ? mesh.uuid : '';
    const key = [mesh.geometry.uuid, mode, ...uvs, ...tangents, skin, own].join(' ');
    const present = this.#cache.get(key);
    if (present) return present;
    const built = await this.#build(mesh, mode, uvs, normalMap, targets);
    this.#cache.set(key, built);
    return built;
  }

  async #build(
    mesh: Mesh,
    mode: number,
    uvs: readonly string[],
    normalMap: Texture | null,
    targets: readonly MorphAccessors[],
  ): Promise<BufferGeometry> {
    const attributes = await this.#attributesOf(mesh.geometry, uvs, normalMap !== null);
    const { count = 0, array: positions = [] } = attributes.get('position') ?? {};
    const shown = [...attributes.keys()];
    await this.#addMoving(attributes, mesh, targets);
    for (const [name, attribute] of attributes) {
      if (attribute.count < count) throw new Error(`a mesh has fewer ${name} than vertices`);
    }
    let corners = await this.#cornersOf(mesh.geometry.index, mode, count);
    const moves = isSkinned(mesh) || targets.length > 0;
    const own = attributes.get('normal');
    const { some, all } = own
      ? await findNormals(own.array, positions, corners, corners?.length ?? count, this.#slices)
      : NO_NORMALS;
    // Without any normal that has a direction they count as absent.
    const flat = !some;
    if (flat) {
      attributes.delete('normal');
      attributes.delete('tangent');
    }
    const computed = normalMap !== null && !attributes.has('tangent');
    // A copy of the vertices for each corner, where they cannot be shared, or few of them are used.
    const separate = corners && (!all || corners.length * 2 < count) ? corners : null;
    const items = [...attributes.values()].reduce((sum, { itemSize }) => sum + itemSize, 0);
    const each =
      (separate ? items : 0) +
      (all ? 0 : 3) +
      (moves ? MOVING_VALUES : 0) +
      (computed ? TANGENT_VALUES : 0);
    // An index, and one of its own where joints mirror it.
    const indices = separate ? 0 : (corners?.length ?? 0) * (isSkinned(mesh) ? 2 : 1);
    this.#source.budget.add({ values: (separate?.length ?? count) * each + indices });
    if (separate) {
      for (const [name, attribute] of attributes) {
        attributes.set(name, await gathered(attribute, separate, this.#slices));
      }
      corners = null;
    }
    const geometry = new BufferGeometry();
    for (const [name, attribute] of attributes) {
      if (shown.includes(name)) {
        geometry.setAttribute(name, attribute);
      }
    }
    if (!all) {
      const normals = await faceNormals(geometry.getAttribute('position').array, this.#slices);
      if (!flat) {
        await takeFileNormals(geometry.getAttribute('normal').array, normals.array, this.#slices);
      }
      geometry.setAttribute('normal', normals);
    }
    geometry.setIndex(corners && new BufferAttribute(corners, 1));
    if (computed) {
      await addTangents(geometry, normalMap, this.#slices);
    }
    if (moves) {
      await this.#deform(mesh, geometry, flat, attributes, targets);
    }
    return geometry;
  }

  async #attributesOf(
    source: BufferGeometry,
    uvs: readonly string[],
    tangents: boolean,
  ): Promise<Map<string, Attribute>> {
    const attributes = new Map<string, Attribute>();
    for (const [name, conversion, items] of [
      ['position', floatPositions, 3],
      ['normal', unitNormals, 3],
      ['color', clampedColors, 4],
      ...(tangents && source.hasAttribute('normal') ? [['tangent', unitTangents, 4] as const] : []),
      ...uvs.map((uv) => [uv, floatUvs, 2] as const),
    ] as const) {
      if (!source.hasAttribute(name)) continue;
      attributes.set(name, await this.#convert(source.getAttribute(name), conversion, items));
    }
    return attributes;
  }

  /** What skins and morph targets move vertices by. */
  async #addMoving(
    attributes: Map<string, Attribute>,
    mesh: Mesh,
    targets: readonly MorphAccessors[],
  ): Promise<void> {
    for (const name of isSkinned(mesh) ? JOINTS.flat() : []) {
      if (mesh.geometry.hasAttribute(name)) {
        attributes.set(name, mesh.geometry.getAttribute(name));
      }
    }
    for (const [i, target] of targets.entries()) {
      for (const [name, accessor] of Object.entries(target)) {
        const vectors = await this.#source.accessor(accessor);
        attributes.set(morphName(i, name), await this.#convert(vectors, floatPositions, 3));
      }
    }
  }

  /** The vertex of each corner of whole triangles. Null if each vertex is a corner. */
  async #cornersOf(
    index: BufferAttribute | null,
    mode: number,
    vertices: number,
  ): Promise<Uint16Array | Uint32Array | null> {
    const count = index?.count ?? vertices;
    const length = cornersOf(mode, count);
    if (!index && mode === TRIANGLES && length === count) return null;
    // 8-bit indices become 16-bit, which every GPU reads at full speed.
    const Type = vertices > 0xffff ? Uint32Array : Uint16Array;
    const plain = index instanceof BufferAttribute && index.array instanceof Type;
    const ready = plain && mode === TRIANGLES && length === count;
    const cornerOf = CORNER_OF[mode];
    const corners = ready ? (index.array as InstanceType<typeof Type>) : new Type(length);
    await this.#slices.over(length, (from, to) => {
      for (let i = from; i < to; i += 1) {
        const at = cornerOf === undefined ? i : cornerOf(i);
        const vertex = index ? index.getX(at) : at;
        if (!(vertex < vertices)) {
          throw new Error(`a triangle refers to vertex ${String(vertex)} of ${String(vertices)}`);
        }
        corners[i] = vertex;
      }
    });
    return corners;
  }

  /** Brings the geometry into the file's pose. Its attributes are those of the undeformed mesh. */
  async #deform(
    mesh: Mesh,
    geometry: BufferGeometry,
    flat: boolean,
    attributes: ReadonlyMap<string, Attribute>,
    targets: readonly MorphAccessors[],
  ): Promise<void> {
    const sets = JOINTS.flatMap((names) => {
      const [indices, weights] = names.map((name) => attributes.get(name));
      return indices && weights ? { indices, weights } : [];
    });
    const joints =
      isSkinned(mesh) && sets.length > 0 ? { pose: this.#poseOf(mesh.skeleton), sets } : null;
    const deformation = new Deformation(geometry, {
      joints,
      flat,
      weights: this.#weightsOf(mesh, targets.length),
      targets: targets.map((target, i): MorphTarget =>
        Object.fromEntries(
          Object.keys(target).map((name) => [
            name.toLowerCase(),
            attributes.get(morphName(i, name)),
          ]),
        ),
      ),
    });
    await deformation.load(this.#slices);
    this.deformations.push(deformation);
  }

  #poseOf(skeleton: Skeleton): JointPose {
    const known = this.joints.get(skeleton);
    if (known) return known;
    const pose = new JointPose(skeleton);
    for (const root of pose.roots) {
      if (!this.#roots.has(root)) {
        root.updateWorldMatrix(false, true);
      }
      this.#roots.add(root); // many skins can share one, with thousands of nodes below it
    }
    pose.update();
    this.joints.set(skeleton, pose);
    return pose;
  }

  /** All primitives of a node share its weights; those with fewer targets use the first ones. */
  #weightsOf(mesh: Mesh, targets: number): Float64Array {
    const index = nodeOf(mesh, this.#source);
    if (index === undefined) return new Float64Array(targets);
    const weights = this.weights.get(index) ?? Float64Array.from(this.#source.weights[index] ?? []);
    this.weights.set(index, weights);
    return weights;
  }

  /** @param items numbers per vertex that it makes. */
  async #convert(
    source: Attribute,
    conversion: Conversion,
    items: number,
  ): Promise<BufferAttribute> {
    const known = this.#converted.get(conversion) ?? new Map<Attribute, BufferAttribute>();
    this.#converted.set(conversion, known);
    const present = known.get(source);
    if (present !== undefined) return present;
    this.#source.budget.add({ values: source.count * Math.max(items, source.itemSize) });
    const result = await conversion(source, this.#slices);
    known.set(source, result);
    return result;
  }
}

const NO_NORMALS = { some: false, all: false };
const JOINTS = [
  ['skinIndex', 'skinWeight'],
  ['joints_1', 'weights_1'],
] as const;

/**
 * What a computed tangent costs, in values: itself, and two sums in float64 while it is computed.
 */
const TANGENT_VALUES = 16;

/**
 * What a vertex that moves costs, in values: position, normal, tangent, joints, weights, whether it
 * is mirrored.
 */
const MOVING_VALUES = 23;

const morphName = (target: number, name: string) => `target ${String(target)} ${name}`;

/** The vertex of a corner of triangle t, as strips and fans count. */
const CORNER_OF: Readonly<Record<number, (corner: number) => number>> = {
  /**
   * t, t + 1, t + 2, with the last two swapped in every second one, so that all face the same side.
   */
  [STRIPS]: (corner) => {
    const within = corner % 3;
    const triangle = (corner - within) / 3;
    return triangle + (within > 0 && triangle % 2 === 1 ? 3 - within : within);
  },
  /** t + 1, t + 2, 0. */
  [FANS]: (corner) => (corner % 3 === 2 ? 0 : Math.floor(corner / 3) + (corner % 3) + 1),
};
