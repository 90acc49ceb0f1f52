// What only Firefox tells, with Mesa's software renderer under Xvfb: does the GLSL keep its
// contract on a second GL, does the next use fetch a chunk that could not be fetched (Firefox
// remembers failed modules by their address), and does a page opened from disk work? For elements,
// camera, panel, models and pictures see browsers.spec.ts.
import { cpSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { expect, test } from '@playwright/test';
import { startFirefox } from '../../.ci/firefox.mjs';
import { outputFolder } from '../../.ci/output-folder.mjs';
import type { PhongViewer } from '../../src/viewer/index.js';
import { startSite, testMounts, type Site } from '../support/site.js';

const SIZE = { width: 160, height: 120 };
const head = '<script type="module" src="/dist/phong-viewer.standalone.js"></script>';
const css = `phong-viewer { display: block; width: ${SIZE.width}px; height: ${SIZE.height}px }`;
let site: Site;
let firefox: Awaited<ReturnType<typeof startFirefox>>;

// One worker, and so one Firefox and one screen.
test.describe.configure({ mode: 'default', timeout: 300_000 });

test.beforeAll(async () => {
  test.setTimeout(300_000);
  site = await startSite(testMounts);
  firefox = await startFirefox();
});

test.afterAll(async () => {
  await firefox.close();
  await site.close();
});

/** A page, and what it prints from now on. */
async function openTab() {
  const page = await firefox.browser.newPage();
  const said: string[] = [];
  page.on('console', (message) => said.push(message.text()));
  page.on('pageerror', (error) => said.push(String(error)));
  return { page, said };
}

test('@release keeps the contract in Firefox, on its driver and on the worst lawful ones', async () => {
  test.setTimeout(1_800_000);
  const { page } = await openTab();
  const seed = Math.floor(Math.random() * 2 ** 31);
  for (const driver of ['shipped', 'up', 'down', 'either']) {
    // Its page begins at once, so a busy machine loads it late: the limit is the test's.
    const url = `${site.origin}/harness/index.html?driver=${driver}&cases=1e6&seed=${seed}`;
    await page.goto(url, { timeout: 0 });
    const report = await page.evaluate(() => window.finished);
    console.log(`seed ${seed}, ${driver}, ${report.seconds.toFixed(1)} s, ${report.renderer}`);
    expect(report.error).toBeNull();
    expect.soft(report.broken, driver).toEqual([]);
  }
});

test('@release a later use fetches what could not be fetched in Firefox', async () => {
  const { page } = await openTab();
  let broken = true;
  await page.setRequestInterception(true);
  page.on('request', (request) => {
    void (broken && /chunks\//.test(request.url()) ? request.abort() : request.continue());
  });
  await page.goto(site.page('<phong-viewer geometry="box"></phong-viewer>', { head, css }));
  const use = (): Promise<readonly string[]> =>
    page.evaluate(async () => {
      await customElements.whenDefined('phong-viewer');
      const viewer = document.querySelector('phong-viewer') as PhongViewer;
      await viewer.ready;
      const outcome = [
        await viewer.toBlob({ width: 8, height: 8 }).then(() => 'blob', String),
        await viewer.shadeAt(80, 60).then(() => 'explanation', String),
      ];
      viewer.geometry = 'torus';
      await viewer.ready;
      outcome.push(viewer.loaded ? 'torus' : 'no torus');
      const said = new Promise<string>((resolve) => {
        viewer.addEventListener('error', ({ detail }) => resolve(detail.message), { once: true });
        viewer.addEventListener('load', () => resolve('bunny'), { once: true });
      });
      viewer.src = '/assets/models/bunny.glb';
      outcome.push(await said);
      viewer.src = '';
      viewer.geometry = 'box';
      return outcome;
    });
  for (let time = 0; time < 2; time++) {
    expect(await use()).toEqual([
      expect.stringContaining('could not be fetched'),
      expect.stringContaining('could not be fetched'),
      'no torus',
      expect.stringContaining('could not be fetched'),
    ]);
  }
  broken = false;
  // The parts that read a model are fetched one after another: none of them is remembered as
  // missing.
  expect(await use()).toEqual(['blob', 'explanation', 'torus', 'bunny']);
});

const MODEL = fileURLToPath(new URL('../fixtures/models/textured.glb', import.meta.url));
const HANDOUT = `<!doctype html>
<title>Handout</title>
<script src="phong-viewer.classic.js"></script>
<phong-viewer alt="A teapot" geometry="teapot" ka="255" gui>
  <phong-light ambient="200 100 50" diffuse="0" specular="0"></phong-light>
</phong-viewer>
<phong-viewer alt="A file" src="textured.glb"></phong-viewer>
`;

test('@release a page opened from disk shows picture and panel in Firefox', async () => {
  const folder = mkdtempSync(join(tmpdir(), 'phong-viewer-disk-'));
  cpSync(
    join(outputFolder('dist'), 'phong-viewer.classic.js'),
    join(folder, 'phong-viewer.classic.js'),
  );
  cpSync(MODEL, join(folder, 'textured.glb'));
  writeFileSync(join(folder, 'handout.html'), HANDOUT);
  try {
    const { page, said } = await openTab();
    await page.goto(pathToFileURL(join(folder, 'handout.html')).href);
    const middle = await page.evaluate(async () => {
      await customElements.whenDefined('phong-viewer');
      const viewer = document.querySelector<PhongViewer>('phong-viewer')!;
      await viewer.ready;
      const picture = await createImageBitmap(await viewer.toBlob({ width: 60, height: 40 }));
      const context = new OffscreenCanvas(60, 40).getContext('2d')!;
      context.drawImage(picture, 0, 0);
      return [...context.getImageData(30, 20, 1, 1).data];
    });
    expect(middle).toEqual([200, 100, 50, 255]);
    const [text, notice] = await page.evaluate(async () => {
      const [shape, file] = document.querySelectorAll<PhongViewer>('phong-viewer');
      await file!.ready;
      return [
        shape!.shadowRoot!.textContent,
        file!.shadowRoot!.querySelector('[part=notice]')?.textContent,
      ];
    });
    expect(text).toContain('Controls');
    expect(notice).toContain('A page opened from disk may not read files');
    // The browser's own words about the model, and ours with the advice.
    expect(
      said.filter(
        (line) => !/Same Origin Policy .*textured\.glb|python3 -m http\.server/.test(line),
      ),
    ).toEqual([]);
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
});
