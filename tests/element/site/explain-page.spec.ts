// Does the demo's page about one fragment show what shadeAt and the picture give, wherever mouse,
// finger or keyboard point? Served under the strict policy. Places are CSS pixels in the picture.

import type { Locator, Page } from '@playwright/test';
import { expect, pixelAt, pixels, test } from '../../support/test.js';
import { nextFrame, type PhongViewer, settled } from '../support/viewer.js';

/**
 * Shares of the width and height: on the body in the spot, on the body outside it, and on the lid.
 */
const PLACES = [
  [0.45, 0.56],
  [0.62, 0.6],
  [0.5, 0.36],
] as const;

/** The page's only live region. */
const result = (page: Page): Locator => page.locator('#result[role=status]');

async function open(page: Page): Promise<void> {
  await page.goto('/demo/explain/');
  await settled(page.locator('phong-viewer'));
  await expect(result(page)).not.toBeEmpty();
}

/** The numbers of the directions, and the texts of each step in the table of lights. */
const read = (page: Page) =>
  page.evaluate(() => {
    const rows = (id: string) =>
      Array.from(document.querySelectorAll(`#${id} tr`), (row) => ({
        title: row.querySelector('th')?.firstChild?.textContent ?? '',
        cells: Array.from(row.querySelectorAll('td'), (cell) => cell.textContent.trim()),
      }));
    const numbers = rows('directions').map(({ cells }) =>
      cells.map((text) => Number(text.replace('−', '-'))),
    );
    const NoL = rows('of-lights').find(({ title }) => title === 'N·L')!.cells;
    return { p: numbers[0]!, N: numbers[1]!, V: numbers[2]!, NoL };
  });

interface Place {
  readonly x: number;
  readonly y: number;
}

/** Shares of the picture as whole CSS pixels in it, and on the page. */
async function place(
  page: Page,
  [across, down]: readonly [number, number],
): Promise<[Place, Place]> {
  const box = (await page.locator('phong-viewer').boundingBox())!;
  const onPage = {
    x: Math.round(box.x + across * box.width),
    y: Math.round(box.y + down * box.height),
  };
  return [{ x: onPage.x - box.x, y: onPage.y - box.y }, onPage];
}

/** The middle of the probe's cross-hair, in the picture. */
async function markAt(page: Page): Promise<Place> {
  const viewer = (await page.locator('phong-viewer').boundingBox())!;
  const { x, y, width, height } = (await page.locator('.probe > .cursor').boundingBox())!;
  return { x: x + width / 2 - viewer.x, y: y + height / 2 - viewer.y };
}

/** Pixels from the mark to this place. */
const isAt = async (page: Page, { x, y }: Place): Promise<number> => {
  const mark = await markAt(page);
  return Math.hypot(mark.x - x, mark.y - y);
};

/** Compares all values on the page with shadeAt and toBlob at this place of the picture. */
async function expectFragment(page: Page, { x, y }: Place): Promise<void> {
  const viewer = page.locator('phong-viewer');
  const fragment = await viewer.evaluate(
    async (element: PhongViewer, at) => {
      const { p, N, V, color, shares } = (await element.shadeAt(at.x, at.y))!;
      return { p, N, V, color, NoL: shares.map((share) => share?.NoL ?? null) };
    },
    { x, y },
  );
  const codes = fragment.color.map((c) => (255 * c).toFixed(2)).join(' ');
  await expect(result(page)).toContainText(`The equation gives ${codes}; the pixel is `);
  const said = await read(page);
  for (const name of ['p', 'N', 'V'] as const) {
    fragment[name].forEach((value, i) =>
      // Printed with three decimals.
      expect(Math.abs(said[name][i]! - value), name).toBeLessThan(0.5001e-3),
    );
  }
  expect(said.NoL).toEqual(fragment.NoL.map((NoL) => NoL?.toFixed(3).replace('-', '−') ?? ''));
  const picture = await pixels(viewer);
  const { width, height } = (await viewer.boundingBox())!;
  const column = Math.floor((x * picture.width) / width);
  const row = Math.floor((y * picture.height) / height);
  const pixel = pixelAt(picture, column, row).slice(0, 3);
  pixel.forEach((code, i) => expect(Math.abs(code - 255 * fragment.color[i]!)).toBeLessThan(1));
  await expect(result(page)).toContainText(`the pixel is ${pixel.join(' ')}.`);
}

test.describe('the page of one fragment', () => {
  test('shows the values of shadeAt and of the picture at the mark, under the mouse, at a click', async ({
    page,
  }) => {
    await open(page);
    const start = await markAt(page);
    await expectFragment(page, start);
    for (const share of PLACES) {
      const [inPicture, onPage] = await place(page, share);
      await page.mouse.move(onPage.x, onPage.y);
      await expect.poll(() => isAt(page, inPicture)).toBeLessThan(0.1);
      await expectFragment(page, inPicture);
    }
    await page.mouse.move(1, 1);
    await expect
      .poll(() => isAt(page, start), 'a mouse that only looked leaves the mark alone')
      .toBeLessThan(1);
    const [inPicture, onPage] = await place(page, PLACES[0]);
    await page.mouse.click(onPage.x, onPage.y);
    await page.mouse.move(1, 1);
    await nextFrame(page);
    // It is on the centre of the pixel that was clicked.
    expect(await isAt(page, inPicture)).toBeLessThan(1);
    await expectFragment(page, await markAt(page));
  });

  test('follows the camera with the mark on its point, and a light that goes out', async ({
    page,
  }) => {
    await open(page);
    const start = await markAt(page);
    const before = await read(page);
    await page.locator('phong-viewer').evaluate((viewer: PhongViewer) => {
      viewer.theta = 38;
    });
    await expect.poll(async () => (await markAt(page)).x).toBeLessThan(start.x - 5);
    await expectFragment(page, await markAt(page));
    const turned = await read(page);
    expect(turned.V).not.toEqual(before.V);
    // The same point to the width of a pixel, about 2e-3 of the teapot.
    turned.p.forEach((x, i) => expect(Math.abs(x - before.p[i]!)).toBeLessThan(5e-3));

    await page.getByRole('checkbox', { name: 'sun' }).uncheck();
    await expect.poll(async () => (await read(page)).NoL[0]).toBe('');
    await expectFragment(page, await markAt(page));

    await page.locator('phong-viewer').evaluate((viewer: PhongViewer) => {
      viewer.theta = 218;
    });
    await expect(result(page), 'the point is on the far side now').toContainText('No surface');
    await expect(page.locator('#directions')).toBeHidden();
  });

  test('reads the picture once per change, and does nothing while nothing happens', async ({
    page,
  }) => {
    await open(page);
    const counts = await page.locator('phong-viewer').evaluateHandle((viewer: PhongViewer) => {
      const seen = { read: 0, shown: 0 };
      const { toBlob } = viewer;
      viewer.toBlob = (options) => {
        seen.read += 1;
        return toBlob.call(viewer, options);
      };
      viewer.addEventListener('probe-change', () => (seen.shown += 1));
      return seen;
    });
    const [, from] = await place(page, PLACES[0]);
    for (let i = 0; i <= 20; i++) {
      await page.mouse.move(from.x + 3 * i, from.y);
    }
    await expect.poll(async () => (await counts.jsonValue()).shown).toBeGreaterThan(0);
    await page.getByRole('slider', { name: 'shininess' }).fill('80');
    await expect.poll(async () => (await counts.jsonValue()).read).toBe(1);
    // Longer than the page waits before it announces the result.
    await page.waitForTimeout(1000);
    const rested = await counts.jsonValue();
    await page.waitForTimeout(1000);
    expect(await counts.jsonValue()).toEqual(rested);
    expect(rested.read, 'a mouse changes no picture').toBe(1);
  });
});
