// What does a screen reader find in a comparison and in linked viewers? Read from Chromium's accessibility tree.

import { axeOn } from '../support/axe.js';
import { expect, test } from '../support/test.js';
import { drag, nextFrame } from '../element/support/viewer.js';
import { accessibleNodes } from './tree.js';

const css = 'phong-compare { display: block; width: 400px; height: 200px }';
const viewer = (alt: string, attributes = ''): string =>
  `<phong-viewer geometry="box" alt="${alt}" ${attributes}></phong-viewer>`;

test('a comparison has its viewers and a divider between them as Tab stops, in this order', async ({
  page,
  mount,
}) => {
  await mount(`<phong-compare>${viewer('Gouraud')}${viewer('Phong')}</phong-compare>`, { css });
  await expect(page.getByRole('separator')).toBeAttached();
  const nodes = await accessibleNodes(page);
  const found = nodes.filter(({ role }) => /application|separator|splitter/i.test(role));
  expect(found.map(({ name }) => name)).toEqual(['Gouraud', 'Divider between Gouraud and Phong', 'Phong']);
  expect(found[1]!.properties).toMatchObject({ focusable: true, orientation: 'vertical' });
  const stops: (string | null)[] = [];
  for (let i = 0; i < 3; i++) {
    await page.keyboard.press('Tab');
    stops.push(
      await page.evaluate(() => {
        let active = document.activeElement;
        while (active?.shadowRoot?.activeElement) active = active.shadowRoot.activeElement;
        return active?.getAttribute('aria-label') ?? null;
      }),
    );
  }
  expect(stops).toEqual(['Gouraud', 'Divider between Gouraud and Phong', 'Phong']);
});

test('a divider has a name with its two panes, and a value', async ({ page, mount }) => {
  await mount(`<phong-compare at="30">${viewer('A')}${viewer('B')}</phong-compare>`, { css });
  const divider = page.getByRole('separator');
  for (const [name, value] of Object.entries({
    'aria-valuenow': '30',
    'aria-valuemin': '0',
    'aria-valuemax': '100',
    'aria-controls': 'pane-1 pane-2',
  }))
    await expect(divider).toHaveAttribute(name, value);
  expect(
    await divider.evaluate((element) =>
      (element.getAttribute('aria-controls') ?? '')
        .split(' ')
        .map(
          (id) => (element.getRootNode() as ShadowRoot).getElementById(id)?.querySelector('slot') !== null,
        ),
    ),
  ).toEqual([true, true]);
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

test('a page of comparisons breaks no rule of axe', async ({ page, mount }) => {
  const viewers = viewer('Gouraud') + viewer('Phong') + viewer('Flat');
  await mount(
    `<main><h1>Comparisons</h1><phong-compare>${viewers}</phong-compare>
      <phong-compare direction="vertical" labels="one, two, three">${viewers}</phong-compare>
      <phong-compare layout="side">${viewers}</phong-compare></main>`,
    { css, csp: '' },
  );
  await expect(page.getByRole('separator')).toHaveCount(4);
  const { violations } = await axeOn(page).analyze();
  expect(violations.map(({ id, nodes }) => [id, nodes.map(({ html }) => html)])).toEqual([]);
});
