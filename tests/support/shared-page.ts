// One page for all tests of a worker that ask for the same kind: opening a page of its own takes as
// long as half a test. Playwright's own `reuseContext` loads three pages between two tests and
// empties the cache, compiled scripts included; this loads an empty page and takes back what the
// test has asked of the page. The pages of this repository store nothing.

import type {
  Browser,
  BrowserContext,
  BrowserContextOptions,
  CDPSession,
  Page,
} from '@playwright/test';

type Undo = () => unknown;
type Method = (...given: never[]) => unknown;

/** Changes that cannot be taken back: the context is closed after the test. */
const FINAL = [
  'grantPermissions',
  'setOffline',
  'exposeFunction',
  'exposeBinding',
  'addCookies',
  'setExtraHTTPHeaders',
  'setHTTPCredentials',
];

const NO_MEDIA = {
  media: null,
  colorScheme: 'light',
  reducedMotion: 'no-preference',
  forcedColors: 'none',
  contrast: 'no-preference',
} as const;

export class SharedPage {
  #kind = '';
  #context: BrowserContext | undefined;
  #undo: Undo[] = [];
  #spent = false;

  /** A context with one empty page, the last test's if it was of the same kind. */
  async take(browser: Browser, options: BrowserContextOptions): Promise<BrowserContext> {
    const kind = JSON.stringify(options);
    if (this.#context !== undefined && kind === this.#kind) return this.#context;
    await this.close();
    this.#kind = kind;
    this.#context = await browser.newContext(options);
    await this.#context.addInitScript(drawAtOnce);
    this.#watch(this.#context);
    this.#watchPage(await this.#context.newPage());
    return this.#context;
  }

  /** Takes back what a test has done. @param failed the page may be stuck */
  async giveBack(failed: boolean): Promise<void> {
    const pages = this.#context?.pages() ?? [];
    if (failed || this.#spent || pages.length === 0) return this.close();
    const [first, ...others] = pages;
    for (const page of others) {
      await page.close();
    }
    try {
      await first!.goto('about:blank', { timeout: 5000 });
      // A mouse that rests where the next test's viewer appears hovers over it.
      await first!.mouse.move(-1, -1);
      for (const undo of this.#undo.splice(0).reverse()) {
        await undo();
      }
    } catch {
      await this.close();
    }
  }

  async close(): Promise<void> {
    const context = this.#context;
    this.#context = undefined;
    this.#undo = [];
    this.#spent = false;
    await context?.close();
  }

  #watch(target: BrowserContext | Page) {
    this.#after(
      target,
      'addInitScript',
      (script: { dispose(): Promise<void> }) => () => script.dispose(),
    );
    this.#after(target, 'route', () => () => target.unrouteAll({ behavior: 'ignoreErrors' }));
    for (const name of ['on', 'once']) {
      this.#after(
        target,
        name,
        (_, type: never, listener: never) => () => target.off(type, listener),
      );
    }
    this.#after(
      target,
      'newCDPSession',
      (session: CDPSession) => () => session.detach().catch(() => undefined),
    );
    for (const name of FINAL) {
      this.#after(target, name, () => () => undefined, true);
    }
    this.#after(target.clock, 'install', () => () => undefined, true);
  }

  #watchPage(page: Page) {
    const size = page.viewportSize();
    this.#watch(page);
    this.#after(page, 'emulateMedia', () => () => page.emulateMedia(NO_MEDIA));
    this.#after(page, 'setViewportSize', () => () => size && page.setViewportSize(size));
  }

  /** Calls what `undo` makes of a method's result and arguments when the page is given back. */
  #after(target: object, name: string, undo: Method, final = false) {
    const real = Reflect.get(target, name) as Method | undefined;
    if (real === undefined) return;
    Reflect.set(target, name, (...given: never[]) => {
      const result: unknown = Reflect.apply(real, target, given);
      this.#undo.push(async () => (undo(...([await result, ...given] as never[])) as Undo)());
      if (final) {
        this.#spent = true;
      }
      return result;
    });
  }
}

/**
 * Runs in each page: the drawing that viewers time takes none, so they have all pixels on a slow
 * machine too.
 */
function drawAtOnce() {
  const gl = WebGL2RenderingContext.prototype;
  const { clientWaitSync } = gl;
  // An exercise waits for its own drawing. Its context has no depth; a lost one has no attributes.
  gl.clientWaitSync = function (...given) {
    if (this.getContextAttributes()?.depth) return this.ALREADY_SIGNALED;
    return clientWaitSync.apply(this, given);
  };
}
