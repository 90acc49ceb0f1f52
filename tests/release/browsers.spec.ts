// Do element, camera, panel, models and pictures work in Firefox and in WebKitGTK with software GL?
// Runs the checks of browser-checks.ts, each on its own page under the strict policy.
import { expect, test } from '@playwright/test';
import { startSite, strictPolicy, testMounts, type Site } from '../support/site.js';
import { allReady, CHECKS } from './browser-checks.js';
import { STARTS, type Tab } from './tabs.js';

for (const [name, start] of Object.entries(STARTS)) {
  test.describe(`@release ${name}`, () => {
    let site: Site | undefined;
    let tab: Tab | undefined;

    // One worker, and so one browser and one screen.
    test.describe.configure({ mode: 'default', timeout: 600_000 });

    test.beforeAll(async () => {
      site = await startSite(testMounts);
      tab = await start();
      console.log(tab.browser);
    });

    test.afterAll(async () => {
      await tab?.close();
      await site?.close();
    });

    for (const {
      title,
      markup,
      size = { width: 600, height: 400 },
      display = 'block',
      csp = strictPolicy,
      holds,
      said = /^$/,
    } of CHECKS) {
      test(title, async () => {
        if (site === undefined || tab === undefined) throw new Error(`${name} did not start`);
        await tab.open(
          site.page(markup, {
            csp,
            head: '<script src="/fixtures/said.js"></script><script type="module" src="/dist/phong-viewer.standalone.js"></script>',
            css: `body { margin: 0; background: white } div { height: 5000px }
              phong-viewer { display: ${display}; width: ${size.width}px; height: ${size.height}px }`,
          }),
        );
        await allReady(tab);
        await holds(tab);
        const lines = await tab.run(() => (window as unknown as { said: string[] }).said);
        expect(lines.filter((line) => !said.test(line))).toEqual([]);
      });
    }
  });
}
