// Counts what a page does and holds: frames, timers, WebGL calls, listeners, GPU objects. Wraps the
// browser's functions before any script runs. Playwright's own waiting happens outside the page.

import { expect, type Page } from '@playwright/test';

interface Counts {
  /** Requested so far. */
  readonly frames: number;
  readonly timers: number;
  readonly idleCallbacks: number;
  /**
   * Calls of WebGL 2 functions other than `delete…`: levels and float buffers are freed a while
   * after their last use.
   */
  readonly gl: number;
  /** `drawImage` calls on 2D canvases. */
  readonly copies: number;
  /** Reads by the package that may force layout. */
  readonly layouts: number;
  /** WebGL contexts created so far. */
  readonly contexts: number;
  /** Created and not deleted, over all contexts; also the next six. */
  readonly textures: number;
  readonly buffers: number;
  readonly programs: number;
  readonly shaders: number;
  readonly framebuffers: number;
  readonly renderbuffers: number;
  readonly vertexArrays: number;
  /** Current listeners of the package on the window, the document and media queries. */
  readonly listeners: number;
  /** Observers with at least one target. */
  readonly observers: number;
  /** Pixels of all canvases with a context. */
  readonly canvasPixels: number;
  /** Pixels of the largest WebGL canvas. */
  readonly sheetPixels: number;
}

/** Counts on all pages of this context that are opened later. */
export async function countEverything(page: Page): Promise<void> {
  await page.addInitScript(wrapEverything);
}

export const countsOf = (page: Page): Promise<Counts> =>
  page.evaluate(() => (window as unknown as { takeCounts: () => Counts }).takeCounts());

type Spent = Pick<Counts, 'frames' | 'timers' | 'idleCallbacks' | 'gl' | 'copies' | 'layouts'>;

export const NOTHING: Spent = {
  frames: 0,
  timers: 0,
  idleCallbacks: 0,
  gl: 0,
  copies: 0,
  layouts: 0,
};

export function spentBetween(before: Counts, after: Counts): Spent {
  const spent: Record<keyof Spent, number> = { ...NOTHING };
  for (const key of Object.keys(spent) as (keyof Spent)[]) {
    spent[key] = after[key] - before[key];
  }
  return spent;
}

/** What the page does within `ms` milliseconds. The wait happens outside the page. */
export async function spentIn(page: Page, ms: number): Promise<Spent> {
  const before = await countsOf(page);
  await new Promise((resolve) => setTimeout(resolve, ms));
  return spentBetween(before, await countsOf(page));
}

/** The page does nothing for so many milliseconds. */
export async function expectIdle(page: Page, ms: number, what?: string): Promise<void> {
  expect(await spentIn(page, ms), what).toEqual(NOTHING);
}

/** Runs in the page. */
function wrapEverything() {
  type Call = (this: unknown, ...given: unknown[]) => unknown;
  const counts: Record<string, number> = {};
  const count = (key: string, by = 1): void => void (counts[key] = (counts[key] ?? 0) + by);
  const wrap = (owner: object, name: string, before: (given: unknown[], self: unknown) => void) => {
    const real = Object.getOwnPropertyDescriptor(owner, name)?.value as Call | undefined;
    if (typeof real !== 'function') return;
    Reflect.set(owner, name, function (this: unknown, ...given: unknown[]) {
      before(given, this);
      return Reflect.apply(real, this, given);
    });
  };

  wrap(window, 'requestAnimationFrame', () => count('frames'));
  wrap(window, 'setTimeout', () => count('timers'));
  wrap(window, 'setInterval', () => count('timers'));
  wrap(window, 'requestIdleCallback', () => count('idleCallbacks'));

  const gl = WebGL2RenderingContext.prototype;
  for (const name of Object.getOwnPropertyNames(gl)) {
    if (!name.startsWith('delete')) {
      wrap(gl, name, () => count('gl'));
    }
  }
  for (const kind of 'Texture Buffer Program Shader Framebuffer Renderbuffer VertexArray'.split(
    ' ',
  )) {
    const key = `${kind[0]!.toLowerCase()}${kind.slice(1)}s`;
    const gone = new WeakSet();
    wrap(gl, `create${kind}`, () => count(key));
    wrap(gl, `delete${kind}`, ([one]) => {
      if (typeof one !== 'object' || one === null || gone.has(one)) return;
      gone.add(one);
      count(key, -1);
    });
  }
  wrap(CanvasRenderingContext2D.prototype, 'drawImage', () => count('copies'));

  const isOurs = () => new Error().stack?.includes('/dist/') === true;
  const countLayout = () => {
    if (isOurs()) {
      count('layouts');
    }
  };
  wrap(window, 'getComputedStyle', countLayout);
  wrap(Element.prototype, 'getBoundingClientRect', countLayout);
  for (const name of ['clientWidth', 'clientHeight', 'currentCSSZoom']) {
    const { get } = Object.getOwnPropertyDescriptor(Element.prototype, name) ?? {};
    if (get === undefined) continue;
    Object.defineProperty(Element.prototype, name, {
      configurable: true,
      get(this: Element) {
        countLayout();
        return Reflect.apply(get, this, []) as unknown;
      },
    });
  }

  const canvases = new Set<WeakRef<HTMLCanvasElement>>();
  const known = new WeakSet();
  const sheets = new WeakSet();
  wrap(HTMLCanvasElement.prototype, 'getContext', ([kind], canvas) => {
    if (!(canvas instanceof HTMLCanvasElement) || known.has(canvas)) return;
    known.add(canvas);
    canvases.add(new WeakRef(canvas));
    if (kind !== 'webgl2') return;
    sheets.add(canvas);
    count('contexts');
  });

  for (const Observer of [IntersectionObserver, ResizeObserver]) {
    const watched = new WeakMap<object, Set<unknown>>();
    const of = (self: unknown) => {
      const present = watched.get(self as object) ?? new Set();
      watched.set(self as object, present);
      return present;
    };
    const change = (self: unknown, by: (targets: Set<unknown>) => void) => {
      const targets = of(self);
      const before = targets.size > 0 ? 1 : 0;
      by(targets);
      count('observers', (targets.size > 0 ? 1 : 0) - before);
    };
    wrap(Observer.prototype, 'observe', ([target], self) =>
      change(self, (targets) => targets.add(target)),
    );
    wrap(Observer.prototype, 'unobserve', ([target], self) =>
      change(self, (targets) => targets.delete(target)),
    );
    wrap(Observer.prototype, 'disconnect', (_, self) => change(self, (targets) => targets.clear()));
  }

  let listeners = 0;
  const heard = new WeakMap<object, Set<string>>();
  const identities = new WeakMap<object, number>();
  let identified = 0;
  const identityOf = (listener: object) => {
    const present = identities.get(listener) ?? (identified += 1);
    identities.set(listener, present);
    return present;
  };
  const isGlobal = (target: unknown) =>
    target === window || target === document || target instanceof MediaQueryList;
  const listen = (target: object, type: unknown, listener: unknown, on: boolean) => {
    const present = heard.get(target) ?? new Set();
    heard.set(target, present);
    const key = `${String(type)} ${identityOf(listener as object)}`;
    const before = present.size;
    if (on) {
      present.add(key);
    } else {
      present.delete(key);
    }
    listeners += present.size - before;
  };
  wrap(EventTarget.prototype, 'addEventListener', ([type, listener, options], self) => {
    const target = self ?? window;
    // Playwright adds listeners too, after its first look-up of an element.
    if (!isGlobal(target) || !isOurs()) return;
    listen(target, type, listener, true);
    const signal = (options as AddEventListenerOptions | undefined)?.signal;
    signal?.addEventListener('abort', () => listen(target, type, listener, false));
  });
  wrap(EventTarget.prototype, 'removeEventListener', ([type, listener], self) => {
    const target = self ?? window;
    if (isGlobal(target)) {
      listen(target, type, listener, false);
    }
  });

  const names = [
    'frames',
    'timers',
    'idleCallbacks',
    'gl',
    'copies',
    'layouts',
    'contexts',
    'textures',
    'buffers',
    'programs',
    'shaders',
    'framebuffers',
    'renderbuffers',
    'vertexArrays',
    'observers',
  ];
  const takeCounts = () => {
    let canvasPixels = 0;
    let sheetPixels = 0;
    for (const weak of canvases) {
      const canvas = weak.deref();
      if (canvas === undefined) {
        canvases.delete(weak);
        continue;
      }
      const pixels = canvas.width * canvas.height;
      canvasPixels += pixels;
      if (sheets.has(canvas)) {
        sheetPixels = Math.max(sheetPixels, pixels);
      }
    }
    const present = Object.fromEntries(names.map((name) => [name, counts[name] ?? 0]));
    return { ...present, listeners, canvasPixels, sheetPixels } as unknown as Counts;
  };
  Object.assign(window, { takeCounts });
}
