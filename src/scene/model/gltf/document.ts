// Which parts of a glTF document are shown? The nodes and meshes of its scene, base colours and their textures. Everything else (other
// scenes, cameras, lights, animation, morph targets, other textures, extras) is removed before anything is loaded. Every index and
// size that the parser will use is checked here. Knows the JSON only, no bytes.
import { clip } from '../../../fields/clip.js';
import { ModelError } from '../model.js';
import {
  readAccessors,
  readBufferViews,
  requireClaims,
  type Accessor,
  type BufferView,
} from './accessors.js';
import {
  countAt,
  indexAt,
  listAt,
  numbersAt,
  objectAt,
  objectsAt,
  optionalObject,
  textAt,
  type JsonObject,
} from './json.js';
import { readMaterials, readTextures, type GltfTexture } from './materials.js';
import { DRACO, readPrimitives } from './primitives.js';

export interface GltfDocument {
  /** The reduced document for three's parser. It has no buffers and images: a plugin provides their bytes by index. */
  readonly json: JsonObject;
  readonly bufferViews: readonly BufferView[];
  /** Claimed byte length, and address; undefined for the GLB's own chunk. */
  readonly buffers: readonly { readonly byteLength: number; readonly uri: string | undefined }[];
  readonly images: readonly JsonObject[];
  readonly textures: readonly GltfTexture[];
  /** What the equation has no place for, by the file's own names. */
  readonly dropped: ReadonlySet<string>;
  readonly usesDraco: boolean;
}

/** Required extensions that do not change what is shown, or that are handled elsewhere. */
const HARMLESS =
  /^(KHR_draco_mesh_compression|KHR_mesh_quantization|KHR_texture_\w+|EXT_texture_\w+|KHR_materials_\w+|KHR_lights_punctual|KHR_animation_pointer|KHR_xmp\w*)$/;

/** @throws ModelError for unsupported content, a plain Error for broken content. */
export function readDocument(value: unknown): GltfDocument {
  const json = objectAt(value, 'the document');
  const version = textAt(optionalObject(json['asset'], 'asset')['version']);
  if (!version.startsWith('2.')) {
    throw new ModelError(
      'bad-model',
      `The model is glTF ${clip(version) || 'of no version'}; only glTF 2 is supported.`,
    );
  }
  for (const required of listAt(json['extensionsRequired'], 'extensionsRequired')) {
    if (!HARMLESS.test(String(required))) throw unsupported(String(required));
  }
  const bufferDefs = objectsAt(json['buffers'], 'buffers');
  const bufferViews = readBufferViews(json, bufferDefs.length);
  const accessors = readAccessors(json, bufferViews);
  const images = objectsAt(json['images'], 'images');
  const textures = readTextures(json, images.length);
  const { definitions: materials, dropped } = readMaterials(json, textures);
  const used = new Set<Accessor>();
  const meshes = objectsAt(json['meshes'], 'meshes').map((mesh) => ({
    name: textAt(mesh['name']),
    primitives: readPrimitives(mesh, {
      accessors,
      materials: materials.length,
      views: bufferViews.length,
      used,
    }),
  }));
  const skins = readSkins(json, accessors, used);
  const { nodes, roots } = readNodes(json, meshes, skins.length);
  requireClaims(used);
  const usesDraco = meshes.some((mesh) => mesh.primitives.some((primitive) => DRACO in primitive.extensions));
  return {
    json: {
      asset: { version: '2.0' },
      scene: 0,
      scenes: [{ nodes: roots }],
      nodes,
      // A mesh without triangles stays as an empty group, so that indices stay valid.
      meshes,
      skins,
      materials,
      textures: textures.map(() => ({})),
      accessors: accessors.map(({ definition }) => definition),
      bufferViews: bufferViews.map(({ byteLength, byteStride }) => ({ byteLength, byteStride })),
      extensionsUsed: [...(usesDraco ? [DRACO] : []), 'KHR_mesh_quantization', 'KHR_texture_transform'],
    },
    bufferViews,
    buffers: bufferDefs.map((buffer, i) => ({
      byteLength: countAt(buffer['byteLength'], `buffers[${String(i)}].byteLength`),
      uri: typeof buffer['uri'] === 'string' ? buffer['uri'] : undefined,
    })),
    images,
    textures,
    dropped,
    usesDraco,
  };
}

export function unsupported(extension: string): ModelError {
  return new ModelError(
    'bad-model',
    `The model needs the glTF extension ${clip(extension)}, which is not supported. Save it without that extension.`,
  );
}

interface Skin {
  readonly joints: readonly number[];
  readonly inverseBindMatrices: number | undefined;
}

function readSkins(json: JsonObject, accessors: readonly Accessor[], used: Set<Accessor>): readonly Skin[] {
  const nodeCount = listAt(json['nodes'], 'nodes').length;
  return objectsAt(json['skins'], 'skins').map((skin, i) => {
    const what = `skins[${String(i)}]`;
    const joints = listAt(skin['joints'], `${what}.joints`).map((joint) =>
      indexAt(joint, nodeCount, `${what}.joints`),
    );
    if (skin['inverseBindMatrices'] === undefined) return { joints, inverseBindMatrices: undefined };
    const index = indexAt(skin['inverseBindMatrices'], accessors.length, `${what}.inverseBindMatrices`);
    const accessor = accessors[index];
    if (accessor?.components !== 16 || accessor.count < joints.length)
      throw new Error(`${what} has too few matrices`);
    used.add(accessor);
    return { joints, inverseBindMatrices: index };
  });
}

interface Meshes {
  readonly length: number;
  readonly [index: number]: { readonly primitives: readonly { readonly attributes: JsonObject }[] };
}

function readNodes(
  json: JsonObject,
  meshes: Meshes,
  skinCount: number,
): { nodes: readonly JsonObject[]; roots: readonly number[] } {
  const defs = objectsAt(json['nodes'], 'nodes');
  const nodes = defs.map((node, i): JsonObject => {
    const what = `nodes[${String(i)}]`;
    const mesh =
      node['mesh'] === undefined ? undefined : indexAt(node['mesh'], meshes.length, `${what}.mesh`);
    const skin = node['skin'] === undefined ? undefined : indexAt(node['skin'], skinCount, `${what}.skin`);
    const primitives = mesh === undefined ? [] : (meshes[mesh]?.primitives ?? []);
    const bound = primitives.length > 0 && primitives.every(({ attributes }) => 'WEIGHTS_0' in attributes);
    return {
      name: textAt(node['name']),
      children: listAt(node['children'], `${what}.children`).map((child) =>
        indexAt(child, defs.length, what),
      ),
      mesh: primitives.length > 0 ? mesh : undefined,
      skin: bound ? skin : undefined,
      matrix: numbersAt(node['matrix'], 16, `${what}.matrix`),
      translation: numbersAt(node['translation'], 3, `${what}.translation`),
      rotation: numbersAt(node['rotation'], 4, `${what}.rotation`),
      scale: numbersAt(node['scale'], 3, `${what}.scale`),
    };
  });
  const children = nodes.map((node) => node['children'] as readonly number[]);
  requireTree(children);
  const scenes = objectsAt(json['scenes'], 'scenes');
  if (scenes.length === 0) {
    const inner = new Set(children.flat());
    return { nodes, roots: nodes.map((_, i) => i).filter((i) => !inner.has(i)) };
  }
  const scene = scenes[indexAt(json['scene'] ?? 0, scenes.length, 'scene')] ?? {};
  const roots = listAt(scene['nodes'], 'the scene').map((root) => indexAt(root, nodes.length, 'the scene'));
  return { nodes, roots: [...new Set(roots)] };
}

/** Throws for a cycle of nodes, on which the parser would wait forever. */
function requireTree(children: readonly (readonly number[])[]): void {
  const parents = new Map<number, number>();
  children.forEach((list, node) => {
    for (const child of list) {
      if (parents.has(child)) throw new Error(`nodes[${String(child)}] has two parents`);
      parents.set(child, node);
    }
  });
  const checked = new Set<number>();
  for (const start of parents.keys()) {
    const path = new Set<number>();
    for (
      let node: number | undefined = start;
      node !== undefined && !checked.has(node);
      node = parents.get(node)
    ) {
      if (path.has(node)) throw new Error(`nodes[${String(node)}] contains itself`);
      path.add(node);
    }
    for (const node of path) checked.add(node);
  }
}
