// Do pictures come back when the browser's GPU process crashes? In a browser of its own: the crash
// takes every page along.

import { chromium } from '@playwright/test';
import { launchOptions } from '../support/built-pages.mjs';
import { compare, expect, pixels, test, type Picture } from '../support/test.js';
import type { PhongViewer } from '../element/support/viewer.js';

const light = '<phong-light position="1 2 3 0"></phong-light>';
const scenes = ['geometry="box"', 'geometry="sphere" ka="0"'].map(
  (attributes) => `<phong-viewer ${attributes}>${light}</phong-viewer>`,
);

for (const count of [1, 2]) {
  test(`@release ${count} on the page: a crash of the GPU process changes no picture`, async ({
    site,
  }) => {
    test.setTimeout(120_000);
    const browser = await chromium.launch(await launchOptions('', []));
    try {
      const page = await browser.newPage();
      const errors: string[] = [];
      page.on('pageerror', (error) => errors.push(String(error)));
      await page.goto(
        site.page(scenes.slice(0, count).join(''), {
          css: 'body { margin: 0 } phong-viewer { width: 120px; height: 90px }',
          head: '<script type="module" src="/dist/phong-viewer.standalone.js"></script>',
        }),
      );
      const viewers = page.locator('phong-viewer');
      const notices = viewers.locator('[part=notice]');
      const pictures = async () => {
        const all: Picture[] = [];
        for (const viewer of await viewers.all()) {
          await viewer.evaluate((element: PhongViewer) => element.ready);
          all.push(await pixels(viewer));
          all.push(await pixels(viewer, { width: 50, height: 70 }));
        }
        return all;
      };
      await page.evaluate(() => customElements.whenDefined('phong-viewer').then(() => undefined));
      const before = await pictures();
      const shot = await viewers.first().screenshot();
      const session = await browser.newBrowserCDPSession();
      await session.send('Browser.crashGpuProcess');
      await expect(notices).toHaveCount(count);
      await expect(notices).toHaveCount(0, { timeout: 60_000 });
      const after = await pictures();
      expect(after.map((picture, i) => compare(picture, before[i]!).max)).toEqual(
        before.map(() => 0),
      );
      expect(Buffer.compare(await viewers.first().screenshot(), shot)).toBe(0);
      expect(errors).toEqual([]);
    } finally {
      await browser.close();
    }
  });
}
