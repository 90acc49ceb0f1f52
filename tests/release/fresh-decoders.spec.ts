// Do users' bundlers build the workers that unpack Draco and KTX2, and does the model show where
// they do not? The packed tarball in fresh projects. Installs from the registry, so it is slow:
// @release.

import { cpSync, mkdirSync } from 'node:fs';
import { join } from 'node:path';
import type { Page } from '@playwright/test';
import { expect, test } from '../support/test.js';
import type { PhongViewer } from '../element/support/viewer.js';
import { pageOf, useFreshProject } from './fresh-project.js';
import { repository } from '../support/repository.mjs';

const body =
  '<script type="module" src="./main.js"></script>' +
  '<phong-viewer alt="A bunny" src="bunny.glb"></phong-viewer><phong-viewer alt="A picture" src="ktx2.glb"></phong-viewer>';
const index = pageOf(body);

/**
 * Which models the page shows, and how many workers it has for them. Draco's is only where
 * WebAssembly is.
 */
async function shown(page: Page) {
  const loaded = await page.evaluate(async () => {
    await customElements.whenDefined('phong-viewer');
    const viewers = [...document.querySelectorAll<PhongViewer>('phong-viewer')];
    await Promise.all(viewers.map((viewer) => viewer.ready));
    return viewers.map((viewer) => viewer.loaded);
  });
  return { loaded, workers: page.workers().length };
}

test.describe('the decoders of the packed tarball @release', () => {
  const project = useFreshProject(
    [
      'three',
      'vite',
      'rollup@^4',
      '@rollup/plugin-node-resolve@^16',
      'webpack@^5',
      'webpack-cli@^6',
    ],
    ({ folder, write }) => {
      write('main.js', "import 'phong-viewer';\n");
      mkdirSync(join(folder, 'public'));
      for (const path of ['demo/assets/models/bunny.glb', 'tests/fixtures/models/ktx2.glb']) {
        cpSync(join(repository, path), join(folder, 'public', path.replace(/.*\//, '')));
      }
    },
  );

  test('run in workers that Vite built', async ({ page }) => {
    await project().open(page, project().build(body), '');
    expect(await shown(page)).toEqual({ loaded: [true, true], workers: 2 });
  });

  test("run in Vite's development server", async ({ page, consoleGuard }) => {
    project().write('index.html', index);
    // Vite's own command prints the address in colours.
    project().write(
      'serve.js',
      "import { createServer } from 'vite'; const server = await createServer({ server: { port: 0 } }); await server.listen(); console.log(`http://localhost:${server.httpServer.address().port}`);",
    );
    consoleGuard.allow(/Lit is in dev mode/);
    consoleGuard.allow(/\[vite\]/);
    await page.goto(await project().serve('../serve.js', []));
    expect(await shown(page)).toEqual({ loaded: [true, true], workers: 2 });
  });

  test('run in workers that webpack built', async ({ page, consoleGuard }) => {
    consoleGuard.allow(/Lit is in dev mode/);
    project().write(
      'webpack.config.js',
      "export default { mode: 'development', devtool: false, entry: './main.js', performance: { hints: false }, output: { path: import.meta.dirname + '/public', filename: 'main.js' } };",
    );
    project().run('npx webpack');
    project().write('public/index.html', index);
    await project().open(page, join(project().folder, 'public'), '');
    expect(await shown(page)).toEqual({ loaded: [true, true], workers: 2 });
  });

  test('run on the main thread where Rollup left the workers out, but for KTX2', async ({
    page,
    consoleGuard,
  }) => {
    consoleGuard.allow(/404/);
    project().run(
      'npx rollup main.js --dir rolled --format es --plugin node-resolve --silent && cp public/*.glb rolled/',
    );
    project().write('rolled/index.html', index);
    await project().open(page, join(project().folder, 'rolled'), '');
    // The transcoder's WebAssembly is left out too.
    expect(await shown(page)).toEqual({ loaded: [true, false], workers: 0 });
  });
});
