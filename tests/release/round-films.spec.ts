// The long forms of element/children/segments.spec.ts: a hundred loads, and longer zooms in larger pictures.

import { expectSmooth, filmZoom, loadAgain } from '../element/children/round-levels.js';
import { test } from '../support/test.js';

test('@release the same markup gives the same picture of the same triangles at each of 100 loads', async ({
  mount,
}) => {
  test.setTimeout(300_000);
  await loadAgain(mount, 100);
});

test('@release zooms of 150 frames show no jump and no blank frame', async ({ page, mount }) => {
  test.setTimeout(300_000);
  for (const geometry of ['sphere', 'torus', 'cylinder', 'cone'])
    expectSmooth(await filmZoom(page, mount, geometry, 150, { width: 160, height: 120 }), geometry);
});
