// Do the demo's pages look as before? Compares every viewer of every page, drawn small and side by side, with a baseline.
import { allReady, compare, expect, expectPicture, pixelAt, pixels, test, type Picture } from '../support/test.js'; // prettier-ignore
import { decodePng } from '../support/picture.js';

const PAGES = [
  '',
  'bunny/',
  'shapes/',
  'article/',
  'lights/',
  'explain/',
  'gallery/',
  'guide/lights/',
  'guide/spots/',
  'guide/camera/',
  'guide/materials/',
  'guide/models/',
  'guide/see/',
  'guide/accuracy/',
  'guide/speed/',
];
const TILE = { width: 160, height: 120 };
const COLUMNS = 6;

function contactSheet(tiles: readonly Picture[]): Picture {
  const width = TILE.width * Math.min(COLUMNS, tiles.length);
  const height = TILE.height * Math.ceil(tiles.length / COLUMNS);
  const data = new Uint8Array(width * height * 4);
  tiles.forEach((tile, i) => {
    const left = (i % COLUMNS) * TILE.width;
    const top = Math.floor(i / COLUMNS) * TILE.height;
    for (let y = 0; y < TILE.height; y++) {
      const row = tile.data.subarray(y * TILE.width * 4, (y + 1) * TILE.width * 4);
      data.set(row, ((top + y) * width + left) * 4);
    }
  });
  return { width, height, data };
}

for (const path of PAGES) {
  const name = path === '' ? 'landing' : path.slice(0, -1).replace('/', '-');
  test(`the ${name} page looks as before, under a strict policy`, async ({ page }) => {
    test.setTimeout(120_000);
    await page.goto(`/demo/${path}`);
    await page.evaluate(() =>
      Promise.all(
        Array.from(document.querySelectorAll('phong-viewer'), async (viewer) => {
          await customElements.whenDefined('phong-viewer');
          // No viewer here is lazy, so models far down the page load as well.
          await (viewer as HTMLElement & { ready: Promise<void> }).ready;
        }),
      ),
    );
    const viewers = await page.locator('phong-viewer').all();
    const tiles: Picture[] = [];
    for (const viewer of viewers) tiles.push(await pixels(viewer, TILE));
    expect(tiles.length).toBeGreaterThan(0);
    const blank = { ...TILE, data: new Uint8Array(TILE.width * TILE.height * 4) };
    for (const tile of tiles) expect(compare(tile, blank).max, 'something is drawn').toBeGreaterThan(100);
    expectPicture(`demo-${name}`, contactSheet(tiles));
  });
}

test('a screenshot of the whole article shows every picture', async ({ page }) => {
  await page.goto('/demo/article/');
  await page.evaluate(() => customElements.whenDefined('phong-viewer').then(() => undefined));
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
        if (pixelAt(whole, x, y).some((code, i) => Math.abs(code - edge[i]!) > 20)) drawn += 1;
      }
    }
    expect(drawn, `the picture at ${String(top)}`).toBeGreaterThan(200);
  }
});
