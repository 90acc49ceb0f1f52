// Plays a random history on a page and compares the page, at each look, with a new page of the same
// scene. A failing history is reduced: tasks and steps are left out as long as it still fails.

import { expect, type Frame, type Page } from '@playwright/test';
import { betweenPrograms, DifferenceSum } from '../../visual/between-programs.js';
import { type Mount, type Picture, setPixelRatio } from '../../support/test.js';
import { type ConsoleGuard, isRemark } from '../../support/console-guard.js';
import type { Site } from '../../support/site.js';
import type { Step } from './history-deeds.js';
import { type Began, type Rest, walkOn } from './history-page.js';
import type { Drawn } from './history-watch.js';
import { type Mix, randomHistory, type Scenario } from './history-steps.js';
import { playSeeds } from './history-shortest.js';

const SIZE = { width: 72, height: 52 };
const STYLE = `
  body { height: 1500px }
  section { height: 300px }
  phong-viewer { display: inline-block !important }
  phong-viewer[style*='none'] { display: none !important }
  iframe { position: fixed; right: 0; bottom: 0; width: 200px; height: 100px }`;

/** Totals over all histories. */
class Findings {
  /** Differences between pictures of different programs, or of cameras that eight digits round. */
  readonly between = new DifferenceSum();
  looks = 0;
  /** Pairs of pictures that the same programs drew. */
  same = 0;
  /** Pictures that specialised programs drew. */
  specialised = 0;
}

class Player {
  readonly #page: Page;
  readonly #mount: Mount;
  readonly #site: Site;
  readonly #heard: string[] = [];
  #warnings = 0;
  #steps = 0;
  /** The iframe with the new viewers. */
  #new: Frame | null = null;
  readonly findings = new Findings();

  constructor(page: Page, mount: Mount, site: Site) {
    this.#page = page;
    this.#mount = mount;
    this.#site = site;
    page.on('console', (message) => {
      const text = message.text();
      const expected = EXPECTED.test(text) && text.length < LONGEST;
      if (expected) {
        this.#warnings += 1;
      }
      const known = isRemark(`${message.type()}: ${text}`) || expected;
      if (!known) {
        this.#heard.push(text);
      }
    });
    page.on('pageerror', (error) => this.#heard.push(String(error)));
  }

  /** The faults at the first look that found any; null if none did. */
  async play({ begins, tasks }: Scenario) {
    await this.#open(begins);
    for (const [i, { steps, then }] of tasks.entries()) {
      await this.#take(steps);
      if (then === 'at once') continue;
      if (then === 'a frame') {
        await this.#page.evaluate(() => new Promise(requestAnimationFrame));
      } else if (then === 'rest') {
        await this.#page.evaluate(() => window.walk.settle());
      } else {
        const fault = await this.#look();
        if (fault !== '') return `after task ${i}: ${fault}`;
      }
    }
    return null;
  }

  async #open(begins: readonly string[]) {
    const page = this.#page;
    await setPixelRatioOnce(page, 1);
    const head = '<script type="module" src="/dist/phong-viewer.standalone.js"></script>';
    const begun = this.#site.page('', { csp: '', head, css: 'body { margin-left: 5000px }' });
    const address = new URL(begun).pathname;
    const body = `<section>${begins.join('')}</section><section></section><iframe src="${address}"></iframe>`;
    await this.#mount(body, { ...SIZE, csp: '', css: STYLE });
    this.#new = page.frames().find((frame) => frame.url() === begun) ?? null;
    // Every history starts with a bad value, so that what it loads does not depend on the seed.
    const bad = {
      what: 'set attribute',
      viewer: 0,
      child: 0,
      tag: 'phong-viewer',
      key: 'fov',
      value: 'wide',
    } as const;
    await this.#take([bad, { ...bad, what: 'remove attribute' }]);
    this.#heard.length = 0;
    this.#warnings = 0;
    this.#steps = 0;
  }

  async #take(steps: readonly Step[]) {
    this.#steps += steps.length;
    let rest = steps;
    while (rest.length > 0) {
      const at = rest.findIndex(({ what }) => what in OUTSIDE);
      const inPage = at < 0 ? rest : rest.slice(0, at);
      if (inPage.length > 0) {
        await this.#page.evaluate((list) => window.walkDeeds.take(list), inPage);
      }
      if (at < 0) return;
      await OUTSIDE[rest[at]!.what]!(this.#page, rest[at]!);
      rest = rest.slice(at + 1);
    }
  }

  async #look() {
    const busy = await this.#page.evaluate(() => window.walk.settle());
    if (busy !== '') return busy;
    const rests = await this.#page.evaluate(() => window.walk.rest());
    const declared = this.findings.looks % 2 === 0;
    const asked = rests.map(({ html, asDeclared, css, pixels, own }) => ({
      html: declared ? (asDeclared ?? html) : html,
      css,
      pixels,
      own,
    }));
    const began = await this.#new!.evaluate((list) => window.walk.begin(list), asked);
    this.findings.looks += 1;
    const faults = rests.flatMap((rest, i) =>
      this.#faults(rest, began[i]!).map((fault) => `viewer ${i}: ${fault}\n${asked[i]!.html}`),
    );
    if (this.#warnings > WARNINGS_PER_STEP * this.#steps) {
      faults.push(`${this.#warnings} warnings of ${this.#steps} steps`);
    }
    return [...faults, ...this.#heard.splice(0).map((text) => `on the console: ${text}`)].join(
      '\n',
    );
  }

  #faults(rest: Rest, began: Began) {
    const { seen, blob, pixels, stats, active, samples, camera } = rest;
    const faults: string[] = [];
    if (seen !== null) {
      const size = `${seen.width} × ${seen.height}`;
      if (size !== pixels.join(' × ')) {
        faults.push(`${size} pixels are seen, not ${pixels.join(' × ')}`);
      } else {
        faults.push(...this.#difference('what is seen and toBlob', seen, blob));
      }
    }
    // toHTML writes eight digits: a camera that needs more is another one by less than a float's
    // rounding.
    const sameCamera = camera.every((x, i) => x === began.camera[i]);
    faults.push(...this.#difference('toBlob and that of a new page', blob, began.blob, sameCamera));
    camera.forEach((x, i) => {
      if (!(Math.abs(x - began.camera[i]!) <= 1e-7 * Math.max(1, Math.abs(x)))) {
        faults.push(`camera ${String(camera)}, not ${String(began.camera)}`);
      }
    });
    const cost = ({
      lightsDeclared,
      lightsActive,
      lightsSent,
      lightsSentByMesh,
      drawCalls,
    }: Rest['stats']) =>
      JSON.stringify({
        lightsDeclared,
        lightsActive,
        lightsSent,
        drawCalls,
        by: [...(lightsSentByMesh as number[])].sort(),
      });
    if (cost(stats) !== cost(began.stats)) {
      faults.push(`stats ${cost(stats)}, of a new page ${cost(began.stats)}`);
    }
    if (seen !== null && stats['samples'] !== samples) {
      faults.push(`${String(stats['samples'])} samples, not ${String(samples)}`);
    }
    if (stats['lightsActive'] !== active) {
      faults.push(`${String(stats['lightsActive'])} lights active, ${active} declared so`);
    }
    return faults;
  }

  #difference(which: string, a: Drawn, b: Drawn, sameCamera = true) {
    const difference = betweenPrograms(pictureOf(a), pictureOf(b));
    const { max, differing, channels } = difference;
    const same =
      sameCamera && a.programs === b.programs && a.programs !== '' && a.place === b.place;
    if (same) {
      this.findings.same += 1;
    } else {
      this.findings.between.add(difference);
    }
    if (a.programs.includes('specialised')) {
      this.findings.specialised += 1;
    }
    // In a small picture one channel is more than the promised share.
    if (max <= (same ? 0 : 1) && differing <= Math.max(2, 2e-3 * channels)) return [];
    return [
      `${which} differ by ${max} codes on ${differing} of ${channels} channels, drawn by ${a.programs || '?'} and ${b.programs || '?'}`,
    ];
  }
}

/** Warnings about values and trees that are wrong on purpose. */
const EXPECTED =
  /<.*(expected .*; using .* instead\.|has no attribute|contains another|so it has no effect|so it is not shown)/;

/** Most characters of such a warning. */
const LONGEST = 600;

/** Largest average. A step can copy a tree of many elements with bad values. */
const WARNINGS_PER_STEP = 10;

function pictureOf({ width, height, data }: Drawn): Picture {
  return { width, height, data: Uint8Array.from(Buffer.from(data, 'base64')) };
}

const ratios = new WeakMap<Page, number>();
async function setPixelRatioOnce(page: Page, ratio: number) {
  if ((ratios.get(page) ?? 1) === ratio) return;
  ratios.set(page, ratio);
  await setPixelRatio(page, ratio);
}

/** Steps that act from outside the page: input, and the screen's resolution. */
const OUTSIDE: Readonly<Record<string, (page: Page, step: Step) => Promise<void>>> = {
  async drag(page, step) {
    const [dx = 0, dy = 0] = step.value.split(' ').map(Number);
    if (!(await over(page, step))) return;
    const [x, y] = await middleOf(page, step);
    await page.mouse.down();
    await page.mouse.move(x + dx, y + dy, { steps: 2 });
    await page.mouse.up();
  },
  async wheel(page, step) {
    if (!(await over(page, step))) return;
    await page.mouse.down();
    await page.mouse.up();
    await page.mouse.wheel(0, Number(step.value));
  },
  ratio: (page, { value }) => setPixelRatioOnce(page, Number(value)),
};

const viewerOf = async (page: Page, { viewer }: Step) => {
  const all = page.locator('phong-viewer');
  const count = await all.count();
  return count === 0 ? null : all.nth(viewer % count);
};

async function middleOf(page: Page, step: Step): Promise<[number, number]> {
  const box = await (await viewerOf(page, step))?.boundingBox();
  return box ? [box.x + box.width / 2, box.y + box.height / 2] : [-1, -1];
}

async function over(page: Page, step: Step) {
  const [x, y] = await middleOf(page, step);
  const { width, height } = page.viewportSize() ?? { width: 0, height: 0 };
  if (!(x >= 0 && y >= 0 && x < width && y < height)) return false;
  await page.mouse.move(x, y);
  return true;
}

export const seedsFrom = (first: number, count: number): number[] =>
  Array.from({ length: count }, (_, i) => first + i);

interface Fixtures {
  readonly page: Page;
  readonly mount: Mount;
  readonly site: Site;
  readonly consoleGuard: ConsoleGuard;
}

/** Plays the histories of these seeds with `looks` looks each. Throws the first fault. */
export async function expectAsNew(
  { page, mount, site, consoleGuard }: Fixtures,
  seeds: readonly number[],
  looks: number,
  mix?: Mix,
): Promise<void> {
  consoleGuard.allow(EXPECTED);
  await walkOn(page);
  const player = new Player(page, mount, site);
  await playSeeds(
    seeds,
    (seed) => randomHistory(seed, looks, mix),
    (history) => player.play(history),
  );
  const { looks: looked, same, specialised, between } = player.findings;
  console.log(
    `Seeds ${seeds.join()}: ${looked} looks, ${same} pairs of pictures by the same programs, ${specialised} by specialised ones; else ${String(between)}`,
  );
  expect(same, 'pairs by the same programs').toBeGreaterThan(0);
  // Only over many channels: one channel of few would exceed the promised share.
  if (between.channels > 5e4) {
    between.expectPromise();
  }
}
