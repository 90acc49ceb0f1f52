// Does the demo's page of one fragment show what shadeAt tells and what the picture holds, wherever a mouse, a finger or
// the keyboard points? Served as the demo is, under the strict policy. Places are CSS pixels in the picture.

import AxeBuilder from '@axe-core/playwright';
import type { Locator, Page } from '@playwright/test';
import { expect, pixelAt, pixels, test } from '../support/test.js';
import { assign, drag, nextFrame, type PhongViewer } from './support.js';

type Color = readonly number[];

/** What the page says. */
interface Told {
  readonly p: Color;
  readonly N: Color;
  readonly V: Color;
  /** As "sun ambient": red, green, blue in 255ths. */
  readonly terms: Readonly<Record<string, Color>>;
  readonly sum: Color;
  readonly clamped: Color;
  /** Empty until it is read. */
  readonly pixel: Color;
  readonly steps: Readonly<Record<string, readonly string[]>>;
}

/** Shares of the width and height: on the body in the spot, on the body outside it, and on the lid. */
const PLACES = [
  [0.45, 0.56],
  [0.62, 0.6],
  [0.5, 0.36],
] as const;

/** The one place that is announced. */
const result = (page: Page): Locator => page.locator('#result[role=status]');

async function open(page: Page): Promise<void> {
  await page.goto('/demo/explain/');
  await page.locator('phong-viewer').evaluate((viewer: PhongViewer) => viewer.ready);
  await expect(result(page)).not.toBeEmpty();
}

/** Where the mark is once it stays there: what a hand has begun goes on for a few frames. */
async function restingMark(page: Page): Promise<{ x: number; y: number }> {
  let last = await markAt(page);
  await expect
    .poll(
      async () => {
        const before = last;
        last = await markAt(page);
        return last.x === before.x && last.y === before.y;
      },
      { intervals: [250] },
    )
    .toBe(true);
  return last;
}

/** What the page says once it has read the pixel. */
async function told(page: Page): Promise<Told> {
  await expect.poll(async () => (await read(page)).pixel.length).toBe(3);
  await expect(result(page)).not.toBeEmpty();
  return read(page);
}

const read = (page: Page): Promise<Told> =>
  page.evaluate(() => {
    const cells = (row: Element, tag: string): string[] =>
      Array.from(row.querySelectorAll(tag), (cell) => cell.textContent.trim());
    const rows = (id: string): Element[] => [...document.querySelectorAll<HTMLElement>(`#${id} tr`)];
    const values = (row: Element | undefined): number[] =>
      row === undefined ? [] : cells(row, 'td').filter((text) => text !== '').map((text) => Number(text.replace('−', '-'))); // prettier-ignore
    const [p, N, V] = rows('directions').map(values);
    const terms: Record<string, number[]> = {};
    let light = '';
    for (const row of rows('sum').slice(0, -3)) {
      const names = cells(row, 'th');
      if (names.length === 2) light = names.shift()!;
      terms[`${light} ${names[0]!}`] = values(row);
    }
    const [sum, clamped, pixel] = rows('sum').slice(-3).map(values);
    const steps: Record<string, string[]> = {};
    for (const row of rows('of-lights'))
      steps[row.querySelector('th')!.firstChild!.textContent ?? ''] = cells(row, 'td');
    return { p: p!, N: N!, V: V!, terms, sum: sum!, clamped: clamped!, pixel: pixel!, steps };
  });

interface Place {
  readonly x: number;
  readonly y: number;
}

/** Shares of the picture as whole CSS pixels in it, and on the page. */
async function place(page: Page, [across, down]: readonly [number, number]): Promise<[Place, Place]> {
  const box = (await page.locator('phong-viewer').boundingBox())!;
  const onPage = { x: Math.round(box.x + across * box.width), y: Math.round(box.y + down * box.height) };
  return [{ x: onPage.x - box.x, y: onPage.y - box.y }, onPage];
}

const markAt = (page: Page): Promise<Place> =>
  page.locator('#vectors circle').evaluate((circle) => ({
    x: Number(circle.getAttribute('cx')),
    y: Number(circle.getAttribute('cy')),
  }));

/** Holds all that the page says against shadeAt and toBlob at this place of the picture. */
async function expectFragment(page: Page, { x, y }: Place): Promise<void> {
  const said = await told(page);
  const viewer = page.locator('phong-viewer');
  const fragment = await viewer.evaluate(
    async (element: PhongViewer, at) => {
      const found = await element.shadeAt(at.x, at.y);
      if (found === null) throw new Error('nothing is hit');
      const { p, N, V, sum, color } = found;
      const shares = found.shares.filter((share) => share !== null);
      return { p, N, V, sum, color, shares: shares.map(({ light: _element, ...rest }) => rest) };
    },
    { x, y },
  );
  const near = (shown: Color, exact: Color, digits: number, what: string): void => {
    expect(shown.length, what).toBe(3);
    // Printed with so many decimals.
    exact.forEach((value, i) =>
      expect(Math.abs(shown[i]! - value), what).toBeLessThan(0.5001 * 10 ** -digits),
    );
  };
  const full = (color: Color): Color => color.map((value) => 255 * value);
  near(said.p, fragment.p, 3, 'p');
  near(said.N, fragment.N, 3, 'N');
  near(said.V, fragment.V, 3, 'V');
  near(said.sum, full(fragment.sum), 2, 'sum');
  near(said.clamped, full(fragment.color), 2, 'clamped');
  for (const share of fragment.shares)
    for (const term of ['ambient', 'diffuse', 'specular'] as const)
      near(said.terms[`${share.name} ${term}`]!, full(share[term]), 2, `${share.name} ${term}`);
  const columns = Object.values(said.terms);
  const addedUp = said.sum.map((_, i) => columns.reduce((total, color) => total + color[i]!, 0));
  // Nine terms and their sum, each rounded to a hundredth.
  addedUp.forEach((value, i) => expect(Math.abs(value - said.sum[i]!)).toBeLessThan(0.05 + 1e-9));

  const picture = await pixels(viewer);
  const { width, height } = (await viewer.boundingBox())!;
  const column = Math.floor((x * picture.width) / width);
  const row = Math.floor((y * picture.height) / height);
  expect(said.pixel).toEqual(pixelAt(picture, column, row).slice(0, 3));
  said.pixel.forEach((code, i) => expect(Math.abs(code - said.clamped[i]!)).toBeLessThan(1));
  await expect(result(page)).toContainText(`the pixel is ${said.pixel.join(' ')}.`);
}

test.describe('the page of one fragment', () => {
  test('shows what shadeAt and the picture say at the mark and wherever the mouse points', async ({
    page,
  }) => {
    await open(page);
    const start = await markAt(page);
    await expectFragment(page, start);
    for (const share of PLACES) {
      const [inPicture, onPage] = await place(page, share);
      await page.mouse.move(onPage.x, onPage.y);
      await expect.poll(() => markAt(page)).toEqual(inPicture);
      await expectFragment(page, inPicture);
    }
    await page.mouse.move(1, 1);
    // A mouse that only looked leaves the mark alone: on the point whose pixel it was put on.
    await expect
      .poll(async () => {
        const { x, y } = await markAt(page);
        return Math.hypot(x - start.x, y - start.y);
      })
      .toBeLessThan(1);
  });

  test('keeps the mark where a click or a slider puts it, and says where no surface is', async ({ page }) => {
    await open(page);
    const [inPicture, onPage] = await place(page, PLACES[0]);
    await page.mouse.click(onPage.x, onPage.y);
    await page.mouse.move(1, 1);
    await nextFrame(page);
    const clicked = await markAt(page);
    // It is on the centre of the pixel that was clicked.
    expect(Math.hypot(clicked.x - inPicture.x, clicked.y - inPicture.y)).toBeLessThan(1);
    await expectFragment(page, clicked);

    const across = page.getByRole('slider', { name: 'across' });
    await across.focus();
    const before = Number(await across.inputValue());
    await page.keyboard.press('ArrowRight');
    await expect.poll(async () => Number(await across.inputValue())).toBe(before + 0.5);
    await expect.poll(async () => (await markAt(page)).x).toBeGreaterThan(clicked.x + 2);
    await expectFragment(page, await markAt(page));

    await page.keyboard.press('Home');
    await expect(result(page)).toContainText('No surface');
    await expect(page.locator('#sum')).toBeHidden();
  });

  test('follows the camera with the mark on its point, and a light that goes out', async ({ page }) => {
    await open(page);
    const before = await told(page);
    const start = await markAt(page);
    await page.locator('phong-viewer').evaluate((viewer: PhongViewer) => {
      viewer.theta = 38;
    });
    await expect.poll(async () => (await markAt(page)).x).toBeLessThan(start.x - 5);
    await expectFragment(page, await markAt(page));
    const turned = await told(page);
    expect(turned.V).not.toEqual(before.V);
    expect(turned.terms['sun ambient']).toEqual(before.terms['sun ambient']);
    // The same point to the width of a pixel, about 2e-3 of the teapot.
    turned.p.forEach((x, i) => expect(Math.abs(x - before.p[i]!)).toBeLessThan(5e-3));
    expect(turned.terms['sun specular']).not.toEqual(before.terms['sun specular']);

    const [, hand] = await place(page, PLACES[1]);
    await drag(page, [hand.x, hand.y], [-40, 10]);
    await page.mouse.move(1, 1);
    await expect.poll(async () => (await markAt(page)).x, 'a drag is no click').toBeLessThan(start.x);
    await expectFragment(page, await restingMark(page));
    const dragged = await told(page);
    expect(dragged.V).not.toEqual(turned.V);
    dragged.p.forEach((x, i) => expect(Math.abs(x - before.p[i]!)).toBeLessThan(5e-3));

    await page.getByRole('checkbox', { name: 'sun' }).uncheck();
    await expect.poll(async () => Object.keys((await read(page)).terms)).not.toContain('sun ambient');
    await expectFragment(page, await markAt(page));
    expect((await told(page)).steps['N·L']![0], 'no numbers for a light that is off').toBe('');

    await page.locator('phong-viewer').evaluate((viewer: PhongViewer) => {
      viewer.theta = 218;
    });
    await expect(result(page), 'the point is on the far side now').toContainText('No surface');
  });

  test('shows nothing for a marked point that the eye has passed, and it again where it is seen', async ({
    page,
  }) => {
    await open(page);
    const start = await told(page);
    const viewer = page.locator('phong-viewer');
    // The eye is inside the teapot now, on the line of sight through the point, and looks away from it.
    const target = start.p.map((x, i) => x - 0.2 * start.V[i]!);
    await assign(viewer, { target, radius: 0.1 });
    await expect(result(page)).toContainText('No surface');
    await assign(viewer, { target: 'auto', radius: 2.4 });
    await expect(result(page)).toContainText('The equation');
    expect((await told(page)).V).toEqual(start.V);
  });

  test('asks once at a time, reads the picture once a change, and rests while nothing happens', async ({
    page,
  }) => {
    await open(page);
    await told(page);
    const counts = await page.locator('phong-viewer').evaluateHandle((viewer: PhongViewer) => {
      const seen = { asked: 0, most: 0, read: 0 };
      let inFlight = 0;
      const { shadeAt, toBlob } = viewer;
      viewer.shadeAt = async (x, y) => {
        seen.asked += 1;
        inFlight += 1;
        seen.most = Math.max(seen.most, inFlight);
        const found = await shadeAt.call(viewer, x, y);
        inFlight -= 1;
        return found;
      };
      viewer.toBlob = (options) => {
        seen.read += 1;
        return toBlob.call(viewer, options);
      };
      return seen;
    });
    const [, from] = await place(page, PLACES[0]);
    await page.mouse.move(from.x, from.y);
    for (let i = 1; i <= 20; i++) await page.mouse.move(from.x + 3 * i, from.y);
    await told(page);
    const hovered = await counts.jsonValue();
    expect(hovered.most).toBe(1);
    expect(hovered.asked).toBeGreaterThan(0);
    expect(hovered.read, 'a mouse changes no picture').toBe(0);

    await page.getByRole('slider', { name: 'shininess' }).fill('80');
    await expect.poll(async () => (await counts.jsonValue()).read).toBe(1);
    await told(page);
    const rested = await counts.jsonValue();
    // Longer than the page waits before it reads and tells.
    await page.waitForTimeout(1000);
    expect(await counts.jsonValue()).toEqual(rested);
    expect(rested.most).toBe(1);
  });

  test.describe('under a finger', () => {
    test.use({ hasTouch: true, viewport: { width: 360, height: 720 } });

    test('takes a tap, fits a phone, and gives axe nothing to complain of', async ({ page }) => {
      await open(page);
      const [inPicture, onPage] = await place(page, PLACES[0]);
      await page.touchscreen.tap(onPage.x, onPage.y);
      await expect.poll(async () => Math.abs((await markAt(page)).x - inPicture.x)).toBeLessThan(1);
      await expectFragment(page, await markAt(page));
      expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(360);
      const { violations } = await new AxeBuilder({ page }).analyze();
      expect(violations).toEqual([]);
    });
  });
});
