// Turns the scene from three's glTF loader into a model's parts. Names, places, and looks in terms of the equation.
import {
  type BufferGeometry,
  DoubleSide,
  Mesh,
  type MeshStandardMaterial,
  NoColorSpace,
  type Object3D,
  type Texture,
} from 'three';
import { srgbEncode } from '../../math/color.js';
import type { BaseLook } from '../../material/file-surface.js';
import type { ContentPart } from '../model.js';
import { mapsOfLook } from '../owned-model.js';
import type { Slices } from '../slices.js';
import { Geometries, type GeometrySource, isSkinned } from './geometries.js';
import type { Movable } from './motion.js';
import { coefficientsOf, mapsOf, surfaceOf } from './surfaces.js';

export interface Parts {
  readonly parts: readonly ContentPart[];
  readonly movable: Movable;
}

export async function collectParts(scene: Object3D, source: GeometrySource, slices: Slices): Promise<Parts> {
  const geometries = new Geometries(source, slices);
  const parts: ContentPart[] = [];
  const rigid: { part: ContentPart; mesh: Mesh }[] = [];
  scene.updateMatrixWorld(true);
  const meshes: Mesh<BufferGeometry, MeshStandardMaterial>[] = [];
  scene.traverse((object) => {
    if (object instanceof Mesh) meshes.push(object as Mesh<BufferGeometry, MeshStandardMaterial>);
  });
  for (const mesh of meshes) {
    const geometry = await geometries.of(mesh);
    const matrix = mesh.matrixWorld.clone();
    if (!matrix.elements.every(Number.isFinite)) throw new Error('the transform of a node is not finite');
    if (isSkinned(mesh)) matrix.identity();
    const { material } = mesh;
    const look = lookOf(material, geometry);
    const part: ContentPart = {
      name: nameOf(mesh),
      geometry,
      matrix,
      look,
      sides: material.side === DoubleSide ? 'double' : 'single',
      surface: coefficientsOf(material, look),
    };
    parts.push(part);
    if (!isSkinned(mesh)) rigid.push({ part, mesh });
  }
  if (parts.length === 0) throw new Error('it has no triangles');
  // Last, because parts can share a map and each has read its channel above.
  for (const { look } of parts) for (const map of mapsOfLook(look)) readUndecoded(map);
  const { deformations, weights, joints } = geometries;
  return { parts, movable: { scene, rigid, joints: [...joints.values()], deformations, weights } };
}

/** The original name of the nearest named node. The loader's own names are altered to be unique. */
function nameOf(object: Object3D): string {
  for (let node: Object3D | null = object; node; node = node.parent) {
    const name: unknown = node.userData['name'];
    if (typeof name === 'string' && name !== '') return name;
  }
  return '';
}

function lookOf(material: MeshStandardMaterial, geometry: BufferGeometry): BaseLook {
  const { color, opacity, transparent, alphaTest } = material;
  const encode = (linear: number): number => srgbEncode(Math.min(Math.max(linear, 0), 1));
  const maps = mapsOf(material, geometry);
  const { map } = maps;
  // Exporters often mark opaque materials as blended. Blending those, unsorted and without depth, would show their
  // backs.
  const vertexAlpha = geometry.hasAttribute('color') && geometry.getAttribute('color').itemSize === 4;
  const blends = transparent && (opacity < 1 || map !== null || vertexAlpha);
  const alphaMode = blends ? 'blend' : alphaTest > 0 ? 'mask' : 'opaque';
  return {
    baseColor: [encode(color.r), encode(color.g), encode(color.b)],
    opacity: alphaMode === 'opaque' ? 1 : Math.min(Math.max(opacity, 0), 1),
    alphaMode,
    alphaCutoff: alphaTest,
    vertexColors: geometry.hasAttribute('color'),
    ...maps,
    ...surfaceOf(material),
  };
}

function readUndecoded(map: Texture): void {
  map.colorSpace = NoColorSpace;
  if (map.matrixAutoUpdate) map.updateMatrix();
}
