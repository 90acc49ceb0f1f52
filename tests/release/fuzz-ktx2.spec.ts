// Can a damaged KTX2 texture hang a page or exhaust its memory? Damaged copies of valid files,
// unpacked in the worker.

import { readFileSync } from 'node:fs';
import { GROWTH_LIMIT_MB, load, MemoryWatch } from '../fuzz/model-run.js';
import { Random } from '../stress/random.js';
import { launchOptions } from '../support/built-pages.mjs';
import { startSite, testMounts, wasmPolicy } from '../support/site.js';
import { expect, test } from '../support/test.js';
import { SEED } from '../support/repeats.js';

const COUNT = 300;
const files = ['ktx2', 'ktx2-etc1s'].map((name) =>
  readFileSync(new URL(`../fixtures/models/${name}.glb`, import.meta.url)),
);

/** A file with some of its texture's bytes changed, most of them in the header. */
function damaged(random: Random): Buffer {
  const bytes = Buffer.from(files[Math.floor(random.from(0, files.length))]!);
  const start = bytes.indexOf('\xabKTX 20', 0, 'latin1') + 12;
  for (let change = random.from(1, 6); change > 0; change--) {
    const end = random.from(0, 1) < 0.7 ? Math.min(start + 200, bytes.length) : bytes.length;
    const at = Math.floor(random.from(start, end));
    bytes[at] = [0, 255, 128, Math.floor(random.from(0, 256))][Math.floor(random.from(0, 4))]!;
  }
  return bytes;
}

// Chromium's headless shell crashes where WebAssembly reads out of bounds, which the transcoder
// does in damaged files.
test.use({ launchOptions: await launchOptions('', []) });

test(`@release ${COUNT} damaged textures end in events (seed ${SEED})`, async ({
  browser,
  consoleGuard,
  page,
}) => {
  consoleGuard.allow(/images\[0\]/);
  test.setTimeout(900_000);
  const random = new Random(SEED);
  const site = await startSite(testMounts, wasmPolicy);
  await page.goto(
    site.page('<phong-viewer></phong-viewer>', {
      csp: wasmPolicy,
      css: 'phong-viewer { display: block; width: 60px; height: 40px }',
      head: '<script type="module" src="/dist/phong-viewer.standalone.js"></script>',
    }),
  );
  const viewer = page.locator('phong-viewer');
  expect(await load(viewer, '/fixtures/models/ktx2.glb')).toBe('load');
  const memory = await MemoryWatch.of(browser);
  const outcomes: Record<string, number> = {};
  for (let i = 0; i < COUNT; i++) {
    memory.start();
    const outcome = await load(viewer, `${site.file(damaged(random))}?${i}`);
    expect(memory.stop(), `growth in MB of file ${i}`).toBeLessThan(GROWTH_LIMIT_MB);
    expect(outcome, `file ${i}`).toMatch(/^(load|bad-model|too-large)$/);
    outcomes[outcome] = (outcomes[outcome] ?? 0) + 1;
  }
  console.log(`seed ${SEED}: ${JSON.stringify(outcomes)}`);
  expect(await load(viewer, '/fixtures/models/ktx2.glb')).toBe('load');
  await site.close();
});
