// Which meshes get a specialised program, and what draws where it does not link? Which scenes share a
// general one: unit/phong/variant.test.ts.

import type { Page } from '@playwright/test';
import { compare, expect, pixels, same, test } from '../../support/test.js';
import { drawFrames, drawUntilSpecialised } from './driving.js';
import { drawnWith, glPrograms, glSpent, isSpecialised, isLit, logGl } from '../support/gl-log.js';
import { statsOf } from '../support/viewer.js';

const size = { width: 60, height: 42 };

async function litPrograms(page: Page) {
  return (await drawnWith(page)).filter(isLit);
}

test('ten meshes reached by different lights get a specialised program each', async ({
  page,
  mount,
}) => {
  await logGl(page);
  // Each lit by one more light than the one before, so that no two share a program.
  const meshes = Array.from(
    { length: 10 },
    (_, i) => `<phong-mesh geometry="plane" position="${3 * i} 0 0"></phong-mesh>`,
  );
  const lights = Array.from({ length: 10 }, (_, i) =>
    `<phong-light position="${3 * i} 1 0" axis="0 -1 0" aperture="30"></phong-light>`.repeat(i + 1),
  );
  const viewer = await mount(
    `<phong-viewer>${meshes.join('')}${lights.join('')}</phong-viewer>`,
    size,
  );
  const before = await pixels(viewer);
  await drawUntilSpecialised(page);
  await glSpent(page);
  await drawFrames(page, 1);
  expect((await litPrograms(page)).filter(isSpecialised)).toHaveLength(10);
  expect((await statsOf(viewer)).lightsSentByMesh).toEqual([1, 2, 3, 4, 5, 6, 7, 8, 9, 10]);
  expect(compare(await pixels(viewer), before).max).toBeLessThanOrEqual(1);
});

test('a picture without lights in the loop gets a specialised program that shows the same', async ({
  page,
  mount,
}) => {
  await logGl(page);
  const light = (more: string) => `<phong-light ambient="90 60 30" ${more}></phong-light>`;
  for (const lights of [light('diffuse="0" specular="0"'), light('active="false"')]) {
    const viewer = await mount(`<phong-viewer geometry="box">${lights}</phong-viewer>`, size);
    const before = await pixels(viewer);
    await drawUntilSpecialised(page);
    same(await pixels(viewer), before, lights);
  }
});

test('if a specialised program does not link, the general one draws', async ({
  page,
  mount,
  consoleGuard,
}) => {
  consoleGuard.allow(/uncaught: .*a program does not link.*broken by hand/s, 1);
  await logGl(page);
  await page.addInitScript(() => {
    const gl = WebGL2RenderingContext.prototype;
    const real = Object.getOwnPropertyDescriptor(gl, 'shaderSource')
      ?.value as typeof gl.shaderSource;
    gl.shaderSource = function (this: WebGL2RenderingContext, shader, text) {
      real.call(
        this,
        shader,
        text.replace('#define LIGHT_STATEMENTS', '#error broken by hand\n$&'),
      );
    };
  });
  const viewer = await mount(
    '<phong-viewer geometry="sphere"><phong-light></phong-light></phong-viewer>',
    size,
  );
  const before = await pixels(viewer);
  await drawFrames(page, 80);
  expect((await drawnWith(page)).filter(isLit).some(isSpecialised)).toBe(false);
  same(await pixels(viewer), before);
  expect((await glPrograms(page)).filter(isSpecialised)).toHaveLength(1);
});
