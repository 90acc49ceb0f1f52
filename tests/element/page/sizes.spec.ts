// Does the canvas follow the element's size and the screen's pixels exactly, also while they
// change? Canvas sizes are in device pixels, everything else in CSS pixels.

import {
  type ViewerLocator,
  expect,
  pixels,
  setPixelRatio,
  same,
  test,
} from '../../support/test.js';
import { assign, canvasSize, nextFrame, record, set, htmlOf } from '../support/viewer.js';

const light = '<phong-light position="1 2 3 0"></phong-light>';
const box = `<phong-viewer geometry="box">${light}</phong-viewer>`;

const style = (viewer: ViewerLocator, css: string) =>
  viewer.evaluate((element, text) => (element.style.cssText = text), css);

test('is 300 × 150 without CSS, and otherwise as large as CSS says', async ({ page, mount }) => {
  const viewer = await mount(box, {
    css: 'phong-viewer { width: revert-layer; height: revert-layer }',
  });
  await page.evaluate(
    () => (document.querySelector<HTMLLinkElement>('link[rel=stylesheet]')!.disabled = true),
  );
  await expect.poll(() => canvasSize(viewer)).toEqual([300, 150]);
  for (const [css, width, height] of [
    ['width: 211px; height: 97px', 211, 97],
    ['width: 50%; height: 40vh; position: absolute', 500, 280],
    ['width: 100px; height: 60px; padding: 10px; border: 5px solid red', 120, 80],
    ['width: 90px; height: 60px; zoom: 2', 180, 120],
    ['width: 200px', 200, 100],
    ['width: 320px; aspect-ratio: 16 / 9', 320, 180],
  ] as const) {
    await style(viewer, css);
    await expect.poll(() => canvasSize(viewer), { message: css }).toEqual([width, height]);
  }
});

for (const count of [1, 2]) {
  test(`has the screen's pixels, or as pixel-ratio allows, live (${count} on the page)`, async ({
    page,
    mount,
  }) => {
    const viewer = await mount(box.repeat(count), { width: 121, height: 77 });
    for (const ratio of [1, 1.5, 2, 1, 3]) {
      await setPixelRatio(page, ratio);
      const wanted = await viewer.evaluate((element) => {
        const { left, right, top, bottom } = element.getBoundingClientRect();
        const snap = (x: number) => Math.round(x * devicePixelRatio);
        return [snap(right) - snap(left), snap(bottom) - snap(top)];
      });
      await expect.poll(() => canvasSize(viewer), { message: `ratio ${ratio}` }).toEqual(wanted);
    }
    for (const [ratio, width, height] of [
      [2, 242, 154],
      [1, 121, 77],
      [0.5, 61, 39],
      [1e-6, 1, 1],
      [10, 363, 231],
      ['1.5', 182, 116],
      [null, 363, 231],
    ] as const) {
      await set(viewer, { pixelRatio: ratio });
      expect(await canvasSize(viewer), String(ratio)).toEqual([width, height]);
    }
    expect(await htmlOf(viewer)).not.toContain('pixel-ratio');
  });
}

test('pixel-ratio gives the picture of such a screen; shadeAt keeps to CSS pixels', async ({
  page,
  mount,
}) => {
  const size = { width: 90, height: 60 };
  const plain = await mount(box, size);
  const expected = await pixels(plain);
  const place = await plain.evaluate(async (element) => (await element.shadeAt(45, 30))?.p);
  const limited = await mount(box.replace(' ', ' pixel-ratio="1" '), {
    ...size,
    deviceScaleFactor: 2,
  });
  expect(await page.evaluate(() => devicePixelRatio)).toBe(2);
  same(await pixels(limited), expected);
  expect(await limited.evaluate(async (element) => (await element.shadeAt(45, 30))?.p)).toEqual(
    place,
  );
  expect(await htmlOf(limited)).toContain('pixel-ratio="1"');
});

test('is right when shown after it was 0 × 0 or not displayed, at the start or later', async ({
  page,
  mount,
}) => {
  const size = { width: 90, height: 60 };
  const expected = await (await mount(box, size)).screenshot();
  for (const hidden of ['width: 0; height: 0', 'height: 0', 'display: none']) {
    const css = `phong-viewer.gone { ${hidden} }`;
    const gone = box.replace(' ', ' class="gone" ');
    const viewer = await mount(gone, { ...size, css, waitForReady: false });
    const shown = async () => {
      // At once: whatever stays without a size is warned of.
      await viewer.evaluate(async (element) => {
        await element.ready;
        element.removeAttribute('class');
      });
      await expect.poll(() => canvasSize(viewer)).toEqual([90, 60]);
      await nextFrame(page);
      expect(Buffer.compare(await viewer.screenshot(), expected), hidden).toBe(0);
    };
    await shown();
    const renders = await record(viewer, 'render');
    await viewer.evaluate((element) => element.setAttribute('class', 'gone'));
    await nextFrame(page);
    for (const theta of [99, 30]) {
      await assign(viewer, { theta });
    }
    await nextFrame(page);
    expect(await renders.take(), hidden).toEqual([]);
    await shown();
  }
});
for (const viewers of [1, 3]) {
  test(`draws a resized picture before the browser paints, once (${viewers} on the page)`, async ({
    page,
    mount,
  }) => {
    await mount(`<main>${box.repeat(viewers)}</main>`, {
      width: 0,
      height: 60,
      css: 'main { display: flex; width: 300px } phong-viewer { flex: 1 1 0 } .tall { height: 90px !important }',
    });
    const filmed = await page.evaluate(async () => {
      const main = document.querySelector('main')!;
      const viewers = [...document.querySelectorAll('phong-viewer')];
      const errors: string[] = [];
      addEventListener('error', ({ message }) => errors.push(message));
      let renders = 0;
      for (const viewer of viewers) {
        viewer.addEventListener('render', () => (renders += 1));
      }
      const wrong: number[][] = [];
      const frames = viewers.map(({ stats }) => stats.frames);
      const nextFrame = () => new Promise(requestAnimationFrame);
      await nextFrame();
      for (let step = 1; step <= 12; step++) {
        main.style.width = `${300 - 12 * step}px`;
        if (step === 6) {
          for (const viewer of viewers) {
            viewer.classList.add('tall');
          }
        }
        // The browser has painted when the next frame begins.
        await nextFrame();
        for (const viewer of viewers) {
          const { width, height } = viewer.shadowRoot!.querySelector('canvas')!;
          if (width !== viewer.clientWidth || height !== viewer.clientHeight) {
            wrong.push([width, height, viewer.clientWidth, viewer.clientHeight]);
          }
        }
      }
      await nextFrame();
      await nextFrame();
      const drawn = viewers.map(({ stats }, i) => stats.frames - frames[i]!);
      return { wrong, drawn, renders, errors };
    });
    expect(filmed).toEqual({
      wrong: [],
      drawn: Array(viewers).fill(12),
      renders: 12 * viewers,
      errors: [],
    });
  });
}
