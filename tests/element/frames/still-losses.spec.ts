// `antialias="full"` where the GPU or the page gets in its way: a context that is lost in the
// middle, buffers that it lacks, what is out of view, and a page's own materials.

import type * as Three from 'three';
import { usages } from '../../package/requests.js';
import { allReady, expect, pixels, same, test } from '../../support/test.js';
import { holdContext } from '../page/many-viewers.js';
import { countEverything, NOTHING, spentIn, expectIdle } from '../support/counting.js';
import { film, keepPixels, LIGHT, viewerOf } from '../support/film.js';
import { assign, nextFrame, type PhongViewer, samplesOf, statsOf } from '../support/viewer.js';

const size = { width: 48, height: 36 };

test('a context lost in the middle shows no part of a picture; samples begin again', async ({
  page,
  mount,
}) => {
  await keepPixels(page);
  await countEverything(page);
  await holdContext(page);
  for (const [what, other] of [
    ['alone', ''],
    ['beside another', viewerOf(16)],
  ] as const) {
    const viewer = await mount(viewerOf(128) + other, size);
    const before = await pixels(viewer);
    const notice = viewer.locator('[part=notice]');
    await assign(viewer, { theta: 31 });
    await assign(viewer, { theta: 30 });
    await expect.poll(() => samplesOf(viewer)).toBeGreaterThan(0);
    const rolling = await film(viewer);
    await page.evaluate('window.loss.loseContext()');
    await expect(notice).toHaveCount(1);
    expect(await samplesOf(viewer), `${what}, lost`).toBe(0);
    await allReady(page);
    const { frames: filmed, timers, ...spent } = await spentIn(page, 200);
    expect(
      { ...spent, frames: 0, timers: 0 },
      `${what}: ${String(filmed)} frames are the film's`,
    ).toEqual(NOTHING);
    expect(timers, what).toBe(0);
    await page.evaluate('window.loss.restoreContext()');
    await expect(notice).toHaveCount(0);
    await allReady(page);
    expect(await samplesOf(viewer), `${what}, restored`).toBe(128);
    await nextFrame(page);
    const frames = await rolling.stop();
    const [first] = frames;
    let reported = false;
    for (const [i, { mean, samples: count }] of frames.entries()) {
      const which = `${what}, frame ${String(i)} of ${String(frames.length)} with ${String(count)} samples`;
      // A lone picture is the context's own canvas, which the browser empties, or now and then
      // makes white.
      const isEmpty = what === 'alone' && mean.every((code) => code === 0 || code === 255);
      if (!isEmpty) {
        mean.forEach((code, k) =>
          expect(Math.abs(code - first!.mean[k]!), which).toBeLessThan(0.5),
        );
      }
      // The browser empties the canvas before it reports the loss.
      reported ||= isEmpty && count === 0;
      if (isEmpty && reported) {
        expect(count, which).toBe(0);
      }
    }
    expect(reported, what).toBe(what === 'alone');
    same(await pixels(viewer), before, what);
    await nextFrame(page);
    await expectIdle(page, 200, what);
  }
});

test('blended surfaces, cut-outs and materials of the page keep their colours on the way', async ({
  page,
  site,
}) => {
  await keepPixels(page);
  const markup = `<phong-viewer alt="" theta="0" phi="90" radius="2.4" target="0 0 0" samples="256">${LIGHT}</phong-viewer>`;
  await page.goto(site.page(markup, usages.modules));
  await page.evaluate(() => customElements.whenDefined('phong-viewer').then(() => undefined));
  const viewer = page.locator('phong-viewer');
  await viewer.evaluate(async (element: PhongViewer) => {
    element.style.cssText =
      'display: block; width: 64px; height: 48px; background: linear-gradient(red, blue)';
    const three = await import('three');
    const encodes = `void main() { gl_FragColor = vec4(0.2, 0.4, 0.6, 0.5);
      #include <tonemapping_fragment>
      #include <colorspace_fragment>
    }`;
    const checks = new three.DataTexture(new Uint8Array([255, 40, 40, 255]), 2, 2, three.RedFormat);
    checks.needsUpdate = true;
    const glass = { color: 0x3366cc, transparent: true, opacity: 0.5 };
    const materials: readonly Three.Material[] = [
      new three.MeshBasicMaterial(glass),
      new three.MeshBasicMaterial({ ...glass, color: 0xcc6633 }),
      new three.MeshBasicMaterial({ ...glass, blending: three.AdditiveBlending }),
      new three.MeshBasicMaterial({
        ...glass,
        blending: three.MultiplyBlending,
        premultipliedAlpha: true,
      }),
      new three.MeshStandardMaterial({
        color: 0xffffff,
        emissive: 0x404040,
        transparent: true,
        opacity: 0.7,
      }),
      new three.MeshBasicMaterial({ color: 0x22aa44, alphaMap: checks, alphaTest: 0.5 }),
      new three.ShaderMaterial({ fragmentShader: encodes }),
      new three.ShaderMaterial({ fragmentShader: encodes, transparent: true, toneMapped: false }),
    ];
    materials.forEach((material, i) => {
      const mesh = new three.Mesh(new three.PlaneGeometry(0.7, 0.7), material);
      mesh.position.set(0.35 * (i % 4) - 0.5, 0.35 * Math.floor(i / 4) - 0.2, 0.02 * i);
      mesh.rotation.z = 0.2;
      element.scene.add(mesh);
    });
    element.scene.add(new three.AmbientLight(0xffffff, 1));
    const lines = new three.GridHelper(0.6, 6, 0x888888, 0x888888); // stay a pixel wide
    lines.position.y = 0.75;
    lines.rotation.x = 1.5;
    element.scene.add(lines);
    element.requestRender();
    await element.ready;
  });
  const { programs } = await statsOf(viewer);
  for (const opaque of [false, true]) {
    await viewer.evaluate(async (element: PhongViewer, isOpaque) => {
      const three = await import('three');
      element.antialias = 'edges';
      element.scene.background = isOpaque ? new three.Color(0x808080) : null;
      element.requestRender();
      await element.ready;
    }, opaque);
    const rolling = await film(viewer);
    await assign(viewer, { antialias: 'full' });
    await allReady(page);
    await nextFrame(page);
    const frames = await rolling.stop();
    expect(new Set(frames.map(({ samples }) => samples)).size).toBeGreaterThan(2);
    expect(frames.at(-1)!.samples).toBe(256);
    for (const [i, { samples, mean, inside }] of frames.entries()) {
      const which = `${opaque ? 'opaque' : 'transparent'}, frame ${String(i)} with ${String(samples)} samples`;
      mean.forEach((code, k) =>
        expect(Math.abs(code - frames[0]!.mean[k]!), which).toBeLessThan(0.7),
      );
      // Edges of little contrast. What is seen of each surface is 70 pixels.
      expect(inside, which).toBeLessThan(40);
    }
  }
  expect((await statsOf(viewer)).programs - programs, 'sum, mean and copy').toBe(3);
});

test('pictures in view converge first, from the top, and those far from it wait', async ({
  page,
  mount,
}) => {
  await countEverything(page);
  const gap = '<div class="gap"></div>';
  const kinds = ['box', 'cone', 'torus', 'plane', 'cylinder', 'pyramid'];
  const [a, b, c, d, e, f] = kinds.map((kind) => viewerOf(16, `geometry="${kind}"`));
  await mount(`${a!}${gap}${b!}${c!}${d!}${gap}${e!}<div class="far"></div>${f!}`, {
    ...size,
    css: '.gap { height: 800px } .far { height: 5000px }',
    waitForReady: false,
  });
  const finished = await page.evaluateHandle(async () => {
    scrollTo(0, 600);
    const viewers = [...document.querySelectorAll<PhongViewer>('phong-viewer')];
    // Their own observers, which are older, hear of their places first.
    await new Promise((resolve) => new IntersectionObserver(resolve).observe(viewers[0]!));
    const order: number[] = [];
    viewers.forEach((viewer, i) =>
      viewer.addEventListener('render', () => viewer.stats.samples === 16 && order.push(i)),
    );
    await Promise.all(viewers.map(({ ready }) => ready));
    // Once more, with all the code here.
    order.length = 0;
    for (const viewer of viewers) {
      viewer.theta = 44;
    }
    await Promise.all(viewers.map(({ ready }) => ready));
    return order;
  });
  await nextFrame(page);
  expect(await finished.jsonValue(), 'in view, then near').toEqual([1, 2, 3, 0, 4]);
  await expectIdle(page, 200);
  await page.evaluate(() => scrollTo(0, 6000));
  await expect.poll(() => finished.jsonValue()).toEqual([1, 2, 3, 0, 4, 5]);
  await nextFrame(page);
  await expectIdle(page, 200);
});
