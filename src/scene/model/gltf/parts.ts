// How does the scene from three's glTF loader become a model's parts? Attributes as the shaders read them, looks in terms of the
// equation. What the file shares stays shared. Must not know where the bytes came from.
import {
  BufferAttribute,
  BufferGeometry,
  DoubleSide,
  Mesh,
  NoColorSpace,
  SkinnedMesh,
  type MeshStandardMaterial,
  type Object3D,
  type Skeleton,
  type Texture,
} from 'three';
import { srgbEncode } from '../../../math/color.js';
import { setBounds } from '../bounds.js';
import { faceNormals } from '../face-normals.js';
import { mapsOfLook, type ModelLook, type ModelPart } from '../model.js';
import type { Slices } from '../slices.js';
import {
  type Attribute,
  type Conversion,
  encodedColors,
  floatPositions,
  floatUvs,
  gathered,
  unitNormals,
} from './attributes.js';
import { usesFew } from './claims.js';
import { boneMatrices, type BoneMatrices, posed } from './pose.js';
import { CORNERS, FAN, STRIP } from './primitives.js';
import { mapsOf, surfaceOf, uvNameOf } from './surfaces.js';
import { addTangents, unitTangents } from './tangents.js';

export async function collectParts(scene: Object3D, slices: Slices): Promise<readonly ModelPart[]> {
  const geometries = new Geometries(slices);
  const parts: ModelPart[] = [];
  scene.updateMatrixWorld(true);
  const meshes: Mesh<BufferGeometry, MeshStandardMaterial>[] = [];
  scene.traverse((object) => {
    if (object instanceof Mesh) meshes.push(object as Mesh<BufferGeometry, MeshStandardMaterial>);
  });
  for (const mesh of meshes) {
    const { geometry, flat } = await geometries.of(mesh);
    const matrix = mesh.matrixWorld.clone();
    if (!matrix.elements.every(Number.isFinite)) throw new Error('the transform of a node is not finite');
    if (isSkinned(mesh)) matrix.identity();
    parts.push({ name: nameOf(mesh), geometry, matrix, look: lookOf(mesh.material, geometry, flat) });
  }
  if (parts.length === 0) throw new Error('it has no triangles');
  // Last, because parts can share a map and each has read its channel above.
  for (const { look } of parts) for (const map of mapsOfLook(look)) readUndecoded(map);
  return parts;
}

// `instanceof` alone would narrow to a type with `any` parameters.
const isSkinned = (mesh: Mesh): mesh is SkinnedMesh => mesh instanceof SkinnedMesh;

/** The original name of the nearest named node. The loader's own names are altered to be unique. */
function nameOf(object: Object3D): string {
  for (let node: Object3D | null = object; node; node = node.parent) {
    const name: unknown = node.userData['name'];
    if (typeof name === 'string' && name !== '') return name;
  }
  return '';
}

function lookOf(material: MeshStandardMaterial, geometry: BufferGeometry, flat: boolean): ModelLook {
  const { color, opacity, transparent, alphaTest } = material;
  const encode = (linear: number): number => srgbEncode(Math.min(Math.max(linear, 0), 1));
  const maps = mapsOf(material, geometry);
  const { map } = maps;
  // Exporters often mark opaque materials as blended. Blending those, unsorted and without depth, would show their backs.
  const vertexAlpha = geometry.hasAttribute('color') && geometry.getAttribute('color').itemSize === 4;
  const blends = transparent && (opacity < 1 || map !== null || vertexAlpha);
  const alphaMode = blends ? 'blend' : alphaTest > 0 ? 'mask' : 'opaque';
  return {
    baseColor: [encode(color.r), encode(color.g), encode(color.b)],
    opacity: alphaMode === 'opaque' ? 1 : Math.min(Math.max(opacity, 0), 1),
    alphaMode,
    alphaCutoff: alphaTest,
    doubleSided: material.side === DoubleSide,
    flat,
    ...maps,
    ...surfaceOf(material),
  };
}

function readUndecoded(map: Texture): void {
  map.colorSpace = NoColorSpace;
  if (map.matrixAutoUpdate) map.updateMatrix();
}

interface BuiltGeometry {
  readonly geometry: BufferGeometry;
  readonly flat: boolean;
}

class Geometries {
  readonly #slices: Slices;
  readonly #cache = new Map<string, BuiltGeometry>();
  readonly #converted = new Map<Conversion, Map<Attribute, BufferAttribute>>();
  readonly #bones = new Map<Skeleton, BoneMatrices>();

  constructor(slices: Slices) {
    this.#slices = slices;
  }

  async of(mesh: Mesh<BufferGeometry, MeshStandardMaterial>): Promise<BuiltGeometry> {
    const { normalMap, ...maps } = mapsOf(mesh.material, mesh.geometry);
    const uvs = [
      ...new Set([...Object.values(maps), normalMap].flatMap((map) => (map ? uvNameOf(map) : []))),
    ];
    const tangents = normalMap === null ? null : uvNameOf(normalMap);
    const skin = isSkinned(mesh) ? mesh.skeleton.uuid : '';
    const key = [mesh.geometry.uuid, ...uvs, 'tangents', tangents, skin].join(' ');
    const present = this.#cache.get(key);
    if (present) return present;
    const built = await this.#build(mesh, uvs, tangents);
    this.#cache.set(key, built);
    return built;
  }

  /** @param tangents the coordinates of the normal map; null for none. */
  async #build(mesh: Mesh, uvs: readonly string[], tangents: string | null): Promise<BuiltGeometry> {
    const source = mesh.geometry;
    const flat = !source.hasAttribute('normal');
    const attributes = await this.#attributesOf(source, uvs, tangents !== null);
    const count = attributes.get('position')?.count ?? 0;
    const joints = isSkinned(mesh) ? ['skinIndex', 'skinWeight'] : [];
    for (const name of joints) attributes.set(name, source.getAttribute(name));
    for (const [name, attribute] of attributes) {
      if (attribute.count < count) throw new Error(`a mesh has fewer ${name} than vertices`);
    }
    let corners = await this.#cornersOf(source, count);
    if (corners && (flat || usesFew(corners.length, count))) {
      for (const [name, attribute] of attributes) {
        attributes.set(name, await gathered(attribute, corners, this.#slices));
      }
      corners = null;
    }
    if (isSkinned(mesh)) await this.#pose(attributes, mesh.skeleton);
    const geometry = new BufferGeometry();
    for (const [name, attribute] of attributes)
      if (!joints.includes(name)) geometry.setAttribute(name, attribute);
    if (flat) {
      const { array } = geometry.getAttribute('position');
      geometry.setAttribute('normal', await faceNormals(array, this.#slices));
    }
    if (corners) geometry.setIndex(new BufferAttribute(corners, 1));
    if (tangents !== null && !attributes.has('tangent')) await addTangents(geometry, tangents, this.#slices);
    await setBounds(geometry, this.#slices);
    return { geometry, flat };
  }

  async #attributesOf(
    source: BufferGeometry,
    uvs: readonly string[],
    tangents: boolean,
  ): Promise<Map<string, Attribute>> {
    const attributes = new Map<string, Attribute>();
    for (const [name, conversion] of [
      ['position', floatPositions],
      ['normal', unitNormals],
      ['color', encodedColors],
      ...(tangents && source.hasAttribute('normal') ? [['tangent', unitTangents] as const] : []),
      ...uvs.map((uv) => [uv, floatUvs] as const),
    ] as const) {
      if (!source.hasAttribute(name)) continue;
      attributes.set(name, await this.#convert(source.getAttribute(name), conversion));
    }
    return attributes;
  }

  /** The vertex of each corner of whole triangles. Null if each vertex is a corner. */
  async #cornersOf(source: BufferGeometry, vertices: number): Promise<Uint16Array | Uint32Array | null> {
    const { index } = source;
    const strip = source.hasAttribute(STRIP.toLowerCase());
    const fan = source.hasAttribute(FAN.toLowerCase());
    const count = index?.count ?? vertices;
    const length = strip || fan ? CORNERS.strip(count) : CORNERS.list(count);
    if (!index && !strip && !fan && length === count) return null;
    // 8-bit indices become 16-bit, which every GPU reads at full speed.
    const Type = vertices > 0xffff ? Uint32Array : Uint16Array;
    const plain = index instanceof BufferAttribute && index.array instanceof Type;
    const ready = plain && !strip && !fan && length === count;
    const corners = ready ? (index.array as InstanceType<typeof Type>) : new Type(length);
    await this.#slices.over(length, (from, to) => {
      for (let i = from; i < to; i += 1) {
        const at = strip ? stripCorner(i) : fan ? fanCorner(i) : i;
        const vertex = index ? index.getX(at) : at;
        if (!(vertex < vertices))
          throw new Error(`a triangle refers to vertex ${String(vertex)} of ${String(vertices)}`);
        corners[i] = vertex;
      }
    });
    return corners;
  }

  async #pose(attributes: Map<string, Attribute>, skeleton: Skeleton): Promise<void> {
    const bones = this.#bones.get(skeleton) ?? boneMatrices(skeleton);
    this.#bones.set(skeleton, bones);
    const [position, joints, weights] = ['position', 'skinIndex', 'skinWeight'].map((name) =>
      attributes.get(name),
    );
    if (!position || !joints || !weights) return;
    const bound = { position, normal: attributes.get('normal') ?? null, joints, weights };
    const pose = await posed(bound, bones, this.#slices);
    attributes.set('position', await floatPositions(pose.position, this.#slices));
    if (pose.normal) attributes.set('normal', pose.normal);
  }

  async #convert(source: Attribute, conversion: Conversion): Promise<BufferAttribute> {
    const known = this.#converted.get(conversion) ?? new Map<Attribute, BufferAttribute>();
    this.#converted.set(conversion, known);
    const result = known.get(source) ?? (await conversion(source, this.#slices));
    known.set(source, result);
    return result;
  }
}

/** Triangle t of a strip is t, t + 1, t + 2, with the last two swapped in every second one, so that all face the same side. */
function stripCorner(corner: number): number {
  const within = corner % 3;
  const triangle = (corner - within) / 3;
  return triangle + (within > 0 && triangle % 2 === 1 ? 3 - within : within);
}

/** Triangle t of a fan is t + 1, t + 2, 0. */
function fanCorner(corner: number): number {
  const within = corner % 3;
  return within === 2 ? 0 : (corner - within) / 3 + within + 1;
}
