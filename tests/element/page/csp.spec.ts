// Does everything work under a strict Content-Security-Policy, without requests to other servers? Any console line and
// any policy report fails the test; this page has all parts that could cause one.

import { expect, strictPolicy, test } from '../../support/test.js';
import { type PhongViewer } from '../support/viewer.js';

test('panel, Draco bunny, embedded textures, poster and messages work under a strict policy', async ({
  page,
  site,
  mount,
}) => {
  expect(strictPolicy).toBe(
    "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' blob: data:; connect-src 'self'",
  );
  const requests: string[] = [];
  page.on('request', (request) => requests.push(request.url()));
  const viewer = await mount(
    `<phong-viewer gui alt="A bunny" src="/assets/models/bunny.glb" poster="data:image/gif;base64,R0lGODlhAQABAAAAACw=">
      <phong-light name="lamp" diffuse="#fc8" position="2 2 0 1" aperture="60"></phong-light>
      <phong-mesh src="/fixtures/models/textured.glb" position="0.2 0 0"></phong-mesh>
      <phong-mesh src="/fixtures/models/data-uris.gltf" position="-0.2 0 0"></phong-mesh>
      <phong-mesh src="/fixtures/models/beside/quad.gltf" position="0 0.2 0"></phong-mesh>
      <phong-mesh geometry="teapot" ka="oklch(0.7 0.1 200)"></phong-mesh>
      <phong-mesh geometry="torus-knot"></phong-mesh></phong-viewer>`,
  );
  await expect(viewer.locator('[part=panel] *').first()).toBeVisible();
  const facts = await viewer.evaluate(async (element: PhongViewer) => {
    element.style.width = '500px';
    await element.ready;
    await element.toBlob({ type: 'image/jpeg' });
    // toHTML would keep it, and the policy refuses style attributes in markup.
    element.removeAttribute('style');
    const copy = document.createElement('div');
    copy.innerHTML = element.toHTML();
    document.body.append(copy);
    await (copy.firstElementChild as PhongViewer).ready;
    return [element.loaded, element.meshes.length, (copy.firstElementChild as PhongViewer).loaded];
  });
  expect(facts).toEqual([true, 5, true]);
  const strays = requests.filter((url) => !url.startsWith(site.origin) && !url.startsWith('data:'));
  expect(strays).toEqual([]);
});

test('markup cannot make the element run script', async ({ page, mount }) => {
  await mount('<main></main>');
  const run = await page.evaluate(async () => {
    const text = '"><img src=x onerror="window.ran = true"><script>window.ran = true</script>';
    const viewer = document.createElement('phong-viewer');
    viewer.alt = text;
    viewer.setAttribute('aria-label', text);
    const light = Object.assign(document.createElement('phong-light'), { name: text });
    viewer.append(light);
    document.querySelector('main')?.append(viewer);
    await viewer.ready;
    const place = document.createElement('div');
    place.innerHTML = viewer.toHTML();
    document.body.append(place);
    await viewer.ready;
    const copied = place.querySelector('phong-light')?.name === text && place.children.length === 1;
    return { ran: 'ran' in window, copied };
  });
  expect(run).toEqual({ ran: false, copied: true });
});
