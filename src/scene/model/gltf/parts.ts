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
  type Texture,
} from 'three';
import { srgbEncode } from '../../../math/color.js';
import { flatGeometry } from '../../../material/flat-geometry.js';
import { mapsOfLook, ModelError, type ModelLook, type ModelPart } from '../model.js';
import { encodedColors, floatPositions, floatUvs, unitNormals, type Attribute } from './attributes.js';
import { posed } from './pose.js';
import { mapsOf, surfaceOf, uvNameOf } from './surfaces.js';
import { addTangents } from './tangents.js';

/** Most triangle corners in one model. A copy with a normal per corner would take more than 1 GiB beyond that. */
const CORNER_LIMIT = 2 ** 26;

export function collectParts(scene: Object3D): readonly ModelPart[] {
  const geometries = new Geometries();
  const parts: ModelPart[] = [];
  scene.updateMatrixWorld(true);
  scene.traverse((object) => {
    if (!(object instanceof Mesh)) return;
    const mesh = object as Mesh<BufferGeometry, MeshStandardMaterial>;
    const { geometry, flat } = geometries.of(mesh);
    if (geometry.getAttribute('position').count === 0) return;
    const matrix = mesh.matrixWorld.clone();
    if (!matrix.elements.every(Number.isFinite)) throw new Error('the transform of a node is not finite');
    if (isSkinned(mesh)) matrix.identity();
    parts.push({ name: nameOf(mesh), geometry, matrix, look: lookOf(mesh.material, geometry, flat) });
  });
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

type Conversion = (source: Attribute) => BufferAttribute;

class Geometries {
  readonly #cache = new Map<string, BuiltGeometry>();
  readonly #converted = new Map<Conversion, Map<Attribute, BufferAttribute>>();
  #corners = 0;

  of(mesh: Mesh<BufferGeometry, MeshStandardMaterial>): BuiltGeometry {
    const { normalMap, ...maps } = mapsOf(mesh.material, mesh.geometry);
    const uvs = [
      ...new Set([...Object.values(maps), normalMap].flatMap((map) => (map ? uvNameOf(map) : []))),
    ];
    const tangents = normalMap === null ? '' : uvNameOf(normalMap);
    const skin = isSkinned(mesh) ? mesh.uuid : '';
    const key = [mesh.geometry.uuid, ...uvs, 'tangents', tangents, skin].join(' ');
    const present = this.#cache.get(key);
    if (present) return present;
    const built = this.#build(mesh, uvs);
    if (tangents !== '') addTangents(built.geometry, mesh.geometry, tangents);
    this.#cache.set(key, built);
    return built;
  }

  #build(mesh: Mesh, uvs: readonly string[]): BuiltGeometry {
    const source = mesh.geometry;
    const geometry = new BufferGeometry();
    let position = this.#convert(source.getAttribute('position'), floatPositions);
    const { count } = position;
    let normal = source.hasAttribute('normal')
      ? this.#convert(source.getAttribute('normal'), unitNormals)
      : null;
    if (isSkinned(mesh)) {
      ({ position, normal } = posed(mesh, position, normal));
      floatPositions(position);
    }
    geometry.setAttribute('position', position);
    if (normal) geometry.setAttribute('normal', normal);
    if (source.hasAttribute('color')) {
      geometry.setAttribute('color', this.#convert(source.getAttribute('color'), encodedColors));
    }
    for (const uv of uvs) geometry.setAttribute(uv, this.#convert(source.getAttribute(uv), floatUvs));
    for (const [name, attribute] of Object.entries(geometry.attributes)) {
      if (attribute.count < count) throw new Error(`a mesh has fewer ${name} than vertices`);
    }
    if (source.index) geometry.setIndex(checkedIndex(source.index, count));
    this.#corners += source.index?.count ?? count;
    if (this.#corners > CORNER_LIMIT) {
      throw new ModelError(
        'too-large',
        `The model has more than ${String(Math.floor(CORNER_LIMIT / 3))} triangles.`,
      );
    }
    return normal ? { geometry, flat: false } : { geometry: flatGeometry(geometry), flat: true };
  }

  #convert(source: Attribute, conversion: Conversion): BufferAttribute {
    const known = this.#converted.get(conversion) ?? new Map<Attribute, BufferAttribute>();
    this.#converted.set(conversion, known);
    const result = known.get(source) ?? conversion(source);
    known.set(source, result);
    return result;
  }
}

/** Complete triangles of existing vertices. 8-bit indices become 16-bit, which every GPU reads at full speed. */
function checkedIndex(index: BufferAttribute, vertices: number): BufferAttribute {
  const length = index.count - (index.count % 3);
  const values = vertices > 0xffff ? new Uint32Array(length) : new Uint16Array(length);
  for (let i = 0; i < length; i += 1) {
    const vertex = index.getX(i);
    if (!(vertex < vertices))
      throw new Error(`a triangle refers to vertex ${String(vertex)} of ${String(vertices)}`);
    values[i] = vertex;
  }
  return new BufferAttribute(values, 1);
}
