// Does phong-viewer/playwright judge pictures correctly? Right pictures pass, a single wrong pixel
// fails, and messages give the reason.
import { existsSync } from 'node:fs';
import type { Locator } from '@playwright/test';
import { expect, settled, snapshot } from '../../support/built-playwright.js';
import type { PhongViewer } from '../../element/support/viewer.js';
import { patch, type PatchOptions, type Texel } from '../../support/gltf.js';
import { firstOf, fullOr } from '../../support/repeats.js';
import { type ViewerLocator, test } from '../../support/test.js';
import { assign, statsOf } from '../../element/support/viewer.js';

const SIZE = { width: fullOr(105, 54), height: fullOr(70, 36) };
/** A pixel inside a face of a box. */
const [X, Y] = [Math.floor(0.53 * SIZE.width), Math.floor(0.6 * SIZE.height)];
const LIGHTS = `<phong-light position="1 2 1 0" ambient="30 20 40" diffuse="180 180 170" specular="90"></phong-light>
  <phong-light position="2 2 0 1" diffuse="#fc8" attenuation="1 0.2 0.05"></phong-light>`;

/** A box that fills the picture. */
const CLOSE = `<phong-viewer geometry="box" radius="1.3">${LIGHTS}</phong-viewer>`;

/** The matcher's message for a picture that it refuses. */
async function refusal(viewer: ViewerLocator, options: object = {}) {
  try {
    await expect(viewer).toShowTheEquation(options);
  } catch (error) {
    return (error as Error).message;
  }
  throw new Error('toShowTheEquation has passed');
}

/** Adds this to a channel of one pixel of every later picture. */
const spoil = (viewer: ViewerLocator, x: number, y: number, channel: number, by: number) =>
  viewer.evaluate(
    (element, at) => {
      const draw = element.toBlob.bind(element);
      element.toBlob = async (options) => {
        const bitmap = await createImageBitmap(await draw(options));
        const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
        const context = canvas.getContext('2d')!;
        context.drawImage(bitmap, 0, 0);
        const pixel = context.getImageData(at.x, at.y, 1, 1);
        pixel.data[at.channel]! += at.by;
        context.putImageData(pixel, at.x, at.y);
        return canvas.convertToBlob();
      };
    },
    { x, y, channel, by },
  );

/** Every later picture is that of the viewer with these attributes, or moved to the right. */
const giveFault = (
  viewer: ViewerLocator,
  attributes: Readonly<Record<string, string>>,
  moved = 0,
) =>
  viewer.evaluate(
    async (element, fault) => {
      const wrong = element.cloneNode(true) as PhongViewer;
      for (const [name, value] of Object.entries(fault.attributes)) {
        (wrong.querySelector(`[${name}]`) ?? wrong).setAttribute(name, value);
      }
      element.after(wrong);
      await wrong.ready;
      const bitmap = await createImageBitmap(await wrong.toBlob());
      wrong.remove();
      const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
      canvas.getContext('2d')!.drawImage(bitmap, fault.moved, 0);
      const blob = await canvas.convertToBlob();
      element.toBlob = () => Promise.resolve(blob);
    },
    { attributes, moved },
  );

/** Those with `segments="auto"`: their triangles are smaller than pixels. */
const ROUND = ['teapot', 'torus-knot', 'cone', 'sphere', 'torus', 'cylinder'] as const;

test.describe('toShowTheEquation', () => {
  test('accepts flats and curves, hard edges of cones, averaged and interpolated colours', async ({
    mount,
  }) => {
    test.slow();
    const pictures = Object.entries({
      'a box': `<phong-viewer geometry="box" radius="2">${LIGHTS}</phong-viewer>`,
      'highlights and cones with hard edges, averaged': `<phong-viewer geometry="plane" radius="1.2" antialias="full" samples="16" shininess="500">
      <phong-light position="0.1 0.3 0 1" axis="0 -1 0.2" aperture="40" specular="255"></phong-light></phong-viewer>`,
      'a sphere without lights': '<phong-viewer geometry="sphere" segments="16"></phong-viewer>',
      'Gouraud shading in linear light': `<phong-viewer geometry="sphere" segments="16" shading="gouraud" color-interpolation="linear">${LIGHTS}</phong-viewer>`,
      'flat shading with Blinn’s highlights': `<phong-viewer geometry="sphere" segments="16" shading="flat" reflection="blinn-phong">${LIGHTS}</phong-viewer>`,
      'cones with hard edges, whose pixels lie on either side': `<phong-viewer geometry="plane" radius="1.2">
      <phong-light position="0.1 0.3 0 1" axis="0 -1 0.2" aperture="40"></phong-light>
      <phong-light space="camera" position="0 0 0 1" aperture="9" diffuse="80 20 90"></phong-light></phong-viewer>`,
      'highlights that begin at the horizon': `<phong-viewer geometry="plane" radius="1.2" ks="255">
      <phong-light position="0.2 0.001 0 1" specular="255" diffuse="0"></phong-light>
      <phong-mesh geometry="plane" shininess="0.1" position="0 0.1 0" rotation="20 0 0"></phong-mesh></phong-viewer>`,
      'a scene far from the origin': `<phong-viewer target="1e6 -3e6 2e6" radius="3">
      <phong-mesh geometry="box" position="1e6 -3e6 2e6"></phong-mesh>
      <phong-light position="1000001 -2999999 2000000 1" axis="-1 -1 0" aperture="30"></phong-light></phong-viewer>`,
      'a mesh in front of another': `<phong-viewer radius="3" target="0 0 0"><phong-mesh geometry="box"></phong-mesh>
      <phong-mesh geometry="cone" position="0 0.6 0.9" reflection="blinn-phong"></phong-mesh>${LIGHTS}</phong-viewer>`,
    });
    const some = firstOf(pictures, 2);
    const all = (await mount(some.map(([, markup]) => markup).join(''), SIZE))
      .page()
      .locator('phong-viewer');
    for (const [i, [what]] of some.entries()) {
      await expect(all.nth(i), what).toShowTheEquation({
        codes: 1,
        share: 0.1,
        pixels: fullOr(1e4, 250),
      });
    }
  });

  test('accepts viewers that are moved by CSS, on dense screens, at any fraction of a pixel', async ({
    mount,
  }) => {
    const viewer = await mount(
      `<main><phong-viewer geometry="box">${LIGHTS}</phong-viewer></main>`,
      {
        css: 'main { rotate: 20deg; margin: 60.3px } phong-viewer { width: 70.4px; height: 50.7px; border: 3px solid; padding: 2px; zoom: 1.3 }',
        deviceScaleFactor: 2,
      },
    );
    await expect(viewer).toShowTheEquation({ pixels: fullOr(1e4, 1000) });
  });

  test('judges enough of every default shape, at outlines and everywhere antialiased', async ({
    mount,
  }) => {
    test.slow();
    const viewers = firstOf(ROUND, 2).flatMap((shape, i) =>
      firstOf(i % 2 === 0 ? ['edges', 'full'] : ['full', 'edges'], 1).map(
        (antialias) =>
          `<phong-viewer geometry="${shape}" antialias="${antialias}" samples="16"></phong-viewer>`,
      ),
    );
    const all = (await mount(viewers.join(''), { width: 300, height: 200 }))
      .page()
      .locator('phong-viewer');
    for (const [i, markup] of viewers.entries()) {
      await expect(all.nth(i), markup).toShowTheEquation({ pixels: fullOr(1500, 250) });
    }
  });

  test('finds a wrong light, a wrong exponent, a colour a few codes off, and a shifted picture', async ({
    mount,
  }) => {
    test.slow();
    const wrongs: readonly (readonly [string, Readonly<Record<string, string>>, number?])[] = [
      ['another exponent', { shininess: '20' }],
      ['a pixel to the right', {}, 1],
      ['a brighter light', { diffuse: '186 180 170' }],
      ['another direction', { position: '1.1 2 1 0' }],
    ];
    for (const scene of firstOf(['sphere', 'torus" antialias="full" samples="16'], 1)) {
      const markup = `<phong-viewer geometry="${scene}" shininess="24">${LIGHTS}</phong-viewer>`;
      const viewer = await mount(markup, { width: 150, height: 100 });
      for (const [what, attributes, moved] of firstOf(wrongs, 2)) {
        await giveFault(viewer, attributes, moved);
        expect(
          await refusal(viewer, { share: 0.1, pixels: fullOr(2000, 250) }),
          `${scene}: ${what}`,
        ).toMatch(/\n {2}pixel \d+, \d+: (\d+ ){4}is drawn, ([\d.]+–[\d.]+ ){3}is the equation's/);
      }
    }
  });

  test('@release judges 10,000 pixels by default', async ({ mount }, info) => {
    await expect(await mount(CLOSE, { width: 200, height: 130 })).toShowTheEquation();
    const [{ description = '' } = {}] = info.annotations;
    expect(parseInt(description, 10)).toBeGreaterThanOrEqual(10_000);
    expect(parseInt(description, 10)).toBeLessThan(10_100);
    expect(description).toContain('(seed 1)');
  });

  test('judges as many pixels as asked for, and reports how many', async ({ mount }, info) => {
    const report = () => info.annotations.at(-1)?.description ?? '';
    const viewer = await mount(CLOSE, SIZE);
    await spoil(viewer, X, Y, 1, -2);
    await expect(viewer).toShowTheEquation({ pixels: 100, seed: 2 });
    expect(info.annotations).toHaveLength(1);
    expect(parseInt(report(), 10)).toBeLessThan(200);
    expect(report()).toMatch(
      /pixels of surfaces in a sample of \d+ % of the picture \(seed 2\) were judged/,
    );
    expect(await refusal(viewer, { pixels: 'all' })).toMatch(
      /^\d+ of \d+ pixels of surfaces were judged/,
    );
    await expect(viewer).toShowTheEquation({ pixels: 'all', codes: 2 });
    const [judged = 0, surface = 0] = report().match(/\d+/g)!.map(Number);
    expect(judged).toBeGreaterThan(0.7 * surface);
    expect(judged).toBeLessThan(surface);
  });

  test('names what it gets instead of a viewer', async ({ mount, page, site }) => {
    const viewer = await mount('<main><phong-viewer></phong-viewer></main><p></p>', SIZE);
    const advice = "expected a locator of a <phong-viewer>, such as page.locator('phong-viewer')";
    for (const [target, words] of [
      [page, `${advice}, got a Page`],
      [undefined, `${advice}, got undefined`],
      [page.locator('main'), `${advice}: locator('main') is a <main> with 1 inside`],
      [page.locator('p'), 'is a <p> with no viewer inside'],
      [page.locator('#no'), `no element matches locator('#no') after 100 ms`],
    ] as const) {
      expect(await refusal(target as ViewerLocator, { timeout: 100 })).toContain(words);
    }
    await viewer.evaluate((element) => element.after(element.cloneNode()));
    expect(await refusal(page.locator('phong-viewer'))).toContain('resolved to 2 elements');
    await page.goto(site.page('<phong-viewer></phong-viewer>'));
    expect(await refusal(page.locator('phong-viewer'), { timeout: 200 })).toContain(
      'is not defined',
    );
  });

  test('warns of a filter or opacity, on the viewer or around it', async ({ mount }, info) => {
    const viewer = await mount(
      `<main><phong-viewer geometry="box">${LIGHTS}</phong-viewer></main>`,
      SIZE,
    );
    await viewer.evaluate((element) => (element.style.filter = 'brightness(0.5)'));
    await expect(viewer).toShowTheEquation({ pixels: 100 });
    await viewer.evaluate((element) => {
      element.style.filter = '';
      element.parentElement!.style.opacity = '0.5';
    });
    await expect(viewer).toShowTheEquation({ pixels: 100 });
    expect(
      info.annotations.filter(({ type }) => type === 'warning').map((one) => one.description),
    ).toEqual([
      expect.stringContaining('<phong-viewer> has the style "filter: brightness(0.5)"'),
      expect.stringContaining('<main> has the style "opacity: 0.5"'),
    ]);
  });

  test('refuses a single channel that is two codes off, and a hole, and names the pixel', async ({
    mount,
  }) => {
    const viewer = await mount(`<phong-viewer geometry="box">${LIGHTS}</phong-viewer>`, SIZE);
    await spoil(viewer, X, Y, 1, -2);
    const message = await refusal(viewer);
    expect(message).toContain('1 of them differ by more than 1 code.');
    expect(message).toContain(`pixel ${X}, ${Y}: `);
    expect(message).toMatch(/: \d+ \d+ \d+ 255 is drawn, ([\d.]+–[\d.]+ ){3}is the equation's/);
    await expect(viewer).toShowTheEquation({ codes: 2 });
    await expect(viewer).not.toShowTheEquation({ codes: 0 });
    await spoil(viewer, X + 1, Y, 3, -1);
    expect(await refusal(viewer, { codes: 2 })).toContain(`pixel ${X + 1}, ${Y}: `);
  });

  test('refuses pictures that it could hardly judge, and values that mean nothing', async ({
    mount,
  }) => {
    const tiny = await mount('<phong-viewer geometry="torus-knot"></phong-viewer>', {
      width: 30,
      height: 20,
    });
    expect(await refusal(tiny)).toMatch(
      /^\d+ of \d+ .*At least 25 % are needed: make the viewer larger/,
    );
    await assign(tiny, { target: [9, 9, 9] });
    for (const [options, words] of [
      [{ share: 0 }, 'The picture shows no surface.'],
      [{ codes: 0.5 }, 'codes must be a whole number'],
      [{ share: 2 }, 'share must be from 0 to 1'],
      [{ pixels: 0 }, "pixels must be a whole number from 1 on, or 'all'"],
      [{ seed: 0.5 }, 'seed must be a whole number'],
    ] as const) {
      expect(await refusal(tiny, options)).toContain(words);
    }
  });

  test('names a file that is missing, and says that a viewer is empty', async ({
    mount,
    consoleGuard,
  }) => {
    consoleGuard.allow(/404/);
    const missing = await mount(
      '<phong-viewer><phong-mesh geometry="box"></phong-mesh><phong-mesh src="/no/nope.glb"></phong-mesh></phong-viewer>',
      SIZE,
    );
    expect(await refusal(missing)).toContain('toShowTheEquation: nope.glb: load-failed (');
    await expect(expect(missing).not.toShowTheEquation()).rejects.toThrow('nope.glb: load-failed');
    expect(await refusal(await mount('<phong-viewer></phong-viewer>', SIZE))).toContain(
      'toShowTheEquation: the viewer is empty',
    );
  });

  test('has stack traces that name files of the package', async () => {
    const error = await settled(undefined as unknown as Locator).catch((reason: unknown) => reason);
    const { stack = '' } = error as Error;
    const files = [...stack.matchAll(/(?:\(|at )(?:file:\/\/)?(\/[^)]*?):\d+:\d+/g)].map(
      ([, file]) => file!,
    );
    expect(files[0]).toMatch(/\/playwright\.js$/);
    for (const file of files) {
      expect(existsSync(file), file).toBe(true);
    }
    expect(stack).not.toContain('/src/');
  });

  test('leaves out textures drawn smaller than they are, and translucent surfaces', async ({
    mount,
  }) => {
    const modelOf = (src: string) => `<phong-viewer src="${src}">${LIGHTS}</phong-viewer>`;
    await expect(await mount(modelOf('/fixtures/models/textured.glb'), SIZE)).toShowTheEquation({
      share: 0.1,
    });
    const textures = [Array.from({ length: 128 ** 2 }, (_, i): Texel => [(i * 37) % 256, 99, 99])];
    const fine = {
      material: { pbrMetallicRoughness: { baseColorTexture: { index: 0 } } },
      textures,
      mipmaps: true,
    };
    const glass = {
      material: { alphaMode: 'BLEND', pbrMetallicRoughness: { baseColorFactor: [1, 1, 1, 0.5] } },
    };
    const refused = async (options: PatchOptions) =>
      refusal(await mount(modelOf(patch(options)), SIZE));
    expect(await refused(fine)).toMatch(
      /^0 of \d+ .*\d+ with textures drawn smaller than they are/,
    );
    expect(await refused(glass)).toMatch(/^0 of \d+ .*\d+ translucent/);
  });
});

test.describe('settled', () => {
  test('waits for models, and for the programs that take over', async ({ mount }) => {
    const viewer = await mount(
      `<phong-viewer src="/assets/models/bunny.glb">${LIGHTS}</phong-viewer>`,
      {
        ...SIZE,
        waitForReady: false,
      },
    );
    await settled(viewer);
    expect(await viewer.evaluate((element) => element.loaded)).toBe(true);
    // The general program and the specialised one.
    expect((await statsOf(viewer)).programs).toBe(2);
  });

  test('scrolls to viewers that can be drawn', async ({ mount, page }) => {
    const css = 'div { height: 5000px }';
    await settled(await mount('<div></div><phong-viewer geometry="box"></phong-viewer>', { css }));
    expect(await page.evaluate(() => scrollY)).toBeGreaterThan(3000);
  });

  test('rejects while the picture moves or a model is loading, and names the cause', async ({
    mount,
    page,
  }) => {
    const moving = await mount(
      '<phong-viewer geometry="box" auto-rotate="20"></phong-viewer>',
      SIZE,
    );
    await expect(settled(moving, { timeout: 1500 })).rejects.toThrow(
      'not settled after 1500 ms: auto-rotate is 20',
    );
    await assign(moving, { autoRotate: 0 });
    await settled(moving);
    await page.route('**/never.glb', () => undefined);
    const loading = await mount('<phong-viewer src="/never.glb"></phong-viewer>', {
      ...SIZE,
      waitForReady: false,
    });
    await expect(settled(loading, { timeout: 500 })).rejects.toThrow('still loading');
  });
});

test.describe('snapshot', () => {
  const markup = `<phong-viewer geometry="teapot" theta="40">${LIGHTS}</phong-viewer>`;

  test('@release gives the same bytes on dense screens, at once and after motion', async ({
    mount,
  }) => {
    const plain = await snapshot(await mount(markup, SIZE));
    const dense = await mount(markup, { ...SIZE, deviceScaleFactor: 2 });
    expect(plain.equals(await snapshot(dense))).toBe(true);
    const moved = await mount(markup.replace('40', '39'), SIZE);
    await moved.evaluate(async (element) => {
      for (let i = 0; i < 25; i++) {
        element.theta = 39 + i / 10;
        await new Promise(requestAnimationFrame);
      }
      element.theta = 40;
    });
    expect(plain.equals(await snapshot(moved))).toBe(true);
  });

  test('has the size asked for, whatever the viewer covers', async ({ mount }) => {
    const png = await snapshot(await mount(markup, SIZE), { width: 320, height: 240 });
    expect([png.readUInt32BE(16), png.readUInt32BE(20)]).toEqual([320, 240]);
    const own = await snapshot(await mount(markup, SIZE));
    expect([own.readUInt32BE(16), own.readUInt32BE(20)]).toEqual([SIZE.width, SIZE.height]);
  });
});
