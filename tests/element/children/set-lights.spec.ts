// Does setLights make the viewer's lights exactly those that it is given, or change nothing?

import type { Locator } from '@playwright/test';
import { compare, expect, pixels, test } from '../../support/test.js';
import type { PhongViewer } from '../support/viewer.js';

const SCENE = `<phong-viewer geometry="sphere">
  <phong-light name="sun" position="1 2 3 0" diffuse="red" aperture="40"></phong-light>
  <div><phong-light name="lamp" position="0 1 1 1"></phong-light></div>
  <phong-light position="0 0 1 0"></phong-light>
</phong-viewer>`;
const SIZE = { width: 120, height: 80 };

const lights = (viewer: Locator): Promise<unknown> =>
  viewer.evaluate((element: PhongViewer) =>
    element.lights.map(({ name, position, diffuse, aperture }) => [
      name,
      position.join(' '),
      diffuse.join(' '),
      aperture,
    ]),
  );

test('changes, adds and removes lights by name; what a light leaves out is the default', async ({
  mount,
}) => {
  const viewer = await mount(SCENE, SIZE);
  const told = await viewer.evaluate(async (element: PhongViewer) => {
    const [sun, lamp] = element.lights;
    const events: unknown[] = [];
    element.addEventListener('light-change', ({ detail }) => events.push(detail.lights.length));
    element.setLights({
      spot: { position: [0, 2, 0], aperture: 30, diffuse: '#08f' },
      sun: { position: new Float32Array([0, 1, 0, 0]), ambient: 20 },
    });
    await element.ready;
    return {
      same: element.lights[0] === sun,
      gone: lamp!.isConnected,
      events,
      parent: element.lights[1]!.parentElement === element,
    };
  });
  expect(told).toEqual({ same: true, gone: false, events: [1], parent: true });
  expect(await lights(viewer)).toEqual([
    ['sun', '0 1 0 0', '255 255 255', 180],
    ['spot', '0 2 0 1', '0 136 255', 30],
  ]);
});

test('the same call gives the same picture, whatever was there', async ({ mount }) => {
  const wanted = { a: { position: '1 1 1 0', diffuse: 120 }, b: { position: [-1, 0, 1, 1] } };
  const set = (viewer: Locator): Promise<void> =>
    viewer.evaluate((element: PhongViewer, given) => {
      element.setLights(given);
      return element.ready;
    }, wanted);
  const first = await mount(SCENE.replace('name="lamp"', 'name="a" cutoff="9"'), SIZE);
  await set(first);
  const before = await pixels(first);
  const second = await mount('<phong-viewer geometry="sphere"></phong-viewer>', SIZE);
  await set(second);
  expect(compare(await pixels(second), before).max).toBe(0);
  await second.evaluate((element: PhongViewer) => element.setLights({}));
  expect(await lights(second)).toEqual([]);
});

test('a bad value, an unknown one or another kind of thing throws and changes nothing', async ({
  mount,
}) => {
  const viewer = await mount(SCENE, SIZE);
  const before = await lights(viewer);
  const refused = (given: unknown): Promise<string> =>
    viewer.evaluate((element: PhongViewer, value) => {
      try {
        element.setLights(value as never);
        return 'accepted';
      } catch (error) {
        return String(error);
      }
    }, given);
  const good = { sun: { position: [9, 9, 9, 0] }, other: {} };
  for (const [given, message] of [
    [{ ...good, lamp: { aperture: 200 } }, /^RangeError: <phong-light>.aperture: .*180.*200/],
    [{ ...good, lamp: { diffuse: 'orangish' } }, /^TypeError: <phong-light>.diffuse: .*orangish/],
    [{ ...good, lamp: { positon: [0, 0, 1] } }, /"positon".*Did you mean "position"\?/],
    [{ ...good, lamp: { colour: 'red' } }, /^TypeError: there is no value named "colour"/],
    [{ ...good, lamp: 5 }, /^TypeError: setLights: expected an object, got 5/],
    [{ ...good, lamp: null }, /^TypeError: setLights: expected an object, got null/],
    [[{ name: 'sun' }], /^TypeError: setLights: expected an object, got \[an object\]/],
    [null, /^TypeError: setLights: expected an object, got null/],
  ] as const) {
    expect(await refused(given), JSON.stringify(given)).toMatch(message);
    expect(await lights(viewer)).toEqual(before);
  }
});
