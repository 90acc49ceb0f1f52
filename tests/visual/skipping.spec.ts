// Does skipping work change no picture? Compares the same scenes drawn by general and by
// specialised programs, with and without lights that reach nothing, and all of them with float64.

import { firstOf, fullOr, SEED } from '../support/repeats.js';
import { expect, test } from '../support/test.js';
import { drawUntilSpecialised } from '../element/frames/driving.js';
import { logGl } from '../element/support/gl-log.js';
import {
  betweenPrograms,
  bothPictures,
  DifferenceSum,
  picturesBy,
  showAll,
} from './between-programs.js';
import { compareScenes, drawnScene, lookScenes, SIZE } from './program-scenes.js';

/** For more or other scenes: PHONG_VIEWER_SCENES=500 PHONG_VIEWER_SEED=1000. */
const SCENES = Number(process.env['PHONG_VIEWER_SCENES'] ?? fullOr(400, 12));

test(`random scenes hardly differ between programs (seeds from ${SEED})`, async ({
  page,
  mount,
}) => {
  test.setTimeout(1_800_000);
  await logGl(page);
  await mount('<phong-viewer></phong-viewer>', SIZE);
  const scenes = Array.from({ length: SCENES }, (_, i) => drawnScene(SEED + i));
  const { compared, exact, snapped } = await compareScenes(page, scenes);
  expect(exact / compared).toBeGreaterThan(0.98);
  // Of spheres alone 1.2e-4 were measured, where vertices lie on sixteenths of a pixel.
  expect(snapped / compared).toBeLessThan(3e-4);
});

test('every kind of surface and light differs as little between the two programs', async ({
  page,
  mount,
}) => {
  test.setTimeout(120_000);
  await logGl(page);
  await mount('<phong-viewer></phong-viewer>', SIZE);
  await compareScenes(page, firstOf(lookScenes(), 16), 701);
});

test('a textured model differs as little between the two programs, under every shading', async ({
  page,
  mount,
}) => {
  test.setTimeout(120_000);
  await logGl(page);
  await mount('<phong-viewer></phong-viewer>', SIZE);
  const lights =
    '<phong-light position="1 2 2 0" ambient="30" diffuse="180 170 160" specular="90"></phong-light>' +
    '<phong-light position="-2 2 1" axis="2 -2 -1" aperture="25" cutoff="4" attenuation="1 0.1 0"></phong-light>';
  const models = firstOf(['/fixtures/models/textured.glb', '/assets/models/bunny.glb'], 1);
  const markups = models.flatMap((src) =>
    ['shading="phong"', 'shading="gouraud"', 'shading="flat" color-interpolation="linear"'].map(
      (how) => `<phong-viewer src="${src}" ${how}>${lights}</phong-viewer>`,
    ),
  );
  const sum = new DifferenceSum();
  for (const { general, specialised } of await bothPictures(page, markups, SIZE)) {
    sum.add(betweenPrograms(general, specialised));
  }
  console.log(`textured models: ${String(sum)}`);
  expect(sum.channels).toBeGreaterThan(fullOr(10_000, 3000));
  sum.expectPromise();
});

/**
 * Attributes of a light that brings nothing to what is seen, declared beside all that the scene's
 * own light needs.
 */
const IDLE = {
  inactive: 'active="false" position="0.3 1 0" axis="0 -1 0" aperture="40" cutoff="2"',
  'turned away': 'position="0.3 1 0" axis="0 1 0" aperture="40" cutoff="2"',
  black: 'diffuse="0" specular="0" position="0.3 1 0" axis="0 -1 0" aperture="40" cutoff="2"',
  'without a direction': 'position="0 0 0 0"',
} as const;

test('lights that reach nothing change no bit in the same program', async ({ page, mount }) => {
  await logGl(page);
  await mount('<phong-viewer></phong-viewer>', SIZE);
  const own = '<phong-light position="1 1 0.5" ambient="20" attenuation="1 0.2 0.1"></phong-light>';
  const declared = `<phong-light active="false" position="0 1 0" axis="0 -1 0" aperture="40" cutoff="2"></phong-light>`;
  for (const shading of firstOf(['phong', 'gouraud', 'flat'], 2)) {
    const markup = (idle: string) =>
      `<phong-viewer geometry="torus" segments="24" shading="${shading}" theta="20" phi="50" target="0 0 0" radius="2">${own}${declared}${idle}</phong-viewer>`;
    const viewers = await showAll(page, [
      markup(''),
      ...Object.values(IDLE).map((attributes) =>
        markup(`<phong-light ${attributes}></phong-light>`),
      ),
      markup(
        Object.values(IDLE)
          .map((attributes) => `<phong-light ${attributes}></phong-light>`)
          .join(''),
      ),
    ]);
    for (const kind of ['general', 'specialised'] as const) {
      if (kind === 'specialised') {
        await drawUntilSpecialised(page);
      }
      const [alone, ...others] = await picturesBy(page, viewers, kind, SIZE);
      for (const [i, other] of others.entries()) {
        const { max } = betweenPrograms(alone!, other);
        expect(max, `${shading}, ${kind}, ${Object.keys(IDLE)[i] ?? 'all'}`).toBe(0);
      }
    }
  }
});
