// Reduces a glTF document to what is shown: the nodes and meshes of its scene, base colours and their textures.
// Everything else (other scenes, cameras, lights, other textures, extras) is removed before anything is loaded. Every
// index and size that the parser will use is checked here. Knows the JSON only, no bytes.
import { clip } from '../../fields/clip.js';
import type { ModelBudget } from '../model-budget.js';
import { ModelError } from '../model.js';
import { type Accessor, Accessors, readBufferViews, type BufferView } from './accessors.js';
import { readAnimations, type GltfAnimation } from './animations.js';
import { countClaims, type DracoClaims } from './claims.js';
import {
  countAt,
  indexAt,
  listAt,
  numberAt,
  numbersAt,
  objectAt,
  objectsAt,
  optionalObject,
  textAt,
  type JsonObject,
} from './json.js';
import { readMaterials, readTextures, type GltfTexture } from './materials.js';
import { DRACO, type MorphAccessors, readPrimitives, type Primitive } from './primitives.js';

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
  readonly animations: readonly GltfAnimation[];
  /** The morph targets of each primitive of each mesh. */
  readonly targets: readonly (readonly (readonly MorphAccessors[])[])[];
  /** The weights of each node's morph targets; empty without. */
  readonly weights: readonly (readonly number[])[];
  /** What the Draco data in a buffer view must decode to at most, by the view's index. */
  readonly draco: ReadonlyMap<number, DracoClaims>;
}

/** Required extensions that do not change what is shown, or that are handled elsewhere. */
const HARMLESS =
  /^(KHR_draco_mesh_compression|(EXT|KHR)_meshopt_compression|KHR_mesh_quantization|KHR_texture_\w+|EXT_texture_\w+|KHR_materials_\w+|KHR_lights_punctual|KHR_animation_pointer|KHR_xmp\w*)$/;

/**
 * @param budget gets everything that the document claims, but images.
 * @throws ModelError for unsupported or too much content, a plain Error for broken content.
 */
export function readDocument(value: unknown, budget: ModelBudget): GltfDocument {
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
  const accessors = new Accessors(json, bufferViews, budget);
  const images = objectsAt(json['images'], 'images');
  const textures = readTextures(json, images.length);
  const { definitions: materials, dropped: unused } = readMaterials(json, textures);
  const dropped = new Set(unused);
  const context = { accessors, materials, views: bufferViews.length };
  const meshes = objectsAt(json['meshes'], 'meshes').map((mesh) => ({
    name: textAt(mesh['name']),
    weights: listAt(mesh['weights'], 'weights').map((weight) => numberAt(weight, 'weights', 0)),
    primitives: readPrimitives(mesh, context),
  }));
  const skins = readSkins(json, accessors);
  const { nodes, roots } = readNodes(json, meshes, skins, budget);
  const draco = countClaims(nodes, roots, { accessors, budget });
  const inScene = withChildren(nodes, roots);
  const shown = withJoints(nodes, inScene);
  budget.add({ nodes: shown.size - inScene.size });
  const weights = nodes.map((node) => node.weights);
  const targets = weights.map((list, i) => (shown.has(i) ? list.length : undefined));
  const animations = readAnimations(json, { accessors, targets, budget }, dropped);
  return {
    json: {
      asset: { version: '2.0' },
      scene: 0,
      scenes: [{ nodes: roots }],
      nodes: nodes.map(({ definition, mesh, children, skinIndex }, i) => ({
        ...definition,
        // A joint outside the scene is a place, no more.
        children: children.filter((child) => shown.has(child)),
        ...(inScene.has(i) ? { mesh, skin: skinIndex } : {}),
      })),
      // A mesh without triangles stays as an empty group, so that indices stay valid.
      meshes: meshes.map(({ name, primitives }) => ({
        name,
        primitives: primitives.map(({ definition }) => definition),
      })),
      skins: skins.map(({ joints, inverseBindMatrices }) => ({
        joints,
        inverseBindMatrices: inverseBindMatrices?.index,
      })),
      materials,
      textures: textures.map(() => ({})),
      accessors: accessors.definitions(),
      bufferViews: bufferViews.map(({ byteLength, byteStride }) => ({ byteLength, byteStride })),
      extensionsUsed: [...(draco.size > 0 ? [DRACO] : []), 'KHR_mesh_quantization', 'KHR_texture_transform'],
    },
    bufferViews,
    buffers: bufferDefs.map((buffer, i) => ({
      byteLength: countAt(buffer['byteLength'], `buffers[${String(i)}].byteLength`),
      uri: typeof buffer['uri'] === 'string' ? buffer['uri'] : undefined,
    })),
    images,
    textures,
    dropped,
    animations,
    targets: meshes.map(({ primitives }) => primitives.map((primitive) => primitive.targets)),
    weights,
    draco,
  };
}

function unsupported(extension: string): ModelError {
  return new ModelError(
    'bad-model',
    `The model needs the glTF extension ${clip(extension)}, which is not supported. Save it without that extension.`,
  );
}

interface Skin {
  readonly joints: readonly number[];
  readonly inverseBindMatrices: Accessor | undefined;
}

function readSkins(json: JsonObject, accessors: Accessors): readonly Skin[] {
  const nodeCount = listAt(json['nodes'], 'nodes').length;
  return objectsAt(json['skins'], 'skins').map((skin, i) => {
    const what = `skins[${String(i)}]`;
    const joints = listAt(skin['joints'], `${what}.joints`).map((joint) =>
      indexAt(joint, nodeCount, `${what}.joints`),
    );
    if (skin['inverseBindMatrices'] === undefined) return { joints, inverseBindMatrices: undefined };
    const inverseBindMatrices = accessors.at(skin['inverseBindMatrices'], `${what}.inverseBindMatrices`);
    if (inverseBindMatrices.components !== 16 || inverseBindMatrices.count < joints.length)
      throw new Error(`${what} has too few matrices`);
    return { joints, inverseBindMatrices };
  });
}

interface GltfNode {
  /** Name and place, for the parser. */
  readonly definition: JsonObject;
  /** Undefined where none of it is drawn. */
  readonly mesh: number | undefined;
  readonly children: readonly number[];
  readonly primitives: readonly Primitive[];
  readonly skin: Skin | undefined;
  readonly skinIndex: number | undefined;
  readonly weights: readonly number[];
}

function readNodes(
  json: JsonObject,
  meshes: readonly { readonly primitives: readonly Primitive[]; readonly weights: readonly number[] }[],
  skins: readonly Skin[],
  budget: ModelBudget,
): { nodes: readonly GltfNode[]; roots: readonly number[] } {
  const defs = objectsAt(json['nodes'], 'nodes');
  const nodes = defs.map((node, i): GltfNode => {
    const what = `nodes[${String(i)}]`;
    const mesh =
      node['mesh'] === undefined ? undefined : indexAt(node['mesh'], meshes.length, `${what}.mesh`);
    const skin = node['skin'] === undefined ? undefined : indexAt(node['skin'], skins.length, `${what}.skin`);
    const primitives = mesh === undefined ? [] : (meshes[mesh]?.primitives ?? []);
    const targets = primitives.reduce((most, primitive) => Math.max(most, primitive.targets.length), 0);
    // A float64 each, in the file's list and in the pose.
    budget.add({ values: 4 * targets });
    const given = node['weights'] === undefined ? undefined : listAt(node['weights'], `${what}.weights`);
    const fallback = mesh === undefined ? [] : (meshes[mesh]?.weights ?? []);
    const bound =
      skin !== undefined &&
      primitives.length > 0 &&
      primitives.every(({ definition }) => 'WEIGHTS_0' in definition.attributes);
    const children = listAt(node['children'], `${what}.children`).map((child) =>
      indexAt(child, defs.length, what),
    );
    return {
      children,
      mesh: primitives.length > 0 ? mesh : undefined,
      primitives,
      skin: bound ? skins[skin] : undefined,
      skinIndex: bound ? skin : undefined,
      weights: Array.from({ length: targets }, (_, k) =>
        numberAt((given ?? fallback)[k], `${what}.weights`, 0),
      ),
      definition: {
        name: textAt(node['name']),
        matrix: numbersAt(node['matrix'], 16, `${what}.matrix`),
        translation: numbersAt(node['translation'], 3, `${what}.translation`),
        rotation: numbersAt(node['rotation'], 4, `${what}.rotation`),
        scale: numbersAt(node['scale'], 3, `${what}.scale`),
      },
    };
  });
  requireTree(nodes.map((node) => node.children));
  return { nodes, roots: readRoots(json, nodes) };
}

/**
 * The scene's nodes without those that lie below another one: they would be there twice. Without a scene, all nodes.
 */
function readRoots(json: JsonObject, nodes: readonly GltfNode[]): readonly number[] {
  const scenes = objectsAt(json['scenes'], 'scenes');
  const all = nodes.map((_, i) => i);
  const listed =
    scenes.length === 0
      ? all
      : listAt(scenes[indexAt(json['scene'] ?? 0, scenes.length, 'scene')]?.['nodes'], 'the scene').map(
          (root) => indexAt(root, nodes.length, 'the scene'),
        );
  const below = withChildren(
    nodes,
    listed.flatMap((root) => nodes[root]?.children ?? []),
  );
  return [...new Set(listed)].filter((root) => !below.has(root));
}

function withChildren(nodes: readonly GltfNode[], roots: readonly number[]): ReadonlySet<number> {
  const reached = new Set(roots);
  for (const index of reached) for (const child of nodes[index]?.children ?? []) reached.add(child);
  return reached;
}

/** The nodes of the scene, and the joints of its skins, which may lie outside it. */
function withJoints(nodes: readonly GltfNode[], inScene: ReadonlySet<number>): ReadonlySet<number> {
  const shown = new Set(inScene);
  for (const index of inScene) for (const joint of nodes[index]?.skin?.joints ?? []) shown.add(joint);
  return shown;
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
