// Does the packed tarball work where users put it: in a fresh TypeScript project with Vite, and as a copied folder
// on a plain page? Installs from the registry, so it is slow: @release.

import { execSync } from 'node:child_process';
import { cpSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import type { Locator } from '@playwright/test';
import { startSite } from '../support/site.js';
import { allReady, expect, pixelAt, pixels, test } from '../support/test.js';

const repository = fileURLToPath(new URL('../..', import.meta.url));
const manifest = JSON.parse(readFileSync(join(repository, 'package.json'), 'utf8')) as {
  version: string;
  devDependencies: Record<string, string>;
};

const scene =
  '<phong-viewer geometry="sphere" phi="90" theta="0">' +
  '<phong-light position="0 0 1 0" diffuse="255 128 0" specular="0"></phong-light></phong-viewer>';

test.describe('the packed tarball @release', () => {
  test.describe.configure({ mode: 'serial', timeout: 300_000 });
  let folder = '';

  test.beforeAll(() => {
    test.setTimeout(300_000);
    folder = mkdtempSync(join(tmpdir(), 'phong-viewer-pack-'));
    const scripts = '--ignore-scripts --silent';
    execSync(`npm pack ${scripts} --pack-destination ${JSON.stringify(folder)}`, { cwd: repository });
    write('package.json', JSON.stringify({ name: 'fresh', private: true, type: 'module' }));
    const { three, vite, typescript, '@types/three': types } = manifest.devDependencies;
    const wanted = [`three@${three}`, `vite@${vite}`, `typescript@${typescript}`, `@types/three@${types}`];
    const tarball = `./phong-viewer-${manifest.version}.tgz`;
    execSync(
      `npm install --no-audit --no-fund --silent ${tarball} ${wanted.map((name) => `"${name}"`).join(' ')}`,
      {
        cwd: folder,
      },
    );
  });

  test.afterAll(() => rmSync(folder, { recursive: true, force: true }));

  function write(path: string, text: string): void {
    mkdirSync(join(folder, path, '..'), { recursive: true });
    writeFileSync(join(folder, path), text);
  }

  test('gives every entry types that a strict project accepts', () => {
    write(
      'types.ts',
      ['', '/core', '/reference', '/standalone']
        .map(
          (entry, i) =>
            `import * as m${i} from 'phong-viewer${entry}';\nexport const n${i}: object = m${i};\n`,
        )
        .join(''),
    );
    write(
      'tsconfig.json',
      JSON.stringify({
        compilerOptions: {
          strict: true,
          noEmit: true,
          target: 'ES2022',
          module: 'ESNext',
          moduleResolution: 'bundler',
          exactOptionalPropertyTypes: true,
          types: [],
        },
        files: ['types.ts'],
      }),
    );
    execSync('npx tsc -p .', { cwd: folder, stdio: 'inherit' });
  });

  test('draws in a page that Vite built from the fresh project', async ({ page }) => {
    write('main.ts', "import 'phong-viewer';\n");
    write(
      'index.html',
      `<!doctype html><html lang="en"><head><title>Fresh</title><script type="module" src="./main.ts"></script></head>` +
        `<body>${scene}</body></html>`,
    );
    execSync('npx vite build --base ./ --logLevel warn', { cwd: folder, stdio: 'inherit' });
    const site = await startSite({ '/': join(folder, 'dist') });
    await page.goto(`${site.origin}/`);
    await expectOrangeSphere(page.locator('phong-viewer'));
    await site.close();
  });

  test('draws on a plain page from a copy of dist/ in another folder', async ({ page }) => {
    const copy = join(folder, 'site/vendor/viewer');
    cpSync(join(folder, 'node_modules/phong-viewer/dist'), copy, { recursive: true });
    const site = await startSite({ '/some/where/': join(folder, 'site') });
    const head = '<script type="module" src="/some/where/vendor/viewer/phong-viewer.standalone.js"></script>';
    await page.goto(site.page(scene, { head }));
    await expectOrangeSphere(page.locator('phong-viewer'));
    await site.close();
  });
});

async function expectOrangeSphere(viewer: Locator): Promise<void> {
  await viewer.page().evaluate(() => customElements.whenDefined('phong-viewer').then(() => undefined));
  await allReady(viewer.page());
  const [r, g, b, a] = pixelAt(await pixels(viewer, { width: 64, height: 64 }), 32, 32);
  expect(a).toBe(255);
  expect(r).toBeGreaterThan(245);
  expect(Math.abs(g - 128)).toBeLessThan(8);
  expect(b).toBe(0);
}
