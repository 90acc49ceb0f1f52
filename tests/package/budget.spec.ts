// How much does a page fetch before its first frame? Counts files and bytes, compressed by Brotli.
// The standalone file contains three.js and Lit; for the ES modules they are not counted.

import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { outputFolder } from '../../.ci/output-folder.mjs';
import { allReady, expect, test } from '../support/test.js';
import { nextFrame } from '../element/support/viewer.js';
import { measured, SIZES } from '../../.ci/site/generated.js';
import { bundleOf } from './bundle.js';
import { brotliSize, Requests, sentSize, usages } from './requests.js';

const scene = `<phong-viewer geometry="box" theta="30" phi="70">
  <phong-light name="sun" position="1 2 1 0" ambient="20 20 25"></phong-light>
  <phong-light name="lamp" position="2 2 0 1" diffuse="#fc8" attenuation="1 0.2 0.05"></phong-light>
  <phong-light name="spot" position="0 3 3 1" axis="0 -1 -1" aperture="20" cutoff="12"></phong-light>
</phong-viewer>`;

/** Measured bytes, rounded up. A change that adds bytes raises the number in the same commit. */
const budgets = { standalone: 125_000, modules: 59_750 } as const;

for (const usage of ['standalone', 'modules'] as const) {
  test(`a viewer with a box and three lights fetches no unused part (${usage})`, async ({
    page,
    site,
  }) => {
    const requests = new Requests(page);
    await page.goto(site.page(scene, usages[usage]));
    await allReady(page);
    await nextFrame(page);
    const fetched = requests.take();
    expect(fetched.sort()).toEqual(
      usage === 'standalone' ? ['phong-viewer.standalone.js'] : ['index.js', 'trusted-types.js'],
    );
    const bytes = sentSize(fetched);
    expect(bytes).toBeLessThanOrEqual(budgets[usage]);
    // A budget far above the real size would let new code in unnoticed.
    expect(bytes, 'the budget can be lowered').toBeGreaterThan(0.97 * budgets[usage]);
  });
}

test('@release the standalone file is about as large as a bundle of plain three.js with its Phong material', async () => {
  const three = await bundleOf(`
    import { DirectionalLight, Mesh, MeshPhongMaterial, PerspectiveCamera, PointLight, Scene } from 'three';
    import { SphereGeometry, SpotLight, WebGLRenderer } from 'three';
    const scene = new Scene();
    scene.add(new Mesh(new SphereGeometry(), new MeshPhongMaterial()));
    scene.add(new DirectionalLight(), new PointLight(), new SpotLight());
    new WebGLRenderer().render(scene, new PerspectiveCamera());
  `);
  // Measured: 1.171.
  expect(sentSize(['phong-viewer.standalone.js']) / brotliSize(three)).toBeLessThan(1.18);
});

test('@release a bundled app is not larger than measured, and smaller with the standalone file', async () => {
  const bundled = async (file: string) =>
    brotliSize(await bundleOf(`import ${JSON.stringify(join(outputFolder('dist'), file))};`));
  // Measured: 168.8 kB, and 125.9 kB. Of the former three.js's renderer is 105 kB, Lit 5, and the
  // elements 59. Were GLTFLoader an import, its classes of three.js would be another 8.
  expect(await bundled('index.js')).toBeLessThan(169_200);
  expect(await bundled('phong-viewer.standalone.js')).toBeLessThan(126_200);
});

test('the script for pages opened from disk and the React components are not larger than measured', () => {
  // Measured: 358.3 kB, of which the Draco decoder is 80 kB.
  expect(sentSize(['phong-viewer.classic.js'])).toBeLessThan(358_500);
  // Measured: 0.95 kB.
  expect(sentSize(['react.js'])).toBeLessThan(1024);
});

test('a bundled page that imports only the lights from core gets nothing of three.js', async () => {
  // A bundler can only drop a module that does nothing on import.
  const code = await bundleOf(`
    import { LightState } from ${JSON.stringify(join(outputFolder('dist'), 'core.js'))};
    console.log(new LightState({ cutoff: 2 }).values);
  `);
  expect(code).toContain('cutoff');
  expect(code).not.toMatch(/Box3|Matrix4|WebGLRenderer/);
  expect(code.length).toBeLessThan(20_000); // measured 18,514: the lights' values and their checks
});

test('@release the React components with the standalone file bring no second copy of the elements or of three.js', async () => {
  const app = await bundleOf(
    `export * from ${JSON.stringify(join(outputFolder('dist'), 'react-standalone.js'))};`,
  );
  // The standalone file, 0.7 kB of components, and 3 kB of React.
  expect(brotliSize(app) - sentSize(['phong-viewer.standalone.js'])).toBeLessThan(5000);
});

test('@release the sizes that the start page shows before the first build are about right', () => {
  for (const row of SIZES) {
    const kilobytes = measured(outputFolder('dist'), row) ?? NaN;
    expect(Math.abs(row.noted - kilobytes), `${row.words}: ${kilobytes} kB`).toBeLessThan(
      0.1 * kilobytes,
    );
  }
});

test('the first files hold only characters that browsers keep as one byte', () => {
  for (const name of ['index.js', 'core.js', 'reference.js', 'phong-viewer.standalone.js']) {
    const text = readFileSync(join(outputFolder('dist'), name), 'utf8');
    expect(text.match(/[^\u0000-\u00ff]/gu) ?? [], name).toEqual([]);
  }
});

test('core and reference are one file each, and reference does not import three.js', async ({
  page,
  site,
}) => {
  const requests = new Requests(page);
  const { csp = '', head = '' } = usages.modules;
  const importMap = head.replace(/<script type="module".*/, '');
  await page.goto(site.page('', { csp, head: importMap }));
  const load = (name: string) =>
    page.evaluate(async (entry) => Object.keys((await import(entry)) as object), name);
  expect(await load('phong-viewer/reference')).toContain('shade');
  expect(requests.take()).toEqual(['reference.js']);
  await load('phong-viewer/core');
  expect(requests.take()).toEqual(['core.js']);
});
