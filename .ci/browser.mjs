// @ts-check
// Finds the Chromium that runs the browser tests: PHONG_VIEWER_BROWSER, then the usual places, then
// Playwright's own. If there is none, it installs one: Debian's packages when run by root,
// otherwise Playwright's download. Logs each step.

import { spawnSync } from 'node:child_process';
import { accessSync, constants, existsSync } from 'node:fs';
import { delimiter, join } from 'node:path';

const names = ['chromium', 'chromium-browser', 'google-chrome', 'google-chrome-stable', 'chrome'];
const places = [
  '/Applications/Google Chrome.app/Contents/MacOS/Google Chrome',
  '/Applications/Chromium.app/Contents/MacOS/Chromium',
  'C:\\Program Files\\Google\\Chrome\\Application\\chrome.exe',
  'C:\\Program Files (x86)\\Google\\Chrome\\Application\\chrome.exe',
  '/snap/bin/chromium',
];

/** Chromium's arguments for WebGL in software, so that every machine draws the same pixels. */
export const softwareGl = [
  '--no-sandbox',
  '--use-angle=swiftshader',
  '--enable-unsafe-swiftshader',
  '--ignore-gpu-blocklist',
  '--disable-background-networking',
];

/**
 * The path of a browser on this machine; undefined if there is none.
 * @returns {Promise<string | undefined>}
 */
export async function findBrowser() {
  const asked = process.env['PHONG_VIEWER_BROWSER'];
  if (asked) {
    if (!isExecutable(asked)) {
      throw new Error(`PHONG_VIEWER_BROWSER is no program that can be run: ${asked}`);
    }
    return asked;
  }
  const found = firstOnPath(names) ?? places.find(isExecutable);
  if (found) return found;
  const { chromium } = await import('@playwright/test');
  const own = chromium.executablePath();
  return own && existsSync(own) ? own : undefined;
}

/**
 * The same for tests: a headless shell where there is one. It draws the same pixels, and most tests
 * take a fifth less CPU time in it than in a browser with windows. It has no PDF viewer.
 * @returns {Promise<string | undefined>}
 */
export async function findTestBrowser() {
  const shell = process.env['PHONG_VIEWER_BROWSER']
    ? undefined
    : firstOnPath(['chromium-headless-shell']);
  return shell ?? findBrowser();
}

/** @param {readonly string[]} programs */
function firstOnPath(programs) {
  const folders = (process.env['PATH'] ?? '').split(delimiter).concat('/usr/bin', '/usr/local/bin');
  return folders.flatMap((folder) => programs.map((name) => join(folder, name))).find(isExecutable);
}

/**
 * As {@link findBrowser}, but installs a browser if there is none. Throws with advice if that
 * fails.
 * @returns {Promise<string>}
 */
export async function ensureBrowser() {
  const present = await findBrowser();
  if (present) return present;
  console.log('No browser found in the usual places.');
  if (process.getuid?.() === 0 && existsSync('/etc/debian_version')) {
    const install = 'DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends';
    run(`apt-get update && ${install} chromium`);
    // Not every release of Debian has it.
    run(`${install} chromium-headless-shell`);
    const debian = await findBrowser();
    if (debian) return debian;
  }
  run('npx playwright install chromium');
  const downloaded = await findBrowser();
  if (downloaded) return downloaded;
  throw new Error(
    'No Chromium to run the browser tests in, and none could be installed. ' +
      'Install Chromium or Chrome, or name one: PHONG_VIEWER_BROWSER=/path/to/chrome npm test',
  );
}

/** The browser's name and version, such as "Chromium 140.0.7339.80". @param {string} path */
export function browserVersion(path) {
  // On Windows `chrome --version` opens a window instead.
  if (process.platform === 'win32') return 'version unknown';
  const { stdout } = spawnSync(path, ['--version'], { encoding: 'utf8' });
  return (stdout ?? '').trim() || 'version unknown';
}

/** @param {string} path */
function isExecutable(path) {
  try {
    accessSync(path, constants.X_OK);
    return true;
  } catch {
    return false;
  }
}

/** @param {string} command */
function run(command) {
  console.log(`Trying: ${command}`);
  spawnSync(command, { stdio: 'inherit', shell: true });
}
