// Does the packed tarball work in a fresh TypeScript project with Vite and three.js, and in Node? Elements, `core` and
// types; React is absent. Installs from the registry, so it is slow: @release.

import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { PNG } from 'pngjs';
import { startSite } from '../support/site.js';
import { expect, pixelAt, pixels, test } from '../support/test.js';
import { readmeSample, readmeScripts, strictOptions, useFreshProject } from './fresh-project.js';

const scripts = (folder: string): string =>
  readdirSync(join(folder, 'assets'))
    .filter((name) => name.endsWith('.js'))
    .map((name) => readFileSync(join(folder, 'assets', name), 'utf8'))
    .join('\n');

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
  const project = useFreshProject(['three', '@types/three', 'typescript', 'vite']);

  /** Type-checks these files as a bundler and as Node resolve them. */
  function compile(...files: readonly string[]): void {
    for (const [moduleResolution, module] of [
      ['bundler', 'ESNext'],
      ['node16', 'node16'],
    ]) {
      const compilerOptions = { ...strictOptions, moduleResolution, module };
      project().write('tsconfig.json', JSON.stringify({ compilerOptions, files }));
      project().run('npx tsc -p .');
    }
  }

  test('has types that a strict project accepts, with bundler and Node resolution', () => {
    project().write(
      'entries.ts',
      `import * as elements from 'phong-viewer';
      import * as core from 'phong-viewer/core';
      import * as reference from 'phong-viewer/reference';
      import * as standalone from 'phong-viewer/standalone';
      export const entries: readonly object[] = [elements, core, reference, standalone];
      `,
    );
    project().write(
      'typed.ts',
      `import 'phong-viewer';
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
      // @ts-expect-error there is no such geometry
      document.createElement('phong-mesh').geometry = 'cube';
      export const elements: HTMLElement[] = [viewer, document.createElement('phong-light')];
      `,
    );
    compile('entries.ts', 'typed.ts');
  });

  test('types properties by what they accept and by what they return', () => {
    project().write('properties.ts', PROPERTIES);
    compile('properties.ts');
  });

  test('accepts the scripts of the README that import the elements', () => {
    const scripts = readmeScripts();
    expect(scripts.length).toBeGreaterThan(0);
    const files = scripts.map((code, i) => {
      project().write(`readme-${i}.ts`, `${code}\nexport {};\n`);
      return `readme-${i}.ts`;
    });
    compile(...files);
  });

  test('draws in a page that Vite built', async ({ page }) => {
    project().write('main.ts', "import 'phong-viewer';\n");
    const folder = project().build(
      '<script type="module" src="./main.ts"></script>' +
        '<phong-viewer alt="A sphere" geometry="sphere" kd="255" phi="90" theta="0">' +
        '<phong-light position="0 0 1 0" diffuse="255 128 0" specular="0"></phong-light></phong-viewer>',
    );
    await project().open(page, folder);
    const picture = await pixels(page.locator('phong-viewer'), { width: 64, height: 64 });
    const [r, g, b, a] = pixelAt(picture, 32, 32);
    expect([r, b, a]).toEqual([255, 0, 255]);
    expect(Math.abs(g - 128)).toBeLessThanOrEqual(1);
  });

  test('draws in a page that Vite built from the standalone file, lazy parts included', async ({ page }) => {
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
    // three.js itself would have stamped its version there, so the bundle contains only the standalone file's copy.
    expect(await page.evaluate(() => '__THREE__' in window)).toBe(false);
  });

  test('draws with plain three.js as the README says, without elements and without Lit', async ({ page }) => {
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
    expect(scripts(folder)).not.toMatch(/customElements|litHtmlVersions|phong-viewer/);
    await site.close();
  });

  test('bundles only the parts of core that are used', () => {
    project().write(
      'light.js',
      "import { LightState } from 'phong-viewer/core';\nconsole.log(new LightState({ cutoff: 2 }).values);\n",
    );
    const code = scripts(project().build('<script type="module" src="./light.js"></script>'));
    expect(code).not.toMatch(/customElements|litHtmlVersions|WebGLRenderer/);
    // Measured: 20.1 kB, minified.
    expect(code.length).toBeLessThan(20_500);
  });

  test('imports without effect or error in Node', () => {
    const code =
      "for (const e of ['', '/core', '/reference']) await import('phong-viewer' + e); console.log('done')";
    expect(project().run(`node --input-type=module -e ${JSON.stringify(code)}`)).toBe('done\n');
    for (const name of ['custom-elements', 'web-types', 'vscode.html-custom-data']) {
      const read = `import d from 'phong-viewer/${name}.json' with { type: 'json' }; console.log(typeof d)`;
      expect(project().run(`node --no-warnings --input-type=module -e ${JSON.stringify(read)}`)).toBe(
        'object\n',
      );
    }
  });
});
