// Reduces a glTF document to what is shown: the nodes and meshes of its scene, with materials,
// textures, skins and animations. Everything else is removed before anything is loaded. Every index
// and size that the parser will use is checked here. Knows the JSON only, no bytes.
import { clip } from '../../../phong/fields/clip.js';
import { requireAtMost } from '../../../phong/model/budget.js';
import { ModelError } from '../../../phong/model/model.js';
import type { ModelBudget } from '../../../phong/model/model-budget.js';
import type { Slices } from '../slices.js';
import { type Accessor, Accessors, readBufferViews, type BufferView } from './accessors.js';
import { readAnimations, type GltfAnimation } from './animations.js';
import type { DracoClaims } from './draco-loader.js';
import { extensionsLeftOut, unreadable, VISIBILITY } from './extensions.js';
import { type Instances, readInstances } from './instances.js';
import {
  indexAt,
  optionalIndex,
  listAt,
  numberAt,
  numbersAt,
  objectAt,
  objectsAt,
  optionalObject,
  shortListAt,
  textAt,
  type JsonObject,
} from './json.js';
import { readMaterials, readTextures, type GltfTexture } from './materials.js';
import { DRACO, type Primitive, type PrimitiveContext, readPrimitives } from './primitives.js';
import { DRACO_LIMIT } from '../limits.js';

export interface GltfDocument {
  /**
   * The reduced document for three's parser. It has no buffers and images: a plugin provides their
   * bytes by index.
   */
  readonly json: JsonObject;
  readonly bufferViews: readonly BufferView[];
  /** Their addresses; undefined for the GLB's own chunk. */
  readonly buffers: readonly (string | undefined)[];
  readonly images: readonly JsonObject[];
  readonly textures: readonly GltfTexture[];
  /** What the equation has no place for, by the file's own names. */
  readonly dropped: ReadonlySet<string>;
  readonly animations: readonly GltfAnimation[];
  /** By mesh. */
  readonly primitives: readonly (readonly Primitive[])[];
  /** The weights of each node's morph targets; empty without. */
  readonly weights: readonly (readonly number[])[];
  /** The instances of each node's mesh; undefined where the node itself is the only one. */
  readonly instances: readonly (Instances | undefined)[];
  /** What the Draco data in a buffer view must decode to at most, by the view's index. */
  readonly draco: ReadonlyMap<number, DracoClaims>;
}

/**
 * Nodes inside nodes: three.js visits children by recursion, and would overflow the stack in some
 * browsers.
 */
const DEPTH_LIMIT = 1000;

/**
 * @param budget gets everything that the document claims, but images.
 * @throws ModelError for unsupported or too much content, a plain Error for broken content.
 */
export async function readDocument(
  value: unknown,
  budget: ModelBudget,
  slices: Slices,
): Promise<GltfDocument> {
  const json = objectAt(value, 'the document');
  requireReadable(json);
  budget.add({ nodes: listAt(json['nodes'], 'nodes').length });
  const dropped = new Set(extensionsLeftOut(json));
  const bufferDefs = objectsAt(json['buffers'], 'buffers');
  const bufferViews = await readBufferViews(json, bufferDefs.length, slices);
  const accessors = await Accessors.of(json, bufferViews, budget, slices);
  const images = objectsAt(json['images'], 'images');
  const textures = await readTextures(json, images.length, slices);
  const materials = await readMaterials(json, textures, dropped, slices);
  const meshes = await readMeshes(json, {
    accessors,
    materials,
    views: bufferViews.length,
    dropped,
    slices,
  });
  const skins = await readSkins(json, accessors, slices);
  const nodes = await readNodes(json, { meshes, skins, accessors, budget, dropped }, slices);
  const roots = readRoots(json, nodes);
  const inScene = withChildren(nodes, roots);
  // Hidden nodes and all below them are places, no more: they can be joints.
  const hiddenRoots = nodes.flatMap((node, i) => (node.hidden ? i : []));
  const hidden = withChildren(nodes, hiddenRoots);
  const visible = new Set([...inScene].filter((index) => !hidden.has(index)));
  const drawn = Array.from(visible, (index) => nodes[index]!);
  const draco = await countDrawn(drawn, accessors, budget, slices);
  const shown = withJoints(drawn, inScene);
  const weights = nodes.map((node) => node.weights);
  const targets = weights.map((list, i) => (shown.has(i) ? list.length : undefined));
  const animations = await readAnimations(json, { accessors, targets, budget, dropped, slices });
  return {
    json: {
      asset: { version: '2.0' },
      scene: 0,
      scenes: [{ nodes: roots }],
      nodes: await slices.map(nodes, ({ definition, mesh, children, skin }, i) => ({
        ...definition,
        // A joint outside the scene is a place, no more.
        children: children.filter((child) => shown.has(child)),
        ...(visible.has(i) ? { mesh, skin: skin?.index } : {}),
      })),
      // A mesh without triangles stays as an empty group, so that indices stay valid.
      meshes: await slices.map(meshes, ({ name, primitives }) => ({
        name,
        primitives: primitives.map(({ definition }) => definition),
      })),
      skins: await slices.map(skins, ({ joints, inverseBindMatrices: own }) => ({
        joints,
        inverseBindMatrices: own?.index,
      })),
      materials,
      textures: await slices.map(textures, () => ({})),
      accessors: await accessors.definitions(slices),
      bufferViews: await slices.map(bufferViews, ({ byteLength, byteStride }) => ({
        byteLength,
        byteStride,
      })),
      extensionsUsed: [
        ...(draco.size > 0 ? [DRACO] : []),
        'KHR_mesh_quantization',
        'KHR_texture_transform',
      ],
    },
    bufferViews,
    buffers: bufferDefs.map(({ uri }) => (typeof uri === 'string' ? uri : undefined)),
    images,
    textures,
    dropped,
    animations,
    primitives: meshes.map(({ primitives }) => primitives),
    weights,
    instances: nodes.map((node) => node.instances),
    draco,
  };
}

function requireReadable(json: JsonObject) {
  const version = textAt(optionalObject(json['asset'], 'asset')['version']);
  if (!version.startsWith('2.')) {
    const fact = `The model is glTF ${clip(version) || 'of no version'}; only glTF 2 is supported.`;
    throw new ModelError('bad-model', fact);
  }
  const required = unreadable(json);
  if (required !== undefined) {
    const fact = `The model needs the glTF extension ${clip(required)}, which is not supported.`;
    throw new ModelError('bad-model', fact, { advice: 'Save it without that extension.' });
  }
}

interface Skin {
  readonly index: number;
  readonly joints: readonly number[];
  readonly inverseBindMatrices: Accessor | undefined;
}

function readSkins(
  json: JsonObject,
  accessors: Accessors,
  slices: Slices,
): Promise<readonly Skin[]> {
  const nodeCount = listAt(json['nodes'], 'nodes').length;
  return slices.map(objectsAt(json['skins'], 'skins'), (skin, i) => {
    const what = `skins[${String(i)}]`;
    const listName = `${what}.joints`;
    const joints = shortListAt(skin['joints'], listName).map((joint) =>
      indexAt(joint, nodeCount, listName),
    );
    const given = skin['inverseBindMatrices'];
    const inverseBindMatrices =
      given === undefined ? undefined : accessors.at(given, `${what}.inverseBindMatrices`);
    const { components = 16, count = joints.length } = inverseBindMatrices ?? {};
    if (components !== 16 || count < joints.length) {
      throw new Error(`${what} has too few matrices`);
    }
    return { index: i, joints, inverseBindMatrices };
  });
}

interface GltfMesh {
  readonly name: string;
  readonly primitives: readonly Primitive[];
  readonly weights: readonly number[];
  /** The most morph targets of a primitive. */
  readonly targets: number;
  /** All primitives have joints. */
  readonly bound: boolean;
}

async function readMeshes(
  json: JsonObject,
  context: PrimitiveContext,
): Promise<readonly GltfMesh[]> {
  const meshes: GltfMesh[] = [];
  for (const mesh of objectsAt(json['meshes'], 'meshes')) {
    const primitives = await readPrimitives(mesh, context);
    await context.slices.pauseIfDue();
    meshes.push({
      name: textAt(mesh['name']),
      primitives,
      weights: shortListAt(mesh['weights'], 'weights').map((weight) =>
        numberAt(weight, 'weights', 0),
      ),
      targets: primitives.reduce((most, { targets }) => Math.max(most, targets.length), 0),
      bound:
        primitives.length > 0 &&
        primitives.every(({ definition }) => 'WEIGHTS_0' in definition.attributes),
    });
  }
  return meshes;
}

interface GltfNode {
  /** Name and place, for the parser. */
  readonly definition: JsonObject;
  readonly hidden: boolean;
  /** Undefined where none of it is drawn. */
  readonly mesh: number | undefined;
  readonly children: readonly number[];
  readonly primitives: readonly Primitive[];
  readonly instances: Instances | undefined;
  readonly skin: Skin | undefined;
  readonly weights: readonly number[];
}

interface NodeContext {
  readonly meshes: readonly GltfMesh[];
  readonly skins: readonly Skin[];
  readonly accessors: Accessors;
  readonly budget: ModelBudget;
  readonly dropped: Set<string>;
}

async function readNodes(
  json: JsonObject,
  { meshes, skins, accessors, budget, dropped }: NodeContext,
  slices: Slices,
): Promise<readonly GltfNode[]> {
  const defs = objectsAt(json['nodes'], 'nodes');
  const nodes = await slices.map(defs, (node, i): GltfNode => {
    const what = `nodes[${String(i)}]`;
    const index = optionalIndex(node['mesh'], meshes.length, `${what}.mesh`);
    const mesh = index === undefined ? undefined : meshes[index];
    const skin = optionalIndex(node['skin'], skins.length, `${what}.skin`);
    const instances = readInstances(node, accessors, what, dropped);
    const { targets = 0, bound = false, weights: fallback = [] } = mesh ?? {};
    const primitives = instances?.count === 0 ? [] : (mesh?.primitives ?? []);
    // A float64 each, in the file's list and in the pose.
    budget.add({ values: 4 * targets });
    const weightsName = `${what}.weights`;
    const given = node['weights'] === undefined ? fallback : listAt(node['weights'], weightsName);
    const visible = optionalObject(optionalObject(node['extensions'], what)[VISIBILITY], what)[
      'visible'
    ];
    return {
      children: shortListAt(node['children'], `${what}.children`).map((child) =>
        indexAt(child, defs.length, what),
      ),
      hidden: visible === false,
      mesh: primitives.length > 0 ? index : undefined,
      primitives,
      instances,
      skin: bound && skin !== undefined ? skins[skin] : undefined,
      weights: Array.from({ length: targets }, (_, k) => numberAt(given[k], weightsName, 0)),
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
  return nodes;
}

/**
 * Counts parts and corners, gives access to the accessors of what is drawn, and returns the largest
 * claims of what each Draco buffer view holds. geometries.ts counts the numbers of what it makes as
 * it makes it.
 * @throws ModelError `too-large` past a limit.
 */
async function countDrawn(
  nodes: readonly GltfNode[],
  accessors: Accessors,
  budget: ModelBudget,
  slices: Slices,
): Promise<ReadonlyMap<number, DracoClaims>> {
  const counted = new Set<Primitive | Skin>();
  const packed = new Map<number, DracoClaims>();
  for (const { primitives, instances, skin } of nodes) {
    if (primitives.length === 0) continue;
    for (const accessor of Object.values(instances?.lists ?? {})) {
      accessors.read(accessor);
    }
    if (skin !== undefined && !counted.has(skin)) {
      counted.add(skin);
      // A joint has a matrix in the file and one in its pose, in float64.
      budget.add({ values: skin.joints.length * 64 });
      if (skin.inverseBindMatrices !== undefined) {
        accessors.read(skin.inverseBindMatrices);
      }
    }
    const copies = instances?.count ?? 1;
    for (const primitive of primitives) {
      const { attributes, corners, vertices } = primitive;
      budget.add({ parts: copies, corners: copies * corners });
      await slices.pauseIfDue();
      if (counted.has(primitive)) continue;
      counted.add(primitive);
      for (const accessor of primitive.read) {
        accessors.read(accessor);
      }
      if (primitive.packed === undefined) continue;
      requireAtMost(Math.max(corners, vertices), DRACO_LIMIT, 'corners in one Draco mesh');
      // The decoder's numbers.
      budget.add({
        values: attributes.reduce((sum, { items }) => sum + items * vertices, corners),
      });
      const most = packed.get(primitive.packed) ?? primitive;
      const claims = {
        corners: Math.max(most.corners, corners),
        vertices: Math.max(most.vertices, vertices),
      };
      packed.set(primitive.packed, claims);
    }
  }
  return packed;
}

/**
 * The scene's nodes without those that lie below another one: they would be there twice. Without a
 * scene, all nodes.
 */
function readRoots(json: JsonObject, nodes: readonly GltfNode[]): readonly number[] {
  const scenes = listAt(json['scenes'], 'scenes');
  const shown = scenes.length === 0 ? 0 : indexAt(json['scene'] ?? 0, scenes.length, 'scene');
  // The others can be millions.
  const scene = optionalObject(scenes[shown], `scenes[${String(shown)}]`);
  const listed =
    scenes.length === 0
      ? nodes.map((_, i) => i)
      : shortListAt(scene['nodes'], 'the scene').map((root) =>
          indexAt(root, nodes.length, 'the scene'),
        );
  // Each once: thousands of entries can name one node with thousands of children.
  const roots = [...new Set(listed)];
  const children = roots.flatMap((root) => nodes[root]!.children);
  const below = withChildren(nodes, children);
  return roots.filter((root) => !below.has(root));
}

function withChildren(nodes: readonly GltfNode[], roots: readonly number[]): ReadonlySet<number> {
  const reached = new Set(roots);
  for (const index of reached) {
    for (const child of nodes[index]?.children ?? []) {
      reached.add(child);
    }
  }
  return reached;
}

/** The nodes of the scene, and the joints of the skins that are drawn, which may lie outside it. */
function withJoints(drawn: readonly GltfNode[], inScene: ReadonlySet<number>): ReadonlySet<number> {
  const skins = [...new Set(drawn.map(({ skin }) => skin))];
  return new Set([...inScene, ...skins.flatMap((skin) => skin?.joints ?? [])]);
}

/**
 * Throws for a cycle of nodes, on which the parser would wait for ever. @throws ModelError
 * `too-large` if nodes are nested too deeply.
 */
function requireTree(children: readonly (readonly number[])[]) {
  const below = new Set<number>();
  for (const child of children.flat()) {
    if (below.has(child)) throw new Error(`nodes[${String(child)}] has two parents`);
    below.add(child);
  }
  const reached = new Set<number>();
  let level = [...children.keys()].filter((node) => !below.has(node));
  for (let depth = 1; level.length > 0; depth += 1) {
    requireAtMost(depth, DEPTH_LIMIT, 'levels of nodes inside nodes');
    level.forEach((node) => reached.add(node));
    level = level.flatMap((node) => children[node]!);
  }
  const cyclic = [...children.keys()].find((node) => !reached.has(node));
  if (cyclic !== undefined) throw new Error(`nodes[${String(cyclic)}] contains itself`);
}
