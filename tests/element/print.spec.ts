// Does a printed page show its pictures, those below the fold too?
import { expect, test } from '../support/test.js';

test('draws what nobody has scrolled to before the page is printed', async ({ mount, page }) => {
  const viewer = await mount('<div id="above"></div><phong-viewer geometry="sphere"></phong-viewer>', {
    css: '#above { height: 5000px }',
  });
  const frames = () =>
    viewer.evaluate((element) => (element as unknown as { stats: { frames: number } }).stats.frames);
  expect(await frames()).toBe(0);
  await page.pdf();
  expect(await frames()).toBe(1);
});
