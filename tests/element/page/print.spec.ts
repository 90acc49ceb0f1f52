// Does a printed page show all pictures, also those below the fold, and their CSS backgrounds?
import { type Browser, chromium, type Page } from '@playwright/test';
import { findBrowser, softwareGl } from '../../../.ci/browser.mjs';
import { expect, test } from '../../support/test.js';
import { nextFrame } from '../support/viewer.js';
import { decodePng, type Picture } from '../../support/picture.js';

/** Has a PDF viewer, other than headless shells. */
let launched: Browser | null = null;

test.afterAll(async () => launched?.close());

test('prints the mean of all samples, also after an exception', async ({
  mount,
  page,
  consoleGuard,
}) => {
  const ball = '<phong-viewer geometry="sphere" antialias="full" samples="64"></phong-viewer>';
  const first = await mount(`${ball.replace('full', 'edges')}${ball}<div></div>${ball}`, {
    width: 60,
    height: 40,
    css: 'div { height: 5000px }',
  });
  const thrown = consoleGuard.allow(/an object of the page throws/);
  await first.evaluate((element) => {
    element.scene.onBeforeRender = () => {
      throw new Error('an object of the page throws');
    };
  });
  // Drawn anew, so that the second one is on its way again when the page is printed.
  await page.evaluate(() => (document.querySelectorAll('phong-viewer')[1]!.theta = 50));
  const printed = await page.evaluateHandle(() => {
    const samples: number[] = [];
    // After the viewers' own listeners.
    window.addEventListener('beforeprint', () => {
      for (const { stats } of document.querySelectorAll('phong-viewer')) {
        samples.push(stats.samples);
      }
    });
    return samples;
  });
  await page.pdf();
  expect(thrown.length).toBeGreaterThan(0);
  expect((await printed.jsonValue()).slice(1)).toEqual([64, 64]);
});

test('prints CSS backgrounds on every page, and round shapes round on narrow paper', async ({
  mount,
  page,
}) => {
  const viewer = '<phong-viewer geometry="box"></phong-viewer>';
  await mount(viewer.repeat(4), {
    width: 200,
    height: 180,
    css: 'phong-viewer { background: #f00; margin-bottom: 4px } @page { size: 300px 400px; margin: 0 }',
  });
  for (const shape of await redShapesOnPaper(page, 4)) {
    expect(shape).toBeCloseTo(200 / 180, 1);
  }
  const ball = (attributes: string) =>
    `<phong-viewer geometry="sphere" ka="255 0 0" kd="0" ks="0" ${attributes}><phong-light ambient="255"></phong-light></phong-viewer>`;
  await mount(ball('gui') + ball(''), {
    css: `body { margin: 0 } phong-viewer { display: block; width: 100% !important; height: 300px }
      @page { size: 420px 700px; margin: 0 }`,
  });
  await expect(page.locator('.lil-root')).toBeVisible();
  await nextFrame(page);
  for (const shape of await redShapesOnPaper(page, 2)) {
    expect(Math.abs(shape - 1)).toBeLessThan(0.05);
  }
});

/**
 * Runs in the page: where the marks over the pictures are, in shares of the pictures as they are
 * shown, and the colours of the texts. `classNames`: of the body, one after the other in one task.
 * No script of the page runs, as when paper is laid out.
 */
function marksOverPictures(classNames: readonly string[]) {
  return classNames.map((className) => {
    const places: number[] = [];
    const inks = new Set<string>();
    document.body.className = className;
    for (const { shadowRoot } of document.querySelectorAll('phong-viewer')) {
      const canvas = shadowRoot!.querySelector('canvas')!;
      const box = canvas.getBoundingClientRect();
      const scale = Math.min(box.width / canvas.width, box.height / canvas.height);
      for (const mark of shadowRoot!.querySelectorAll(
        ':is(.helpers, .probe) > svg :is(circle, text), .pointed',
      )) {
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
  });
}

test('paper of another width keeps N at its foot, and lights, axes and rings at their places', async ({
  mount,
  page,
}) => {
  const light = '<phong-light name="lamp" position="1 2 1 1"></phong-light>';
  const viewer = (attributes: string) =>
    `<phong-viewer geometry="sphere" helpers="lights axes" probe probe-at="0 0 0.5" ${attributes}>${light}</phong-viewer>`;
  await mount(
    viewer('gui') +
      viewer('view="diffuse"') +
      '<phong-viewer id="v" geometry="sphere"></phong-viewer><phong-probe for="v" at="0 0 0.5"></phong-probe>',
    {
      css: `phong-viewer { width: 100% !important; height: 360px !important } .paper { width: 520px }
      :root { color-scheme: dark }`,
    },
  );
  await expect(page.locator('.box, .pointed:not([hidden])')).toHaveCount(3);
  await expect(page.locator('.legend')).toHaveCount(1);
  await page.emulateMedia({ media: 'print' });
  const [screen, paper] = await page.evaluate(marksOverPictures, ['', 'paper']);
  await page.emulateMedia({ media: null });
  const { places } = screen!;
  expect(places.length).toBeGreaterThan(16);
  expect(paper!.places.length).toBe(places.length);
  paper!.places.forEach((place, i) => expect(place).toBeCloseTo(places[i]!, 2));
  expect(paper!.inks).toEqual([
    'rgb(0, 0, 0) on rgb(255, 255, 255)',
    'rgb(0, 0, 0) on rgba(0, 0, 0, 0)',
  ]);
});

/**
 * Shows a PDF by Chromium's own viewer, its pages below each other. Skips the test where no browser
 * has one.
 */
async function readPdf(pdf: Buffer) {
  const executablePath = await findBrowser();
  const own = executablePath === undefined ? {} : { executablePath };
  launched ??= await chromium.launch({ ...own, args: softwareGl });
  const reader = await launched.newPage({ viewport: { width: 500, height: 1700 } });
  const showsPdf = await reader.evaluate(() => navigator.pdfViewerEnabled);
  test.skip(!showsPdf, 'no browser on this machine shows a PDF');
  await reader.setContent(
    '<style>body { margin: 0 } embed { width: 500px; height: 1700px }</style>',
  );
  await reader.evaluate((base64) => {
    const embed = document.createElement('embed');
    embed.type = 'application/pdf';
    embed.src = `data:application/pdf;base64,${base64}#toolbar=0`;
    document.body.append(embed);
  }, pdf.toString('base64'));
  return reader;
}

/**
 * Prints the page. Returns width over height of each of the `count` red shapes on paper, from the
 * top.
 */
async function redShapesOnPaper(page: Page, count: number) {
  const reader = await readPdf(await page.pdf({ printBackground: true, preferCSSPageSize: true }));
  let shapes: number[] = [];
  const found = async () => {
    shapes = redShapes(decodePng(await reader.screenshot()));
    return shapes.length;
  };
  await expect.poll(found, { timeout: 30_000 }).toBe(count);
  await reader.close();
  return shapes;
}

function redShapes({ width, height, data }: Picture) {
  const isRed = (at: number) => data[at]! > 240 && data[at + 1]! < 20 && data[at + 2]! < 20;
  const widths = Array.from({ length: height }, (_, y) => {
    let count = 0;
    for (let x = 0; x < width; x++) {
      if (isRed(4 * (y * width + x))) {
        count += 1;
      }
    }
    return count;
  });
  const shapes: number[] = [];
  for (let y = 0; y < height; y++) {
    const from = y;
    while (widths[y]! > 0) {
      y += 1;
    }
    if (y - from > 20) {
      shapes.push(Math.max(...widths.slice(from, y)) / (y - from));
    }
  }
  return shapes;
}
