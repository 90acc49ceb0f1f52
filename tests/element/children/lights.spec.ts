// Do lights match the markup, however it was created and changed? Small pictures of a plane seen from above are
// compared with those of the same scene in markup.

import type { Locator } from '@playwright/test';
import { allReady, expect, pixels, test } from '../../support/test.js';
import { type PhongViewer, record } from '../support/viewer.js';
import { green, red, same, shown, size } from './plane-scene.js';

const open = '<phong-viewer geometry="plane" kd="255" theta="0" phi="40" radius="1.2" target="0 0 0">';
const spot =
  '<phong-light diffuse="90 90 255" position="0 1 0" axis="0 -1 0" aperture="20" cutoff="3"></phong-light>';
const scene = (...lights: readonly string[]): string => `${open}${lights.join('')}</phong-viewer>`;

const names = (viewer: Locator): Promise<string[]> =>
  viewer.evaluate((element: PhongViewer) => element.lights.map((light) => light.name));

test.describe('changes', () => {
  test('are in the next picture on the screen, not only in toBlob', async ({ page, mount }) => {
    const viewer = await mount(scene(red), size);
    const before = await viewer.screenshot();
    await viewer.evaluate((element: PhongViewer) => (element.lights[0]!.diffuse = [0, 200, 0]));
    await allReady(page);
    expect(Buffer.compare(await viewer.screenshot(), before)).not.toBe(0);
    await viewer.evaluate((element: PhongViewer) => (element.lights[0]!.diffuse = [200, 0, 0]));
    await allReady(page);
    expect(Buffer.compare(await viewer.screenshot(), before)).toBe(0);
  });
});

test.describe('the head-light', () => {
  test('shines only in viewers without any phong-light, and is in neither lights nor toHTML', async ({
    page,
    mount,
  }) => {
    const head = '<phong-light space="camera" position="0 0 1 0"></phong-light>';
    const viewer = await mount(scene(), size);
    const wanted = await shown(page, scene(head));
    same(await pixels(viewer), wanted);
    expect(
      await viewer.evaluate((element: PhongViewer) => [element.lights.length, element.toHTML()]),
    ).toEqual([0, expect.not.stringContaining('phong-light')]);
    await viewer.evaluate((element, html) => (element.innerHTML = html), red);
    same(await pixels(viewer), await shown(page, scene(red)));
    await viewer.evaluate((element) => element.replaceChildren());
    same(await pixels(viewer), wanted);
  });

  test('never flashes when lights are appended at once', async ({ page, mount }) => {
    await mount('<main></main>');
    const frames = await page.evaluate(async () => {
      const element = document.createElement('phong-viewer');
      element.geometry = 'plane';
      const sent: number[] = [];
      element.addEventListener('render', () => sent.push(element.stats.lightsActive));
      document.querySelector('main')?.append(element);
      element.append(
        Object.assign(document.createElement('phong-light'), { active: false }),
        Object.assign(document.createElement('phong-light'), { active: false }),
      );
      await element.ready;
      return sent;
    });
    expect(frames).toEqual([0]);
  });
});

test.describe('lights', () => {
  test('are listed in document order, frozen, at once after a change', async ({ mount }) => {
    const viewer = await mount(scene(red, `<div>${spot}</div>`, green, '<p>Text</p>'), size);
    const facts = await viewer.evaluate((element: PhongViewer) => {
      const before = element.lights;
      const again = element.lights === before;
      const added = document.createElement('phong-light');
      element.prepend(added);
      const { lights } = element;
      return {
        again,
        frozen: Object.isFrozen(lights),
        first: lights[0] === added,
        counts: [before.length, lights.length],
      };
    });
    expect(facts).toEqual({ again: true, frozen: true, first: true, counts: [3, 4] });
  });

  test('without a name are named by their number', async ({ mount }) => {
    const plain = '<phong-light></phong-light>';
    const viewer = await mount(scene(plain, red, '<phong-mesh></phong-mesh>', plain), size);
    expect(await names(viewer)).toEqual(['light 1', 'red', 'light 3']);
    await viewer.evaluate((element: PhongViewer) => element.lights[0]?.remove());
    expect(await names(viewer)).toEqual(['red', 'light 2']);
    await viewer.evaluate((element: PhongViewer) => element.lights[0]?.removeAttribute('name'));
    expect(await names(viewer)).toEqual(['light 1', 'light 2']);
  });
});

test('light-change lists the lights that were written to, and none when lights are added or removed', async ({
  mount,
}) => {
  const viewer = await mount(scene(red, green), size);
  const events = await record(viewer, 'light-change');
  const change = { type: 'light-change' };
  await viewer.evaluate((element: PhongViewer) => {
    element.lights[0]!.cutoff = 3;
    element.lights[0]!.aperture = 30;
  });
  expect(await events.take()).toEqual([{ ...change, detail: { lights: ['<phong-light>'] } }]);
  await viewer.evaluate((element: PhongViewer) => (element.lights[0]!.cutoff = 3));
  expect(await events.take()).toEqual([]);
  await viewer.evaluate((element: PhongViewer) => element.lights[0]?.remove());
  await expect.poll(() => events.take()).toEqual([{ ...change, detail: { lights: [] } }]);
});
