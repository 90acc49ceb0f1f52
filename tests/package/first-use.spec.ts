// Is each lazy chunk fetched with its first use and not before? For the standalone file and the ES
// modules.

import type { Page } from '@playwright/test';
import { type ViewerLocator, allReady, expect, test } from '../support/test.js';
import { drag, nextFrame, set as setOn } from '../element/support/viewer.js';
import { chunkName, Requests, usages } from './requests.js';

type Act = (viewer: ViewerLocator, page: Page) => Promise<unknown>;

const set =
  (values: Readonly<Record<string, string | number | boolean>>): Act =>
  (viewer) =>
    setOn(viewer, values);

const explain =
  (x: number, y: number): Act =>
  (viewer) =>
    viewer.evaluate(async (element, at) => (await element.shadeAt(...at)) === null, [
      x,
      y,
    ] as const);

const draw =
  (frames: number): Act =>
  (viewer) =>
    viewer.evaluate(async (element, count) => {
      for (let frame = 0; frame < count; frame++) {
        element.requestRender();
        await element.ready;
      }
    }, frames);

const readOnce: Act = (viewer) =>
  viewer.evaluate((element) => [element.toHTML(), element.camera, element.stats].length);

const capture: Act = (viewer) => viewer.evaluate(async (element) => (await element.toBlob()).size);

const addAfter =
  (markup: string): Act =>
  (viewer) =>
    viewer.evaluate((element, html) => element.insertAdjacentHTML('afterend', html), markup);

const model = (name: string): Act => set({ src: `/fixtures/models/${name}` });

/**
 * What is used, and the chunks that it fetches, in any order. Run in this order on one page: a
 * chunk that an earlier use fetched is not fetched again.
 */
const uses: readonly (readonly [what: string, act: Act, chunks: string])[] = [
  ['a picture drawn again and again', draw(6), ''],
  ['a picture that moves', draw(6), 'special-programs'],
  ['changes of lights, camera and shading', set({ theta: 5, fov: 40, shading: 'gouraud' }), ''],
  ['toHTML, camera and stats', readOnce, ''],
  ['a sphere', set({ geometry: 'sphere' }), ''],
  ['a torus', set({ geometry: 'torus' }), 'solids'],
  ['a pyramid', set({ geometry: 'pyramid' }), ''],
  ['a teapot', set({ geometry: 'teapot' }), 'teapot'],
  ['toBlob', capture, 'picture-blob'],
  ['shadeAt beside the shape', explain(1, 1), 'equation pick shade-at triangle-bvh'],
  ['shadeAt on the shape', explain(75, 50), ''],
  ['a view of normals', set({ view: 'normals' }), 'legend'],
  ['one light alone', set({ view: 'shaded', viewLight: 'light 1' }), ''],
  ['no view', set({ viewLight: '' }), ''],
  ['a probe', set({ probe: true }), 'probe projection sum-table svg-layer'],
  ['helpers', set({ probe: false, helpers: 'lights' }), 'followed-drag helpers round-number'],
  ['none', set({ helpers: '' }), ''],
  ['a drag', (_, page) => drag(page, [75, 50], [10, 5]), ''],
  ['auto-rotate', set({ autoRotate: 5 }), ''],
  ['dropped files', set({ droppable: true }), 'drops'],
  ['a camera group', set({ cameraGroup: 'all' }), 'camera-group'],
  ['a comparison', addAfter('<phong-compare></phong-compare>'), 'comparison'],
  ['the panel', set({ gui: true }), 'panel panel-rows show-rows'],
  [
    'a control',
    addAfter('<phong-control for="turned" attribute="theta"></phong-control>'),
    'control extra-element',
  ],
  ['a model', model('textured.glb'), 'model-content model-shared read-gltf'],
  ['an STL file', model('coloured.stl'), 'model-triangles read-stl'],
  ['a PLY file', model('coloured.ply'), 'read-ply'],
  ['an OBJ file', model('quads.obj'), 'read-obj'],
  ['another model', model('mask.glb'), ''],
  [
    'a model compressed with Draco, under a policy without WebAssembly',
    set({ src: '/assets/models/bunny.glb' }),
    'draco draco-worker draco_decoder.wasm',
  ],
];

for (const usage of ['standalone', 'modules'] as const) {
  test(`${usage === 'modules' ? '@release ' : ''}parts are fetched at first use (${usage})`, async ({
    page,
    site,
  }) => {
    const requests = new Requests(page);
    const scene =
      '<phong-viewer id="turned" geometry="box"><phong-light></phong-light></phong-viewer>';
    const css = 'body { margin: 0 } phong-viewer { display: block; width: 150px; height: 100px }';
    await page.goto(site.page(scene, { ...usages[usage], css }));
    await allReady(page);
    const viewer = page.locator('phong-viewer');
    expect(requests.take()).toHaveLength(usage === 'modules' ? 2 : 1); // with trusted-types.js
    for (const [what, act, chunks] of uses) {
      await act(viewer, page);
      // Requests may start after the call. Two frames later no further one may have started.
      const late = new Set<string>();
      const came = () => {
        for (const path of requests.take()) {
          late.add(chunkName(path));
        }
        return [...late].sort().join(' ');
      };
      await expect.poll(came, { message: what, intervals: [10, 20, 50, 100] }).toBe(chunks);
      await nextFrame(page);
      expect(came(), what).toBe(chunks);
    }
  });
}
