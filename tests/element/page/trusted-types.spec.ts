// Pages under a strict Content-Security-Policy, which every test's page has, and under Trusted
// Types: everything works where Lit's policy is allowed, and one sentence says so where it is not.
// The page's own script avoids the sinks too.

import type { Page } from '@playwright/test';
import { usages } from '../../package/requests.js';
import { expect, type Site, strictPolicy, test } from '../../support/test.js';
import { button, panelOf } from '../../extras/panel/panel-rows.js';
import type { PhongViewer } from '../support/viewer.js';
import { requestsOf } from '../../support/requests.js';
import { assign } from '../support/viewer.js';

const trusted = (policies: string) =>
  `require-trusted-types-for 'script'; trusted-types ${policies}`;

test('a viewer works under a strict policy and trusted-types lit-html', async ({
  page,
  site,
  mount,
  consoleGuard,
}) => {
  expect(strictPolicy).toBe(
    "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' blob: data:; connect-src 'self'",
  );
  const requests = requestsOf(page);
  consoleGuard.allow(/404/, 1);
  // No worker starts without a policy of its own, and the browser reports the attempt. Draco is
  // then decoded on the main thread.
  consoleGuard.allow(/requires 'TrustedScriptURL'/, 1);
  consoleGuard.allow(/requires 'TrustedHTML'/, 1);
  consoleGuard.allow(/refused trusted-types-sink/, 2);
  const viewer = await mount(
    `<phong-viewer gui helpers alt="A bunny" src="/assets/models/bunny.glb" poster="data:image/gif;base64,R0lGODlhAQABAAAAACw=">
      <phong-light name="lamp" diffuse="#fc8" position="2 2 0 1" aperture="60"></phong-light>
      <phong-mesh src="/fixtures/models/textured.glb" position="0.2 0 0"></phong-mesh>
      <phong-mesh src="/fixtures/models/data-uris.gltf" position="-0.2 0 0"></phong-mesh>
      <phong-mesh src="/fixtures/models/beside/quad.gltf" position="0 0.2 0"></phong-mesh>
      <phong-mesh geometry="torus-knot"></phong-mesh>
      <phong-mesh geometry="teapot" ka="oklch(0.7 0.1 200)"></phong-mesh></phong-viewer>`,
    { csp: `${strictPolicy}; ${trusted('lit-html')}` },
  );
  // The policy is in force: assigning text to a sink throws.
  const refused = await viewer.evaluate(() => {
    try {
      document.createElement('p').innerHTML = 'text';
      return '';
    } catch (error) {
      return String(error);
    }
  });
  expect(refused).toContain('TrustedHTML');
  const loaded = await viewer.evaluate(async (element) => {
    await element.toBlob({ helpers: true });
    await element.shadeAt(300, 200);
    return element.loaded;
  });
  expect(loaded).toBe(true);
  await button(panelOf(viewer), 'add light').click();
  await button(panelOf(viewer), 'copy HTML').click();
  await expect(panelOf(viewer).getByRole('button', { name: /copied|select/ })).toBeVisible();
  expect(await viewer.evaluate((element) => element.lights.length)).toBe(2);
  await assign(viewer, { src: '/fixtures/models/not-there.glb' });
  await expect(viewer.locator('[part=notice]')).toBeVisible();
  expect(
    requests.filter((url) => !url.startsWith(site.origin) && !url.startsWith('data:')),
  ).toEqual([]);
});

const box = '<phong-viewer geometry="box" alt="A box"></phong-viewer>';

/** What a page with this head says on its console, and whether it has the elements. */
async function loaded(
  { page, site }: { page: Page; site: Site },
  policies: string,
  head: string,
): Promise<{ readonly said: readonly string[]; readonly defined: boolean }> {
  const said: string[] = [];
  page.on('console', (message) => said.push(message.text()));
  await page.goto(site.page(box, { csp: trusted(policies), head }));
  const defined = await page.evaluate(async () => {
    // The browser reports a refused policy in a task of its own.
    await new Promise((resolve) => setTimeout(resolve, 50));
    const viewer = document.querySelector('phong-viewer') as Partial<PhongViewer> | null;
    await viewer?.ready;
    return viewer?.loaded === true;
  });
  return { said: said.filter((text) => text.includes('<phong-viewer>')), defined };
}

const scripts = {
  standalone: '<script type="module" src="/dist/phong-viewer.standalone.js"></script>',
  modules: usages.modules.head!,
  classic: '<script src="/dist/phong-viewer.classic.js" defer></script>',
  ownLit: '<script type="module" src="/node_modules/lit-html/lit-html.js"></script>',
} as const;

/** What the browser and the package say where a policy is refused. */
const REFUSED =
  /TrustedTypePolicy|createPolicy|refused trusted-types|Allow it by trusted-types lit-html/;

test("where Lit's policy is refused, one sentence says what to allow", async ({
  page,
  site,
  consoleGuard,
}) => {
  consoleGuard.allow(REFUSED);
  for (const usage of ['standalone', 'modules', 'classic'] as const) {
    const { said, defined } = await loaded({ page, site }, "'none'", scripts[usage]);
    expect(defined, usage).toBe(false);
    expect(said, usage).toHaveLength(1);
    expect(said[0], usage).toMatch(
      /Allow it by trusted-types lit-html, or, if the page has another copy of Lit, by trusted-types lit-html 'allow-duplicates'/,
    );
  }
});

test("two copies of Lit need 'allow-duplicates', in either order", async ({
  page,
  site,
  consoleGuard,
}) => {
  consoleGuard.allow(REFUSED);
  const copies = [
    ['standalone', 'classic'],
    ['ownLit', 'standalone'],
    ['standalone', 'ownLit'],
  ] as const;
  for (const [first, second] of copies) {
    const head = scripts[first] + scripts[second];
    const both = await loaded({ page, site }, "lit-html 'allow-duplicates'", head);
    expect(both, `${first}, ${second}`).toEqual({ said: [], defined: true });
    // The first copy has the policy; the elements are missing only where that copy is not one of
    // this package.
    const one = await loaded({ page, site }, 'lit-html', head);
    expect(one.defined, `${first}, ${second}`).toBe(first !== 'ownLit');
    expect(one.said, `${first}, ${second}`).toHaveLength(first === 'ownLit' ? 1 : 0);
  }
});
