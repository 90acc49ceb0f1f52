// How many programs are there, and does each hold the code that its scene needs and no other?
// Programs are compared with each other: how long the code is that the driver keeps, and whether
// two scenes have the same one.

import type { Page } from '@playwright/test';
import { compare, expect, pixels, same, test } from '../../support/test.js';
import { drawFrames, drawUntilSpecialised } from './driving.js';
import {
  drawnWith,
  glPrograms,
  glSpent,
  isSpecialised,
  isLit,
  logGl,
  type GlProgram,
} from '../support/gl-log.js';
import { settled, statsOf } from '../support/viewer.js';

const size = { width: 60, height: 42 };

async function litPrograms(page: Page) {
  return (await drawnWith(page)).filter(isLit);
}

/**
 * Lengths of the programs' code after the preprocessor and without functions that `main` does not
 * reach.
 */
const codeLengths = (page: Page, programs: readonly GlProgram[]) =>
  page.evaluate((texts) => {
    const gl = new OffscreenCanvas(1, 1).getContext('webgl2')!;
    const lengthOf = (kind: number, text: string) => {
      const shader = gl.createShader(kind)!;
      gl.shaderSource(shader, text);
      gl.compileShader(shader);
      return gl.getExtension('WEBGL_debug_shaders')!.getTranslatedShaderSource(shader).length;
    };
    return texts.map(
      ({ vertex, fragment }) =>
        lengthOf(gl.VERTEX_SHADER, vertex) + lengthOf(gl.FRAGMENT_SHADER, fragment),
    );
  }, programs);

/** Needs that add code. The compiler decides the others by constants. */
const ADDED = ['spot', 'texture', 'colours', 'linear'];
/** Other code in place of the usual, which may be longer or shorter. */
const VARIANTS = ['gouraud', 'blinn-phong'];

const SUN = 'directional diffuse specular';

/**
 * Scenes, and the needs of their one program. The lights' own features:
 * unit/light-features.test.ts.
 */
const SCENES: Readonly<Record<string, readonly [markup: string, needs: string]>> = {
  'a sun': ['geometry="box"><phong-light>', SUN],
  'a head-light': ['geometry="box">', SUN],
  'flat shading': ['geometry="box" shading="flat"><phong-light>', SUN],
  'a sun on a matte mesh': ['geometry="box" ks="0"><phong-light>', 'directional diffuse'],
  'a sun without highlights': ['geometry="box"><phong-light specular="0">', 'directional diffuse'],
  'no terms': ['geometry="box" terms=""><phong-light ambient="9">', 'directional'],
  'a point': ['geometry="box"><phong-light position="1 2 3">', 'point diffuse specular'],
  'attenuation that is none': ['geometry="box"><phong-light position="1 2 3" attenuation="0.5 0 0">', 'point diffuse specular'], // oxfmt-ignore
  'a decay': ['geometry="box"><phong-light position="1 2 3" axis="-1 -2 -3" cutoff="3">', 'spot decay diffuse specular'], // oxfmt-ignore
  'an inactive spot beside a sun': ['geometry="box"><phong-light></phong-light><phong-light active="false" position="1 2 3" axis="-1 -2 -3" aperture="30">', `${SUN} spot cone`], // oxfmt-ignore
  gouraud: ['geometry="box" shading="gouraud"><phong-light>', `${SUN} gouraud`],
  'blinn-phong': ['geometry="box" reflection="blinn-phong"><phong-light>', `${SUN} blinn-phong`],
  linear: ['geometry="box" color-interpolation="linear"><phong-light>', `${SUN} linear`],
  'a textured model': [
    'src="/fixtures/models/textured.glb" ks="90"><phong-light>',
    `${SUN} texture`,
  ],
  'a model with colours at its vertices': ['src="/fixtures/models/vertex-colours.glb" ks="90"><phong-light>', `${SUN} colours`], // oxfmt-ignore
};

/**
 * Whether `more` declares everything that `less` declares, in the same variant, and something that
 * adds code.
 */
function declaresMore(more: string, less: string) {
  const [all, some] = [more.split(' '), less.split(' ')];
  const added = all.filter((need) => !some.includes(need));
  return (
    some.every((need) => all.includes(need)) &&
    added.some((need) => ADDED.includes(need)) &&
    !added.some((need) => VARIANTS.includes(need))
  );
}

test('scenes with the same needs have the same program, and only further needs add code', async ({
  page,
  mount,
}) => {
  await logGl(page);
  const viewer = await mount('<phong-viewer></phong-viewer>', size);
  const programs: GlProgram[] = [];
  for (const [which, [markup]] of Object.entries(SCENES)) {
    await glSpent(page);
    const html = `<phong-viewer ${markup}</phong-viewer>`;
    await viewer.evaluate((element, text) => (element.outerHTML = text), html);
    await settled(viewer);
    const [lit, ...others] = await litPrograms(page);
    expect(others, which).toEqual([]);
    expect(lit!.fragment, which).toMatch(/precision highp float/);
    programs.push(lit!);
  }
  const lengths = await codeLengths(page, programs);
  const drawn = Object.entries(SCENES).map(([which, [, needs]], i) => {
    const { vertex, fragment } = programs[i]!;
    return { which, needs, text: vertex + fragment, length: lengths[i]! };
  });
  for (const a of drawn) {
    for (const b of drawn) {
      expect
        .soft(a.text === b.text, `${a.which}, ${b.which}: one program`)
        .toBe(a.needs === b.needs);
      if (declaresMore(a.needs, b.needs)) {
        expect.soft(a.length, `${a.which} has more code than ${b.which}`).toBeGreaterThan(b.length);
      }
    }
  }
});

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
