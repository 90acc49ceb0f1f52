// Does a printed page show all pictures, also those below the fold, and their CSS backgrounds?
import { expect, test } from '../../support/test.js';
import { decodePng, type Picture } from '../../support/picture.js';

test('draws pictures below the fold before the page is printed', async ({ mount, page }) => {
  const viewer = await mount('<div id="above"></div><phong-viewer geometry="sphere"></phong-viewer>', {
    css: '#above { height: 5000px }',
  });
  const frames = () =>
    viewer.evaluate((element) => (element as unknown as { stats: { frames: number } }).stats.frames);
  expect(await frames()).toBe(0);
  await page.pdf();
  expect(await frames()).toBe(1);
});

test('prints the mean of all samples with `antialias="full"`, in view or not', async ({ mount, page }) => {
  const viewer = '<phong-viewer geometry="sphere" antialias="full" samples="64"></phong-viewer>';
  await mount(`${viewer}<div id="above"></div>${viewer}`, {
    width: 60,
    height: 40,
    css: '#above { height: 5000px }',
  });
  // Drawn anew, so that the first one is on its way again when the page is printed.
  await page.evaluate(() => (document.querySelector('phong-viewer')!.theta = 50));
  const printed = await page.evaluateHandle(() => {
    const samples: number[] = [];
    // After the viewers' own listeners.
    window.addEventListener('beforeprint', () => {
      for (const each of document.querySelectorAll('phong-viewer')) samples.push(each.stats.samples);
    });
    return samples;
  });
  await page.pdf();
  expect(await printed.jsonValue()).toEqual([64, 64]);
});

test('prints the CSS background behind every picture, on every page', async ({ mount, page, browser }) => {
  const count = 8;
  const viewer = '<phong-viewer geometry="box"></phong-viewer>';
  await mount(viewer.repeat(count), {
    width: 200,
    height: 180,
    css: 'phong-viewer { background: #f00 } @page { size: 300px 400px; margin: 0 }',
  });
  const pdf = await page.pdf({ printBackground: true, preferCSSPageSize: true });
  // Chromium's own viewer shows the pages below each other.
  const reader = await browser.newPage({ viewport: { width: 500, height: 1700 } });
  await reader.setContent('<style>body { margin: 0 } embed { width: 500px; height: 1700px }</style>');
  await reader.evaluate((base64) => {
    const embed = document.createElement('embed');
    embed.type = 'application/pdf';
    embed.src = `data:application/pdf;base64,${base64}#toolbar=0`;
    document.body.append(embed);
  }, pdf.toString('base64'));
  await expect
    .poll(async () => redBoxes(decodePng(await reader.screenshot())), { timeout: 30_000 })
    .toBe(count);
  await reader.close();
});

/** Runs of at least 100 red pixels, read down the column that has the most red. */
function redBoxes({ width, height, data }: Picture): number {
  let most = 0;
  for (let x = 0; x < width; x++) {
    let boxes = 0;
    let run = 0;
    for (let y = 0; y < height; y++) {
      const at = 4 * (y * width + x);
      run = data[at]! > 240 && data[at + 1]! < 20 && data[at + 2]! < 20 ? run + 1 : 0;
      if (run === 100) boxes += 1;
    }
    most = Math.max(most, boxes);
  }
  return most;
}
