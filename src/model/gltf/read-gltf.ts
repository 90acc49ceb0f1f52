// Reads glTF 2 and GLB by three's own loader, which gets a reduced and checked document and no addresses to fetch.
// Bytes and images are provided by index. A separate chunk.
import type { Object3D, Texture } from 'three';
import { GLTFLoader, type GLTFLoaderPlugin, type GLTFParser } from 'three/addons/loaders/GLTFLoader.js';
import type { ModelReader } from '../model-reader.js';
import { nameOf } from '../file-name.js';
import { ownedModel } from '../owned-model.js';
import { Slices } from '../slices.js';
import type { Accessor } from './accessors.js';
import type { Attribute } from './attributes.js';
import { gltfBytes } from './bytes.js';
import { openContainer } from './container.js';
import { readDocument } from './document.js';
import { checkDracoHeader } from './draco-header.js';
import { dracoLoader } from './draco-loader.js';
import type { FileIndices } from './geometries.js';
import { readMotion } from './motion.js';
import { collectParts } from './collect-parts.js';
import { gltfTextures } from './textures.js';

export const readGltf: ModelReader = async (source) => {
  const { budget } = source;
  const slices = new Slices(source.signal, source.budget);
  const container = await openContainer(source.bytes, budget, slices);
  const document = await readDocument(container.json, budget, slices);
  await slices.pauseIfDue();
  const bytes = gltfBytes(document, container, source);
  const textures = gltfTextures(document, bytes, budget, source);
  const turn = turnsOf(slices);
  const pluginOf = (parser: GLTFParser): GLTFLoaderPlugin => ({
    name: 'phong_viewer_bytes',
    loadNode: (index) => turn().then(() => parser.loadNode(index)),
    loadMesh: (index) => turn().then(() => parser.loadMesh(index)),
    loadBufferView: async (index) => {
      const view = await bytes.view(index);
      const claims = document.draco.get(index);
      if (claims) checkDracoHeader(new Uint8Array(view), claims);
      return view;
    },
    // The loader leaves a texture out that is null, although its types do not say so.
    loadTexture: (index) => textures.texture(index) as Promise<Texture>,
  });
  const loader = new GLTFLoader();
  loader.register(pluginOf);
  try {
    if (document.draco.size > 0) loader.setDRACOLoader(dracoLoader(slices, source.signal));
    source.signal.throwIfAborted();
    // It takes a parsed document too, whatever its types say: a text would be parsed in one task.
    const { scene, parser } = await loader.parseAsync(document.json as unknown as string, '');
    source.signal.throwIfAborted();
    const { animations, targets, weights, instances } = document;
    const accessor = ({ index }: Accessor): Promise<Attribute> =>
      parser.getDependency('accessor', index) as Promise<Attribute>;
    const node = (index: number): Promise<Object3D> => parser.getDependency('node', index) as Promise<Object3D>;
    const indicesOf = (object: Object3D): FileIndices | undefined => parser.associations.get(object);
    const file = { indicesOf, accessor, targets, weights, instances, budget };
    const { parts, movable } = await collectParts(scene, file, slices);
    const dropped = new Set(document.dropped);
    const place = nameOf(source.url);
    const motion = await readMotion(place, animations, { node, accessor }, movable, { dropped, slices });
    source.signal.throwIfAborted();
    return { ...ownedModel(parts, () => void textures.close()), motion, dropped };
  } catch (error) {
    void textures.close();
    throw error;
  }
};

/** A promise for each item of a list that the loader starts at once: they resolve in turn, with pauses in between. */
function turnsOf(slices: Slices): () => Promise<void> {
  let last = Promise.resolve();
  return () => (last = last.then(() => slices.pauseIfDue()));
}
