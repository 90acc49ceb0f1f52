// Is a chunk that could not be fetched fetched by the next use in Firefox, which remembers failed modules by their
// address?
import { expect, test } from '@playwright/test';
import { startFirefox } from '../../.ci/firefox.mjs';
import type { PhongViewer } from '../../src/index.js';
import { startSite, testMounts } from '../support/site.js';

test('@release a later use fetches what could not be fetched in Firefox', async () => {
  test.setTimeout(300_000);
  const site = await startSite(testMounts);
  const firefox = await startFirefox();
  try {
    const page = await firefox.browser.newPage();
    let broken = true;
    await page.setRequestInterception(true);
    page.on('request', (request) => {
      void (broken && /chunks\//.test(request.url()) ? request.abort() : request.continue());
    });
    const head = '<script type="module" src="/dist/phong-viewer.standalone.js"></script>';
    const css = 'phong-viewer { display: block; width: 160px; height: 120px }';
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
    // The parts that read a model are fetched one after another: none of them is remembered as missing.
    expect(await use()).toEqual(['blob', 'explanation', 'torus', 'bunny']);
  } finally {
    await firefox.close();
    await site.close();
  }
});
