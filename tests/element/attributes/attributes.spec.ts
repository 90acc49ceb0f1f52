// Do attributes and properties behave where it takes a browser: upgrades, CSS colours, the heap?
// unit/elements/attributes.test.ts has the complete tables.

import { expect, test } from '../../support/test.js';
import { BAD_COLORS, COLORS } from './css-colors.js';
import { assign } from '../support/viewer.js';

test('values set before the upgrade are used, or give a warning if invalid', async ({
  page,
  site,
  consoleGuard,
}) => {
  const warnings = consoleGuard.allow(/^warning: <phong-/, 7);
  const light = '<phong-light></phong-light>';
  await page.goto(
    site.page(`<phong-viewer>${light}<phong-mesh></phong-mesh>${light}</phong-viewer>`),
  );
  const ofViewer = {
    fov: 33,
    target: [1, 2, 3],
    theta: 'north',
    texts: 'Nochmal',
    autoRotate: null,
    camera: 1,
    ready: 1,
  };
  await assign(page.locator('phong-viewer'), ofViewer);
  const first = page.locator('phong-light').first();
  await assign(first, { diffuse: '#fc8', cutoff: -3, name: 'early' });
  await assign(page.locator('phong-mesh'), { geometry: 'torus', scale: {} });
  await page.evaluate(() => {
    // Objects without a text form.
    const second = document.querySelectorAll('phong-light')[1]!;
    for (const key of ['name', 'diffuse', 'cutoff']) {
      Reflect.set(second, key, Object.create(null));
    }
  });
  await page.addScriptTag({ type: 'module', url: '/dist/phong-viewer.standalone.js' });
  await page.evaluate(() => customElements.whenDefined('phong-viewer'));
  const values = await page.evaluate(() => {
    const viewer = document.querySelector('phong-viewer')!;
    const [light, other] = viewer.lights;
    const [mesh] = viewer.meshes;
    return [
      [viewer.fov, viewer.target, viewer.theta, viewer.autoRotate],
      [light?.diffuse, light?.cutoff, light?.name],
      [other?.diffuse, other?.cutoff, other?.name],
      [mesh?.geometry, mesh?.scale],
    ];
  });
  expect(values).toEqual([
    [33, [1, 2, 3], 30, 0],
    [[255, 204, 136], 0, 'early'],
    [[255, 255, 255], 0, 'light 2'],
    ['torus', [1, 1, 1]],
  ]);
  expect([...warnings].sort().map((line) => /<[\w-]+>\W\w+/.exec(line)?.[0])).toEqual([
    '<phong-light> cutoff',
    '<phong-light> cutoff',
    '<phong-light> diffuse',
    '<phong-light> name',
    '<phong-mesh> scale',
    '<phong-viewer> theta',
    '<phong-viewer>.texts',
  ]);
  await assign(first, { cutoff: 3 });
  expect(await page.evaluate(() => document.querySelector('phong-light')?.cutoff)).toBe(3);
});

test('the browser converts colours to sRGB; text too long or too deep never reaches it', async ({
  page,
  mount,
}) => {
  await mount('<main></main>');
  for (const [text, wanted] of [
    ...Object.entries(COLORS),
    ['oklch(1 0 0)', [255, 255, 255]],
    ['oklch(0.7 0.1 200)', [64.2, 177.0, 182.8]],
    ['lab(50% 0 0)', [118.9, 118.9, 118.9]],
    ['color(display-p3 0.5 0.5 0.5)', [127.5, 127.5, 127.5]],
    ['color(srgb-linear 0.5 0.5 0.5)', [187.5, 187.5, 187.5]],
  ] as const) {
    const color = await page.evaluate(
      (diffuse) => Object.assign(document.createElement('phong-light'), { diffuse }).diffuse,
      text,
    );
    wanted.forEach((code, i) => expect(Math.abs(Number(color[i]) - code), text).toBeLessThan(0.1));
  }
  const outcome = await page.evaluate((bad) => {
    const parser = Object.getOwnPropertyDescriptor(
      CanvasRenderingContext2D.prototype,
      'fillStyle',
    )!;
    let asked = 0;
    Object.defineProperty(CanvasRenderingContext2D.prototype, 'fillStyle', {
      ...parser,
      set(text: string) {
        asked += 1;
        parser.set!.call(this, text);
      },
    });
    const light = document.createElement('phong-light');
    const accepts = (text: string) => {
      try {
        light.diffuse = text;
        return true;
      } catch {
        return false;
      }
    };
    const refusable = bad.filter(accepts);
    asked = 0;
    const accepted = [
      'color-mix('.repeat(40),
      'color-mix(in srgb, '.repeat(5),
      '('.repeat(5e4),
      `rgb(${')'.repeat(50)}${'('.repeat(50)}`,
      'color-mix(/*)*/'.repeat(13),
      `color-mix(")"`.repeat(13),
      'color-mix(\\)'.repeat(13),
      `rgb(1 2 3${' '.repeat(200)}/ 1)`,
      `${' '.repeat(200)}#fc8`,
    ].filter(accepts);
    const before = asked;
    const deep = 'color-mix(in srgb, rgb(calc((100 + 100)) 0 0), rgb(200 0 0))';
    return [refusable, accepted, before, accepts(deep), asked > 0];
  }, BAD_COLORS);
  expect(outcome).toEqual([[], [], 0, true, true]);
});

test('values that were refused are not kept', async ({ page, mount, consoleGuard }) => {
  consoleGuard.allow(/^warning: <phong-light> diffuse=/);
  const light = (await mount('<phong-viewer><phong-light></phong-light></phong-viewer>')).locator(
    'phong-light',
  );
  const session = await page.context().newCDPSession(page);
  const heap = async () => {
    await session.send('HeapProfiler.collectGarbage');
    return (await session.send('Runtime.getHeapUsage')).usedSize;
  };
  const write = (count: number) =>
    light.evaluate((element, times) => {
      for (let i = 0; i < times; i++) {
        const text = `${String(i)} ${'color-mix('.repeat(1e5)}`;
        element.setAttribute('diffuse', text);
        element.setAttribute('diffuse', `#fc8${text}`.slice(0, 199 + i));
        element.removeAttribute('diffuse');
      }
    }, count);
  await write(2);
  const before = await heap();
  await write(150);
  expect((await heap()) - before).toBeLessThan(4e6);
});
