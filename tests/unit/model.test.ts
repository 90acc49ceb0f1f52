// Does a model come out of real files as the shaders need it, and a readable error out of broken ones?
// Files are served over HTTP on this machine; images are decoded by a stand-in, as Node has no createImageBitmap.
import { createReadStream, existsSync, statSync } from 'node:fs';
import { createServer, type Server } from 'node:http';
import type { AddressInfo } from 'node:net';
import { fileURLToPath } from 'node:url';
import { ClampToEdgeWrapping, NearestFilter, NoColorSpace, type BufferGeometry, type Texture } from 'three';
import { afterAll, afterEach, beforeAll, beforeEach, describe, expect, it, vi } from 'vitest';
import { modelContent, type LoadOptions } from '../../src/model/model-content.js';
import { type Content, ModelError } from '../../src/model/model.js';
import { bitmapOf } from './model-files.js';
import { srgbEncode } from '../../src/math/color.js';

const roots: Readonly<Record<string, string>> = {
  '/fixtures/': fileURLToPath(new URL('../fixtures/models/', import.meta.url)),
  '/assets/': fileURLToPath(new URL('../../demo/assets/models/', import.meta.url)),
};

let server: Server;
let origin = '';
let requests: string[] = [];

beforeAll(async () => {
  server = createServer((request, response) => {
    const path = decodeURIComponent(request.url ?? '');
    requests.push(path);
    const [prefix = ''] = Object.keys(roots).filter((root) => path.startsWith(root));
    const file = (roots[prefix] ?? '/nowhere/') + path.slice(prefix.length);
    if (path === '/hangs.glb') {
      response.writeHead(200, { 'content-length': '1000' }).write('glTF');
    } else if (path === '/huge.glb') {
      response.writeHead(200, { 'content-length': String(2 ** 31) }).write('glTF');
    } else if (path === '/page.glb') {
      response.writeHead(200, { 'content-type': 'text/html' }).end('<!doctype html><title>Hello</title>');
    } else if (path === '/breaks.glb') {
      response.writeHead(200, { 'content-length': '1000' }).write('glTF', () => response.destroy());
    } else if (prefix === '' || !existsSync(file)) {
      response.writeHead(404).end();
    } else {
      response.writeHead(200, { 'content-length': statSync(file).size });
      createReadStream(file).pipe(response);
    }
  });
  await new Promise<void>((resolve) => server.listen(0, '127.0.0.1', resolve));
  origin = `http://127.0.0.1:${String((server.address() as AddressInfo).port)}`;
});

afterAll(() => {
  server.closeAllConnections();
  server.close();
});

interface Bitmap {
  readonly type: string;
  readonly size: number;
  readonly options: ImageBitmapOptions | undefined;
  readonly close: () => void;
}
let bitmaps: Bitmap[] = [];

beforeEach(() => {
  requests = [];
  bitmaps = [];
  vi.stubGlobal('createImageBitmap', async (blob: Blob, options?: ImageBitmapOptions) => {
    const head = new Uint8Array(await blob.arrayBuffer()).subarray(0, 4);
    if (head[0] !== 0x89) throw new Error('no PNG');
    const bitmap = { ...(await bitmapOf(blob)), type: blob.type, size: blob.size, options, close: vi.fn() };
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

const at = (path: string): URL => new URL(path, origin);
const load = (path: string, options: Partial<LoadOptions> = {}): Promise<Content> =>
  modelContent(at(path), { signal: new AbortController().signal, crossOrigin: null, ...options });

async function failure(path: string, options: Partial<LoadOptions> = {}): Promise<ModelError> {
  const error: unknown = await load(path, options).then(
    () => new Error('it loaded'),
    (reason: unknown) => reason,
  );
  if (error instanceof ModelError) return error;
  throw error;
}

const values = (geometry: BufferGeometry, name: string): number[] =>
  Array.from(geometry.getAttribute(name).array);

function onlyPart(model: Content): Content['parts'][number] {
  expect(model.parts).toHaveLength(1);
  const [part] = model.parts;
  if (!part) throw new Error('no part');
  return part;
}

describe('a model compressed by meshopt', () => {
  it('is the same as without the compression', async () => {
    const [packed, plain] = await Promise.all([
      load('/fixtures/meshopt.glb'),
      load('/fixtures/no-normals.glb'),
    ]);
    // The encoder may rotate a triangle's corners, but must not change it.
    const corners = (model: Content): string[] => {
      const list = values(onlyPart(model).geometry, 'position');
      const points = Array.from({ length: list.length / 3 }, (_, i) =>
        list.slice(3 * i, 3 * i + 3).join(' '),
      );
      return points.sort();
    };
    expect(corners(packed)).toEqual(corners(plain));
  });
});

describe('the bunny', () => {
  it('comes out of Draco whole: finite positions, unit normals, outward triangles', async () => {
    const model = await load('/assets/bunny.glb');
    const { geometry, look, matrix } = onlyPart(model);
    const position = geometry.getAttribute('position');
    expect(position.count).toBe(2826);
    expect(geometry.index?.count).toBe(5648 * 3);
    expect(geometry.index?.array).toBeInstanceOf(Uint16Array);
    expect(values(geometry, 'position').every(Number.isFinite)).toBe(true);
    const normal = geometry.getAttribute('normal');
    let agreeing = 0;
    let worst = 0;
    for (let i = 0; i < normal.count; i += 1) {
      const length = Math.hypot(normal.getX(i), normal.getY(i), normal.getZ(i));
      worst = Math.max(worst, Math.abs(length - 1));
      const center = [normal.getX(i) * position.getX(i), normal.getZ(i) * position.getZ(i)];
      if ((center[0] ?? 0) + (center[1] ?? 0) > 0) agreeing += 1;
    }
    expect(worst).toBeLessThan(2e-7);
    expect(agreeing / normal.count).toBeGreaterThan(0.6);
    expect(look).toMatchObject({ alphaMode: 'opaque', opacity: 1, map: null });
    expect(matrix.elements.every(Number.isFinite)).toBe(true);
    expect(requests).toEqual(['/assets/bunny.glb']);
    model.dispose();
  });

  it('reports progress in bytes', async () => {
    const told: [number, number][] = [];
    await load('/assets/bunny.glb', { onProgress: (...progress) => told.push(progress) });
    expect(told.at(-1)).toEqual([18808, 18808]);
    expect(told.every(([loaded, total]) => loaded <= total)).toBe(true);
  });
});

describe('textures', () => {
  const files = ['textured.glb', 'data-uris.gltf', 'beside/quad.gltf'];

  it.each(files)('of %s are decoded from bytes, unconverted, with the sampler of the file', async (file) => {
    const model = await load(`/fixtures/${file}`);
    const { geometry, look, name } = onlyPart(model);
    expect(name).toBe('quad');
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
  });

  it('beside the file are fetched from its folder and below, and nothing else is', async () => {
    await load('/fixtures/beside/quad.gltf');
    expect(requests.toSorted()).toEqual([
      '/fixtures/beside/quad.bin',
      '/fixtures/beside/quad.gltf',
      '/fixtures/beside/textures/four colours.png',
    ]);
  });
});

describe('looks', () => {
  it('has one normal a triangle where the file has none', async () => {
    const { geometry } = onlyPart(await load('/fixtures/no-normals.glb'));
    expect(geometry.index).toBeNull();
    expect(values(geometry, 'normal')).toEqual(Array.from({ length: 18 }, (_, i) => (i % 3 === 2 ? 1 : 0)));
  });

  it('encodes linear vertex colours and factors, and leaves alpha alone', async () => {
    const { geometry, look } = onlyPart(await load('/fixtures/vertex-colours.glb'));
    expect(look.baseColor[0]).toBeCloseTo(0.5, 6);
    expect(look.baseColor[1]).toBeCloseTo(1, 12);
    expect(look.baseColor[2]).toBeCloseTo(srgbEncode(0.5), 12);
    const colors = values(geometry, 'color');
    expect(colors.slice(0, 4)).toEqual([1, 0, 0, 1]);
    expect(colors[12]).toBeCloseTo(srgbEncode(55 / 255), 6);
    expect(colors[15]).toBeCloseTo(128 / 255, 6);
  });

  it('treats a blended material with alpha 1 everywhere as opaque', async () => {
    expect(onlyPart(await load('/assets/bunny.glb')).look.alphaMode).toBe('opaque');
  });

  it('keeps the cutoff of a masked material', async () => {
    const { look } = onlyPart(await load('/fixtures/mask.glb'));
    expect(look).toMatchObject({ alphaMode: 'mask', alphaCutoff: 0.6, opacity: 1 });
  });
});

describe('failures', () => {
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
    ['/fixtures/missing-buffer.gltf', 'load-failed', /^The server answered 404 Not Found for nowhere\.bin\./],
    ['/fixtures/nothing.glb', 'load-failed', /404/],
    ['/page.glb', 'bad-model', /web page/],
    ['/huge.glb', 'too-large', /at most 268,435,456/],
    ['/breaks.glb', 'load-failed', /connection broke/],
  ] as const)('of %s are %s', async (path, code, message) => {
    const error = await failure(path);
    expect(error.message).toMatch(message);
    expect(error.code).toBe(code);
    expect(requests.some((request) => request.includes('example'))).toBe(false);
  });

  it('to reach a server are load-failed', async () => {
    const error: unknown = await modelContent(new URL('http://127.0.0.1:9/x.glb'), {
      signal: new AbortController().signal,
      crossOrigin: null,
    }).catch((reason: unknown) => reason);
    expect(error).toMatchObject({ code: 'load-failed' });
  });

  it('by an abort in the middle of the file reject with its reason', async () => {
    const controller = new AbortController();
    const loading = load('/hangs.glb', {
      signal: controller.signal,
      onProgress: () => {
        controller.abort(new Error('enough'));
      },
    });
    await expect(loading).rejects.toThrow('enough');
  });

  it('are always a ModelError, whatever bytes are changed', async () => {
    const { readFileSync } = await import('node:fs');
    const fc = (await import('fast-check')).default;
    const whole = readFileSync(`${String(roots['/fixtures/'])}textured.glb`);
    await fc.assert(
      fc.asyncProperty(
        fc.array(fc.tuple(fc.nat(whole.length - 1), fc.nat(255)), { minLength: 1, maxLength: 6 }),
        async (changes) => {
          const bytes = Buffer.from(whole);
          for (const [index, value] of changes) bytes[index] = value;
          const url = new URL(`data:model/gltf-binary;base64,${bytes.toString('base64')}`);
          const result: unknown = await modelContent(url, {
            signal: new AbortController().signal,
            crossOrigin: null,
          }).catch((reason: unknown) => reason);
          if (result instanceof Error) expect(result).toBeInstanceOf(ModelError);
          else (result as Content).dispose();
        },
      ),
      { numRuns: 300 },
    );
  });
});
