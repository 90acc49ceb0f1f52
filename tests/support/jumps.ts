// How far the parts of a page move by themselves, as browsers count it (cumulative layout shift).

import type { Page } from '@playwright/test';

/** Counts from the next page on. */
export const countJumps = (page: Page): Promise<unknown> =>
  page.addInitScript(() => {
    Reflect.set(window, 'jumps', 0);
    new PerformanceObserver((list) => {
      for (const entry of list.getEntries()) {
        const jumps = Reflect.get(window, 'jumps') as number;
        Reflect.set(window, 'jumps', jumps + (Reflect.get(entry, 'value') as number));
      }
    }).observe({ type: 'layout-shift', buffered: true });
  });

export const jumpsOf = (page: Page): Promise<number> =>
  page.evaluate(() => Reflect.get(window, 'jumps') as number);
