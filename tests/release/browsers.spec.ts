// Do element, camera, panel, models and pictures work in Firefox and in WebKitGTK with software GL?
// Runs the checks of browser-checks.ts, each on its own page under the strict policy.
import { expect, test } from '@playwright/test';
import { strictPolicy } from '../support/site.js';
import { allReady, CHECKS } from './browser-checks.js';
import { inEachBrowser } from './tabs.js';

inEachBrowser(600_000, (open) => {
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
      const tab = await open(markup, {
        csp,
        head: '<script src="/fixtures/said.js"></script><script type="module" src="/dist/phong-viewer.standalone.js"></script>',
        css: `body { margin: 0; background: white } div { height: 5000px }
          phong-viewer { display: ${display}; width: ${size.width}px; height: ${size.height}px }`,
      });
      await allReady(tab);
      await holds(tab);
      const lines = await tab.run(() => (window as unknown as { said: string[] }).said);
      expect(lines.filter((line) => !said.test(line))).toEqual([]);
    });
  }
});
