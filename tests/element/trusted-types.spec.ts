// Does everything work on a page that forbids every Trusted Types policy? The page's own script avoids the sinks too.

import { expect, strictPolicy, test } from '../support/test.js';
import { button, panelOf } from './panel-rows.js';
import type { PhongViewer } from './support.js';

test("panel, models, Draco, messages and copied HTML work under trusted-types 'none'", async ({
  mount,
  consoleGuard,
}) => {
  consoleGuard.allow(/404/, 1);
  // No worker starts without a policy, and the browser reports the attempt. Draco is then decoded on the main thread.
  consoleGuard.allow(/requires 'TrustedScriptURL'/, 1);
  consoleGuard.allow(/requires 'TrustedHTML'/, 1);
  consoleGuard.allow(/refused trusted-types-sink/, 2);
  const viewer = await mount(
    `<phong-viewer gui helpers alt="A bunny" src="/assets/models/bunny.glb" poster="data:image/gif;base64,R0lGODlhAQABAAAAACw=">
      <phong-light name="lamp" diffuse="#fc8" position="2 2 0 1" aperture="60"></phong-light>
      <phong-mesh src="/fixtures/models/textured.glb" position="0.2 0 0"></phong-mesh>
      <phong-mesh geometry="teapot" ka="oklch(0.7 0.1 200)"></phong-mesh></phong-viewer>`,
    { csp: `${strictPolicy}; require-trusted-types-for 'script'; trusted-types 'none'` },
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
  const loaded = await viewer.evaluate(async (element: PhongViewer) => {
    await element.toBlob({ helpers: true });
    await element.shadeAt(300, 200);
    return element.loaded;
  });
  expect(loaded).toBe(true);
  await button(panelOf(viewer), 'add light').click();
  await button(panelOf(viewer), 'copy HTML').click();
  await expect(panelOf(viewer).getByRole('button', { name: /copied|select/ })).toBeVisible();
  expect(await viewer.evaluate((element: PhongViewer) => element.lights.length)).toBe(2);
  await viewer.evaluate((element: PhongViewer) => (element.src = '/fixtures/models/not-there.glb'));
  await expect(viewer.locator('[part=notice]')).toBeVisible();
});
