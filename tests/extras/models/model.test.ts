// Does a model come out of real files as the shaders need it, and a readable error out of broken
// ones? Images are decoded by a stand-in, as Node has no createImageBitmap.
import { existsSync, readFileSync } from 'node:fs';
import {
  ClampToEdgeWrapping,
  NearestFilter,
  NoColorSpace,
  type BufferGeometry,
  type Texture,
} from 'three';
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { modelContent, type ReadOptions } from '../../../src/extras/models/model-content.js';
import { type Content, ModelError } from '../../../src/phong/model/model.js';
import { bitmapOf, OPTIONS } from './model-files.js';
import { srgbEncode } from '../../../src/phong/math/color.js';

const ORIGIN = 'https://shop.example';
const FOLDERS: Readonly<Record<string, string>> = {
  fixtures: '../../fixtures/models/',
  assets: '../../../demo/assets/models/',
};
const fileOf = (path: string) => {
  const [, folder = '', ...rest] = path.split('/');
  return new URL(`${FOLDERS[folder] ?? 'nowhere/'}${rest.join('/')}`, import.meta.url);
};

/** Answers as a server with these folders does. */
function answer({ href }: URL) {
  const path = decodeURIComponent(href.replace(ORIGIN, ''));
  requests.push(path);
  if (path === '/no-answer.glb') throw new TypeError('fetch failed');
  if (path === '/huge.glb') {
    return new Response('glTF', { headers: { 'content-length': String(2 ** 31) } });
  }
  if (!existsSync(fileOf(path))) {
    return new Response(null, { status: 404, statusText: 'Not Found' });
  }
  const bytes = readFileSync(fileOf(path));
  return new Response(bytes, { headers: { 'content-length': String(bytes.length) } });
}

let requests: string[] = [];
let bitmaps: { readonly options: ImageBitmapOptions | undefined; readonly close: () => void }[] =
  [];

beforeEach(() => {
  requests = [];
  bitmaps = [];
  vi.stubGlobal('fetch', (url: URL) => Promise.resolve(url).then(answer));
  vi.stubGlobal('createImageBitmap', async (blob: Blob, options?: ImageBitmapOptions) => {
    const [first] = new Uint8Array(await blob.arrayBuffer());
    if (first !== 0x89) throw new Error('no PNG');
    const bitmap = { ...(await bitmapOf(blob)), options, close: vi.fn() };
    bitmaps.push(bitmap);
    return bitmap;
  });
  for (const method of ['log', 'warn', 'error'] as const) {
    vi.spyOn(console, method).mockImplementation((...line: unknown[]) => {
      throw new Error(`unexpected console.${method}: ${line.map(String).join(' ')}`);
    });
  }
});

afterEach(() => {
  vi.unstubAllGlobals();
  vi.restoreAllMocks();
});

const load = (path: string, options: Partial<ReadOptions> = {}) =>
  modelContent(new URL(path, ORIGIN), { ...OPTIONS, ...options });

const values = (geometry: BufferGeometry, name: string) =>
  Array.from(geometry.getAttribute(name).array);

function onlyPart(model: Content) {
  expect(model.parts).toHaveLength(1);
  return model.parts[0]!;
}

it('a model compressed by meshopt is the same as without the compression', async () => {
  const [packed, plain] = [
    await load('/fixtures/meshopt.glb'),
    await load('/fixtures/no-normals.glb'),
  ];
  // The encoder may rotate a triangle's corners, but must not change it.
  const corners = (model: Content) => {
    const list = values(onlyPart(model).geometry, 'position');
    return list.flatMap((_, i) => (i % 3 === 0 ? [list.slice(i, i + 3).join(' ')] : [])).sort();
  };
  expect(corners(packed)).toEqual(corners(plain));
});

it('the bunny comes out of Draco whole: all its triangles, unit normals, with progress in bytes', async () => {
  const told: [number, number][] = [];
  const model = await load('/assets/bunny.glb', {
    onProgress: (...progress) => told.push(progress),
  });
  const { geometry } = onlyPart(model);
  expect(geometry.getAttribute('position').count).toBe(2826);
  expect(geometry.index?.count).toBe(5648 * 3);
  expect(geometry.index?.array).toBeInstanceOf(Uint16Array);
  const normal = geometry.getAttribute('normal');
  let worst = 0;
  for (let i = 0; i < normal.count; i += 1) {
    const length = Math.hypot(normal.getX(i), normal.getY(i), normal.getZ(i));
    worst = Math.max(worst, Math.abs(length - 1));
  }
  expect(worst).toBeLessThan(2e-7);
  expect(requests).toEqual(['/assets/bunny.glb']);
  expect(told.at(-1)).toEqual([18808, 18808]);
  expect(told.every(([loaded, total]) => loaded <= total)).toBe(true);
});

it.each([
  ['textured.glb', []],
  ['data-uris.gltf', []],
  ['beside/quad.gltf', ['beside/quad.bin', 'beside/textures/four colours.png']],
])(
  'textures of %s are decoded from bytes, unconverted, with the sampler of the file',
  async (file, others) => {
    const model = await load(`/fixtures/${file}`);
    // Nothing but what is in the model's folder and below.
    expect(requests.toSorted()).toEqual(
      [file, ...others].map((path) => `/fixtures/${path}`).toSorted(),
    );
    const { geometry, look, name } = onlyPart(model);
    expect(name).toBe('quad');
    expect(model.missing).toEqual([]);
    expect(values(geometry, 'uv')).toEqual([0, 1, 1, 1, 1, 0, 0, 0]);
    const map = look.map as Texture;
    expect(map).toMatchObject({
      colorSpace: NoColorSpace,
      flipY: false,
      channel: 0,
      magFilter: NearestFilter,
      minFilter: NearestFilter,
      wrapS: ClampToEdgeWrapping,
      wrapT: ClampToEdgeWrapping,
      generateMipmaps: false,
      premultiplyAlpha: false,
    });
    expect(map.version).toBeGreaterThan(0);
    expect(bitmaps).toHaveLength(1);
    expect(bitmaps[0]?.options).toEqual({ premultiplyAlpha: 'none', colorSpaceConversion: 'none' });
    model.dispose();
    await expect.poll(() => bitmaps[0]?.close).toHaveBeenCalledTimes(1);
  },
);

describe('looks', () => {
  it('encodes factors, and leaves vertex colours linear', async () => {
    const { geometry, look } = onlyPart(await load('/fixtures/vertex-colours.glb'));
    expect(look.baseColor[0]).toBeCloseTo(0.5, 6);
    expect(look.baseColor[1]).toBeCloseTo(1, 12);
    expect(look.baseColor[2]).toBeCloseTo(srgbEncode(0.5), 12);
    const colors = values(geometry, 'color');
    expect(colors.slice(0, 4)).toEqual([1, 0, 0, 1]);
    expect(look.vertexColors).toBe('linear');
    expect(colors[12]).toBeCloseTo(55 / 255, 6);
    expect(colors[15]).toBeCloseTo(128 / 255, 6);
  });

  it('keeps the cutoff of a masked material', async () => {
    const { look } = onlyPart(await load('/fixtures/mask.glb'));
    expect(look).toMatchObject({ alphaMode: 'mask', alphaCutoff: 0.6, opacity: 1 });
  });
});

it.each([
  ['/fixtures/truncated.glb', 'bad-model', /truncated/],
  ['/fixtures/wrong-magic.glb', 'bad-model', /JSON is broken/],
  ['/fixtures/claims-too-much.glb', 'bad-model', /4000000000 elements/],
  ['/fixtures/claims-zeros.glb', 'too-large', /numbers in its vertices/],
  ['/fixtures/node-loop.glb', 'bad-model', /contains itself/],
  ['/fixtures/points-only.glb', 'bad-model', /no triangles/],
  ['/fixtures/not-a-number.glb', 'bad-model', /coordinate NaN/],
  ['/fixtures/unknown-extension.glb', 'bad-model', /EXT_mesh_of_tomorrow/],
  [
    '/fixtures/meshopt-claims.glb',
    'bad-model',
    /bufferViews\[0\] does not unpack to the bytes that it claims/,
  ],
  ['/fixtures/meshopt-damaged.glb', 'bad-model', /Malformed buffer data/],
  ['/fixtures/other-origin.gltf', 'load-failed', /https:\/\/example\.com\/quad\.bin.*crossorigin/],
  ['/fixtures/folder-above.gltf', 'load-failed', /is not in the folder of folder-above\.gltf/],
  [
    '/fixtures/missing-buffer.gltf',
    'load-failed',
    /^The server answered 404 Not Found for nowhere\.bin\./,
  ],
  ['/fixtures/nothing.glb', 'load-failed', /404/],
  ['/huge.glb', 'too-large', /at most 268,435,456/],
  ['/no-answer.glb', 'load-failed', /no-answer\.glb/],
] as const)('failures of %s are %s', async (path, code, message) => {
  const error: unknown = await load(path).catch((reason: unknown) => reason);
  expect(error).toBeInstanceOf(ModelError);
  expect(error).toMatchObject({ code, message: expect.stringMatching(message) as string });
  expect(requests.some((request) => request.includes('example'))).toBe(false);
});
