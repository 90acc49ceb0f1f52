// Turns the scene from three's glTF loader into a model's parts. Names, places, and looks in terms of the equation.
import {
  type BufferGeometry,
  DoubleSide,
  Matrix4,
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
import { Geometries, type GeometrySource, isSkinned, nodeOf } from './geometries.js';
import { type Instance, placeInstances } from './instances.js';
import type { Movable, RigidPart } from './motion.js';
import { coefficientsOf, mapsOf, surfaceOf } from './surfaces.js';

export interface Parts {
  readonly parts: readonly ContentPart[];
  readonly movable: Movable;
}

export async function collectParts(scene: Object3D, source: GeometrySource, slices: Slices): Promise<Parts> {
  const geometries = new Geometries(source, slices);
  const parts: ContentPart[] = [];
  const rigid: RigidPart[] = [];
  scene.updateMatrixWorld(true);
  const meshes: Mesh<BufferGeometry, MeshStandardMaterial>[] = [];
  const looks = new Map<string, Pick<ContentPart, 'look' | 'surface'>>();
  scene.traverse((object) => {
    if (object instanceof Mesh) meshes.push(object as Mesh<BufferGeometry, MeshStandardMaterial>);
  });
  for (const mesh of meshes) {
    await slices.pauseIfDue();
    const instances = await instancesOf(mesh, source, slices);
    if (instances.length === 0) continue;
    const geometry = await geometries.of(mesh);
    const name = nameOf(mesh);
    const { material } = mesh;
    await slices.map(instances, ({ matrix: within, color }) => {
      const matrix = isSkinned(mesh) ? new Matrix4() : mesh.matrixWorld.clone();
      if (within !== null) matrix.multiply(within);
      if (!matrix.elements.every(Number.isFinite)) throw new Error('the transform of a node is not finite');
      // Equal looks are one object: materials are compared by it.
      const key = [material.uuid, geometry.uuid, color].join(' ');
      const looked = looks.get(key) ?? lookedAt(material, lookOf(material, geometry, color ?? WHITE));
      looks.set(key, looked);
      const sides = material.side === DoubleSide ? 'double' : 'single';
      const part = { name, geometry, matrix, sides, ...looked } as const;
      parts.push(part);
      if (!isSkinned(mesh)) rigid.push({ part, mesh, within });
    });
  }
  if (parts.length === 0) throw new Error('it has no triangles');
  // Last, because parts can share a map and each has read its channel above.
  for (const { look } of parts) for (const map of mapsOfLook(look)) readUndecoded(map);
  const { deformations, weights, joints } = geometries;
  return { parts, movable: { scene, rigid, joints: [...joints.values()], deformations, weights } };
}

const lookedAt = (material: MeshStandardMaterial, look: BaseLook): Pick<ContentPart, 'look' | 'surface'> => ({
  look,
  surface: coefficientsOf(material, look),
});

const WHITE = [1, 1, 1, 1];
const ITSELF: readonly { readonly matrix: null; readonly color: null }[] = [{ matrix: null, color: null }];

function instancesOf(
  mesh: Mesh,
  source: GeometrySource,
  slices: Slices,
): Promise<readonly (Instance | (typeof ITSELF)[number])[]> | typeof ITSELF {
  const instances = source.instances[nodeOf(mesh, source) ?? -1];
  return instances === undefined ? ITSELF : placeInstances(instances, source.accessor, slices);
}

/** The original name of the nearest named node. The loader's own names are altered to be unique. */
function nameOf(object: Object3D): string {
  for (let node: Object3D | null = object; node; node = node.parent) {
    const name: unknown = node.userData['name'];
    if (typeof name === 'string' && name !== '') return name;
  }
  return '';
}

/** @param tint multiplies base colour and opacity; linear. */
function lookOf(material: MeshStandardMaterial, geometry: BufferGeometry, tint: readonly number[]): BaseLook {
  const { color, transparent, alphaTest } = material;
  const [red = 1, green = 1, blue = 1, alpha = 1] = tint;
  const opacity = material.opacity * alpha;
  const encode = (linear: number): number => srgbEncode(Math.min(Math.max(linear, 0), 1));
  const maps = mapsOf(material, geometry);
  const { map } = maps;
  // Exporters often mark opaque materials as blended. Blending those, unsorted and without depth, would show their
  // backs.
  const vertexAlpha = geometry.hasAttribute('color') && geometry.getAttribute('color').itemSize === 4;
  const blends = transparent && (opacity < 1 || map !== null || vertexAlpha);
  const alphaMode = blends ? 'blend' : alphaTest > 0 ? 'mask' : 'opaque';
  return {
    baseColor: [encode(color.r * red), encode(color.g * green), encode(color.b * blue)],
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
