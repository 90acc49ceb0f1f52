// A glTF document of a bar that bends, for tests: two joints, two morph targets, animations of
// every interpolation. As a data: address.
import { viewsOf } from '../fuzz/glb.js';
import { IDENTITY } from './matrices.js';

export interface BarOptions {
  /** Whether the bar has joints. Default true. */
  readonly skinned?: boolean;
  /** Whether it has morph targets. Default true. */
  readonly morphed?: boolean;
  /** Whether it has normals; without, it is flat. Default true. */
  readonly normals?: boolean;
  /** Replaces the times 0, 1, 2. */
  readonly times?: readonly number[];
}

/** Of vertices, along the bar. */
const RINGS = 6;
const FLOAT = 5126;
const USHORT = 5123;
const TYPES = ['', 'SCALAR', 'VEC2', 'VEC3', 'VEC4'] as const;

/**
 * The document; a bar of height 2 and width 0.5 about y, from y = 0. Joint 0 is at its foot, joint
 * 1 at y = 1. Animations: `bend` (rotation, linear), `slide` (translation, step; scale, cubic),
 * `swell` (weights, linear).
 */
export function bar(options: BarOptions = {}): Record<string, unknown> {
  const { skinned = true, morphed = true, normals = true, times = [0, 1, 2] } = options;
  const views: Buffer[] = [];
  const accessors: object[] = [];
  const add = (items: number, values: readonly number[], integer = false) => {
    views.push(Buffer.from((integer ? new Uint16Array(values) : new Float32Array(values)).buffer));
    const type = items === 16 ? 'MAT4' : TYPES[items];
    const [componentType, count] = [integer ? USHORT : FLOAT, values.length / items];
    accessors.push({ bufferView: accessors.length, componentType, count, type });
    return accessors.length - 1;
  };
  const vertices = Array.from({ length: RINGS * 4 }, (_, i) => {
    const y = (2 * Math.floor(i / 4)) / (RINGS - 1);
    const angle = ((i % 4) * Math.PI) / 2;
    return { y, x: Math.cos(angle), z: Math.sin(angle) };
  });
  type Vertex = (typeof vertices)[number];
  const perVertex = (items: number, of: (vertex: Vertex) => readonly number[], integer = false) =>
    add(items, vertices.flatMap(of), integer);
  const indices = Array.from({ length: (RINGS - 1) * 4 }, (_, i) => {
    const a = Math.floor(i / 4) * 4 + (i % 4);
    const b = Math.floor(i / 4) * 4 + ((i + 1) % 4);
    return [a, a + 4, b, b, a + 4, b + 4];
  }).flat();
  const attributes: Record<string, number> = {
    POSITION: perVertex(3, ({ x, y, z }) => [0.25 * x, y, 0.25 * z]),
  };
  if (normals) {
    attributes['NORMAL'] = perVertex(3, ({ x, z }) => [x, 0, z]);
  }
  if (skinned) {
    attributes['JOINTS_0'] = perVertex(4, () => [0, 1, 0, 0], true);
    attributes['WEIGHTS_0'] = perVertex(4, ({ y }) => [1 - y / 2, y / 2, 0, 0]);
  }
  const thicker = perVertex(3, ({ x, z }) => [0.5 * x, 0, 0.5 * z]);
  const leaning = perVertex(3, ({ y }) => [y * y, 0, 0]);
  const tilted = perVertex(3, ({ x }) => [0, -x / 2, 0]);
  const targets = [
    { POSITION: thicker },
    { POSITION: leaning, ...(normals ? { NORMAL: tilted } : {}) },
  ];
  const order = add(1, indices, true);
  const inverses = add(16, [...IDENTITY, ...IDENTITY.slice(0, 13), -1, 0, 1]);
  const input = add(1, times);
  const half = Math.SQRT1_2;
  const scales = [
    0, 0, 0, 1, 1, 1, 0.5, 0, 0, 0, 1, 0, 2, 1, 0.5, 0, 0, 1, 0, 0, 0, 1, -1, 1, 0, 0, 0,
  ];
  const turns = [0, 0, 0, 1, 0, 0, half, half, 0, 0, -0.6, 0.8];
  const samplers = {
    bend: { input, output: add(4, turns), interpolation: 'LINEAR' },
    slide: { input, output: add(3, [0, 0, 0, 3, 0, 0, 0, 0, 2]), interpolation: 'STEP' },
    grow: { input, output: add(3, scales), interpolation: 'CUBICSPLINE' },
    swell: { input, output: add(1, [0, 0, 1, 0.25, 0, 1]) },
  };
  const [foot, knee] = skinned ? [1, 2] : [0, 0];
  const clip = (name: string, ...channels: readonly [number, string, object][]): object => ({
    name,
    samplers: channels.map(([, , sampler]) => sampler),
    channels: channels.map(([node, path], sampler) => ({ sampler, target: { node, path } })),
  });
  const { bufferViews, buffers, body } = viewsOf(views);
  return {
    asset: { version: '2.0' },
    scene: 0,
    scenes: [{ nodes: [0, 1] }],
    nodes: [
      { name: 'bar', mesh: 0, ...(skinned ? { skin: 0 } : {}) },
      { name: 'foot', children: [2] },
      { name: 'knee', translation: [0, 1, 0] },
    ],
    ...(skinned ? { skins: [{ joints: [1, 2], inverseBindMatrices: inverses }] } : {}),
    meshes: [
      {
        primitives: [{ attributes, indices: order, ...(morphed && { targets }) }],
        ...(morphed && { weights: [0, 0] }),
      },
    ],
    animations: [
      clip('bend', [knee, 'rotation', samplers.bend]),
      clip('slide', [foot, 'translation', samplers.slide], [knee, 'scale', samplers.grow]),
      ...(morphed ? [clip('swell', [0, 'weights', samplers.swell])] : []),
    ],
    accessors,
    bufferViews,
    buffers: [
      { ...buffers[0], uri: `data:application/octet-stream;base64,${body.toString('base64')}` },
    ],
  };
}

export const addressOf = (document: object): string =>
  `data:model/gltf+json;base64,${Buffer.from(JSON.stringify(document)).toString('base64')}`;
