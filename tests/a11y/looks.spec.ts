// Is the focus visible on any picture, are targets large enough, and is no message cut off?
// Measured on the drawn page.

import { expect, test } from '../support/test.js';
import { nextFrame } from '../element/support/viewer.js';
import { contrast, screenshot } from './contrast.js';

/** WCAG 2.2, 1.4.11: parts that are needed to understand a control stand out by this ratio. */
const CONTRAST = 3;

for (const media of [
  {},
  { colorScheme: 'dark' },
  { forcedColors: 'active' },
  { forcedColors: 'active', colorScheme: 'dark' },
] as const) {
  test(`the focus stands out from any picture: ${JSON.stringify(media)}`, async ({
    page,
    mount,
  }) => {
    await page.emulateMedia(media);
    const viewer = await mount('<phong-viewer></phong-viewer>', {
      width: 80,
      height: 60,
      css: ':root { color-scheme: light dark; forced-color-adjust: none } phong-viewer { background: var(--picture) }',
    });
    await page.keyboard.press('Tab');
    for (const picture of ['#000', '#fff', '#767676', '#f00', '#00f', '#4a90d9']) {
      await page.evaluate(
        (color) => document.documentElement.style.setProperty('--picture', color),
        picture,
      );
      await nextFrame(page);
      const at = await screenshot(viewer);
      for (const [x, y] of [
        [-1, 0],
        [1, 0],
        [0, -1],
        [0, 1],
      ] as const) {
        /** The colour at this distance from the edge on that side. */
        const from = (edge: number) =>
          at(40 + x * (40 - edge) - (x > 0 ? 1 : 0), 30 + y * (30 - edge) - (y > 0 ? 1 : 0));
        const ring = [from(1), from(3)] as const;
        expect(contrast(...ring), `the ring's two colours on ${picture}`).toBeGreaterThanOrEqual(
          CONTRAST,
        );
        const best = Math.max(...ring.map((color) => contrast(color, from(8))));
        expect(best, `the ring on ${picture}`).toBeGreaterThanOrEqual(CONTRAST);
      }
    }
  });
}

/** WCAG 2.2, 2.5.8, CSS pixels. */
const TARGET = 24;

test('all targets in panel and message have at least 24 pixels', async ({
  page,
  mount,
  consoleGuard,
}) => {
  consoleGuard.allow(/404/);
  const viewer = await mount(
    `<phong-viewer alt="A box" gui geometry="box" src="/none.glb">
      <phong-light name="sun"></phong-light>
      <phong-light name="spot" position="0 3 3 1" axis="0 -1 -1" aperture="20"></phong-light>
      <phong-mesh name="floor" geometry="plane"></phong-mesh></phong-viewer>`,
    { width: 600, height: 650 },
  );
  await expect(viewer.locator('.lil-root')).toBeVisible();
  await viewer.evaluate((element) => {
    const closed = (): HTMLElement | null =>
      element.shadowRoot!.querySelector('.lil-closed > .lil-title');
    for (let title = closed(); title !== null; title = closed()) {
      title.click();
    }
  });
  await nextFrame(page);
  const small = viewer.evaluate((element, least) => {
    const controls = element.shadowRoot!.querySelectorAll(
      'button, input, select, textarea, summary, a[href]',
    );
    return Array.from(controls).flatMap((control) => {
      // A label counts with its field.
      const { width, height } = (control.closest('label') ?? control).getBoundingClientRect();
      const isSmall = width > 0 && (width < least || height < least);
      const name =
        control.getAttribute('aria-label') ?? control.closest('.lil-controller')?.textContent ?? '';
      return isSmall ? [`${name} <${control.localName}> ${width} × ${height}`] : [];
    });
  }, TARGET);
  expect(await small).toEqual([]);
});

test('a message longer than the viewer can be scrolled', async ({ page, mount, consoleGuard }) => {
  consoleGuard.allow(/404/);
  const viewer = await mount(
    `<phong-viewer alt="None" src="/${'none'.repeat(60)}.glb"></phong-viewer>`,
    {
      width: 160,
      height: 80,
    },
  );
  await expect(viewer.getByRole('alert')).toBeVisible();
  const hidden = await viewer.evaluate((element) => {
    const notice = element.shadowRoot!.querySelector('.notice')!;
    notice.scrollTop = 1e6;
    const { top } = element.getBoundingClientRect();
    const range = document.createRange();
    range.selectNodeContents(notice);
    const last = [...range.getClientRects()].at(-1)!;
    notice.scrollTop = 0;
    const first = range.getClientRects()[0]!;
    return [first.top < top, last.bottom > top + element.clientHeight];
  });
  expect(hidden).toEqual([false, false]);
  await nextFrame(page);
});
