// Does a printed page show all pictures, also those below the fold, and their CSS backgrounds?
import { type Browser, chromium, type Page } from '@playwright/test';
import { findBrowser, softwareGl } from '../../../.ci/browser.mjs';
import { expect, test } from '../../support/test.js';
import { decodePng, type Picture } from '../../support/picture.js';

/** Launched where the tests' own browser has no PDF viewer, as headless shells have none. */
let launched: Browser | null = null;

test.afterAll(async () => launched?.close());

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

test('prints the viewers after one whose own object throws', async ({ mount, page, consoleGuard }) => {
  const viewer = '<phong-viewer geometry="sphere"></phong-viewer>';
  await mount(viewer + '<div id="above"></div>' + viewer, {
    width: 60,
    height: 40,
    css: '#above { height: 5000px }',
  });
  const [first, second] = [page.locator('phong-viewer').first(), page.locator('phong-viewer').last()];
  await first.evaluate((element: HTMLElementTagNameMap['phong-viewer']) => {
    element.scene.onBeforeRender = () => {
      throw new Error('an object of the page throws');
    };
  });
  const thrown = consoleGuard.allow(/an object of the page throws/);
  await page.pdf();
  expect(thrown.length).toBeGreaterThan(0);
  expect(
    await second.evaluate((element: HTMLElementTagNameMap['phong-viewer']) => element.stats.frames),
  ).toBe(1);
});

test('prints the CSS background behind every picture, on every page', async ({ mount, page, browser }) => {
  const count = 8;
  const viewer = '<phong-viewer geometry="box"></phong-viewer>';
  await mount(viewer.repeat(count), {
    width: 200,
    height: 180,
    css: 'phong-viewer { background: #f00 } @page { size: 300px 400px; margin: 0 }',
  });
  const reader = await readPdf(browser, await page.pdf({ printBackground: true, preferCSSPageSize: true }));
  await expect
    .poll(async () => redBoxes(decodePng(await reader.screenshot())), { timeout: 30_000 })
    .toBe(count);
  await reader.close();
});

test('keeps round what is round where paper is narrower than the screen, with a panel open or not', async ({
  mount,
  page,
  browser,
}) => {
  const ball = (attributes: string): string =>
    `<phong-viewer geometry="sphere" ka="255 0 0" kd="0" ks="0" ${attributes}><phong-light ambient="255"></phong-light></phong-viewer>`;
  await mount(ball('gui') + ball(''), {
    css: `body { margin: 0 } phong-viewer { display: block; width: 100% !important; height: 300px }
      @page { size: 420px 700px; margin: 0 }`,
  });
  await expect(page.locator('.lil-root')).toBeVisible();
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
  const reader = await readPdf(browser, await page.pdf({ printBackground: true, preferCSSPageSize: true }));
  const shapes = async (): Promise<readonly number[]> => redShapes(decodePng(await reader.screenshot()));
  await expect.poll(async () => (await shapes()).length, { timeout: 30_000 }).toBe(2);
  for (const shape of await shapes()) expect(Math.abs(shape - 1)).toBeLessThan(0.05);
  await reader.close();
});

/**
 * Runs in the page: where the marks over the pictures are, in shares of the pictures as they are shown, and the colours
 * of the texts. `className`: that of the body meanwhile. No script of the page runs, as when paper is laid out.
 */
function marksOverPictures(className: string): { places: number[]; inks: string[] } {
  const places: number[] = [];
  const inks = new Set<string>();
  document.body.className = className;
  for (const { shadowRoot } of document.querySelectorAll('phong-viewer')) {
    const canvas = shadowRoot!.querySelector('canvas')!;
    const box = canvas.getBoundingClientRect();
    const scale = Math.min(box.width / canvas.width, box.height / canvas.height);
    for (const mark of shadowRoot!.querySelectorAll(':is(.helpers, .probe) > svg :is(circle, text)')) {
      const place = mark.getBoundingClientRect();
      const [x, y] = [place.x + place.width / 2, place.y + place.height / 2];
      places.push((x - box.x - box.width / 2) / (canvas.width * scale));
      places.push((y - box.y - box.height / 2) / (canvas.height * scale));
    }
    const texts = '.box, .box :not(.swatch, svg *), .legend, .legend-title';
    for (const text of shadowRoot!.querySelectorAll(texts)) {
      const { color, backgroundColor } = getComputedStyle(text);
      inks.add(`${color} on ${backgroundColor}`);
    }
  }
  document.body.className = '';
  return { places, inks: [...inks].sort() };
}

test('paper of another width keeps N at its foot, and lights and axes at their places', async ({
  mount,
  page,
}) => {
  const light = '<phong-light name="lamp" position="1 2 1 1"></phong-light>';
  const viewer = (attributes: string): string =>
    `<phong-viewer geometry="sphere" helpers="lights axes" probe probe-at="0 0 0.5" ${attributes}>${light}</phong-viewer>`;
  await mount(viewer('gui') + viewer('view="diffuse"'), {
    css: `phong-viewer { width: 100% !important; height: 360px !important } .paper { width: 520px }
      :root { color-scheme: dark }`,
  });
  await expect(page.locator('.box')).toHaveCount(2);
  await expect(page.locator('.legend')).toHaveCount(1);
  await page.emulateMedia({ media: 'print' });
  const { places: screen } = await page.evaluate(marksOverPictures, '');
  expect(screen.length).toBeGreaterThan(16);
  const paper = await page.evaluate(marksOverPictures, 'paper');
  await page.emulateMedia({ media: null });
  expect(paper.places.length).toBe(screen.length);
  paper.places.forEach((place, i) => expect(place).toBeCloseTo(screen[i]!, 2));
  expect(paper.inks).toEqual(['rgb(0, 0, 0) on rgb(255, 255, 255)', 'rgb(0, 0, 0) on rgba(0, 0, 0, 0)']);
});

/** Shows a PDF by Chromium's own viewer, its pages below each other. Skips the test where no browser has one. */
async function readPdf(own: Browser, pdf: Buffer): Promise<Page> {
  const browser = await browserWithPdfViewer(own);
  test.skip(browser === null, 'no browser on this machine shows a PDF');
  const reader = await browser!.newPage({ viewport: { width: 500, height: 1700 } });
  await reader.setContent('<style>body { margin: 0 } embed { width: 500px; height: 1700px }</style>');
  await reader.evaluate((base64) => {
    const embed = document.createElement('embed');
    embed.type = 'application/pdf';
    embed.src = `data:application/pdf;base64,${base64}#toolbar=0`;
    document.body.append(embed);
  }, pdf.toString('base64'));
  return reader;
}

async function browserWithPdfViewer(own: Browser): Promise<Browser | null> {
  if (await showsPdf(own)) return own;
  const executablePath = await findBrowser();
  launched ??= await chromium.launch({
    ...(executablePath === undefined ? {} : { executablePath }),
    args: softwareGl,
  });
  return (await showsPdf(launched)) ? launched : null;
}

async function showsPdf(browser: Browser): Promise<boolean> {
  const page = await browser.newPage();
  const shows = await page.evaluate(() => navigator.pdfViewerEnabled);
  await page.close();
  return shows;
}

/** Width over height of what is red, from the top. */
function redShapes(picture: Picture): number[] {
  const { width, height } = picture;
  const widths = Array.from({ length: height }, (_, y) => {
    let count = 0;
    for (let x = 0; x < width; x++) if (isRed(picture, 4 * (y * width + x))) count += 1;
    return count;
  });
  const shapes: number[] = [];
  for (let y = 0; y < height; y++) {
    const from = y;
    while (widths[y]! > 0) y += 1;
    if (y - from > 20) shapes.push(Math.max(...widths.slice(from, y)) / (y - from));
  }
  return shapes;
}

const isRed = ({ data }: Picture, at: number): boolean =>
  data[at]! > 240 && data[at + 1]! < 20 && data[at + 2]! < 20;

/** Runs of at least 100 red pixels, read down the column that has the most red. */
function redBoxes(picture: Picture): number {
  const { width, height } = picture;
  let most = 0;
  for (let x = 0; x < width; x++) {
    let boxes = 0;
    let run = 0;
    for (let y = 0; y < height; y++) {
      const at = 4 * (y * width + x);
      run = isRed(picture, at) ? run + 1 : 0;
      if (run === 100) boxes += 1;
    }
    most = Math.max(most, boxes);
  }
  return most;
}
