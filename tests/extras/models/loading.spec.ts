// Which events do loads dispatch, what stays on screen when one fails, and what do messages say?
// Real files from the page's own server.

import { addressOf } from '../../support/animated-gltf.js';
import { compare, expect, pixels, same, test } from '../../support/test.js';
import { assign, record, set, settled } from '../../element/support/viewer.js';
import { requestsOf } from '../../support/requests.js';

const size = { width: 90, height: 60 };
const bunny = '/assets/models/bunny.glb';
const model = (name: string) => `/fixtures/models/${name}`;

test('the bunny is shown, with progress up to 1 and then one load', async ({ page, mount }) => {
  const viewer = await mount('<phong-viewer></phong-viewer>', size);
  const empty = await pixels(viewer);
  const events = await record(viewer, 'progress', 'load', 'error');
  const loadedAtOnce = await viewer.evaluate((element, src) => {
    element.src = src;
    return element.loaded;
  }, bunny);
  expect(loadedAtOnce).toBe(false);
  await settled(viewer);
  expect(await viewer.evaluate((element) => element.loaded)).toBe(true);
  await expect.poll(async () => (await pixels(viewer)).data.some((code) => code > 0)).toBe(true);
  expect(compare(await pixels(viewer), empty).share).toBeGreaterThan(0.1);
  const heard = await events.take();
  const shares = heard.flatMap(({ type, detail }) =>
    type === 'progress' ? [(detail as { totalProgress: number }).totalProgress] : [],
  );
  expect(shares.at(-1)).toBe(1);
  expect(
    shares.every((share, i) => share >= 0 && share <= 1 && share >= (shares[i - 1] ?? 0)),
  ).toBe(true);
  expect(heard.filter(({ type }) => type !== 'progress')).toEqual([
    { type: 'load', detail: { url: new URL(bunny, page.url()).href, missing: [] } },
  ]);
});

test('a model that cannot be shown is an error with its code, or the author’s own element; the picture stays', async ({
  mount,
  consoleGuard,
}) => {
  consoleGuard.allow(/error: Failed to load resource.*404/, 1);
  consoleGuard.allow(/CSP report|violates the following|Content Security Policy/);
  const shown = model('no-normals.glb');
  const viewer = await mount(`<phong-viewer src="${shown}"></phong-viewer>`, size);
  const before = await pixels(viewer);
  const notice = viewer.locator('[part=notice]');
  const events = await record(viewer, 'error', 'load');
  for (const [src, code] of [
    ['/none.glb', 'load-failed'],
    ['http://[', 'load-failed'],
    [model('truncated.glb'), 'bad-model'],
    [model('wrong-magic.glb'), 'bad-model'],
    [model('claims-zeros.glb'), 'too-large'],
    ['http://127.0.0.1:9/x.glb', 'csp'], // another origin under a strict policy
  ] as const) {
    await set(viewer, { src });
    const heard = await events.take();
    expect(heard, src).toMatchObject([{ type: 'error', detail: { code } }]);
    expect((heard[0]!.detail as { message: string }).message.length, src).toBeGreaterThan(10);
    same(await pixels(viewer), before);
    await expect(notice, src).toBeVisible();
    await set(viewer, { src: shown });
    await expect(notice, src).toHaveCount(0);
    same(await pixels(viewer), before);
    expect(await events.take(), src).toMatchObject([{ type: 'load' }]);
  }
  const own = '<b slot="error">No bunny today</b>';
  await viewer.evaluate((element, html) => element.insertAdjacentHTML('beforeend', html), own);
  await set(viewer, { src: model('truncated.glb') });
  await expect(viewer.locator('b')).toBeVisible();
  await expect(notice).toBeHidden();
});
test('messages repeat a part of long texts in files and addresses', async ({
  mount,
  consoleGuard,
}) => {
  consoleGuard.allow(/error: Failed to load resource/);
  consoleGuard.allow(/warning: .*Save it without that extension\./, 1);
  const viewer = await mount('<phong-viewer></phong-viewer>');
  const errors = await record(viewer, 'error');
  const [word, words] = ['x'.repeat(1e5), 'x '.repeat(5e4)];
  const sources = [
    ...[word, words].map((version) => addressOf({ asset: { version } })),
    addressOf({ asset: { version: '2.0' }, extensionsRequired: [word] }),
    `/${'x'.repeat(5000)}.glb`,
  ];
  for (const [i, src] of sources.entries()) {
    await set(viewer, { src });
    const [error, ...more] = await errors.take();
    expect(more, `source ${i}`).toEqual([]);
    const { message } = error!.detail as { message: string };
    const shown = (await viewer.locator('[part=notice]').textContent())!;
    expect(shown.slice(0, 100), `source ${i}`).toBe(message.slice(0, 100));
    for (const text of [message, shown]) {
      expect(text.length, `source ${i}`).toBeLessThan(530);
      expect(
        Math.max(...text.split(/\s+/).map(({ length }) => length)),
        `source ${i}`,
      ).toBeLessThan(105);
      expect(text, `source ${i}`).toContain('...');
    }
  }
});

test('moving a viewer loads nothing again', async ({ page, mount }) => {
  const mesh = `<phong-mesh src="${model('no-normals.glb')}"></phong-mesh>`;
  const viewer = await mount(
    `<phong-viewer src="${bunny}">${mesh}</phong-viewer><aside></aside>`,
    size,
  );
  const before = await pixels(viewer);
  const requests = requestsOf(page);
  await viewer.evaluate(async (element) => {
    element.remove();
    await element.ready;
    element.append(document.createElement('phong-light'));
    await new Promise((resolve) => setTimeout(resolve, 50));
    element.querySelector('phong-light')?.remove();
    document.querySelector('aside')?.append(element);
    await element.ready;
  });
  same(await pixels(viewer), before);
  expect(requests).toEqual([]);
});

test('a mesh dispatches its own load and error events; so does the viewer', async ({
  page,
  mount,
  consoleGuard,
}) => {
  consoleGuard.allow(/error: Failed to load resource.*404/, 1);
  const viewer = await mount('<phong-viewer><phong-mesh></phong-mesh></phong-viewer>', size);
  const mesh = viewer.locator('phong-mesh');
  const own = await record(mesh, 'load', 'error');
  const viewers = await record(viewer, 'load', 'error');
  await assign(mesh, { src: model('no-normals.glb') });
  await settled(viewer);
  const url = new URL(model('no-normals.glb'), page.url()).href;
  expect(await own.take()).toEqual([{ type: 'load', detail: { url, missing: [] } }]);
  expect(await viewers.take()).toEqual([{ type: 'load', detail: { url, missing: [] } }]);
  const before = await pixels(viewer);
  await assign(mesh, { src: '/none.glb' });
  await settled(viewer);
  const failed = {
    type: 'error',
    detail: expect.objectContaining({ code: 'load-failed' }) as unknown,
  };
  expect(await own.take()).toEqual([failed]);
  expect(await viewers.take()).toEqual([failed]);
  same(await pixels(viewer), before);
  const notice = viewer.locator('[part=notice]');
  await expect(notice).toBeVisible();
  await assign(mesh, { src: '', geometry: 'box' });
  await expect(notice).toHaveCount(0);
});
