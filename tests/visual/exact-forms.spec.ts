// Does each form of exact programs show what general programs show? Which one a page takes depends on its device: numbers in the
// text on a processor, loops of literal length on a GPU. Both are plain WebGL 2, so software draws both where the device's name says so.

import type { Page } from '@playwright/test';
import { drawUntilExact } from '../element/driving.js';
import { drawnWith, type GlProgram, isExact, isLit, logGl } from '../element/gl-log.js';
import { expect, test } from '../support/test.js';
import { betweenPrograms, DifferenceSum, picturesBy, showAll } from './between-programs.js';
import { Dice, randomLight, randomScene, sceneMarkup } from './random-scene.js';
import { MOST_CONSTANT } from '../../src/material/exact-lights.js';
import type { LightValues } from '../../src/light/light-state.js';

const SEED = Number(process.env['PHONG_VIEWER_SEED'] ?? 1);
const SIZE = { width: 90, height: 64 };

/** One alone, a few, all that software writes out at once, and many: more than it takes into a text, so that loops stand beside it. */
const COUNTS = { constant: [1, 2, 5, 16, MOST_CONSTANT + 6], counted: [1, 2, 5, 16, 64] } as const;

/** How a program holds its lights, told by its text; written out or counted, one light or two are the same. */
const FORMS = {
  constant: ({ fragment }: GlProgram) => fragment.includes('#define LIGHT_CONSTANTS'),
  counted: ({ fragment }: GlProgram) => fragment.includes('#define LIGHT_STORAGE STORAGE_BLOCK'),
} as const;

/** Turns of all its loops of literal length together. */
const turns = ({ fragment }: GlProgram): number =>
  [...fragment.matchAll(/for\(int i=0;i<(\d+);/g)].reduce((sum, [, times]) => sum + Number(times), 0);

/** Where each is taken. */
const DEVICES = { constant: null, counted: 'A GPU of no maker' } as const;

/** Of all kinds in turn, lit enough to be told apart and together within range; of a kind some are of one shape. */
function lights(count: number, dice: Dice): LightValues[] {
  return Array.from({ length: count }, (_, i) => {
    const light = randomLight(dice);
    const dim = (c: readonly number[]) =>
      c.map((x) => Number((x * Math.min(1, 6 / count)).toFixed(2))) as unknown as LightValues['diffuse'];
    return {
      ...light,
      active: true,
      // Suns, lamps and spots: the kinds that programs have code of their own for.
      position: [light.position[0], light.position[1], light.position[2], i % 3 === 0 ? 0 : 1],
      ...(i % 3 === 2
        ? { aperture: dice.pick([45, 80, 120]), cutoff: dice.pick([0, 1, 4]) }
        : { aperture: 180, cutoff: 0 }),
      attenuation: i % 2 === 0 ? [1, 0, 0] : light.attenuation,
      space: i % 8 === 7 ? 'camera' : 'world',
      ambient: dim(light.ambient),
      diffuse: dim(light.diffuse),
      specular: dim(light.specular),
    };
  });
}

/** What the driver calls itself is asked by an extension's constant. */
async function callDevice(page: Page, name: string | null): Promise<void> {
  await page.addInitScript((given) => {
    if (given === null) return;
    const gl = WebGL2RenderingContext.prototype;
    const real = Object.getOwnPropertyDescriptor(gl, 'getParameter')?.value as typeof gl.getParameter;
    const asked = 0x9246; // UNMASKED_RENDERER_WEBGL
    gl.getParameter = function (this: WebGL2RenderingContext, what: number): unknown {
      return what === asked ? given : (Reflect.apply(real, this, [what]) as unknown);
    };
  }, name);
}

/** Pictures as small as these are not halted for what many lights take to compile; where time flies, each takes long enough. */
async function letTimeFly(page: Page): Promise<void> {
  await page.addInitScript(() => {
    const real = performance.now.bind(performance);
    performance.now = () => 100 * real();
  });
}

for (const [form, isWanted] of Object.entries(FORMS) as [keyof typeof FORMS, (one: GlProgram) => boolean][]) {
  const counts = COUNTS[form];
  const where = DEVICES[form] === null ? 'in software' : 'on a GPU';
  test(`exact programs ${where}, which are ${form}, show mixed lights as general ones do, ${counts[0]} to ${counts.at(-1)!} (seed ${SEED})`, async ({
    page,
    mount,
  }) => {
    test.setTimeout(120_000);
    await logGl(page);
    await callDevice(page, DEVICES[form]);
    if (form === 'constant') await letTimeFly(page);
    await mount('<phong-viewer></phong-viewer>', SIZE);
    const markups = counts.map((count, i) => {
      const dice = new Dice(SEED + count);
      const scene = randomScene(SEED + count, i % 2 === 0 ? 'plane' : 'box');
      const { reflection = 'phong' } = scene.options;
      const shading = i === 1 ? 'flat' : 'phong';
      const options = { reflection, terms: ['ambient', 'diffuse', 'specular'], linear: i === 2 } as const;
      return sceneMarkup({ ...scene, options, lights: lights(count, dice) }, shading);
    });
    const viewers = await showAll(page, markups);
    const general = await picturesBy(page, viewers, 'general', SIZE);
    await drawUntilExact(page, (one) => isExact(one) && isWanted(one));
    const exact = await picturesBy(page, viewers, 'exact', SIZE);
    const looped = (await drawnWith(page)).filter(isLit).map(turns);
    expect(Math.max(...looped)).toBeGreaterThan(1);
    // Some may not reach their mesh.
    if (form === 'constant') expect(Math.max(...looped)).toBeLessThanOrEqual(counts.at(-1)! - MOST_CONSTANT);
    const sum = new DifferenceSum();
    let told = 0;
    for (const [i, picture] of exact.entries()) {
      const difference = betweenPrograms(general[i]!, picture);
      expect.soft(difference.max, `${counts[i]} lights`).toBeLessThanOrEqual(1);
      const { data } = picture;
      told += data.filter((code, at) => at % 4 < 3 && code > 0 && code < 255 && data[at | 3] === 255).length;
      sum.add(difference);
    }
    expect(told, 'channels neither dark nor full').toBeGreaterThan(10_000);
    console.log(`${form}, seed ${SEED}: ${String(sum)}`);
    sum.expectPromise();
  });
}
