// Do viewers with the same `camera-group` always have exactly the same camera? Poses are compared bit by bit, and
// events counted.

import type { Page } from '@playwright/test';
import { allReady, expect, test } from '../../support/test.js';
import { opened, slider } from '../panel/panel-rows.js';
import { countEverything, NOTHING, spentIn } from '../support/counting.js';
import { assign, cameraOf, drag, nextFrame, type PhongViewer, record, settled } from '../support/viewer.js';

/** Two viewers of 300 × 200 side by side. */
const pair = (first: string, second: string, inner = ''): string =>
  `<phong-viewer geometry="box" camera-group="a" ${first}>${inner}</phong-viewer>` +
  `<phong-viewer geometry="box" camera-group="a" ${second}>${inner}</phong-viewer>`;

const size = { width: 300, height: 200, css: 'phong-viewer { display: inline-block }' } as const;

/** Angles, radius and target of each viewer, in document order, shadow trees not included. */
const poses = (page: Page): Promise<string[]> =>
  page.evaluate(() =>
    Array.from(document.querySelectorAll('phong-viewer'), ({ camera }) => {
      const { theta, phi, radius, target } = camera;
      return JSON.stringify({ theta, phi, radius, target });
    }),
  );

async function expectOnePose(page: Page): Promise<{ theta: number; phi: number; radius: number }> {
  const all = await poses(page);
  expect(new Set(all).size, all.join('\n')).toBe(1);
  return JSON.parse(all[0] ?? '') as { theta: number; phi: number; radius: number };
}

test('the first viewer of a group keeps its camera, and the others take it', async ({ page, mount }) => {
  await mount(pair('theta="10" radius="5"', 'theta="80" phi="20"'), size);
  expect(await expectOnePose(page)).toMatchObject({ theta: 10, phi: 70, radius: 5 });
});

test('the first picture is the group’s, however late its code comes, and is drawn once', async ({
  page,
  mount,
}) => {
  let send = (): void => undefined;
  const sent = new Promise<void>((resolve) => (send = resolve));
  await page.route(/\/camera-group-/, async (route) => {
    await sent;
    return route.continue();
  });
  await mount(pair('theta="10"', 'theta="80"'), { ...size, waitForReady: false });
  const frames = (): Promise<number[]> =>
    page.evaluate(() => [...document.querySelectorAll('phong-viewer')].map(({ stats }) => stats.frames));
  for (let i = 0; i < 3; i++) await nextFrame(page);
  expect(await frames()).toEqual([0, 0]);
  send();
  await allReady(page);
  expect(await frames()).toEqual([1, 1]);
  await expectOnePose(page);
});

test('a drag, a wheel turn, keys and a property move all viewers, with one event each', async ({
  page,
  mount,
}) => {
  const first = await mount(pair('', ''), size);
  const second = page.locator('phong-viewer').nth(1);
  const heard = [await record(first, 'camera-change'), await record(second, 'camera-change')] as const;
  const deeds: readonly (readonly [source: string, deed: () => Promise<unknown>])[] = [
    ['pointer', () => drag(page, [450, 100], [33, 17], { steps: 1 })],
    ['wheel', () => page.mouse.wheel(0, 70)],
    ['key', () => page.keyboard.press('ArrowLeft')],
    ['key', () => page.keyboard.press('Home')],
    ['script', () => assign(second, { theta: 12.345 })],
    ['script', () => assign(second, { target: [0.1, 0.2, 0.3] })],
    ['key', () => page.keyboard.press('ArrowUp')],
    ['script', () => second.evaluate((element: PhongViewer) => element.resetCamera())],
  ];
  let before = JSON.stringify(await expectOnePose(page));
  for (const [source, deed] of deeds) {
    await deed();
    await nextFrame(page);
    const after = JSON.stringify(await expectOnePose(page));
    expect(after, source).not.toBe(before);
    before = after;
    expect(await heard[1].take()).toEqual([{ type: 'camera-change', detail: { source } }]);
    expect(await heard[0].take()).toEqual([{ type: 'camera-change', detail: { source, linked: true } }]);
  }
});

test('auto fits the largest scene of the group, and again when members come, go and change', async ({
  page,
  mount,
}) => {
  const small = await mount(
    `${pair('', '')}<phong-viewer camera-group="a"><phong-mesh geometry="box" scale="3" position="1 0 0"></phong-mesh></phong-viewer>`,
    size,
  );
  const alone = (await cameraOf(small)).radius / 3;
  expect((await cameraOf(small)).target).toEqual([1, 0, 0]);
  await expectOnePose(page);
  await page
    .locator('phong-viewer')
    .nth(2)
    .evaluate((element) => element.remove());
  await nextFrame(page);
  expect((await expectOnePose(page)).radius).toBeCloseTo(alone, 9);
  await assign(page.locator('phong-viewer').nth(1), { fov: 20 });
  await nextFrame(page);
  const narrow = (await expectOnePose(page)).radius;
  expect(narrow).toBeGreaterThan(2 * alone);
  // Empty scenes do not count.
  await page.evaluate(() => {
    const empty = document.createElement('phong-viewer');
    empty.cameraGroup = 'a';
    empty.alt = 'Nothing';
    document.body.append(empty);
    return empty.ready;
  });
  await nextFrame(page);
  expect((await expectOnePose(page)).radius).toBe(narrow);
});

test('a member that is not displayed counts, and has the right camera when it comes back', async ({
  page,
  mount,
}) => {
  const first = await mount(pair('', 'hidden'), {
    ...size,
    css: `${size.css} [hidden] { display: none !important }`,
  });
  const second = page.locator('phong-viewer').nth(1);
  await assign(second, { fov: 20 });
  await nextFrame(page);
  const { radius } = await expectOnePose(page);
  await drag(page, [100, 100], [33, 17]);
  await second.evaluate((element: PhongViewer) => (element.hidden = false));
  await settled(second);
  expect((await expectOnePose(page)).radius).toBe(radius);
  expect((await cameraOf(first)).theta).not.toBe(30);
});

test('a viewer that leaves its group moves alone, and takes the camera of the next group it joins', async ({
  page,
  mount,
}) => {
  const first = await mount(pair('theta="10"', ''), size);
  const second = page.locator('phong-viewer').nth(1);
  await assign(second, { cameraGroup: null });
  await assign(second, { theta: 50 });
  expect((await cameraOf(first)).theta).toBe(10);
  await second.evaluate((element) => {
    element.remove();
    element.setAttribute('camera-group', 'a');
    document.body.append(element);
  });
  await settled(second);
  expect((await expectOnePose(page)).theta).toBe(10);
});

test('one auto-rotate turns the whole group, and pauses while any viewer is dragged', async ({
  page,
  mount,
}) => {
  const first = await mount(pair('auto-rotate="30"', 'auto-rotate="-700"'), size);
  const heard = await record(page.locator('phong-viewer').nth(1), 'camera-change');
  await nextFrame(page);
  await expect.poll(async () => (await heard.take()).length).toBeGreaterThan(3);
  await expectOnePose(page);
  const from = (await cameraOf(first)).theta;
  await nextFrame(page);
  // Half a second at most: 30°/s moves less than 90°, −700°/s moves far more, downwards.
  const turned = (((await cameraOf(first)).theta - from + 540) % 360) - 180;
  expect(turned).toBeGreaterThan(0);
  for (const { detail } of await heard.take()) expect(detail).toEqual({ source: 'auto', linked: true });
  await drag(page, [450, 100], [20, 0], { release: false });
  const held = (await expectOnePose(page)).theta;
  await nextFrame(page);
  expect((await expectOnePose(page)).theta).toBe(held);
  await page.mouse.up();
  await expect.poll(async () => (await cameraOf(first)).theta).not.toBe(held);
});

test('groups include viewers in shadow trees, but not in other documents', async ({ page, mount, site }) => {
  const address = site.page(pair('theta="1"', 'theta="2"'), {
    csp: '',
    head: '<script type="module" src="/dist/phong-viewer.standalone.js"></script>',
  });
  const first = await mount(`${pair('theta="10"', '')}<main></main>`, { ...size, csp: '' });
  await page.evaluate(async (src) => {
    const viewer = document.createElement('phong-viewer');
    Object.assign(viewer, { alt: 'In a shadow tree', geometry: 'box', cameraGroup: 'a', theta: 99 });
    document.querySelector('main')?.attachShadow({ mode: 'closed' }).append(viewer);
    Reflect.set(window, 'inner', viewer);
    await viewer.ready;
    const frame = document.createElement('iframe');
    frame.src = src;
    document.body.append(frame);
    await new Promise((resolve) => frame.addEventListener('load', resolve));
  }, address);
  const inner = () => page.evaluate(() => (Reflect.get(window, 'inner') as PhongViewer).camera.theta);
  expect(await inner()).toBe(10);
  const other = page.frameLocator('iframe').locator('phong-viewer').nth(1);
  await settled(other);
  await assign(first, { theta: 20 });
  expect(await inner()).toBe(20);
  expect((await cameraOf(other)).theta).toBe(1);
});

test('a move costs each of 20 linked viewers one event and one frame', async ({ page, mount }) => {
  await mount('<phong-viewer geometry="box" camera-group="a"></phong-viewer>'.repeat(20), {
    width: 60,
    height: 40,
    css: size.css,
  });
  await nextFrame(page);
  const counts = await page.evaluate(async () => {
    const viewers = Array.from(document.querySelectorAll('phong-viewer'));
    const moves: number[] = viewers.map(() => 0);
    viewers.forEach((viewer, i) => viewer.addEventListener('camera-change', () => moves[i]!++));
    const frames = viewers.map((viewer) => viewer.stats.frames);
    for (let step = 1; step <= 10; step++) {
      viewers[7]!.theta = 30 + step;
      viewers[7]!.phi = 70 - step;
      await new Promise((resolve) => requestAnimationFrame(() => setTimeout(resolve)));
    }
    return {
      moves,
      frames: viewers.map((viewer, i) => viewer.stats.frames - frames[i]!),
      thetas: viewers.map((viewer) => viewer.camera.theta),
    };
  });
  expect(counts.moves).toEqual(Array<number>(20).fill(10));
  expect(counts.frames).toEqual(Array<number>(20).fill(10));
  expect(counts.thetas).toEqual(Array<number>(20).fill(40));
});

test('the panel moves all viewers with the source "panel", and undo moves all back', async ({
  page,
  mount,
}) => {
  const first = await mount(pair('gui', ''), { ...size, width: 500, height: 350 });
  const folder = await opened(first, 'Camera');
  const before = JSON.stringify(await expectOnePose(page));
  const heard = await record(page.locator('phong-viewer').nth(1), 'camera-change');
  await slider(folder, 'θ azimuth °').fill('75');
  expect((await expectOnePose(page)).theta).toBe(75);
  const linked = { type: 'camera-change', detail: { source: 'panel', linked: true } };
  expect((await heard.take()).at(-1)).toEqual(linked);
  await page.keyboard.press('Control+z');
  expect(JSON.stringify(await expectOnePose(page))).toBe(before);
  expect((await heard.take()).at(-1)).toEqual(linked);
});

test('the next viewer turns the group once the first is out of view, and nothing happens after both stop', async ({
  page,
  mount,
}) => {
  await countEverything(page);
  const first = await mount(pair('auto-rotate="30"', 'auto-rotate="-30"'), {
    ...size,
    css: `${size.css} [hidden] { display: none !important }`,
  });
  const second = page.locator('phong-viewer').nth(1);
  await first.evaluate((element: PhongViewer) => (element.hidden = true));
  await nextFrame(page);
  const heard = await record(second, 'camera-change');
  await expect.poll(async () => (await heard.take()).at(-1)?.detail).toEqual({ source: 'auto' });
  await expectOnePose(page);
  await first.evaluate((element: PhongViewer) => (element.hidden = false));
  for (const viewer of [first, second]) await assign(viewer, { autoRotate: 0 });
  await allReady(page);
  await nextFrame(page);
  // The description is written a second after the last frame.
  await expect.poll(() => spentIn(page, 300), { timeout: 20_000 }).toEqual(NOTHING);
  await expectOnePose(page);
});
