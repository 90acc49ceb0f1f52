// `antialias="full"`: what does a page show, frame by frame, while pictures converge? Canvases keep
// their pixels here, so that each frame can be read.

import { allReady, expect, test } from '../../support/test.js';
import { countEverything, NOTHING, spentIn, expectIdle } from '../support/counting.js';
import { film, keepPixels, viewerOf } from '../support/film.js';
import { assign, framesOf, nextFrame, samplesOf, set, settled } from '../support/viewer.js';

const size = { width: 64, height: 48 };

test('a converging picture keeps its brightness, changes in outlines only, never flashes', async ({
  page,
  mount,
}) => {
  await keepPixels(page);
  for (const [what, other] of [
    ['alone', ''],
    ['beside another', viewerOf(16)],
  ] as const) {
    const viewer = await mount(viewerOf(64) + other, { ...size, waitForReady: false });
    await expect.poll(() => framesOf(viewer)).toBeGreaterThan(0);
    const rolling = await film(viewer, 40);
    await allReady(page);
    await nextFrame(page);
    const frames = await rolling.stop();
    const [plain] = frames;
    expect(plain!.samples, what).toBe(0);
    expect(frames.at(-1)!.samples, what).toBe(64);
    expect(
      new Set(frames.map(({ samples }) => samples)).size,
      `${what}: pictures shown`,
    ).toBeGreaterThan(2);
    for (const [i, { samples, mean, inside }] of frames.entries()) {
      const which = `${what}, frame ${String(i)} with ${String(samples)} samples`;
      mean.forEach((code, channel) =>
        expect(Math.abs(code - plain!.mean[channel]!), which).toBeLessThan(0.5),
      );
      expect(inside, which).toBe(0);
    }
  }
});

test('whatever happens, each frame is a whole picture, and it converges afterwards', async ({
  page,
  mount,
}) => {
  await keepPixels(page);
  await countEverything(page);
  const viewer = await mount(viewerOf(512, 'geometry="sphere"'), { ...size, waitForReady: false });
  const samples = () => samplesOf(viewer);
  const begins = () => expect.poll(samples, { timeout: 20_000 }).toBeGreaterThan(0);
  const hide = (hidden: boolean) =>
    page.evaluate((isHidden) => {
      const visibilityState = isHidden ? 'hidden' : 'visible';
      Object.defineProperties(document, {
        visibilityState: { value: visibilityState, configurable: true },
        hidden: { value: isHidden, configurable: true },
      });
      document.dispatchEvent(new Event('visibilitychange'));
    }, hidden);
  const deeds: Readonly<Record<string, () => Promise<unknown>>> = {
    'a change': () => assign(viewer, { theta: 50 }),
    'a new size': () => viewer.evaluate((element) => (element.style.width = '62px')),
    'a move': () =>
      viewer.evaluate((element) => {
        const section = document.createElement('section');
        element.before(section);
        section.append(element);
      }),
    'another viewer': () =>
      page.evaluate(
        (markup) => document.body.insertAdjacentHTML('beforeend', markup),
        viewerOf(16),
      ),
    'its removal': () =>
      page.evaluate(() => document.querySelector('body > phong-viewer')!.remove()),
    'a hidden page': async () => {
      await hide(true);
      await nextFrame(page);
      await settled(viewer);
      const { frames, ...spent } = await spentIn(page, 200);
      expect({ ...spent, frames: 0 }, `${String(frames)} frames are the film's own`).toEqual(
        NOTHING,
      );
      await hide(false);
    },
  };
  for (const [what, act] of Object.entries(deeds)) {
    await begins();
    const rolling = await film(viewer);
    await act();
    await begins();
    const frames = await rolling.stop();
    const whole = frames[0]!.mean[3]!;
    // Another width shows another part of the background.
    for (const [i, { mean }] of frames.entries()) {
      expect(Math.abs(mean[3]! / whole - 1), `${what}, frame ${String(i)}`).toBeLessThan(0.05);
    }
    // Each begins again.
    await assign(viewer, { samples: 1023 });
    await assign(viewer, { samples: 1024 });
  }
  await set(viewer, { samples: 16 });
  expect(await samples()).toBe(16);
  await nextFrame(page);
  await expectIdle(page, 200);
});

test('samples trigger nothing else: no frame, program, description, overlay or third `render`', async ({
  mount,
}) => {
  const viewer = await mount(
    viewerOf(64, 'geometry="box" helpers="lights axes" probe probe-at="0 0 0.5"'),
    size,
  );
  const seen = (antialias: string) =>
    viewer.evaluate(async (element, mode) => {
      const wait = (ms: number) => new Promise((resolve) => setTimeout(resolve, ms));
      element.setAttribute('antialias', mode);
      element.theta = 30;
      await element.ready;
      await wait(1100); // a description comes at most once a second
      const before = element.stats;
      const changed: string[] = [];
      const watch = new MutationObserver((records) => {
        for (const { target, attributeName } of records) {
          changed.push(`${target.nodeName} ${String(attributeName)}`);
        }
      });
      let renders = 0;
      const count = (): unknown => (renders += 1);
      element.addEventListener('render', count);
      watch.observe(element.shadowRoot!, {
        childList: true,
        attributes: true,
        characterData: true,
        subtree: true,
      });
      element.theta = 44;
      await element.ready;
      await wait(1100); // a description comes at most once a second
      watch.disconnect();
      element.removeEventListener('render', count);
      const { frames, programs, samples } = element.stats;
      return {
        renders,
        changed,
        samples,
        frames: frames - before.frames,
        programs: programs - before.programs,
      };
    }, antialias);
  const edges = await seen('edges');
  expect(edges.changed.length).toBeGreaterThan(0);
  const full = await seen('full');
  expect(full).toEqual({ ...edges, samples: 64, renders: edges.renders + 1 });
});

test('on a slow machine inputs show the plain picture at once, and samples resume after', async ({
  page,
  mount,
}) => {
  await page.addInitScript(() => {
    const log: string[] = [];
    Object.assign(window, { log });
    const { prototype } = WebGL2RenderingContext;
    type Call = (this: unknown, ...given: unknown[]) => unknown;
    const wrap = (name: 'fenceSync' | 'deleteSync' | 'drawElements', before: () => void) => {
      const real = prototype[name] as Call;
      Reflect.set(prototype, name, function (this: unknown, ...given: unknown[]) {
        before();
        return real.apply(this, given);
      });
    };
    let drawn = 0;
    wrap('drawElements', () => (drawn += 1)); // the shape: once for four samples
    // Each batch ends with one.
    wrap('fenceSync', () => {
      log.push(`batch of ${String(drawn)}`);
      drawn = 0;
    });
    wrap('deleteSync', () => log.push('ended'));
    addEventListener('pointermove', ({ buttons }) => buttons > 0 && log.push('input'), true);
    for (const type of ['wheel', 'keydown']) {
      addEventListener(type, () => log.push('input'), true);
    }
    addEventListener('render', () => log.push('render'), true);
    const frame = () => {
      drawn = 0;
      requestAnimationFrame(frame);
    };
    requestAnimationFrame(frame); // before the package's own
  });
  const viewer = await mount(viewerOf(256, 'geometry="torus" pixel-ratio="1"'), {
    ...size,
    waitForReady: false,
  });
  const session = await page.context().newCDPSession(page);
  await session.send('Emulation.setCPUThrottlingRate', { rate: 6 });
  try {
    const log = await page.evaluateHandle(() => (window as unknown as { log: string[] }).log);
    const batches = () =>
      log.evaluate((list) => list.filter((one) => one.startsWith('batch')).length);
    await page.mouse.move(20, 20);
    await page.mouse.down();
    const inputs = [
      ...[1, 2, 3, 4].map((i) => () => page.mouse.move(20 + 4 * i, 20)),
      () => page.mouse.up().then(() => page.mouse.wheel(0, 20)),
      () => page.keyboard.press('ArrowLeft'),
    ];
    for (const act of inputs) {
      const before = await batches();
      await expect.poll(batches, { timeout: 20_000 }).toBeGreaterThan(before + 1);
      await act();
    }
    await expect
      .poll(() => log.evaluate((list) => list.filter((one) => one === 'input').length))
      .toBe(6);
    await settled(viewer);
    const said = (await log.jsonValue()).join(' ');
    expect(said, 'between an input and its frame').not.toMatch(/input (ended )?(input )*batch/);
    expect(said, 'one batch at a time').not.toMatch(/batch of \d+ (render )?batch/);
    for (const [first] of said.matchAll(/(?<=input[^b]*)batch of \d+/g)) {
      expect(first, 'after an input').toBe('batch of 1');
    }
    const rest = said.slice(said.lastIndexOf('input'));
    const samples = [...rest.matchAll(/batch of (\d+)/g)].reduce(
      (sum, [, count]) => sum + Number(count),
      0,
    );
    expect(samples, 'after the last input').toBe(64);
    expect(rest.match(/render/g), 'plain and converged').toHaveLength(2);
  } finally {
    await session.send('Emulation.setCPUThrottlingRate', { rate: 1 });
    await session.detach();
  }
});

test('where one sample takes seconds, the plain picture stays, and a quicker one converges', async ({
  page,
  mount,
}) => {
  await page.addInitScript(() => {
    const gpu = { isBusy: true, seen: 0, drawn: 0 };
    const { now } = performance;
    Object.assign(window, { gpu });
    const { prototype } = WebGL2RenderingContext;
    const { getSyncParameter, fenceSync } = prototype;
    prototype.fenceSync = function (...given) {
      gpu.drawn += 1;
      return fenceSync.apply(this, given);
    };
    // It is seen running for ten seconds of this clock.
    prototype.getSyncParameter = function (...given) {
      if (!gpu.isBusy || gpu.seen === 20) return getSyncParameter.apply(this, given) as unknown;
      gpu.seen += 1;
      return this.UNSIGNALED;
    };
    performance.now = () => now.call(performance) + 500 * gpu.seen;
  });
  const viewer = await mount(viewerOf(64, 'pixel-ratio="1"'), size);
  expect(await samplesOf(viewer)).toBe(0);
  const gpu = await page.evaluateHandle(
    () => Reflect.get(window, 'gpu') as Record<string, unknown>,
  );
  expect(await gpu.jsonValue(), 'one batch of one sample').toMatchObject({ drawn: 1 });
  await gpu.evaluate((it) => (it['isBusy'] = false));
  await set(viewer, { theta: 40 });
  expect(await samplesOf(viewer)).toBe(64);
});
