// When does a page request the models that its markup names? Before the first file has run, once,
// and only those that the elements would request.

import { allReady, expect, test } from '../support/test.js';
import { requestsOf } from '../support/requests.js';
import { usages } from './requests.js';

const scene = `<phong-viewer src="/fixtures/models/mask.glb">
    <phong-mesh src="/fixtures/models/coloured.ply"></phong-mesh>
  </phong-viewer>
  <phong-viewer src="/fixtures/models/mask.glb" geometry="box"></phong-viewer>
  <phong-viewer loading="lazy" id="far" src="/fixtures/models/lazy.glb"></phong-viewer>`;

const css =
  'phong-viewer { display: block; width: 200px; height: 150px } #far { margin-top: 9000px }';

for (const usage of ['standalone', 'modules'] as const) {
  test(`models in the markup alone are requested, once, before the definitions (${usage})`, async ({
    page,
    site,
  }) => {
    await page.addInitScript(() => {
      const steps: string[] = [];
      Object.assign(window, { steps });
      const { fetch: get } = window;
      window.fetch = (input, init) => {
        steps.push(String(input).replace(/.*\//, ''));
        return get(input, init);
      };
      const define = customElements.define.bind(customElements);
      customElements.define = (name, element) => {
        steps.push(name);
        define(name, element);
      };
    });
    const requests = requestsOf(page);
    await page.goto(site.page(scene, { ...usages[usage], css }));
    await allReady(page);
    const steps = await page.evaluate(() => Reflect.get(window, 'steps') as string[]);
    expect(steps.slice(0, 3)).toEqual(['mask.glb', 'coloured.ply', 'phong-light']);
    const models = requests.filter((url) => url.includes('/fixtures/'));
    expect(models.map((url) => url.replace(/.*\//, '')).sort()).toEqual([
      'coloured.ply',
      'mask.glb',
    ]);
    expect(requests.join()).toMatch(/model-content/);
  });
}
