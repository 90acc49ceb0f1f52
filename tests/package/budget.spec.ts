// What a page fetches before anything moves: how many bytes, gzipped, and in how many files. three.js and Lit are not
// counted where they stay imports, and are inside where the file is the standalone one.

import { allReady, expect, test } from '../support/test.js';
import { nextFrame } from '../element/support.js';
import { gzippedSize, Requests, usages } from './requests.js';

const scene = `<phong-viewer geometry="box" theta="30" phi="70">
  <phong-light name="sun" position="1 2 1 0" ambient="20 20 25"></phong-light>
  <phong-light name="lamp" position="2 2 0 1" diffuse="#fc8" attenuation="1 0.2 0.05"></phong-light>
  <phong-light name="spot" position="0 3 3 1" axis="0 -1 -1" aperture="20" cutoff="12"></phong-light>
</phong-viewer>`;

/** Bytes that are measured, rounded up to the next 256: whoever adds some decides whether they are worth it. */
const budgets = { standalone: 97_792, modules: 36_096 } as const;

for (const usage of ['standalone', 'modules'] as const) {
  test(`a viewer with a box and three lights fetches no part of the package that it does not use (${usage})`, async ({
    page,
    site,
  }) => {
    const requests = new Requests(page);
    await page.goto(site.page(scene, usages[usage]));
    await page.evaluate(() => customElements.whenDefined('phong-viewer').then(() => undefined));
    await allReady(page);
    await nextFrame(page);
    const fetched = requests.take();
    expect(fetched).toEqual([usage === 'standalone' ? 'phong-viewer.standalone.js' : 'index.js']);
    const bytes = gzippedSize(fetched);
    expect(bytes).toBeLessThanOrEqual(budgets[usage]);
    // Far below, the budget would let as much creep back in.
    expect(bytes, 'the budget can be lowered').toBeGreaterThan(0.97 * budgets[usage]);
  });
}

test('core and reference are one file each, and the latter needs no three.js', async ({ page, site }) => {
  const requests = new Requests(page);
  const { csp = '', head = '' } = usages.modules;
  const importMap = head.replace(/<script type="module".*/, '');
  await page.goto(site.page('', { csp, head: importMap }));
  const names = await page.evaluate(async () => {
    const name = 'phong-viewer/reference';
    return Object.keys((await import(name)) as object);
  });
  expect(names).toContain('shade');
  expect(requests.take()).toEqual(['reference.js']);
  await page.evaluate(async () => {
    const name = 'phong-viewer/core';
    await import(name);
  });
  expect(requests.take()).toEqual(['core.js']);
});
