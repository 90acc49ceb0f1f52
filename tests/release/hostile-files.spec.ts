// Does any small file, or a small page of large files, take a gigabyte? Measured in the browser's own processes.
import { readFileSync } from 'node:fs';
import { gzipSync } from 'node:zlib';
import type { PhongViewer } from '../element/support/viewer.js';
import { GROWTH_LIMIT_MB, load, MemoryWatch } from '../fuzz/model-run.js';
import { texturedGlb, triangleGlb } from '../fuzz/models.js';
import { expect, test } from '../support/test.js';

const SIZE = { width: 300, height: 200 };
const MB = 2 ** 20;

/** A GIF whose screen is one pixel, and whose only frame is 16,000 × 16,000. */
function gif(): Buffer {
  const head = Buffer.from('GIF89a\x01\0\x01\0\x80\0\0\0\0\0\xff\xff\xff,\0\0\0\0', 'latin1');
  const sides = Buffer.alloc(4);
  sides.writeUInt16LE(16_000);
  sides.writeUInt16LE(16_000, 2);
  return Buffer.concat([head, sides, Buffer.from([0, 2, 2, 0x4c, 1, 0, 0x3b])]);
}

const base64Gltf = (size: number): Buffer => {
  const json = '{"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}],"bufferViews":[{"buffer":0,"byteLength":36}],"buffers":[{"byteLength":36,"uri":"data:application/octet-stream;base64,'; // prettier-ignore
  return Buffer.concat([Buffer.from(json), Buffer.alloc(size - 1000, 'A'), Buffer.from('"}]}')]);
};

const utf16 = (size: number): Buffer => {
  const text = Buffer.alloc(size, '界', 'utf16le');
  text.set([0xff, 0xfe, 0x23, 0]); // a comment
  return text;
};

for (const [what, make, expected] of [
  ['240 MB of UTF-16', () => gzipSync(utf16(240 * MB), { level: 9 }), 'too-large'],
  ['120 MB of UTF-16', () => gzipSync(utf16(120 * MB), { level: 9 }), 'bad-model'],
  ['240 MB of base64 in JSON', () => gzipSync(base64Gltf(240 * MB), { level: 9 }), 'load'],
  ['240 MB in one string of JSON', () => gzipSync(Buffer.concat([Buffer.from('{"a":"'), Buffer.alloc(240 * MB, 'x'), Buffer.from('"}')]), { level: 9 }), 'too-large'], // prettier-ignore
  ['an image of GIF whose frame is larger than its screen', () => gzipSync(texturedGlb([gif()], [{ source: 0 }])), 'load'], // prettier-ignore
] as const) {
  test(`@release ${what} takes less than a gigabyte`, async ({ browser, site, mount, consoleGuard }) => {
    test.setTimeout(300_000);
    if (what === '120 MB of UTF-16') consoleGuard.allow(/The format is not supported/);
    if (what.includes('image')) consoleGuard.allow(/is shown without 1 of the files/);
    const viewer = await mount(`<phong-viewer src="${site.file(triangleGlb())}"></phong-viewer>`, SIZE);
    const memory = await MemoryWatch.of(browser);
    const file = make();
    const address = site.file(file, true);
    memory.start();
    const start = performance.now();
    const outcome = await load(viewer, `${address}?hostile`);
    const time = performance.now() - start;
    const growth = memory.stop();
    console.log(`${what}: ${outcome}, ${file.length} bytes, ${growth.toFixed()} MB, ${time.toFixed()} ms`);
    expect(growth).toBeLessThan(GROWTH_LIMIT_MB);
    expect(outcome).toBe(expected);
  });
}

test('@release ninety meshes of one model with textures take the memory of one', async ({
  browser,
  site,
  mount,
  consoleGuard,
}) => {
  test.setTimeout(300_000);
  consoleGuard.allow(/is shown without KHR_materials/, 1);
  const model = readFileSync(new URL('../../demo/assets/models/real/magicleap-two.glb', import.meta.url));
  const viewer = await mount('<phong-viewer></phong-viewer>', SIZE);
  const memory = await MemoryWatch.of(browser);
  const address = site.file(model);
  memory.start();
  const shown = await viewer.evaluate(async (element: PhongViewer, src) => {
    for (let i = 0; i < 90; i++) element.append(Object.assign(document.createElement('phong-mesh'), { src }));
    await element.ready;
    return element.scene.children.length;
  }, address);
  const growth = memory.stop();
  console.log(`ninety meshes of one model: ${growth.toFixed()} MB`);
  expect(shown).toBe(90);
  expect(growth).toBeLessThan(GROWTH_LIMIT_MB);
});

test('@release eight captures at once take the float buffers of one', async ({ browser, mount }) => {
  test.setTimeout(300_000);
  const viewer = await mount('<phong-viewer geometry="box"></phong-viewer>', SIZE);
  const memory = await MemoryWatch.of(browser);
  memory.start();
  await viewer.evaluate(async (element: PhongViewer) => {
    const options = { width: 1000, height: 700, samples: 2 };
    await Promise.all(Array.from({ length: 8 }, () => element.toBlob(options)));
  });
  const growth = memory.stop();
  console.log(`eight captures: ${growth.toFixed()} MB`);
  expect(growth).toBeLessThan(200); // buffers of 36 MB, and eight pictures of 3 MB
});
