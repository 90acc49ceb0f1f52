// Do a model's poses agree with three.js's own mixer, skinned meshes and morph targets, at any time? What happens to
// mistakes in animation data?
import { AnimationMixer, type Mesh, type SkinnedMesh, Vector3 } from 'three';
import fc from 'fast-check';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { beforeAll, describe, expect, it, vi } from 'vitest';
import { modelContent } from '../../src/model/model-content.js';
import type { Content } from '../../src/model/model.js';
import { addressOf, bar, type BarOptions } from '../support/animated-gltf.js';

const load = (document: object): Promise<Content> =>
  modelContent(new URL(addressOf(document)), { signal: new AbortController().signal, crossOrigin: null });

// three.js's loader reads data: addresses by fetch, and reports progress with this class, which Node does not have.
beforeAll(() => {
  vi.stubGlobal('ProgressEvent', Event);
});

/** Vertices in the model's space, in float64, as three.js computes them. */
async function expected(document: object, clip: number, seconds: number): Promise<number[]> {
  const { scene, animations } = await new GLTFLoader().parseAsync(JSON.stringify(document), '');
  const mixer = new AnimationMixer(scene);
  const animation = clip < 0 ? undefined : animations.at(clip);
  if (animation) mixer.clipAction(animation).play();
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

function places({ parts }: Content): number[] {
  return parts.flatMap(({ geometry, matrix }) => {
    const position = geometry.getAttribute('position');
    return Array.from({ length: position.count }, (_, i) =>
      new Vector3().fromBufferAttribute(position, i).applyMatrix4(matrix).toArray(),
    ).flat();
  });
}

function expectClose(actual: readonly number[], wanted: readonly number[]): void {
  expect(actual).toHaveLength(wanted.length);
  // Vertices are float32, within 4 of the origin.
  actual.forEach((value, i) => {
    expect(Math.abs(value - wanted[i]!)).toBeLessThan(2e-6);
  });
}

const cases: readonly [string, BarOptions][] = [
  ['nodes alone', { skinned: false, morphed: false }],
  ['joints', { morphed: false }],
  ['morph targets', { skinned: false }],
  ['joints and morph targets', {}],
];

describe.each(cases)('the pose of %s', (_, options) => {
  it.each([0, 0.3, 1, 1.25, 1.999])(
    'is the same as in three.js in each animation at %d s',
    async (seconds) => {
      const document = bar(options);
      const model = await load(document);
      expectClose(places(model), await expected(document, -1, 0));
      for (const [clip, name] of model.motion?.names.entries() ?? []) {
        model.motion?.pose(name, seconds);
        expectClose(places(model), await expected(document, clip, seconds));
      }
      model.motion?.pose(null, 0);
      expectClose(places(model), await expected(document, -1, 0));
    },
  );
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
      const [normal, position] = [geometry.getAttribute('normal'), geometry.getAttribute('position')];
      for (let i = 0; i < normal.count; i += 1)
        expect(new Vector3().fromBufferAttribute(normal, i).length()).toBeCloseTo(1, 6);
      if (normals) continue;
      for (let i = 0; i < normal.count; i += 3) {
        const [a, b] = [0, 1].map((k) => new Vector3().fromBufferAttribute(position, i + k));
        const edge = b!.sub(a!).normalize();
        expect(edge.dot(new Vector3().fromBufferAttribute(normal, i))).toBeCloseTo(0, 5);
      }
    }
  });

  it('is independent for two nodes that share a mesh, each with its own weights', async () => {
    const document = bar({ skinned: false });
    const model = await load({
      ...document,
      scenes: [{ nodes: [0, 3] }],
      nodes: [...(document['nodes'] as object[]), { mesh: 0, weights: [1, 0], translation: [5, 0, 0] }],
    });
    const [one, two] = model.parts.map(({ geometry }) => geometry.getAttribute('position').getX(0));
    expect([one, two]).toEqual([0.25, 0.75]);
    model.motion?.pose('swell', 1);
    const [moved, still] = model.parts.map(({ geometry }) => geometry.getAttribute('position').getX(0));
    expect([moved, still]).toEqual([0.75, 0.75]);
  });
});

describe('a model without animations', () => {
  it('has no motion, and is shown with the weights of its file', async () => {
    const document = bar({ skinned: false, animations: [] });
    const [mesh] = document['meshes'] as { weights: number[] }[];
    mesh!.weights = [1, 0];
    const model = await load(document);
    expect(model.motion).toBeNull();
    expectClose(places(model), await expected(document, -1, 0));
  });
});

describe('an animation with a mistake is left out, and named', () => {
  const channel = (sampler: object, target: object = { node: 0, path: 'translation' }): object => ({
    samplers: [sampler],
    channels: [{ sampler: 0, target }],
  });
  const accessorOf = (document: Record<string, unknown>, type: string): number =>
    (document['accessors'] as { type: string }[]).findIndex((accessor) => accessor.type === type);
  const document = bar();
  const input = (document['animations'] as { samplers: { input: number }[] }[])[0]!.samplers[0]!.input;
  const vectors = accessorOf(document, 'VEC3');

  it.each([
    ['an unknown accessor', channel({ input: 999, output: vectors })],
    ['an unknown sampler', { samplers: [], channels: [{ sampler: 0, target: { node: 0, path: 'scale' } }] }],
    ['an unknown node', channel({ input, output: vectors }, { node: 99, path: 'scale' })],
    ['values of another type', channel({ input, output: vectors }, { node: 0, path: 'rotation' })],
    ['an unknown interpolation', channel({ input, output: vectors, interpolation: 'WILD' })],
    ['times that are vectors', channel({ input: vectors, output: vectors })],
    ['no object', 5],
  ])('%s', async (_, animation) => {
    const loading = load({ ...document, animations: [animation] });
    if (typeof animation !== 'object') {
      await expect(loading).rejects.toThrow(/animations\[0\] is not an object/);
      return;
    }
    const model = await loading;
    expect(model.motion).toBeNull();
    expect([...(model.dropped ?? [])].join()).toMatch(/^animations\[0\] \(.+\)$/);
  });

  it.each([
    ['times that go back', [0, 2, 1]],
    ['a time that is no number', [0, NaN, 2]],
    ['a time before 0', [-1, 0, 1]],
  ])('%s', async (_, times) => {
    const model = await load(bar({ times }));
    expect(model.motion).toBeNull();
    expect([...(model.dropped ?? [])]).toHaveLength(3);
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
  interface Arrangement {
    /** Of each node but the first; -1 for none. */
    readonly parents: readonly number[];
    /** Mesh and skin of each node; -1 for none. */
    readonly meshes: readonly number[];
    readonly skins: readonly number[];
    readonly joints: readonly (readonly number[])[];
    readonly roots: readonly number[];
  }
  const NODES = 5;
  const node = fc.integer({ min: 0, max: NODES - 1 });
  const perNode = (most: number): fc.Arbitrary<number[]> =>
    fc.array(fc.integer({ min: -1, max: most }), { minLength: NODES, maxLength: NODES });
  const arrangements: fc.Arbitrary<Arrangement> = fc.record({
    parents: fc.tuple(...Array.from({ length: NODES - 1 }, (_, i) => fc.integer({ min: -1, max: i }))),
    meshes: perNode(1),
    skins: perNode(1),
    joints: fc.tuple(fc.array(node, { maxLength: 3 }), fc.array(node, { maxLength: 3 })),
    roots: fc.array(node, { minLength: 1, maxLength: 3 }),
  });
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
    const shown = async (arrangement: Arrangement): Promise<void> => {
      const result: unknown = await load(arranged(arrangement)).catch((error: unknown) => error);
      if (result instanceof Error) {
        expect(result.message).toMatch(/it has no triangles/);
        return;
      }
      const model = result as Content;
      for (const pose of ['bend', 'slide', 'swell', null]) model.motion?.pose(pose, 0.7);
      expect(places(model).every(Number.isFinite)).toBe(true);
    };
    await fc.assert(fc.asyncProperty(arrangements, shown), { numRuns: 100 });
  });

  it('with a joint that is an ancestor of its mesh, or the mesh itself, or has the same mesh without a skin', async () => {
    const parts = async (arrangement: Arrangement): Promise<number> =>
      (await load(arranged(arrangement))).parts.length;
    const chain = { parents: [0, 1, -1, -1], roots: [0], joints: [[0, 1], []] };
    expect(await parts({ ...chain, meshes: [-1, -1, 0, -1, -1], skins: [-1, -1, 0, -1, -1] })).toBe(1);
    expect(await parts({ ...chain, meshes: [-1, 0, -1, -1, -1], skins: [-1, 0, -1, -1, -1] })).toBe(1);
    expect(await parts({ ...chain, meshes: [0, -1, 0, -1, -1], skins: [-1, -1, 0, -1, -1] })).toBe(2);
  });

  it('with a node listed in the scene that lies below another one, which is shown once', async () => {
    const document = { ...bar({ skinned: false }), nodes: [{ children: [1] }, { mesh: 0 }] };
    const model = await load({ ...document, scenes: [{ nodes: [0, 1, 0] }] });
    expect(model.parts).toHaveLength(1);
  });
});
