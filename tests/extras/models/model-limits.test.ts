// Are files that claim too much, or claim nonsense, refused? The files are small, and no more than
// the limit of what they claim may be allocated.
import { readFileSync } from 'node:fs';
import { deflateSync } from 'node:zlib';
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { Growing } from '../../../src/extras/models/triangles/corner-lists.js';
import { LIMITS } from '../../../src/phong/model/limits.js';
import { ModelBudget } from '../../../src/phong/model/model-budget.js';
import { modelContent } from '../../../src/extras/models/model-content.js';
import { type Content, ModelError } from '../../../src/phong/model/model.js';
import { bitmapOf, OPTIONS, view } from './model-files.js';
import { bar } from '../../support/animated-gltf.js';
import { floats, glbOf, jpegWith, type Json, openGlb, pngWith, viewsOf } from '../../fuzz/glb.js';
import * as hostile from '../../fuzz/models.js';

const load = (file: Buffer | Blob) => {
  if (file instanceof Blob) return modelContent(new URL('file:///a'), OPTIONS, file);
  return modelContent(new URL(`data:model/gltf-binary;base64,${file.toString('base64')}`), OPTIONS);
};

const NATIVE = Float32Array;

/**
 * The error's code and message, or what was loaded. Fails where more floats are allocated than a
 * model may have.
 */
async function outcome(file: Buffer | Blob) {
  let allocated = 0;
  const construct = (target: Float32ArrayConstructor, args: [number]) => {
    if (typeof args[0] === 'number') {
      expect((allocated += args[0])).toBeLessThanOrEqual(LIMITS.values);
    }
    return Reflect.construct(target, args) as Float32Array;
  };
  vi.stubGlobal('Float32Array', new Proxy(NATIVE, { construct }));
  const result: unknown = await load(file).catch((error: unknown) => error);
  if (result instanceof ModelError) return `${result.code}: ${result.message}`;
  return `${String((result as Content).parts.length)} parts`;
}

const jsonOf = (document: Json): Buffer => Buffer.from(JSON.stringify(document));

const UBYTE = 5121;
const FLOAT = 5126;
const TRIANGLE = floats(0, 0, 0, 1, 0, 0, 0, 1, 0);
/** The triangle's own accessor. */
const SOUND = view(0, 'VEC3');

afterEach(() => {
  vi.unstubAllGlobals();
});

it('the limits allow five million triangles, two thousand parts and 64 megapixels', () => {
  new ModelBudget().add({ corners: 15e6, values: 15e6 * 6 });
  new ModelBudget().add({ parts: 2000, nodes: 2000, values: 1e6, json: 5e5 });
  new ModelBudget().add({ pixels: 64e6, values: 1e6, parts: 100 });
});

describe('accessors', () => {
  const nodes = Array.from({ length: 200 }, (_, mesh) => ({ mesh }));
  const together = {
    accessors: Array<Json>(200).fill({ componentType: FLOAT, count: 300_000, type: 'VEC3' }),
    meshes: nodes.map((_, i) => ({ primitives: [{ attributes: { POSITION: i } }] })),
    nodes,
    scenes: [{ nodes: nodes.map((_, i) => i) }],
  };
  const attributes = { POSITION: 0, NORMAL: 0, COLOR_0: 0, TEXCOORD_0: 0 };

  it.each([
    ['a strip of 40 million indices', hostile.zerosGlb(40e6, { indices: 1, mode: 5 })],
    ['a fan of 6 million vertices', hostile.zerosGlb(6e6, { mode: 6 })],
    ['bytes that become floats', hostile.zerosGlb(40e6, {}, { componentType: UBYTE })],
    ['vertices that no triangle uses', hostile.zerosGlb(1e9, { indices: 0 })],
    ['corners that get a normal each', hostile.zerosGlb(16e6, { indices: 1 })],
    ['elements larger than those used', hostile.zerosGlb(7e6, {}, { type: 'MAT4' })],
    ['many accessors together', hostile.triangleGlb(together)],
    ['one accessor of many attributes', hostile.zerosGlb(10e6, { attributes })],
  ])('count as what they become: %s are too-large', async (_, file) => {
    expect(await outcome(file)).toMatch(/^too-large: The model has [\d,]+ \w+.* at most/);
  });

  it('that primitives share are not copied whole where each uses a few', async () => {
    const count = 3000;
    const accessors = [
      { componentType: FLOAT, count: 1e6, type: 'VEC3' },
      { bufferView: 1, componentType: UBYTE, count: 3, type: 'SCALAR' },
    ];
    const { bufferViews, buffers, body } = viewsOf([floats(0), Buffer.from([0, 1, 2])]);
    const primitive = { attributes: { POSITION: 0, NORMAL: 0 }, indices: 1 };
    const meshes = [{ primitives: Array<Json>(count).fill(primitive) }];
    const document = hostile.triangleDocument({ accessors, meshes, bufferViews, buffers });
    const { parts } = await load(glbOf(document, body));
    expect(parts).toHaveLength(count);
    expect(new Set(parts.map(({ geometry }) => geometry)).size).toBe(1);
    expect(parts[0]?.geometry.getAttribute('position').count).toBe(3);
  });
});

describe('every accessor that is read is counted', () => {
  const claim = 3e8;
  /** Puts a value in place of one. */
  const SPARSE = {
    count: 1,
    indices: { bufferView: 0, componentType: 5123 },
    values: { bufferView: 0 },
  };

  it.each(['POSITION', 'NORMAL'])(
    'a morph target with fewer or more %s than its mesh has vertices',
    async (name) => {
      for (const count of [2, claim]) {
        const accessors = [SOUND, { componentType: 5120, count, type: 'VEC3' }];
        const primitives = [{ attributes: { POSITION: 0 }, targets: [{ [name]: 1 }] }];
        const file = hostile.triangleGlb({ accessors, meshes: [{ primitives, weights: [1] }] });
        const what = `targets\\[0\\].${name} has ${count} elements, but its mesh has 3 vertices`;
        expect(await outcome(file)).toMatch(new RegExp(`^bad-model: .*${what}`));
      }
    },
  );

  const whole = bar();
  const accessors = whole['accessors'] as readonly Json[];
  it.each(accessors.map((_, i) => i))(
    'accessor %i of a skinned, morphed and animated bar, with a claim of 300 million zeros',
    async (i) => {
      for (const sparse of [undefined, SPARSE]) {
        const claims = accessors.map((accessor, k) =>
          k === i ? { ...accessor, bufferView: undefined, count: claim, sparse } : accessor,
        );
        const result = await outcome(jsonOf({ ...whole, accessors: claims }));
        // Animations whose times do not fit their values are left out, unread.
        const leftOut = i === accessors.findIndex(({ type }, k) => type === 'SCALAR' && k > 8);
        expect(result).toMatch(
          leftOut ? /^1 parts$/ : /^(too-large: .* at most|bad-model: .*elements, but its mesh)/,
        );
      }
    },
  );

  it('and one that is not read gives no numbers', async () => {
    const nodes = [...(whole['nodes'] as Json[]), { mesh: 1 }];
    const unread = { primitives: [{ attributes: { POSITION: accessors.length } }] };
    const meshes = [...(whole['meshes'] as Json[]), unread];
    const more = [...accessors, { componentType: FLOAT, count: claim, type: 'VEC3' }];
    expect(await outcome(jsonOf({ ...whole, nodes, meshes, accessors: more }))).toBe('1 parts');
  });

  it('and Draco data count once for each mesh that is made of them', async () => {
    const attributes = { POSITION: 0, NORMAL: 0 };
    const bufferViews = Array<Json>(200).fill({ buffer: 0, byteOffset: 0, byteLength: 36 });
    const primitives = bufferViews.map((_, bufferView) => ({
      attributes,
      indices: 1,
      extensions: { KHR_draco_mesh_compression: { bufferView, attributes: { POSITION: 0 } } },
    }));
    const accessors = [
      { componentType: FLOAT, count: 500_000, type: 'VEC3' },
      { componentType: 5125, count: 3, type: 'SCALAR' },
    ];
    const file = hostile.triangleGlb({ meshes: [{ primitives }], bufferViews, accessors });
    expect(await outcome(file)).toMatch(/^too-large: .*numbers in its vertices/);
  });

  it('and the values of each animated property', async () => {
    const targets = 4000;
    const times = accessors.length;
    const channel = { sampler: 0, target: { node: 0, path: 'weights' } };
    const file = jsonOf({
      ...bar({ skinned: false, morphed: false }),
      meshes: [{ primitives: [{ attributes: { POSITION: 0 }, targets: Array(targets).fill({}) }] }],
      accessors: [
        ...accessors,
        { componentType: FLOAT, count: 1, type: 'SCALAR' },
        { componentType: FLOAT, count: targets, type: 'SCALAR' },
      ],
      animations: [
        { samplers: [{ input: times, output: times + 1 }], channels: Array(10_000).fill(channel) },
      ],
    });
    expect(await outcome(file)).toMatch(/^too-large: .*numbers in its vertices/);
  });
});

describe('parts', () => {
  it.each([true, false])(
    'of 2000 nodes load and share one geometry (one mesh: %s)',
    async (shared) => {
      const { parts } = await load(hostile.instancesGlb(2000, shared));
      expect(parts).toHaveLength(2000);
      expect(new Set(parts.map(({ geometry }) => geometry)).size).toBe(1);
    },
  );
});

describe('images', () => {
  const decode = vi.fn((blob: Blob, _options: ImageBitmapOptions) => bitmapOf(blob));
  const png = (width: number, height: number) =>
    pngWith(width, height, 32, deflateSync(Buffer.alloc(10)));

  beforeEach(() => {
    decode.mockClear();
    vi.stubGlobal('createImageBitmap', decode);
  });

  it.each([
    ['three of 8192 × 4096', Array.from({ length: 3 }, () => png(8192, 4096))],
    ['many whose sum is too much', Array.from({ length: 65 }, () => png(1024, 1024))],
  ])('are too-large by their headers: %s', async (_, images) => {
    const textures = images.map((_, source) => ({ source }));
    expect(await outcome(hostile.texturedGlb(images, textures))).toMatch(
      /^too-large: .*pixels in its images/,
    );
    expect(decode.mock.calls.length).toBeLessThan(65);
  });

  it('used by two thousand textures are decoded once and are one texture', async () => {
    const textures = Array.from({ length: 2000 }, () => ({ source: 0 }));
    const { parts } = await load(hostile.texturedGlb([png(4096, 4096)], textures));
    expect(decode).toHaveBeenCalledTimes(1);
    expect(new Set(parts.map(({ look }) => look.map)).size).toBe(1);
  });

  it('count again for another sampler, because they are uploaded again', async () => {
    const samplers = [10497, 33071, 33648, 10497, 33071].map((wrapS, i) => ({
      wrapS,
      wrapT: i > 2 ? 33648 : 10497,
    }));
    const textures = samplers.map((_, sampler) => ({ source: 0, sampler }));
    const { json, body } = openGlb(hostile.texturedGlb([png(4096, 4096)], textures));
    expect(await outcome(glbOf({ ...json, samplers }, body))).toMatch(
      /^too-large: .*pixels in its images/,
    );
  });

  it('are not decoded once their load is aborted', async () => {
    let finish = (): void => undefined;
    decode.mockImplementationOnce(
      (blob) => new Promise((resolve) => (finish = () => resolve(bitmapOf(blob)))),
    );
    const abort = new AbortController();
    const file = hostile.texturedGlb(
      [png(4096, 4096), png(4096, 4095)],
      [{ source: 0 }, { source: 1 }],
    );
    const options = { ...OPTIONS, signal: abort.signal };
    const ended = modelContent(
      new URL('file:///a'),
      options,
      new Blob([new Uint8Array(file)]),
    ).catch(String);
    await expect.poll(() => decode.mock.calls.length).toBe(1);
    abort.abort();
    finish();
    expect(await ended).toMatch(/AbortError/);
    await load(file); // waits for its turn behind them
    expect(decode).toHaveBeenCalledTimes(3);
  });

  it('larger than 8192 pixels on a side are decoded smaller', async () => {
    await load(hostile.texturedGlb([png(16384, 1000)], [{ source: 0 }]));
    await load(hostile.texturedGlb([png(8192, 4096)], [{ source: 0 }]));
    const sizes = decode.mock.calls.map(([, { resizeWidth, resizeHeight }]) => [
      resizeWidth,
      resizeHeight,
    ]);
    expect(sizes).toEqual([
      [8192, 500],
      [undefined, undefined],
    ]);
  });

  it('of more than a hundred scans are left out, whatever the header says', async () => {
    vi.spyOn(console, 'warn').mockReturnValue();
    const withScans = async (scans: number) => {
      const image = jpegWith(640, 480, scans);
      return (await load(hostile.texturedGlb([image], [{ source: 0 }]))).missing;
    };
    expect(await withScans(101)).toEqual(['images[0]']);
    expect(decode).not.toHaveBeenCalled();
    decode.mockImplementationOnce(() =>
      Promise.resolve({ width: 640, height: 480, close: vi.fn() } as never),
    );
    expect(await withScans(100)).toEqual([]);
    expect(decode).toHaveBeenCalledTimes(1);
  });

  it('with more than half of all pixels are left out, KTX2 too, and nothing is decoded', async () => {
    const file = readFileSync(new URL('../../fixtures/models/ktx2.glb', import.meta.url));
    const ktx2 = Buffer.from(file.subarray(file.indexOf('\xabKTX 20', 0, 'latin1')));
    ktx2.writeUInt32LE(8192, 20);
    ktx2.writeUInt32LE(8192, 24);
    const warn = vi.spyOn(console, 'warn').mockReturnValue().mockClear();
    for (const image of [png(8192, 4097), png(60_000, 60_000), ktx2]) {
      const model = await load(hostile.texturedGlb([image], [{ source: 0 }]));
      expect(model.missing).toEqual(['images[0]']);
      expect(model.parts[0]!.look.map).toBeNull();
    }
    expect(decode).not.toHaveBeenCalled();
    expect(warn).toHaveBeenCalledWith(expect.stringMatching(/has 33,562,624 pixels; at most /));
  });
});

const beyondAccessors = /^bad-model: .*its Draco data claims \d triangles/;
it.each([
  ['claim more triangles than their accessors', [9, 3], [1, 3], beyondAccessors],
  ['claim more points than their accessors', [1, 7], [1, 3], beyondAccessors],
  ['claim 50 million triangles', [50e6, 3], [1, 3], /^too-large/],
  ['agree with accessors beyond the limits', [50e6, 25e6], [50e6, 25e6], /^too-large/],
  [
    'agree with accessors beyond the limits of a mesh',
    [1.2e6, 6e5],
    [1.2e6, 6e5],
    /in one Draco mesh/,
  ],
  ['are themselves beyond the limits of a mesh', [1.2e6, 6e5], [8e5, 4e5], /in one Draco mesh/],
  ['end after their header', [1e5, 5e4], [1e5, 5e4], /^bad-model: .*Draco data/],
] as const)(
  'Draco data that %s are refused before decoding',
  async (_, [faces, points], [claimed, least], message) => {
    expect(
      await outcome(hostile.dracoGlb(faces, points, { faces: claimed, points: least })),
    ).toMatch(message);
  },
);

describe('text', () => {
  /** A triangle and `size` bytes more. */
  const embedded = (size: number, change: (uri: string) => string = (uri) => uri): Buffer => {
    const bytes = Buffer.concat([TRIANGLE, Buffer.alloc(size)]);
    const document = hostile.triangleDocument({
      buffers: [{ byteLength: bytes.length, uri: 'BUFFER' }],
    });
    const uri = change(`data:application/octet-stream;base64,${bytes.toString('base64')}`);
    return Buffer.from(JSON.stringify(document).replace('BUFFER', uri));
  };

  it.each([
    ['short', embedded(0)],
    ['long', embedded(1e6)],
    ['long, with escaped slashes', embedded(1e4, (uri) => uri.replaceAll('/', '\\/'))],
    ['long, with escaped padding', embedded(9999, (uri) => uri.replaceAll('=', '%3D'))],
    ['long, without padding', embedded(9999, (uri) => uri.replace(/=+$/, ''))],
  ])('with %s data in base64 is read as without', async (_, file) => {
    const { parts } = await load(file);
    const { array } = parts[0]!.geometry.getAttribute('position');
    expect(array).toEqual(new Float32Array([0, 0, 0, 1, 0, 0, 0, 1, 0]));
  });

  it('in base64 is no text: a buffer of 3 million bytes in JSON never becomes a string', async () => {
    const file = embedded(3e6);
    const parse = vi.spyOn(JSON, 'parse');
    const decode = vi.spyOn(TextDecoder.prototype, 'decode');
    expect(await outcome(file)).toBe('1 parts');
    for (const [text] of parse.mock.calls) {
      expect(text.length).toBeLessThan(5000);
    }
    for (const [bytes] of decode.mock.calls) {
      expect(bytes!.byteLength).toBeLessThan(5000);
    }
    vi.restoreAllMocks();
  });

  it('that is broken is named: base64, strings without an end, JSON', async () => {
    const broken = embedded(9000, (uri) => uri.replace('AAAA', 'A*AA'));
    expect(await outcome(broken)).toMatch(/^bad-model: .*broken base64/);
    for (const text of ['{"asset": "', '{"asset": "\\"', '{"buffers": [{]}']) {
      expect(await outcome(Buffer.from(text))).toMatch(/^bad-model: .*JSON is broken/);
    }
  });

  const utf16 = Buffer.alloc(135e6, 0x20);
  utf16.set([0xff, 0xfe]);
  it.each([
    ['one long string of a glTF', `{"asset":{"version":"2.0","copyright":"${'x'.repeat(17e6)}"}}`],
    ['an OBJ of 130 MB', `v 0 0 0\n#${' '.repeat(135e6)}\nf 1 1 1\n`],
    ['130 MB in UTF-16', utf16],
  ])(
    'is too-large before it is read: %s',
    async (_, text) => {
      expect(await outcome(new Blob([text]))).toMatch(
        /^too-large: The model has [\d,]+ bytes of (text|JSON)/,
      );
    },
    20_000,
  );
});

describe('documents that are wrong', () => {
  const strided = (byteStride: number | undefined, byteOffset: number) =>
    glbOf(
      hostile.triangleDocument({
        bufferViews: [{ buffer: 0, byteLength: 64, byteStride }],
        buffers: [{ byteLength: 64 }],
        accessors: [{ ...SOUND, byteOffset }],
      }),
      Buffer.alloc(64),
    );
  const multiples = /^bad-model: .*byteOffset and byteStride must be multiples of 4/;
  const typed = (type: string) => hostile.triangleGlb({ accessors: [{ ...SOUND, type }] });
  const unknownType = /accessors\[0\] has an unknown type/;
  const tooDeep = /nodes are nested deeper than 1000 levels|too-large/;
  const odd = JSON.stringify(hostile.triangleDocument()).replace(
    '{',
    '{"__proto__":{"scenes":[]},"constructor":0,',
  );

  const names = Object.fromEntries(Array.from({ length: 5000 }, (_, i) => [`name ${i}`, 0]));
  const primitive = { attributes: { POSITION: 0 } };
  const withPrimitive = (more: Json) =>
    hostile.triangleGlb({ meshes: [{ primitives: [{ ...primitive, ...more }] }] });
  const manyTargets = Array<Json>(5000).fill({ POSITION: 0 });
  const deep = JSON.stringify(hostile.triangleDocument({ extras: 0 })).replace(
    '"extras":0',
    `"extras":${'['.repeat(1e6)}${']'.repeat(1e6)}`,
  );

  it.each([
    ['an accessor of the type constructor', typed('constructor'), unknownType],
    ['an accessor of the type __proto__', typed('__proto__'), unknownType],
    ['a stride of 3', strided(3, 0), multiples],
    ['a stride of 13', strided(13, 0), multiples],
    ['an offset of 2', strided(undefined, 2), multiples],
    ['a hundred thousand levels of nodes', hostile.deepGlb(100_000), tooDeep],
    ['a thousand levels of nodes', hostile.deepGlb(1000), /^1 parts$/],
    ['JSON that ends a million levels deep', glbOf('['.repeat(1e6)), /JSON is broken/],
    ['notes a million levels deep', glbOf(deep, TRIANGLE), /^1 parts$|JSON is broken/],
    [
      'JSON of millions of values',
      glbOf(`[${'{},'.repeat(2e6)}0]`),
      /^too-large: .*values in its JSON/,
    ],
    [
      'thousands of attributes',
      withPrimitive({ attributes: { POSITION: 0, ...names } }),
      /^too-large: .* names in/,
    ],
    ['thousands of extensions', withPrimitive({ extensions: names }), /^too-large: .* names in/],
    ['thousands of targets', withPrimitive({ targets: manyTargets }), /^too-large: .* in targets/],
    [
      'ten times the allowed joints',
      hostile.triangleGlb({ skins: [{ joints: Array<number>(7e5).fill(0) }] }),
      /^too-large: .* in skins\[0\]\.joints/,
    ],
    ['keys such as __proto__', glbOf(odd, TRIANGLE), /^1 parts$/],
  ])('with %s are named, or shown where it does no harm', async (_, file, message) => {
    expect(await outcome(file)).toMatch(message);
  });
});

const repeated = hostile.triangleGlb({
  accessors: [{ componentType: FLOAT, count: 3000, type: 'VEC3' }],
  nodes: Array<Json>(6000).fill({ mesh: 0 }),
  scenes: [{ nodes: Array.from({ length: 6000 }, (_, i) => i) }],
});

// Where each user of a list reads it again, these take minutes.
it.each([
  ['6000 nodes with a thousand triangles each', repeated, /^too-large: .*triangle corners/],
  ['a hundred channels over a million keyframes', hostile.channelsGlb(100, 1e6), /^1 parts$/],
  [
    'nodes without instances of a mesh of many parts',
    hostile.instancingGlb(0, 4500, 15_000, ['SCALE']),
    /^bad-model: .*has no triangles/,
  ],
  ['ten thousand nodes of a skin of many joints', hostile.jointsGlb(60_000, 9000), /^9000 parts$/],
  ['three million corners at one vertex', hostile.fanGlb(3e6), /^1 parts$/],
  ['200,000 buffer views', hostile.longListGlb('bufferViews', 200_000), /^1 parts$/],
  [
    '200,000 nodes',
    hostile.longListGlb('nodes', 200_000),
    /^too-large: .*200,001 nodes; at most 30,000/,
  ],
])(
  'work of %s ends within seconds',
  async (_, file, message) => {
    expect(await outcome(file)).toMatch(message);
  },
  10_000,
);

it('a list of a text file that is full grows up to a length that moves in one task, then is too-large', () => {
  const list = new Growing(Uint8Array, 2 ** 24);
  list.fillTo(2 ** 24, 0);
  list.push(1);
  expect(list.array.length).toBe(2 ** 25);
  list.length = 2 ** 25;
  expect(() => {
    list.push(1);
  }).toThrow(expect.objectContaining({ code: 'too-large' }));
});
