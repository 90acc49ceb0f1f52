// A page that has lived shows what a new one shows: random histories of one to three viewers, held now and then against a page
// that begins with the same scene. Failures print the seed and the shortest history that still fails.

import { test } from '../support/test.js';
import { Player, walk } from './history.js';
import { walkOn } from './history-page.js';

const FIRST = Number(process.env['PHONG_VIEWER_SEED'] ?? 1);
const WALKS = Number(process.env['PHONG_VIEWER_WALKS'] ?? 6);
const seeds = (count: number): number[] => Array.from({ length: count }, (_, i) => FIRST + i);

test('a page that has lived shows what a new one shows', async ({ page, mount, site, consoleGuard }) => {
  test.setTimeout(1_800_000);
  consoleGuard.allow(/expected .*; using .* instead\./);
  await walkOn(page);
  const player = new Player(page, mount, site);
  try {
    await walk(player, seeds(WALKS), 6);
  } finally {
    const { looks, same, exact, between } = player.findings;
    console.log(
      `Seeds from ${FIRST}: ${looks} looks, ${same} pairs by the same programs, ${exact} exact; else ${String(between)}`,
    );
  }
  player.findings.between.expectPromise();
});
