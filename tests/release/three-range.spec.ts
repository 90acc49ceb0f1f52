// Does the packed tarball work with the oldest and the newest three.js that its peer range allows,
// types included? Few lights (uniforms) and many (a texture), a model with a texture, and an object
// of the page's own. PHONG_VIEWER_THREE=~0.183.0 tries that release instead. Installs from the
// registry, so it is slow: @release.

import { cpSync } from 'node:fs';
import { join } from 'node:path';
import type { PhongViewer } from '../../src/viewer/index.js';
import { expect, pixelAt, pixels, test } from '../support/test.js';
import { manifest, strictOptions, useFreshProject } from './fresh-project.js';
import { repository } from '../support/repository.mjs';

/** Light number `i` of many: all light up a plane seen from above. */
const lamp = (_: unknown, i: number) =>
  `<phong-light position="${(i % 20) - 10} 3 ${(i >> 4) - 10} 1" diffuse="${i % 7} 9 ${i % 5}" specular="1" attenuation="1 0.3 0.1"></phong-light>`;

const many = Array.from({ length: 300 }, lamp).join('');

const body = `
<script type="module" src="./main.ts"></script>
<phong-viewer id="few" geometry="plane" theta="0" phi="20" shininess="20">
  <phong-light position="1 2 1 1" ambient="20 10 5" diffuse="90 120 150" attenuation="1 0.1 0.1"></phong-light>
  <phong-light position="0 2 0 1" axis="0 -1 0" aperture="40" cutoff="3" diffuse="60 90 30"></phong-light>
</phong-viewer>
<phong-viewer id="many" geometry="plane" theta="0" phi="20">${many}</phong-viewer>
<phong-viewer id="model" src="./model.glb" theta="0" phi="90"></phong-viewer>
<phong-viewer id="own" theta="0" phi="90" radius="4"></phong-viewer>
`;

const main = `
import 'phong-viewer';
import { LightSet, LightState, PhongLighting, PhongMaterial } from 'phong-viewer/core';
import { DoubleSide, Mesh, MeshBasicMaterial, PlaneGeometry, REVISION, type Scene } from 'three';

const scene: Scene = document.querySelector<HTMLElementTagNameMap['phong-viewer']>('#own')!.scene;
scene.add(new Mesh(new PlaneGeometry(2, 2), new MeshBasicMaterial({ color: 0x3366cc, side: DoubleSide })));
Object.assign(window, { revision: REVISION, core: [LightSet, LightState, PhongLighting, PhongMaterial] });
`;

const range = manifest.peerDependencies['three']!;
const oldest = /^>=(\d+\.\d+\.\d+) /.exec(range)![1]!;

/** Pixels that are compared with `shadeAt`. */
const PLACES = [[150, 75], [140, 60], [165, 85]] as const; // oxfmt-ignore

const asked = process.env['PHONG_VIEWER_THREE'];

for (const version of asked === undefined ? [oldest, range] : [asked]) {
  // Older types contradict those of TypeScript 6 about WebGPU.
  const minor = /^~?0\.(\d+)/.exec(version)?.[1];
  const typescript = minor !== undefined ? 'typescript@~5.9' : 'typescript';
  test.describe(`with three.js ${version}, which is allowed, the packed tarball @release`, () => {
    const project = useFreshProject(
      [`three@${version}`, `@types/three@${version}`, typescript, 'vite'],
      ({ folder, write }) => {
        cpSync(
          join(repository, 'tests/fixtures/models/textured.glb'),
          join(folder, 'public/model.glb'),
        );
        write('main.ts', main);
      },
    );

    test('has types that a strict project accepts', () => {
      const compilerOptions = { ...strictOptions, lib: ['ES2022', 'DOM', 'DOM.Iterable'] };
      project().write('tsconfig.json', JSON.stringify({ compilerOptions, files: ['main.ts'] }));
      project().run('npx tsc -p .');
    });

    test('draws the equation, models and objects of the page', async ({ page }) => {
      await project().open(page, project().build(body));
      const revision = await page.evaluate(() => Reflect.get(window, 'revision') as string);
      if (minor !== undefined) {
        expect(revision).toBe(minor);
      }

      for (const id of ['few', 'many', 'model']) {
        const viewer = page.locator(`#${id}`);
        const [width, height] = [300, 150];
        const check = async () => {
          const picture = await pixels(viewer, { width, height });
          for (const [x, y] of PLACES) {
            const color = await viewer.evaluate(
              async (element: PhongViewer, [x, y]) =>
                (await element.shadeAt(x + 0.5, y + 0.5))?.color,
              [x, y] as const,
            );
            const codes = pixelAt(picture, x, y);
            for (const [i, share] of color!.entries()) {
              expect(Math.abs(codes[i]! - 255 * share), `${id} at ${x}, ${y}`).toBeLessThanOrEqual(
                1,
              );
            }
          }
        };
        await check();
        await viewer.evaluate((element: PhongViewer) => {
          for (const light of element.lights) {
            light.diffuse = [10, 5, 9];
          }
        });
        await check();
      }
      const own = await pixels(page.locator('#own'), { width: 300, height: 150 });
      expect(pixelAt(own, 150, 75)).toEqual([0x33, 0x66, 0xcc, 255]);
    });
  });
}
