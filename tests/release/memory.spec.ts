// Do models of the promised size load, and does any file, or a page of many, take a gigabyte?
// Measured in the browser's own processes.
import { readFileSync } from 'node:fs';
import { gzipSync } from 'node:zlib';
import { Gltf } from '../bench/glb.mjs';
import { pngOf } from '../fuzz/glb.js';
import { GROWTH_LIMIT_MB, load, MemoryWatch } from '../fuzz/model-run.js';
import { instancesGlb, texturedGlb, triangleGlb } from '../fuzz/models.js';
import { expect, test } from '../support/test.js';

const SIZE = { width: 300, height: 200 };
const MB = 2 ** 20;

const base64Gltf = (size: number): Buffer => {
  const json =
    '{"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}],"bufferViews":[{"buffer":0,"byteLength":36}],"buffers":[{"byteLength":36,"uri":"data:application/octet-stream;base64,';
  return Buffer.concat([Buffer.from(json), Buffer.alloc(size - 1000, 'A'), Buffer.from('"}]}')]);
};

const utf16 = (size: number): Buffer => {
  const text = Buffer.alloc(size, '界', 'utf16le');
  text.set([0xff, 0xfe, 0x23, 0]); // a comment
  return text;
};

const textured = (count: number, width: number, height: number) => {
  const images = Array.from({ length: count }, () => pngOf(width, height, 32));
  return texturedGlb(
    images,
    images.map((_, source) => ({ source })),
  );
};

/** A square of 2 · side² triangles that share their vertices. */
function gridGlb(side: number, normals: boolean): Buffer {
  const row = side + 1;
  const positions = new Float32Array(row * row * 3);
  for (let i = 0; i < row * row; i++) {
    positions[i * 3] = i % row;
    positions[i * 3 + 1] = Math.floor(i / row);
  }
  const indices = new Uint32Array(side * side * 6);
  for (let i = 0; i < side * side; i++) {
    const a = (i % side) + Math.floor(i / side) * row;
    indices.set([a, a + 1, a + row, a + row, a + 1, a + row + 1], i * 6);
  }
  const up = positions.map((_, i) => (i % 3 === 2 ? 1 : 0));
  const gltf = new Gltf();
  const list = (values: Float32Array) =>
    gltf.accessor(values, { componentType: 5126, count: row * row, type: 'VEC3' });
  gltf.addPrimitive({ POSITION: list(positions), ...(normals && { NORMAL: list(up) }) }, indices);
  return Buffer.from(gltf.glb());
}

/**
 * What the files are; how they end, if not by `load`; whether they are sent with gzip.
 */
interface Case {
  readonly make: () => Buffer;
  readonly ends?: string;
  readonly isZipped?: boolean;
}

const CASES: Readonly<Record<string, Case>> = {
  'five million triangles in a file of 120 MB': { make: () => gridGlb(1582, true) },
  'five million triangles without normals': { make: () => gridGlb(1582, false) },
  'two thousand parts': { make: () => instancesGlb(2000, false) },
  'ten thousand nodes of one mesh': { make: () => instancesGlb(10_000, true) },
  'two images of 32 megapixels': { make: () => textured(2, 8192, 4096) },
  '64 images of a megapixel': { make: () => textured(64, 1024, 1024) },
  '120 MB of UTF-16': {
    make: () => utf16(120 * MB),
    isZipped: true,
    ends: 'too-large',
  },
  '240 MB of base64 in JSON': { make: () => base64Gltf(240 * MB), isZipped: true },
};

for (const [what, { make, ends = 'load', isZipped = false }] of Object.entries(CASES)) {
  test(`@release ${what} ends by ${ends} in less than a gigabyte`, async ({
    browser,
    site,
    mount,
  }) => {
    test.setTimeout(600_000);
    const viewer = await mount(
      `<phong-viewer src="${site.file(triangleGlb())}"></phong-viewer>`,
      SIZE,
    );
    const memory = await MemoryWatch.of(browser);
    const file = isZipped ? gzipSync(make(), { level: 9 }) : make();
    const address = site.file(file, isZipped);
    memory.start();
    expect(await load(viewer, `${address}?file`)).toBe(ends);
    await viewer.evaluate(
      async (element) => (await element.toBlob({ width: 30, height: 20 })).size,
    );
    const growth = memory.stop();
    console.log(`${what}: ${file.length} bytes, ${growth.toFixed()} MB`);
    expect(growth).toBeLessThan(GROWTH_LIMIT_MB);
  });
}

test('@release ninety meshes of one model take the memory of one', async ({
  browser,
  site,
  mount,
  consoleGuard,
}) => {
  test.setTimeout(300_000);
  consoleGuard.allow(/is shown without KHR_materials/, 1);
  const model = readFileSync(
    new URL('../../demo/assets/models/real/magicleap-two.glb', import.meta.url),
  );
  const viewer = await mount('<phong-viewer></phong-viewer>', SIZE);
  const memory = await MemoryWatch.of(browser);
  const address = site.file(model);
  memory.start();
  const shown = await viewer.evaluate(async (element, src) => {
    for (let i = 0; i < 90; i++) {
      element.append(Object.assign(document.createElement('phong-mesh'), { src }));
    }
    await element.ready;
    return element.scene.children.length;
  }, address);
  const growth = memory.stop();
  console.log(`ninety meshes of one model: ${growth.toFixed()} MB`);
  expect(shown).toBe(90);
  expect(growth).toBeLessThan(GROWTH_LIMIT_MB);
});

test('@release eight captures at once take the float buffers of one', async ({
  browser,
  mount,
}) => {
  test.setTimeout(300_000);
  const viewer = await mount('<phong-viewer geometry="box"></phong-viewer>', SIZE);
  const memory = await MemoryWatch.of(browser);
  memory.start();
  await viewer.evaluate(async (element) => {
    const options = { width: 1000, height: 700, samples: 2 };
    await Promise.all(Array.from({ length: 8 }, () => element.toBlob(options)));
  });
  const growth = memory.stop();
  console.log(`eight captures: ${growth.toFixed()} MB`);
  expect(growth).toBeLessThan(200); // buffers of 36 MB, and eight pictures of 3 MB
});
