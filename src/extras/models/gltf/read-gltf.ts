// Reads glTF 2 and GLB by three's loader, which gets a checked document, and bytes by index, not by
// address. A chunk.
import {
  type BufferGeometry,
  Matrix4,
  Mesh,
  type MeshStandardMaterial,
  NoColorSpace,
  type Object3D,
  type Texture,
} from 'three';
import {
  GLTFLoader,
  type GLTFLoaderPlugin,
  type GLTFParser,
} from 'three/addons/loaders/GLTFLoader.js';
import { ImageTextures } from '../image.js';
import type { ContentPart } from '../../../phong/model/model.js';
import { mapsOfLook, type ModelReader, ownedModel, requireDecoders } from '../model-reader.js';
import { Slices } from '../slices.js';
import type { Accessor } from './accessors.js';
import type { Attribute } from './attributes.js';
import { gltfBytes } from './bytes.js';
import { openContainer } from './container.js';
import { readDocument } from './document.js';
import { checkDracoHeader, dracoLoader } from './draco-loader.js';
import {
  type FileIndices,
  Geometries,
  type GeometrySource,
  isSkinned,
  nodeOf,
} from './geometries.js';
import { type Instance, placeInstances } from './instances.js';
import { lookOf } from './materials.js';
import { type Movable, readMotion, type RigidPart } from './motion.js';
import { gltfTexture } from './textures.js';
import { nameOf } from '../../../phong/fields/file-names.js';

export const read: ModelReader = async (source) => {
  const { budget } = source;
  const slices = new Slices(source.signal, budget);
  const container = await openContainer(source.bytes, budget, slices);
  const document = await readDocument(container.json, budget, slices);
  await slices.pauseIfDue();
  const bytes = gltfBytes(document, container, source);
  const images = new ImageTextures(source);
  const turn = turnsBetweenPauses(slices);
  const meshTurn = turnsBetweenPauses(slices);
  const pluginOf = (parser: GLTFParser): GLTFLoaderPlugin => ({
    name: 'phong_viewer_bytes',
    loadNode: (index) => turn().then(() => parser.loadNode(index)),
    loadMesh: (index) => turn().then(() => parser.loadMesh(index)),
    // Nodes that name one mesh are copies of it, which are made once it is there.
    createNodeMesh: (index) => {
      const { mesh } = (parser.json as { nodes: { mesh?: number }[] }).nodes[index]!;
      if (mesh === undefined) return null;
      const loaded = parser.getDependency('mesh', mesh);
      return meshTurn(loaded).then(() => parser.createNodeMesh(index));
    },
    loadBufferView: async (index) => {
      const view = await bytes.view(index);
      const claims = document.draco.get(index);
      if (claims) {
        checkDracoHeader(new Uint8Array(view), claims);
      }
      return view;
    },
    // The loader leaves a texture out that is null, although its types do not say so.
    loadTexture: (index) => gltfTexture(index, document, bytes, images, source) as Promise<Texture>,
  });
  const loader = new GLTFLoader();
  loader.register(pluginOf);
  try {
    if (document.draco.size > 0) {
      requireDecoders(source, 'Draco');
      loader.setDRACOLoader(dracoLoader(slices, source.signal));
    }
    source.signal.throwIfAborted();
    // It takes a parsed document too, whatever its types say: a text would be parsed in one task.
    const { scene, parser } = await loader.parseAsync(document.json as unknown as string, '');
    source.signal.throwIfAborted();
    const accessor = ({ index }: Accessor) =>
      parser.getDependency('accessor', index) as Promise<Attribute>;
    const node = (index: number) => parser.getDependency('node', index) as Promise<Object3D>;
    const indicesOf = (object: Object3D): FileIndices | undefined =>
      parser.associations.get(object);
    const file = { ...document, indicesOf, accessor, budget };
    const { parts, movable } = await collectParts(scene, file, slices);
    const dropped = new Set(document.dropped);
    const motion = await readMotion(
      nameOf(source.url),
      document.animations,
      { node, accessor },
      movable,
      parts,
      { dropped, slices },
    );
    source.signal.throwIfAborted();
    return { ...ownedModel(parts, () => void images.close()), motion, dropped };
  } catch (error) {
    void images.close();
    throw error;
  }
};

/**
 * A promise for each item of a list that the loader starts at once: they resolve in turn, each once
 * what it waits for is there, with pauses in between.
 */
function turnsBetweenPauses(slices: Slices): (waitsFor?: Promise<unknown>) => Promise<void> {
  let last = Promise.resolve();
  return (waitsFor) => (last = Promise.all([last, waitsFor]).then(() => slices.pauseIfDue()));
}

/**
 * Turns the scene from three's loader into a model's parts: names, places, and looks in terms of
 * the equation.
 */
async function collectParts(
  scene: Object3D,
  source: GeometrySource,
  slices: Slices,
): Promise<{ readonly parts: readonly ContentPart[]; readonly movable: Movable }> {
  const geometries = new Geometries(source, slices);
  const parts: ContentPart[] = [];
  const rigid: RigidPart[] = [];
  scene.updateMatrixWorld(true);
  const meshes: Mesh<BufferGeometry, MeshStandardMaterial>[] = [];
  const looks = new Map<string, ReturnType<typeof lookOf>>();
  scene.traverse((object) => {
    if (object instanceof Mesh) {
      meshes.push(object as Mesh<BufferGeometry, MeshStandardMaterial>);
    }
  });
  for (const mesh of meshes) {
    await slices.pauseIfDue();
    const placed = source.instances[nodeOf(mesh, source) ?? -1];
    const instances =
      placed === undefined ? ITSELF : await placeInstances(placed, source.accessor, slices);
    if (instances.length === 0) continue;
    const geometry = await geometries.of(mesh);
    const name = originalName(mesh);
    const { material } = mesh;
    await slices.map(instances, ({ matrix: within, color }) => {
      const matrix = isSkinned(mesh) ? new Matrix4() : mesh.matrixWorld.clone();
      if (within !== null) {
        matrix.multiply(within);
      }
      if (!matrix.elements.every(Number.isFinite)) {
        throw new Error('the transform of a node is not finite');
      }
      // Equal looks are one object: materials are compared by it.
      const key = [material.uuid, geometry.uuid, color].join(' ');
      const look = looks.get(key) ?? lookOf(material, geometry, color ?? WHITE);
      looks.set(key, look);
      const part = { name, geometry, matrix, ...look };
      parts.push(part);
      if (!isSkinned(mesh)) {
        rigid.push({ part, mesh, within });
      }
    });
  }
  if (parts.length === 0) throw new Error('it has no triangles');
  // Last: parts can share a map, and the look of each is read from the map as GLTFLoader made it.
  for (const map of parts.flatMap(({ look }) => mapsOfLook(look))) {
    map.colorSpace = NoColorSpace; // GLTFLoader's would make the GPU decode it in srgb shading too
    if (map.matrixAutoUpdate) {
      map.updateMatrix();
    }
  }
  const { deformations, weights, joints } = geometries;
  return { parts, movable: { scene, rigid, joints: [...joints.values()], deformations, weights } };
}

const WHITE = [1, 1, 1, 1];
const ITSELF: readonly Instance[] = [{ matrix: null, color: null }];

/** The original name of the nearest named node. The loader's own names are altered to be unique. */
function originalName(object: Object3D): string {
  for (let node: Object3D | null = object; node; node = node.parent) {
    const name: unknown = node.userData['name'];
    if (typeof name === 'string' && name !== '') return name;
  }
  return '';
}
