// Does a page opened from disk work? dist/phong-viewer.classic.js in a folder of its own, opened as
// file://.

import { cpSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import type { PhongViewer } from '../../src/viewer/index.js';
import { outputFolder } from '../../.ci/output-folder.mjs';
import { readmePage } from '../../.ci/readme-picture.mjs';
import { field } from '../extras/panel/panel-rows.js';
import { allReady, expect, pixelAt, pixels, same, test } from '../support/test.js';
import { requestsOf } from '../support/requests.js';

const fixtures = fileURLToPath(new URL('../fixtures', import.meta.url));
const size = { width: 60, height: 40 };
const sized = 'style="display: block; width: 600px; height: 400px"';
const classic = '<script src="phong-viewer.classic.js"></script>';

const scene =
  `<phong-viewer ${sized} geometry="sphere" ka="255"><phong-light ambient="200 100 50" diffuse="0" specular="0">` +
  '</phong-light></phong-viewer>';

let folder: string;

test.beforeEach(() => {
  folder = mkdtempSync(join(tmpdir(), 'phong-viewer-disk-'));
  cpSync(
    join(outputFolder('dist'), 'phong-viewer.classic.js'),
    join(folder, 'phong-viewer.classic.js'),
  );
});

test.afterEach(() => rmSync(folder, { recursive: true, force: true }));

/** Writes a page without a declared encoding. @returns its address */
function handout(text: string) {
  const path = join(folder, 'handout.html');
  writeFileSync(path, `<!doctype html>\n<title>Handout</title>\n${text}\n`);
  return pathToFileURL(path).href;
}

test('a page opened from disk shows the picture, with the script before or after the element', async ({
  page,
}) => {
  for (const text of [classic + scene, scene + classic]) {
    await page.goto(handout(text));
    await allReady(page);
    const picture = await pixels(page.locator('phong-viewer'), size);
    expect(pixelAt(picture, 30, 20)).toEqual([200, 100, 50, 255]);
    expect(pixelAt(picture, 0, 0)).toEqual([0, 0, 0, 0]);
  }
});

test('a page opened from disk has every shape, a model that it contains, the panel, shadeAt and toBlob, without a request', async ({
  page,
}) => {
  const requests = requestsOf(page);
  const shapes = ['cylinder', 'cone', 'pyramid', 'torus', 'torus-knot', 'teapot', 'plane'];
  const meshes = shapes.map(
    (name, i) => `<phong-mesh geometry="${name}" position="${i} 0 0"></phong-mesh>`,
  );
  const model = readFileSync(join(fixtures, 'models/textured.glb')).toString('base64');
  meshes.push(`<phong-mesh src="data:model/gltf-binary;base64,${model}"></phong-mesh>`);
  await page.goto(
    handout(
      `${classic}<phong-viewer ${sized} geometry="box" target="0 0 0" radius="12" gui>${meshes.join('')}</phong-viewer>`,
    ),
  );
  await allReady(page);
  const viewer = page.locator('phong-viewer');
  await expect(viewer.getByText('θ azimuth °')).toBeVisible();
  const found = await viewer.evaluate(async (element: PhongViewer) => ({
    drawn: element.stats.drawCalls,
    shares: (await element.shadeAt(300, 200))?.shares.length,
    type: (await element.toBlob({ type: 'image/jpeg' })).type,
    globals: ['phongViewer', '__THREE__'].filter((name) => name in window),
  }));
  expect(found).toEqual({ drawn: 9, shares: 1, type: 'image/jpeg', globals: [] });
  expect(requests.filter((url) => !url.startsWith('data:'))).toEqual([
    expect.stringMatching(/handout\.html$/),
    expect.stringMatching(/phong-viewer\.classic\.js$/),
  ]);
});

test('a model beside a page opened from disk is an error that names a server', async ({
  page,
  consoleGuard,
}) => {
  // The browser's own words: two lines of a browser with windows, one of a headless shell.
  consoleGuard.allow(
    /^error: (Access to fetch at 'file:.* blocked by CORS policy|Failed to load resource|Fetch API cannot load file:)/,
  );
  consoleGuard.allow(
    /textured\.glb\. Serve the folder, with `npx serve` or `python3 -m http\.server`/,
    1,
  );
  cpSync(join(fixtures, 'models/textured.glb'), join(folder, 'textured.glb'));
  await page.goto(handout(`${classic}<phong-viewer ${sized} src="textured.glb"></phong-viewer>`));
  const notice = page.locator('phong-viewer').locator('[part=notice]');
  await expect(notice).toHaveText(
    'A page opened from disk may not read files, such as textured.glb.',
  );
});

test('the classic script draws what the module draws, also sandboxed', async ({
  page,
  site,
  mount,
}) => {
  const head = '<script src="/dist/phong-viewer.classic.js"></script>';
  const markup =
    '<phong-viewer geometry="box" theta="20" gui><phong-light></phong-light></phong-viewer>';
  const expected = await pixels(await mount(markup), size);
  await page.goto(site.page(markup, { head }));
  await allReady(page);
  const viewer = page.locator('phong-viewer');
  await expect(viewer.getByText('Controls')).toBeVisible();
  same(await pixels(viewer, size), expected);
  // Where learning platforms put pages.
  const inner = site.page(scene, { csp: '', head });
  await page.goto(
    site.page(`<iframe sandbox="allow-scripts" src="${inner}"></iframe>`, { csp: '' }),
  );
  const framed = page.frameLocator('iframe').locator('phong-viewer');
  await framed.evaluate((element: PhongViewer) => element.ready);
  expect(pixelAt(await pixels(framed, size), 30, 20)).toEqual([200, 100, 50, 255]);
});

test('the classic script imports nothing and is ASCII after its notice', () => {
  const text = readFileSync(join(outputFolder('dist'), 'phong-viewer.classic.js'), 'utf8');
  const code = text.slice(text.indexOf('*/'));
  expect(code).not.toMatch(/\bimport\s*\(|import\.meta|^\s*(import|export)\b/m);
  expect(/[\u0080-\uffff]/.exec(code)?.[0]).toBeUndefined();
});

test.describe('on a phone', () => {
  test.use({ isMobile: true, viewport: { width: 390, height: 844 } });

  test("the README's page is as wide as the screen", async ({ page }) => {
    await page.goto(handout(readmePage()));
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(390);
  });
});

// All code is there before the first picture, so the panel is built before `auto` has found a
// camera.
test('the panel of a page opened from disk shows the camera of the first picture', async ({
  page,
}) => {
  for (const shape of ['plane', 'teapot']) {
    for (const gui of ['gui', 'gui="radius target"']) {
      const mesh = `<phong-mesh geometry="${shape}" position="0 -0.5 0"></phong-mesh>`;
      await page.goto(handout(`${classic}<phong-viewer ${sized} ${gui}>${mesh}</phong-viewer>`));
      await allReady(page);
      const viewer = page.locator('phong-viewer');
      const { target, radius } = await viewer.evaluate(({ camera }: PhongViewer) => camera);
      expect(target).toEqual([0, -0.5, 0]);
      await expect(field(viewer, 'target y')).toHaveValue('-0.5');
      expect(Number(await field(viewer, 'radius').inputValue())).toBeCloseTo(radius, 3);
    }
  }
});
