// One page in Firefox or in WebKitGTK, with real input: what the checks of browser-checks.ts need
// of a browser. Positions are CSS pixels of the page.
import { test } from '@playwright/test';
import { startFirefox } from '../../.ci/firefox.mjs';
import { startWebkit } from '../../.ci/webkit.mjs';
import type { PhongViewer } from '../../src/viewer/index.js';
import { type PageOptions, type Site, startSite, testMounts } from '../support/site.js';

type Place = readonly [x: number, y: number];

export interface Tab {
  /** Such as `Firefox 153.0`. */
  readonly browser: string;
  open(address: string): Promise<void>;
  /**
   * Runs a function in the page, which may use nothing outside itself; arguments and result travel
   * as JSON.
   */
  run<A, T>(work: (argument: A) => T | Promise<T>, argument: A): Promise<T>;
  run<T>(work: () => T | Promise<T>): Promise<T>;
  /** The same with the page's first viewer. */
  onViewer<A, T>(
    work: (viewer: PhongViewer, argument: A) => T | Promise<T>,
    argument: A,
  ): Promise<T>;
  onViewer<T>(work: (viewer: PhongViewer) => T | Promise<T>): Promise<T>;
  /** Presses the primary button at `from`, moves by `by` in several steps and releases. */
  drag(from: Place, by: Place): Promise<void>;
  /** Turns the wheel by so many pixels. */
  wheel(at: Place, pixels: number): Promise<void>;
  /** A key by its name in KeyboardEvent. */
  press(key: 'ArrowRight' | 'Home' | '+'): Promise<void>;
  /** What the window shows, as PNG. */
  screenshot(): Promise<Uint8Array>;
  close(): Promise<void>;
}

export const STARTS: Readonly<Record<string, () => Promise<Tab>>> = {
  Firefox: firefoxTab,
  WebKitGTK: webkitTab,
};

/**
 * Declares tests for each of these browsers: one worker, and so one browser and one screen each.
 * `open` shows a page in its tab.
 */
export function inEachBrowser(
  timeout: number,
  declare: (open: (markup: string, options: PageOptions) => Promise<Tab>) => void,
): void {
  for (const [name, start] of Object.entries(STARTS)) {
    test.describe(`@release ${name}`, () => {
      let site: Site | undefined;
      let tab: Tab | undefined;
      test.describe.configure({ mode: 'default', timeout });
      test.beforeAll(async () => {
        site = await startSite(testMounts);
        tab = await start();
        console.log(tab.browser);
      });
      test.afterAll(async () => {
        await tab?.close();
        await site?.close();
      });
      declare(async (markup, options) => {
        if (site === undefined || tab === undefined) throw new Error(`${name} did not start`);
        await tab.open(site.page(markup, options));
        return tab;
      });
    });
  }
}

async function firefoxTab(): Promise<Tab> {
  const { browser, close } = await startFirefox();
  const page = await browser.newPage();
  await page.setViewport({ width: 900, height: 600 });
  return {
    browser: (await browser.version()).replace('/', ' '),
    async open(address) {
      await page.goto(address);
    },
    onViewer: (work: (viewer: PhongViewer, argument: never) => unknown, argument?: unknown) =>
      page.$eval('phong-viewer', work, argument as never) as never,
    run: (work: (argument: never) => unknown, argument?: unknown) =>
      page.evaluate(work, argument as never) as never,
    async drag([x, y], [dx, dy]) {
      await page.mouse.move(x, y);
      await page.mouse.down();
      await page.mouse.move(x + dx, y + dy, { steps: 4 });
      await page.mouse.up();
    },
    async wheel([x, y], deltaY) {
      await page.mouse.move(x, y);
      await page.mouse.wheel({ deltaY });
    },
    press: (key) => page.keyboard.press(key),
    screenshot: () => page.screenshot(),
    close,
  };
}

/** WebDriver's codes of keys that type no character. */
const KEYS = { ArrowRight: '\uE014', Home: '\uE011', '+': '+' } as const;

async function webkitTab(): Promise<Tab> {
  const { version, send, close } = await startWebkit();
  const act = async (...actions: readonly object[]): Promise<void> =>
    await send('POST', '/actions', { actions });
  const mouse = (...actions: readonly object[]) =>
    act({ type: 'pointer', id: 'mouse', parameters: { pointerType: 'mouse' }, actions });
  const execute = async (call: string, argument: unknown) => {
    const script = `const [argument, done] = arguments;
      (async () => ${call})().then(
        (value) => done({ value }),
        (error) => done({ error: String(error) + '\\n' + error?.stack }));`;
    const answer = (await send('POST', '/execute/async', { script, args: [argument ?? null] })) as {
      readonly value?: unknown;
      readonly error?: string;
    };
    if (answer.error !== undefined) throw new Error(answer.error);
    return answer.value;
  };
  return {
    browser: `WebKitGTK ${version}`,
    async open(url) {
      await send('POST', '/url', { url });
    },
    run: (work: (argument: never) => unknown, argument?: unknown) =>
      execute(`(${String(work)})(argument)`, argument) as never,
    onViewer: (work: (viewer: PhongViewer, argument: never) => unknown, argument?: unknown) =>
      execute(
        `(${String(work)})(document.querySelector('phong-viewer'), argument)`,
        argument,
      ) as never,
    drag: ([x, y], [dx, dy]) =>
      mouse(
        { type: 'pointerMove', x, y, duration: 0 },
        { type: 'pointerDown', button: 0 },
        ...[0.25, 0.5, 0.75, 1].map((share) => ({
          type: 'pointerMove',
          duration: 0,
          x: Math.round(x + share * dx),
          y: Math.round(y + share * dy),
        })),
        { type: 'pointerUp', button: 0 },
      ),
    wheel: ([x, y], deltaY) =>
      act({
        type: 'wheel',
        id: 'wheel',
        actions: [{ type: 'scroll', x, y, deltaX: 0, deltaY, duration: 0 }],
      }),
    press: (key) =>
      act({
        type: 'key',
        id: 'keys',
        actions: ['keyDown', 'keyUp'].map((type) => ({ type, value: KEYS[key] })),
      }),
    async screenshot() {
      return Buffer.from((await send('GET', '/screenshot')) as string, 'base64');
    },
    close,
  };
}
