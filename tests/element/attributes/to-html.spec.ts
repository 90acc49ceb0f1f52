// Does toHTML write the current scene, so that its markup gives the same picture and the same
// markup again? unit/elements/to-html.test.ts has what takes no picture.

import type { Page } from '@playwright/test';
import { type ViewerLocator, expect, pixels, same, test } from '../../support/test.js';
import { drag, htmlOf, nextFrame, shownBy } from '../support/viewer.js';

const size = { width: 120, height: 80 };

const rich = `<phong-viewer alt='A "scene" & <more>' fov="50" shading="flat" terms="ambient diffuse" orbit="false" color-interpolation="linear" antialias="full" auto-rotate="0">
    <phong-mesh name="a&quot;b" geometry="torus" rotation="10 20 30" kd="hsl(20 80% 60%)" shininess="7"></phong-mesh>
    <phong-mesh geometry="plane" position="0 -0.5 0" scale="3" reflection="blinn-phong" shading="gouraud"></phong-mesh>
    <phong-light name="sun" position="1 2 1 0" ambient="20 20 25" diffuse="180 180 170"></phong-light>
    <phong-light position="0 3 3" axis="0 -1 -1" aperture="20" cutoff="12" attenuation="1 0.1 0.05" space="camera"></phong-light>
    <phong-light active="false" diffuse="#f00"></phong-light></phong-viewer>`;

async function roundTrip(page: Page, viewer: ViewerLocator) {
  const before = await pixels(viewer, size);
  const text = await htmlOf(viewer);
  same(await shownBy(page, text, size), before);
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
  const text = await htmlOf(viewer);
  for (const part of ['name="sun"', 'active="false"', 'orbit="false"', 'antialias="full"']) {
    expect(text).toContain(part);
  }
  expect(text).not.toContain('<more>');
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
    await nextFrame(page); // events that wait for one
    const { written, camera } = await viewer.evaluate((element) => {
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
