// Does phong-viewer/playwright work from the packed tarball, in a project of ES modules and in one
// of CommonJS, which Playwright makes by default? The page has a copy of dist/ anywhere on a
// server, under the strict policy, and fetches lazy parts from there. Installs from the registry,
// so it is slow: @release.
import { join } from 'node:path';
import { launchOptions } from '../support/built-pages.mjs';
import { startSite } from '../support/site.js';
import { expect, test } from '../support/test.js';
import { freshProject } from './fresh-project.js';

const spec = (address: string) => `
import { test } from '@playwright/test';
import { expect, settled, snapshot } from 'phong-viewer/playwright';

test('lamp', async ({ page }) => {
  await page.goto(${JSON.stringify(address)});
  const viewer = page.locator('phong-viewer');
  await settled(viewer, { timeout: 60_000 });
  await expect(viewer).toBeVisible();
  await expect(viewer).toShowTheEquation({ codes: 1 });
  const [first, second] = [await snapshot(viewer, { width: 60, height: 40 }), await snapshot(viewer, { width: 60, height: 40 })];
  expect(first.equals(second)).toBe(true);
});
`;

test('phong-viewer/playwright judges a page in fresh projects of both module kinds @release', async () => {
  test.setTimeout(300_000);
  const project = freshProject(['@playwright/test']);
  const site = await startSite({
    '/some/where/': join(project.folder, 'node_modules/phong-viewer/dist'),
  });
  try {
    const address = site.page('<phong-viewer geometry="box"></phong-viewer>', {
      head: '<script type="module" src="/some/where/phong-viewer.standalone.js"></script>',
    });
    const use = { launchOptions: await launchOptions('', []) };
    project.write(
      'playwright.config.ts',
      `export default ${JSON.stringify({ timeout: 120_000, use })};`,
    );
    project.write('lamp.spec.ts', spec(address));
    for (const type of ['module', 'commonjs']) {
      project.run(`npm pkg set type=${type}`);
      // The server of the page is in this process, which must not be blocked.
      expect(await project.runBeside('npx playwright test --reporter line')).toContain('1 passed');
    }
  } finally {
    await site.close();
    await project.remove();
  }
});
