// @ts-check
// One bench run: the built pages on a server of their own, fresh launches of one browser, and what is to be known of machine
// and versions. Plain JavaScript, for machines with Node and a browser alone.

import { execFileSync } from 'node:child_process';
import { existsSync, mkdtempSync, readdirSync, readFileSync, symlinkSync, writeFileSync } from 'node:fs';
import { cpus, release, tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { chromium } from 'playwright-core';
import { launchOptions } from '../stress/launch-options.mjs';
import { serveFolder } from '../stress/serve-folder.mjs';
import { box, glbOf } from './glb.mjs';
import { copyPeers, installPeers, peerVersions } from './peers/install.mjs';
import { processesOf, tellsCpuTime } from './processes.mjs';

const here = fileURLToPath(new URL('.', import.meta.url));
const repository = fileURLToPath(new URL('../..', import.meta.url));

/**
 * @typedef {object} SessionOptions
 * @property {string} browser a program, or empty for this machine's own
 * @property {string[]} args its arguments; none: software GL
 * @property {string} page folder of built pages, or empty to build them
 * @property {string} source checkout whose src/ is measured, or empty for this one
 * @property {boolean} [alone] no peer is asked for: none is installed, and only OWN_PAGES are built
 */

/** Pages that time the element and its parts against themselves. */
const OWN_PAGES = /^(fronts|field|viewers-element)\.html$/;

export class Session {
  /** @type {import('playwright-core').LaunchOptions} */
  #launch = {};
  #site = { origin: '', close: () => {} };
  folder = '';

  /** @param {SessionOptions} options */
  static async open({ browser, args, page, source, alone = false }) {
    const session = new Session();
    session.folder =
      page || (await buildPages(mkdtempSync(join(tmpdir(), 'phong-viewer-bench-')), source, alone));
    session.#site = await serveFolder(session.folder);
    session.#launch = await launchOptions(browser, args);
    return session;
  }

  get origin() {
    return this.#site.origin;
  }

  /** Revision and versions that the pages were built from, by name. */
  get versions() {
    return builtFrom(this.folder);
  }

  /** A fresh browser: one launch can misplace a program in memory, so figures come from several. @param {string[]} more arguments */
  async launch(more = []) {
    return chromium.launch({ ...this.#launch, args: [...(this.#launch.args ?? []), ...more] });
  }

  close() {
    this.#site.close();
  }

  /** What a result has to say of where it was measured. */
  async machine() {
    const browser = await this.launch();
    const page = await browser.newPage();
    const renderer = await page.evaluate(() => {
      const gl = document.createElement('canvas').getContext('webgl2');
      const info = gl?.getExtension('WEBGL_debug_renderer_info');
      return String(info && gl?.getParameter(info.UNMASKED_RENDERER_WEBGL));
    });
    const version = browser.version();
    await browser.close();
    return {
      cpu: `${cpus().length} × ${cpus()[0]?.model ?? 'unknown'}`,
      system: `${process.platform} ${release()}`,
      node: process.version,
      browser: `Chromium ${version}`,
      renderer,
      ...this.versions,
    };
  }
}

/** Software GL works in the browser's GPU process; where this system tells of its CPU time, that is the measure. @param {import('playwright-core').Browser} browser */
export async function gpuProcess(browser) {
  if (!tellsCpuTime()) return null;
  return (await processesOf(browser, 'GPU'))[0] ?? null;
}

/** What errors and warnings the page has: a bench of a broken page says nothing. @param {import('playwright-core').Page} page */
export function failOnErrors(page) {
  /** @type {string[]} */
  const said = [];
  page.on('console', (message) => {
    if (message.type() === 'error') said.push(message.text());
  });
  page.on('pageerror', (error) => said.push(String(error)));
  return () => {
    if (said.length > 0) throw new Error(`${page.url()}: ${said.join('\n')}`);
  };
}

/** @param {string} folder @param {string} source @param {boolean} alone */
export async function buildPages(folder, source, alone = false) {
  const { build } = await import('vite');
  if (!alone) installPeers();
  process.env['PHONG_VIEWER_BENCH_OUT'] = folder;
  process.env['PHONG_VIEWER_BENCH_SOURCE'] = source;
  const named = process.env['PHONG_VIEWER_BENCH_NAMES'] !== undefined; // the package's own functions have lost theirs
  process.env['PHONG_VIEWER_BENCH_PACKAGE'] = named ? '' : buildPackage(source || repository);
  const pages = readdirSync(join(here, 'pages')).filter((name) => name.endsWith('.html'));
  for (const page of alone ? pages.filter((name) => OWN_PAGES.test(name)) : pages) {
    process.env['PHONG_VIEWER_BENCH_PAGE'] = page;
    await build({ configFile: join(here, 'vite.config.ts'), logLevel: 'error' });
  }
  if (!alone) copyPeers(folder);
  writeFileSync(join(folder, 'box.glb'), glbOf(box()));
  const root = source || repository;
  /** @param {string} name */
  const version = (name) =>
    JSON.parse(readFileSync(join(repository, 'node_modules', name, 'package.json'), 'utf8')).version;
  const git = (/** @type {string[]} */ ...args) =>
    execFileSync('git', args, { cwd: root, encoding: 'utf8' }).trim();
  const revision =
    git('rev-parse', '--short', 'HEAD') + (git('status', '--short', 'src', 'shaders') ? ' and changes' : '');
  const about = {
    ...{ revision, three: version('three'), lit: version('lit'), vite: version('vite') },
    ...(alone ? {} : peerVersions()),
  };
  writeFileSync(join(folder, 'built-from.json'), JSON.stringify(about));
  return folder;
}

/**
 * The package's modules, as a page's author installs them; answers with the file that is imported. By the checkout's own
 * configuration, in a process of its own: it may be another revision's.
 * @param {string} root
 */
function buildPackage(root) {
  const out = mkdtempSync(join(tmpdir(), 'phong-viewer-package-'));
  symlinkSync(join(repository, 'node_modules'), join(out, 'node_modules'));
  const vite = join(repository, 'node_modules/vite/bin/vite.js');
  const options = ['build', '-c', 'vite.lib.config.ts', '--mode', 'index', '-l', 'error'];
  execFileSync(process.execPath, [vite, ...options], {
    cwd: root,
    env: { ...process.env, PHONG_VIEWER_OUT: out },
    stdio: ['ignore', 'ignore', 'inherit'],
  });
  return join(out, 'dist/index.js');
}

/** @param {string} folder @returns {Record<string, string>} */
function builtFrom(folder) {
  const file = join(folder, 'built-from.json');
  return existsSync(file) ? JSON.parse(readFileSync(file, 'utf8')) : {};
}
