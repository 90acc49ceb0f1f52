// The same bytes in each engine: the package's code draws the same scenes in Node and in pages. A
// release run takes all scenes and all engines.
import { execFile } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { promisify } from 'node:util';
import { build, type Rolldown } from 'vite';
import { outputFolder } from '../../../.ci/output-folder.mjs';
import { fullOr } from '../../support/repeats.js';
import { expect, type Site, test } from '../../support/test.js';
import { STARTS } from '../../release/tabs.js';
import { modelScenes, siteScenes } from './scenes.js';

/** Small, so that the slow ones among the scenes take a second. */
const SIZE = { width: fullOr(152, 76), height: fullOr(84, 42) };

const SCENES = [
  ...siteScenes(fullOr(Infinity, 3), fullOr(Infinity, 1)),
  ...modelScenes().slice(0, fullOr(Infinity, 1)),
];

/** Draws a scene: the SHA-256 of its pixels and of its PNG. */
type Digest = (markup: string, base: string) => Promise<string>;

/** A module that puts it into the global object. */
const entry = (still: string) => `
  import { still } from ${JSON.stringify(still)};
  const digest = async (bytes) => {
    const sum = new Uint8Array(await crypto.subtle.digest('SHA-256', bytes));
    return Array.from(sum, (byte) => byte.toString(16).padStart(2, '0')).join('');
  };
  globalThis.digestOf = async (markup, base) => {
    const size = ${JSON.stringify(SIZE)};
    const { pixels, png } = await still(markup, { ...size, base, warn: () => {} });
    return (await digest(pixels)) + ' ' + (await digest(png));
  };`;

const STILL = join(outputFolder('dist'), 'still.js');

/** The same code as one script for pages. */
async function pageScript() {
  const result = await build({
    configFile: false,
    logLevel: 'error',
    plugins: [
      {
        name: 'entry',
        resolveId: (name) => (name === 'entry' ? '\0entry' : null),
        load: (id) => (id === '\0entry' ? entry(STILL) : null),
      },
    ],
    build: {
      write: false,
      target: 'es2022',
      minify: false,
      rolldownOptions: {
        input: 'entry',
        external: /^(node:|pngjs|jpeg-js)/,
        output: { codeSplitting: false, format: 'es' },
      },
    },
  });
  const [{ output }] = [result].flat() as Rolldown.RolldownOutput[] as [Rolldown.RolldownOutput];
  return output[0].code;
}

/** Lets the test's own script run. */
const OPEN = "script-src 'self' 'unsafe-inline'";

/** Draws the scenes in Node, on all cores, and writes what it found as JSON. */
const inNodeScript = (base: string) => `
  ${entry(pathToFileURL(STILL).href)}
  const found = [];
  for (const markup of ${JSON.stringify(SCENES.map(({ markup }) => markup))}) {
    found.push(await digestOf(markup, ${JSON.stringify(base)}));
  }
  console.log(JSON.stringify({ version: process.version, found }));`;

const run = promisify(execFile);
let code: string;
let folder: string;
let here: Promise<readonly string[]> | undefined;

/** In this Node, or in one of another version, which npx fetches. */
async function inNode(base: string, version?: number): Promise<readonly string[]> {
  const file = join(folder, 'draw.mjs');
  writeFileSync(file, inNodeScript(base));
  const [command, ...before] =
    version === undefined ? [process.execPath] : ['npx', '-y', `node@${version}`];
  const { stdout } = await run(command!, [...before, file], { cwd: folder });
  const answer = JSON.parse(stdout) as { readonly version: string; readonly found: string[] };
  console.log(`Node ${answer.version}`);
  if (version !== undefined) {
    expect(answer.version).toMatch(new RegExp(`^v${version}\\.`));
  }
  return answer.found;
}

/** Compares with this Node, scene by scene. */
async function expectSame(site: Site, found: readonly string[]) {
  const expected = await (here ??= inNode(site.origin));
  const named = (digests: readonly string[]): readonly string[] =>
    SCENES.map(({ name }, i) => `${name}: ${digests[i]!}`);
  expect(named(found)).toEqual(named(expected));
}

// One worker: what this Node draws is drawn once.
test.describe.configure({ mode: 'default', timeout: fullOr(1_800_000, 120_000) });

test.beforeAll(async () => {
  code = await pageScript();
  folder = mkdtempSync(join(tmpdir(), 'engines-'));
});

test.afterAll(() => rmSync(folder, { recursive: true, force: true }));

const draw = ({ markup, base }: { readonly markup: string; readonly base: string }) =>
  (globalThis as unknown as { digestOf: Digest }).digestOf(markup, base);

test('a still has the same bytes in Node and in Chromium', async ({ page, site }) => {
  await page.goto(site.page('', { csp: OPEN }));
  await page.addScriptTag({ type: 'module', content: code });
  await page.waitForFunction(() => 'digestOf' in globalThis);
  const found: string[] = [];
  for (const { markup } of SCENES) {
    found.push(await page.evaluate(draw, { markup, base: site.origin }));
  }
  await expectSame(site, found);
});

for (const version of [20, 22, 24]) {
  test(`@release a still has the same bytes in Node ${version}`, async ({ site }) => {
    await expectSame(site, await inNode(site.origin, version));
  });
}

for (const [name, start] of Object.entries(STARTS)) {
  test(`@release a still has the same bytes in ${name}`, async ({ site }) => {
    const tab = await start();
    console.log(tab.browser);
    try {
      const head = `<script type="module">${code.replaceAll('</script', '<\\/script')}</script>`;
      await tab.open(site.page('', { csp: OPEN, head }));
      const found: string[] = [];
      for (const { markup } of SCENES) {
        found.push(await tab.run(draw, { markup, base: site.origin }));
      }
      await expectSame(site, found);
    } finally {
      await tab.close();
    }
  });
}
