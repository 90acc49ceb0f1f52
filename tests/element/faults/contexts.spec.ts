// What happens when the graphics context fails: refused, lost while it is created, lost again, lost
// under toBlob, too large?

import { expect, pixels, same, test } from '../../support/test.js';
import { fullOr } from '../../support/repeats.js';
import { installFaults, type Opening } from './faults.js';
import { canvasSize, framesOf, nextFrame, record, settled } from '../support/viewer.js';

const SIZE = { width: 120, height: 90 };
const box =
  '<phong-viewer geometry="box"><phong-light position="1 2 3 0"></phong-light></phong-viewer>';

test.beforeEach(({ page }) => installFaults(page));

for (const count of [1, 2]) {
  test(`a refused context is an error with a message, and tried again (${count} viewers)`, async ({
    mount,
    page,
  }) => {
    const expected = await pixels(await mount(box.repeat(count), SIZE));
    await page.addInitScript(() => {
      window.faults.opening = 'throws';
      const note = ({ detail }: Event & { detail?: unknown }): unknown =>
        Object.assign(window, { detail });
      addEventListener('error', note, true); // capturing, because the event does not bubble
    });
    const viewer = await mount(box.repeat(count), SIZE);
    const notices = page.locator('phong-viewer [part=notice]');
    const events = await record(viewer, 'error', 'render');
    const asked = () => page.evaluate(() => window.faults.asked);
    await expect(notices).toHaveCount(count);
    await expect(notices.first()).toContainText(/WebGL 2/);
    expect(await page.evaluate('window.detail.code')).toBe('no-webgl2');

    // Changes request no context: a script may make one in each frame. Pictures do.
    const html = await viewer.evaluate(async (element) => {
      element.theta = 77;
      await element.ready;
      const markup = element.toHTML();
      element.theta = 30;
      return markup;
    });
    expect(html).toContain('theta="77"');
    await nextFrame(page);
    expect(await asked()).toBe(1);
    await expect(pixels(viewer)).rejects.toThrow();

    // The page becomes visible again.
    const show = (opening: Opening) =>
      page.evaluate((next) => {
        window.faults.opening = next;
        document.dispatchEvent(new Event('visibilitychange'));
      }, opening);
    await show('null');
    await nextFrame(page);
    expect(await asked()).toBe(3);
    expect(await events.take()).toEqual([]);
    await show('works');
    await expect(notices).toHaveCount(0);
    await nextFrame(page);
    expect(await events.take()).toEqual([{ type: 'render', detail: null }]);
    same(await pixels(viewer), expected);
  });
}

test('a context lost at any call of the first picture is reported once and restored', async ({
  mount,
  page,
}) => {
  test.slow();
  const expected = await pixels(await mount(box, SIZE));
  const calls = await page.evaluate(async (html) => {
    document.body.replaceChildren();
    await new Promise((resolve) => setTimeout(resolve));
    window.faults.callsLeft = 1e6;
    document.body.innerHTML = html;
    await document.querySelector('phong-viewer')!.ready;
    return 1e6 - window.faults.callsLeft;
  }, box);
  expect(calls).toBeGreaterThan(60);
  for (let call = 0; call < calls; call += call < 40 ? fullOr(1, 3) : fullOr(7, 21)) {
    const isLost = await page.evaluate(
      async ({ html, call }) => {
        document.body.replaceChildren();
        await new Promise((resolve) => setTimeout(resolve));
        window.faults.callsLeft = call;
        document.body.innerHTML = html;
        const viewer = document.querySelector('phong-viewer')!;
        viewer.addEventListener('error', ({ detail }) => (viewer.title += detail.code));
        await Promise.race([
          viewer.ready,
          new Promise((resolve) => viewer.addEventListener('error', resolve, { once: true })),
        ]);
        return window.faults.callsLeft === Infinity;
      },
      { html: box, call },
    );
    // The number of calls that ask for a program's state varies a little.
    if (!isLost) {
      expect(call).toBeGreaterThan(0.95 * calls);
      break;
    }
    const viewer = page.locator('phong-viewer');
    await expect(viewer.locator('[part=notice]')).toContainText('context was lost');
    await expect(viewer, `call ${call}`).toHaveAttribute('title', 'context-lost');
    await page.evaluate(() => window.faults.restore());
    await expect(viewer.locator('[part=notice]')).toHaveCount(0);
    await settled(viewer);
    same(await pixels(viewer), expected, `call ${call}`);
  }
});

test('a context lost again while it is restored comes back later, for new viewers too', async ({
  mount,
  page,
}) => {
  const viewer = await mount(box, SIZE);
  const expected = await pixels(viewer);
  const notices = page.locator('phong-viewer [part=notice]');
  const events = await record(viewer, 'error');
  await page.evaluate(() => window.faults.lose());
  await expect(notices).toHaveCount(1);
  await page.evaluate((html) => document.body.insertAdjacentHTML('beforeend', html), box);
  await expect(notices).toHaveCount(2);
  for (const calls of [0, 1, 10, 100]) {
    await page.evaluate((count) => {
      window.faults.restore();
      window.faults.callsLeft = count;
    }, calls);
    await nextFrame(page);
    await nextFrame(page);
    if (calls < 100) {
      await expect(notices).toHaveCount(2);
    }
  }
  await page.evaluate(() => {
    window.faults.callsLeft = Infinity;
    window.faults.restore();
  });
  await expect(notices).toHaveCount(0);
  for (const one of await page.locator('phong-viewer').all()) {
    same(await pixels(one), expected);
  }
  expect((await events.take()).length).toBeLessThanOrEqual(2);
});

test('toBlob rejects if the context is lost before its event arrives or between two tiles', async ({
  mount,
}) => {
  const viewer = await mount(box, SIZE);
  for (const width of [50, 5000]) {
    const outcomes = await viewer.evaluate(async (element, side) => {
      const picture = () =>
        element.toBlob({ width: side, height: 60 }).then(() => 'a picture', String);
      const wait = () => new Promise((resolve) => setTimeout(resolve, 50));
      if (side > 4096) {
        window.faults.callsLeft = 1e6;
        await picture();
        window.faults.callsLeft = Math.floor((1e6 - window.faults.callsLeft) * 0.6);
      } else {
        window.faults.lose();
      }
      const first = await picture();
      await wait();
      const second = await picture();
      window.faults.restore();
      await wait();
      return [first, second, await picture()];
    }, width);
    const message = 'Error: the graphics context is lost';
    expect(outcomes, String(width)).toEqual([message, message, 'a picture']);
  }
});
test('a picture larger than the GPU allows keeps its shape, with four screens of pixels', async ({
  mount,
  page,
}) => {
  test.slow();
  const fourScreens = await page.evaluate(() => 4 * screen.width * screen.height);
  const first = await mount(box, { width: 8192, height: 8192 });
  await expect(first.locator('[part=notice]')).toHaveCount(0);
  const [side, height] = await canvasSize(first);
  expect(side).toBe(height);
  expect((side * height) / fourScreens).toBeCloseTo(1, 2);
  expect(await framesOf(first)).toBe(1);
  const viewer = await mount(box.repeat(2), SIZE);
  for (const [width, height] of [
    [20000, 100],
    [9000, 6000],
  ] as const) {
    await viewer.evaluate(
      (element, css) => (element.style.cssText = css),
      `width: ${width}px; height: ${height}px`,
    );
    await nextFrame(page);
    const [w, h] = await canvasSize(viewer);
    const most = Math.sqrt((fourScreens * width) / height);
    expect(w).toBeGreaterThanOrEqual(Math.min(4096, 0.99 * most));
    expect(w).toBeLessThan(width);
    expect(Math.abs(w / h / (width / height) - 1)).toBeLessThan(0.03); // whole pixels
  }
});
