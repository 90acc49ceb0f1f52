// Does toHTML write the current scene, so that its markup gives the same picture and the same
// markup again?

import type { Locator, Page } from '@playwright/test';
import { compare, expect, pixels, test } from '../../support/test.js';
import { assign, drag, type PhongViewer, shownBy } from '../support/viewer.js';

const size = { width: 120, height: 80 };
const light = '<phong-light position="1 2 3 0" ambient="60"></phong-light>';
const box = `<phong-viewer geometry="box" kd="200 40 40">${light}</phong-viewer>`;

const rich = `<phong-viewer alt='A "scene" & <more>' fov="50" shading="flat" terms="ambient diffuse" orbit="false" color-interpolation="linear" antialias="full" auto-rotate="0">
    <phong-mesh name="a&quot;b" geometry="torus" rotation="10 20 30" kd="hsl(20 80% 60%)" shininess="7"></phong-mesh>
    <phong-mesh geometry="plane" position="0 -0.5 0" scale="3" reflection="blinn-phong" shading="gouraud"></phong-mesh>
    <phong-light name="sun" position="1 2 1 0" ambient="20 20 25" diffuse="180 180 170"></phong-light>
    <phong-light position="0 3 3" axis="0 -1 -1" aperture="20" cutoff="12" attenuation="1 0.1 0.05" space="camera"></phong-light>
    <phong-light active="false" diffuse="#f00"></phong-light></phong-viewer>`;

const html = (viewer: Locator): Promise<string> =>
  viewer.evaluate((element: PhongViewer) => element.toHTML());

async function roundTrip(page: Page, viewer: Locator): Promise<void> {
  const before = await pixels(viewer, size);
  const text = await html(viewer);
  expect(compare(await shownBy(page, text, size), before).max).toBe(0);
  const again = await page.evaluate((markup) => {
    const place = document.createElement('div');
    place.innerHTML = markup;
    document.body.append(place);
    const text = place.querySelector('phong-viewer')?.toHTML();
    place.remove();
    return text;
  }, text);
  expect(again).toBe(text);
}

test('toHTML gives the same picture, and the same markup again', async ({ page, mount }) => {
  const viewer = await mount(rich, size);
  await roundTrip(page, viewer);
  const text = await html(viewer);
  for (const part of ['name="sun"', 'active="false"', 'orbit="false"', 'antialias="full"']) {
    expect(text).toContain(part);
  }
  expect(text).not.toContain('<more>');
});

test('toHTML keeps id, class, style, wrappers and the order of the children', async ({
  page,
  mount,
}) => {
  const markup = `<phong-viewer id="scene" class="a b" style="color: red" alt="A ball" theta="20" phi="70" radius="auto" target="auto">
  <phong-light id="first" name="one"></phong-light>
  <div id="rig" class="rig" style="color: blue">
    <section>
      <phong-mesh class="ball" geometry="sphere"></phong-mesh>
    </section>
    <phong-light style="--x: 1" position="0 1 0 1"></phong-light>
  </div>
  <phong-mesh geometry="box" position="1 0 0"></phong-mesh>
</phong-viewer>`;
  const viewer = await mount(markup, { ...size, csp: '' });
  expect(await html(viewer)).toBe(markup);
  await viewer.evaluate((element) => {
    element.append(Object.assign(document.createElement('p'), { textContent: 'of the page' }));
    element.querySelector('.ball')!.replaceWith(document.createElement('my-ball'));
    const ball = document.createElement('phong-mesh');
    element.querySelector('my-ball')!.attachShadow({ mode: 'closed' }).append(ball);
  });
  expect(await html(viewer)).toBe(
    markup.replace(
      '<phong-mesh class="ball" geometry="sphere"></phong-mesh>',
      '<div>\n        <phong-mesh></phong-mesh>\n      </div>',
    ),
  );
  await page.evaluate(() => document.querySelector('my-ball')!.remove());
});

test('toHTML writes auto until the camera moves, and as many digits as the picture needs', async ({
  page,
  mount,
}) => {
  const viewer = await mount(box, size);
  expect(await html(viewer)).toContain('theta="30" phi="70" radius="auto" target="auto"');
  await assign(viewer, { target: [0, 0.5, 0] });
  expect(await html(viewer)).toContain('radius="auto" target="0 0.5 0"');
  await drag(page, [60, 40], [37, 11]);
  expect(await html(viewer)).not.toContain('auto');
  const light = viewer.locator('phong-light');
  await assign(light, { position: [0.1 + 0.2, 1 / 3, 1e-7 / 3, 1], cutoff: 100 / 3 });
  expect(await html(viewer)).toContain('position="0.3 0.33333333 3.3333333e-8 1"');
  expect(await html(viewer)).toContain('cutoff="33.3333333"');
  // Far from the origin a coordinate keeps the digits that count at the camera's distance.
  await assign(viewer, { radius: 4, target: [1e6 + 1 / 3, 0, 0] });
  expect(await html(viewer)).toContain('target="1000000.3333333 0 0"');
  await roundTrip(page, viewer);
});

/** Two frames, in which events that wait for one arrive. */
const frames = (viewer: Locator): Promise<void> =>
  viewer.evaluate(async () => {
    for (let i = 0; i < 2; i++) {
      await new Promise(requestAnimationFrame);
    }
  });

test('what the user moved is where toHTML says, to the last bit', async ({ page, mount }) => {
  const viewer = await mount(
    '<phong-viewer geometry="torus" fov="37" gui="radius"></phong-viewer>',
    {
      width: 713,
      height: 407,
    },
  );
  const moves = [
    () => drag(page, [300, 200], [37, 11]),
    () => drag(page, [300, 200], [-401, 53]),
    () => drag(page, [200, 200], [29, -67]),
    () => page.mouse.wheel(0, 137),
    () => page.keyboard.press('ArrowLeft'),
    () => page.keyboard.press('+'),
    () => viewer.getByRole('textbox', { name: 'radius', exact: true }).fill('3.123456789123'),
  ];
  for (const move of moves) {
    await move();
    await frames(viewer);
    const { written, camera } = await viewer.evaluate((element: PhongViewer) => {
      const parsed = new DOMParser().parseFromString(element.toHTML(), 'text/html');
      const text = (name: string) => parsed.body.firstElementChild!.getAttribute(name)!;
      return {
        written: ['theta', 'phi', 'radius', 'target'].map((name) =>
          text(name).split(' ').map(Number),
        ),
        camera: [
          element.camera.theta,
          element.camera.phi,
          element.camera.radius,
          element.camera.target,
        ].flat(),
      };
    });
    expect(camera).toEqual(written.flat());
  }
});
