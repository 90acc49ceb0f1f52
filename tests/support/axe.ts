// axe without what costs most: a tab of its own for each run, which serves frames of other hosts,
// and lists of what passes.

import AxeBuilder from '@axe-core/playwright';
import { expect, type Page } from '@playwright/test';

/** axe over this page, whose result holds only violations. */
export const axeOn = (page: Page): AxeBuilder =>
  new AxeBuilder({ page }).setLegacyMode().options({ resultTypes: ['violations'] });

/** axe finds no fault on this page, in forced colours neither. */
export async function expectNoFaults(page: Page): Promise<void> {
  for (const forcedColors of ['none', 'active'] as const) {
    await page.emulateMedia({ forcedColors });
    expect((await axeOn(page).analyze()).violations, forcedColors).toEqual([]);
  }
}
