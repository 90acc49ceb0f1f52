// How many requests of a model wait for another one? What can be asked for together is: a page far
// from its server waits for each further one.

import { allReady, expect, test } from '../support/test.js';
import { startSite, testMounts, wasmPolicy } from '../support/site.js';
import { set } from '../element/support/viewer.js';
import { usages } from './requests.js';

const head = usages.standalone.head ?? '';

// One worker for all, so that the server stays.
test.describe.configure({ mode: 'default' });

/** The server answers after this time, ms. */
const ANSWER = 300;

const allowing = await startSite(testMounts, wasmPolicy);
test.afterAll(() => allowing.close());

for (const [model, rows] of [
  // The reader with the file, then its buffer, the decoder's worker and its WebAssembly together.
  ['/assets/models/real/engine/2CylinderEngine.gltf', 2],
  ['/assets/models/bunny.glb', 2],
  ['/fixtures/models/textured.glb', 1],
  ['/fixtures/models/coloured.ply', 1],
  // It names materials, and these an image.
  ['/fixtures/models/quads.obj', 3],
] as const) {
  test(`${model.replace(/.*\//, '')} is shown after ${rows} ${rows === 1 ? 'request' : 'requests'} in a row`, async ({
    page,
  }) => {
    await page.goto(
      allowing.page('<phong-viewer geometry="box"></phong-viewer>', { csp: wasmPolicy, head }),
    );
    await allReady(page);
    const begun: number[] = [];
    await page.context().route('**/*', async (route) => {
      begun.push(performance.now());
      await new Promise((resolve) => setTimeout(resolve, ANSWER));
      await route.continue();
    });
    await set(page.locator('phong-viewer'), { src: model });
    // Those of one row begin together, long before the first of them is answered.
    const starts = begun.filter((at, i) => i === 0 || at - begun[i - 1]! > ANSWER / 2);
    expect(begun.length).toBeGreaterThan(1);
    expect(starts).toHaveLength(rows);
  });
}
