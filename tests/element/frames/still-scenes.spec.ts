// `antialias="full"`: does whatever a picture can show converge to its mean over each pixel?
// Against the mean of a plain picture with four times as many pixels along each side, which the
// code of samples has no part in.

import { readFileSync } from 'node:fs';
import { VIEWS } from '../../../src/phong/material/views.js';
import {
  type ViewerLocator,
  allReady,
  expect,
  type Picture,
  pixels,
  test,
} from '../../support/test.js';
import { countEverything, expectIdle } from '../support/counting.js';
import { assign, nextFrame, type PhongViewer, samplesOf, settled } from '../support/viewer.js';

const SIZE = { width: 48, height: 36 };
const TIMES = 4;
const light =
  '<phong-light name="a" position="1 2 3 0" ambient="40" attenuation="1 0.2 0"></phong-light>';
const spot =
  '<phong-light name="b" position="1 1 2 1" axis="-1 -1 -2" aperture="25" cutoff="4" diffuse="#f84" attenuation="1 0.2 0"></phong-light>';
const full = 'alt="" antialias="full" samples="64"';

type Means = readonly number[];

/** Codes, premultiplied: channels of each pixel, the mean of a square of `times` pixels. */
function meansOf({ width, height, data }: Picture, times: number): Means {
  const means = new Array<number>((4 * width * height) / times ** 2).fill(0);
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) {
      const from = 4 * (y * width + x);
      const to = 4 * (Math.floor(y / times) * (width / times) + Math.floor(x / times));
      const alpha = data[from + 3]!;
      for (const k of [0, 1, 2]) {
        means[to + k]! += (data[from + k]! * alpha) / 255 / times ** 2;
      }
      means[to + 3]! += alpha / times ** 2;
    }
  }
  return means;
}

const rmse = (a: Means, b: Means) =>
  Math.sqrt(a.reduce((sum, code, i) => sum + (code - b[i]!) ** 2, 0) / a.length);

/** Views whose picture depends on the size of a pixel: lines of a pixel's width. */
const BY_PIXEL: readonly string[] = ['triangles'];

/** Waits for all samples and holds the picture against the mean of a larger one. */
async function showsTheMean(viewer: ViewerLocator, what: string) {
  await settled(viewer);
  expect(await samplesOf(viewer), what).toBe(64);
  const shown = meansOf(await pixels(viewer), 1);
  const { width, height } = SIZE;
  const mean = BY_PIXEL.includes(what)
    ? meansOf(await pixels(viewer, { ...SIZE, samples: 64 }), 1)
    : meansOf(await pixels(viewer, { width: TIMES * width, height: TIMES * height }), TIMES);
  expect(rmse(shown, mean), what).toBeLessThan(2);
}

test('every view converges to its mean', async ({ mount }) => {
  const viewer = await mount(
    `<phong-viewer ${full} geometry="torus" segments="24" phi="60">${light}${spot}
      <phong-mesh geometry="plane" position="0 -0.4 0" scale="2"></phong-mesh></phong-viewer>`,
    SIZE,
  );
  for (const view of VIEWS) {
    await assign(viewer, { view });
    await showsTheMean(viewer, view);
  }
});

test('linear, flat, textured, blended and cut-out surfaces converge to their means', async ({
  page,
  mount,
}) => {
  const file = readFileSync(new URL('../../fixtures/models/mask.glb', import.meta.url), 'latin1');
  const blended = file.replace(/"MASK"(.*?) (?= *[^ ]{4}BIN)/s, '"BLEND"$1'); // a space less keeps its length
  await page.route('**/blended.glb', (route) =>
    route.fulfill({ body: Buffer.from(blended, 'latin1') }),
  );
  const viewers: Readonly<Record<string, string>> = {
    linear: 'geometry="box" color-interpolation="linear" shininess="200"',
    flat: 'geometry="sphere" segments="12" shading="flat" reflection="blinn-phong"',
    gouraud: 'geometry="sphere" segments="12" shading="gouraud"',
    textured: 'src="/fixtures/models/textured.glb"',
    blended: 'src="/blended.glb"',
    'cut out': 'src="/fixtures/models/mask.glb"',
  };
  const markup = Object.values(viewers).map(
    (attributes) => `<phong-viewer ${full} ${attributes}>${light}</phong-viewer>`,
  );
  await mount(markup.join(''), { ...SIZE, css: 'phong-viewer { background: red }' });
  await allReady(page);
  for (const [i, what] of Object.keys(viewers).entries()) {
    await showsTheMean(page.locator('phong-viewer').nth(i), what);
  }
});

test('both sides of a comparison converge, and moving its divider samples nothing again', async ({
  page,
  mount,
}) => {
  await countEverything(page);
  const side = (shading: string) =>
    `<phong-viewer ${full} geometry="sphere" segments="12" shading="${shading}">${light}</phong-viewer>`;
  await mount(`<phong-compare>${side('phong')}${side('gouraud')}</phong-compare>`, {
    css: `phong-compare { display: block; width: ${String(SIZE.width)}px; height: ${String(SIZE.height)}px }`,
  });
  const [first, second] = [
    page.locator('phong-viewer').first(),
    page.locator('phong-viewer').last(),
  ];
  await showsTheMean(first, 'left');
  await showsTheMean(second, 'right');
  const frames = (): Promise<readonly number[]> =>
    page.evaluate(() =>
      [...document.querySelectorAll<PhongViewer>('phong-viewer')].map(({ stats }) => stats.frames),
    );
  const before = await frames();
  for (const at of [20, 80]) {
    await page.evaluate((place) => (document.querySelector('phong-compare')!.at = [place]), at);
    await nextFrame(page);
    expect([await samplesOf(first), await samplesOf(second)], String(at)).toEqual([64, 64]);
  }
  expect(await frames()).toEqual(before);
  await assign(first, { theta: 70 });
  await expect.poll(() => samplesOf(first)).toBeGreaterThan(0);
  const turned = (await frames()).reduce((sum, count) => sum + count);
  await page.evaluate(() => (document.querySelector('phong-compare')!.at = [50]));
  await showsTheMean(first, 'turned');
  await showsTheMean(second, 'turned with it');
  expect(
    (await frames()).reduce((sum, count) => sum + count),
    'divider moved in the middle',
  ).toBe(turned);
  await nextFrame(page);
  await expectIdle(page, 200);
});
