// Plays histories of faults. After the last fault every promise must settle, nothing may have
// thrown, nothing may leak, and the page must show the same as a new page with the same scenes. A
// failing history is reduced.

import type { Page, Route } from '@playwright/test';
import { compare, type Mount } from '../../support/test.js';
import { decodePng } from '../../support/picture.js';
import { type ConsoleGuard, isRemark } from '../../support/console-guard.js';
import { installFaultDeeds } from './fault-deeds.js';
import { randomFaults } from './fault-steps.js';
import { installFaults } from './faults.js';
import { playSeeds } from '../histories/history-shortest.js';
import type { Scenario } from '../histories/history-steps.js';
import { nextFrame } from '../support/viewer.js';

const SIZE = { width: 120, height: 90, css: 'phong-viewer { float: left }' };

/** Console lines that faults cause, and one of the sizes. */
const EXPECTED =
  /Failed to load resource|ERR_FAILED|could not be (fetched|loaded)|has the (width|height) 0/;

class FaultPlayer {
  readonly #page: Page;
  readonly #mount: Mount;
  /** Errors, unhandled rejections and unexpected console lines. */
  readonly #heard: string[] = [];
  #requests = 'answered';

  constructor(page: Page, mount: Mount) {
    this.#page = page;
    this.#mount = mount;
    page.on('pageerror', (error) => this.#heard.push(error.stack ?? String(error)));
    page.on('console', (message) => {
      const text = message.text();
      if (!isRemark(`${message.type()}: ${text}`) && !EXPECTED.test(text)) {
        this.#heard.push(text);
      }
    });
  }

  async start() {
    await installFaults(this.#page);
    await this.#page.addInitScript(installFaultDeeds);
    await this.#page.route('**/*.glb', (route) => this.#answerModel(route));
    await this.#page.route('**/dist/chunks/**', (route) =>
      this.#requests === 'chunks aborted' ? route.abort() : route.continue(),
    );
  }

  /** The faults at the first look that found any; null if none did. */
  async play({ begins, tasks }: Scenario) {
    const page = this.#page;
    this.#requests = 'answered';
    await this.#mount(begins.join(''), { ...SIZE, waitForReady: false });
    this.#heard.length = 0;
    for (const [i, { steps, then }] of tasks.entries()) {
      for (const step of steps) {
        if (step.what === 'requests') {
          this.#requests = step.value;
        } else {
          await page.evaluate((one) => window.faultDeeds.take(one), step);
        }
      }
      if (then === 'a frame') {
        await page.evaluate(() => new Promise(requestAnimationFrame));
      } else if (then === 'rest') {
        await nextFrame(page);
      } else if (then === 'look') {
        const fault = await this.#look();
        if (fault !== '') return `after task ${i}: ${fault}`;
      }
    }
    return null;
  }

  async #answerModel(route: Route) {
    if (this.#requests === 'models aborted') {
      await route.abort();
    } else if (this.#requests === 'models missing') {
      await route.fulfill({ status: 404, body: '' });
    } else if (this.#requests === 'models cut') {
      await route.fulfill({ body: 'glTF' });
    } else {
      await route.continue();
    }
  }

  async #look() {
    const page = this.#page;
    this.#requests = 'answered';
    const unsettled = await page.evaluate(() => window.faultDeeds.heal());
    await nextFrame(page);
    const lived = await page.screenshot();
    const markup = await page.evaluate(() =>
      Array.from(document.querySelectorAll('phong-viewer'), (viewer) => viewer.toHTML()),
    );
    const left = markup.length === 0 ? '' : await page.evaluate(() => window.faultDeeds.leaks());
    const faults = [unsettled, left, ...this.#heard.splice(0)];
    await this.#mount(markup.join(''), SIZE);
    await nextFrame(page);
    const fresh = await page.screenshot();
    const { max } = compare(decodePng(lived), decodePng(fresh));
    // General and specialised programs may differ by one code.
    if (max > 1) {
      faults.push(`the page differs from a new one by ${max} codes:\n${markup.join('\n')}`);
    }
    return faults.filter((fault) => fault !== '').join('\n');
  }
}

interface Fixtures {
  readonly page: Page;
  readonly mount: Mount;
  readonly consoleGuard: ConsoleGuard;
}

/** Plays the histories of these seeds. Throws the first fault. */
export async function expectRecovery(
  { page, mount, consoleGuard }: Fixtures,
  seeds: readonly number[],
  { tasks, withLargest }: { readonly tasks: number; readonly withLargest: boolean },
): Promise<void> {
  consoleGuard.allow(/^/, 'any'); // the player reads the console itself
  const player = new FaultPlayer(page, mount);
  await player.start();
  await playSeeds(
    seeds,
    (seed) => randomFaults(seed, tasks, withLargest),
    (history) => player.play(history),
  );
}
