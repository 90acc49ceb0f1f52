// Does the element hold in a second browser, on a second GL? Firefox with Mesa's software renderer, under Xvfb; driven by
// puppeteer because Playwright's own Firefox is a build of its own.
import { execFileSync, spawn, type ChildProcess } from 'node:child_process';
import { existsSync } from 'node:fs';
import { expect, test } from '@playwright/test';
import puppeteer, { type Browser } from 'puppeteer-core';
import { decodePng } from '../support/picture.js';
import { startSite, testMounts, type Site } from '../support/site.js';
import { compareWithReference } from '../visual/against-reference.js';
import { randomScene, sceneMarkup } from '../visual/random-scene.js';

const SIZE = { width: 160, height: 120 };
const SCENES = 60;
/** A display of this run's own: another run may have the next one. */
const SCREEN = 100 + (process.pid % 800);
const NEEDED = ['firefox-esr', 'xvfb', 'libegl1', 'libgl1-mesa-dri'];

let site: Site | undefined;
let screen: ChildProcess | undefined;
let browser: Browser | undefined;

// One worker, and so one Firefox and one screen.
test.describe.configure({ mode: 'serial' });

function has(command: string): boolean {
  try {
    execFileSync('which', [command], { stdio: 'ignore' });
    return true;
  } catch {
    return false;
  }
}

test.beforeAll(async () => {
  test.setTimeout(300_000);
  if (!has('firefox-esr') || !has('Xvfb')) {
    if (process.getuid?.() !== 0 || !has('apt-get'))
      throw new Error(`This test needs ${NEEDED.join(', ')} (Debian's names).`);
    execFileSync('apt-get', ['update', '-qq']);
    execFileSync('apt-get', ['install', '-y', '-qq', ...NEEDED]);
  }
  site = await startSite(testMounts);
  screen = spawn('Xvfb', [`:${SCREEN}`, '-screen', '0', '1000x700x24'], { stdio: 'ignore' });
  await expect.poll(() => existsSync(`/tmp/.X11-unix/X${SCREEN}`)).toBe(true);
  browser = await puppeteer.launch({
    browser: 'firefox',
    executablePath: execFileSync('which', ['firefox-esr'], { encoding: 'utf8' }).trim(),
    headless: false,
    env: { ...process.env, DISPLAY: `:${SCREEN}` },
    extraPrefsFirefox: { 'webgl.force-enabled': true },
  });
});

test.afterAll(async () => {
  await browser?.close();
  screen?.kill();
  await site?.close();
});

test('@release draws the equation in Firefox within one code of float64', async () => {
  test.setTimeout(900_000);
  if (browser === undefined || site === undefined) throw new Error('Firefox did not start');
  const page = await browser.newPage();
  const said: string[] = [];
  page.on('console', (message) => said.push(message.text()));
  page.on('pageerror', (error) => said.push(String(error)));
  const head = '<script type="module" src="/dist/phong-viewer.standalone.js"></script>';
  const css = `phong-viewer { display: block; width: ${SIZE.width}px; height: ${SIZE.height}px }`;
  for (let seed = 1; seed <= SCENES; seed++) {
    const scene = randomScene(seed, seed % 3 === 0 ? 'box' : 'plane');
    await page.goto(site.page(sceneMarkup(scene), { head, css }));
    const base64 = await page.evaluate(async ({ width, height }) => {
      await customElements.whenDefined('phong-viewer');
      const viewer = document.querySelector('phong-viewer') as HTMLElement & {
        ready: Promise<void>;
        toBlob(options: object): Promise<Blob>;
      };
      await viewer.ready;
      const bytes = new Uint8Array(await (await viewer.toBlob({ width, height })).arrayBuffer());
      return btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(''));
    }, SIZE);
    const errors = compareWithReference(decodePng(Buffer.from(base64, 'base64')), scene);
    expect.soft(errors.max, `seed ${seed}, ${errors.at}`).toBeLessThanOrEqual(1);
  }
  expect(said).toEqual([]);
});

test('@release loads the bunny and its panel in Firefox under a strict policy', async () => {
  test.setTimeout(120_000);
  if (browser === undefined || site === undefined) throw new Error('Firefox did not start');
  const page = await browser.newPage();
  const said: string[] = [];
  page.on('console', (message) => said.push(message.text()));
  const head = '<script type="module" src="/dist/phong-viewer.standalone.js"></script>';
  await page.goto(site.page('<phong-viewer src="/assets/models/bunny.glb" gui></phong-viewer>', { head }));
  await page.waitForFunction(() => {
    const viewer = document.querySelector('phong-viewer') as (HTMLElement & { loaded?: boolean }) | null;
    return (
      viewer?.loaded === true && viewer.shadowRoot?.querySelector('.panel')?.textContent.includes('Camera')
    );
  });
  expect(said).toEqual([]);
});
