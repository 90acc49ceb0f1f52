// From the scene that three's glTF loader made to a model's parts: attributes in the shaders' form, looks in the
// equation's terms. Sources shared in the file stay shared. Must not know where the bytes came from.
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
import { ModelError, type ModelLook, type ModelPart } from '../model.js';
import { encodedColors, floatPositions, floatUvs, unitNormals, type Attribute } from './attributes.js';
import { posed } from './pose.js';

/** Corners of triangles in one model; a copy with a normal for each then takes more than a GiB. */
const CORNER_LIMIT = 2 ** 26;

export function collectParts(scene: Object3D): readonly ModelPart[] {
  const geometries = new Geometries();
  const parts: ModelPart[] = [];
  scene.updateMatrixWorld(true);
  scene.traverse((object) => {
    if (!(object instanceof Mesh)) return;
    const mesh = object as Mesh<BufferGeometry, MeshStandardMaterial>;
    const { map } = mesh.material;
    const { geometry, flat } = geometries.of(mesh, map);
    if (geometry.getAttribute('position').count === 0) return;
    const matrix = mesh.matrixWorld.clone();
    if (!matrix.elements.every(Number.isFinite)) throw new Error('a node is moved beyond all numbers');
    if (isSkinned(mesh)) matrix.identity();
    parts.push({ name: nameOf(mesh), geometry, matrix, look: lookOf(mesh.material, geometry, flat) });
  });
  if (parts.length === 0) throw new Error('it has no triangles');
  // Last, for parts may share a map, whose channel each of them has asked for above.
  for (const { look } of parts) if (look.map) readPlainly(look.map);
  return parts;
}

// What `instanceof` narrows to has `any` in its type parameters.
const isSkinned = (mesh: Mesh): mesh is SkinnedMesh => mesh instanceof SkinnedMesh;

/** The file's name of the nearest node that has one; the loader's own names are made unique, and bent for it. */
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
  const map = geometry.hasAttribute('uv') ? material.map : null;
  // Exporters mark opaque materials as blended; drawing those unsorted, without depth, would show their backs.
  const vertexAlpha = geometry.hasAttribute('color') && geometry.getAttribute('color').itemSize === 4;
  const blends = transparent && (opacity < 1 || map !== null || vertexAlpha);
  const alphaMode = blends ? 'blend' : alphaTest > 0 ? 'mask' : 'opaque';
  return {
    baseColor: [encode(color.r), encode(color.g), encode(color.b)],
    opacity: alphaMode === 'opaque' ? 1 : Math.min(Math.max(opacity, 0), 1),
    alphaMode,
    alphaCutoff: alphaTest,
    map,
    doubleSided: material.side === DoubleSide,
    flat,
  };
}

function readPlainly(map: Texture): void {
  map.colorSpace = NoColorSpace;
  // The geometry's `uv` is the set that the map asks for.
  map.channel = 0;
  if (map.matrixAutoUpdate) map.updateMatrix();
}

interface Made {
  readonly geometry: BufferGeometry;
  readonly flat: boolean;
}

type Conversion = (source: Attribute) => BufferAttribute;

class Geometries {
  readonly #made = new Map<string, Made>();
  readonly #converted = new Map<Conversion, Map<Attribute, BufferAttribute>>();
  #corners = 0;

  of(mesh: Mesh<BufferGeometry, MeshStandardMaterial>, map: Texture | null): Made {
    const uv = map ? (map.channel === 0 ? 'uv' : `uv${String(map.channel)}`) : '';
    const skin = isSkinned(mesh) ? mesh.uuid : '';
    const key = `${mesh.geometry.uuid} ${uv} ${skin}`;
    const present = this.#made.get(key);
    if (present) return present;
    const made = this.#make(mesh, uv);
    this.#made.set(key, made);
    return made;
  }

  #make(mesh: Mesh, uv: string): Made {
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
    if (uv !== '' && source.hasAttribute(uv)) {
      geometry.setAttribute('uv', this.#convert(source.getAttribute(uv), floatUvs));
    }
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

/** Whole triangles of vertices that exist. Bytes become 16 bits, which every GPU reads at full speed. */
function checkedIndex(index: BufferAttribute, vertices: number): BufferAttribute {
  const length = index.count - (index.count % 3);
  const values = vertices > 0xffff ? new Uint32Array(length) : new Uint16Array(length);
  for (let i = 0; i < length; i += 1) {
    const vertex = index.getX(i);
    if (!(vertex < vertices))
      throw new Error(`a triangle names vertex ${String(vertex)} of ${String(vertices)}`);
    values[i] = vertex;
  }
  return new BufferAttribute(values, 1);
}
