// Is each lazy chunk fetched with its first use and not before? For the standalone file and the ES modules.

import type { Locator, Page } from '@playwright/test';
import type { PhongViewer } from '../../src/index.js';
import { allReady, expect, test } from '../support/test.js';
import { nextFrame } from '../element/support/viewer.js';
import { chunkName, Requests, usages } from './requests.js';

interface Use {
  readonly what: string;
  readonly use: (viewer: Locator, page: Page) => Promise<unknown>;
  /** The chunks that it fetches, in any order. */
  readonly chunks: readonly string[];
}

const set = (values: Readonly<Record<string, string | number | boolean>>) => (viewer: Locator) =>
  viewer.evaluate(async (element: PhongViewer, given) => {
    Object.assign(element, given);
    await element.ready;
  }, values);

const explain = (x: number, y: number) => (viewer: Locator) =>
  viewer.evaluate(async (element: PhongViewer, [left, top]) => (await element.shadeAt(left, top)) === null, [
    x,
    y,
  ] as const);

/** Run in this order on one page: a chunk that an earlier use fetched is not fetched again. */
const uses: readonly Use[] = [
  {
    what: 'a picture drawn again and again',
    use: (viewer) => drawOften(viewer),
    chunks: [],
  },
  {
    what: 'changes of lights, camera and shading',
    use: set({ theta: 5, fov: 40, shading: 'gouraud' }),
    chunks: [],
  },
  {
    what: 'toHTML, camera and stats',
    use: (viewer) =>
      viewer.evaluate((element: PhongViewer) => [element.toHTML(), element.camera, element.stats].length),
    chunks: [],
  },
  { what: 'a sphere', use: set({ geometry: 'sphere' }), chunks: [] },
  { what: 'a torus', use: set({ geometry: 'torus' }), chunks: ['solids'] },
  { what: 'a pyramid', use: set({ geometry: 'pyramid' }), chunks: [] },
  { what: 'a teapot', use: set({ geometry: 'teapot' }), chunks: ['teapot'] },
  {
    what: 'toBlob',
    use: (viewer) => viewer.evaluate(async (element: PhongViewer) => (await element.toBlob()).size),
    chunks: ['picture-blob'],
  },
  { what: 'shadeAt beside the shape', use: explain(1, 1), chunks: ['pick', 'shade-at'] },
  { what: 'shadeAt on the shape', use: explain(75, 50), chunks: ['reference'] },
  { what: 'shadeAt once more', use: explain(76, 50), chunks: [] },
  { what: 'a view of normals', use: set({ view: 'normals' }), chunks: ['legend'] },
  { what: 'one light alone', use: set({ view: 'shaded', viewLight: 'light 1' }), chunks: [] },
  { what: 'no view', use: set({ viewLight: '' }), chunks: [] },
  { what: 'a drag', use: (_, page) => drag(page), chunks: [] },
  { what: 'auto-rotate', use: set({ autoRotate: 5 }), chunks: [] },
  { what: 'a camera group', use: set({ cameraGroup: 'all' }), chunks: ['camera-group'] },
  {
    what: 'a comparison',
    use: (viewer) => viewer.evaluate((element) => element.after(document.createElement('phong-compare'))),
    chunks: ['comparison'],
  },
  { what: 'the panel', use: set({ gui: true }), chunks: ['panel', 'panel-rows', 'round-number'] },
  {
    what: 'a control',
    use: (viewer) =>
      viewer.evaluate((element) => {
        element.insertAdjacentHTML(
          'afterend',
          '<phong-control for="turned" attribute="theta"></phong-control>',
        );
        element.id = 'turned';
      }),
    chunks: ['control'],
  },
  {
    what: 'a model',
    use: set({ src: '/fixtures/models/textured.glb' }),
    chunks: ['model-content', 'model-shared', 'read-gltf'],
  },
  {
    what: 'an STL file',
    use: set({ src: '/fixtures/models/coloured.stl' }),
    chunks: ['model-triangles', 'read-stl'],
  },
  { what: 'a PLY file', use: set({ src: '/fixtures/models/coloured.ply' }), chunks: ['read-ply'] },
  { what: 'an OBJ file', use: set({ src: '/fixtures/models/quads.obj' }), chunks: ['read-obj'] },
  { what: 'another model', use: set({ src: '/fixtures/models/mask.glb' }), chunks: [] },
  {
    what: 'a model compressed with Draco, under a policy without WebAssembly',
    use: set({ src: '/assets/models/bunny.glb' }),
    chunks: ['draco-worker', 'draco'],
  },
];

const drawOften = (viewer: Locator) =>
  viewer.evaluate(async (element: PhongViewer) => {
    for (let frame = 0; frame < 6; frame++) {
      element.requestRender();
      await element.ready;
    }
  });

async function drag(page: Page): Promise<void> {
  await page.mouse.move(75, 50);
  await page.mouse.down();
  await page.mouse.move(85, 55);
  await page.mouse.up();
}

/** The width of the panel, which the comparison needs too. The standalone build has it in a chunk with other code. */
const WITH_OTHERS = 'panel-column';

for (const usage of ['standalone', 'modules'] as const) {
  test(`${usage === 'modules' ? '@release ' : ''}each part is fetched with its first use (${usage})`, async ({
    page,
    site,
  }) => {
    const requests = new Requests(page);
    const scene = '<phong-viewer geometry="box"><phong-light></phong-light></phong-viewer>';
    const css = 'body { margin: 0 } phong-viewer { display: block; width: 150px; height: 100px }';
    await page.goto(site.page(scene, { ...usages[usage], css }));
    await page.evaluate(() => customElements.whenDefined('phong-viewer').then(() => undefined));
    await allReady(page);
    const viewer = page.locator('phong-viewer');
    expect(requests.take()).toHaveLength(usage === 'modules' ? 2 : 1); // with trusted-types.js
    for (const { what, use, chunks } of uses) {
      await use(viewer, page);
      // Requests may start after the call. Two frames later no further one may have started.
      const late = new Set<string>();
      const came = (): string[] => {
        for (const path of requests.take()) if (chunkName(path) !== WITH_OTHERS) late.add(chunkName(path));
        return [...late].sort();
      };
      await expect.poll(came, { message: what, intervals: [10, 20, 50, 100] }).toEqual([...chunks].sort());
      await nextFrame(page);
      expect(came(), what).toEqual([...chunks].sort());
    }
  });
}
