// Do viewers with the same `camera-group` always have exactly the same camera? Poses are compared
// bit by bit, and events counted.

import type { Page } from '@playwright/test';
import { allReady, expect, test } from '../../support/test.js';
import { countEverything, NOTHING, spentIn } from '../support/counting.js';
import {
  assign,
  cameraOf,
  drag,
  framesOf,
  holdBack,
  nextFrame,
  type PhongViewer,
  record,
  settled,
} from '../support/viewer.js';

/** Two viewers of 300 × 200 side by side. */
const pair = (first: string, second: string) =>
  [first, second]
    .map(
      (attributes) => `<phong-viewer geometry="box" camera-group="a" ${attributes}></phong-viewer>`,
    )
    .join('');

const css = 'phong-viewer { display: inline-block } [hidden] { display: none !important }';
const size = { width: 300, height: 200, css } as const;

/**
 * Angles and radius of all viewers, which are equal, and the target. Shadow trees are not included.
 */
async function onePose(page: Page): Promise<{ theta: number; phi: number; radius: number }> {
  const poses = await page.evaluate(() =>
    Array.from(document.querySelectorAll('phong-viewer'), ({ camera }) => {
      const { theta, phi, radius, target } = camera;
      return { theta, phi, radius, target };
    }),
  );
  for (const pose of poses) {
    expect(pose).toStrictEqual(poses[0]);
  }
  return poses[0]!;
}

test('the first picture, drawn once, has the first viewer’s camera, however late the code', async ({
  page,
  mount,
}) => {
  const send = await holdBack(page, /\/camera-group\./);
  await mount(pair('theta="10" radius="5"', 'theta="80" phi="20"'), {
    ...size,
    waitForReady: false,
  });
  const frames = () =>
    page.evaluate(() =>
      [...document.querySelectorAll('phong-viewer')].map(({ stats }) => stats.frames),
    );
  for (let i = 0; i < 3; i++) {
    await nextFrame(page);
  }
  expect(await frames()).toEqual([0, 0]);
  send();
  await allReady(page);
  expect(await frames()).toEqual([1, 1]);
  expect(await onePose(page)).toMatchObject({ theta: 10, phi: 70, radius: 5 });
});

test('drag, wheel, keys and properties move all viewers, with one event and frame each', async ({
  page,
  mount,
}) => {
  const first = await mount(pair('', ''), size);
  const second = page.locator('phong-viewer').nth(1);
  const heard = [
    await record(first, 'camera-change'),
    await record(second, 'camera-change'),
  ] as const;
  const drawn = () => framesOf(first);
  const deeds: readonly (readonly [source: string, deed: () => Promise<unknown>])[] = [
    ['pointer', () => drag(page, [450, 100], [33, 17], { steps: 1 })],
    ['wheel', () => page.mouse.wheel(0, 70)],
    ['key', () => page.keyboard.press('ArrowLeft')],
    ['key', () => page.keyboard.press('Home')],
    ['script', () => assign(second, { theta: 12.345, phi: 50, target: [0.1, 0.2, 0.3] })],
    ['key', () => page.keyboard.press('ArrowUp')],
    ['script', () => second.evaluate((element: PhongViewer) => element.resetCamera())],
  ];
  let before = await onePose(page);
  for (const [source, deed] of deeds) {
    const frames = await drawn();
    await deed();
    await nextFrame(page);
    const after = await onePose(page);
    expect(after, source).not.toEqual(before);
    before = after;
    expect(await heard[1].take()).toEqual([{ type: 'camera-change', detail: { source } }]);
    expect(await heard[0].take()).toEqual([
      { type: 'camera-change', detail: { source, linked: true } },
    ]);
    expect(await drawn(), source).toBe(frames + 1);
  }
});

test('auto fits the largest scene of the group, also when members come, go and change', async ({
  page,
  mount,
}) => {
  const small = await mount(
    `${pair('', '')}<phong-viewer camera-group="a"><phong-mesh geometry="box" scale="3" position="1 0 0"></phong-mesh></phong-viewer>`,
    size,
  );
  const alone = (await cameraOf(small)).radius / 3;
  expect((await cameraOf(small)).target).toEqual([1, 0, 0]);
  await onePose(page);
  await page.evaluate(() => document.querySelector('phong-viewer:last-of-type')!.remove());
  await nextFrame(page);
  expect((await onePose(page)).radius).toBeCloseTo(alone, 9);
  // A member that is not displayed counts, and has the right camera when it comes back.
  const second = page.locator('phong-viewer').nth(1);
  await assign(second, { hidden: true, fov: 20 });
  await nextFrame(page);
  const narrow = (await onePose(page)).radius;
  expect(narrow).toBeGreaterThan(2 * alone);
  await drag(page, [100, 100], [33, 17]);
  await assign(second, { hidden: false });
  await settled(second);
  const back = await onePose(page);
  // A drag leaves the camera at the digits that markup has.
  expect(back.radius).toBeCloseTo(narrow, 6);
  expect(back.theta).not.toBe(30);
  // Empty scenes do not count.
  await small.evaluate((element) => element.resetCamera());
  await page.evaluate(() => {
    const empty = document.createElement('phong-viewer');
    document.body.append(Object.assign(empty, { cameraGroup: 'a', alt: 'Nothing' }));
    return empty.ready;
  });
  await nextFrame(page);
  expect((await onePose(page)).radius).toBe(narrow);
});

test('a viewer that leaves its group moves alone, and takes the camera of the next one', async ({
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
  expect((await onePose(page)).theta).toBe(10);
});

test('groups include viewers in shadow trees, but not in other documents', async ({
  page,
  mount,
  site,
}) => {
  const address = site.page(pair('theta="1"', 'theta="2"'), {
    csp: '',
    head: '<script type="module" src="/dist/phong-viewer.standalone.js"></script>',
  });
  const first = await mount(`${pair('theta="10"', '')}<main></main>`, { ...size, csp: '' });
  await page.evaluate(async (src) => {
    const viewer = document.createElement('phong-viewer');
    Object.assign(viewer, {
      alt: 'In a shadow tree',
      geometry: 'box',
      cameraGroup: 'a',
      theta: 99,
    });
    document.querySelector('main')?.attachShadow({ mode: 'closed' }).append(viewer);
    Reflect.set(window, 'inner', viewer);
    await viewer.ready;
    const frame = document.createElement('iframe');
    frame.src = src;
    document.body.append(frame);
    await new Promise((resolve) => frame.addEventListener('load', resolve));
  }, address);
  const inner = () =>
    page.evaluate(() => (Reflect.get(window, 'inner') as PhongViewer).camera.theta);
  expect(await inner()).toBe(10);
  const other = page.frameLocator('iframe').locator('phong-viewer').nth(1);
  await settled(other);
  await assign(first, { theta: 20 });
  expect(await inner()).toBe(20);
  expect((await cameraOf(other)).theta).toBe(1);
});

test('auto-rotate turns the group, pauses during drags, and passes to the next in view', async ({
  page,
  mount,
}) => {
  await countEverything(page);
  const first = await mount(pair('auto-rotate="30"', 'auto-rotate="-700"'), size);
  const second = page.locator('phong-viewer').nth(1);
  const heard = await record(second, 'camera-change');
  await nextFrame(page);
  await expect.poll(async () => (await heard.take()).length).toBeGreaterThan(3);
  const from = (await onePose(page)).theta;
  await nextFrame(page);
  // Half a second at most: 30°/s moves less than 90°, −700°/s moves far more, downwards.
  const turned = (((await cameraOf(first)).theta - from + 540) % 360) - 180;
  expect(turned).toBeGreaterThan(0);
  for (const { detail } of await heard.take()) {
    expect(detail).toEqual({ source: 'auto', linked: true });
  }
  await drag(page, [450, 100], [20, 0], { release: false });
  const held = (await onePose(page)).theta;
  await nextFrame(page);
  expect((await onePose(page)).theta).toBe(held);
  await page.mouse.up();
  await expect.poll(async () => (await cameraOf(first)).theta).not.toBe(held);

  await assign(first, { hidden: true });
  await nextFrame(page);
  await heard.take();
  await expect.poll(async () => (await heard.take()).at(-1)?.detail).toEqual({ source: 'auto' });
  await onePose(page);
  await assign(first, { hidden: false });
  for (const viewer of [first, second]) {
    await assign(viewer, { autoRotate: 0 });
  }
  await allReady(page);
  await nextFrame(page);
  // The description is written a second after the last frame.
  await expect.poll(() => spentIn(page, 300), { timeout: 20_000 }).toEqual(NOTHING);
  await onePose(page);
});
