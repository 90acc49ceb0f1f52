// Can the element be used, and understood, without a mouse and without seeing it? Rules by axe; keys by a real
// keyboard.

import { axeOn } from '../support/axe.js';
import { expect, test } from '../support/test.js';
import { cameraOf, type PhongViewer } from '../element/support/viewer.js';

const light = '<phong-light position="1 2 3 0"></phong-light>';
const viewer = (attributes = ''): string =>
  `<phong-viewer geometry="box" ${attributes}>${light}</phong-viewer>`;

test('a page of viewers breaks no rule of axe', async ({ page, mount, consoleGuard }) => {
  consoleGuard.allow(/404/);
  await mount(
    `<main><h1>Viewers</h1>${viewer('alt="A box under one light"')}${viewer()}${viewer('role="img" aria-label="A box"')}
    ${viewer('alt="A box" gui')}${viewer('alt="Nothing" src="/none.glb"')}
    ${viewer('alt="A still" orbit="false" zoom="false"')}${viewer('alt="" orbit="false" zoom="false"')}</main>`,
    { width: 300, height: 200 },
  );
  const { violations } = await axeOn(page).analyze();
  expect(violations.map(({ id, nodes }) => [id, nodes.map(({ html }) => html)])).toEqual([]);
});

test('alt names the picture, and follows its changes', async ({ page, mount }) => {
  const element = await mount(viewer('alt="A box under one light"'));
  await expect(page.getByRole('application', { name: 'A box under one light' })).toBeVisible();
  await element.evaluate((target: PhongViewer) => (target.alt = 'Another box'));
  await expect(page.getByRole('application', { name: 'Another box' })).toBeVisible();
  await element.evaluate((target: PhongViewer) => target.removeAttribute('alt'));
  await expect(page.getByRole('application', { name: '3D scene' })).toBeVisible();
});

test("the author's role, aria-label and tabindex are left as they are", async ({ mount }) => {
  const element = await mount(viewer('role="figure" aria-label="Mine" tabindex="-1" alt="Other"'));
  const facts = await element.evaluate((target) => [
    target.getAttribute('role'),
    target.getAttribute('aria-label'),
    target.getAttribute('tabindex'),
  ]);
  expect(facts).toEqual(['figure', 'Mine', '-1']);
  const plain = await mount(viewer('alt="A box"'));
  const added = await plain.evaluate((target) => target.getAttributeNames());
  expect(added).toEqual(['geometry', 'alt']);
});

test('an author’s tabindex of −1 takes the viewer out of the tab order', async ({ page, mount }) => {
  await mount(`${viewer('tabindex="-1"')}<a href="#next">Next</a>`);
  await page.keyboard.press('Tab');
  expect(await page.evaluate(() => document.activeElement?.localName)).toBe('a');
});

test('Tab reaches each viewer once, and the focus is visible', async ({ page, mount }) => {
  const first = await mount(`${viewer()}${viewer()}<a href="#next">Next</a>`, { width: 300, height: 200 });
  const before = await first.screenshot();
  await page.keyboard.press('Tab');
  await expect(first).toBeFocused();
  expect(Buffer.compare(await first.screenshot(), before)).not.toBe(0);
  await page.keyboard.press('Tab');
  await expect(page.locator('phong-viewer').nth(1)).toBeFocused();
  await page.keyboard.press('Tab');
  expect(await page.evaluate(() => document.activeElement?.localName)).toBe('a');
  await page.keyboard.press('Shift+Tab');
  await page.keyboard.press('Shift+Tab');
  await expect(first).toBeFocused();
});

test('the keyboard can do everything that the pointer can: turn, zoom and reset', async ({ page, mount }) => {
  const element = await mount(viewer('theta="30" phi="70" radius="5"'));
  await page.keyboard.press('Tab');
  for (const key of ['ArrowLeft', 'ArrowUp', '+']) await page.keyboard.press(key);
  const { theta, phi, radius } = await cameraOf(element);
  expect([theta, phi]).toEqual([35, 75]);
  expect(radius).toBeCloseTo(5 / 1.1, 12);
  await page.keyboard.press('Home');
  expect(await cameraOf(element)).toMatchObject({ theta: 30, phi: 70, radius: 5 });
});
