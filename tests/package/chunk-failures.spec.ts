// What happens when a chunk cannot be fetched? A clear message, and the next use on the same viewer
// fetches it again. For the standalone file and the ES modules.

import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Page } from '@playwright/test';
import { outputFolder } from '../../.ci/output-folder.mjs';
import type { PhongViewer } from '../../src/viewer/index.js';
import { allReady, expect, test } from '../support/test.js';
import { set, statsOf } from '../element/support/viewer.js';
import { usages } from './requests.js';

/** A shape, a method (and a pixel), or a model's address. */
type Use = 'torus' | 'toBlob' | 'shadeAt' | `/${string}`;

/** Runs in the page. Returns the failure's message, or null if it worked. */
async function useIn(viewer: PhongViewer, use: Use) {
  if (use === 'toBlob') return viewer.toBlob({ width: 8, height: 8 }).then(() => null, String);
  if (use === 'shadeAt') {
    return viewer.shadeAt(300, 200).then((hit) => (hit === null ? 'no hit' : null), String);
  }
  const said: string[] = [];
  viewer.addEventListener('error', ({ detail }) => said.push(`${detail.code}: ${detail.message}`), {
    once: true,
  });
  if (use === 'torus') {
    viewer.geometry = use;
  } else {
    viewer.src = use;
  }
  await viewer.ready;
  return viewer.loaded ? null : said.join();
}

/**
 * A chunk or a pattern for several, a use of it, and what the failure is said to be. In this order
 * on one page: a chunk that an earlier use fetched is not fetched again.
 */
const parts: readonly (readonly [chunk: string, use: Use, sentence: RegExp])[] = [
  ['picture-blob', 'toBlob', /The code of toBlob could not be fetched/],
  ['(shade-at|equation)', 'shadeAt', /The code of shadeAt could not be fetched/],
  ['solids', 'torus', /^load-failed: The code of the solid shapes could not be fetched/],
  [
    'model-(content|shared)',
    '/fixtures/models/textured.glb',
    /^load-failed: The code of models could not be fetched/,
  ],
  ['read-obj', '/fixtures/models/quads.obj', /^load-failed: The code .*OBJ.* could not be fetched/],
  [
    'draco(-worker)?',
    '/assets/models/bunny.glb',
    /^load-failed: The Draco decoder.* could not be fetched/,
  ],
];

async function open(page: Page, address: string) {
  await page.goto(address);
  await allReady(page);
}

const scene = '<phong-viewer geometry="box"></phong-viewer>';

for (const usage of ['standalone', 'modules'] as const) {
  test(`a part that failed to load is fetched with its next use (${usage})`, async ({
    page,
    site,
    consoleGuard,
  }) => {
    consoleGuard.allow(/error: Failed to load resource/);
    await open(page, site.page(scene, usages[usage]));
    const viewer = page.locator('phong-viewer');
    for (const [chunk, use, sentence] of parts) {
      const path = new RegExp(`/${chunk}([-.][\\w-]{8})?\\.js`);
      await page.route(path, (route) => route.abort());
      for (let time = 0; time < 2; time++) {
        expect(await viewer.evaluate(useIn, use), chunk).toMatch(sentence);
      }
      await page.unroute(path);
      for (let time = 0; time < 2; time++) {
        expect(await viewer.evaluate(useIn, use), chunk).toBeNull();
      }
    }
  });

  test(`a panel or legend that failed to load is fetched again (${usage})`, async ({
    page,
    site,
    consoleGuard,
  }) => {
    consoleGuard.allow(/error: Failed to load resource/);
    const said = consoleGuard.allow(
      /warning: <phong-viewer>: .*The code of (the control panel|views) could not/,
    );
    await open(page, site.page(scene, usages[usage]));
    const viewer = page.locator('phong-viewer');
    for (const [chunk, values, shown] of [
      [/\/panel/, [{ gui: true }, { gui: true }, { gui: true }], '.lil-root'],
      [/\/legend/, [{ view: 'normals' }, { view: 'decay' }], '.legend:has-text("Decay")'],
    ] as const) {
      await page.route(chunk, (route) => route.abort());
      for (const given of values.slice(0, -1)) {
        const before = said.length;
        await set(viewer, given);
        expect((await statsOf(viewer)).frames).toBeGreaterThan(0);
        await expect.poll(() => said.length).toBeGreaterThan(before);
        await expect(viewer.locator(shown)).toHaveCount(0);
      }
      await page.unroute(chunk);
      await set(viewer, values.at(-1)!);
      await expect(viewer.locator(shown)).toBeVisible();
    }
  });
}

test('a later attempt of the standalone file uses another address', async ({
  page,
  site,
  consoleGuard,
}) => {
  consoleGuard.allow(/error: Failed to load resource/);
  await open(page, site.page(scene, usages.standalone));
  const asked: string[] = [];
  await page.route(/\/picture-blob/, (route) => {
    asked.push(new URL(route.request().url()).search);
    return asked.length < 2 ? route.abort() : route.continue();
  });
  const outcome = await page.locator('phong-viewer').evaluate(async (viewer: PhongViewer) => {
    const blob = () =>
      viewer.toBlob({ width: 8, height: 8 }).then(
        () => 'blob',
        () => 'error',
      );
    return [await blob(), await blob(), await blob()];
  });
  expect(outcome).toEqual(['error', 'blob', 'blob']);
  expect(asked).toEqual(['', '?1']);
});

test('no chunk that a use imports, and imports again after a failure, is also imported statically', () => {
  const folder = join(outputFolder('dist'), 'chunks');
  const files = readdirSync(folder).filter((name) => name.endsWith('.js'));
  const codes = [...files.map((name) => join('chunks', name)), 'phong-viewer.standalone.js'].map(
    (path) => readFileSync(join(outputFolder('dist'), path), 'utf8'),
  );
  const imported = (pattern: RegExp) =>
    new Set(codes.flatMap((code) => [...code.matchAll(pattern)].map(([, name]) => name ?? '')));
  const asParts = imported(/\bfrom\s*["'`]\.\/([^"'`]+)/g);
  // The address of a second attempt: code that is only requested early has none, and its failure is
  // that of its users.
  const asUses = imported(/[`'"]\.\/(?:chunks\/)?([^`'"?]+)\?[`'"]\s*\+/g);
  expect(asUses.size).toBeGreaterThan(7);
  expect([...asUses].filter((name) => asParts.has(name))).toEqual([]);
});
