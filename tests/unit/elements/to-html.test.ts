// @vitest-environment happy-dom
// Does toHTML write the scene as it is, and nothing else of the page?

import { expect, it } from 'vitest';
import { onPage, partOf } from './on-page.js';

it('toHTML keeps id, class, style, wrappers and the order of the children', async () => {
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
  const viewer = await onPage(markup);
  expect(viewer.toHTML()).toBe(markup);
  viewer.append(Object.assign(document.createElement('p'), { textContent: 'of the page' }));
  const host = document.createElement('my-ball');
  viewer.querySelector('.ball')!.replaceWith(host);
  host.attachShadow({ mode: 'closed' }).append(document.createElement('phong-mesh'));
  expect(viewer.toHTML()).toBe(
    markup.replace(
      '<phong-mesh class="ball" geometry="sphere"></phong-mesh>',
      '<div>\n        <phong-mesh></phong-mesh>\n      </div>',
    ),
  );
});

it('toHTML writes all that is declared', async () => {
  const markup = `<phong-viewer alt="A &#34;scene&#34; &#38; &#60;more&#62;" theta="30" phi="70" radius="auto" target="auto" fov="50" orbit="false" auto-rotate="0" shading="flat" terms="ambient diffuse" color-interpolation="linear" antialias="full">
  <phong-mesh name="a&#34;b" kd="220 100 50" shininess="7" geometry="torus" rotation="10 20 30"></phong-mesh>
  <phong-mesh geometry="plane" position="0 -0.5 0" scale="3 3 3" shading="gouraud" reflection="blinn-phong"></phong-mesh>
  <phong-light name="sun" ambient="20 20 25" diffuse="180 180 170" position="1 2 1 0"></phong-light>
  <phong-light active="false" position="0 3 3 1" axis="0 -1 -1" aperture="20" cutoff="12" attenuation="1 0.1 0.05" space="camera"></phong-light>
</phong-viewer>`;
  expect((await onPage(markup)).toHTML()).toBe(markup);
});

it('toHTML writes auto until the camera moves, and as many digits as the picture needs', async () => {
  const viewer = await onPage(
    '<phong-viewer alt="" geometry="box"><phong-light></phong-light></phong-viewer>',
  );
  expect(viewer.toHTML()).toContain('theta="30" phi="70" radius="auto" target="auto"');
  viewer.target = [0, 0.5, 0];
  expect(viewer.toHTML()).toContain('radius="auto" target="0 0.5 0"');
  partOf(viewer, '.surface')!.dispatchEvent(new KeyboardEvent('keydown', { key: 'ArrowLeft' }));
  expect(viewer.toHTML()).not.toContain('auto');
  Object.assign(viewer.lights[0]!, { position: [0.1 + 0.2, 1 / 3, 1e-7 / 3, 1], cutoff: 100 / 3 });
  expect(viewer.toHTML()).toContain('position="0.3 0.33333333 3.3333333e-8 1"');
  expect(viewer.toHTML()).toContain('cutoff="33.3333333"');
  // Far from the origin a coordinate keeps the digits that count at the camera's distance.
  viewer.radius = 4;
  viewer.target = [1e6 + 1 / 3, 0, 0];
  const text = viewer.toHTML();
  expect(text).toContain('target="1000000.3333333 0 0"');
  expect((await onPage(text)).toHTML()).toBe(text);
});

it('lights are listed at once, frozen, and unnamed ones are named by their place', async () => {
  const plain = '<phong-light></phong-light>';
  const viewer = await onPage(
    `<phong-viewer alt="">${plain}<phong-light name="red"></phong-light><phong-mesh></phong-mesh>${plain}</phong-viewer>`,
  );
  const names = () => viewer.lights.map(({ name }) => name).join();
  const { lights } = viewer;
  expect(viewer.lights).toBe(lights);
  expect(Object.isFrozen(lights)).toBe(true);
  expect(names()).toBe('light 1,red,light 3');
  lights[0]!.remove();
  expect(names()).toBe('red,light 2');
  viewer.lights[0]!.removeAttribute('name');
  viewer.prepend(document.createElement('phong-light'));
  expect(names()).toBe('light 1,light 2,light 3');
  expect(lights).toHaveLength(3);
});
