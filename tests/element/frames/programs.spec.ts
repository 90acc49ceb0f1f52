// How many programs are there, and does each hold the code that its scene needs and no other? Programs are compared
// with each other: how long the code is that `main` reaches, and whether two scenes have the same one.

import type { Page } from '@playwright/test';
import { compare, expect, pixels, test } from '../../support/test.js';
import { drawFrames, drawUntilSpecialised } from './driving.js';
import { reachedCode } from './glsl-reading.js';
import {
  drawnWith,
  glPrograms,
  glSpent,
  isSpecialised,
  isLit,
  logGl,
  type GlProgram,
} from '../support/gl-log.js';
import type { PhongViewer } from '../support/viewer.js';

const size = { width: 60, height: 42 };

/** What a scene declares. */
type Need =
  | ('directional' | 'point' | 'cone' | 'decay' | 'attenuation' | 'ambient' | 'diffuse' | 'specular')
  | (typeof ADDED)[number]
  | (typeof VARIANTS)[number];

/** Needs for which `main` reaches more code. The compiler decides the others by constants. */
const ADDED = ['spot', 'texture', 'vertex colours', 'linear'] as const;
/** Other code in place of the usual, which may be longer or shorter. */
const VARIANTS = ['gouraud', 'blinn-phong'] as const;

interface Drawn {
  readonly needs: readonly Need[];
  readonly text: string;
  /** Characters that `main` reaches, both stages together. */
  readonly length: number;
}

/** Whether `more` declares everything that `less` declares, in the same variant, and something that adds code. */
const declaresMore = (more: readonly Need[], less: readonly Need[]): boolean =>
  less.every((need) => more.includes(need)) &&
  ADDED.some((need) => more.includes(need) && !less.includes(need)) &&
  VARIANTS.every((variant) => more.includes(variant) === less.includes(variant));

const declaresSame = (a: readonly Need[], b: readonly Need[]): boolean =>
  a.length === b.length && a.every((need) => b.includes(need));

const reachedLength = ({ vertex, fragment }: GlProgram): number =>
  reachedCode(vertex).length + reachedCode(fragment).length;

async function litPrograms(page: Page): Promise<GlProgram[]> {
  return (await drawnWith(page)).filter(isLit);
}

/** Scenes, and the needs of their one program. */
const SCENES: Readonly<Record<string, readonly [markup: string, needs: readonly Need[]]>> = {
  'a sun': ['geometry="box"><phong-light>', ['directional', 'diffuse', 'specular']],
  'a head-light': ['geometry="box">', ['directional', 'diffuse', 'specular']],
  'a sun on a matte mesh': ['geometry="box" ks="0"><phong-light>', ['directional', 'diffuse']],
  'a sun without highlights': ['geometry="box"><phong-light specular="0">', ['directional', 'diffuse']],
  'ambient light alone': ['geometry="box"><phong-light ambient="9" diffuse="0" specular="0">', ['directional', 'ambient']], // prettier-ignore
  'ambient and diffuse terms of all': ['geometry="box" terms="ambient diffuse"><phong-light ambient="9">', ['directional', 'ambient', 'diffuse']], // prettier-ignore
  'no terms': ['geometry="box" terms=""><phong-light ambient="9">', ['directional']],
  'a sun with a cone, which is decided beforehand': ['geometry="box"><phong-light axis="-1 -1 -1" aperture="50" cutoff="4">', ['directional', 'diffuse', 'specular']], // prettier-ignore
  'a point': ['geometry="box"><phong-light position="1 2 3">', ['point', 'diffuse', 'specular']],
  'a spot without an axis': ['geometry="box"><phong-light position="1 2 3" axis="0 0 0" aperture="20" cutoff="2">', ['point', 'diffuse', 'specular']], // prettier-ignore
  'a point that fades': ['geometry="box"><phong-light position="1 2 3" attenuation="1 0 1">', ['point', 'attenuation', 'diffuse', 'specular']], // prettier-ignore
  'attenuation that is none': ['geometry="box"><phong-light position="1 2 3" attenuation="0.5 0 0">', ['point', 'diffuse', 'specular']], // prettier-ignore
  'a sun with attenuation, which it has not': ['geometry="box"><phong-light attenuation="9 9 9">', ['directional', 'diffuse', 'specular']], // prettier-ignore
  'a cone': ['geometry="box"><phong-light position="1 2 3" axis="-1 -2 -3" aperture="30">', ['spot', 'cone', 'diffuse', 'specular']], // prettier-ignore
  'a decay': ['geometry="box"><phong-light position="1 2 3" axis="-1 -2 -3" cutoff="3">', ['spot', 'decay', 'diffuse', 'specular']], // prettier-ignore
  'an inactive spot beside a sun': ['geometry="box"><phong-light></phong-light><phong-light active="false" position="1 2 3" axis="-1 -2 -3" aperture="30">', ['directional', 'spot', 'cone', 'diffuse', 'specular']], // prettier-ignore
  gouraud: [
    'geometry="box" shading="gouraud"><phong-light>',
    ['directional', 'diffuse', 'specular', 'gouraud'],
  ],
  flat: ['geometry="box" shading="flat"><phong-light>', ['directional', 'diffuse', 'specular']],
  'blinn-phong': ['geometry="box" reflection="blinn-phong"><phong-light>', ['directional', 'diffuse', 'specular', 'blinn-phong']], // prettier-ignore
  linear: ['geometry="box" color-interpolation="linear"><phong-light>', ['directional', 'diffuse', 'specular', 'linear']], // prettier-ignore
  'a textured model': ['src="/fixtures/models/textured.glb" ks="90"><phong-light>', ['directional', 'diffuse', 'specular', 'texture']], // prettier-ignore
  'a model with colours at its vertices': ['src="/fixtures/models/vertex-colours.glb" ks="90"><phong-light>', ['directional', 'diffuse', 'specular', 'vertex colours']], // prettier-ignore
};

test('scenes with the same needs have the same program, and only further needs add code', async ({
  page,
  mount,
}) => {
  await logGl(page);
  const viewer = await mount('<phong-viewer></phong-viewer>', size);
  const drawn = new Map<string, Drawn>();
  for (const [which, [markup, needs]] of Object.entries(SCENES)) {
    await glSpent(page);
    const html = `<phong-viewer ${markup}</phong-viewer>`;
    await viewer.evaluate((element, text) => (element.outerHTML = text), html);
    await viewer.evaluate((element: PhongViewer) => element.ready);
    const lit = await litPrograms(page);
    expect(lit.length, which).toBe(1);
    const { vertex, fragment } = lit[0]!;
    expect(fragment, which).toMatch(/precision highp float/);
    drawn.set(which, { needs, text: vertex + fragment, length: reachedLength(lit[0]!) });
  }
  for (const [a, one] of drawn) {
    for (const [b, other] of drawn) {
      const areSame = declaresSame(one.needs, other.needs);
      expect.soft(one.text === other.text, `${a}, ${b}: one program`).toBe(areSame);
      if (declaresMore(one.needs, other.needs))
        expect.soft(one.length, `${a} has more code than ${b}`).toBeGreaterThan(other.length);
    }
  }
});

test('ten meshes reached by different lights get a specialised program each', async ({ page, mount }) => {
  await logGl(page);
  // Each lit by one more light than the one before, so that no two share a program.
  const meshes = Array.from({ length: 10 }, (_, i) => `<phong-mesh geometry="plane" position="${3 * i} 0 0"></phong-mesh>`); // prettier-ignore
  const lights = Array.from({ length: 10 }, (_, i) =>
    `<phong-light position="${3 * i} 1 0" axis="0 -1 0" aperture="30"></phong-light>`.repeat(i + 1),
  );
  const viewer = await mount(`<phong-viewer>${meshes.join('')}${lights.join('')}</phong-viewer>`, size);
  const before = await pixels(viewer);
  await drawUntilSpecialised(page);
  await glSpent(page);
  await drawFrames(page, 1);
  expect((await litPrograms(page)).filter(isSpecialised)).toHaveLength(10);
  expect(await viewer.evaluate((element: PhongViewer) => element.stats.lightsSentByMesh)).toEqual([1, 2, 3, 4, 5, 6, 7, 8, 9, 10]); // prettier-ignore
  expect(compare(await pixels(viewer), before).max).toBeLessThanOrEqual(1);
});

test('a picture without lights in the loop gets a specialised program that shows the same', async ({
  page,
  mount,
}) => {
  await logGl(page);
  const light = (more: string): string => `<phong-light ambient="90 60 30" ${more}></phong-light>`;
  for (const lights of [light('diffuse="0" specular="0"'), light('active="false"')]) {
    const viewer = await mount(`<phong-viewer geometry="box">${lights}</phong-viewer>`, size);
    const before = await pixels(viewer);
    await drawUntilSpecialised(page);
    expect(compare(await pixels(viewer), before).max, lights).toBe(0);
  }
});

test('a specialised program that does not link is reported once, and the general one goes on drawing', async ({
  page,
  mount,
  consoleGuard,
}) => {
  consoleGuard.allow(/uncaught: .*a program does not link.*broken by hand/s, 1);
  await logGl(page);
  await page.addInitScript(() => {
    const gl = WebGL2RenderingContext.prototype;
    const real = Object.getOwnPropertyDescriptor(gl, 'shaderSource')?.value as typeof gl.shaderSource;
    gl.shaderSource = function (this: WebGL2RenderingContext, shader, text) {
      real.call(this, shader, text.replace('#define LIGHT_STATEMENTS', '#error broken by hand\n$&'));
    };
  });
  const viewer = await mount(
    '<phong-viewer geometry="sphere"><phong-light></phong-light></phong-viewer>',
    size,
  );
  const before = await pixels(viewer);
  await drawFrames(page, 80);
  expect((await drawnWith(page)).filter(isLit).some(isSpecialised)).toBe(false);
  expect(compare(await pixels(viewer), before).max).toBe(0);
  expect((await glPrograms(page)).filter(isSpecialised)).toHaveLength(1);
});
