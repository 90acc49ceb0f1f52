// Which lights and meshes belong to a viewer? Those whose nearest enclosing viewer it is, at any
// depth and across shadow trees, in document order, however they come, move and go.
// histories/histories.spec.ts moves them at random. Pictures are compared with those of the same
// markup, complete from the start.

import type { Page } from '@playwright/test';
import { allReady, compare, expect, pixels, same, test, type Picture } from '../../support/test.js';
import { drawUntilSpecialised } from '../frames/driving.js';
import { logGl } from '../support/gl-log.js';
import { type PhongViewer, record, shownBy, assign } from '../support/viewer.js';
import { requestsOf } from '../../support/requests.js';

const size = { width: 60, height: 40 };
const red =
  '<phong-light name="red" diffuse="200 0 0" specular="0" position="1 1 0 0"></phong-light>';
const green =
  '<phong-light name="green" diffuse="0 120 0" position="-0.3 0.5 0.2 1" ambient="0 9 0"></phong-light>';

const open = '<phong-viewer geometry="plane" theta="0" phi="40" radius="1.2" target="0 0 0">';
const scene = (...children: readonly string[]) => `${open}${children.join('')}</phong-viewer>`;

/** The picture of this markup in a second viewer. */
const shown = (page: Page, markup: string) => shownBy(page, markup, size);
const box = '<phong-mesh name="box" geometry="box" scale="0.3"></phong-mesh>';

test('children belong to the nearest viewer at any depth, except in slots', async ({
  page,
  mount,
  consoleGuard,
}) => {
  const ignored = consoleGuard.allow(
    / is inside an element with a slot, so it has no effect\. Move it out/,
    2,
  );
  const nested = consoleGuard.allow(/^warning: <phong-viewer> contains another <phong-viewer>/, 1);
  const tree = (mode: string, inner: string) =>
    `<div><template shadowrootmode="${mode}">${inner}</template>`;
  const selfClosed = [red, box, green].map((tag) => tag.replace(/><\/[^>]*>$/, '/>')).join('');
  /** Each with the lights and meshes of its viewers, in document order. */
  const scenes: readonly (readonly [markup: string, ...names: string[]])[] = [
    [`<div><p>${red}</p><span>${box}</span></div>${green}`, 'red green box'],
    [selfClosed, 'red green box'],
    // A shadow tree comes before what its host contains.
    [
      `${tree('open', `${tree('closed', green)}</div>`)}${box}${red}</div>${green}`,
      'green red green box',
    ],
    [red + scene(green, box), 'red', 'green box'],
    [`<div slot="error"><p>${green}${box}</p>${scene(red)}</div>${red}`, 'red', 'red'],
  ];
  await mount(scenes.map(([markup]) => scene(markup)).join(''), size);
  const found = await page.evaluate(() =>
    Array.from(document.querySelectorAll('phong-viewer'), ({ lights, meshes }) =>
      [...lights, ...meshes].map(({ name }) => name).join(' '),
    ),
  );
  expect(found).toEqual(scenes.flatMap(([, ...names]) => names));
  await expect.poll(() => [ignored.length, nested.length]).toEqual([2, 1]);
});

test('children come and go while the viewer is outside the document', async ({ mount, page }) => {
  const viewer = await mount(scene(red, green, box), size);
  const counts = await viewer.evaluate(async (element) => {
    const count = () => [
      element.lights.length,
      element.meshes.length,
      element.stats.lightsDeclared,
    ];
    const parent = element.parentElement;
    element.remove();
    element.lights[0]?.remove();
    element.meshes[0]?.remove();
    const away = count();
    // A link has a `host` that is no element.
    const link = Object.assign(document.createElement('a'), { href: 'https://example.test/' });
    link.append(document.createElement('phong-light'));
    const wrapper = document.createElement('div');
    wrapper.append(document.createElement('phong-mesh'));
    element.append(...link.children, wrapper);
    const added = count();
    link.append(element.lights[1]!);
    parent?.append(element);
    await element.ready;
    const counts = [away, added, count()];
    const light = document.createElement('phong-light');
    element.append(light);
    void element.lights; // looks for children, as it does below, while the script still holds this one
    element.remove();
    light.remove();
    void element.lights;
    parent?.append(element);
    await element.ready;
    return counts;
  });
  expect(counts).toEqual([[1, 0, 1], [2, 1, 2], [1, 1, 1]]); // oxfmt-ignore
  same(await pixels(viewer), await shown(page, scene(green)));
});

test('children that a component shows in a slot belong to the viewer around the slot', async ({
  page,
  mount,
}) => {
  await mount(scene(), size);
  const names = await page.evaluate(
    async ([markup, children, { width, height }]) => {
      const host = document.createElement('article');
      host.innerHTML = children;
      document.body.append(host);
      host.attachShadow({ mode: 'open' }).innerHTML = markup;
      const viewer = host.shadowRoot!.querySelector('phong-viewer')!;
      Object.assign(viewer.style, { width: `${width}px`, height: `${height}px` });
      const seen: string[] = [];
      const see = async () => {
        await viewer.ready;
        seen.push([...viewer.lights, ...viewer.meshes].map(({ name }) => name).join(' '));
      };
      await see();
      const [red] = host.children as unknown as [HTMLElement];
      red.slot = 'none';
      await see();
      red.slot = '';
      const wrapper = document.createElement('div');
      wrapper.innerHTML = '<phong-light name="dim" diffuse="9"></phong-light>';
      host.prepend(wrapper);
      await see();
      wrapper.remove();
      await see();
      return seen;
    },
    [scene(green, '<slot></slot>'), red + box, size] as const,
  );
  expect(names).toEqual(['green red box', 'green box', 'green dim red box', 'green red box']);
  same(
    await pixels(page.locator('article phong-viewer')),
    await shown(page, scene(green, red, box)),
  );
});

test('children are found by a viewer that is defined later than they are', async ({
  page,
  site,
  mount,
}) => {
  const markup = scene(`<div>${red}</div>`, green, box);
  const wanted = await pixels(await mount(markup, size));
  await page.goto(
    site.page(markup, { css: 'phong-viewer { display: block; width: 60px; height: 40px }' }),
  );
  await page.evaluate(async () => {
    // A copy of the package whose viewer is not defined until everything else is.
    const define = customElements.define.bind(customElements);
    let last = (): void => undefined;
    customElements.define = (name, constructor) => {
      if (name === 'phong-viewer') {
        last = () => define(name, constructor);
      } else {
        define(name, constructor);
      }
    };
    const address = '/dist/phong-viewer.standalone.js';
    await import(address);
    await new Promise((resolve) => requestAnimationFrame(resolve));
    last();
  });
  await allReady(page);
  same(await pixels(page.locator('phong-viewer')), wanted);
});

test('a viewer loses nothing in a detached tree, in another viewer or in a shadow tree', async ({
  mount,
}) => {
  const viewer = await mount(`${scene(red, green, box)}<aside></aside>`, size);
  const before = await pixels(viewer);
  for (const move of [
    (element: PhongViewer) => {
      document.createElement('div').append(element);
      element.meshes[0]!.scale = [0.1, 0.1, 0.1];
      element.lights[0]!.diffuse = [1, 2, 3];
      element.lights[0]!.diffuse = [200, 0, 0];
      element.meshes[0]!.scale = [0.3, 0.3, 0.3];
      document.body.append(element);
    },
    (element: PhongViewer) => {
      const other = document.createElement('phong-viewer');
      document.body.append(other);
      other.append(element);
      document.body.append(element);
      other.remove();
    },
    (element: PhongViewer) =>
      document.querySelector('aside')?.attachShadow({ mode: 'open' }).append(element),
  ]) {
    await viewer.evaluate(move);
    same(await pixels(viewer, size), before);
  }
});

test('moveBefore of wrapper or viewer keeps models, camera and panel; the order follows', async ({
  page,
  mount,
}) => {
  const model = '<phong-mesh name="model" src="/fixtures/models/textured.glb"></phong-mesh>';
  const markup = `<main></main>${scene(`<p></p><div>${model}${red}</div>`, green).replace('geometry', 'gui geometry')}`;
  const viewer = await mount(markup, size);
  await expect(viewer.locator('[part=panel] > *')).not.toHaveCount(0);
  await assign(viewer, { theta: 77 });
  const requests = requestsOf(page);
  const events = await record(viewer, 'load', 'error', 'camera-change');
  const kept = await viewer.evaluate(async (element) => {
    const state = (): unknown[] => [
      ...element.scene.children.map(({ uuid }) => uuid),
      element.shadowRoot?.querySelector('[part=panel]')?.firstElementChild,
      element.camera.theta,
      element.loaded,
    ];
    const before = state();
    element.querySelector('p')!.moveBefore(element.querySelector('div')!, null);
    element.moveBefore(element.querySelector('p')!, null);
    document.querySelector('main')!.moveBefore(element, null);
    await element.ready;
    const names = [...element.lights, ...element.meshes].map(({ name }) => name);
    return [state().every((part, i) => part === before[i]), ...names];
  });
  expect(kept).toEqual([true, 'green', 'red', 'model']);
  expect([...requests, ...(await events.take())]).toEqual([]);
});

test('many lights connected one per microtask make one frame and one search, in document order', async ({
  mount,
}) => {
  const viewer = await mount(open + '</phong-viewer>', size);
  const facts = await viewer.evaluate(async (element) => {
    const { frames } = element.stats;
    let searches = 0;
    document.createTreeWalker = (...given) => {
      searches += 1;
      return Document.prototype.createTreeWalker.apply(document, given);
    };
    for (let i = 0; i < 300; i++) {
      const light = Object.assign(document.createElement('phong-light'), {
        diffuse: 2,
        name: String(i),
      });
      if (i % 2 === 0) {
        element.append(light);
      } else {
        element.prepend(light);
      }
      await Promise.resolve();
    }
    await element.ready;
    const { stats } = element;
    const inOrder = element.lights.every((light, i) => light === element.children[i]);
    Reflect.deleteProperty(document, 'createTreeWalker');
    return [inOrder, stats.lightsActive, stats.frames - frames, searches];
  });
  expect(facts).toEqual([true, 300, 1, 1]);
});

test('the head-light shines only without any phong-light, and is not in lights or toHTML', async ({
  page,
  mount,
}) => {
  const viewer = await mount(scene(), size);
  const wanted = await shown(
    page,
    scene('<phong-light space="camera" position="0 0 1 0"></phong-light>'),
  );
  same(await pixels(viewer), wanted);
  expect(await viewer.evaluate((element) => [element.lights.length, element.toHTML()])).toEqual([
    0,
    expect.not.stringContaining('phong-light'),
  ]);
  await viewer.evaluate((element, html) => (element.innerHTML = html), red);
  same(await pixels(viewer), await shown(page, scene(red)));
  await viewer.evaluate((element) => element.replaceChildren());
  same(await pixels(viewer), wanted);
  // It never flashes when lights are appended at once.
  const sent = await page.evaluate(async () => {
    const element = document.createElement('phong-viewer');
    element.geometry = 'plane';
    const counts: number[] = [];
    element.addEventListener('render', () => counts.push(element.stats.lightsActive));
    document.body.append(element);
    element.append(Object.assign(document.createElement('phong-light'), { active: false }));
    await element.ready;
    return counts;
  });
  expect(sent).toEqual([0]);
});

test('of meshes at one place the last one in document order is visible, with any program', async ({
  page,
  mount,
}) => {
  await logGl(page);
  const lit = (...meshes: readonly string[]) =>
    `<phong-viewer theta="20" phi="60" radius="3" target="0 0 0">
      <phong-light position="0.6 1 1.2 0" ambient="60" diffuse="120"></phong-light>${meshes.join('')}</phong-viewer>`;
  const red = '<phong-mesh geometry="sphere" kd="200 40 40"></phong-mesh>';
  const green = red.replace('200 40', '40 200');
  const blue = red.replace('200 40 40', '40 40 200');
  const viewer = await mount(lit(red, green), size);
  const wanted = { red: await shown(page, lit(red)), green: await shown(page, lit(green)) };
  expect(compare(wanted.red, wanted.green).max).toBeGreaterThan(20);
  same(await pixels(viewer), wanted.green);
  await viewer.evaluate((element) => element.append(element.meshes[0]!));
  same(await pixels(viewer), wanted.red);
  await viewer.evaluate((element, html) => element.insertAdjacentHTML('afterbegin', html), blue);
  same(await pixels(viewer), wanted.red);
  await viewer.evaluate((element) => (element.meshes[1]!.shading = 'gouraud'));
  await viewer.evaluate((element) => (element.meshes[1]!.shading = null));
  await drawUntilSpecialised(page);
  expectAlike(await pixels(viewer), wanted.red, 'by programs of their own');
  await viewer.evaluate((element) => (element.meshes[0]!.kd = [40, 40, 180]));
  expectAlike(await pixels(viewer), wanted.red, 'one of them changed');
});

/** Other programs may be off by one code on 0.02 % of channels. */
function expectAlike(actual: Picture, wanted: Picture, name: string) {
  const { max, share } = compare(actual, wanted, 0);
  expect(max, name).toBeLessThanOrEqual(1);
  expect(share, name).toBeLessThanOrEqual(2e-4);
}
