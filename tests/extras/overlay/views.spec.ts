// Do `view` and `view-light` behave as documented: legend, lights by name, what is compiled,
// measuring the error?

import { type View, VIEWS } from '../../../src/phong/material/views.js';
import {
  type ViewerLocator,
  compare,
  expect,
  pixelAt,
  pixels,
  same,
  test,
} from '../../support/test.js';
import { choice, flag, opened, button, panelOf } from '../panel/panel-rows.js';
import {
  assign,
  loseContext,
  nextFrame,
  type PhongViewer,
  set,
  settled,
  htmlOf,
  statsOf,
} from '../../element/support/viewer.js';

const SIZE = { width: 300, height: 240 };
const lights = `
  <phong-light name="sun" position="1 2 1 0" diffuse="120 100 80" ambient="20"></phong-light>
  <phong-light id="lamp" name="lamp" position="1 1 1 1" diffuse="0 60 60"></phong-light>
  <phong-light position="0 1 2 1" axis="0 -1 -2" aperture="9" cutoff="3"></phong-light>`;
const scene = (attributes: string) =>
  `<phong-viewer geometry="sphere" ${attributes}>${lights}</phong-viewer>`;

const legendOf = (viewer: ViewerLocator) => viewer.locator('.legend');

/** Title and lights of the legend, and the marks of its scale. */
const legendText = async (viewer: ViewerLocator) => {
  const legend = legendOf(viewer);
  const texts = await legend.locator('p:not(:empty), .legend-marks').allTextContents();
  return texts.map((text) => text.trim());
};

test('each view has a legend that says what its colours mean, to a screen reader too', async ({
  mount,
}) => {
  const viewer = await mount(scene(''), SIZE);
  const expected: Record<Exclude<View, 'shaded'>, readonly string[]> = {
    ambient: ['Ambient term', 'all lights'],
    diffuse: ['Diffuse term', 'all lights'],
    specular: ['Specular term', 'all lights'],
    normals: ['Normals', '−1 0 1'],
    'n-dot-l': ['N · L', 'sun', '0 0.5 1'],
    'r-dot-v': ['R · V', 'sun', '0 0.5 1'],
    attenuation: ['Attenuation', 'sun', '0 0.5 1'],
    decay: ['Decay', 'sun', '0 0.5 1'],
    triangles: ['Triangles'],
  };
  for (const [view, texts] of Object.entries(expected)) {
    await set(viewer, { view });
    expect(await legendText(viewer), view).toEqual(texts);
  }
  await set(viewer, { view: 'n-dot-l' });
  await expect(viewer.getByRole('group', { name: 'Legend' })).toMatchAriaSnapshot(`
    - group "Legend":
      - paragraph: N · L
      - paragraph: sun
      - text: 0 0.5 1
  `);
  await set(viewer, { view: 'r-dot-v', reflection: 'blinn-phong', viewLight: 'light 3' });
  expect(await legendText(viewer)).toEqual(['N · H', 'light 3', '0 0.5 1']);
  await set(viewer, { view: null, viewLight: 'lamp' });
  expect(await legendText(viewer)).toEqual(['Shaded', 'lamp']);
  await set(viewer, { viewLight: null });
  await expect(legendOf(viewer)).toHaveCount(0);
});

test('`ready` and `toBlob` wait for the view, and leaving it restores the picture', async ({
  page,
  mount,
}) => {
  const viewer = await mount(scene('view="normals"'), SIZE);
  // The middle of the sphere faces the eye: no shade of these lights has as much blue.
  const [r, g, b] = pixelAt(await pixels(viewer), 150, 120);
  const back = await viewer.evaluate(({ camera: { eye, radius } }) => eye.map((x) => x / radius));
  expect(
    [r, g, b].map((code) => code / 127.5 - 1).every((x, i) => Math.abs(x - back[i]!) < 0.02),
  ).toBe(true);
  await assign(viewer, { view: null });
  const shaded = await pixels(viewer);
  await page.reload();
  const again = page.locator('phong-viewer');
  const blob = again.evaluate(async (element: PhongViewer) => {
    await customElements.whenDefined('phong-viewer');
    element.view = 'triangles';
    const picture = await element.toBlob();
    element.view = 'shaded';
    return picture.size;
  });
  expect(await blob).toBeGreaterThan(0);
  same(shaded, await pixels(again));
});

test('follows lights that are renamed, switched off, added and removed', async ({
  mount,
  consoleGuard,
}) => {
  consoleGuard.allow(/view-light="lamp2?">: no light has this name/, 2);
  const viewer = await mount(scene('view="n-dot-l" view-light="lamp"'), SIZE);
  const lamp = viewer.locator('#lamp');
  const write = async (values: Readonly<Record<string, string | boolean>>) => {
    await assign(lamp, values);
    await settled(viewer);
  };
  const expectLegend = async (text: string) => expect(await legendText(viewer)).toContain(text);
  const middle = async () => pixelAt(await pixels(viewer), 150, 120);
  await expectLegend('lamp');
  await write({ active: false });
  await expectLegend('lamp (not active)');
  expect(await middle()).toEqual([0, 0, 0, 255]);
  await write({ active: true });
  expect((await middle())[0]).toBeGreaterThan(50);
  await write({ name: 'other' });
  await expectLegend('no light has the name lamp');
  await write({ name: 'lamp' });
  await expectLegend('lamp');
  // A name by the page's texts, which come later.
  await write({ name: '' });
  await set(viewer, { viewLight: 'lamp2' });
  await set(viewer, { texts: { 'light {number}': 'lamp{number}' } });
  expect((await middle())[0]).toBeGreaterThan(50);
  await set(viewer, { texts: null, viewLight: 'lamp' });
  await lamp.evaluate((light) => light.remove());
  await settled(viewer);
  await expectLegend('no light has the name lamp');
  // Without a name it is the first active light.
  await set(viewer, { viewLight: null });
  await expectLegend('sun');
  await viewer.evaluate((element) => element.lights.forEach((one) => (one.active = false)));
  await settled(viewer);
  await expectLegend('no light is active');
  expect(await middle()).toEqual([0, 0, 0, 255]);
  await viewer.evaluate((element) => element.replaceChildren());
  await settled(viewer);
  await expectLegend('head-light');
});

test('a view is compiled once, however often it is chosen', async ({ page, mount }) => {
  const viewer = await mount(scene(''), { width: 60, height: 42 });
  const rounds: number[] = [];
  for (let round = 0; round < 3; round++) {
    for (const view of VIEWS) {
      await set(viewer, { view });
      await nextFrame(page);
    }
    rounds.push((await statsOf(viewer)).programs);
  }
  // The general program, and those of the seven views that no sum of terms shows.
  expect(rounds[0]).toBeLessThanOrEqual(1 + 7);
  expect(rounds).toEqual([rounds[0], rounds[0], rounds[0]]);
});

for (const view of ['specular', 'attenuation']) {
  test(`the title of a small legend of ${view} stays whole, and its lights give way to a scale alone`, async ({
    mount,
  }) => {
    const markup = `<phong-viewer geometry="sphere" view="${view}"></phong-viewer>`;
    const viewer = await mount(markup, { width: 148, height: 110 });
    const cut = await legendOf(viewer)
      .locator('p')
      .evaluateAll((texts) =>
        texts.map((one) => {
          const text = document.createRange();
          text.selectNodeContents(one);
          return text.getBoundingClientRect().width - one.getBoundingClientRect().width;
        }),
      );
    expect(cut[0]).toBe(0);
    expect(cut[1]! > 1).toBe(view === 'attenuation');
  });
}

test('the legend can be styled and hidden, and stays inside small viewers', async ({
  page,
  mount,
}) => {
  const viewer = await mount(scene('view="n-dot-l" view-light="lamp"'), {
    ...SIZE,
    css: 'phong-viewer::part(legend) { border-width: 3px } .quiet::part(legend) { display: none }',
  });
  await expect(legendOf(viewer)).toHaveCSS('border-top-width', '3px');
  const isInside = async () => {
    const [inner, outer] = [(await legendOf(viewer).boundingBox())!, (await viewer.boundingBox())!];
    return (
      inner.x >= outer.x &&
      inner.y >= outer.y &&
      inner.x + inner.width <= outer.x + outer.width &&
      inner.y + inner.height <= outer.y + outer.height
    );
  };
  const resize = (width: string, height: string) =>
    viewer.evaluate((element, size) => Object.assign(element.style, size), { width, height });
  expect(await isInside()).toBe(true);
  await page.evaluate(() => (document.documentElement.dir = 'rtl'));
  expect(await isInside()).toBe(true);
  const box = (await legendOf(viewer).boundingBox())!;
  expect(box.x).toBeGreaterThan((await viewer.boundingBox())!.x + 100);
  await resize('120px', '90px');
  await expect(legendOf(viewer)).toBeVisible();
  expect(await isInside()).toBe(true);
  await resize('60px', '40px');
  await expect(legendOf(viewer)).toBeHidden();
  await resize('', '');
  await expect(legendOf(viewer)).toBeVisible();
  await viewer.evaluate((element) => element.classList.add('quiet'));
  await expect(legendOf(viewer)).toBeHidden();
});

test('is restored after the element was removed, and after its context was lost', async ({
  mount,
}) => {
  const viewer = await mount(scene('view="triangles"'), SIZE);
  const before = await pixels(viewer);
  /** Takes the viewer off the page, for a task or within one, and back with this view. */
  const comeBack = (view: PhongViewer['view'], pause: boolean) =>
    viewer.evaluate(
      async (element, [next, waits]) => {
        const parent = element.parentNode!;
        element.remove();
        if (waits) {
          await new Promise((resolve) => setTimeout(resolve));
        }
        element.view = next;
        parent.append(element);
        await element.ready;
      },
      [view, pause] as const,
    );
  await comeBack('triangles', true);
  await expect(legendOf(viewer)).toHaveCount(1);
  same(before, await pixels(viewer));
  await comeBack('shaded', false);
  expect(compare(before, await pixels(viewer)).max).toBeGreaterThan(0);
  await set(viewer, { view: 'triangles' });
  const restore = await loseContext(viewer);
  const notice = viewer.locator('[part=notice]');
  await expect(notice).toHaveCount(1);
  await restore();
  await expect(notice).toHaveCount(0);
  await settled(viewer);
  same(before, await pixels(viewer));
});

test('a name that no light has is black with a warning; a later light shows', async ({
  page,
  mount,
  consoleGuard,
}) => {
  consoleGuard.allow(
    /view-light="lampe">: no light has this name, so none is shown. Names of lights: "sun", "lamp", "light 3"/,
    1,
  );
  const viewer = await mount(scene('view-light="lampe"'), SIZE);
  const brightest = async () => {
    const { data } = await pixels(viewer);
    return data.reduce((most, value, i) => (i % 4 === 3 ? most : Math.max(most, value)), 0);
  };
  expect(await legendText(viewer)).toContain('no light has the name lampe');
  for (const view of ['shaded', 'diffuse', 'n-dot-l'] as const) {
    await set(viewer, { view });
    expect(await brightest(), view).toBe(0);
  }
  await nextFrame(page);
  await viewer.evaluate((element) => {
    element.lights[1]!.name = 'lampe';
    return element.ready;
  });
  expect(await brightest()).toBeGreaterThan(100);
  // Lights that come in the same task or its microtasks, as frameworks add them, are no mistake.
  await viewer.evaluate(async (element) => {
    element.viewLight = 'late';
    await Promise.resolve();
    element.append(Object.assign(document.createElement('phong-light'), { name: 'late' }));
    await new Promise((resolve) => setTimeout(resolve, 20));
    // Nor are those that the parser has not come to.
    Object.defineProperty(document, 'readyState', { value: 'loading', configurable: true });
    element.viewLight = 'last';
    await new Promise((resolve) => setTimeout(resolve, 20));
    element.append(Object.assign(document.createElement('phong-light'), { name: 'last' }));
    Reflect.deleteProperty(document, 'readyState');
    document.dispatchEvent(new Event('DOMContentLoaded'));
    await new Promise((resolve) => setTimeout(resolve, 20));
    return element.ready;
  });
  expect(await brightest()).toBeGreaterThan(100);
});

test('the markup keeps the view, and the panel writes and follows it', async ({
  mount,
  consoleGuard,
}) => {
  const warnings = consoleGuard.allow(/view-light="lamp">: no light has this name/, 1);
  const viewer = await mount(scene('gui view="decay" view-light="lamp"'), {
    width: 900,
    height: 700,
  });
  const html = await htmlOf(viewer);
  expect(html).toContain(' view="decay" view-light="lamp"');
  const folder = await opened(viewer, 'Show');
  await expect(choice(folder, 'view')).toHaveValue('decay');
  await choice(folder, 'view').selectOption('normals');
  await choice(folder, 'view light').selectOption('light 3');
  await flag(folder, 'show axes').click();
  await flag(folder, 'probe').click();
  const values = () =>
    viewer.evaluate(({ view, viewLight, helpers, probe }) => [view, viewLight, helpers, probe]);
  expect(await values()).toEqual(['normals', 'light 3', ['axes'], true]);
  for (let step = 0; step < 4; step++) {
    await button(panelOf(viewer), 'undo').click();
  }
  expect(await values()).toEqual(['decay', 'lamp', [], false]);
  await viewer.evaluate((element) => (element.lights[1]!.name = 'torch'));
  const names = ['all, or the first', 'sun', 'torch', 'light 3', 'lamp'];
  await expect(choice(folder, 'view light').locator('option')).toHaveText(names);
  await expect.poll(() => warnings.length).toBe(1);
});
