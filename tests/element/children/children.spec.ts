// Which lights and meshes belong to a viewer? Those whose nearest enclosing viewer it is, at any depth and across
// shadow trees, in document order, however they come, move and go.

import type { Locator } from '@playwright/test';
import { allReady, compare, expect, pixels, test } from '../../support/test.js';
import { type PhongViewer } from '../support/viewer.js';
import { green, open, red, same, scene, shown, size } from './plane-scene.js';

const box = '<phong-mesh name="box" geometry="box" scale="0.3"></phong-mesh>';

const names = (viewer: Locator): Promise<string[]> =>
  viewer.evaluate((element: PhongViewer) => [...element.lights, ...element.meshes].map(({ name }) => name));

test.describe('children belong to the nearest viewer', () => {
  test('inside wrappers, and inside one another, as self-closed tags are parsed', async ({ page, mount }) => {
    const wrapped = `<div><p>${red}</p><span>${box}</span></div>${green}`;
    const viewer = await mount(scene(wrapped), size);
    expect(await names(viewer)).toEqual(['red', 'green', 'box']);
    same(await pixels(viewer), await shown(page, scene(red, box, green)));
    const selfClosed = [red, box, green].map((tag) => tag.replace(/><\/[^>]*>$/, '/>')).join('');
    same(await shown(page, scene(selfClosed)), await pixels(viewer));
  });

  test('in shadow trees, open and closed, before what the host contains', async ({ page, mount }) => {
    const viewer = await mount(scene(red), size);
    await viewer.evaluate(
      (element, [inner, outer]) => {
        const host = document.createElement('div');
        host.innerHTML = outer;
        const deeper = document.createElement('div');
        deeper.attachShadow({ mode: 'closed' }).innerHTML = inner;
        host.attachShadow({ mode: 'open' }).append(deeper);
        element.prepend(host);
      },
      [green, box.replace('box', 'mesh') + red.replace('red', 'outer')] as const,
    );
    expect(await names(viewer)).toEqual(['green', 'outer', 'red', 'mesh']);
    await page.evaluate(() => document.querySelector('phong-viewer > div')?.remove());
    expect(await names(viewer)).toEqual(['red']);
    same(await pixels(viewer), await shown(page, scene(red)));
  });

  test('where viewers are nested', async ({ page, mount, consoleGuard }) => {
    const warnings = consoleGuard.allow(/^warning: <phong-viewer> contains another <phong-viewer>/, 1);
    const inner = scene(green, box).replace('<phong-viewer', '<phong-viewer id="inner"');
    const outer = await mount(scene(red, inner), size);
    expect(await names(outer)).toEqual(['red']);
    expect(await names(page.locator('#inner'))).toEqual(['green', 'box']);
    await page.evaluate(() => {
      const light = document.querySelector('#inner > phong-light');
      if (light !== null) document.querySelector('phong-viewer')?.append(light);
    });
    expect(await names(outer)).toEqual(['red', 'green']);
    expect(await names(page.locator('#inner'))).toEqual(['box']);
    await expect.poll(() => warnings.length).toBe(1);
  });
});

test.describe('children do not belong to a viewer', () => {
  test('in the content of its slots, unless that contains a viewer itself', async ({
    page,
    mount,
    consoleGuard,
  }) => {
    const warnings = consoleGuard.allow(/is inside an element with a slot/, 2);
    const slotted = `<div slot="error"><p>${green}${box}</p>${scene(red).replace('<phong-viewer', '<phong-viewer id="inner"')}</div>`;
    const viewer = await mount(scene(slotted, red.replace('"red"', '"own"')), size);
    expect(await names(viewer)).toEqual(['own']);
    expect(await names(page.locator('#inner'))).toEqual(['red']);
    // From there and back.
    await page.evaluate(() => document.querySelector('phong-viewer')!.append(document.querySelector('[slot] phong-light')!)); // prettier-ignore
    expect(await names(viewer)).toEqual(['own', 'green']);
    await page.evaluate(() =>
      document.querySelector('[slot]')!.prepend(document.querySelector('phong-light')!),
    );
    expect(await names(viewer)).toEqual(['own', 'green']);
    await page.evaluate(() => document.querySelector('[slot]')!.append(...document.querySelector('phong-viewer')!.lights)); // prettier-ignore
    expect(await names(viewer)).toEqual([]);
    await expect
      .poll(() => [...warnings].sort())
      .toEqual([
        'warning: <phong-light name="green"> is inside an element with a slot, so it has no effect. Move it out of that element.',
        'warning: <phong-mesh name="box"> is inside an element with a slot, so it has no effect. Move it out of that element.',
      ]);
  });

  test('outside the document, and in elements with a mere `host` property', async ({ page, mount }) => {
    await mount('<main></main>', size);
    const found = await page.evaluate(() => {
      const link = document.createElement('a');
      link.href = 'https://example.test/';
      link.append(document.createElement('phong-light'));
      const fragment = document.createDocumentFragment();
      fragment.append(document.createElement('phong-mesh'));
      const viewer = document.createElement('phong-viewer');
      viewer.append(...link.children, fragment);
      const before = [viewer.lights.length, viewer.meshes.length];
      link.append(...viewer.children);
      return [...before, viewer.lights.length, viewer.meshes.length, (link.firstChild as Element & { name: string }).name]; // prettier-ignore
    });
    expect(found).toEqual([1, 1, 0, 0, 'light 1']);
  });
});

test.describe('children are found', () => {
  test('by a viewer that is defined later than they are', async ({ page, site, mount }) => {
    const wanted = await pixels(await mount(scene(`<div>${red}</div>`, green, box), size));
    await page.goto(site.page(scene(`<div>${red}</div>`, green, box), { css: 'phong-viewer { display: block; width: 60px; height: 40px }' })); // prettier-ignore
    await page.evaluate(async () => {
      // A copy of the package whose viewer is not defined until everything else is.
      const define = customElements.define.bind(customElements);
      let last = (): void => undefined;
      customElements.define = (name, constructor) => {
        if (name === 'phong-viewer') last = () => define(name, constructor);
        else define(name, constructor);
      };
      const address = '/dist/phong-viewer.standalone.js';
      await import(address);
      await new Promise((resolve) => requestAnimationFrame(resolve));
      last();
    });
    await allReady(page);
    expect(await names(page.locator('phong-viewer'))).toEqual(['red', 'green', 'box']);
    same(await pixels(page.locator('phong-viewer')), wanted);
  });

  test('in a viewer outside the document, where they can be added and removed', async ({ page, mount }) => {
    await mount('<main></main>', size);
    const counts = await page.evaluate(() => {
      const viewer = document.createElement('phong-viewer');
      const wrapper = document.createElement('div');
      const lights = [1, 2, 3].map(() => document.createElement('phong-light'));
      wrapper.append(...lights);
      viewer.append(wrapper, document.createElement('phong-mesh'));
      const before = [viewer.lights.length, viewer.meshes.length, viewer.stats.lightsDeclared];
      lights[1]?.remove();
      return [...before, viewer.lights.length];
    });
    expect(counts).toEqual([3, 1, 3, 2]);
  });

  test('no longer when they were removed while the viewer was outside the document', async ({
    page,
    mount,
  }) => {
    const viewer = await mount(scene(red, green, box), size);
    const facts = await viewer.evaluate(async (element: PhongViewer) => {
      const parent = element.parentElement;
      element.remove();
      element.lights[0]?.remove();
      element.meshes[0]?.remove();
      parent?.append(element);
      await element.ready;
      return [element.lights.length, element.meshes.length];
    });
    expect(facts).toEqual([1, 0]);
    same(await pixels(viewer), await shown(page, scene(green)));
  });
});

test.describe('moves of children', () => {
  test('with moveBefore keep everything and update the order', async ({ mount }) => {
    const viewer = await mount(`<main></main>${scene(red, green, box)}`, size);
    const before = await pixels(viewer);
    const events = await viewer.evaluate((element) => {
      const heard: string[] = [];
      for (const type of ['load', 'error', 'camera-change'])
        element.addEventListener(type, () => heard.push(type));
      Object.assign(window, { heard });
      type Mover = Element & { moveBefore(node: Node, before: Node | null): void };
      (element as unknown as Mover).moveBefore(element.firstElementChild!, null);
      (document.querySelector('main') as unknown as Mover).moveBefore(element, null);
      return heard;
    });
    expect(await names(viewer)).toEqual(['green', 'red', 'box']);
    expect(events).toEqual([]);
    expect(compare(await pixels(viewer), before).max).toBeLessThanOrEqual(1);
  });

  test('with moveBefore of a wrapper or of the viewer keep models, camera and panel', async ({
    page,
    mount,
  }) => {
    const model = '<phong-mesh name="model" src="/fixtures/models/textured.glb"></phong-mesh>';
    const markup = `<main></main>${scene(`<p></p><div>${model}${red}</div>`, green).replace('geometry', 'gui geometry')}`;
    const viewer = await mount(markup, size);
    await expect(viewer.locator('[part=panel] > *')).not.toHaveCount(0);
    await viewer.evaluate((element: PhongViewer) => (element.theta = 77));
    const requests: string[] = [];
    page.on('request', (request) => requests.push(request.url()));
    const kept = await viewer.evaluate(async (element: PhongViewer) => {
      const state = (): unknown[] => [
        ...element.scene.children.map(({ uuid }) => uuid),
        element.shadowRoot?.querySelector('[part=panel]')?.firstElementChild,
        element.camera.theta,
        element.loaded,
      ];
      const before = state();
      element.querySelector('p')!.moveBefore(element.querySelector('div')!, null);
      document.querySelector('main')!.moveBefore(element, null);
      await element.ready;
      return state().every((part, i) => part === before[i]);
    });
    expect(kept).toBe(true);
    expect(await names(viewer)).toEqual(['red', 'green', 'model']);
    expect(requests).toEqual([]);
  });
});

test('many lights connected one per microtask make one frame and one search, in document order', async ({
  mount,
}) => {
  const viewer = await mount(open + '</phong-viewer>', size);
  const facts = await viewer.evaluate(async (element: PhongViewer) => {
    const { frames } = element.stats;
    let searches = 0;
    const search: (...given: never[]) => unknown = Reflect.get(Element.prototype, 'querySelector');
    Object.defineProperty(element, 'querySelector', {
      value: (...given: never[]) => {
        searches += 1;
        return Reflect.apply(search, element, given) as unknown;
      },
    });
    for (let i = 0; i < 300; i++) {
      const light = document.createElement('phong-light');
      light.diffuse = 0.5;
      light.name = String(i);
      if (i % 2 === 0) element.append(light);
      else element.prepend(light);
      await Promise.resolve();
    }
    await element.ready;
    const { stats } = element;
    const inOrder = element.lights.every((light, i) => light === element.children[i]);
    return [inOrder, stats.lightsActive, stats.frames - frames, searches <= 1];
  });
  expect(facts).toEqual([true, 300, 1, true]);
});
