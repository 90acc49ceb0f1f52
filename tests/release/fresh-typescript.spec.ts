// Does the packed tarball work in a fresh TypeScript project with Vite and three.js? Elements,
// `core` and types; React is absent. arethetypeswrong and publint judge it too. Installs from the
// registry, so it is slow: @release.

import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { PNG } from 'pngjs';
import { startSite } from '../support/site.js';
import { expect, pixels, test } from '../support/test.js';
import { readmeSample, readmeScripts, strictOptions, useFreshProject } from './fresh-project.js';

const ENTRIES = `
import * as elements from 'phong-viewer';
import * as core from 'phong-viewer/core';
import * as reference from 'phong-viewer/reference';
import * as standalone from 'phong-viewer/standalone';
export const entries: readonly object[] = [elements, core, reference, standalone];
`;

const EVENTS = `
import 'phong-viewer';
const viewer = document.querySelector('phong-viewer')!;
viewer.addEventListener('camera-change', (event) => {
  const source: 'pointer' | 'wheel' | 'key' | 'panel' | 'script' | 'auto' = event.detail.source;
  console.log(source, event.currentTarget);
});
viewer.addEventListener('error', (event) => console.log(event.detail.code === 'csp', event.detail.url?.length));
viewer.addEventListener('light-change', function (event) {
  this.theta += event.detail.lights[0]?.aperture ?? 0;
});
viewer.addEventListener('click', (event) => console.log(event.clientX));
viewer.addEventListener('anything', (event: Event) => console.log(event.type), { once: true });
viewer.meshes[0]?.addEventListener('load', (event) => console.log(event.detail.url));
// @ts-expect-error there is no such source
viewer.addEventListener('camera-change', (event) => event.detail.source === 'mouse');
export const elements: HTMLElement[] = [viewer, document.createElement('phong-light')];
`;

const PROPERTIES = `
import type { PhongLight, PhongMesh, PhongViewer, Vec3, Vec4 } from 'phong-viewer';

export function accepted(light: PhongLight, mesh: PhongMesh, viewer: PhongViewer): void {
  light.diffuse = '#fc8';
  light.diffuse = 200;
  light.diffuse = [255, 204, 136];
  light.diffuse = new Float32Array([255, 204, 136]);
  light.diffuse = null;
  light.name = undefined;
  light.position = [1, 2, 3];
  light.position = [1, 2, 3, 0];
  light.position = '1 2 3';
  const place: number[] = [1, 2, 3];
  light.position = place;
  light.aperture = '20';
  light.active = 'false';
  light.space = null;
  mesh.scale = 2;
  mesh.geometry = 'torus-knot';
  mesh.shading = null;
  viewer.radius = 'auto';
  viewer.target = place;
  viewer.terms = ['ambient', 'diffuse'];
  viewer.terms = 'ambient diffuse';
  viewer.gui = true;
  viewer.crossOrigin = 'anonymous';
  viewer.requestRender();
  viewer.refit();
}

export function returned(light: PhongLight, mesh: PhongMesh, viewer: PhongViewer): readonly unknown[] {
  light.diffuse = '#fc8';
  const diffuse: Vec3 = light.diffuse;
  light.position = [1, 2, 3];
  const position: Vec4 = light.position;
  light.active = 'false';
  const active: boolean = light.active;
  light.aperture = null;
  const aperture: number = light.aperture;
  mesh.scale = 2;
  const scale: Vec3 = mesh.scale;
  const radius: number | 'auto' = viewer.radius;
  const terms: readonly ('ambient' | 'diffuse' | 'specular')[] = viewer.terms;
  const name: string = light.name;
  return [diffuse, position, active, aperture, scale, radius, terms, name];
}

export function refused(light: PhongLight, mesh: PhongMesh, viewer: PhongViewer): void {
  // @ts-expect-error one number is no position
  light.position = 1;
  // @ts-expect-error an angle is no flag
  light.aperture = true;
  // @ts-expect-error there is no such space
  light.space = 'screen';
  // @ts-expect-error there is no such geometry
  mesh.geometry = 'cube';
  // @ts-expect-error there is no such term
  viewer.terms = ['emissive'];
  // @ts-expect-error lists that are returned are frozen
  light.diffuse[0] = 1;
  // @ts-expect-error the camera is read-only
  viewer.camera.theta = 1;
  // @ts-expect-error what only the package needs is not in the types
  void viewer.state;
  // @ts-expect-error nor is this
  void light.declared;
  // @ts-expect-error nor this
  viewer.moveFrom('panel', () => undefined);
}
`;

test.describe('the packed tarball in a fresh TypeScript project @release', () => {
  const judges = ['@arethetypeswrong/cli@^0.18', 'publint@^0.3'];
  const project = useFreshProject(['three', '@types/three', 'typescript', 'vite', ...judges]);

  test('has no wrong types, except that require() gets ES modules, and a manifest without fault', () => {
    project().run('npx attw phong-viewer-*.tgz --ignore-rules cjs-resolves-to-esm');
    project().run('npx publint run phong-viewer-*.tgz --strict');
  });

  test('has types that a strict project accepts, also in the scripts of the README', () => {
    project().write('entries.ts', ENTRIES);
    project().write('typed.ts', EVENTS);
    project().write('properties.ts', PROPERTIES);
    const scripts = readmeScripts();
    expect(scripts.length).toBeGreaterThan(0);
    scripts.forEach((code, i) =>
      project().write(`readme-${i}.ts`, `import 'phong-viewer';\n${code}\n`),
    );
    const files = [
      'entries.ts',
      'typed.ts',
      'properties.ts',
      ...scripts.map((_, i) => `readme-${i}.ts`),
    ];
    // As a bundler and as Node resolve them.
    for (const [moduleResolution, module] of [
      ['bundler', 'ESNext'],
      ['node16', 'node16'],
    ]) {
      const compilerOptions = { ...strictOptions, moduleResolution, module };
      project().write('tsconfig.json', JSON.stringify({ compilerOptions, files }));
      project().run('npx tsc -p .');
    }
  });

  test('draws in a page that Vite built from the standalone file, lazy parts included', async ({
    page,
  }) => {
    project().write('standalone.ts', "import 'phong-viewer/standalone';\n");
    const folder = project().build(
      '<script type="module" src="./standalone.ts"></script>' +
        '<phong-viewer alt="A torus" geometry="torus" gui><phong-light name="sun"></phong-light></phong-viewer>',
    );
    await project().open(page, folder);
    const viewer = page.locator('phong-viewer');
    const { data } = await pixels(viewer, { width: 64, height: 64 });
    expect(data.some((code, i) => i % 4 === 3 && code === 255)).toBe(true);
    await expect(viewer.getByText('sun').first()).toBeAttached();
    // three.js itself would have stamped its version there, so the bundle contains only the
    // standalone file's copy.
    expect(await page.evaluate(() => '__THREE__' in window)).toBe(false);
  });

  test('draws with plain three.js as the README says, without elements and without Lit', async ({
    page,
  }) => {
    project().write('core.js', readmeSample('With plain three.js'));
    const folder = project().build(
      '<canvas width="300" height="200"></canvas><script type="module" src="./core.js"></script>',
    );
    const site = await startSite({ '/': folder });
    await page.goto(`${site.origin}/`);
    const png = PNG.sync.read(await page.locator('canvas').screenshot());
    const middle = 4 * (100 * png.width + 150);
    const [r = 0, g = 0, b = 0] = png.data.subarray(middle, middle + 3);
    expect(r).toBeGreaterThan(60);
    expect(r).toBeGreaterThan(2 * Math.max(g, b));
    const built = readdirSync(join(folder, 'assets')).filter((name) => name.endsWith('.js'));
    const code = built.map((name) => readFileSync(join(folder, 'assets', name), 'utf8')).join('\n');
    expect(code).not.toMatch(/customElements|litHtmlVersions|phong-viewer/);
    await site.close();
  });
});
