// Is what a glTF file says shown, whatever combination says it: instances, hidden nodes, missing normals, mirrored
// joints, written defaults? And is what is left out named?
import fc from 'fast-check';
import { Matrix4, Quaternion, Vector3 } from 'three';
import { describe, expect, it } from 'vitest';
import type { Content } from '../../src/model/model.js';
import { FLOAT, gltf, type Json, mesh, numbers, SHORT, TRIANGLE, UBYTE } from './gltf-files.js';
import { heardWarnings, indexOf } from './model-files.js';

const warnings = heardWarnings();

const POSITION = { bufferView: 0, type: 'VEC3', count: 3, componentType: FLOAT };
const BYTE = 5120;
const USHORT = 5123;

interface List {
  readonly name: string;
  readonly values: ArrayBufferView;
  readonly accessor: Json;
}

const list = (
  name: string,
  type: string,
  values: Float32Array | Int8Array | Int16Array | Uint8Array | Uint16Array,
): List => ({
  name,
  values,
  accessor: {
    type,
    count: values.length / Number(type.at(-1)),
    componentType: {
      Float32Array: FLOAT,
      Int8Array: BYTE,
      Int16Array: SHORT,
      Uint8Array: UBYTE,
      Uint16Array: USHORT,
    }[values.constructor.name],
    normalized: !(values instanceof Float32Array),
  },
});

/** A triangle at these instances of a node, which has a transform of its own. */
function instanced(lists: readonly List[], more: Json = {}, node: Json = {}): Promise<Content> {
  const attributes = Object.fromEntries(lists.map(({ name }, i) => [name, i + 1]));
  return gltf(
    [new Float32Array(TRIANGLE), ...lists.map(({ values }) => values)],
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
    const lists = fc.record(
      {
        TRANSLATION: fc.array(component, { minLength: 9, maxLength: 9 }),
        ROTATION: fc.array(component, { minLength: 12, maxLength: 12 }),
        SCALE: fc.array(component, { minLength: 9, maxLength: 9 }),
      },
      { requiredKeys: [] },
    );
    const types = [Float32Array, Int8Array, Int16Array] as const;
    await fc.assert(
      fc.asyncProperty(lists, fc.constantFrom(...types), fc.boolean(), async (given, Type, mirrored) => {
        fc.pre(Object.keys(given).length > 0);
        const divisor = { Float32Array: 1, Int8Array: 127, Int16Array: 32767 }[Type.name] ?? 1;
        const places = Object.entries(given).map(([name, values]) =>
          list(
            name,
            `VEC${String(values.length / 3)}`,
            new (name === 'ROTATION' ? Type : Float32Array)(values),
          ),
        );
        const model = await instanced(
          places,
          {},
          { scale: [mirrored ? -2 : 2, 1, 1], translation: [5, 0, 0] },
        );
        const node = new Matrix4().compose(
          new Vector3(5, 0, 0),
          new Quaternion(),
          new Vector3(mirrored ? -2 : 2, 1, 1),
        );
        expect(model.parts).toHaveLength(3);
        model.parts.forEach(({ matrix, geometry }, i) => {
          const { TRANSLATION: t = [], ROTATION: r = [], SCALE: s = [1, 1, 1, 1, 1, 1, 1, 1, 1] } = given;
          const q = new Quaternion().fromArray(
            r.length > 0 ? r.map((c) => c / divisor) : [0, 0, 0, 1],
            r.length > 0 ? i * 4 : 0,
          );
          const turn = q.lengthSq() > 0 ? q.normalize() : new Quaternion();
          const at = t.length > 0 ? new Vector3().fromArray(t, i * 3) : new Vector3();
          const wanted = new Matrix4().compose(at, turn, new Vector3().fromArray(s, i * 3)).premultiply(node);
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
      list('_COLOR_0', 'VEC4', new Uint8Array([255, 255, 0, 255, 0, 255, 255, 128])),
      list('_COLOR_0', 'VEC3', new Uint16Array([65535, 65535, 0, 0, 65535, 65535])),
      list('_COLOR_0', 'VEC3', new Float32Array([1, 2, -1, NaN, 1, 1])),
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
    const colors = list('_COLOR_0', 'VEC4', new Uint8Array([255, 255, 255, 51, 255, 255, 255, 51]));
    const { parts } = await instanced([colors], { materials: [{ alphaMode: 'BLEND' }] });
    expect(parts[0]?.look).toBe(parts[1]?.look);
    expect(parts[0]?.look).toMatchObject({ alphaMode: 'blend', opacity: 0.2 });
  });

  it('are as many as their shortest list has, and the rest is named', async () => {
    const three = list('TRANSLATION', 'VEC3', new Float32Array(9));
    const two = list('SCALE', 'VEC3', new Float32Array([1, 1, 1, 2, 2, 2]));
    expect((await instanced([three, two])).parts).toHaveLength(2);
    expect(warnings.join()).toMatch(/is shown without instances of nodes\[0\]/);
  });

  it('are counted as draws', async () => {
    const accessor = { type: 'VEC3', count: 10_001, componentType: FLOAT };
    const more = {
      ...mesh({ POSITION: 0 }),
      nodes: [{ mesh: 0, extensions: { EXT_mesh_gpu_instancing: { attributes: { TRANSLATION: 1 } } } }],
    };
    await expect(gltf([new Float32Array(TRIANGLE)], [POSITION, accessor], more)).rejects.toThrow(
      /10,001 draws/,
    );
  });

  it('follow their node when it moves', async () => {
    const attributes = { TRANSLATION: 1 };
    const model = await gltf(
      [
        new Float32Array(TRIANGLE),
        new Float32Array([1, 0, 0, 2, 0, 0]),
        new Float32Array([0, 1]),
        new Float32Array([0, 0, 0, 7, 0, 0]),
      ],
      [
        POSITION,
        { bufferView: 1, type: 'VEC3', count: 2, componentType: FLOAT },
        { bufferView: 2, type: 'SCALAR', count: 2, componentType: FLOAT },
        { bufferView: 3, type: 'VEC3', count: 2, componentType: FLOAT },
      ],
      {
        ...mesh({ POSITION: 0 }),
        nodes: [{ mesh: 0, scale: [-1, 1, 1], extensions: { EXT_mesh_gpu_instancing: { attributes } } }],
        animations: [
          {
            samplers: [{ input: 2, output: 3 }],
            channels: [{ sampler: 0, target: { node: 0, path: 'translation' } }],
          },
        ],
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
    const model = await gltf([new Float32Array(TRIANGLE)], [POSITION], {
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

  it('still move a skin as its joints', async () => {
    const model = await skinned([{ translation: [3, 0, 0], ...hidden }]);
    expect(numbers(model, 'position').slice(0, 3)).toEqual([3, 0, 0]);
  });
});

/** A triangle whose corners follow these joints, the first one each if there are fewer. */
function skinned(
  joints: readonly Json[],
  more: Json = {},
  blobs: readonly Float32Array[] = [],
): Promise<Content> {
  const of = (corner: number): number => Math.min(corner, joints.length - 1);
  const indices = new Uint8Array([0, 1, 2].flatMap((corner) => [of(corner), 0, 0, 0]));
  return gltf(
    [
      new Float32Array(TRIANGLE),
      indices,
      new Float32Array([1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0]),
      new Float32Array([0, 0, 1, 0, 0, 1, 0, 0, 1]),
      new Float32Array([1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1]),
      new Uint8Array([0, 1, 2]),
      ...blobs,
    ],
    [
      POSITION,
      { bufferView: 1, type: 'VEC4', count: 3, componentType: UBYTE },
      { bufferView: 2, type: 'VEC4', count: 3, componentType: FLOAT },
      { bufferView: 3, type: 'VEC3', count: 3, componentType: FLOAT },
      { bufferView: 4, type: 'VEC4', count: 3, componentType: FLOAT },
      { bufferView: 5, type: 'SCALAR', count: 3, componentType: UBYTE },
      ...blobs.map((values, i) => ({
        bufferView: 6 + i,
        type: i === 0 ? 'SCALAR' : 'VEC3',
        count: i === 0 ? values.length : values.length / 3,
        componentType: FLOAT,
      })),
    ],
    {
      ...mesh({ POSITION: 0, JOINTS_0: 1, WEIGHTS_0: 2, NORMAL: 3 }, { indices: 5 }),
      scenes: [{ nodes: [0, ...joints.map((_, i) => i + 1)] }],
      nodes: [{ mesh: 0, skin: 0 }, ...joints],
      skins: [{ joints: joints.map((_, i) => i + 1) }],
      ...more,
    },
  );
}

/** z of the cross product of a part's first triangle: positive if it faces +z. */
function facing(model: Content): number {
  const positions = numbers(model, 'position');
  const order = indexOf(model);
  const [a = 0, b = 1, c = 2] = order.length > 0 ? order : [0, 1, 2];
  const edge = (to: number, k: number): number => positions[to * 3 + k]! - positions[a * 3 + k]!;
  return edge(b, 0) * edge(c, 1) - edge(b, 1) * edge(c, 0);
}

describe('mirrored joints', () => {
  const mirror = { scale: [-1, 1, 1] };

  it('leave the outside outside, with normals and without, indexed or not', async () => {
    for (const attributes of [{ NORMAL: 3 }, {}])
      for (const indices of [5, undefined]) {
        const primitive = mesh({ POSITION: 0, JOINTS_0: 1, WEIGHTS_0: 2, ...attributes }, { indices });
        const model = await skinned([mirror], primitive);
        expect(facing(model)).toBeGreaterThan(0);
        expect(numbers(model, 'normal').slice(0, 3)).toEqual(
          [0, 0, 1].map((c) => expect.closeTo(c, 6) as number),
        );
      }
  });

  it('turn only the triangles that they mirror', async () => {
    expect(facing(await skinned([{}, { translation: [1, 0, 0] }, {}]))).toBeGreaterThan(0);
    const [one, two] = [await skinned([mirror, {}, {}]), await skinned([mirror, mirror, {}])];
    expect(indexOf(one)).toEqual([0, 1, 2]);
    expect(indexOf(two)).toEqual([0, 2, 1]);
  });

  it('and turn with a mesh whose scale changes its sign in an animation', async () => {
    const samplers = [{ input: 6, output: 7 }];
    const channels = [{ sampler: 0, target: { node: 1, path: 'scale' } }];
    const keyframes = [new Float32Array([0, 1]), new Float32Array([1, 1, 1, -1, 1, 1])];
    const model = await skinned([{}], { animations: [{ samplers, channels }] }, keyframes);
    const faces = [0.25, 0.75, 0.25].map((seconds) => {
      model.motion?.pose('', seconds);
      return facing(model) > 0;
    });
    expect(faces).toEqual([true, true, true]);
  });
});

describe('normals without direction', () => {
  /** Two triangles of a square, and the normals of its four corners. */
  const square = (normals: readonly number[], order: readonly number[], more: Json = {}): Promise<Content> =>
    gltf(
      [
        new Float32Array([0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0]),
        new Float32Array(normals),
        new Uint16Array(order),
        new Float32Array(12).fill(1),
      ],
      [
        { ...POSITION, count: 4 },
        { bufferView: 1, type: 'VEC3', count: 4, componentType: FLOAT },
        { bufferView: 2, type: 'SCALAR', count: order.length, componentType: USHORT },
        { bufferView: 3, type: 'VEC3', count: 4, componentType: FLOAT },
      ],
      { ...mesh({ POSITION: 0, NORMAL: 1 }, { indices: 2 }), ...more },
    );
  const ORDER = [0, 1, 2, 0, 2, 3];
  const BOTH_SIDES = [0, 1, 2, 0, 2, 1];

  it('are computed anew where some are missing, and the file’s others stay', async () => {
    const model = await square([0, 0.6, 0.8, 0, 0, 0, NaN, 0, 1, 0, 0, Infinity], ORDER);
    expect(numbers(model, 'normal')).toEqual([0, 0.6, 0.8, 0, 0, 1, 0, 0, 1, 0, 0, 1].map(Math.fround));
    expect(indexOf(model)).toEqual(ORDER);
  });

  it('are those of the faces where all are missing', async () => {
    expect(numbers(await square(new Array<number>(12).fill(0), ORDER), 'normal')).toEqual(
      ORDER.flatMap(() => [0, 0, 1]),
    );
  });

  it('are the face’s own where the mean would be that of another side', async () => {
    const model = await square([0, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0], BOTH_SIDES);
    expect(numbers(model, 'normal')).toEqual([0, 0, 1, 1, 0, 0, 0, 0, 1, 0, 0, -1, 0, 0, -1, 1, 0, 0]);
  });

  it('of a morphed mesh follow its faces', async () => {
    const morphed = mesh({ POSITION: 0, NORMAL: 1 }, { indices: 2, targets: [{ POSITION: 3 }] });
    const model = await square(new Array<number>(12).fill(0), ORDER, { ...morphed, weights: [1] });
    expect(numbers(model, 'normal')).toEqual(ORDER.flatMap(() => [0, 0, 1]));
  });
});

describe('metals', () => {
  const lookOf = async (pbrMetallicRoughness: Json, more: Json = {}) =>
    (
      await gltf([new Float32Array(TRIANGLE)], [POSITION], {
        ...mesh({ POSITION: 0 }, { material: 0 }),
        materials: [{ pbrMetallicRoughness, ...more }],
      })
    ).parts[0];

  it('look alike whether the file writes the defaults or leaves them out', async () => {
    const plain = await lookOf({});
    const glossy = { extensions: { KHR_materials_pbrSpecularGlossiness: { glossinessFactor: 1 } } };
    const written = [
      { metallicFactor: 1, roughnessFactor: 1 },
      { metallicFactor: 1 },
      { roughnessFactor: 1 },
    ];
    for (const part of [
      ...(await Promise.all(written.map((values) => lookOf(values)))),
      await lookOf({}, glossy),
    ]) {
      expect(part?.look).toEqual(plain?.look);
      expect(part?.surface).toEqual(plain?.surface);
    }
  });

  it('keep half of Kd without a texture', async () => {
    expect((await lookOf({ roughnessFactor: 0.3 }))?.look).toMatchObject({ metalness: 0.5, roughness: 0.3 });
    expect((await lookOf({ metallicFactor: 0.2 }))?.look).toMatchObject({ metalness: 0.2, roughness: 1 });
  });
});

describe('what is left out', () => {
  it('is named once, in one warning of bounded length', async () => {
    const long = 'X'.repeat(1e6);
    const light = { extensions: { KHR_lights_punctual: { light: 0 } } };
    await gltf([new Float32Array(TRIANGLE)], [POSITION], {
      extensions: { KHR_lights_punctual: { lights: [{ type: 'point' }] } },
      meshes: [
        {
          primitives: [
            { attributes: { POSITION: 0 } },
            { attributes: { POSITION: 0 }, mode: 0 },
            { attributes: { POSITION: 0 }, mode: 3, extensions: { KHR_xmp_json_ld: {} } },
          ],
        },
      ],
      nodes: [{ mesh: 0, extensions: { [long]: {} }, children: [1] }, light],
      animations: [
        {
          samplers: [],
          channels: [
            {
              sampler: 0,
              target: { path: 'pointer', extensions: { KHR_animation_pointer: { pointer: '/' } } },
            },
          ],
        },
      ],
    });
    expect(warnings).toHaveLength(1);
    expect(warnings[0]).toMatch(
      /without KHR_lights_punctual, X+\.\.\., points, lines, KHR_animation_pointer\.$/,
    );
    expect(warnings[0]!.length).toBeLessThan(300);
  });
});
