// Does the packed tarball work in fresh Nuxt and SvelteKit projects, written as their users write it? Pages are
// rendered at build time and hydrated. Vue omits lists from the markup and sets them when it hydrates, except constant
// ones: those have to be text. Installs from the registry, so it is slow: @release.

import { join } from 'node:path';
import type { PhongLight, PhongViewer } from '../../src/index.js';
import { startSite, type Site } from '../support/site.js';
import { allReady, expect, pixelAt, pixels, test } from '../support/test.js';
import { freshProject, type FreshProject } from './fresh-project.js';

interface Framework {
  readonly name: string;
  readonly packages: readonly string[];
  readonly files: Readonly<Record<string, string>>;
  readonly build: string;
  readonly output: string;
  /** What a server's markup says of the lights. */
  readonly sent: readonly string[];
}

const frameworks: readonly Framework[] = [
  {
    name: 'Nuxt',
    packages: ['nuxt@^3', 'vue@^3'],
    files: {
      'nuxt.config.ts': `
        export default defineNuxtConfig({
          telemetry: false,
          vue: { compilerOptions: { isCustomElement: (tag) => tag.startsWith('phong-') } },
        });
      `,
      'plugins/phong-viewer.client.ts': `
        import 'phong-viewer';
        export default defineNuxtPlugin(() => {});
      `,
      'app.vue': `
        <script setup>
        const light = ref({ active: false, ambient: [0, 0, 255] });
        const moved = ref('nothing');
        </script>
        <template>
          <phong-viewer geometry="sphere" :ka="255" :orbit="false" :gui="false" @camera-change="moved = $event.detail.source">
            <phong-light :active="light.active" :ambient="light.ambient" :diffuse="0" :specular="0" />
            <phong-light ambient="200 100 50" :diffuse="0" :specular="0" />
          </phong-viewer>
          <button @click="light = { active: true, ambient: [20, 30, 40] }">light up</button>
          <output>{{ moved }}</output>
        </template>
      `,
    },
    build: 'npx nuxt generate',
    output: '.output/public',
    sent: [
      '<phong-light active="false" diffuse="0" specular="0">',
      '<phong-light ambient="200 100 50" diffuse="0" specular="0">',
    ],
  },
  {
    name: 'SvelteKit',
    packages: [
      '@sveltejs/kit@^2',
      '@sveltejs/adapter-static@^3',
      '@sveltejs/vite-plugin-svelte@^6',
      'svelte@^5',
      'vite@^7',
    ],
    files: {
      'svelte.config.js': `
        import adapter from '@sveltejs/adapter-static';
        export default { kit: { adapter: adapter() } };
      `,
      'vite.config.js': `
        import { sveltekit } from '@sveltejs/kit/vite';
        export default { plugins: [sveltekit()] };
      `,
      'src/app.html':
        '<!doctype html><html lang="en"><head><link rel="icon" href="data:,">%sveltekit.head%</head>' +
        '<body><div>%sveltekit.body%</div></body></html>',
      'src/routes/+page.js': 'export const prerender = true;',
      'src/routes/+page.svelte': `
        <script>
          import 'phong-viewer';
          let light = $state({ active: false, ambient: [0, 0, 255] });
          let moved = $state('nothing');
        </script>
        <phong-viewer geometry="sphere" ka={255} orbit={false} gui={false} oncamera-change={(event) => (moved = event.detail.source)}>
          <phong-light active={light.active} ambient={light.ambient} diffuse={0} specular={0}></phong-light>
          <phong-light ambient={[200, 100, 50]} diffuse={0} specular={0}></phong-light>
        </phong-viewer>
        <button onclick={() => (light = { active: true, ambient: [20, 30, 40] })}>light up</button>
        <output>{moved}</output>
      `,
    },
    build: 'npx vite build',
    output: 'build',
    sent: [
      '<phong-light active="false" ambient="0,0,255" diffuse="0" specular="0">',
      '<phong-light ambient="200,100,50" diffuse="0" specular="0">',
    ],
  },
];

for (const { name, packages, files, build, output, sent } of frameworks) {
  test.describe(`the packed tarball in a fresh ${name} project @release`, () => {
    test.describe.configure({ mode: 'serial', timeout: 400_000 });
    let project: FreshProject | undefined;
    let site: Site | undefined;

    test.beforeAll(async () => {
      test.setTimeout(400_000);
      project = freshProject(['three', ...packages]);
      for (const [path, text] of Object.entries(files)) project.write(path, text);
      project.run(build);
      // Both start from inline scripts.
      site = await startSite({ '/': join(project.folder, output) }, '');
    });

    test.afterAll(async () => {
      await site?.close();
      project?.remove();
    });

    test('sends false and numbers as text', async ({ request }) => {
      const markup = await (await request.get(`${site!.origin}/`)).text();
      for (const text of sent) expect(markup).toContain(text);
    });

    test('shows, updates and dispatches events after hydration', async ({ page }) => {
      await page.goto(`${site!.origin}/`);
      const viewer = page.locator('phong-viewer');
      const lights = () =>
        viewer.evaluate(({ lights }: PhongViewer) =>
          lights.map(({ active, ambient }: PhongLight) => [active, ambient]),
        );
      await expect.poll(lights).toEqual([
        [false, [0, 0, 255]],
        [true, [200, 100, 50]],
      ]);
      await allReady(page);
      expect(await viewer.evaluate(({ orbit, gui }: PhongViewer) => [orbit, gui])).toEqual([false, false]);
      expect(pixelAt(await pixels(viewer, { width: 60, height: 40 }), 30, 20)).toEqual([200, 100, 50, 255]);

      let theta = 40;
      await expect(async () => {
        await viewer.evaluate((element: PhongViewer, to) => (element.theta = to), ++theta);
        await expect(page.locator('output')).toHaveText('script', { timeout: 500 });
      }).toPass();
      await page.getByText('light up').click();
      await expect.poll(async () => (await lights())[0]).toEqual([true, [20, 30, 40]]);
    });
  });
}
