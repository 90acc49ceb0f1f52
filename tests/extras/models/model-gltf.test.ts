// Is what a glTF document says shown, whatever combination says it: quantised, interleaved, shared,
// skinned, in strips, with moved textures, instances, hidden nodes, missing normals, mirrored
// joints? And is what is left out named?
import { readFileSync } from 'node:fs';
import fc from 'fast-check';
import { Matrix4, Quaternion, Vector3 } from 'three';
import { describe, expect, it, vi } from 'vitest';
import { modelContent } from '../../../src/extras/models/model-content.js';
import type { Content } from '../../../src/phong/model/model.js';
import { movingCopy } from '../../../src/extras/models/moving-copy.js';
import { type Json, pngOf, viewsOf } from '../../fuzz/glb.js';
import { bitmapOf, heardWarnings, indexOf, numbersOf, OPTIONS, view } from './model-files.js';

const FLOAT = 5126;
const SHORT = 5122;
const UBYTE = 5121;
const TRIANGLE = [0, 0, 0, 1, 0, 0, 0, 1, 0];

/** A document whose buffer views are the given arrays, one each, end to end. */
function gltf(blobs: readonly ArrayBufferView[], accessors: readonly Json[], more: Json) {
  const { bufferViews, buffers, body } = viewsOf(
    blobs.map(
      ({ buffer, byteOffset, byteLength }) => new Uint8Array(buffer, byteOffset, byteLength),
    ),
  );
  const strides = (more['strides'] ?? []) as readonly number[];
  const uri = `data:;base64,${body.toString('base64')}`;
  const document = {
    asset: { version: '2.0' },
    scenes: [{ nodes: [0] }],
    nodes: [{ mesh: 0 }],
    bufferViews: bufferViews.map((view, i) => ({ ...view, byteStride: strides[i] })),
    buffers: [{ ...buffers[0], uri }],
    accessors,
    ...more,
  };
  const url = new URL(`data:model/gltf+json,${encodeURIComponent(JSON.stringify(document))}`);
  return modelContent(url, OPTIONS);
}

const mesh = (attributes: Json, more: Json = {}): Json => ({
  meshes: [{ primitives: [{ attributes, ...more }] }],
});

const warnings = heardWarnings();

const triangle = new Float32Array(TRIANGLE);
const POSITION = view(0, 'VEC3');

describe('attributes', () => {
  it('may be normalised integers, interleaved, the last element without its padding', async () => {
    const values = new Int16Array([0, 0, 0, 99, 32767, 0, 0, 99, 0, 32767, 0]);
    const model = await gltf([values], [{ ...view(0, 'VEC3', SHORT), normalized: true }], {
      ...mesh({ POSITION: 0 }),
      strides: [8],
      extensionsRequired: ['KHR_mesh_quantization'],
    });
    expect(numbersOf(model, 'position')).toEqual(TRIANGLE);
  });

  it('may be interleaved and sparse, beside others of the same view', async () => {
    const values = new Float32Array([0, 0, 0, 0, 0, 2, 9, 9, 9, 0, 0, 2, 0, 1, 0, 0, 0, 2]);
    const sparse = {
      count: 1,
      indices: { bufferView: 1, componentType: UBYTE },
      values: { bufferView: 2 },
    };
    const model = await gltf(
      [values, new Uint8Array([1]), new Float32Array([1, 0, 0])],
      [
        { ...POSITION, sparse },
        { ...POSITION, byteOffset: 12 },
      ],
      { ...mesh({ POSITION: 0, NORMAL: 1 }), strides: [24] },
    );
    expect(numbersOf(model, 'position')).toEqual(TRIANGLE);
    expect(numbersOf(model, 'normal')).toEqual([0, 0, 1, 0, 0, 1, 0, 0, 1]);
  });

  it('may lie in a buffer that lacks the bytes behind them, but not their own', async () => {
    const uri = `data:;base64,${Buffer.from(triangle.buffer).toString('base64')}`;
    const short = { ...mesh({ POSITION: 0 }), buffers: [{ byteLength: 38, uri }] };
    expect(numbersOf(await gltf([triangle], [POSITION], short), 'position')).toEqual(TRIANGLE);
    const cut = { ...short, bufferViews: [{ buffer: 0, byteLength: 38 }] };
    await expect(gltf([triangle], [POSITION], cut)).rejects.toThrow(/buffers\[0\] is truncated/);
  });

  it('must be as many as there are vertices, and triangles must name vertices that exist', async () => {
    const fewer = view(0, 'VEC3', FLOAT, 2);
    await expect(
      gltf([triangle], [POSITION, fewer], mesh({ POSITION: 0, NORMAL: 1 })),
    ).rejects.toThrow(/fewer normal/);
    const indexed = mesh({ POSITION: 0 }, { indices: 1 });
    await expect(
      gltf([triangle, new Uint8Array([0, 1, 3])], [POSITION, view(1, 'SCALAR', UBYTE)], indexed),
    ).rejects.toThrow(/vertex 3 of 3/);
  });

  it('may have strided indices', async () => {
    const model = await gltf(
      [triangle, new Uint16Array([2, 9, 1, 9, 0, 9])],
      [POSITION, view(1, 'SCALAR', 5123)],
      {
        ...mesh({ POSITION: 0 }, { indices: 1 }),
        strides: [12, 4],
      },
    );
    expect(numbersOf(model, 'position')).toEqual(
      [2, 1, 0].flatMap((i) => TRIANGLE.slice(3 * i, 3 * i + 3)),
    );
  });

  it.each([
    ['fan, whose triangles share the first vertex', 6, [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0]],
    ['strip, in which every second triangle is reversed', 5, [0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0]],
  ])('may form a %s', async (_, mode, square) => {
    const positions = [new Float32Array(square)];
    const model = await gltf(
      positions,
      [view(0, 'VEC3', FLOAT, 4)],
      mesh({ POSITION: 0 }, { mode }),
    );
    expect(numbersOf(model, 'position')).toHaveLength(18);
    expect(numbersOf(model, 'normal').filter((_, i) => i % 3 === 2)).toEqual([1, 1, 1, 1, 1, 1]);
  });
});

it('nodes that share a mesh share its geometry, each with its own matrix, and those of other scenes are not shown', async () => {
  const model = await gltf([triangle], [POSITION], {
    ...mesh({ POSITION: 0 }),
    scene: 1,
    scenes: [{ nodes: [3] }, { nodes: [0] }],
    nodes: [
      { name: 'pair', translation: [0, 0, 1e8], children: [1, 2] },
      { mesh: 0, name: 'one', translation: [0.1, 0, 0] },
      { mesh: 0, name: 'two: mirrored', scale: [-1, 1, 1] },
      { mesh: 0, name: 'hidden' },
    ],
  });
  const [one, two] = model.parts;
  expect(model.parts.map(({ name }) => name)).toEqual(['one', 'two: mirrored']);
  expect(one?.geometry).toBe(two?.geometry);
  expect(one?.matrix.elements.slice(12)).toEqual([0.1, 0, 1e8, 1]);
  expect(two?.matrix.determinant()).toBeCloseTo(-1, 12);
});

describe('textures', () => {
  // The head of a PNG of 1 × 1 pixels; the rest is up to the decoder, which is a stand-in here.
  const image = `data:image/png;base64,${pngOf(1, 1, 32).toString('base64')}`;

  it('use the coordinates and the transform that the file names, in all meshes, and unused ones are not fetched', async () => {
    vi.stubGlobal('createImageBitmap', bitmapOf);
    // Those above the fourth take the places of unused ones.
    const sets = [0, 1, 4, 5, 9];
    const coordinates = Object.fromEntries(sets.map((n, i) => [`TEXCOORD_${n}`, i + 1]));
    const primitive = (position: number): Json => ({
      attributes: { POSITION: position, ...coordinates },
      material: 0,
    });
    const moved = { texCoord: 9, offset: [0.25, 0.5], scale: [2, 3] };
    const model = await gltf(
      [triangle, ...sets.map((u) => new Float32Array([u, 0, u, 1, u, 2]))],
      [POSITION, ...sets.map((_, i) => view(i + 1, 'VEC2')), POSITION],
      {
        meshes: [{ primitives: [primitive(0), primitive(sets.length + 1)] }],
        materials: [
          {
            pbrMetallicRoughness: {
              baseColorTexture: { index: 0, texCoord: 5 },
              metallicRoughnessTexture: { index: 0, texCoord: 1 },
            },
            emissiveTexture: { index: 0, texCoord: 5 },
            emissiveFactor: [1, 1, 1],
            normalTexture: { index: 0, extensions: { KHR_texture_transform: moved } },
            occlusionTexture: { index: 1, texCoord: 12 },
          },
        ],
        textures: [{ source: 0 }, { source: 1 }],
        images: [{ uri: image }, { uri: 'https://example.com/never-asked-for.png' }],
        extensionsUsed: ['KHR_texture_transform'],
      },
    );
    expect(model.parts).toHaveLength(2);
    for (const [part, { look }] of model.parts.entries()) {
      const used = [look.map, look.metalRoughMap, look.emissiveMap, look.normalMap].map((map) => {
        const channel = map?.channel ?? NaN;
        return numbersOf(model, channel === 0 ? 'uv' : `uv${channel}`, part)[0];
      });
      expect(used).toEqual([5, 1, 5, 9]);
      const matrix = look.normalMap?.matrix.elements.map((value) => value + 0);
      expect(matrix).toEqual([2, 0, 0, 0, 3, 0, 0.25, 0.5, 1]);
    }
  });

  it('are closed when another part of the model fails', async () => {
    const close = vi.fn();
    vi.stubGlobal('createImageBitmap', (blob: Blob) => bitmapOf(blob, close));
    const broken = gltf([new Float32Array([NaN, 0, 0, 1, 0, 0, 0, 1, 0])], [POSITION], {
      ...mesh({ POSITION: 0 }, { material: 0 }),
      materials: [{ pbrMetallicRoughness: { baseColorTexture: { index: 0 } } }],
      textures: [{ source: 0 }],
      images: [{ uri: image }],
    });
    await expect(broken).rejects.toMatchObject({ code: 'bad-model' });
    await expect.poll(() => close).toHaveBeenCalledTimes(1);
  });
});

it('sides are single unless the material says double, and single without a material', async () => {
  const part = (material?: number): Json => ({ attributes: { POSITION: 0 }, material });
  const model = await gltf([triangle], [POSITION], {
    materials: [{ doubleSided: true }, { doubleSided: false }, {}],
    meshes: [{ primitives: [part(0), part(1), part(2), part()] }],
  });
  expect(model.parts.map(({ sides }) => sides)).toEqual(['double', 'single', 'single', 'single']);
});

const BYTE = 5120;
const USHORT = 5123;

const list = (
  name: string,
  size: number,
  values: ArrayBufferView & ArrayLike<number>,
  componentType = FLOAT,
) => ({
  name,
  values,
  accessor: {
    type: `VEC${size}`,
    count: values.length / size,
    componentType,
    normalized: componentType !== FLOAT,
  },
});

/** A triangle at these instances of a node, which has a transform of its own. */
function instanced(lists: readonly ReturnType<typeof list>[], more: Json = {}, node: Json = {}) {
  const attributes = Object.fromEntries(lists.map(({ name }, i) => [name, i + 1]));
  return gltf(
    [triangle, ...lists.map(({ values }) => values)],
    [POSITION, ...lists.map(({ accessor }, i) => ({ bufferView: i + 1, ...accessor }))],
    {
      ...mesh({ POSITION: 0 }, { material: 0 }),
      materials: [{ pbrMetallicRoughness: { baseColorFactor: [1, 0.5, 0.5, 1] } }],
      extensionsRequired: ['EXT_mesh_gpu_instancing'],
      nodes: [{ mesh: 0, ...node, extensions: { EXT_mesh_gpu_instancing: { attributes } } }],
      ...more,
    },
  );
}

describe('instances', () => {
  it('are where their lists and their node put them, whichever lists there are and however quantised', async () => {
    const component = fc.integer({ min: -127, max: 127 });
    const components = (count: number) =>
      fc.array(component, { minLength: count, maxLength: count });
    const lists = fc.record(
      { TRANSLATION: components(9), ROTATION: components(12), SCALE: components(9) },
      { requiredKeys: [] },
    );
    const still = {
      TRANSLATION: Array<number>(9).fill(0),
      ROTATION: [0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1],
      SCALE: Array<number>(9).fill(1),
    };
    const types = fc.constantFrom([Float32Array, FLOAT], [Int8Array, BYTE], [Int16Array, SHORT]);
    await fc.assert(
      fc.asyncProperty(lists, types, async (given, [Type, componentType]) => {
        fc.pre(Object.keys(given).length > 0);
        const places = Object.entries(given).map(([name, values]) =>
          name === 'ROTATION'
            ? list(name, 4, new Type(values), componentType)
            : list(name, 3, new Float32Array(values)),
        );
        const model = await instanced(places, {}, { scale: [-2, 1, 1], translation: [5, 0, 0] });
        const node = new Matrix4().makeScale(-2, 1, 1).setPosition(5, 0, 0);
        expect(model.parts).toHaveLength(3);
        model.parts.forEach(({ matrix, geometry }, i) => {
          const { TRANSLATION, ROTATION, SCALE } = { ...still, ...given };
          // Whatever the divisor of its type, a quaternion is normalised.
          const q = new Quaternion().fromArray(ROTATION, i * 4);
          const turn = q.lengthSq() > 0 ? q.normalize() : new Quaternion();
          const [at, size] = [TRANSLATION, SCALE].map((list) =>
            new Vector3().fromArray(list, i * 3),
          );
          const wanted = new Matrix4().compose(at!, turn, size!).premultiply(node);
          wanted.elements.forEach((element, k) => {
            expect(matrix.elements[k]).toBeCloseTo(element, 9);
          });
          expect(geometry).toBe(model.parts[0]?.geometry);
        });
      }),
      { numRuns: 40 },
    );
  });

  it('have colours that multiply the base colour in linear light', async () => {
    for (const colors of [
      list('_COLOR_0', 4, new Uint8Array([255, 255, 0, 255, 0, 255, 255, 128]), UBYTE),
      list('_COLOR_0', 3, new Uint16Array([65535, 65535, 0, 0, 65535, 65535]), USHORT),
      list('_COLOR_0', 3, new Float32Array([1, 2, -1, NaN, 1, 1])),
    ]) {
      const { parts } = await instanced([colors]);
      expect(parts.map(({ look }) => look.baseColor.map((c) => Math.round(c * 255)))).toEqual([
        [255, 188, 0],
        [0, 188, 188],
      ]);
      expect(parts.map(({ look }) => look.alphaMode)).toEqual(['opaque', 'opaque']);
    }
  });

  it('share a look where they have one colour, and fade where it has an alpha and the material blends', async () => {
    const colors = list(
      '_COLOR_0',
      4,
      new Uint8Array([255, 255, 255, 51, 255, 255, 255, 51]),
      UBYTE,
    );
    const { parts } = await instanced([colors], { materials: [{ alphaMode: 'BLEND' }] });
    expect(parts[0]?.look).toBe(parts[1]?.look);
    expect(parts[0]?.look).toMatchObject({ alphaMode: 'blend', opacity: 0.2 });
  });

  it('are as many as their shortest list has, and the rest is named', async () => {
    const three = list('TRANSLATION', 3, new Float32Array(9));
    const two = list('SCALE', 3, new Float32Array([1, 1, 1, 2, 2, 2]));
    expect((await instanced([three, two])).parts).toHaveLength(2);
    expect(warnings.join()).toMatch(/is shown without instances of nodes\[0\]/);
  });

  it('are counted as draws', async () => {
    const tooMany = list('TRANSLATION', 3, new Float32Array(3 * 10_001));
    await expect(instanced([tooMany])).rejects.toThrow(/10,001 draws/);
  });

  it('follow their node when it moves', async () => {
    const extensions = { EXT_mesh_gpu_instancing: { attributes: { TRANSLATION: 1 } } };
    const channels = [{ sampler: 0, target: { node: 0, path: 'translation' } }];
    const model = await gltf(
      [
        triangle,
        new Float32Array([1, 0, 0, 2, 0, 0]),
        new Float32Array([0, 1]),
        new Float32Array([0, 0, 0, 7, 0, 0]),
      ],
      [POSITION, view(1, 'VEC3', FLOAT, 2), view(2, 'SCALAR', FLOAT, 2), view(3, 'VEC3', FLOAT, 2)],
      {
        ...mesh({ POSITION: 0 }),
        nodes: [{ mesh: 0, scale: [-1, 1, 1], extensions }],
        animations: [{ samplers: [{ input: 2, output: 3 }], channels }],
      },
    );
    model.motion?.pose('', 0.5);
    expect(model.parts.map(({ matrix }) => matrix.elements[12])).toEqual([2.5, 1.5]);
    model.motion?.pose(null, 0);
    expect(model.parts.map(({ matrix }) => matrix.elements[12])).toEqual([-1, -2]);
  });
});

describe('hidden nodes', () => {
  const hidden = { extensions: { KHR_node_visibility: { visible: false } } };
  const shown = { extensions: { KHR_node_visibility: { visible: true } } };

  it('are left out with all below them, even what says that it is visible', async () => {
    const model = await gltf([triangle], [POSITION], {
      ...mesh({ POSITION: 0 }),
      scenes: [{ nodes: [0, 4] }],
      nodes: [
        { name: 'a', mesh: 0, children: [1] },
        { name: 'b', mesh: 0, children: [2], ...hidden },
        { name: 'c', mesh: 0, children: [3], ...shown },
        { name: 'd', mesh: 0 },
        { name: 'e', mesh: 0, ...shown },
      ],
    });
    expect(model.parts.map(({ name }) => name)).toEqual(['a', 'e']);
    expect(warnings).toEqual([]);
  });

  it('still move a skin as its joints, wherever the node of its mesh is', async () => {
    const half = Math.SQRT1_2;
    const model = await skinned([
      { translation: [10, 0, 0], rotation: [half, 0, 0, half], ...hidden },
    ]);
    // A quarter turn about x brings y to z and z to -y.
    expect(numbersOf(model, 'position')).toEqual([10, 0, 0, 11, 0, 0, 10, 0, 1]);
    expect(numbersOf(model, 'normal')).toEqual([0, -1, 0, 0, -1, 0, 0, -1, 0]);
    expect(model.parts[0]?.matrix).toEqual(new Matrix4());
  });
});

/** A triangle whose corners follow these joints, the first one each if there are fewer. */
function skinned(joints: readonly Json[], more: Json = {}, blobs: readonly Float32Array[] = []) {
  const of = (corner: number) => Math.min(corner, joints.length - 1);
  const indices = new Uint8Array([0, 1, 2].flatMap((corner) => [of(corner), 0, 0, 0]));
  return gltf(
    [
      triangle,
      indices,
      new Float32Array([1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0]),
      new Float32Array([0, 0, 1, 0, 0, 1, 0, 0, 1]),
      new Float32Array([1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1]),
      new Uint8Array([0, 1, 2]),
      ...blobs,
    ],
    [
      POSITION,
      view(1, 'VEC4', UBYTE),
      view(2, 'VEC4'),
      view(3, 'VEC3'),
      view(4, 'VEC4'),
      view(5, 'SCALAR', UBYTE),
      ...blobs.map(({ length }, i) =>
        i === 0 ? view(6, 'SCALAR', FLOAT, length) : view(6 + i, 'VEC3', FLOAT, length / 3),
      ),
    ],
    {
      ...mesh({ POSITION: 0, JOINTS_0: 1, WEIGHTS_0: 2, NORMAL: 3 }, { indices: 5 }),
      scenes: [{ nodes: [0, ...joints.map((_, i) => i + 1)] }],
      nodes: [{ mesh: 0, skin: 0, translation: [50, 50, 50] }, ...joints],
      skins: [{ joints: joints.map((_, i) => i + 1) }],
      ...more,
    },
  );
}

/** z of the cross product of a part's first triangle: positive if it faces +z. */
function facing(model: Content) {
  const positions = numbersOf(model, 'position');
  const order = indexOf(model);
  const [a = 0, b = 1, c = 2] = order.length > 0 ? order : [0, 1, 2];
  const edge = (to: number, k: number) => positions[to * 3 + k]! - positions[a * 3 + k]!;
  return edge(b, 0) * edge(c, 1) - edge(b, 1) * edge(c, 0);
}

it('up to eight joints move a vertex', async () => {
  const document = readFileSync('tests/fixtures/cases/gltf/skin-8-influences.gltf', 'utf8');
  const url = new URL(`data:model/gltf+json,${encodeURIComponent(document)}`);
  const model = await modelContent(url, OPTIONS);
  const places = numbersOf(model, 'position');
  places.forEach((x, i) => expect(Math.abs(x)).toBeCloseTo(i % 3 === 2 ? 0 : 1, 5));
  expect([...(model.dropped ?? [])]).toEqual([]);
});

describe('mirrored joints', () => {
  const mirror = { scale: [-1, 1, 1] };

  it('leave the outside outside, with normals and without, indexed or not', async () => {
    for (const attributes of [{ NORMAL: 3 }, {}]) {
      for (const indices of [5, undefined]) {
        const primitive = mesh(
          { POSITION: 0, JOINTS_0: 1, WEIGHTS_0: 2, ...attributes },
          { indices },
        );
        const model = await skinned([mirror], primitive);
        expect(facing(model)).toBeGreaterThan(0);
        expect(numbersOf(model, 'normal').slice(0, 3)).toEqual([0, 0, 1]);
      }
    }
  });

  it('turn only the triangles that they mirror', async () => {
    expect(facing(await skinned([{}, { translation: [1, 0, 0] }, {}]))).toBeGreaterThan(0);
    const [one, two] = [await skinned([mirror, {}, {}]), await skinned([mirror, mirror, {}])];
    expect(indexOf(one)).toEqual([0, 1, 2]);
    expect(indexOf(two)).toEqual([0, 2, 1]);
  });

  it('and turn with a mesh whose scale changes its sign in an animation, in a copy too', async () => {
    const samplers = [{ input: 6, output: 7 }];
    const channels = [{ sampler: 0, target: { node: 1, path: 'scale' } }];
    const keyframes = [new Float32Array([0, 1]), new Float32Array([1, 1, 1, -1, 1, 1])];
    const model = await skinned([{}], { animations: [{ samplers, channels }] }, keyframes);
    const copy = movingCopy(model);
    const faces = [0.25, 0.75, 0.8, 0.25].flatMap((seconds) => {
      copy.motion?.pose('', seconds);
      return [facing(model) > 0, facing(copy) > 0];
    });
    expect(faces).not.toContain(false);
  });
});

describe('normals without direction', () => {
  /** Two triangles of a square, and the normals of its four corners. */
  const square = (normals: readonly number[], order: readonly number[], more: Json = {}) =>
    gltf(
      [
        new Float32Array([0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0]),
        new Float32Array(normals),
        new Uint16Array(order),
        new Float32Array(12).fill(1),
      ],
      [
        view(0, 'VEC3', FLOAT, 4),
        view(1, 'VEC3', FLOAT, 4),
        view(2, 'SCALAR', USHORT, order.length),
        view(3, 'VEC3', FLOAT, 4),
      ],
      { ...mesh({ POSITION: 0, NORMAL: 1 }, { indices: 2 }), ...more },
    );
  const ORDER = [0, 1, 2, 0, 2, 3];
  const BOTH_SIDES = [0, 1, 2, 0, 2, 1];

  it('are those of the faces where some are missing, and the file’s others stay, with unit length', async () => {
    const model = await square(
      [0, 3 * 2 ** 100, 4 * 2 ** 100, 0, 0, 0, NaN, 0, 1, 0, 0, Infinity],
      ORDER,
    );
    expect(numbersOf(model, 'normal')).toEqual([
      0, 0.6, 0.8, 0, 0, 1, 0, 0, 1, 0, 0.6, 0.8, 0, 0, 1, 0, 0, 1,
    ]);
  });

  it('are those of each side where a square has two', async () => {
    const model = await square([0, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0], BOTH_SIDES);
    expect(numbersOf(model, 'normal')).toEqual([
      0, 0, 1, 1, 0, 0, 0, 0, 1, 0, 0, -1, 0, 0, -1, 1, 0, 0,
    ]);
  });

  it('leave corners together where only triangles without area have them', async () => {
    const order = [0, 1, 2, 3, 3, 3];
    expect(indexOf(await square([0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 0], order))).toEqual(order);
  });

  it.each(['still', 'morphed'])(
    'are those of the faces where all are missing in a %s mesh',
    async (which) => {
      const morphed = mesh({ POSITION: 0, NORMAL: 1 }, { indices: 2, targets: [{ POSITION: 3 }] });
      const more = which === 'morphed' ? { ...morphed, weights: [1] } : {};
      const model = await square(new Array<number>(12).fill(0), ORDER, more);
      expect(numbersOf(model, 'normal')).toEqual(ORDER.flatMap(() => [0, 0, 1]));
    },
  );
});

describe('metals', () => {
  const lookOf = async (pbrMetallicRoughness: Json, more: Json = {}) => {
    const materials = [{ pbrMetallicRoughness, ...more }];
    const shape = mesh({ POSITION: 0 }, { material: 0 });
    return (await gltf([triangle], [POSITION], { ...shape, materials })).parts[0];
  };

  it('look alike whether the file writes the defaults or leaves them out', async () => {
    const plain = await lookOf({});
    const glossy = { extensions: { KHR_materials_pbrSpecularGlossiness: { glossinessFactor: 1 } } };
    for (const part of [
      await lookOf({ metallicFactor: 1, roughnessFactor: 1 }),
      await lookOf({ metallicFactor: 1 }),
      await lookOf({ roughnessFactor: 1 }),
      await lookOf({}, glossy),
    ]) {
      expect(part?.look).toEqual(plain?.look);
      expect(part?.surface).toEqual(plain?.surface);
    }
  });

  it('keep half of Kd without a texture', async () => {
    expect((await lookOf({ roughnessFactor: 0.3 }))?.look).toMatchObject({
      metalness: 0.5,
      roughness: 0.3,
    });
    expect((await lookOf({ metallicFactor: 0.2 }))?.look).toMatchObject({
      metalness: 0.2,
      roughness: 1,
    });
  });
});

it('what is left out is named once, in one warning of bounded length', async () => {
  const light = { extensions: { KHR_lights_punctual: { light: 0 } } };
  const target = { path: 'pointer', extensions: { KHR_animation_pointer: { pointer: '/' } } };
  const primitives = [
    { attributes: { POSITION: 0 }, material: 0 },
    { attributes: { POSITION: 0 }, mode: 0 },
    { attributes: { POSITION: 0 }, mode: 3, extensions: { KHR_xmp_json_ld: {} } },
  ];
  await gltf([triangle], [POSITION], {
    extensions: { KHR_lights_punctual: { lights: [{ type: 'point' }] } },
    materials: [{ extensions: { KHR_materials_clearcoat: {} }, occlusionTexture: { index: 0 } }],
    meshes: [{ primitives }],
    nodes: [{ mesh: 0, extensions: { ['X'.repeat(1e6)]: {} }, children: [1] }, light],
    animations: [{ samplers: [], channels: [{ sampler: 0, target }] }],
  });
  expect(warnings).toHaveLength(1);
  expect(warnings[0]).toMatch(
    /without KHR_lights_punctual, X+\.\.\., KHR_materials_clearcoat, occlusionTexture, points, lines, KHR_animation_pointer\.$/,
  );
  expect(warnings[0]!.length).toBeLessThan(300);
});
