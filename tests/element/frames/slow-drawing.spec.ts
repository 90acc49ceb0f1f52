// Does a picture that moves have fewer pixels where drawing is slow, and only there? Counts pixels.
// The page's clock and the GPU are models: a GPU that queues what it is sent, as browsers do, while
// frames come at an interval of their own. So no machine is too slow or too fast.

import { type ViewerLocator, expect, pixels, test } from '../../support/test.js';
import { statsOf, assign } from '../support/viewer.js';

const size = { width: 300, height: 200 };
const viewerOf = (attributes = '') =>
  `<phong-viewer geometry="box" alt="A box" ${attributes}><phong-light></phong-light></phong-viewer>`;

/** Milliseconds. */
interface Costs {
  /** Of a picture with all pixels. */
  readonly drawing: number;
  /** Of a picture, besides: what no pixels save. */
  readonly vertices?: number;
  /** Between two frames. */
  readonly interval: number;
  /** The page's thread waits for the GPU after each picture, as without GPU compositing. */
  readonly blocks?: boolean;
}

test.beforeEach(async ({ page }) => {
  await page.addInitScript((whole) => {
    const held = Object.assign(window, {
      costs: { drawing: 0, vertices: 0, interval: 16, blocks: false },
    });
    let now = 0;
    performance.now = () => now;
    const gl = WebGL2RenderingContext.prototype;
    let drawn = 0;
    let pixels = whole;
    const { drawElements, viewport } = gl;
    gl.viewport = function (...args) {
      pixels = args[2] * args[3];
      viewport.apply(this, args);
    };
    gl.drawElements = function (...args) {
      const { drawing, vertices } = held.costs;
      drawn = Math.max(drawn, now) + (drawing * pixels) / whole + vertices;
      drawElements.apply(this, args);
    };
    const { fenceSync } = gl;
    let end = 0; // of the fence: there is one at most
    gl.fenceSync = function (...args) {
      end = drawn;
      return fenceSync.apply(this, args);
    };
    let inFrame = false;
    let isAsked = false; // then time passes by questions, not by frames
    gl.clientWaitSync = function () {
      isAsked = !inFrame && end > now;
      now += isAsked ? 2 : 0;
      return end > now || isAsked ? this.TIMEOUT_EXPIRED : this.CONDITION_SATISFIED;
    };
    // The page waits for the GPU, which it may only where the browser does.
    const block = () => {
      now = held.costs.blocks ? Math.max(now, drawn) : now;
    };
    gl.readPixels = () => {
      if (!held.costs.blocks) throw new Error('the page waits');
      block();
    };
    const { drawImage } = CanvasRenderingContext2D.prototype;
    CanvasRenderingContext2D.prototype.drawImage = function (...args: unknown[]) {
      block(); // so does a copy of the picture
      (drawImage as (...all: unknown[]) => void).apply(this, args);
    };
    const later = window.setTimeout.bind(window);
    window.setTimeout = ((run: () => void, ms?: number) =>
      later(() => {
        block();
        run();
      }, ms)) as typeof setTimeout;
    const request = window.requestAnimationFrame.bind(window);
    window.requestAnimationFrame = (run) =>
      request(() => {
        block();
        now += isAsked ? 0 : held.costs.interval;
        inFrame = true;
        run(now);
        inFrame = false;
      });
  }, size.width * size.height);
});

const setCosts = (viewer: ViewerLocator, costs: Costs) =>
  viewer.evaluate((_, given) => {
    Object.assign(window, { costs: { vertices: 0, blocks: false, ...given } });
  }, costs);

/** Turns for so many pictures, gives the canvas's widths, and waits until it has all pixels again. */
async function turn(viewer: ViewerLocator, pictures: number, costs: Costs) {
  await setCosts(viewer, costs);
  return viewer.evaluate(async (element, count) => {
    const canvas = () => element.shadowRoot!.querySelector('canvas')!;
    const next = (): Promise<number> =>
      new Promise((resolve) =>
        element.addEventListener('render', () => resolve(canvas().width), { once: true }),
      );
    element.autoRotate = 45;
    const moving: number[] = [];
    while (moving.length < count) {
      moving.push(await next());
    }
    element.autoRotate = 0;
    do {
      await new Promise(requestAnimationFrame);
    } while (canvas().width < 300);
    return moving;
  }, pictures);
}

for (const [viewers, interval, blocks] of [
  [1, 60, false],
  [2, 33, false],
  [1, 16, false],
  [1, 16, true],
  [2, 16, true],
] as const) {
  const where = blocks ? 'without GPU compositing' : `with a frame in ${interval} ms`;
  test(`a slow picture has a ninth of the pixels from the fourth of a motion on, and all when it is still: ${viewers} on a page ${where}`, async ({
    mount,
  }) => {
    const viewer = await mount(viewerOf().repeat(viewers), size);
    const moving = await turn(viewer, 8, { drawing: blocks ? 3000 : 200, interval, blocks });
    expect(moving.slice(3)).toEqual(Array<number>(5).fill(100));
    expect((await statsOf(viewer)).reducedFrames).toBeGreaterThanOrEqual(5);
    expect(await viewer.locator('canvas').boundingBox()).toMatchObject(size);
  });
}

for (const [drawing, width] of [
  [36, 200],
  [68, 150],
] as const) {
  test(`a picture that takes ${drawing} ms to draw has ${width} of 300 pixels a side, until drawing is quick again`, async ({
    mount,
  }) => {
    const viewer = await mount(viewerOf(), size);
    const slow = await turn(viewer, 6, { drawing, interval: 60 });
    const quick = await turn(viewer, 99, { drawing: 0, interval: 16 });
    expect([slow.at(-1), quick.at(-1)]).toEqual([width, 300]);
  });
}

test('quick drawing has all pixels at 60 frames a second and in late frames, and slow drawing where `pixel-ratio` is written', async ({
  mount,
}) => {
  const viewer = await mount(viewerOf(), size);
  await turn(viewer, 30, { drawing: 14, interval: 16 });
  await turn(viewer, 6, { drawing: 14, interval: 80 });
  expect((await statsOf(viewer)).reducedFrames).toBe(0);
  await assign(viewer, { pixelRatio: 1 });
  await turn(viewer, 50, { drawing: 200, interval: 60 }); // it counts as quick for two seconds
  expect((await statsOf(viewer)).reducedFrames).toBe(0);
});

test('a picture whose canvas another viewer takes waits for no drawing', async ({ mount }) => {
  const viewer = await mount(viewerOf(), size);
  await setCosts(viewer, { drawing: 200, interval: 60 });
  const [waiting, then, drawn] = await viewer.evaluate(async (element, markup) => {
    const next = async () => {
      for (let i = 0; i < 9; i++) {
        await new Promise(requestAnimationFrame);
      }
      return element.stats.frames;
    };
    WebGL2RenderingContext.prototype.clientWaitSync = () => 0x911b; // not drawn yet
    element.autoRotate = 45;
    const waits = [await next(), await next()];
    element.insertAdjacentHTML('afterend', markup);
    return [...waits, await next()];
  }, viewerOf());
  expect([then, drawn]).toEqual([waiting, waiting! + 1]);
});

test('a slow drag has fewer pixels too, as the wait for its pictures is no rest', async ({
  mount,
}) => {
  const viewer = await mount(viewerOf(), size);
  await setCosts(viewer, { drawing: 400, interval: 16, blocks: true });
  const widths = await viewer.evaluate(async (element) => {
    const canvas = element.shadowRoot!.querySelector('canvas')!;
    const seen: number[] = [];
    element.addEventListener('render', () => seen.push(canvas.width));
    for (let frame = 0; seen.length < 9; frame++) {
      element.theta = element.theta + Number(frame % 6 === 0);
      await new Promise(requestAnimationFrame);
    }
    return seen;
  });
  expect(widths.slice(4)).toEqual(Array<number>(5).fill(100));
});

test('where vertices take the time, the pixels come back', async ({ mount }) => {
  const viewer = await mount(viewerOf(), size);
  const moving = await turn(viewer, 20, { drawing: 5, vertices: 150, interval: 60 });
  expect(moving).toContain(100);
  expect(moving.slice(-10)).toEqual(Array<number>(10).fill(300));
});

test('files, `ready` and `shadeAt` know whole pictures only, even of a viewer that never stops', async ({
  mount,
}) => {
  const viewer = await mount(viewerOf(), size);
  await setCosts(viewer, { drawing: 200, interval: 60 });
  const seen = await viewer.evaluate(async (element) => {
    const canvas = element.shadowRoot!.querySelector('canvas')!;
    element.autoRotate = 45;
    while (canvas.width === 300) {
      await new Promise(requestAnimationFrame);
    }
    const middle = await element.shadeAt(150, 100);
    await element.ready;
    return { width: canvas.width, hit: middle !== null };
  });
  expect(seen).toEqual({ width: 300, hit: true });
  expect(await pixels(viewer)).toMatchObject(size);
});

test('a ball that moves with fewer pixels has fewer triangles, but not in files, and all when it is still', async ({
  mount,
}) => {
  const viewer = await mount(viewerOf().replace('box', 'sphere'), size);
  await setCosts(viewer, { drawing: 200, interval: 60 });
  const drawn = await viewer.evaluate(async (element) => {
    const canvas = element.shadowRoot!.querySelector('canvas')!;
    const triangles: Record<number, Set<number>> = {};
    const { drawElements } = WebGL2RenderingContext.prototype;
    WebGL2RenderingContext.prototype.drawElements = function (...args) {
      (triangles[canvas.width] ??= new Set()).add(args[1] / 3);
      drawElements.apply(this, args);
    };
    const until = async (width: number) => {
      while (canvas.width !== width) {
        await new Promise(requestAnimationFrame);
      }
    };
    element.autoRotate = 45;
    await until(100);
    await element.toBlob();
    await until(100);
    element.autoRotate = 0;
    await until(300);
    return { whole: [...triangles[300]!], moving: [...triangles[100]!] };
  });
  expect(drawn.whole).toHaveLength(1);
  expect(Math.max(...drawn.moving)).toBeLessThan(drawn.whole[0]! / 4);
});
