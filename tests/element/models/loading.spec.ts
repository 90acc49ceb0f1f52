// Which events do loads dispatch, and what stays on screen when one fails? Real files from the page's own server.

import { compare, expect, pixels, test, type Picture } from '../../support/test.js';
import { assign, type PhongViewer, record, settled } from '../support/viewer.js';

const size = { width: 90, height: 60 };
const bunny = '/assets/models/bunny.glb';
const model = (name: string): string => `/fixtures/models/${name}`;
const same = (a: Picture, b: Picture): void => expect(compare(a, b).max).toBe(0);

test('the bunny is shown, with progress up to 1 and then one load', async ({ page, mount }) => {
  const viewer = await mount('<phong-viewer></phong-viewer>', size);
  const empty = await pixels(viewer);
  const events = await record(viewer, 'progress', 'load', 'error');
  const loadedAtOnce = await viewer.evaluate((element: PhongViewer, src) => {
    element.src = src;
    return element.loaded;
  }, bunny);
  expect(loadedAtOnce).toBe(false);
  await settled(viewer);
  expect(await viewer.evaluate((element: PhongViewer) => element.loaded)).toBe(true);
  await expect.poll(async () => (await pixels(viewer)).data.some((code) => code > 0)).toBe(true);
  expect(compare(await pixels(viewer), empty).share).toBeGreaterThan(0.1);
  const heard = await events.take();
  const shares = heard.filter(({ type }) => type === 'progress').map(({ detail }) => (detail as { totalProgress: number }).totalProgress); // prettier-ignore
  expect(shares.at(-1)).toBe(1);
  expect(shares.every((share, i) => share >= 0 && share <= 1 && share >= (shares[i - 1] ?? 0))).toBe(true);
  expect(heard.filter(({ type }) => type !== 'progress')).toEqual([
    { type: 'load', detail: { url: new URL(bunny, page.url()).href, missing: [] } },
  ]);
});

test('a model’s file is requested while the code that reads it is still on the way', async ({
  page,
  mount,
}) => {
  let letGo = (): void => undefined;
  const free = new Promise<void>((resolve) => (letGo = resolve));
  await page.route(/model-content/, async (route) => {
    await free;
    await route.continue();
  });
  const requested = page.waitForRequest(/textured\.glb/);
  const viewer = await mount(`<phong-viewer src="${model('textured.glb')}"></phong-viewer>`, {
    ...size,
    waitForReady: false,
  });
  await requested;
  letGo();
  await settled(viewer);
  expect(await viewer.evaluate((element: PhongViewer) => element.loaded)).toBe(true);
});

for (const [what, src, code, allowed] of [
  ['that is not there', '/none.glb', 'load-failed', /error: Failed to load resource.*404/],
  ['whose address is none', 'http://[', 'load-failed', null],
  ['that is cut short', model('truncated.glb'), 'bad-model', null],
  ['that is no model', model('wrong-magic.glb'), 'bad-model', null],
  ['that unpacks to too much', model('claims-zeros.glb'), 'too-large', null],
  ['of another origin under a strict policy', 'http://127.0.0.1:9/x.glb', 'csp', /CSP report|violates the following|Content Security Policy/], // prettier-ignore
] as const) {
  test(`a model ${what} is an error of code ${code}; what was shown stays, with a message`, async ({
    mount,
    consoleGuard,
  }) => {
    if (allowed !== null) consoleGuard.allow(allowed);
    const viewer = await mount(`<phong-viewer src="${model('no-normals.glb')}"></phong-viewer>`, size);
    const before = await pixels(viewer);
    const events = await record(viewer, 'error', 'load');
    await assign(viewer, { src });
    await settled(viewer);
    const [event, ...more] = await events.take();
    expect(event).toMatchObject({ type: 'error', detail: { code } });
    expect((event?.detail as { message: string }).message.length).toBeGreaterThan(10);
    expect(more).toEqual([]);
    same(await pixels(viewer), before);
    const notice = viewer.locator('[part=notice]');
    await expect(notice).toBeVisible();
    await assign(viewer, { src: model('no-normals.glb') });
    await settled(viewer);
    await expect(notice).toHaveCount(0);
    same(await pixels(viewer), before);
  });
}

test('a newer src wins, whichever arrives first', async ({ mount }) => {
  const viewer = await mount(`<phong-viewer src="${model('no-normals.glb')}"></phong-viewer>`, size);
  const wanted = await pixels(viewer);
  const events = await record(viewer, 'load', 'error');
  await assign(viewer, { src: bunny });
  await viewer.evaluate(() => Promise.resolve());
  await assign(viewer, { src: model('no-normals.glb') });
  await settled(viewer);
  same(await pixels(viewer), wanted);
  expect((await events.take()).filter(({ type }) => type === 'error')).toEqual([]);
});

test('an author’s own element in the slot error takes the place of the message', async ({
  mount,
  consoleGuard,
}) => {
  consoleGuard.allow(/error: Failed to load resource.*404/);
  const viewer = await mount(
    '<phong-viewer src="/none.glb"><b slot="error">No bunny today</b></phong-viewer>',
    size,
  );
  await expect(viewer.locator('b')).toBeVisible();
  await expect(viewer.locator('[part=notice]')).toBeHidden();
});

test('without a poster the first picture does not move the page', async ({ mount }) => {
  const other = await mount('<phong-viewer></phong-viewer>', size);
  const pending = await other.evaluate(async (element) => {
    const viewer = document.createElement('phong-viewer');
    element.replaceWith(viewer);
    return new Promise<boolean>((resolve) => {
      const drawn = (): void => resolve(viewer.isUpdatePending);
      viewer.addEventListener('render', drawn, { once: true });
    });
  });
  expect(pending).toBe(false);
});

test('lazy loads nothing until the viewer can be seen', async ({ page, mount }) => {
  const requests: string[] = [];
  page.on('request', (request) => requests.push(new URL(request.url()).pathname));
  const viewer = await mount(
    `<div class="tall"></div><phong-viewer loading="lazy" src="${bunny}"></phong-viewer>`,
    { ...size, css: '.tall { height: 5000px }' },
  );
  expect(requests).not.toContain(bunny);
  await viewer.scrollIntoViewIfNeeded();
  await expect.poll(() => requests.filter((path) => path === bunny).length).toBe(1);
  await expect.poll(() => viewer.evaluate((element: PhongViewer) => element.loaded)).toBe(true);
});

test('moving a viewer loads nothing again', async ({ page, mount }) => {
  const viewer = await mount(`<phong-viewer src="${bunny}"><phong-mesh src="${model('no-normals.glb')}"></phong-mesh></phong-viewer><aside></aside>`, size); // prettier-ignore
  const before = await pixels(viewer);
  const requests: string[] = [];
  page.on('request', (request) => requests.push(request.url()));
  await viewer.evaluate(async (element: PhongViewer) => {
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
