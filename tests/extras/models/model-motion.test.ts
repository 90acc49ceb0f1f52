// Do a model's poses agree with three.js's own mixer, skinned meshes and morph targets, at any
// time? What happens to mistakes in animation data?
import { AnimationMixer, type Mesh, Object3D, type SkinnedMesh, Vector3 } from 'three';
import fc from 'fast-check';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { beforeAll, describe, expect, it, vi } from 'vitest';
import { LIMITS } from '../../../src/phong/model/limits.js';
import { Animations } from '../../../src/viewer/scene/mesh/animations.js';
import { channelsGlb, morphsGlb, skinsGlb } from '../../fuzz/models.js';
import { sizeOf } from '../../../src/phong/geometry/geometry-size.js';
import { modelContent } from '../../../src/extras/models/model-content.js';
import type { Content } from '../../../src/phong/model/model.js';
import { keysWithin } from '../../../src/extras/models/gltf/reach.js';
import { movingCopy } from '../../../src/extras/models/moving-copy.js';
import { addressOf, bar, type BarOptions } from '../../support/animated-gltf.js';
import { OPTIONS } from './model-files.js';

const load = (document: object) => modelContent(new URL(addressOf(document)), OPTIONS);

// three.js's loader reads data: addresses by fetch, and reports progress with this class, which
// Node does not have.
beforeAll(() => {
  vi.stubGlobal('ProgressEvent', Event);
});

/** Vertices in the model's space, in float64, as three.js computes them. */
async function expected(document: object, clip: number, seconds: number) {
  const { scene, animations } = await new GLTFLoader().parseAsync(JSON.stringify(document), '');
  const mixer = new AnimationMixer(scene);
  const animation = clip < 0 ? undefined : animations.at(clip);
  if (animation) {
    mixer.clipAction(animation).play();
  }
  mixer.setTime(seconds);
  scene.updateMatrixWorld(true);
  const found: number[] = [];
  scene.traverse((object) => {
    const mesh = object as Mesh;
    if (!('isMesh' in object)) return;
    const { count } = mesh.geometry.getAttribute('position');
    for (let i = 0; i < count; i += 1) {
      // Morph targets and joints, in the mesh's space.
      const place = (mesh as SkinnedMesh).getVertexPosition(i, new Vector3());
      found.push(...place.applyMatrix4(mesh.matrixWorld).toArray());
    }
  });
  return found;
}

function places({ parts }: Content) {
  return parts.flatMap(({ geometry, matrix }) => {
    const position = geometry.getAttribute('position');
    const at = (_: unknown, i: number) =>
      new Vector3().fromBufferAttribute(position, i).applyMatrix4(matrix);
    return Array.from({ length: position.count }, at).flatMap((place) => place.toArray());
  });
}

function expectPlaces(model: Content, wanted: readonly number[]): void {
  const actual = places(model);
  expect(actual).toHaveLength(wanted.length);
  // Vertices are float32, within 4 of the origin.
  for (const [i, value] of actual.entries()) {
    expect(Math.abs(value - wanted[i]!)).toBeLessThan(2e-6);
  }
}

const cases: readonly [string, BarOptions][] = [
  ['nodes alone', { skinned: false, morphed: false }],
  ['joints', { morphed: false }],
  ['morph targets', { skinned: false }],
  ['joints and morph targets', {}],
];

it.each(cases)(
  'the pose of %s is the same as in three.js in each animation at any time',
  async (_, options) => {
    const document = bar(options);
    const atRest = await expected(document, -1, 0);
    const model = await load(document);
    expectPlaces(model, atRest);
    for (const seconds of [0, 0.3, 1, 1.25, 1.999]) {
      for (const [clip, name] of model.motion?.names.entries() ?? []) {
        model.motion?.pose(name, seconds);
        expectPlaces(model, await expected(document, clip, seconds));
      }
    }
    model.motion?.pose(null, 0);
    expectPlaces(model, atRest);
  },
);

describe('the reach of an animation', () => {
  const { signal } = OPTIONS;

  it.each(cases)('of %s is that of its vertices in the poses at the keys', async (_, options) => {
    const model = await load(bar(options));
    // The last step of a STEP animation is at a key, but lasts no time.
    for (const name of model.motion!.names.filter((one) => one !== 'slide')) {
      const all = [0, 1, 2 - 1e-12].flatMap((seconds) => {
        model.motion!.pose(name, seconds);
        return places(model);
      });
      const { box, center, radius } = (await model.motion!.reach(name, signal))!;
      for (const axis of [0, 1, 2]) {
        const along = all.filter((__, i) => i % 3 === axis);
        expect(box[axis]).toBeCloseTo(Math.min(...along), 5);
        expect(box[axis + 3]).toBeCloseTo(Math.max(...along), 5);
      }
      const away = all
        .map((x, i) => [x, all[i + 1], all[i + 2]] as [number, number, number])
        .filter((__, i) => i % 3 === 0)
        .map(([x, y, z]) => Math.hypot(x - center[0], y - center[1], z - center[2]));
      // Of near directions one vertex is kept.
      expect(Math.max(...away) / radius).toBeLessThan(1.01);
      expect(radius / Math.max(...away)).toBeLessThan(1 + 1e-6);
    }
  });

  it('is found once for all copies, and never leaves a pose of its own in one', async () => {
    const model = await load(bar());
    const copies = [movingCopy(model), movingCopy(model)];
    copies[0]!.motion!.pose('bend', 0.5);
    const before = places(copies[0]!);
    const first = await copies[0]!.motion!.reach('bend', signal);
    expect(await copies[1]!.motion!.reach('bend', signal)).toBe(first);
    expect(places(copies[0]!)).toEqual(before);
    copies[0]!.motion!.pose('bend', 0.5);
    expect(places(copies[0]!)).toEqual(before);
  });

  it('is read at some of the keys where there are too many, the first and the last among them', () => {
    const keys = Array.from({ length: 5000 }, (_, i) => i);
    expect(keysWithin(keys.slice(0, 900), 10)).toHaveLength(900);
    expect(keysWithin(keys, 10)).toHaveLength(1000);
    const few = keysWithin(keys, 2 * LIMITS.pose);
    expect(few).toHaveLength(4);
    expect([few[0], few.at(-1)]).toEqual([0, 4999]);
    expect(keysWithin(keys, 1e9)).toEqual([0, 4999]);
  });
});

describe('a pose', () => {
  it('has the bounds of its vertices, in a new object each time', async () => {
    const model = await load(bar());
    const [{ geometry }] = model.parts as [Content['parts'][0]];
    const before = geometry.boundingBox;
    model.motion?.pose('bend', 0.5);
    const posed = geometry.boundingBox;
    expect(posed).not.toBe(before);
    model.motion?.pose('bend', 1);
    expect(geometry.boundingBox).not.toBe(posed);
    const { min, max } = geometry.boundingBox!.clone();
    geometry.computeBoundingBox();
    expect([min, max]).toEqual([geometry.boundingBox?.min, geometry.boundingBox?.max]);
  });

  it('of a copy is framed as it is first, not as in the file', async () => {
    const copy = movingCopy(await load(bar()));
    copy.motion?.pose('bend', 1);
    const { geometry } = copy.parts[0]!;
    expect(sizeOf(geometry)?.center).toEqual(
      geometry.boundingBox?.getCenter(new Vector3()).toArray(),
    );
  });

  it('that does not change sends nothing to the GPU', async () => {
    const model = await load(bar());
    const position = model.parts[0]!.geometry.getAttribute('position') as { version?: number };
    model.motion?.pose('bend', 0.5);
    const { version } = position;
    model.motion?.pose('bend', 0.5);
    expect(position.version).toBe(version);
    model.motion?.pose('bend', 0.6);
    expect(position.version).toBe((version ?? 0) + 1);
  });

  it('has normals of unit length, perpendicular to the faces where the file has none', async () => {
    for (const normals of [true, false]) {
      const model = await load(bar({ normals }));
      model.motion?.pose('swell', 0.7);
      model.motion?.pose('bend', 0.7);
      const { geometry } = model.parts[0]!;
      const [normal, position] = [
        geometry.getAttribute('normal'),
        geometry.getAttribute('position'),
      ];
      for (let i = 0; i < normal.count; i += 1) {
        const N = new Vector3().fromBufferAttribute(normal, i);
        expect(N.length()).toBeCloseTo(1, 6);
        if (normals || i % 3 > 0) continue;
        const [a, b] = [0, 1].map((k) => new Vector3().fromBufferAttribute(position, i + k));
        expect(b!.sub(a!).normalize().dot(N)).toBeCloseTo(0, 5);
      }
    }
  });

  it('is independent for two nodes that share a mesh, each with its own weights', async () => {
    const document = bar({ skinned: false });
    const model = await load({
      ...document,
      scenes: [{ nodes: [0, 3] }],
      nodes: [
        ...(document['nodes'] as object[]),
        { mesh: 0, weights: [1, 0], translation: [5, 0, 0] },
      ],
    });
    const firstX = () =>
      model.parts.map(({ geometry }) => geometry.getAttribute('position').getX(0));
    expect(firstX()).toEqual([0.25, 0.75]);
    model.motion?.pose('swell', 1);
    expect(firstX()).toEqual([0.75, 0.75]);
  });
});

describe('an animation with a mistake is left out, and named', () => {
  const channel = (sampler: object, target: object = { node: 0, path: 'translation' }): object => ({
    samplers: [sampler],
    channels: [{ sampler: 0, target }],
  });
  const document = bar();
  const input = (document['animations'] as { samplers: { input: number }[] }[])[0]!.samplers[0]!
    .input;
  const vectors = (document['accessors'] as { type: string }[]).findIndex(
    ({ type }) => type === 'VEC3',
  );

  const withOne = (animation: unknown): object => ({ ...document, animations: [animation] });
  it.each([
    ['an unknown accessor', withOne(channel({ input: 999, output: vectors })), 1],
    ['an unknown sampler', withOne({ ...channel({}), samplers: [] }), 1],
    [
      'an unknown node',
      withOne(channel({ input, output: vectors }, { node: 99, path: 'scale' })),
      1,
    ],
    ['values of another type', withOne(channel({ input, output: vectors }, { node: 0, path: 'rotation' })), 1], // oxfmt-ignore
    [
      'an unknown interpolation',
      withOne(channel({ input, output: vectors, interpolation: 'WILD' })),
      1,
    ],
    ['times that are vectors', withOne(channel({ input: vectors, output: vectors })), 1],
    ['times that go back', bar({ times: [0, 2, 1] }), 3],
    ['a time that is no number', bar({ times: [0, NaN, 2] }), 3],
    ['a time before 0', bar({ times: [-1, 0, 1] }), 3],
  ])('%s', async (_, wrong, count) => {
    const model = await load(wrong);
    expect(model.motion).toBeNull();
    expect(model.dropped?.size).toBe(count);
    for (const name of model.dropped ?? []) {
      expect(name).toMatch(/^animations\[\d\] \(.+\)$/);
    }
  });

  it('but one that is no object is an error', async () => {
    await expect(load(withOne(5))).rejects.toThrow(/animations\[0\] is not an object/);
  });

  it('channels of nodes that are not shown, and of other properties, are ignored', async () => {
    const model = await load({
      ...document,
      nodes: [...(document['nodes'] as object[]), { name: 'elsewhere' }],
      animations: [
        channel({ input, output: vectors }, { node: 3, path: 'translation' }),
        channel({ input, output: vectors }, { path: 'pointer' }),
      ],
    });
    expect(model.motion).toBeNull();
    expect(model.dropped?.size).toBe(0);
  });
});

describe('nodes, skins and scenes in any arrangement', () => {
  const NODES = 5;
  const node = fc.integer({ min: 0, max: NODES - 1 });
  const perNode = fc.array(fc.integer({ min: -1, max: 1 }), { minLength: NODES, maxLength: NODES });
  const arrangements = fc.record({
    /** Of each node but the first; -1 for none. */
    parents: fc.tuple(
      ...Array.from({ length: NODES - 1 }, (_, i) => fc.integer({ min: -1, max: i })),
    ),
    /** Mesh and skin of each node; -1 for none. */
    meshes: perNode,
    skins: perNode,
    joints: fc.array(fc.array(node, { maxLength: 3 }), { minLength: 2, maxLength: 2 }),
    roots: fc.array(node, { minLength: 1, maxLength: 3 }),
  });
  type Arrangement = typeof arrangements extends fc.Arbitrary<infer A> ? A : never;
  /** Both meshes have joints. */
  function arranged({ parents, meshes, skins, joints, roots }: Arrangement): object {
    const document = bar();
    const [mesh] = document['meshes'] as readonly object[];
    return {
      ...document,
      scenes: [{ nodes: roots }],
      meshes: [mesh, mesh],
      skins: joints.map((list) => ({ joints: list })),
      nodes: meshes.map((index, i) => ({
        children: parents.flatMap((parent, k) => (parent === i ? [k + 1] : [])),
        ...(index < 0 ? {} : { mesh: index }),
        ...(index < 0 || skins[i]! < 0 ? {} : { skin: skins[i] }),
      })),
    };
  }

  it('are shown, or refused because nothing is in the scene', async () => {
    vi.spyOn(console, 'warn').mockReturnValue();
    const shown = async (arrangement: Arrangement) => {
      const result: unknown = await load(arranged(arrangement)).catch((error: unknown) => error);
      if (result instanceof Error) {
        expect(result.message).toMatch(/it has no triangles/);
        return;
      }
      const model = result as Content;
      for (const pose of ['bend', 'slide', 'swell', null]) {
        model.motion?.pose(pose, 0.7);
      }
      expect(places(model).every(Number.isFinite)).toBe(true);
    };
    await fc.assert(fc.asyncProperty(arrangements, shown), { numRuns: 100 });
  });

  it.each([
    ['is an ancestor of its mesh', [-1, -1, 0, -1, -1], [-1, -1, 0, -1, -1], 1],
    ['is its mesh', [-1, 0, -1, -1, -1], [-1, 0, -1, -1, -1], 1],
    ['has the same mesh without a skin', [0, -1, 0, -1, -1], [-1, -1, 0, -1, -1], 2],
  ])('with a joint that %s', async (_, meshes, skins, parts) => {
    const chain = { parents: [0, 1, -1, -1], roots: [0], joints: [[0, 1], []] };
    expect((await load(arranged({ ...chain, meshes, skins }))).parts).toHaveLength(parts);
  });
});

describe('the work of a pose', () => {
  const loadGlb = async (bytes: Buffer) =>
    modelContent(new URL(`data:model/gltf-binary;base64,${bytes.toString('base64')}`), OPTIONS);

  it('is each vertex once, and once more for each target that a key gives a weight', async () => {
    const workWith = async (weights: readonly number[]) =>
      (await loadGlb(morphsGlb(3000, weights))).motion!.work;
    const none = await workWith([0, 0, 0]);
    expect(none).toBeGreaterThanOrEqual(3000);
    expect(await workWith([0, 1, 0])).toBe(none + 3000);
    expect(await workWith([1, 1, -0.5])).toBe(none + 9000);
  });

  it('keeps a model within the limit in motion, and shows one above it in its own pose', async () => {
    const vertices = 3 * 2 ** 16;
    const within = await loadGlb(morphsGlb(vertices, [1, 1, 1, 1, 1, 1, 1, 1, 1, 0, 0, 0, 0, 0]));
    expect(within.motion?.work).toBeLessThanOrEqual(LIMITS.pose);
    expect(within.dropped?.size).toBe(0);
    const warned = vi.spyOn(console, 'warn').mockReturnValue().mockClear();
    const above = await loadGlb(morphsGlb(vertices, [1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 0, 0, 0, 0]));
    expect(above.motion).toBeNull();
    expect(above.parts).toHaveLength(1);
    expect(warned.mock.calls).toEqual([
      [expect.stringMatching(/ is shown without its animations \(a pose takes [\d,]+ steps; /)],
    ]);
  });

  it('counts tracks and joints: thousands of them move one triangle', async () => {
    const workOf = async (file: Buffer) => (await loadGlb(file)).motion!.work;
    const tracks = (await workOf(channelsGlb(2000, 1))) - (await workOf(channelsGlb(1000, 1)));
    expect(tracks).toBeGreaterThanOrEqual(1000 * 3);
    const joints = (await workOf(skinsGlb(200, 1))) - (await workOf(skinsGlb(100, 1)));
    expect(joints).toBeGreaterThanOrEqual(100 * (3 + 1));
  });

  it('updates a tree that many skins name once, not once for each skin', async () => {
    const [skins, nodes] = [50, 20];
    const update = vi.spyOn(Object3D.prototype, 'updateWorldMatrix');
    const { motion } = await loadGlb(skinsGlb(skins, nodes));
    expect(update.mock.calls.length).toBeLessThanOrEqual(nodes + 1);
    update.mockClear();
    motion!.pose('', 0.5);
    expect(update.mock.calls.length).toBeLessThanOrEqual(nodes + 1);
    update.mockRestore();
  });
});

it('meshes of a picture play as far as the work of their poses is within the limit of a frame', () => {
  const warned = vi.spyOn(console, 'warn').mockReturnValue().mockClear();
  const animations = new Animations();
  const advances = [0, 0, 0];
  advances.forEach((_, i) => {
    const mesh = { plays: true, work: 0.4 * LIMITS.pose, advance: () => void advances[i]!++ };
    animations.all.add(mesh);
  });
  animations.step(0);
  animations.step(16);
  expect(advances).toEqual([2, 2, 0]);
  expect(warned.mock.calls).toEqual([[expect.stringContaining('Not all animations play')]]);
});
