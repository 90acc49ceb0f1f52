// What every browser test starts from: `test` with a guarded page, a server and `mount`, and
// `expect`. Fails if WebGL 2 does not work, so that a machine without it cannot pass.

import {
  expect,
  test as playwright,
  type CDPSession,
  type Locator,
  type Page,
  type PlaywrightTestArgs,
  type PlaywrightTestOptions,
  type PlaywrightWorkerArgs,
  type PlaywrightWorkerOptions,
  type TestType,
} from '@playwright/test';
import { ConsoleGuard } from './console-guard.js';
import type { PhongViewer } from '../../src/viewer/index.js';
import type { ViewerLike } from './picture.js';
import { SharedPage } from './shared-page.js';
import { startSite, testMounts, type PageOptions, type Site } from './site.js';

export { expect };
export { compare, pixelAt, pixels, same, type Picture } from './picture.js';
export { type Site, strictPolicy } from './site.js';

interface MountOptions extends PageOptions {
  /**
   * CSS pixels of every viewer on the page, the first of which lies at the page's top left; default
   * 600 × 400.
   */
  readonly width?: number;
  readonly height?: number;
  /** Device pixels per CSS pixel; default 1. `setPixelRatio` changes it later. */
  readonly deviceScaleFactor?: number;
  /** false: return the viewer as soon as it is defined, while it may still load. Default true. */
  readonly waitForReady?: boolean;
}

/** What a viewer's locator evaluates gets the viewer. */
interface OnViewer {
  evaluate<R>(work: (viewer: PhongViewer) => R | Promise<R>): Promise<R>;
  evaluate<R, A>(
    work: (viewer: PhongViewer, argument: A) => R | Promise<R>,
    argument: A,
  ): Promise<R>;
}
export type ViewerLocator = OnViewer & Locator;

/** Loads a page with this markup and the standalone build; gives the first viewer. */
export type Mount = (markup: string, options?: MountOptions) => Promise<ViewerLocator>;

interface Fixtures {
  readonly consoleGuard: ConsoleGuard;
  readonly mount: Mount;
}

interface WorkerFixtures {
  /** Serves /dist/, /demo/ (built), /fixtures/, /assets/, /node_modules/ and pages from memory. */
  readonly site: Site;
  readonly webgl2: undefined;
  readonly sharedPage: SharedPage;
}

// Playwright's own `mount` is for component galleries; ours takes its name.
const base = playwright as unknown as TestType<
  Omit<PlaywrightTestArgs, 'mount'> & PlaywrightTestOptions,
  PlaywrightWorkerArgs & PlaywrightWorkerOptions
>;

export const test = base.extend<Fixtures, WorkerFixtures>({
  site: [
    async ({}, use) => {
      const site = await startSite(testMounts);
      await use(site);
      await site.close();
    },
    { scope: 'worker' },
  ],

  webgl2: [
    async ({ browser }, use) => {
      const page = await browser.newPage();
      const works = await page.evaluate(
        () => document.createElement('canvas').getContext('webgl2') !== null,
      );
      await page.close();
      if (!works) {
        throw new Error(
          `This browser (${browser.version()}) gives no WebGL 2, not even in software.`,
        );
      }
      await use(undefined);
    },
    { scope: 'worker' },
  ],

  sharedPage: [
    async ({}, use) => {
      const shared = new SharedPage();
      await use(shared);
      await shared.close();
    },
    { scope: 'worker' },
  ],

  // The other options of the configuration are added by Playwright, and no test changes them.
  context: async (
    { browser, sharedPage, baseURL, viewport, deviceScaleFactor, hasTouch, forcedColors },
    use,
    info,
  ) => {
    const context = await sharedPage.take(browser, {
      viewport,
      hasTouch,
      forcedColors,
      ...(baseURL === undefined ? {} : { baseURL }),
      ...(deviceScaleFactor === undefined ? {} : { deviceScaleFactor }),
    });
    await use(context);
    await sharedPage.giveBack(info.status !== info.expectedStatus);
  },

  baseURL: async ({ site }, use) => use(site.origin),

  consoleGuard: async ({ context }, use) => {
    const guard = new ConsoleGuard();
    await guard.watch(context);
    await use(guard);
    for (const page of context.pages()) {
      // One round trip to each page, so that pending messages arrive.
      await page.evaluate(() => 0).catch(() => 0);
      // Where the browser refuses to resize its window, the next test gets a new page.
      await restorePixelRatio(page).catch(() => page.close());
    }
    guard.check();
  },

  // Named here so that they are at work wherever a page is.
  page: async ({ context, consoleGuard: _guard, webgl2: _works }, use) => use(context.pages()[0]!),

  mount: async ({ page, site }, use) =>
    use((markup, options = {}) => mount(page, site, markup, options)),
});

async function mount(
  page: Page,
  site: Site,
  markup: string,
  options: MountOptions,
): Promise<ViewerLocator> {
  const { width = 600, height = 400, css = '', head = '' } = options;
  const { deviceScaleFactor = 1, waitForReady = true } = options;
  const address = site.page(markup, {
    ...options,
    css: `body { margin: 0 } phong-viewer { display: block; width: ${width}px; height: ${height}px }\n${css}`,
    head: `<script type="module" src="/dist/phong-viewer.standalone.js"></script>${head}`,
  });
  if (deviceScaleFactor !== 1) {
    await setPixelRatio(page, deviceScaleFactor);
  }
  await page.goto(address);
  await defined(page);
  const viewer = page.locator('phong-viewer').first();
  if (waitForReady) {
    await allReady(page);
  }
  return viewer;
}

/** The sessions that hold a page's changed ratio. */
const scaled = new WeakMap<Page, CDPSession>();

/**
 * Changes the device's pixels per CSS pixel under a live page, as moving a window to another screen
 * does. Emulated: `devicePixelRatio` and `resolution` queries change, a `device-pixel-content-box`
 * stays that of the real screen. Holds until the next screenshot or change of the viewport's size.
 */
export async function setPixelRatio(page: Page, deviceScaleFactor: number): Promise<void> {
  const { width, height } = page.viewportSize() ?? { width: 1000, height: 700 };
  const session = scaled.get(page) ?? (await page.context().newCDPSession(page));
  scaled.set(page, session);
  // Chromium updates resolution queries only if the viewport's size changes too.
  for (const tall of [height + 1, height]) {
    const metrics = { width, height: tall, deviceScaleFactor, mobile: false };
    await session.send('Emulation.setDeviceMetricsOverride', metrics);
  }
}

/** Gives a page its own ratio again, for the next test. */
async function restorePixelRatio(page: Page) {
  const session = scaled.get(page);
  const size = page.viewportSize();
  if (session === undefined || size === null || page.isClosed()) return;
  scaled.delete(page);
  await session.detach();
  // Playwright sends its own size and ratio only when the size changes.
  await page.setViewportSize({ ...size, height: size.height + 1 });
  await page.setViewportSize(size);
}

async function defined(page: Page) {
  await page.evaluate(async () => {
    const late = new Promise<never>((_, reject) =>
      setTimeout(
        () => reject(new Error('dist/ did not define <phong-viewer> within 20 s')),
        20_000,
      ),
    );
    await Promise.race([customElements.whenDefined('phong-viewer'), late]);
  });
}

/** Waits until the element is defined, then for `ready` of every viewer on the page. */
export async function allReady(page: Page): Promise<void> {
  await page.evaluate(async () => {
    await customElements.whenDefined('phong-viewer');
    const viewers = document.querySelectorAll<ViewerLike>('phong-viewer');
    await Promise.all(Array.from(viewers, (viewer) => viewer.ready));
  });
}
