// The long form of element/frames/still-films.spec.ts: fifty viewers with `antialias="full"` on a page.

import { countEverything, countsOf, NOTHING, spentIn } from '../element/support/counting.js';
import { nextFrame, type PhongViewer } from '../element/support/viewer.js';
import { expect, test } from '../support/test.js';

test('@release fifty viewers converge, each of them once, and then nothing runs', async ({ page, mount }) => {
  test.setTimeout(300_000);
  await countEverything(page);
  const kinds = ['box', 'sphere', 'cone', 'torus', 'teapot'];
  const markup = Array.from(
    { length: 50 },
    (_, i) =>
      `<phong-viewer alt="" antialias="full" samples="16" geometry="${kinds[i % 5]!}"><phong-light></phong-light></phong-viewer>`,
  );
  await mount(markup.join(''), { width: 64, height: 48, css: 'phong-viewer { float: left }' });
  const samples = (): Promise<readonly number[]> =>
    page.evaluate(() =>
      [...document.querySelectorAll<PhongViewer>('phong-viewer')].map(({ stats }) => stats.samples),
    );
  expect(await samples()).toEqual(markup.map(() => 16));
  await nextFrame(page);
  expect(await spentIn(page, 1000)).toEqual(NOTHING);
  const before = await countsOf(page);
  const order = await page.evaluate(async () => {
    const viewers = [...document.querySelectorAll<PhongViewer>('phong-viewer')];
    const finished: number[] = [];
    viewers.forEach((viewer, i) => {
      viewer.addEventListener('render', () => viewer.stats.samples === 16 && finished.push(i));
      viewer.theta += 20;
    });
    await Promise.all(viewers.map(({ ready }) => ready));
    return finished;
  });
  expect(new Set(order).size, 'each one finishes').toBe(50);
  expect(order.length, 'once').toBe(50);
  await nextFrame(page);
  expect(await spentIn(page, 1000)).toEqual(NOTHING);
  const { textures, framebuffers, renderbuffers, contexts } = await countsOf(page);
  expect({ textures, framebuffers, renderbuffers, contexts }).toEqual({
    textures: before.textures,
    framebuffers: before.framebuffers,
    renderbuffers: before.renderbuffers,
    contexts: 1,
  });
});
