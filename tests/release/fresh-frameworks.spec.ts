// Does the packed tarball work in fresh projects with Vue, Svelte, Solid, React, Angular, Nuxt,
// SvelteKit, Next and Astro, written as their users write it? Templates are type-checked, mistakes
// in them are errors, and the built page sets values and hears events. The last five render pages
// at build time and hydrate them; Vue omits lists from that markup and sets them when it hydrates,
// except constant ones: those have to be text. Installs from the registry, so it is slow: @release.

import { readFileSync, rmSync } from 'node:fs';
import { join } from 'node:path';
import type { PhongLight, PhongViewer } from '../../src/viewer/index.js';
import { allReady, expect, pixelAt, pixels, strictPolicy, test } from '../support/test.js';
import { pageOf, readmeSample, strictOptions, useFreshProject } from './fresh-project.js';

interface Framework {
  readonly name: string;
  readonly packages: readonly string[];
  readonly files: Readonly<Record<string, string>>;
  /** Type-checks the project. */
  readonly check?: string;
  /** A template where each line with `id="wrong"` has one mistake, and no other line has any. */
  readonly mistakes?: { readonly path: string; readonly text: string };
  readonly build: string;
  readonly output: string;
  /** Pages are rendered at build time: what their markup says of the lights. */
  readonly sent?: readonly string[];
}

const appOf = (script: string) =>
  pageOf(`<div id="app"></div><script type="module" src="${script}"></script>`);

const vite = ['three', '@types/three', 'typescript', 'vite'];

const typescript = (options: object, more: object = {}) =>
  JSON.stringify({ compilerOptions: { ...strictOptions, ...options }, include: ['src'], ...more });

const vue: Framework = {
  name: 'Vue',
  packages: [...vite, 'vue@^3.5', '@vitejs/plugin-vue@^6', 'vue-tsc@^3'],
  files: {
    'vite.config.js': `
      import vue from '@vitejs/plugin-vue';
      const isCustomElement = (tag) => tag.startsWith('phong-');
      export default { plugins: [vue({ template: { compilerOptions: { isCustomElement } } })] };
    `,
    'tsconfig.json': typescript(
      { jsx: 'preserve', skipLibCheck: true },
      { vueCompilerOptions: { strictTemplates: true } },
    ),
    'index.html': appOf('/src/main.ts'),
    'src/main.ts': `
      import { createApp } from 'vue';
      import App from './App.vue';
      createApp(App).mount('#app');
    `,
    'src/App.vue': `
      <script setup lang="ts">
      import 'phong-viewer';
      import type { PhongViewer } from 'phong-viewer';
      import { ref, useTemplateRef } from 'vue';
      const light = ref({ active: false, ambient: [0, 0, 255] });
      const moved = ref('nothing');
      const viewer = useTemplateRef<PhongViewer>('viewer');
      </script>
      <template>
        <phong-viewer
          ref="viewer" class="picture" aria-label="A sphere" geometry="sphere" :ka="255" :orbit="false"
          color-interpolation="linear" radius="auto" :terms="['ambient']"
          @camera-change="moved = $event.detail.source + ' to ' + viewer!.camera.theta" @click="(event) => event.clientX"
        >
          <phong-light key="a" :active="light.active" :ambient="light.ambient" :diffuse="0" :specular="0" />
          <phong-light :ambient="[200, 100, 50]" diffuse="#000" :specular="0" />
        </phong-viewer>
        <button @click="light = { active: true, ambient: [20, 30, 40] }">light up</button>
        <output>{{ moved }}</output>
      </template>
    `,
  },
  check: 'npx vue-tsc -p . --pretty false',
  mistakes: {
    path: 'src/Mistakes.vue',
    text: `
      <script setup lang="ts">
      import 'phong-viewer';
      </script>
      <template>
        <phong-viewer id="wrong" :theta="true" />
        <phong-mesh id="wrong" geometry="cube" />
        <phong-mesh id="wrong" :position="2" />
        <phong-light id="wrong" :strength="2" />
        <phong-light id="wrong" :aperture="null" />
        <phong-viewer id="wrong" @camera-change="(event: MouseEvent) => event" />
        <phong-mesh id="right" :scale="2" rotation="0 10 0" @load="(event) => event.detail.url" style="width: 9px" title="A mesh" />
        <phong-viewer id="right" :autoRotate="5" :crossOrigin="'anonymous'" />
        <phong-viewer id="right" radius="auto" :target="[0, 1, 2]" gui auto-rotate="5" crossorigin="anonymous" />
      </template>
    `,
  },
  build: 'npx vite build --logLevel warn',
  output: 'dist',
};

const svelte: Framework = {
  name: 'Svelte',
  packages: [...vite, 'svelte@^5', '@sveltejs/vite-plugin-svelte@^7', 'svelte-check@^4'],
  files: {
    'vite.config.js': `
      import { svelte } from '@sveltejs/vite-plugin-svelte';
      export default { plugins: [svelte()] };
    `,
    'tsconfig.json': typescript({ verbatimModuleSyntax: true, skipLibCheck: true }),
    'index.html': appOf('/src/main.ts'),
    'src/main.ts': `
      import { mount } from 'svelte';
      import App from './App.svelte';
      mount(App, { target: document.getElementById('app')! });
    `,
    'src/App.svelte': `
      <script lang="ts">
        import 'phong-viewer';
        import type { PhongViewer } from 'phong-viewer';
        let light = $state({ active: false, ambient: [0, 0, 255] });
        let moved = $state('nothing');
        let viewer: PhongViewer;
      </script>
      <phong-viewer
        bind:this={viewer} class="picture" aria-label="A sphere" geometry="sphere" ka={255} orbit={false}
        color-interpolation="linear" radius="auto" terms={['ambient']}
        oncamera-change={({ detail }) => (moved = detail.source + ' to ' + viewer.camera.theta)} onfocusin={(event) => event.relatedTarget}
      >
        <phong-light active={light.active} ambient={light.ambient} diffuse={0} specular={0}></phong-light>
        <phong-light ambient={[200, 100, 50]} diffuse="#000" specular={0}></phong-light>
      </phong-viewer>
      <button onclick={() => (light = { active: true, ambient: [20, 30, 40] })}>light up</button>
      <output>{moved}</output>
    `,
  },
  check: 'npx svelte-check --output machine --fail-on-warnings',
  mistakes: {
    path: 'src/Mistakes.svelte',
    text: `
      <script lang="ts">
        import 'phong-viewer';
      </script>
      <phong-viewer id="wrong" theta={true}></phong-viewer>
      <phong-mesh id="wrong" geometry="cube"></phong-mesh>
      <phong-mesh id="wrong" position={2}></phong-mesh>
      <phong-light id="wrong" strength={2}></phong-light>
      <phong-viewer id="wrong" oncamera-change={(event: MouseEvent) => event}></phong-viewer>
      <phong-mesh id="right" scale={2} rotation="0 10 0" onload={(event) => event.detail.url} data-kind="x" style="width: 9px"></phong-mesh>
      <phong-viewer id="right" radius="auto" target={[0, 1, 2]} gui autoRotate={5} auto-rotate={5} crossorigin="anonymous" fov={null}></phong-viewer>
    `,
  },
  build: 'npx vite build --logLevel warn',
  output: 'dist',
};

const solid: Framework = {
  name: 'Solid',
  packages: [...vite, 'solid-js@^1.9', 'vite-plugin-solid@^2'],
  files: {
    'vite.config.js': `
      import solid from 'vite-plugin-solid';
      export default { plugins: [solid()] };
    `,
    'tsconfig.json': typescript({ jsx: 'preserve', jsxImportSource: 'solid-js' }),
    'index.html': appOf('/src/main.tsx'),
    'src/main.tsx': `
      import 'phong-viewer';
      import type { PhongViewer } from 'phong-viewer';
      import { createSignal } from 'solid-js';
      import { render } from 'solid-js/web';

      function App() {
        const [light, setLight] = createSignal({ active: false, ambient: [0, 0, 255] });
        const [moved, setMoved] = createSignal('nothing');
        let viewer!: PhongViewer;
        return (
          <>
            <phong-viewer
              ref={viewer} class="picture" aria-label="A sphere" geometry="sphere" ka={255} orbit={false}
              color-interpolation="linear" radius="auto" terms={['ambient']}
              on:camera-change={({ detail }) => setMoved(detail.source + ' to ' + viewer.camera.theta)} onClick={(event) => event.clientX}
            >
              <phong-light active={light().active} ambient={light().ambient} diffuse={0} specular={0} />
              <phong-light ambient={[200, 100, 50]} diffuse="#000" specular={0} />
            </phong-viewer>
            <button onClick={() => setLight({ active: true, ambient: [20, 30, 40] })}>light up</button>
            <output>{moved()}</output>
          </>
        );
      }

      render(() => <App />, document.getElementById('app')!);
    `,
  },
  check: 'npx tsc -p . --pretty false',
  mistakes: {
    path: 'src/Mistakes.tsx',
    text: `
      import 'phong-viewer';
      export const list = [
        <phong-viewer id="wrong" theta={true} />,
        <phong-mesh id="wrong" geometry="cube" />,
        <phong-mesh id="wrong" position={2} />,
        <phong-light id="wrong" strength={2} />,
        <phong-viewer id="wrong" autoRotate={5} />,
        <phong-viewer id="wrong" onLoad={() => undefined} />,
        <phong-viewer id="wrong" on:camera-change={(event: MouseEvent) => event} />,
        <phong-mesh id="right" scale={2} rotation="0 10 0" on:load={(event) => event.detail.url} data-kind="x" style="width: 9px" />,
        <phong-viewer id="right" radius="auto" target={[0, 1, 2]} gui auto-rotate={5} prop:autoRotate={5} attr:crossorigin="anonymous" fov={null} />,
      ];
    `,
  },
  build: 'npx vite build --logLevel warn',
  output: 'dist',
};

const react: Framework = {
  name: 'React',
  packages: [...vite, 'react@^19', 'react-dom@^19', '@types/react', '@types/react-dom@^19'],
  files: {
    'tsconfig.json': typescript({ jsx: 'react-jsx', allowJs: true, checkJs: true }),
    'index.html': appOf('/src/main.tsx'),
    'src/readme.jsx': readmeSample('React, Next'),
    'src/main.tsx': `
      import { StrictMode, useRef, useState } from 'react';
      import { createRoot } from 'react-dom/client';
      import 'phong-viewer';
      import type { PhongLightProps, PhongViewer } from 'phong-viewer';

      const unlit: PhongLightProps = { active: false, ambient: [0, 0, 255], diffuse: 0, specular: '0' };

      function App() {
        const viewer = useRef<PhongViewer>(null);
        const [light, setLight] = useState(unlit);
        const [moved, setMoved] = useState('nothing');
        return (
          <>
            <phong-viewer
              ref={viewer} className="picture" aria-label="A sphere" geometry="sphere" ka={255} orbit={false}
              color-interpolation="linear" radius="auto" terms={['ambient']}
              oncamera-change={({ detail }) => setMoved(detail.source + ' to ' + viewer.current?.camera.theta)}
            >
              <phong-light {...light} />
              <phong-light ambient={[200, 100, 50]} diffuse="#000" specular={0} />
            </phong-viewer>
            <button onClick={() => setLight({ ambient: [20, 30, 40] })}>light up</button>
            <output>{moved}</output>
          </>
        );
      }

      createRoot(document.getElementById('app')!).render(<StrictMode><App /></StrictMode>);
    `,
  },
  check: 'npx tsc -p . --pretty false',
  mistakes: {
    path: 'src/Mistakes.tsx',
    text: `
      import 'phong-viewer';
      import type { PhongViewer as Element } from 'phong-viewer';
      import { PhongCompare, PhongLight, PhongMesh, PhongViewer, type PhongViewerElement, type PhongViewerProps } from 'phong-viewer/react';
      import { createRef } from 'react';
      export const elements = [
        <phong-viewer id="wrong" theta={true} />,
        <phong-mesh id="wrong" geometry="cube" />,
        <phong-mesh id="wrong" position={2} />,
        <phong-viewer id="wrong" onLoad={() => undefined} />,
        <phong-light id="wrong" strength={2} />,
        <phong-viewer id="wrong" oncamera-change={(event: MouseEvent) => event} />,
        <phong-mesh scale={2} rotation="0 10 0" ka={128} onload={(event) => event.detail.url} aria-hidden />,
        <phong-viewer radius="auto" target={[0, 1, 2]} terms={['ambient']} crossOrigin={null} color-interpolation="linear" />,
        <phong-viewer helpers={['lights', 'grid']} view="n-dot-l" view-light="sun" probe probe-at="0 0 1" onprobe-change={(event) => event.detail.pinned} />,
        <phong-compare at={40} labels="Gouraud, Phong" ondivider-change={(event) => event.detail.at} />,
        <phong-control for="a" attribute="cutoff" component="x" max={60} type="slider">label</phong-control>,
        <phong-light position={[1, 2, 3]} active="false" space="camera" aperture={undefined} />,
      ];
      const viewer = createRef<PhongViewerElement>();
      const same: Element | null = viewer.current;
      const props: PhongViewerProps = { radius: 'auto', target: [0, 1, 2], terms: ['ambient'], crossOrigin: null };
      export const components = [
        <PhongLight id="wrong" strength={2} />,
        <PhongViewer id="wrong" onCameraChange={(event: MouseEvent) => event} />,
        <PhongCompare id="wrong" layout="grid" />,
        <PhongMesh id="wrong" onCameraChange={() => undefined} />,
        <PhongViewer id="wrong" ref={createRef<HTMLInputElement>()} />,
        <PhongViewer
          {...props} ref={viewer} key={1} className="wide" style={{ width: 10 }} data-kind="x" aria-label="A box" gui
          onCameraChange={(event) => event.detail.source === 'pointer'} onLightChange={({ detail }) => detail.lights.length}
          onLoad={({ detail }) => detail.url} onError={({ detail }) => detail.code}
          onProgress={({ detail }) => detail.totalProgress} onRender={() => same} onClick={(event) => event.clientX}
        >
          text <PhongLight position={[1, 2, 3]} active={false} diffuse={new Uint8Array(3)} space="camera" aperture={undefined} />
        </PhongViewer>,
        <PhongCompare at={[25, 50]} layout="side" onDividerChange={({ detail }) => detail.at}>
          <PhongViewer helpers="lights" view="normals" probe probeAt={[0, 0, 1]} onProbeChange={({ detail }) => detail.pinned} />
        </PhongCompare>,
        <PhongMesh scale={2} rotation="0 10 0" ka={128} onLoad={(event) => event.detail.url} auto-focus />,
      ];
    `,
  },
  build: 'npx vite build --logLevel warn',
  output: 'dist',
};

const angular: Framework = {
  name: 'Angular',
  packages: [
    'three',
    '@types/three',
    'typescript@~5.9',
    'rxjs@^7',
    'tslib@^2',
    // Angular 22 and later need Node 22.
    ...['core', 'common', 'compiler', 'compiler-cli', 'platform-browser', 'build', 'cli'].map(
      (name) => `@angular/${name}@^21`,
    ),
  ],
  files: {
    'angular.json': `{ "version": 1, "cli": { "analytics": false }, "projects": { "fresh": {
      "projectType": "application", "root": "", "sourceRoot": "src", "architect": { "build": {
        "builder": "@angular/build:application",
        "options": {
          "browser": "src/main.ts", "index": "src/index.html", "tsConfig": "tsconfig.json",
          "optimization": { "scripts": true, "styles": false, "fonts": false }
        }
      } }
    } } }`,
    'tsconfig.json': JSON.stringify({
      compilerOptions: { ...strictOptions, noEmit: false, experimentalDecorators: true },
      angularCompilerOptions: { strictTemplates: true },
      files: ['src/main.ts'],
    }),
    'src/index.html': pageOf('<app-root></app-root>'),
    'src/main.ts': `
      import 'phong-viewer';
      import type { PhongViewer } from 'phong-viewer';
      import { Component, CUSTOM_ELEMENTS_SCHEMA, type ElementRef, signal, viewChild } from '@angular/core';
      import { bootstrapApplication } from '@angular/platform-browser';

      @Component({
        selector: 'app-root',
        schemas: [CUSTOM_ELEMENTS_SCHEMA],
        template: \`
          <phong-viewer
            #viewer class="picture" aria-label="A sphere" geometry="sphere" [ka]="255" [orbit]="false"
            color-interpolation="linear" radius="auto" [terms]="['ambient']" (camera-change)="hear($event)"
          >
            <phong-light [active]="light().active" [ambient]="light().ambient" [diffuse]="0" [specular]="0" />
            <phong-light [ambient]="[200, 100, 50]" diffuse="#000" [specular]="0" />
          </phong-viewer>
          <button (click)="light.set({ active: true, ambient: [20, 30, 40] })">light up</button>
          <output>{{ moved() }}</output>
        \`,
      })
      class App {
        readonly light = signal({ active: false, ambient: [0, 0, 255] });
        readonly moved = signal('nothing');
        readonly viewer = viewChild.required<ElementRef<PhongViewer>>('viewer');
        hear({ detail }: CustomEvent<{ readonly source: string }>): void {
          this.moved.set(detail.source + ' to ' + this.viewer().nativeElement.camera.theta);
        }
      }

      void bootstrapApplication(App);
    `,
  },
  check: 'npx ngc -p . --noEmit',
  build: 'npx ng build',
  output: 'dist/fresh/browser',
};

const nuxt: Framework = {
  name: 'Nuxt',
  packages: ['three', 'nuxt@^3', 'vue@^3'],
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
        <phong-viewer class="picture" geometry="sphere" :ka="255" :orbit="false" :gui="false" @camera-change="moved = $event.detail.source + ' to ' + $event.target.theta">
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
};

const svelteKit: Framework = {
  name: 'SvelteKit',
  packages: [
    'three',
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
      <phong-viewer class="picture" geometry="sphere" ka={255} orbit={false} gui={false} oncamera-change={(event) => (moved = event.detail.source + ' to ' + event.target.theta)}>
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
};

/** A component for the frameworks that render React's on a server. */
const reactApp = `
'use client';
import { type ReactNode, useRef, useState } from 'react';
import { PhongLight, PhongViewer, type PhongViewerElement } from 'phong-viewer/react';

export default function App({ children }: { readonly children?: ReactNode }) {
  const viewer = useRef<PhongViewerElement>(null);
  const [light, setLight] = useState({ active: false, ambient: [0, 0, 255] });
  const [moved, setMoved] = useState('nothing');
  return (
    <main>
      <PhongViewer
        ref={viewer} className="picture" aria-label="A sphere" geometry="sphere" ka={255} orbit={false} gui={false}
        onCameraChange={({ detail }) => setMoved(detail.source + ' to ' + viewer.current?.camera.theta)}
      >
        <PhongLight active={light.active} ambient={light.ambient} diffuse={0} specular={0} />
        {children}
      </PhongViewer>
      <button onClick={() => setLight({ active: true, ambient: [20, 30, 40] })}>light up</button>
      <output>{moved}</output>
    </main>
  );
}
`;

const sentByReact = [
  '<phong-light active="false" ambient="0 0 255" diffuse="0" specular="0">',
  '<phong-light ambient="200 100 50" diffuse="0" specular="0 0 0">',
];

const oldestReact: Framework = {
  name: 'React 18',
  packages: [
    ...vite,
    'react@18.0.0',
    'react-dom@18.0.0',
    '@types/react@^18',
    '@types/react-dom@^18',
  ],
  files: {
    'tsconfig.json': typescript({ jsx: 'react-jsx' }),
    'src/App.tsx': reactApp,
    'src/page.tsx': `
      import { PhongLight } from 'phong-viewer/react';
      import App from './App';
      export const page = <App><PhongLight ambient={[200, 100, 50]} diffuse={0} specular={[0, 0, 0]} /></App>;
    `,
    'src/server.tsx': `
      import { renderToString } from 'react-dom/server';
      import { page } from './page';
      const html = ${JSON.stringify(appOf('/src/client.tsx'))};
      console.log(html.replace('></div>', '>' + renderToString(page) + '</div>'));
    `,
    'src/client.tsx': `
      import { hydrateRoot } from 'react-dom/client';
      import { page } from './page';
      hydrateRoot(document.getElementById('app')!, page);
    `,
  },
  check: 'npx tsc -p . --pretty false',
  mistakes: {
    path: 'src/Mistakes.tsx',
    text: `
      import { PhongViewer } from 'phong-viewer/react';
      export const unknown = <PhongViewer id="wrong" theta={true} />;
    `,
  },
  build:
    'npx vite build --ssr src/server.tsx --outDir server && node server/server.js > index.html && npx vite build',
  output: 'dist',
  sent: sentByReact,
};

const next: Framework = {
  name: 'Next',
  packages: [
    'three',
    '@types/three',
    'next@^16',
    'react',
    'react-dom',
    'typescript',
    '@types/react',
    '@types/node',
  ],
  files: {
    'next.config.mjs': "export default { output: 'export' };",
    'app/layout.tsx': `
      export default function Layout({ children }: { children: React.ReactNode }) {
        return <html lang="en"><head><link rel="icon" href="data:," /></head><body>{children}</body></html>;
      }
    `,
    'app/app.tsx': reactApp.trimStart(),
    'app/page.tsx': `
      import { PhongLight } from 'phong-viewer/react';
      import App from './app';
      export default function Page() {
        return <App><PhongLight ambient={[200, 100, 50]} diffuse={0} specular={[0, 0, 0]} /></App>;
      }
    `,
  },
  build: 'npx next build',
  output: 'out',
  sent: sentByReact,
};

const astro: Framework = {
  name: 'Astro',
  // Astro 6 and later need Node 22.
  packages: ['three', 'astro@^5', '@astrojs/react@^4', 'react', 'react-dom'],
  files: {
    'astro.config.mjs': `
      import react from '@astrojs/react';
      import { defineConfig } from 'astro/config';
      export default defineConfig({ integrations: [react()] });
    `,
    'src/App.tsx': reactApp,
    'src/pages/index.astro': `---
import { PhongViewer } from 'phong-viewer/react';
import App from '../App.tsx';
---
<html lang="en">
  <head><meta charset="utf-8" /><title>Fresh</title><link rel="icon" href="data:," /></head>
  <body>
    <App client:load><phong-light ambient={[200, 100, 50]} diffuse={0} specular={0} /></App>
    <phong-viewer aria-label="A box" gui={false} />
    <PhongViewer aria-label="A box" target={[0, 0, 0]} gui={false} />
  </body>
</html>`,
  },
  build: 'npx astro build',
  output: 'dist',
  sent: [
    sentByReact[0]!,
    '<phong-light ambient="200,100,50" diffuse="0" specular="0">',
    '<phong-viewer aria-label="A box" gui="false">',
    '<phong-viewer aria-label="A box" target="0 0 0" gui="false">',
  ],
};

for (const framework of [
  vue,
  svelte,
  solid,
  react,
  angular,
  nuxt,
  svelteKit,
  oldestReact,
  next,
  astro,
]) {
  const { name, packages, files, check, mistakes, build, output, sent } = framework;
  test.describe(`the packed tarball in a fresh ${name} project @release`, () => {
    const project = useFreshProject(packages, ({ write }) => {
      for (const [path, text] of Object.entries(files)) {
        write(path, text);
      }
    });

    if (check !== undefined) {
      test('accepts values and events in templates', () => {
        project().run(check);
      });
    }

    if (mistakes !== undefined) {
      test('refuses mistakes in templates, each where it is, and nothing else', () => {
        project().write(mistakes.path, mistakes.text);
        const lines = mistakes.text.split('\n');
        const wrong = lines.flatMap((line, i) => (line.includes('id="wrong"') ? [i + 1] : []));
        let said = '';
        try {
          project().run(check!);
        } catch (error) {
          said = String(error);
        }
        rmSync(join(project().folder, mistakes.path));
        const places = said.matchAll(/Mistakes\.\w+(?:" |\()(\d+)[:,]\d+/g);
        expect([...new Set(Array.from(places, ([, line]) => Number(line)))], said).toEqual(wrong);
      });
    }

    test('sends false and numbers as text, sets lists and false, hears events and follows state', async ({
      page,
    }) => {
      project().run(build);
      const folder = join(project().folder, output);
      const markup = readFileSync(join(folder, 'index.html'), 'utf8');
      for (const text of sent ?? []) {
        expect(markup).toContain(text);
      }
      // The strict policy: no framework's production build needs more, unless inline scripts
      // hydrate its pages.
      await project().open(page, folder, sent === undefined ? strictPolicy : '');
      const viewer = page.locator('phong-viewer.picture');
      const lights = () =>
        viewer.evaluate(({ lights }: PhongViewer) =>
          lights.map(({ active, ambient }: PhongLight) => [active, ambient]),
        );
      await expect.poll(lights).toEqual([
        [false, [0, 0, 255]],
        [true, [200, 100, 50]],
      ]);
      await allReady(page);
      const values = ({ orbit, gui, colorInterpolation: space, terms, ka }: PhongViewer) => ({
        orbit,
        gui,
        space,
        terms,
        ka,
      });
      const own = sent === undefined ? { space: 'linear', terms: ['ambient'] } : {};
      const expected = { orbit: false, gui: false, ka: [255, 255, 255], ...own };
      expect(await viewer.evaluate(values)).toMatchObject(expected);
      expect(pixelAt(await pixels(viewer, { width: 60, height: 40 }), 30, 20)).toEqual([
        200, 100, 50, 255,
      ]);

      // The page may still be hydrated.
      let theta = 40;
      await expect(async () => {
        await viewer.evaluate((element: PhongViewer, to) => (element.theta = to), ++theta);
        await expect(page.locator('output')).toHaveText(`script to ${String(theta)}`, {
          timeout: 500,
        });
      }).toPass();
      await page.getByText('light up').click();
      await expect.poll(async () => (await lights())[0]).toEqual([true, [20, 30, 40]]);
    });
  });
}
