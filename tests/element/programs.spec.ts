// Which code do programs contain, and how many are there? Reads the text sent to WebGL: the functions that `main` reaches once all
// preprocessor conditions are decided.

import type { Page } from '@playwright/test';
import { compare, expect, pixels, test } from '../support/test.js';
import { drawFrames, drawUntilSpecialised } from './driving.js';
import { definesOf, reachableOf } from './glsl-reading.js';
import { drawnWith, glPrograms, glSpent, isSpecialised, isLit, logGl, type GlProgram } from './gl-log.js';
import { expectFewPrograms } from './program-walk.js';
import type { PhongViewer } from './support.js';

const size = { width: 60, height: 42 };

/** For each feature, the code that implements it: macros and functions that `main` reaches. */
const CODE = {
  directional: { facts: ['HAS_DIRECTIONAL'], functions: [] },
  point: { facts: ['HAS_POINT'], functions: [] },
  spot: { facts: ['HAS_SPOT'], functions: ['insideCone', 'spotDecay'] },
  cone: { facts: ['HAS_CONE'], functions: [] },
  decay: { facts: ['HAS_DECAY'], functions: [] },
  attenuation: { facts: ['HAS_ATTENUATION'], functions: [] },
  ambient: { facts: ['HAS_AMBIENT'], functions: [] },
  diffuse: { facts: ['HAS_DIFFUSE'], functions: [] },
  specular: { facts: ['HAS_SPECULAR'], functions: [] },
  texture: { facts: ['HAS_MAP'], functions: [] },
  gouraud: { facts: ['SHADING_GOURAUD'], functions: ['shadeFace'] },
  'blinn-phong': { facts: ['REFLECTION_BLINN_PHONG'], functions: [] },
  linear: { facts: ['IS_LINEAR'], functions: ['srgbEncode'] },
  'vertex colours': { facts: ['HAS_VERTEX_COLOR'], functions: [] },
  mask: { facts: ['HAS_ALPHA_MASK'], functions: [] },
  'filtered highlights': { facts: ['FILTER_HIGHLIGHTS'], functions: ['averagedLobe', 'footprintOf'] },
} as const;

type Need = keyof typeof CODE;

/** Which of {@link CODE} is in a program. */
function codeIn({ vertex, fragment }: GlProgram): Need[] {
  const defines = new Set([...definesOf(vertex), ...definesOf(fragment)]);
  const functions = new Set([...reachableOf(vertex), ...reachableOf(fragment)]);
  return (Object.keys(CODE) as Need[]).filter((need) => {
    const { facts, functions: named } = CODE[need];
    const some = facts.some((fact) => defines.has(fact)) || named.some((name) => functions.has(name));
    const all = facts.every((fact) => defines.has(fact)) && named.every((name) => functions.has(name));
    expect(all, `${need}: its facts and its functions are there together`).toBe(some);
    return some;
  });
}

async function litPrograms(page: Page): Promise<GlProgram[]> {
  return (await drawnWith(page)).filter(isLit);
}

/** Scenes, and what their one program holds besides a directional light's diffuse and specular light. */
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
  'filtered highlights': ['geometry="box" antialias="highlights"><phong-light>', ['directional', 'diffuse', 'specular', 'filtered highlights']], // prettier-ignore
  'filtered highlights of Blinn and Phong': ['geometry="box" antialias="highlights" reflection="blinn-phong"><phong-light>', ['directional', 'diffuse', 'specular', 'blinn-phong', 'filtered highlights']], // prettier-ignore
  'filtered highlights that there are none of': ['geometry="box" antialias="highlights" ks="0"><phong-light>', ['directional', 'diffuse']], // prettier-ignore
  'filtered highlights under gouraud, which has none': ['geometry="box" antialias="highlights" shading="gouraud"><phong-light>', ['directional', 'diffuse', 'specular', 'gouraud']], // prettier-ignore
  'a textured model': ['src="/fixtures/models/textured.glb" ks="90"><phong-light>', ['directional', 'diffuse', 'specular', 'texture']], // prettier-ignore
  'a model with colours at its vertices': ['src="/fixtures/models/vertex-colours.glb" ks="90"><phong-light>', ['directional', 'diffuse', 'specular', 'vertex colours']], // prettier-ignore
};

test('a program contains the code for the features declared in its scene, and no other', async ({
  page,
  mount,
}) => {
  await logGl(page);
  const viewer = await mount('<phong-viewer></phong-viewer>', size);
  for (const [which, [markup, needs]] of Object.entries(SCENES)) {
    await glSpent(page);
    const html = `<phong-viewer ${markup}</phong-viewer>`;
    await viewer.evaluate((element, text) => (element.outerHTML = text), html);
    await viewer.evaluate((element: PhongViewer) => element.ready);
    const lit = await litPrograms(page);
    expect(lit.length, which).toBe(1);
    expect(codeIn(lit[0]!), which).toEqual(Object.keys(CODE).filter((need) => needs.includes(need as Need)));
    expect(lit[0]!.fragment, which).toMatch(/precision highp float/);
  }
});

test('the code for lights is in one stage only', async ({ page, mount }) => {
  await logGl(page);
  const viewer = await mount('<phong-viewer></phong-viewer>', size);
  for (const shading of ['phong', 'flat', 'gouraud']) {
    await glSpent(page);
    await viewer.evaluate((element, how) => (element.outerHTML = `<phong-viewer geometry="box" shading="${how}"><phong-light position="1 2 3"></phong-light></phong-viewer>`), shading); // prettier-ignore
    await viewer.evaluate((element: PhongViewer) => element.ready);
    const [{ vertex, fragment }] = (await litPrograms(page)) as [GlProgram];
    expect(reachableOf(vertex).has('lightSums'), shading).toBe(shading === 'gouraud');
    expect(reachableOf(fragment).has('lightSums'), shading).toBe(shading !== 'gouraud');
  }
});

test('a long random walk makes one general program per feature set, and few specialised ones', async ({
  page,
  mount,
}) => {
  test.setTimeout(120_000);
  await logGl(page);
  const viewer = await mount('<phong-viewer></phong-viewer>', size);
  await expectFewPrograms(page, viewer, Number(process.env['PHONG_VIEWER_SEED'] ?? 1), 60);
});

test('another shape is drawn by the same program', async ({ page, mount }) => {
  await logGl(page);
  const viewer = await mount('<phong-viewer geometry="box"><phong-light></phong-light></phong-viewer>', size);
  for (const [key, value] of Object.entries({ geometry: 'sphere', segments: '12' })) {
    await glSpent(page);
    await viewer.evaluate((element, [name, text]) => element.setAttribute(name, text), [key, value] as const);
    await viewer.evaluate((element: PhongViewer) => element.ready);
    expect(await glSpent(page), `${key} ${value}`).toMatchObject({ draws: 1, links: 0, compiles: 0 });
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

test('a fragment’s explanation does not depend on the program that drew it', async ({ mount }) => {
  const viewer = await mount(
    '<phong-viewer geometry="sphere"><phong-light></phong-light></phong-viewer>',
    size,
  );
  const explain = () =>
    viewer.evaluate(async (element: PhongViewer) => (await element.shadeAt(45, 30))?.color ?? null);
  const before = await explain();
  expect(before).not.toBeNull();
  const programs = await viewer.evaluate(async (element: PhongViewer) => {
    for (let frame = 0; frame < 60; frame++) {
      element.requestRender();
      await new Promise((resolve) => {
        element.addEventListener('render', resolve, { once: true });
      });
    }
    return element.stats.programs;
  });
  expect(programs).toBe(2);
  expect(await explain()).toEqual(before);
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
