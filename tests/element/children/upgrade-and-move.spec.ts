// Does a viewer find its children in any order of definition and insertion, and keep everything while it moves in the
// document? Pictures are compared with those of the same markup, complete from the start.

import { allReady, expect, pixels, test } from '../../support/test.js';
import { assign, type PhongLight, type PhongViewer } from '../support/viewer.js';
import { different, green, red, same, scene, shown, size } from './plane-scene.js';

test.describe('the order of upgrades does not matter', () => {
  const inner = `${red}${green}<phong-mesh geometry="box" scale="0.3"></phong-mesh>`;
  const markup = scene(inner);

  test('when the elements are defined long after the children, or before them', async ({
    page,
    site,
    mount,
  }) => {
    const wanted = await pixels(await mount(markup, size));
    await page.goto(site.page(markup, { css: 'phong-viewer { display: block; width: 60px; height: 40px }' }));
    await page.addScriptTag({ type: 'module', url: '/dist/phong-viewer.standalone.js' });
    await page.evaluate(() => customElements.whenDefined('phong-viewer'));
    await allReady(page);
    same(await pixels(page.locator('phong-viewer')), wanted);

    same(await shown(page, markup), wanted);
  });

  for (const when of ['before', 'after', 'long after'] as const) {
    test(`when children are appended ${when} the viewer is connected`, async ({ page, mount }) => {
      await mount('<main></main>', size);
      const wanted = await shown(page, markup);
      await page.evaluate(
        async ({ html, order }) => {
          const template = document.createElement('template');
          template.innerHTML = html;
          const pattern = template.content.firstElementChild!;
          const element = document.createElement('phong-viewer');
          for (const { name, value } of pattern.attributes) element.setAttribute(name, value);
          const main = document.querySelector('main');
          if (order !== 'before') main?.append(element);
          if (order === 'long after') await element.ready;
          // From a template's document: inert until they are adopted.
          element.append(...pattern.children);
          if (order === 'before') main?.append(element);
        },
        { html: markup, order: when },
      );
      await allReady(page);
      same(await pixels(page.locator('phong-viewer')), wanted);
    });
  }

  test('when properties were set before the upgrade', async ({ page, site, mount }) => {
    const wanted = await pixels(await mount(markup, size));
    await page.goto(
      site.page(markup.replace('diffuse="200 0 0"', '').replace('geometry="plane"', ''), {
        css: 'phong-viewer { display: block; width: 60px; height: 40px }',
      }),
    );
    await assign(page.locator('phong-light').first(), { diffuse: [200, 0, 0] });
    await assign(page.locator('phong-viewer'), { geometry: 'plane' });
    await page.addScriptTag({ type: 'module', url: '/dist/phong-viewer.standalone.js' });
    await page.evaluate(() => customElements.whenDefined('phong-viewer'));
    await allReady(page);
    same(await pixels(page.locator('phong-viewer')), wanted);
    await page
      .locator('phong-light')
      .first()
      .evaluate((light: PhongLight) => (light.diffuse = [1, 2, 3]));
    different(await pixels(page.locator('phong-viewer')), wanted);
  });
});

test.describe('moving the viewer in the document', () => {
  for (const [what, move] of [
    [
      'into a detached tree and back, with a change on the way',
      (viewer: PhongViewer) => {
        document.createElement('div').append(viewer);
        viewer.meshes[0]!.scale = [0.1, 0.1, 0.1];
        viewer.lights[0]!.diffuse = [1, 2, 3];
        viewer.lights[0]!.diffuse = [200, 0, 0];
        viewer.meshes[0]!.scale = [0.3, 0.3, 0.3];
        document.querySelector('aside')?.append(viewer);
      },
    ],
    [
      'into the shadow tree of another element',
      (viewer: Element) => document.querySelector('aside')?.attachShadow({ mode: 'open' }).append(viewer),
    ],
    [
      'among the children of another viewer and back',
      (viewer: Element) => {
        const other = document.createElement('phong-viewer');
        document.body.append(other);
        other.append(viewer);
        document.body.append(viewer);
        other.remove();
      },
    ],
  ] as const) {
    test(`${what} loses nothing`, async ({ page, mount }) => {
      const markup = `<p>Text</p>${scene(red, green, '<phong-mesh geometry="box" scale="0.3"></phong-mesh>')}<aside></aside>`;
      const viewer = await mount(markup, size);
      const before = await pixels(viewer);
      await viewer.evaluate(move);
      const moved = page.locator('phong-viewer').first();
      const facts = await moved.evaluate(async (element: PhongViewer) => {
        await element.ready;
        return [element.lights.length, element.meshes.length, element.isConnected];
      });
      expect(facts).toEqual([2, 1, true]);
      same(await pixels(moved, size), before);
    });
  }
});
