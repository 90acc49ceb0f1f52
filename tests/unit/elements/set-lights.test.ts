// @vitest-environment happy-dom
// Does setLights make the viewer's lights exactly those that it is given, or change nothing?

import { expect, it } from 'vitest';
import type { PhongViewer } from '../../../src/viewer/index.js';
import { onPage } from './on-page.js';

const SCENE = `<phong-viewer alt="" geometry="sphere">
  <phong-light name="sun" position="1 2 3 0" diffuse="255 0 0" aperture="40"></phong-light>
  <div><phong-light name="lamp" position="0 1 1 1"></phong-light></div>
  <phong-light position="0 0 1 0"></phong-light>
</phong-viewer>`;

const lights = ({ lights }: PhongViewer) =>
  lights.map(({ name, position, diffuse, aperture }) => [
    name,
    position.join(' '),
    diffuse.join(' '),
    aperture,
  ]);

it('changes, adds and removes lights by name; what a light leaves out is the default', async () => {
  const viewer = await onPage(SCENE);
  const [sun, lamp] = viewer.lights;
  const events: unknown[] = [];
  viewer.addEventListener('light-change', ({ detail }) => events.push(detail.lights.length));
  viewer.setLights({
    spot: { position: [0, 2, 0], aperture: 30, diffuse: [0, 136, 255] },
    sun: { position: new Float32Array([0, 1, 0, 0]), ambient: 20 },
  });
  await viewer.ready;
  expect(viewer.lights[0]).toBe(sun);
  expect(lamp!.isConnected).toBe(false);
  expect(events).toEqual([1]);
  expect(viewer.lights[1]!.parentElement).toBe(viewer);
  expect(lights(viewer)).toEqual([
    ['sun', '0 1 0 0', '255 255 255', 180],
    ['spot', '0 2 0 1', '0 136 255', 30],
  ]);
});

it('the same call gives the same lights, whatever was there', async () => {
  const wanted = { a: { position: '1 1 1 0', diffuse: 120 }, b: { position: [-1, 0, 1, 1] } };
  const given = async (markup: string) => {
    const viewer = await onPage(markup);
    viewer.setLights(wanted);
    return viewer.toHTML().match(/<phong-light.*?>/g);
  };
  const before = await given(SCENE.replace('name="lamp"', 'name="a" cutoff="9"'));
  expect(before).toEqual(await given('<phong-viewer alt="" geometry="sphere"></phong-viewer>'));
  const viewer = document.querySelector('phong-viewer')!;
  viewer.setLights({});
  expect(viewer.lights).toEqual([]);
});

const good = { sun: { position: [9, 9, 9, 0] }, other: {} };

it.each([
  [{ ...good, lamp: { aperture: 200 } }, /^RangeError: <phong-light>.aperture: .*180.*200/],
  [{ ...good, lamp: { diffuse: 'orangish' } }, /^TypeError: <phong-light>.diffuse: .*orangish/],
  [{ ...good, lamp: { positon: [0, 0, 1] } }, /"positon".*Did you mean "position"\?/],
  [{ ...good, lamp: { colour: 'red' } }, /^TypeError: there is no value named "colour"/],
  [{ ...good, lamp: 5 }, /^TypeError: setLights: expected an object, got 5/],
  [{ ...good, lamp: null }, /^TypeError: setLights: expected an object, got null/],
  [[{ name: 'sun' }], /^TypeError: setLights: expected an object, got \[an object\]/],
  [null, /^TypeError: setLights: expected an object, got null/],
])('%j throws and changes nothing', async (given, message) => {
  const viewer = await onPage(SCENE);
  const before = lights(viewer);
  const refused = await (async () => viewer.setLights(given as never))().catch(String);
  expect(refused).toMatch(message);
  expect(lights(viewer)).toEqual(before);
});
