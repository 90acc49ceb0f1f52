// Do models of the promised size load, within the memory that no file may exceed? Both are measured in the browser's
// own processes.
import type { PhongViewer } from '../element/support/viewer.js';
import { glbOf, pngOf, viewsOf } from '../fuzz/glb.js';
import { GROWTH_LIMIT_MB, load, MemoryWatch } from '../fuzz/model-run.js';
import { instancesGlb, texturedGlb, triangleDocument, triangleGlb } from '../fuzz/models.js';
import { expect, test } from '../support/test.js';

const textured = (count: number, width: number, height: number): Buffer => {
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
  const up = Float32Array.from(positions, (_, i) => (i % 3 === 2 ? 1 : 0));
  const { bufferViews, buffers, body } = viewsOf(
    [positions, up, indices].map(({ buffer }) => Buffer.from(buffer)),
  );
  const vectors = { componentType: 5126, count: row * row, type: 'VEC3' };
  const attributes = normals ? { POSITION: 0, NORMAL: 1 } : { POSITION: 0 };
  return glbOf(
    {
      ...triangleDocument(),
      meshes: [{ primitives: [{ attributes, indices: 2 }] }],
      accessors: [
        { bufferView: 0, ...vectors },
        { bufferView: 1, ...vectors },
        { bufferView: 2, componentType: 5125, count: indices.length, type: 'SCALAR' },
      ],
      bufferViews,
      buffers,
    },
    body,
  );
}

for (const [what, make] of [
  ['five million triangles in a file of 120 MB', () => gridGlb(1582, true)],
  ['five million triangles without normals', () => gridGlb(1582, false)],
  ['two thousand parts', () => instancesGlb(2000, false)],
  ['ten thousand nodes of one mesh', () => instancesGlb(10_000, true)],
  ['an image of 64 megapixels', () => textured(1, 8192, 8192)],
  ['two images of 32 megapixels', () => textured(2, 8192, 4096)],
  ['64 images of a megapixel', () => textured(64, 1024, 1024)],
] as const) {
  test(`@release ${what} loads, and the page and the GPU process grow by less than 1 GB`, async ({
    browser,
    site,
    mount,
  }) => {
    test.setTimeout(600_000);
    const viewer = await mount(`<phong-viewer src="${site.file(triangleGlb())}"></phong-viewer>`, {
      width: 300,
      height: 200,
    });
    const memory = await MemoryWatch.of(browser);
    const address = site.file(make());
    memory.start();
    expect(await load(viewer, `${address}?large`)).toBe('load');
    await viewer.evaluate(
      async (element: PhongViewer) => (await element.toBlob({ width: 30, height: 20 })).size,
    );
    const growth = memory.stop();
    console.log(`${what}: ${growth.toFixed()} MB`);
    expect(growth).toBeLessThan(GROWTH_LIMIT_MB);
  });
}
