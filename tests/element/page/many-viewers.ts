// Many viewers on one page: creates them, scrolls through them, adds and removes them. The short
// and the long tests differ only in the number.

import type { CDPSession, Locator, Page } from '@playwright/test';
import { allReady, expect, type Mount } from '../../support/test.js';
import { countsOf } from '../support/counting.js';
import { nextFrame, type PhongViewer } from '../support/viewer.js';

const light = '<phong-light position="1 2 3 0"></phong-light>';

/** Boxes: the first one is black, each next one is redder. */
export const reddening = (count: number): string =>
  Array.from(
    { length: count },
    (_, i) =>
      `<phong-viewer geometry="box" terms="diffuse" kd="${(255 * i) / count} 0 0">${light}</phong-viewer>`,
  ).join('');

/**
 * The red code (0 to 255) in the middle of each viewer's own canvas; -1 without a canvas. Copies
 * each canvas once.
 */
export const redsShown = (page: Page): Promise<number[]> =>
  page.evaluate(() => {
    const pixel = new OffscreenCanvas(1, 1).getContext('2d', { willReadFrequently: true })!;
    return [...document.querySelectorAll('phong-viewer')].map(({ shadowRoot }) => {
      const canvas = shadowRoot?.querySelector('canvas');
      if (!canvas) return -1;
      pixel.clearRect(0, 0, 1, 1);
      pixel.drawImage(canvas, -canvas.width / 2, -canvas.height * 0.6);
      return pixel.getImageData(0, 0, 1, 1).data[0]!;
    });
  });

/**
 * Scrolls a column of `count` viewers to its end and back. Their canvases' pixels must stay bounded
 * throughout.
 */
export async function scrollThrough(page: Page, mount: Mount, count: number): Promise<void> {
  const size = { width: 300, height: 200 };
  const view = { width: 1000, height: 700 };
  const viewer = await mount(reddening(count), size);
  const first = await viewer.screenshot();
  const pixelsOfOne = size.width * size.height;
  const screenful = await page.evaluate(() => screen.width * screen.height * devicePixelRatio ** 2);
  const onScreen = (Math.ceil(view.height / size.height) + 1) * pixelsOfOne;
  const near = (Math.ceil((3 * view.height) / size.height) + 1) * pixelsOfOne;
  // Viewers on screen or near it, two screens of earlier ones, those not yet reported by the
  // observer, and the shared canvas.
  const bound = near + 2 * screenful + onScreen + screenful;
  expect(count * pixelsOfOne, 'more than may be kept').toBeGreaterThan(bound);
  const end = count * size.height - view.height;
  for (let top = 0; top < end; top += view.height - size.height) {
    await page.evaluate((y) => scrollTo(0, y), top);
    await nextFrame(page);
    const { canvasPixels, contexts } = await countsOf(page);
    expect(canvasPixels).toBeLessThanOrEqual(bound);
    expect(contexts).toBe(1);
  }
  const drawn = await page.evaluate(
    () =>
      [...document.querySelectorAll('phong-viewer')].filter(({ stats }) => stats.frames > 0).length,
  );
  expect(drawn).toBeGreaterThan(0.9 * count);
  await page.evaluate(() => scrollTo(0, 0));
  await expect.poll(async () => Buffer.compare(await viewer.screenshot(), first)).toBe(0);
}

/** Counts that must not grow, however many viewers come and go. */
const GIVEN_BACK = [
  'textures',
  'buffers',
  'programs',
  'shaders',
  'framebuffers',
  'renderbuffers',
  'vertexArrays',
  'listeners',
  'observers',
] as const;

/** What a page holds now. */
interface HeapSnapshot {
  readonly snapshot: {
    readonly meta: {
      readonly node_fields: readonly string[];
      readonly node_types: readonly [readonly string[]];
    };
  };
  /** The fields of one node after those of another. */
  readonly nodes: readonly number[];
}

export class Ledger {
  readonly #page: Page;
  readonly #session: CDPSession;

  constructor(page: Page, session: CDPSession) {
    this.#page = page;
    this.#session = session;
  }

  static async of(page: Page): Promise<Ledger> {
    return new Ledger(page, await page.context().newCDPSession(page));
  }

  /**
   * `objects`: of each class in the page's heap after a garbage collection.
   */
  async read() {
    await nextFrame(this.#page);
    // Twice: finalizers of the first collection free more objects.
    for (let time = 0; time < 2; time++) {
      await this.#session.send('HeapProfiler.collectGarbage');
    }
    const objects: Record<string, number> = {};
    for (const [name, prototype] of Object.entries(PROTOTYPES)) {
      objects[name] = await this.#instances(prototype);
    }
    const all = await countsOf(this.#page);
    const counts = Object.fromEntries(GIVEN_BACK.map((key) => [key, all[key]]));
    return { counts, objects };
  }

  /**
   * Bytes of the page's heap after a garbage collection, without compiled code: with use the engine
   * compiles more functions, and each better.
   */
  async heap(): Promise<number> {
    let text = '';
    const add = ({ chunk }: { readonly chunk: string }) => {
      text += chunk;
    };
    this.#session.on('HeapProfiler.addHeapSnapshotChunk', add);
    await this.#session.send('HeapProfiler.takeHeapSnapshot', { reportProgress: false });
    this.#session.off('HeapProfiler.addHeapSnapshotChunk', add);
    const { snapshot, nodes } = JSON.parse(text) as HeapSnapshot;
    const { node_fields: fields, node_types } = snapshot.meta;
    const [type, size] = [fields.indexOf('type'), fields.indexOf('self_size')];
    let bytes = 0;
    for (let i = 0; i < nodes.length; i += fields.length) {
      if (node_types[0][nodes[i + type]!] !== 'code') {
        bytes += nodes[i + size]!;
      }
    }
    return bytes;
  }

  async #instances(prototype: string) {
    const objectGroup = 'ledger';
    const { result } = await this.#session.send('Runtime.evaluate', {
      expression: prototype,
      objectGroup,
    });
    if (result.objectId === undefined) throw new Error(`no object: ${prototype}`);
    const { objects } = await this.#session.send('Runtime.queryObjects', {
      prototypeObjectId: result.objectId,
      objectGroup,
    });
    const { result: length } = await this.#session.send('Runtime.callFunctionOn', {
      objectId: objects.objectId!,
      functionDeclaration: 'function () { return this.length }',
      returnByValue: true,
    });
    await this.#session.send('Runtime.releaseObjectGroup', { objectGroup });
    return length.value as number;
  }
}

/**
 * Remembers, without keeping them alive, all elements of the package that are on the page, and the
 * scenes of its viewers.
 */
export const remember = (page: Page): Promise<void> =>
  page.evaluate(() => {
    const remembered: [name: string, object: WeakRef<object>][] = [];
    for (const element of document.querySelectorAll('*')) {
      if (!element.localName.startsWith('phong-')) continue;
      remembered.push([element.localName, new WeakRef(element)]);
      if ('scene' in element) {
        remembered.push(['scene', new WeakRef(element.scene as object)]);
      }
    }
    Object.assign(window, { remembered });
  });

/** What is alive of what was remembered last, by name, after a garbage collection. */
export async function stillAlive(page: Page): Promise<string[]> {
  const session = await page.context().newCDPSession(page);
  await nextFrame(page);
  for (let time = 0; time < 2; time++) {
    await session.send('HeapProfiler.collectGarbage');
  }
  await session.detach();
  return page.evaluate(() => {
    type Remembered = readonly [name: string, object: WeakRef<object>];
    const { remembered } = window as unknown as { remembered: readonly Remembered[] };
    return remembered.filter(([, weak]) => weak.deref() !== undefined).map(([name]) => name);
  });
}

const first = `document.querySelector('phong-viewer')`;
const drawn = `${first}.scene.getObjectByProperty('isMesh', true)`;
const above = (object: string) => `Object.getPrototypeOf(Object.getPrototypeOf(${object}))`;

/** Expressions for the prototypes that all objects of a class have. */
const PROTOTYPES = {
  viewers: `customElements.get('phong-viewer').prototype`,
  lights: `customElements.get('phong-light').prototype`,
  scenes: `Object.getPrototypeOf(${first}.scene)`,
  materials: above(`${drawn}.material`),
  geometries: above(`${drawn}.geometry`),
  canvases: 'HTMLCanvasElement.prototype',
  ports: 'MessagePort.prototype',
} as const;

/**
 * Adds `count` viewers of these kinds after the first, lets them draw, uses them and removes them.
 * One is asked for a picture afterwards too.
 */
export async function comeAndGo(
  page: Page,
  kinds: readonly string[],
  count: number,
): Promise<void> {
  await page.evaluate(
    ({ kinds, count }) => {
      for (let i = 0; i < count; i++) {
        document.body.insertAdjacentHTML('beforeend', kinds[i % kinds.length]!);
      }
    },
    { kinds, count },
  );
  await allReady(page);
  await nextFrame(page);
  await page.evaluate(async () => {
    const [, ...come] = document.querySelectorAll<PhongViewer>('phong-viewer');
    for (const viewer of come) {
      viewer.theta += 10;
      viewer.append(document.createElement('phong-light'));
    }
    await Promise.all(come.map((viewer) => viewer.ready));
    await come[0]?.toBlob();
    const remove = (from: number) => {
      come.slice(from).forEach((viewer) => viewer.remove());
      return new Promise((resolve) => setTimeout(resolve));
    };
    const last = come.slice(0, come.length / 2);
    await remove(last.length);
    // What those have shared is drawn again, and then shown no longer.
    for (const change of [{ theta: 60 }, { radius: 9, src: '' }]) {
      for (const viewer of last) {
        Object.assign(viewer, change);
      }
      await Promise.all(last.map(({ ready }) => ready));
    }
    await remove(0);
    await come[0]?.toBlob({ width: 40, height: 30 });
  });
  await nextFrame(page);
}

/**
 * The page's WebGL context can be lost and restored from outside; call before the page is opened.
 */
export async function holdContext(page: Page): Promise<void> {
  await page.addInitScript(() => {
    const real = HTMLCanvasElement.prototype.getContext;
    HTMLCanvasElement.prototype.getContext = function (
      this: HTMLCanvasElement,
      ...given: unknown[]
    ) {
      const context = Reflect.apply(real, this, given) as unknown;
      if (context instanceof WebGL2RenderingContext) {
        // Null while it is lost.
        const loss = context.getExtension('WEBGL_lose_context');
        Object.assign(window, loss && { loss });
      }
      return context;
    } as typeof real;
  });
}

/**
 * Loses and restores the context. Waits until all viewers show each change; `meanwhile` runs in
 * between.
 */
export async function loseAndRestore(
  page: Page,
  viewers: Locator,
  meanwhile?: () => Promise<unknown>,
): Promise<void> {
  const count = await viewers.count();
  const notices = page.locator('phong-viewer [part=notice]');
  await page.evaluate('window.loss.loseContext()');
  await expect(notices).toHaveCount(count);
  await meanwhile?.();
  await page.evaluate('window.loss.restoreContext()');
  await expect(notices).toHaveCount(0);
  await allReady(page);
  await nextFrame(page);
}
