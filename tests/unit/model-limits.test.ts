// Are files that claim too much, or claim nonsense, refused? The files are small, and no more than the limit of what
// they claim may be allocated.
import { readFileSync } from 'node:fs';
import { deflateSync } from 'node:zlib';
import { afterEach, describe, expect, it, vi } from 'vitest';
import { Growing } from '../../src/model/triangles/corner-lists.js';
import { CORNER_LIMIT, MEMORY_LIMIT, PART_LIMIT, PIXEL_LIMIT, VALUE_LIMIT } from '../../src/model/limits.js';
import { ModelBudget } from '../../src/model/model-budget.js';
import { Slices } from '../../src/model/slices.js';
import { readDocument } from '../../src/model/gltf/document.js';
import { modelContent } from '../../src/model/model-content.js';
import { type Content, ModelError } from '../../src/model/model.js';
import { bitmapOf } from './model-files.js';
import { bar } from '../support/animated-gltf.js';
import { floats, glbOf, pngWith, viewsOf, type Json } from '../fuzz/glb.js';
import {
  channelsGlb,
  deepGlb,
  dracoGlb,
  fanGlb,
  instancesGlb,
  instancingGlb,
  jointsGlb,
  longListGlb,
  texturedGlb,
  triangleDocument,
  triangleGlb,
  zerosGlb,
} from '../fuzz/models.js';

const load = (file: Buffer): Promise<Content> =>
  modelContent(new URL(`data:model/gltf-binary;base64,${file.toString('base64')}`), {
    signal: new AbortController().signal,
    crossOrigin: null,
  });

const NATIVE = Float32Array;

/** The error's code and message, or what was loaded. Fails where more floats are allocated than a model may have. */
async function outcome(file: Buffer): Promise<string> {
  let allocated = 0;
  const construct = (target: Float32ArrayConstructor, args: [number]): Float32Array => {
    if (typeof args[0] === 'number') expect((allocated += args[0])).toBeLessThanOrEqual(VALUE_LIMIT);
    return Reflect.construct(target, args) as Float32Array;
  };
  vi.stubGlobal('Float32Array', new Proxy(NATIVE, { construct }));
  const result: unknown = await load(file).catch((error: unknown) => error);
  if (result instanceof ModelError) return `${result.code}: ${result.message}`;
  const { parts } = result as Content;
  return `${String(parts.length)} parts`;
}

/** The same of a file. */
const outcomeOf = (file: Blob): Promise<string> =>
  modelContent(new URL('file:///a'), { signal: new AbortController().signal, crossOrigin: null }, file).then(
    ({ parts }) => `${String(parts.length)} parts`,
    (error: unknown) => `${(error as ModelError).code}: ${(error as ModelError).message}`,
  );

const UBYTE = 5121;

afterEach(() => {
  vi.unstubAllGlobals();
});

describe('the limits', () => {
  it('allow five million triangles, two thousand parts and 64 megapixels', () => {
    new ModelBudget().add({ corners: 15e6, values: 15e6 * 6 });
    new ModelBudget().add({ parts: 2000, nodes: 2000, values: 1e6, json: 5e5 });
    new ModelBudget().add({ pixels: 64e6, values: 1e6, parts: 100 });
  });

  it.each([
    ['draws', { parts: PART_LIMIT + 1 }],
    ['triangle corners', { corners: CORNER_LIMIT + 1 }],
    ['numbers in its vertices', { values: VALUE_LIMIT + 1 }],
    ['pixels in its images', { pixels: PIXEL_LIMIT + 1 }],
    ['bytes in memory', { values: VALUE_LIMIT, pixels: PIXEL_LIMIT }],
    ['bytes in memory', { pixels: PIXEL_LIMIT, values: MEMORY_LIMIT / 10 }],
  ] as const)('of %s give a too-large error with the figures beyond that', (what, claims) => {
    expect(() => new ModelBudget().add(claims)).toThrow(
      expect.objectContaining({ code: 'too-large', message: expect.stringMatching(what) as string }),
    );
  });
});

describe('accessors count as what they become', () => {
  it.each([
    ['a strip of 40 million indices', zerosGlb(40e6, { indices: 1, mode: 5 })],
    ['a fan of 6 million vertices', zerosGlb(6e6, { mode: 6 })],
    ['bytes that become floats', zerosGlb(40e6, {}, { componentType: UBYTE })],
    ['vertices that no triangle uses', zerosGlb(1e9, { indices: 0 })],
    ['corners that get a normal each', zerosGlb(16e6, { indices: 1 })],
    ['elements larger than those used', zerosGlb(7e6, {}, { type: 'MAT4' })],
  ])('%s are too-large', async (_, file) => {
    expect(await outcome(file)).toMatch(/^too-large: The model has [\d,]+ \w+.* at most/);
  });

  it('and one buffer view read by many accessors counts for each', async () => {
    const accessors = Array.from({ length: 200 }, () => ({
      componentType: 5126,
      count: 300_000,
      type: 'VEC3',
    }));
    const meshes = accessors.map((_, i) => ({ primitives: [{ attributes: { POSITION: i } }] }));
    const nodes = meshes.map((_, mesh) => ({ mesh }));
    const scenes = [{ nodes: nodes.map((_, i) => i) }];
    expect(await outcome(triangleGlb({ accessors, meshes, nodes, scenes }))).toMatch(/^too-large/);
  });

  it('and one accessor counts for each attribute made from it', async () => {
    const attributes = { POSITION: 0, NORMAL: 0, COLOR_0: 0, TEXCOORD_0: 0 };
    expect(await outcome(zerosGlb(10e6, { attributes }))).toMatch(/^too-large/);
  });

  it('and primitives that use few of many shared vertices get copies of those', async () => {
    const count = 3000;
    const accessors = [
      { componentType: 5126, count: 1e6, type: 'VEC3' },
      { bufferView: 1, componentType: 5121, count: 3, type: 'SCALAR' },
    ];
    const { bufferViews, buffers, body } = viewsOf([floats(0), Buffer.from([0, 1, 2])]);
    const primitive = { attributes: { POSITION: 0, NORMAL: 0 }, indices: 1 };
    const primitives = Array.from({ length: count }, () => primitive);
    const model = await load(
      glbOf({ ...triangleDocument({ accessors, meshes: [{ primitives }] }), bufferViews, buffers }, body),
    );
    expect(model.parts).toHaveLength(count);
    expect(new Set(model.parts.map(({ geometry }) => geometry)).size).toBe(1);
    expect(model.parts[0]?.geometry.getAttribute('position').count).toBe(3);
  });
});

describe('every accessor that is read is counted', () => {
  const claim = 3e8;

  it.each(['POSITION', 'NORMAL'])(
    'a morph target with another number of elements of %s than its mesh has vertices is named',
    async (name) => {
      for (const count of [2, claim]) {
        const accessors = [
          { bufferView: 0, componentType: 5126, count: 3, type: 'VEC3' },
          { componentType: 5120, count, type: 'VEC3' },
        ];
        const primitives = [{ attributes: { POSITION: 0 }, targets: [{ [name]: 1 }] }];
        const file = triangleGlb({ accessors, meshes: [{ primitives, weights: [1] }] });
        expect(await outcome(file)).toMatch(
          new RegExp(
            `^bad-model: .*targets\\[0\\].${name} has ${String(count)} elements, but its mesh has 3 vertices`,
          ),
        );
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
        const result = await outcome(Buffer.from(JSON.stringify({ ...whole, accessors: claims })));
        // Animations whose times do not fit their values are left out, unread.
        const leftOut = i === accessors.findIndex(({ type }, k) => type === 'SCALAR' && k > 8);
        expect(result).toMatch(
          leftOut ? /^1 parts$/ : /^(too-large: .* at most|bad-model: .*elements, but its mesh)/,
        );
      }
    },
  );

  it('and one that is not read gives no numbers', async () => {
    const json = {
      ...whole,
      nodes: [...(whole['nodes'] as Json[]), { mesh: 1 }],
      meshes: [...(whole['meshes'] as Json[]), { primitives: [{ attributes: { POSITION: accessors.length } }] }], // prettier-ignore
      accessors: [...accessors, { componentType: 5126, count: claim, type: 'VEC3' }],
    };
    const slices = new Slices(new AbortController().signal);
    const { json: reduced } = await readDocument(json, new ModelBudget(), slices);
    const counts = (reduced['accessors'] as readonly Json[]).map(({ count }) => count);
    expect(counts.at(-1)).toBe(0);
    expect(counts.slice(0, -1)).toEqual(accessors.map(({ count }) => count));
    expect((reduced['nodes'] as readonly Json[]).at(-1)).not.toHaveProperty('mesh');
  });

  it('and Draco data count once for each mesh that is made of them', async () => {
    const extension = (bufferView: number): Json => ({
      KHR_draco_mesh_compression: { bufferView, attributes: { POSITION: 0 } },
    });
    const views = Array.from({ length: 200 }, () => ({ buffer: 0, byteOffset: 0, byteLength: 36 }));
    const primitives = views.map((_, i) => ({ attributes: { POSITION: 0, NORMAL: 0 }, indices: 1, extensions: extension(i) })); // prettier-ignore
    const file = triangleGlb({
      meshes: [{ primitives }],
      bufferViews: views,
      accessors: [
        { componentType: 5126, count: 500_000, type: 'VEC3' },
        { componentType: 5125, count: 3, type: 'SCALAR' },
      ],
    });
    expect(await outcome(file)).toMatch(/^too-large: .*numbers in its vertices/);
  });

  it('and the values of each animated property', async () => {
    const targets = 20_000;
    const times = accessors.length;
    const channels = Array.from({ length: 10_000 }, () => ({ sampler: 0, target: { node: 0, path: 'weights' } })); // prettier-ignore
    const file = Buffer.from(
      JSON.stringify({
        ...bar({ skinned: false, morphed: false }),
        meshes: [{ primitives: [{ attributes: { POSITION: 0 }, targets: Array(targets).fill({}) }] }],
        accessors: [
          ...accessors,
          { componentType: 5126, count: 1, type: 'SCALAR' },
          { componentType: 5126, count: targets, type: 'SCALAR' },
        ],
        animations: [{ samplers: [{ input: times, output: times + 1 }], channels }],
      }),
    );
    expect(await outcome(file)).toMatch(/^too-large: .*numbers in its vertices/);
  });
});

/** Puts a value in place of one. */
const SPARSE = {
  count: 1,
  indices: { bufferView: 0, componentType: 5123 },
  values: { bufferView: 0 },
};

describe('parts', () => {
  it('of 200,000 nodes are too-large', async () => {
    expect(await outcome(instancesGlb(200_000, true))).toMatch(
      /^too-large: The model has .* (draws|nodes|values in one part of its JSON)/,
    );
  });

  it('of two thousand nodes load, and equal ones share one geometry', async () => {
    for (const shared of [true, false]) {
      const { parts } = await load(instancesGlb(2000, shared));
      expect(parts).toHaveLength(2000);
      expect(new Set(parts.map(({ geometry }) => geometry)).size).toBe(1);
    }
  });

  it('are counted with their triangles each time a mesh is repeated', async () => {
    const nodes = Array.from({ length: 6000 }, () => ({ mesh: 0 }));
    const accessors = [{ componentType: 5126, count: 3000, type: 'VEC3' }];
    const scenes = [{ nodes: nodes.map((_, i) => i) }];
    expect(await outcome(triangleGlb({ accessors, nodes, scenes }))).toMatch(
      /^too-large: .*triangle corners/,
    );
  });
});

describe('images', () => {
  const dataOf = (size: number): Buffer => deflateSync(Buffer.alloc(size));

  it.each([
    ['one of 16384²', [pngWith(16384, 16384, 32, dataOf(10))]],
    ['many whose sum is too much', Array.from({ length: 65 }, () => pngWith(1024, 1024, 32, dataOf(10)))],
  ])('are too-large by their headers: %s', async (_, images) => {
    const decode = vi.fn((blob: Blob) => bitmapOf(blob));
    vi.stubGlobal('createImageBitmap', decode);
    const file = texturedGlb(
      images,
      images.map((_, source) => ({ source })),
    );
    expect(await outcome(file)).toMatch(/^too-large: .*pixels in its images/);
    expect(decode.mock.calls.length).toBeLessThan(65);
  });

  it('used by two thousand textures are decoded once and are one texture', async () => {
    const decode = vi.fn((blob: Blob) => bitmapOf(blob));
    vi.stubGlobal('createImageBitmap', decode);
    const textures = Array.from({ length: 2000 }, () => ({ source: 0 }));
    const { parts } = await load(texturedGlb([pngWith(4096, 4096, 32, dataOf(10))], textures));
    expect(decode).toHaveBeenCalledTimes(1);
    expect(new Set(parts.map(({ look }) => look.map)).size).toBe(1);
  });

  it('count again for another sampler, because they are uploaded again', async () => {
    vi.stubGlobal('createImageBitmap', (blob: Blob) => bitmapOf(blob));
    const { bufferViews, buffers, body } = viewsOf([
      floats(0, 0, 0, 1, 0, 0, 0, 1, 0),
      floats(0, 0, 1, 0, 0, 1),
      pngWith(4096, 4096, 32, dataOf(10)),
    ]);
    const samplers = [10497, 33071, 33648, 10497, 33071].map((wrapS, i) => ({
      wrapS,
      wrapT: i > 2 ? 33648 : 10497,
    }));
    const materials = samplers.map((_, index) => ({ pbrMetallicRoughness: { baseColorTexture: { index } } }));
    const primitives = samplers.map((_, material) => ({
      attributes: { POSITION: 0, TEXCOORD_0: 1 },
      material,
    }));
    const document: Json = {
      ...triangleDocument({ samplers, materials, meshes: [{ primitives }] }),
      textures: samplers.map((_, sampler) => ({ source: 0, sampler })),
      images: [{ bufferView: 2, mimeType: 'image/png' }],
      accessors: [
        { bufferView: 0, componentType: 5126, count: 3, type: 'VEC3' },
        { bufferView: 1, componentType: 5126, count: 3, type: 'VEC2' },
      ],
      bufferViews,
      buffers,
    };
    expect(await outcome(glbOf(document, body))).toMatch(/^too-large: .*pixels in its images/);
  });

  it('larger than 8192 pixels on a side, or half of all pixels, are decoded smaller', async () => {
    const decode = vi.fn((blob: Blob, _options: ImageBitmapOptions) => bitmapOf(blob));
    vi.stubGlobal('createImageBitmap', decode);
    await load(texturedGlb([pngWith(16384, 1000, 32, dataOf(10))], [{ source: 0 }]));
    await load(texturedGlb([pngWith(8192, 8192, 32, dataOf(10))], [{ source: 0 }]));
    await load(texturedGlb([pngWith(8192, 4096, 32, dataOf(10))], [{ source: 0 }]));
    const sizes = decode.mock.calls.map(([, { resizeWidth, resizeHeight }]) => [resizeWidth, resizeHeight]);
    expect(sizes).toEqual([
      [8192, 500],
      [5792, 5792],
      [undefined, undefined],
    ]);
  });

  it('of KTX2 have fewer pixels, because their transcoder takes memory too', async () => {
    const file = readFileSync(new URL('../fixtures/models/ktx2.glb', import.meta.url));
    const image = Buffer.from(file.subarray(file.indexOf('\xabKTX 20', 0, 'latin1')));
    image.writeUInt32LE(8192, 20);
    image.writeUInt32LE(8192, 24);
    expect(await outcome(texturedGlb([image], [{ source: 0 }]))).toMatch(
      /^too-large: .*pixels in one KTX2 image/,
    );
  });
});

describe('Draco data', () => {
  it('that claim more than their accessors are refused before decoding', async () => {
    for (const [faces, points] of [
      [9, 3],
      [1, 7],
    ] as const) {
      const file = dracoGlb(faces, points, { faces: 1, points: 3 });
      expect(await outcome(file)).toMatch(/^bad-model: .*its Draco data claims \d triangles/);
    }
    expect(await outcome(dracoGlb(50e6, 3, { faces: 1, points: 3 }))).toMatch(/^too-large/);
  });

  it('that agree with accessors beyond the limits are too-large', async () => {
    expect(await outcome(dracoGlb(50e6, 25e6, { faces: 50e6, points: 25e6 }))).toMatch(/^too-large/);
    expect(await outcome(dracoGlb(1.2e6, 6e5, { faces: 1.2e6, points: 6e5 }))).toMatch(/in one Draco mesh/);
    expect(await outcome(dracoGlb(1.2e6, 6e5, { faces: 8e5, points: 4e5 }))).toMatch(/in one Draco mesh/);
  });

  it('that end after their header are broken', async () => {
    expect(await outcome(dracoGlb(1e6, 5e5, { faces: 1e6, points: 5e5 }))).toMatch(
      /^bad-model: .*Draco data/,
    );
  });
});

describe('text', () => {
  const embedded = (bytes: Buffer, change: (uri: string) => string = (uri) => uri): Buffer =>
    Buffer.from(
      JSON.stringify({
        ...triangleDocument(),
        buffers: [{ byteLength: bytes.length, uri: 'BUFFER' }],
      }).replace('BUFFER', change(`data:application/octet-stream;base64,${bytes.toString('base64')}`)),
    );
  const triangle = (size: number): Buffer =>
    Buffer.concat([floats(0, 0, 0, 1, 0, 0, 0, 1, 0), Buffer.alloc(size)]);

  it.each([
    ['short', embedded(triangle(0))],
    ['long', embedded(triangle(1e6))],
    ['long, with escaped slashes', embedded(triangle(1e4), (uri) => uri.replaceAll('/', '\\/'))],
    ['long, with escaped padding', embedded(triangle(9999), (uri) => uri.replaceAll('=', '%3D'))],
    ['long, without padding', embedded(triangle(9999), (uri) => uri.replace(/=+$/, ''))],
  ])('with %s data in base64 is read as without', async (_, file) => {
    const { parts } = await load(file);
    expect(parts[0]!.geometry.getAttribute('position').array).toEqual(
      new Float32Array([0, 0, 0, 1, 0, 0, 0, 1, 0]),
    );
  });

  it('in base64 is no text: a buffer of 30 million bytes in JSON never becomes a string', async () => {
    const file = embedded(triangle(30e6));
    const parse = vi.spyOn(JSON, 'parse');
    const decode = vi.spyOn(TextDecoder.prototype, 'decode');
    expect(await outcome(file)).toBe('1 parts');
    for (const [text] of parse.mock.calls) expect(text.length).toBeLessThan(5000);
    for (const [bytes] of decode.mock.calls) expect(bytes!.byteLength).toBeLessThan(5000);
    vi.restoreAllMocks();
  }, 20_000);

  it('that is broken is named: base64, strings without an end, JSON', async () => {
    const broken = embedded(triangle(9000), (uri) => uri.replace('AAAA', 'A*AA'));
    expect(await outcome(broken)).toMatch(/^bad-model: .*broken base64/);
    for (const text of ['{"asset": "', '{"asset": "\\"', '{"buffers": [{]}'])
      expect(await outcome(Buffer.from(text))).toMatch(/^bad-model: .*JSON is broken/);
  });

  it.each([
    ['one long string of a glTF', `{"asset":{"version":"2.0","copyright":"${'x'.repeat(34e6)}"}}`],
    ['an OBJ of 130 MB', `v 0 0 0\n#${' '.repeat(135e6)}\nf 1 1 1\n`],
    ['an STL of 130 MB', `solid a\nfacet normal 0 0 1\n${' '.repeat(135e6)}`],
  ])(
    'is too-large before it is read: %s',
    async (_, text) => {
      expect(await outcomeOf(new Blob([text]))).toMatch(
        /^too-large: The model has [\d,]+ bytes of (text|JSON)/,
      );
    },
    20_000,
  );

  it('in UTF-16 is too-large before it is converted', async () => {
    const bytes = Buffer.alloc(135e6, 0x20);
    bytes.set([0xff, 0xfe]);
    expect(await outcomeOf(new Blob([bytes]))).toMatch(/^too-large: .* bytes of text/);
  }, 20_000);
});

describe('documents that are wrong', () => {
  it.each(['constructor', '__proto__', 'toString'])('report an accessor of the type %s', async (type) => {
    const accessor = { bufferView: 0, componentType: 5126, count: 3, type };
    expect(await outcome(triangleGlb({ accessors: [accessor] }))).toMatch(
      /accessors\[0\] has an unknown type/,
    );
  });

  it.each([
    [3, 0],
    [13, 0],
    [undefined, 2],
  ])('report a stride of %s or an offset of %s, and what it must be', async (byteStride, byteOffset) => {
    const body = Buffer.alloc(64);
    const file = glbOf(
      triangleDocument({
        bufferViews: [{ buffer: 0, byteLength: 64, byteStride }],
        buffers: [{ byteLength: 64 }],
        accessors: [{ bufferView: 0, byteOffset, componentType: 5126, count: 3, type: 'VEC3' }],
      }),
      body,
    );
    expect(await outcome(file)).toMatch(/bad-model: .*byteOffset and byteStride must be multiples of 4/);
  });

  it('report nodes nested too deeply; a thousand levels load', async () => {
    expect(await outcome(deepGlb(100_000))).toMatch(/nodes are nested deeper than 1000 levels|too-large/);
    expect(await outcome(deepGlb(1000))).toBe('1 parts');
  });

  it('report JSON that is too deep or has millions of values', async () => {
    expect(await outcome(glbOf('['.repeat(1e6)))).toMatch(/^too-large/);
    expect(await outcome(glbOf(`[${'{},'.repeat(2e6)}0]`))).toMatch(/^too-large: .*values in its JSON/);
  });

  it('with keys such as __proto__ change nothing', async () => {
    const document = JSON.stringify(triangleDocument()).replace(
      /^\{/,
      '{"__proto__":{"scenes":[]},"constructor":0,',
    );
    expect(await outcome(glbOf(document, floats(0, 0, 0, 1, 0, 0, 0, 1, 0)))).toBe('1 parts');
  });
});

describe('work', () => {
  // Where each user of a list reads it again, these take minutes.
  it.each([
    ['a hundred channels over a million keyframes', channelsGlb(100, 1e6)],
    ['nodes without instances of a mesh of many parts', instancingGlb(0, 9000, 30_000, ['SCALE'])],
    ['ten thousand nodes of a skin of many joints', jointsGlb(60_000, 9000)],
    ['three million corners at one vertex', fanGlb(3e6)],
    ['200,000 buffer views', longListGlb('bufferViews', 200_000)],
    ['200,000 nodes', longListGlb('nodes', 200_000)],
  ])(
    'of %s ends within seconds',
    async (_, file) => {
      expect(await outcome(file)).toMatch(/parts$|^too-large|^bad-model/);
    },
    10_000,
  );
});

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
