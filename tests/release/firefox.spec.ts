// Does the GLSL keep its contract in a second browser on a second GL, and do pictures follow float64? Firefox with
// Mesa's software renderer, under Xvfb. For elements, camera, panel and models see browsers.spec.ts.
import { expect, test } from '@playwright/test';
import { startFirefox } from '../../.ci/firefox.mjs';
import type { Report } from '../glsl/page/page.js';
import { decodePng } from '../support/picture.js';
import { startSite, testMounts, type Site } from '../support/site.js';
import { compareWithReference } from '../visual/against-reference.js';
import { randomScene, sceneMarkup } from '../visual/random-scene.js';

const SIZE = { width: 160, height: 120 };
const SCENES = 60;
let site: Site | undefined;
let firefox: Awaited<ReturnType<typeof startFirefox>> | undefined;

// One worker, and so one Firefox and one screen.
test.describe.configure({ mode: 'serial' });

test.beforeAll(async () => {
  test.setTimeout(300_000);
  site = await startSite(testMounts);
  firefox = await startFirefox();
});

test.afterAll(async () => {
  await firefox?.close();
  await site?.close();
});

test('@release keeps the contract in Firefox, on its driver and on the worst lawful ones', async () => {
  test.setTimeout(1_800_000);
  if (firefox === undefined || site === undefined) throw new Error('Firefox did not start');
  const page = await firefox.browser.newPage();
  const seed = Math.floor(Math.random() * 2 ** 31);
  for (const driver of ['shipped', 'up', 'down', 'either']) {
    await page.goto(`${site.origin}/harness/index.html?driver=${driver}&cases=1e6&seed=${seed}`);
    const report: Report = await page.evaluate(() => window.finished);
    console.log(`seed ${seed}, ${driver}, ${report.seconds.toFixed(1)} s, ${report.renderer}`);
    expect(report.error).toBeNull();
    expect.soft(report.broken, driver).toEqual([]);
  }
});

test('@release draws the equation in Firefox within one code of float64', async () => {
  test.setTimeout(900_000);
  if (firefox === undefined || site === undefined) throw new Error('Firefox did not start');
  const page = await firefox.browser.newPage();
  const said: string[] = [];
  page.on('console', (message) => said.push(message.text()));
  page.on('pageerror', (error) => said.push(String(error)));
  const head = '<script type="module" src="/dist/phong-viewer.standalone.js"></script>';
  const css = `phong-viewer { display: block; width: ${SIZE.width}px; height: ${SIZE.height}px }`;
  for (let seed = 1; seed <= SCENES; seed++) {
    const scene = randomScene(seed, seed % 3 === 0 ? 'box' : 'plane');
    await page.goto(site.page(sceneMarkup(scene), { head, css }));
    const base64 = await page.evaluate(async ({ width, height }) => {
      await customElements.whenDefined('phong-viewer');
      const viewer = document.querySelector('phong-viewer') as HTMLElement & {
        ready: Promise<void>;
        toBlob(options: object): Promise<Blob>;
      };
      await viewer.ready;
      const bytes = new Uint8Array(await (await viewer.toBlob({ width, height })).arrayBuffer());
      return btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(''));
    }, SIZE);
    const errors = compareWithReference(decodePng(Buffer.from(base64, 'base64')), scene);
    expect.soft(errors.max, `seed ${seed}, ${errors.at}`).toBeLessThanOrEqual(1);
  }
  expect(said).toEqual([]);
});
