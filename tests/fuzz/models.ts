// Files that claim too much, or are wrong in ways that authors and attackers come by: constructed
// ones, each about one claim, and real ones with something changed. The same seed gives the same
// files. Knows nothing about how they are loaded.
import type { Random } from '../stress/random.js';
import { bar } from '../support/animated-gltf.js';
import { floats, glbOf, type Json, openGlb, pngWith, viewsOf } from './glb.js';

interface HostileFile {
  /** Describes what is wrong with it. */
  readonly what: string;
  readonly bytes: Buffer;
}

const FLOAT = 5126;
const TYPES = [5120, 5121, 5122, 5123, 5125, FLOAT];
const TRIANGLE = floats(0, 0, 0, 1, 0, 0, 0, 1, 0);
const POSITIONS = { bufferView: 0, componentType: FLOAT, count: 3, type: 'VEC3' };

/** The numbers from 0 to `count` - 1. */
const upTo = (count: number) => Array.from({ length: count }, (_, i) => i);

/** A sound document with one triangle; `more` replaces its entries. */
export function triangleDocument(more: Json = {}): Json {
  const { bufferViews, buffers } = viewsOf([TRIANGLE]);
  return {
    asset: { version: '2.0' },
    scenes: [{ nodes: [0] }],
    nodes: [{ mesh: 0 }],
    meshes: [{ primitives: [{ attributes: { POSITION: 0 } }] }],
    accessors: [POSITIONS],
    bufferViews,
    buffers,
    ...more,
  };
}

export const triangleGlb = (more: Json = {}): Buffer => glbOf(triangleDocument(more), TRIANGLE);

/**
 * Triangles of `count` vertices or indices that are not in the file: an accessor without a view
 * stands for zeros.
 */
export function zerosGlb(count: number, primitive: Json = {}, accessor: Json = {}): Buffer {
  const zeros = { componentType: FLOAT, count, type: 'VEC3', ...accessor };
  return triangleGlb({
    accessors: [zeros, { componentType: 5125, count, type: 'SCALAR' }],
    meshes: [{ primitives: [{ attributes: { POSITION: 0 }, ...primitive }] }],
  });
}

/** The triangle at `count` nodes, which share a mesh or have one each. */
export function instancesGlb(count: number, shared: boolean): Buffer {
  const nodes = upTo(count).map((i) => ({
    mesh: shared ? 0 : i,
    translation: [i % 99, i / 99, 0],
  }));
  const meshes = upTo(shared ? 1 : count).map(() => ({
    primitives: [{ attributes: { POSITION: 0 } }],
  }));
  return triangleGlb({ scenes: [{ nodes: upTo(count) }], nodes, meshes });
}

/** The triangle below `depth` nodes, each in the one before. */
export function deepGlb(depth: number): Buffer {
  return triangleGlb({
    nodes: upTo(depth).map((i) => (i + 1 < depth ? { children: [i + 1] } : { mesh: 0 })),
  });
}

/** Triangles with a texture each: `textures` name the images by their index. */
export function texturedGlb(images: readonly Buffer[], textures: readonly Json[]): Buffer {
  const { bufferViews, buffers, body } = viewsOf([TRIANGLE, floats(0, 0, 1, 0, 0, 1), ...images]);
  const attributes = { POSITION: 0, TEXCOORD_0: 1 };
  const document = triangleDocument({
    scenes: [{ nodes: upTo(textures.length) }],
    nodes: textures.map((_, mesh) => ({ mesh })),
    meshes: textures.map((_, material) => ({ primitives: [{ attributes, material }] })),
    materials: textures.map((_, index) => ({
      pbrMetallicRoughness: { baseColorTexture: { index } },
    })),
    textures,
    images: images.map((_, i) => ({ bufferView: i + 2, mimeType: 'image/png' })),
    accessors: [POSITIONS, { ...POSITIONS, bufferView: 1, type: 'VEC2' }],
    bufferViews,
    buffers,
  });
  return glbOf(document, body);
}

/** Draco data that end after a header with these counts; the accessors claim their own. */
export function dracoGlb(
  faces: number,
  points: number,
  claimed: { faces: number; points: number },
): Buffer {
  const header = Buffer.concat([Buffer.from('DRACO'), Buffer.from([2, 2, 1, 1, 0, 0, 0])]);
  const counts = [varint(points), varint(faces), Buffer.from([0]), varint(faces), varint(0)];
  const data = Buffer.concat([header, ...counts, Buffer.alloc(600)]);
  const { bufferViews, buffers, body } = viewsOf([data]);
  const attributes = { POSITION: 0 };
  const extensions = { KHR_draco_mesh_compression: { bufferView: 0, attributes } };
  const document = triangleDocument({
    extensionsUsed: ['KHR_draco_mesh_compression'],
    meshes: [{ primitives: [{ attributes, indices: 1, extensions }] }],
    accessors: [
      { componentType: FLOAT, count: claimed.points, type: 'VEC3' },
      { componentType: 5125, count: claimed.faces * 3, type: 'SCALAR' },
    ],
    bufferViews,
    buffers,
  });
  return glbOf(document, body);
}

function varint(value: number): Buffer {
  const bytes: number[] = [];
  for (let rest = value; ; rest = Math.floor(rest / 128)) {
    if (rest < 128) return Buffer.from([...bytes, rest]);
    bytes.push((rest % 128) + 128);
  }
}

/**
 * As many vertices in one place, and morph targets that all name one accessor; one animation gives
 * each target, at its only key, the weight of its place in `weights`.
 */
export function morphsGlb(vertices: number, weights: readonly number[]): Buffer {
  const { bufferViews, buffers, body } = viewsOf([floats(0), floats(...weights)]);
  const zeros = { componentType: FLOAT, count: vertices, type: 'VEC3' };
  const scalars = (bufferView: number, count: number): Json => ({
    bufferView,
    componentType: FLOAT,
    count,
    type: 'SCALAR',
  });
  const targets = weights.map(() => ({ POSITION: 0 }));
  const document = triangleDocument({
    meshes: [{ primitives: [{ attributes: { POSITION: 0 }, targets }] }],
    accessors: [zeros, scalars(0, 1), scalars(1, weights.length)],
    animations: [
      {
        samplers: [{ input: 1, output: 2 }],
        channels: [{ sampler: 0, target: { node: 0, path: 'weights' } }],
      },
    ],
    bufferViews,
    buffers,
  });
  return glbOf(document, body);
}

/**
 * The triangle with as many skins, at a node each, of one joint: the foot of a tree that the scene
 * does not show. The first skin has the tree's other `nodes` nodes, too.
 */
export function skinsGlb(skins: number, nodes: number): Buffer {
  const { bufferViews, buffers, body } = viewsOf([TRIANGLE, Buffer.alloc(12), floats(0)]);
  const attributes = { POSITION: 0, JOINTS_0: 1, WEIGHTS_0: 1 };
  const document = triangleDocument({
    scenes: [{ nodes: upTo(skins) }],
    nodes: [
      ...upTo(skins).map((skin) => ({ mesh: 0, skin })),
      { children: upTo(nodes).map((i) => skins + 1 + i) },
      ...upTo(nodes).map(() => ({})),
    ],
    skins: upTo(skins).map((i) => ({
      joints: i > 0 ? [skins] : upTo(nodes + 1).map((k) => skins + k),
    })),
    meshes: [{ primitives: [{ attributes }] }],
    accessors: [
      POSITIONS,
      { bufferView: 1, componentType: 5121, count: 3, type: 'VEC4' },
      { bufferView: 2, componentType: FLOAT, count: 1, type: 'SCALAR' },
      { componentType: FLOAT, count: 1, type: 'VEC3' },
    ],
    animations: [
      {
        samplers: [{ input: 2, output: 3 }],
        channels: [{ sampler: 0, target: { node: skins, path: 'translation' } }],
      },
    ],
    bufferViews,
    buffers,
  });
  return glbOf(document, body);
}

/**
 * The triangle, which moves by `channels` channels that share one sampler of `keys` keyframes of
 * zeros.
 */
export function channelsGlb(channels: number, keys: number, animations = 1): Buffer {
  const channel = { sampler: 0, target: { node: 0, path: 'translation' } };
  const animation = {
    samplers: [{ input: 1, output: 2 }],
    channels: Array<Json>(channels).fill(channel),
  };
  return triangleGlb({
    accessors: [
      POSITIONS,
      { componentType: FLOAT, count: keys, type: 'SCALAR' },
      { componentType: FLOAT, count: keys, type: 'VEC3' },
    ],
    animations: Array<Json>(animations).fill(animation),
  });
}

/** Nodes that have `count` instances each, in the origin, of a mesh of `primitives` triangles. */
export function instancingGlb(
  count: number,
  primitives: number,
  nodes: number,
  attributes: readonly string[],
): Buffer {
  const lists = Object.fromEntries(attributes.map((name) => [name, name === 'ROTATION' ? 2 : 1]));
  const node = { mesh: 0, extensions: { EXT_mesh_gpu_instancing: { attributes: lists } } };
  return triangleGlb({
    accessors: [
      POSITIONS,
      { componentType: FLOAT, count, type: 'VEC3' },
      { componentType: FLOAT, count, type: 'VEC4' },
    ],
    meshes: [{ primitives: Array<Json>(primitives).fill({ attributes: { POSITION: 0 } }) }],
    scenes: [{ nodes: upTo(nodes) }],
    nodes: Array<Json>(nodes).fill(node),
  });
}

/** A list of the document with `length` entries more: what each is alone is repeated. */
export function longListGlb(list: string, length: number): Buffer {
  const skins = [{ joints: [0] }];
  const document = triangleDocument({ materials: [{}], textures: [], skins, animations: [] });
  const entries = document[list] as readonly Json[];
  return glbOf(
    { ...document, [list]: [...entries, ...Array<Json>(length).fill(entries[0] ?? {})] },
    TRIANGLE,
  );
}

/**
 * A fan: triangles of `corners` corners in all that meet at vertex 0, whose normals have no
 * direction.
 */
export function fanGlb(corners: number): Buffer {
  const primitive = { attributes: { POSITION: 0, NORMAL: 1 }, indices: 2 };
  return triangleGlb({
    accessors: [
      POSITIONS,
      { componentType: FLOAT, count: 3, type: 'VEC3' },
      { componentType: 5125, count: corners, type: 'SCALAR' },
    ],
    meshes: [{ primitives: [primitive] }],
  });
}

/** Nodes that share a skin, whose joints are one node again and again. */
export function jointsGlb(joints: number, nodes: number): Buffer {
  return triangleGlb({
    accessors: [
      POSITIONS,
      { componentType: 5121, count: 3, type: 'VEC4' },
      { componentType: FLOAT, count: 3, type: 'VEC4' },
    ],
    meshes: [{ primitives: [{ attributes: { POSITION: 0, JOINTS_0: 1, WEIGHTS_0: 2 } }] }],
    skins: [{ joints: Array<number>(joints).fill(nodes) }],
    scenes: [{ nodes: upTo(nodes) }],
    nodes: [...Array<Json>(nodes).fill({ mesh: 0, skin: 0 }), {}],
  });
}

/** A skinned, morphed and animated bar, as a GLB whose buffer is a data: URI. */
export const barGlb = (more: Json = {}): Buffer => glbOf({ ...bar(), ...more });

/** The bar with one accessor that claims `count` elements that are not in the file. */
export function barClaimsGlb(
  index: number,
  count: number,
  componentType: number,
  sparse: boolean,
): Buffer {
  const accessors = bar()['accessors'] as Json[];
  const few = {
    count: 1,
    indices: { bufferView: 0, componentType: 5121 },
    values: { bufferView: 0 },
  };
  Object.assign(accessors[index % accessors.length]!, {
    bufferView: undefined,
    count,
    componentType,
    ...(sparse && { sparse: few }),
  });
  return barGlb({ accessors });
}

const whole = (random: Random, low: number, high: number) =>
  Math.floor(random.magnitude(low, high));

type Construct = (random: Random) => readonly [what: string, bytes: Buffer];

const CONSTRUCTED: readonly Construct[] = [
  (random) => {
    const [index, count, componentType] = [
      whole(random, 1, 15),
      whole(random, 3, 1e9),
      random.pick(TYPES),
    ];
    const sparse = random.chance(0.3);
    return [
      `a bar whose accessor ${index - 1} claims ${count} of ${componentType}${sparse ? ', sparse' : ''}`,
      barClaimsGlb(index - 1, count, componentType, sparse),
    ];
  },
  (random) => {
    const [count, mode] = [whole(random, 3, 1e9), random.pick([4, 5, 6])];
    return [
      `${count} indices of mode ${mode} without bytes`,
      zerosGlb(count, { indices: 1, mode }),
    ];
  },
  (random) => {
    const [count, componentType] = [whole(random, 3, 1e9), random.pick(TYPES)];
    const type = random.pick(['VEC3', 'VEC3', 'VEC4', 'MAT4', 'SCALAR']);
    const sparse = {
      count: 1,
      indices: { bufferView: 0, componentType: 5123 },
      values: { bufferView: 0 },
    };
    const more = random.chance(0.3) ? { sparse } : {};
    return [
      `${count} elements of ${type} ${componentType}${'sparse' in more ? ', sparse' : ''}`,
      zerosGlb(count, random.chance(0.5) ? { indices: 1 } : {}, { componentType, type, ...more }),
    ];
  },
  (random) => {
    const [width, height] = [whole(random, 1, 70_000), whole(random, 1, 70_000)];
    return [
      `an image of ${width} × ${height}`,
      texturedGlb(
        [pngWith(width, height, random.pick([1, 32]), Buffer.alloc(64))],
        [{ source: 0 }],
      ),
    ];
  },
  (random) => {
    const count = whole(random, 2, 300_000);
    const shared = random.chance(0.7);
    return [`${count} nodes, shared: ${shared}`, instancesGlb(shared ? count : count / 10, shared)];
  },
  (random) => {
    const depth = whole(random, 10, 100_000);
    return [`${depth} levels`, deepGlb(depth)];
  },
  (random) => {
    const [channels, keys] = [whole(random, 1, 2e4), whole(random, 1, 2e7)];
    const animations = whole(random, 1, 100);
    const times = Math.max(1, Math.floor(Math.min(animations, 1e5 / channels)));
    return [
      `${times} animations of ${channels} channels over ${keys} keyframes`,
      channelsGlb(channels, keys, times),
    ];
  },
  (random) => {
    const [count, primitives, nodes] = [
      whole(random, 1, 1e9),
      whole(random, 1, 1e4),
      whole(random, 1, 3e4),
    ];
    const attributes = ['TRANSLATION', 'ROTATION', 'SCALE', '_COLOR_0'].filter(() =>
      random.chance(0.5),
    );
    const instances = random.chance(0.3) ? 0 : count;
    return [
      `${nodes} nodes of ${instances} instances (${attributes.join(' ')}) of ${primitives} primitives`,
      instancingGlb(instances, primitives, nodes, attributes),
    ];
  },
  (random) => {
    const list = random.pick([
      'nodes',
      'meshes',
      'accessors',
      'bufferViews',
      'buffers',
      'scenes',
      'materials',
      'textures',
      'skins',
      'animations',
    ]);
    const length = whole(random, 10, 3e5);
    return [`${length} ${list} more`, longListGlb(list, length)];
  },
  (random) => {
    const corners = whole(random, 3, 3e7);
    return [`${corners} corners at a vertex without normal`, fanGlb(corners)];
  },
  (random) => {
    const [joints, nodes] = [whole(random, 1, 7e4), whole(random, 1, 9e3)];
    return [`${nodes} nodes of a skin of ${joints} joints`, jointsGlb(joints, nodes)];
  },
  (random) => {
    const [faces, points] = [whole(random, 1, 2e9), whole(random, 1, 2e9)];
    const claimed = random.chance(0.5) ? { faces: 1, points: 3 } : { faces, points };
    return [
      `Draco data of ${faces} and ${points}, claimed ${claimed.faces}`,
      dracoGlb(faces, points, claimed),
    ];
  },
  (random) => {
    const byteStride = random.pick([1, 2, 3, 5, 7, 13, 252, 255, 1e6, 2 ** 31, -4, 0.5]);
    const byteOffset = random.pick([0, 0, 1, 2, 3, 35, 1e9]);
    const document = triangleDocument({
      bufferViews: [{ buffer: 0, byteLength: 36, byteStride }],
      accessors: [
        { bufferView: 0, byteOffset, componentType: random.pick(TYPES), count: 3, type: 'VEC3' },
      ],
    });
    return [`stride ${byteStride}, offset ${byteOffset}`, glbOf(document, TRIANGLE)];
  },
  (random) => {
    const name = random.pick(['constructor', '__proto__', 'toString', 'hasOwnProperty', 'length']);
    const accessor = { bufferView: 0, componentType: FLOAT, count: 3, type: name };
    return [`an accessor of type ${name}`, triangleGlb({ accessors: [accessor] })];
  },
  (random) => {
    const [open, times] = [random.pick(['[', '{"a":', '[{},']), whole(random, 1e3, 1e6)];
    return [`JSON that opens ${times} ${open}`, glbOf(open.repeat(times))];
  },
  (random) => {
    const times = whole(random, 1e3, 1e6);
    return [
      `JSON with ${times} values`,
      glbOf(
        JSON.stringify(triangleDocument()).replace(/}$/, `,"extras":[${'{},'.repeat(times)}0]}`),
      ),
    ];
  },
];

const EXTREMES: readonly unknown[] = [
  0,
  -1,
  1,
  2,
  3,
  0.5,
  255,
  65_535,
  65_536,
  1e6,
  2 ** 31,
  2 ** 32 - 1,
  2 ** 53,
  1e300,
  -1e9,
  null,
  true,
  '',
  'constructor',
  '__proto__',
  'data:,',
  '../x',
  'SCALAR',
  'MAT4',
  [],
  {},
  [[]],
  [0],
  [1e9],
];

/**
 * JSON longer than this is not parsed again: a constructed file of a million values has one change.
 */
const PARSED_JSON = 1e6;

/** The file with one to four changed values, keys or bytes. */
function changed(random: Random, file: Buffer): HostileFile {
  if (random.chance(0.4) || file.readUInt32LE(12) > PARSED_JSON) return changedBytes(random, file);
  let opened: ReturnType<typeof openGlb>;
  try {
    opened = openGlb(file);
  } catch {
    return changedBytes(random, file); // its JSON is broken on purpose
  }
  const { json, body } = opened;
  const changes = Array.from({ length: whole(random, 1, 5) }, () => changeValue(random, json));
  return { what: changes.join('; '), bytes: glbOf(json, body) };
}

function changedBytes(random: Random, file: Buffer): HostileFile {
  if (random.chance(0.2)) {
    const length = whole(random, 1, file.length);
    return { what: `the first ${length} bytes`, bytes: file.subarray(0, length) };
  }
  const bytes = Buffer.from(file);
  const changes = Array.from({ length: whole(random, 1, 9) }, () => {
    const [at, value] = [
      Math.floor(random.from(0, bytes.length)),
      random.pick([0, 1, 127, 128, 255]),
    ];
    bytes[at] = value;
    return `byte ${at} is ${value}`;
  });
  return { what: changes.join('; '), bytes };
}

/** Replaces, removes or repeats a value anywhere in the tree. */
function changeValue(random: Random, root: Json) {
  let place = root;
  let path = '';
  for (;;) {
    const keys = Object.keys(place);
    if (keys.length === 0) return `nothing at ${path}`;
    const key = random.pick(keys);
    path += `/${key}`;
    const value = place[key];
    if (typeof value === 'object' && value !== null && !random.chance(0.15)) {
      place = value as Json;
      continue;
    }
    const deed = random.pick(['replace', 'replace', 'remove', 'repeat']);
    if (deed === 'remove') {
      Reflect.deleteProperty(place, key);
    } else if (deed === 'repeat' && Array.isArray(value)) {
      place[key] = Array<unknown>(99).fill(value).flat();
    } else {
      place[key] = random.pick(EXTREMES);
    }
    return `${deed} ${path}: ${JSON.stringify(place[key] ?? null).slice(0, 40)}`;
  }
}

/**
 * One hostile file: constructed, made of one of these, or both: two changes can pass where each
 * alone is refused.
 */
export function hostileFile(random: Random, files: readonly Buffer[]): HostileFile {
  if (random.chance(0.6)) return changed(random, random.pick(files));
  const [what, bytes] = random.pick(CONSTRUCTED)(random);
  if (random.chance(0.4)) return { what, bytes };
  const second = changed(random, bytes);
  return { what: `${what}; ${second.what}`, bytes: second.bytes };
}
