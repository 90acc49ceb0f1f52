// How far are two pictures of one scene by two programs from each other? And how such pictures come
// about: pages of a few viewers at a time, drawn by general programs at first and by specialised
// ones once they keep being drawn.

import type { Locator, Page } from '@playwright/test';
import { drawUntilSpecialised } from '../element/frames/driving.js';
import { drawnWith, glSpent, isSpecialised, isLit } from '../element/support/gl-log.js';
import { statsOf } from '../element/support/viewer.js';
import { allReady, expect, pixels, type Picture } from '../support/test.js';

interface ProgramDifference {
  /** Codes. */
  readonly max: number;
  /** Channels that differ, and all channels of covered pixels. */
  readonly differing: number;
  readonly channels: number;
}

/**
 * A pixel that is covered in part has been drawn in as many codes less: there one code is several
 * of straight alpha, up to four where one sample of four is covered. Differences are those of what
 * was drawn.
 */
export function betweenPrograms(a: Picture, b: Picture): ProgramDifference {
  expect([a.width, a.height]).toEqual([b.width, b.height]);
  let max = 0;
  let differing = 0;
  let channels = 0;
  const drawn = ({ data }: Picture, i: number) => Math.round((data[i]! * data[i | 3]!) / 255);
  for (let i = 0; i < a.data.length; i++) {
    const shown = a.data[i | 3] !== 0 || b.data[i | 3] !== 0;
    if (i % 4 === 3 || !shown) continue;
    channels += 1;
    if (a.data[i] === b.data[i]) continue;
    differing += 1;
    max = Math.max(max, 1, Math.abs(drawn(a, i) - drawn(b, i)));
  }
  return { max, differing, channels };
}

export class DifferenceSum {
  max = 0;
  differing = 0;
  channels = 0;

  add({ max, differing, channels }: ProgramDifference): void {
    this.max = Math.max(this.max, max);
    this.differing += differing;
    this.channels += channels;
  }

  /** The contract: at most one code, on at most 0.02 % of the channels. */
  expectPromise(): void {
    expect(this.max).toBeLessThanOrEqual(1);
    expect(this.differing / this.channels).toBeLessThanOrEqual(2e-4);
  }

  toString(): string {
    const share = ((100 * this.differing) / this.channels).toFixed(4);
    return `${this.differing} of ${this.channels} channels differ (${share} %), by ${this.max} at most`;
  }
}

/** Viewers on a page at a time: few, so that their specialised programs take over soon. */
export const A_PAGE = 8;

/** Replaces the page's viewers by these. Returns a locator for each. */
export async function showAll(page: Page, markups: readonly string[]): Promise<Locator[]> {
  await page.evaluate((html) => (document.body.innerHTML = html), markups.join('\n'));
  await allReady(page);
  return markups.map((_, i) => page.locator('phong-viewer').nth(i));
}

/** Whether all lit programs since `glSpent` were of this kind. */
export async function expectDrawnBy(page: Page, kind: 'specialised' | 'general'): Promise<void> {
  const lit = (await drawnWith(page)).filter(isLit);
  expect(lit.length).toBeGreaterThan(0);
  expect(lit.map((one) => (isSpecialised(one) ? 'specialised' : 'general'))).toEqual(
    lit.map(() => kind),
  );
}

export async function picturesBy(
  page: Page,
  viewers: readonly Locator[],
  kind: 'specialised' | 'general',
  size: { readonly width: number; readonly height: number },
): Promise<Picture[]> {
  await glSpent(page);
  const pictures: Picture[] = [];
  for (const viewer of viewers) {
    pictures.push(await pixels(viewer, size));
  }
  await expectDrawnBy(page, kind);
  return pictures;
}

/**
 * Each viewer's picture by the general and by the specialised program. `markups`: at most A_PAGE
 * viewers of one mesh each.
 */
export async function bothPictures(
  page: Page,
  markups: readonly string[],
  size: { readonly width: number; readonly height: number },
) {
  const viewers = await showAll(page, markups);
  const general = await picturesBy(page, viewers, 'general', size);
  const { programs } = await statsOf(viewers[0]!);
  await drawUntilSpecialised(page);
  // Viewers of the same lights and surface share one.
  expect((await statsOf(viewers[0]!)).programs).toBeGreaterThan(programs);
  const specialised = await picturesBy(page, viewers, 'specialised', size);
  return general.map((picture, i) => ({ general: picture, specialised: specialised[i]! }));
}
