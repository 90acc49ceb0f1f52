// Does a copy of the packed dist/ work on a page without a bundler, under the strict policy, with its lazy parts?
// Installs from the registry, so it is slow: @release.

import { cpSync } from 'node:fs';
import { join } from 'node:path';
import { startSite, testMounts } from '../support/site.js';
import { allReady, expect, pixels, test } from '../support/test.js';
import { useFreshProject } from './fresh-project.js';

test.describe('a copy of dist/ @release', () => {
  const project = useFreshProject([], ({ folder }) => {
    const installed = join(folder, 'node_modules/phong-viewer/dist');
    cpSync(installed, join(folder, 'site/vendor/viewer'), { recursive: true });
    cpSync(join(testMounts['/assets/']!, 'models/bunny.glb'), join(folder, 'site/bunny.glb'));
  });

  test('shows the bunny and the panel, and fetches nothing from other hosts', async ({ page }) => {
    const site = await startSite({ '/some/where/': join(project().folder, 'site') });
    const asked: string[] = [];
    page.on('request', (request) => asked.push(request.url()));
    await page.goto(
      site.page(
        '<phong-viewer alt="A bunny" src="/some/where/bunny.glb" gui>' +
          '<phong-light name="sun" position="1 2 1 0"></phong-light></phong-viewer>',
        {
          head: '<script type="module" src="/some/where/vendor/viewer/phong-viewer.standalone.js"></script>',
          css: 'phong-viewer { display: block; width: 600px; height: 400px }',
        },
      ),
    );
    await page.evaluate(() => customElements.whenDefined('phong-viewer').then(() => undefined));
    await allReady(page);
    const viewer = page.locator('phong-viewer');
    const { data } = await pixels(viewer, { width: 60, height: 40 });
    const lit = data.filter((code, i) => i % 4 === 3 && code === 255 && data[i - 1]! > 60).length;
    expect(lit).toBeGreaterThan(200);
    await expect(viewer.locator('[part=panel]').getByText('sun').first()).toBeVisible();
    expect(asked.filter((url) => !url.startsWith(site.origin))).toEqual([]);
    await site.close();
  });
});
