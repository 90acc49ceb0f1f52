// What does a screen reader find in a comparison and in linked viewers? Read from Chromium's
// accessibility tree.

import { expect, test } from '../support/test.js';
import { drag, nextFrame } from '../element/support/viewer.js';
import { accessibleNodes } from './tree.js';

const css = 'phong-compare { display: block; width: 400px; height: 200px }';
const viewer = (alt: string, attributes = '') =>
  `<phong-viewer geometry="box" alt="${alt}" ${attributes}></phong-viewer>`;

test('a comparison has its viewers and their divider as named Tab stops, in order', async ({
  page,
  mount,
}) => {
  await mount(`<phong-compare at="30">${viewer('Gouraud')}${viewer('Phong')}</phong-compare>`, {
    css,
  });
  const divider = page.getByRole('separator');
  await expect(divider).toBeAttached();
  const expected = ['Gouraud', 'Divider between Gouraud and Phong', 'Phong'];
  const nodes = await accessibleNodes(page);
  const found = nodes.filter(({ role }) => /application|separator|splitter/i.test(role));
  expect(found.map(({ name }) => name)).toEqual(expected);
  expect(found[1]!.properties).toMatchObject({ focusable: true, orientation: 'vertical' });
  const stops: (string | null)[] = [];
  for (let i = 0; i < 3; i++) {
    await page.keyboard.press('Tab');
    stops.push(
      await page.evaluate(() => {
        let active = document.activeElement;
        while (active?.shadowRoot?.activeElement) {
          active = active.shadowRoot.activeElement;
        }
        return active?.getAttribute('aria-label') ?? null;
      }),
    );
  }
  expect(stops).toEqual(expected);
  for (const [name, value] of Object.entries({ now: '30', min: '0', max: '100' })) {
    await expect(divider).toHaveAttribute(`aria-value${name}`, value);
  }
  const panes = divider.evaluate((element) =>
    element
      .getAttribute('aria-controls')!
      .split(' ')
      .map(
        (id) =>
          (element.getRootNode() as ShadowRoot).getElementById(id)!.querySelector('slot') !== null,
      ),
  );
  expect(await panes).toEqual([true, true]);
});

test('among linked viewers only the one that the user moves announces the camera', async ({
  page,
  mount,
}) => {
  await mount(`${viewer('A', 'camera-group="x"')}${viewer('B', 'camera-group="x"')}`, {
    width: 300,
    height: 200,
    css: 'phong-viewer { display: inline-block }',
  });
  await drag(page, [100, 100], [30, 10]);
  await nextFrame(page);
  const spoken = (i: number) => page.locator('phong-viewer').nth(i).locator('[aria-live]');
  await expect(spoken(0)).toHaveText(/Camera: azimuth/);
  await expect(spoken(1)).toHaveCount(0);
});
