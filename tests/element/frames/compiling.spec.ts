// Does no frame wait for a compiler where another program is needed? The browser's answer whether a
// program has linked is held back.

import type { Page } from '@playwright/test';
import { type ViewerLocator, compare, expect, pixels, test } from '../../support/test.js';
import { type PhongViewer, framesOf, settled, assign } from '../support/viewer.js';

const size = { width: 90, height: 60 };
const PARTS = [...Array(18).keys()]
  .map((kd) => `<phong-mesh geometry="box" kd="${kd}"></phong-mesh>`)
  .join('');
const LIGHT = '<phong-light position="1 2 3 0"></phong-light>';

test.beforeEach(async ({ page }) => {
  await page.addInitScript(() => {
    const COMPLETION_STATUS_KHR = 0x91b1;
    const held = Object.assign(window, { linking: false });
    const real = Object.getOwnPropertyDescriptors(WebGL2RenderingContext.prototype);
    const late = new WeakSet<WebGLProgram>();
    Object.assign(WebGL2RenderingContext.prototype, {
      getExtension(this: WebGL2RenderingContext, name: string) {
        // Software GL does not have it.
        if (name === 'KHR_parallel_shader_compile') return { COMPLETION_STATUS_KHR };
        return Reflect.apply(real.getExtension.value!, this, [name]) as unknown;
      },
      linkProgram(this: WebGL2RenderingContext, program: WebGLProgram) {
        if (held.linking) {
          late.add(program);
        }
        real.linkProgram.value!.call(this, program);
      },
      getProgramParameter(this: WebGL2RenderingContext, program: WebGLProgram, name: number) {
        if (name === COMPLETION_STATUS_KHR) return !held.linking || !late.has(program);
        return real.getProgramParameter.value!.call(this, program, name) as unknown;
      },
    });
  });
});

const setLinking = (page: Page, linking: boolean) =>
  page.evaluate((on) => void Object.assign(window, { linking: on }), linking);

/** Frames that the viewer draws in six of the page's, and whether it is ready after them. */
const watch = (viewer: ViewerLocator) =>
  viewer.evaluate(async (element) => {
    const before = element.stats.frames;
    let ready = false;
    void element.ready.then(() => (ready = true));
    for (let frame = 0; frame < 6; frame++) {
      await new Promise(requestAnimationFrame);
    }
    return { drawn: element.stats.frames - before, ready };
  });

const CHANGES: Readonly<Record<string, (viewer: PhongViewer) => void>> = {
  'the reflection of a late part': (viewer) => (viewer.meshes[17]!.reflection = 'blinn-phong'),
  'another shading': (viewer) => (viewer.shading = 'gouraud'),
  'linear light': (viewer) => (viewer.colorInterpolation = 'linear'),
  'a lamp that becomes a spot': (viewer) => (viewer.lights[0]!.aperture = 30),
};

for (const [change, make] of Object.entries(CHANGES)) {
  test(`${change} is shown once its program is there, and the picture before until then`, async ({
    page,
    mount,
  }) => {
    const viewer = await mount(
      `<phong-viewer geometry="torus">${LIGHT}<phong-light position="1 1 2 1"></phong-light>${PARTS}</phong-viewer>`,
      size,
    );
    await viewer.evaluate((element) => element.lights[0]!.remove());
    await settled(viewer);
    const lit = await pixels(viewer);
    await setLinking(page, true);
    await viewer.evaluate(make);
    expect(await watch(viewer)).toEqual({ drawn: 0, ready: false });
    await setLinking(page, false);
    await settled(viewer);
    expect(compare(lit, await pixels(viewer)).max).toBeGreaterThan(0);
    await setLinking(page, true);
    const frames = await framesOf(viewer);
    await viewer.evaluate((element) => (element.lights[0]!.diffuse = [9, 99, 9]));
    await settled(viewer);
    expect(await framesOf(viewer)).toBe(frames + 1);
  });
}

test('a file is drawn at once, and a program that never answers holds no picture for ever', async ({
  page,
  mount,
}) => {
  const viewer = await mount(`<phong-viewer geometry="torus">${LIGHT}</phong-viewer>`, size);
  const before = await pixels(viewer);
  await setLinking(page, true);
  await assign(viewer, { reflection: 'blinn-phong' });
  expect(compare(before, await pixels(viewer)).max).toBeGreaterThan(0);
  await assign(viewer, { shading: 'gouraud' });
  const frames = await framesOf(viewer);
  await settled(viewer);
  expect(await framesOf(viewer)).toBe(frames + 1);
});
