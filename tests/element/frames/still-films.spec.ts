// `antialias="full"`: what does a page show, frame by frame, while pictures converge? Canvases keep their pixels here,
// so that each frame can be read.

import type { Locator, Page } from '@playwright/test';
import { allReady, expect, test } from '../../support/test.js';
import { countEverything, countsOf, NOTHING, spentIn } from '../support/counting.js';
import { assign, nextFrame, type PhongViewer } from '../support/viewer.js';

const size = { width: 64, height: 48 };
const light = '<phong-light position="1 2 3 0" ambient="40"></phong-light>';
const viewerOf = (samples: number, attributes = 'geometry="torus"'): string =>
  `<phong-viewer alt="A shape" antialias="full" samples="${String(samples)}" ${attributes}>${light}</phong-viewer>`;

/** A frame of a viewer as the page shows it. Colours are codes, premultiplied. */
interface Frame {
  readonly samples: number;
  /** Of each channel over the picture. */
  readonly mean: readonly number[];
  /** Pixels that differ by more than three codes from the first frame, inside surfaces and in outlines. */
  readonly inside: number;
  readonly outlines: number;
}

/** Reads the viewer's canvas after each animation frame, until `stop`. The first frame is the one that is shown now. */
async function film(viewer: Locator): Promise<{ stop(): Promise<readonly Frame[]> }> {
  const filmed = await viewer.evaluateHandle((element: PhongViewer) => {
    const frames: Frame[] = [];
    const copy = new OffscreenCanvas(1, 1).getContext('2d', { willReadFrequently: true })!;
    let first: Uint8ClampedArray | null = null;
    let running = true;
    const outline = (data: Uint8ClampedArray, width: number, pixel: number): boolean => {
      const beside = [0, -1, 1, -width, width].map((by) => 4 * (pixel + by));
      return [0, 1, 2, 3].some((channel) => {
        const codes = beside.map((at) => data[at + channel] ?? 0);
        return Math.max(...codes) - Math.min(...codes) > 24;
      });
    };
    const read = (): void => {
      if (!running) return;
      const canvas = element.shadowRoot!.querySelector('canvas')!;
      const { width, height } = canvas;
      Object.assign(copy.canvas, { width, height });
      copy.drawImage(canvas, 0, 0);
      const { data } = copy.getImageData(0, 0, width, height);
      for (let i = 0; i < data.length; i++) if (i % 4 !== 3) data[i]! *= data[i - (i % 4) + 3]! / 255;
      if (first?.length !== data.length) first = data;
      const mean = [0, 0, 0, 0];
      data.forEach((code, i) => (mean[i % 4]! += (4 * code) / data.length));
      const found = { inside: 0, outlines: 0 };
      for (let pixel = 0; pixel < width * height; pixel++) {
        const differs = [0, 1, 2, 3].some((k) => Math.abs(data[4 * pixel + k]! - first![4 * pixel + k]!) > 3);
        if (differs) found[outline(first, width, pixel) ? 'outlines' : 'inside'] += 1;
      }
      frames.push({ samples: element.stats.samples, mean, ...found });
    };
    // Once the page has been shown.
    const { port1, port2 } = new MessageChannel();
    port1.onmessage = read;
    const next = (): void => {
      if (!running) return;
      port2.postMessage(null);
      requestAnimationFrame(next);
    };
    read();
    requestAnimationFrame(next);
    return { frames, stop: () => (running = false) };
  });
  return {
    stop: () =>
      filmed.evaluate(({ frames, stop }) => {
        stop();
        return frames;
      }),
  };
}

/** WebGL canvases keep their pixels after a frame. */
const keepPixels = (page: Page): Promise<unknown> =>
  page.addInitScript(() => {
    const real = HTMLCanvasElement.prototype.getContext as (this: unknown, ...given: unknown[]) => unknown;
    HTMLCanvasElement.prototype.getContext = function (this: unknown, kind: string, options?: object) {
      return real.call(this, kind, kind === 'webgl2' ? { ...options, preserveDrawingBuffer: true } : options);
    } as typeof HTMLCanvasElement.prototype.getContext;
  });

test('a picture keeps its brightness while it converges, changes in outlines only, and never flashes', async ({
  page,
  mount,
}) => {
  await keepPixels(page);
  for (const [what, other] of [
    ['alone', ''],
    ['beside another', viewerOf(16)],
  ] as const) {
    // prettier-ignore
    const viewer = await mount(viewerOf(256) + other, { ...size, waitForReady: false });
    await expect
      .poll(() => viewer.evaluate((element: PhongViewer) => element.stats.frames))
      .toBeGreaterThan(0);
    await assign(viewer, { theta: 40 });
    await nextFrame(page);
    const rolling = await film(viewer);
    await allReady(page);
    await nextFrame(page);
    const frames = await rolling.stop();
    const [plain] = frames;
    expect(plain!.samples, what).toBe(0);
    expect(frames.at(-1)!.samples, what).toBe(256);
    expect(new Set(frames.map(({ samples }) => samples)).size, `${what}: pictures shown`).toBeGreaterThan(2);
    for (const [i, { samples, mean, inside }] of frames.entries()) {
      const which = `${what}, frame ${String(i)} with ${String(samples)} samples`;
      mean.forEach((code, channel) => {
        expect(Math.abs(code - plain!.mean[channel]!), which).toBeLessThan(0.5);
      });
      expect(inside, which).toBe(0);
    }
  }
});

test('whatever happens in the middle, each frame is a whole picture, and it converges afterwards', async ({
  page,
  mount,
}) => {
  await keepPixels(page);
  await countEverything(page);
  const viewer = await mount(viewerOf(512, 'geometry="sphere"'), { ...size, waitForReady: false });
  const samples = (): Promise<number> => viewer.evaluate((element: PhongViewer) => element.stats.samples);
  const begins = (): Promise<void> => expect.poll(samples, { timeout: 20_000 }).toBeGreaterThan(0);
  const hide = (hidden: boolean): Promise<void> =>
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
      page.evaluate((markup) => {
        document.body.insertAdjacentHTML('beforeend', markup);
      }, viewerOf(16)),
    'its removal': () => page.evaluate(() => document.querySelector('body > phong-viewer')!.remove()),
    'a hidden page': async () => {
      await hide(true);
      await nextFrame(page);
      await viewer.evaluate((element: PhongViewer) => element.ready);
      const { frames, ...spent } = await spentIn(page, 200);
      expect({ ...spent, frames: 0 }, `${String(frames)} frames are the film's own`).toEqual(NOTHING);
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
    for (const [i, { mean }] of frames.entries())
      expect(Math.abs(mean[3]! / whole - 1), `${what}, frame ${String(i)}`).toBeLessThan(0.05);
    await assign(viewer, { samples: 511 });
    await expect.poll(samples).toBe(0);
    await assign(viewer, { samples: 512 });
  }
  await assign(viewer, { samples: 16 });
  await viewer.evaluate((element: PhongViewer) => element.ready);
  expect(await samples()).toBe(16);
  await nextFrame(page);
  expect(await spentIn(page, 200)).toEqual(NOTHING);
});

test('samples trigger nothing but themselves: no frame, program, description, overlay or third `render`', async ({
  mount,
}) => {
  const viewer = await mount(
    viewerOf(64, 'geometry="box" helpers="lights axes" probe probe-at="0 0 0.5"'),
    size,
  );
  const seen = (antialias: string) =>
    viewer.evaluate(async (element: PhongViewer, mode) => {
      const wait = (ms: number): Promise<unknown> => new Promise((resolve) => setTimeout(resolve, ms));
      element.setAttribute('antialias', mode);
      element.theta = 30;
      await element.ready;
      await wait(1100); // a description comes at most once a second
      const before = element.stats;
      const changed: string[] = [];
      const watch = new MutationObserver((records) => {
        for (const { target, attributeName } of records)
          changed.push(`${target.nodeName} ${String(attributeName)}`);
      });
      let renders = 0;
      const count = (): unknown => (renders += 1);
      element.addEventListener('render', count);
      watch.observe(element.shadowRoot!, {
        ...{ childList: true, attributes: true, characterData: true, subtree: true },
      });
      element.theta = 44;
      await element.ready;
      await wait(1100); // a description comes at most once a second
      watch.disconnect();
      element.removeEventListener('render', count);
      const { frames, programs, samples } = element.stats;
      return { renders, changed, samples, frames: frames - before.frames, programs: programs - before.programs }; // prettier-ignore
    }, antialias);
  const edges = await seen('edges');
  expect(edges.changed.length).toBeGreaterThan(0);
  const full = await seen('full');
  expect(full).toEqual({ ...edges, samples: 64, renders: edges.renders + 1 });
});

test('six viewers converge in one context, and leave no buffers and nothing running', async ({
  page,
  mount,
}) => {
  await countEverything(page);
  const kinds = ['box', 'sphere', 'cone', 'cylinder', 'plane', 'pyramid'];
  await mount(kinds.map((kind) => viewerOf(16, `geometry="${kind}"`)).join(''), size);
  const samples = await page.evaluate(() =>
    [...document.querySelectorAll<PhongViewer>('phong-viewer')].map(({ stats }) => stats.samples),
  );
  expect(samples).toEqual(kinds.map(() => 16));
  await nextFrame(page);
  expect(await spentIn(page, 200)).toEqual(NOTHING);
  const held = await countsOf(page);
  expect(held.contexts).toBe(1);
  for (const theta of [40, 50]) {
    await page.evaluate((angle) => {
      for (const viewer of document.querySelectorAll<PhongViewer>('phong-viewer')) viewer.theta = angle;
    }, theta);
    await allReady(page);
  }
  await nextFrame(page);
  const { textures, framebuffers, renderbuffers } = await countsOf(page);
  expect({ textures, framebuffers, renderbuffers }).toEqual({
    textures: held.textures,
    framebuffers: held.framebuffers,
    renderbuffers: held.renderbuffers,
  });
});

test('on a slow machine a drag shows the plain picture in its next frame, after no further batch', async ({
  page,
  mount,
}) => {
  await page.addInitScript(() => {
    const log: string[] = [];
    Object.assign(window, { log });
    const { prototype } = WebGL2RenderingContext;
    // Each batch ends with one.
    const real = prototype.fenceSync;
    prototype.fenceSync = function (this: WebGL2RenderingContext, ...given) {
      log.push('batch');
      return real.apply(this, given);
    };
    addEventListener('pointermove', ({ buttons }) => buttons > 0 && log.push('move'), true);
  });
  const viewer = await mount(viewerOf(1024, 'geometry="torus"'), { ...size, waitForReady: false });
  const session = await page.context().newCDPSession(page);
  await session.send('Emulation.setCPUThrottlingRate', { rate: 6 });
  try {
    const log = await viewer.evaluateHandle((element) => {
      const { log: list } = window as unknown as { log: string[] };
      element.addEventListener('render', () => list.push('render'));
      return list;
    });
    const batches = (): Promise<number> =>
      log.evaluate((list) => list.filter((one) => one === 'batch').length);
    await page.mouse.move(20, 20);
    await page.mouse.down();
    for (let i = 1; i <= 6; i++) {
      const before = await batches();
      await expect.poll(batches, { timeout: 20_000 }).toBeGreaterThan(before + 1);
      await page.mouse.move(20 + 4 * i, 20);
    }
    await page.mouse.up();
    await nextFrame(page);
    const said = (await log.jsonValue()).join(' ');
    expect(said.match(/move/g)!.length).toBeGreaterThanOrEqual(6);
    expect(said, 'between a move and its frame').not.toMatch(/move (move )*batch/);
  } finally {
    await session.send('Emulation.setCPUThrottlingRate', { rate: 1 });
    await session.detach();
  }
});
