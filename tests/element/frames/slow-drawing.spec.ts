// Does a picture that moves have fewer pixels where drawing is slow, and only there? Counts pixels.
// The time that drawing takes and that of the page's own work are added to the page's clock, so no
// machine is too slow or too fast.

import type { Locator, Page } from '@playwright/test';
import { expect, pixels, test } from '../../support/test.js';
import { type PhongViewer, statsOf, assign } from '../support/viewer.js';

const size = { width: 300, height: 200 };
const viewerOf = (attributes = ''): string =>
  `<phong-viewer geometry="box" alt="A box" ${attributes}><phong-light></phong-light></phong-viewer>`;

/**
 * Milliseconds of a picture with all pixels, of that which no pixels save, and of the page's own
 * work in each frame.
 */
interface Costs {
  readonly drawing: number;
  readonly vertices?: number;
  readonly own: number;
}

test.beforeEach(async ({ page }) => {
  await page.addInitScript((whole) => {
    const held = Object.assign(window, { costs: { drawing: 0, vertices: 0, own: 0 } });
    const now = performance.now.bind(performance);
    let passed = 0;
    performance.now = () => now() + passed;
    const gl = WebGL2RenderingContext.prototype;
    let seen: WebGLSync;
    gl.clientWaitSync = function (fence) {
      if (fence === seen) return this.CONDITION_SATISFIED;
      seen = fence;
      const { width, height } = this.canvas;
      passed += (held.costs.drawing * width * height) / whole + held.costs.vertices;
      return this.TIMEOUT_EXPIRED;
    };
    Reflect.deleteProperty(gl, 'readPixels'); // it would wait for the GPU, and the page with it
    const request = window.requestAnimationFrame.bind(window);
    window.requestAnimationFrame = (run) =>
      request((time) => {
        passed += held.costs.own;
        run(time);
      });
  }, size.width * size.height);
});

const setCosts = (page: Page, costs: Costs): Promise<void> =>
  page.evaluate((given) => void Object.assign(window, { costs: { vertices: 0, ...given } }), costs);

/** Turns for so many pictures, and gives the widths of the canvas: of these, and of the next one. */
const turn = (viewer: Locator, pictures: number): Promise<{ moving: number[]; still: number }> =>
  viewer.evaluate(async (element: PhongViewer, count) => {
    const canvas = (): HTMLCanvasElement => element.shadowRoot!.querySelector('canvas')!;
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
    for (let width = 0; ; width = canvas().width) {
      if (width === 300) return { moving, still: width };
      await new Promise(requestAnimationFrame);
    }
  }, pictures);

for (const [where, markup] of [
  ['alone', viewerOf()],
  ['beside another', viewerOf() + viewerOf()],
] as const) {
  test(`a slow picture ${where} has a ninth of the pixels from the fourth of a motion on, and all when it is still`, async ({
    page,
    mount,
  }) => {
    const viewer = await mount(markup, size);
    await setCosts(page, { drawing: 200, own: 60 });
    const { moving, still } = await turn(viewer, 8);
    expect(moving.slice(3)).toEqual(Array<number>(5).fill(100));
    expect(still).toBe(300);
    expect((await statsOf(viewer)).reducedFrames).toBeGreaterThanOrEqual(5);
    expect(await viewer.locator('canvas').boundingBox()).toMatchObject(size);
  });
}

for (const [drawing, width] of [
  [36, 200],
  [68, 150],
] as const) {
  test(`a picture that takes ${drawing} ms to draw has ${width} of 300 pixels a side`, async ({
    page,
    mount,
  }) => {
    const viewer = await mount(viewerOf(), size);
    await setCosts(page, { drawing, own: 60 });
    expect((await turn(viewer, 6)).moving.at(-1)).toBe(width);
  });
}

test('late frames alone take no pixels away, nor does slow drawing where `pixel-ratio` is written', async ({
  page,
  mount,
}) => {
  const viewer = await mount(viewerOf(), size);
  await setCosts(page, { drawing: 0, own: 80 });
  await turn(viewer, 6);
  expect((await statsOf(viewer)).reducedFrames).toBe(0);
  await assign(viewer, { pixelRatio: 1 });
  await setCosts(page, { drawing: 200, own: 60 });
  await turn(viewer, 50); // drawing counts as quick for two seconds of this clock
  expect((await statsOf(viewer)).reducedFrames).toBe(0);
});

test('a picture whose canvas another viewer takes waits for no drawing', async ({
  page,
  mount,
}) => {
  const viewer = await mount(viewerOf(), size);
  await setCosts(page, { drawing: 200, own: 60 });
  const [waiting, then, drawn] = await viewer.evaluate(async (element: PhongViewer, markup) => {
    const next = async (): Promise<number> => {
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

test('where vertices take the time, the pixels come back', async ({ page, mount }) => {
  const viewer = await mount(viewerOf(), size);
  await setCosts(page, { drawing: 5, vertices: 150, own: 60 });
  const { moving } = await turn(viewer, 20);
  expect(moving).toContain(100);
  expect(moving.slice(-10)).toEqual(Array<number>(10).fill(300));
});

test('files, `ready` and `shadeAt` know whole pictures only, even of a viewer that never stops', async ({
  page,
  mount,
}) => {
  const viewer = await mount(viewerOf(), size);
  await setCosts(page, { drawing: 200, own: 60 });
  await turn(viewer, 6);
  const seen = await viewer.evaluate(async (element: PhongViewer) => {
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
  page,
  mount,
}) => {
  const viewer = await mount(viewerOf().replace('box', 'sphere'), size);
  await setCosts(page, { drawing: 200, own: 60 });
  const drawn = await viewer.evaluate(async (element: PhongViewer) => {
    const canvas = element.shadowRoot!.querySelector('canvas')!;
    const triangles: Record<number, Set<number>> = {};
    const { drawElements } = WebGL2RenderingContext.prototype;
    WebGL2RenderingContext.prototype.drawElements = function (...args) {
      (triangles[canvas.width] ??= new Set()).add(args[1] / 3);
      drawElements.apply(this, args);
    };
    const until = async (width: number): Promise<void> => {
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

test('once drawing is quick again, a motion gets its pixels back', async ({ page, mount }) => {
  const viewer = await mount(viewerOf(), size);
  await setCosts(page, { drawing: 40, own: 60 });
  await turn(viewer, 6);
  await setCosts(page, { drawing: 0, own: 0 });
  const { moving } = await turn(viewer, 60);
  expect([moving[0], moving.at(-1)]).toEqual([200, 300]);
});
