// Does a screenshot of a long page show every picture? That each looks as before is tested with its
// page: element/site/site.spec.ts.
import { allReady, expect, pixelAt, test } from '../support/test.js';
import { decodePng } from '../support/picture.js';

test('@release a screenshot of the whole page about light shows every picture', async ({
  page,
}) => {
  await page.goto('/demo/guide/light/');
  await allReady(page);
  const boxes = await page.evaluate(() =>
    Array.from(document.querySelectorAll('phong-viewer'), (viewer) => {
      const { left, top, width, height } = viewer.getBoundingClientRect();
      return { left, top, width, height };
    }),
  );
  expect(boxes.length).toBeGreaterThan(10);
  const whole = decodePng(await page.screenshot({ fullPage: true }));
  for (const { left, top, width, height } of boxes) {
    const edge = pixelAt(whole, Math.ceil(left) + 2, Math.ceil(top) + 2);
    let drawn = 0;
    for (let y = Math.ceil(top) + 2; y < top + height - 2; y++) {
      for (let x = Math.ceil(left) + 2; x < left + width - 2; x++) {
        if (pixelAt(whole, x, y).some((code, i) => Math.abs(code - edge[i]!) > 20)) {
          drawn += 1;
        }
      }
    }
    expect(drawn, `the picture at ${String(top)}`).toBeGreaterThan(200);
  }
});
