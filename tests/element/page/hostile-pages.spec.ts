// Does a viewer work on pages that change what every script relies on, or say what is wrong with
// them?

import type { Page } from '@playwright/test';
import { firstOf } from '../../support/repeats.js';
import { compare, expect, pixels, same, test } from '../../support/test.js';
import { nextFrame, record, type PhongViewer, settled } from '../support/viewer.js';

const size = { width: 200, height: 150 };
const light = '<phong-light position="1 2 3 1" cutoff="5"></phong-light>';
const model = '/fixtures/models/textured.glb';

/** As old frameworks do, enumerable: a function, a text and a list. */
const pollute = (page: Page) =>
  page.addInitScript(() => {
    Object.assign(Object.prototype, {
      extend(other: object) {
        return other;
      },
      note: 'a text',
      entries: [1, 2],
    });
  });

const scenes = {
  'a shape': `<phong-viewer geometry="teapot">${light}</phong-viewer>`,
  'a flat shape': `<phong-viewer geometry="sphere" shading="flat">${light}</phong-viewer>`,
  'a text model': `<phong-viewer src="/fixtures/models/quads.obj">${light}</phong-viewer>`,
  'a glTF model': `<phong-viewer src="${model}">${light}</phong-viewer>`,
  'a glTF model with Draco': `<phong-viewer src="/assets/models/bunny.glb">${light}</phong-viewer>`,
  'a glTF model with a skin': `<phong-viewer src="/assets/models/real/figure/RiggedFigure.gltf">${light}</phong-viewer>`,
  'a glTF model with morph targets': `<phong-viewer src="/assets/models/real/morph-cube/AnimatedMorphCube.gltf">${light}</phong-viewer>`,
  'a flat glTF model': `<phong-viewer src="${model}" shading="flat">${light}</phong-viewer>`,
  'a converged picture': `<phong-viewer geometry="box" antialias="full" samples="16">${light}</phong-viewer>`,
  'a viewer with all extras': `<phong-viewer geometry="box" gui helpers="lights axes grid normals bounds"
    view="n-dot-l" probe probe-at="0.5 0.5 0.5" camera-group="a">${light}</phong-viewer>`,
  'a comparison': `<phong-compare><phong-viewer geometry="box">${light}</phong-viewer>
    <phong-viewer geometry="torus">${light}</phong-viewer></phong-compare>`,
};

test('shows every kind of scene alike whatever a page adds to Object.prototype', async ({
  page,
  mount,
}) => {
  const all = Object.entries(scenes);
  const shown = async () => {
    await mount(all.map(([, markup]) => `<main>${markup}</main>`).join(''), {
      ...size,
      css: `main { float: left; width: ${size.width}px }`,
    });
    const first = page.locator('main phong-viewer:first-child');
    return Promise.all((await first.all()).map((viewer) => pixels(viewer)));
  };
  const clean = await shown();
  await pollute(page);
  for (const [i, picture] of (await shown()).entries()) {
    expect.soft(compare(picture, clean[i]!).max, all[i]![0]).toBe(0);
  }
  expect(clean).toHaveLength(all.length);
});

const extras = [
  'probe',
  'probe probe-at="0.5 0.5 0.5"',
  'probe-at="0.5 0.5 0.5"',
  'helpers="lights"',
  'view="n-dot-l"',
  'gui',
  'camera-group="a"',
  `src="${model}"`,
];

/** Milliseconds after the viewer came; -1: in the same task. */
const MOMENTS = firstOf([-1, 0, 3, 8, 28, 1, 2, 4, 5, 6, 7, 18, 38, 48, 58], 5);

for (const extra of extras) {
  test(`a viewer with ${extra} moves into a template at any time, and back`, async ({
    page,
    mount,
  }) => {
    const viewer = await mount(`<phong-viewer geometry="box"></phong-viewer>`, size);
    await page.evaluate(
      async ({ attributes, moments }) => {
        const pause = (ms: number) => new Promise((resolve) => setTimeout(resolve, ms));
        for (const ms of moments) {
          const template = document.createElement('template');
          document.body.append(template);
          const place = document.createElement('section');
          place.innerHTML = `<phong-viewer geometry="box" ${attributes}><phong-light></phong-light></phong-viewer>`;
          document.body.append(place);
          const moved = place.firstElementChild as PhongViewer;
          await (ms < 0 ? undefined : pause(ms));
          template.content.append(moved);
          await pause(20);
          moved.theta += 5;
          await moved.ready;
          place.append(moved);
          await moved.ready;
          place.remove();
          template.remove();
        }
      },
      { attributes: extra, moments: MOMENTS },
    );
    await nextFrame(page);
    await settled(viewer);
  });
}

test('says once on a page of XHTML that it needs HTML', async ({ page, site, consoleGuard }) => {
  const said = consoleGuard.allow(/served as application\/xhtml\+xml/, 1);
  await page.route('**/page.xhtml', (route) =>
    route.fulfill({
      contentType: 'application/xhtml+xml',
      body: `<html xmlns="http://www.w3.org/1999/xhtml"><head><title>x</title>
        <script src="/dist/phong-viewer.classic.js" defer="defer"></script></head>
        <body><phong-viewer geometry="box"><phong-light></phong-light></phong-viewer></body></html>`,
    }),
  );
  await page.goto(`${site.origin}/page.xhtml`);
  await expect.poll(() => said.length).toBe(1);
  await nextFrame(page);
});

test('a model for which the GPU has no memory is too large, and the picture before it stays', async ({
  page,
  mount,
  consoleGuard,
}) => {
  // Drawing with what was not allocated: the browser's own words.
  consoleGuard.allow(/Insufficient buffer size/);
  await page.addInitScript(() => {
    const { bufferData, getError } = WebGL2RenderingContext.prototype;
    let refused = false;
    const refuses = (data: unknown) =>
      (window as { full?: boolean }).full === true && ArrayBuffer.isView(data);
    WebGL2RenderingContext.prototype.bufferData = function (
      this: WebGL2RenderingContext,
      ...given: unknown[]
    ) {
      if (refuses(given[1])) {
        refused = true;
      } else {
        Reflect.apply(bufferData, this, given);
      }
    } as typeof bufferData;
    WebGL2RenderingContext.prototype.getError = function () {
      const error = refused ? this.OUT_OF_MEMORY : getError.call(this);
      refused = false;
      return error;
    };
  });
  const viewer = await mount(`<phong-viewer geometry="box">${light}</phong-viewer>`, size);
  const before = await pixels(viewer);
  const heard = await record(viewer, 'error');
  await viewer.evaluate((element, src) => {
    Object.assign(window, { full: true });
    element.src = src;
    return element.ready;
  }, model);
  await expect
    .poll(() => heard.take())
    .toEqual([
      { type: 'error', detail: expect.objectContaining({ code: 'too-large' }) as unknown },
    ]);
  await viewer.evaluate(() => Object.assign(window, { full: false }));
  same(await pixels(viewer), before);
});
