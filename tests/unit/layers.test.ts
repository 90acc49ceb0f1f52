// Do the layer rules of src/ report what they should? Asks ESLint itself, about texts under made-up paths.

import { ESLint } from 'eslint';
import { describe, expect, it } from 'vitest';
import { layersRule } from '../../.ci/layers.mjs';
import tseslint from 'typescript-eslint';

// The layer rule alone and without types: the texts are in no TypeScript project.
const eslint = new ESLint({
  overrideConfigFile: true,
  overrideConfig: [
    {
      files: ['**/*.ts'],
      languageOptions: { parser: tseslint.parser },
      plugins: { house: { rules: { layers: layersRule } } },
      rules: { 'house/layers': 'error' },
    },
  ],
});

async function messages(filePath: string, code: string): Promise<string[]> {
  const [result] = await eslint.lintText(code, { filePath });
  return (result?.messages ?? []).map(({ message }) => message);
}

describe('layers of src/', () => {
  const allowed = [
    ['src/light/light-set.ts', "import { dot } from '../math/vector.js';"],
    ['src/light/light-set.ts', "import { one } from './light-state.js';"],
    ['src/material/phong-material.ts', "import text from '../../shaders/phong.frag.glsl?raw';"],
    ['src/model/gltf.ts', "import { material } from '../material/phong-material.js';"],
    ['src/model/gltf.ts', "const m = import('three/examples/jsm/loaders/GLTFLoader.js');"],
    ['src/element/phong-viewer.ts', "import { LitElement } from 'lit';"],
    ['src/element/phong-viewer.ts', "const r = import('../reference/index.js');"],
    ['src/element/phong-viewer.ts', "import type { Scene } from 'three';"],
    ['src/index.ts', "const panel = () => import('./gui/panel.js');"],
    ['src/core.ts', "export { pack } from './light/pack-lights.js';"],
    ['src/playwright/subpixel.ts', "import type { PhongViewer } from '../index.js';"],
  ] as const;
  it.each(allowed)('lets %s write %s', async (file, code) => {
    expect(await messages(file, code)).toEqual([]);
  });

  const refused = [
    ['src/math/vector.ts', "import { x } from '../light/light-set.js';"],
    ['src/light/light-set.ts', "import { Vector3 } from 'three';"],
    ['src/scene/gpu/stage.ts', "export { html } from 'lit';"],
    ['src/element/phong-viewer.ts', "import { x } from '../gui/panel.js';"],
    ['src/element/phong-viewer.ts', "import { explain } from '../reference/index.js';"],
    ['src/element/phong-viewer.ts', "import { Vector3 } from 'three';"],
    ['src/index.ts', "import { makePanel } from './gui/panel.js';"],
    ['src/core.ts', "import { LitElement } from 'lit';"],
    ['src/playwright.ts', "import { PhongViewer } from './index.js';"],
    ['src/index.ts', "import { settled } from './playwright.js';"],
    ['src/reference/index.ts', "import type { Judgement } from '../playwright/judge-in-page.js';"],
    ['src/light/light-set.ts', "import { x } from '../../tests/support/test.js';"],
    ['src/element/phong-viewer.ts', "import text from '../../shaders/phong.frag.glsl?raw';"],
    ['src/helpers/anything.ts', "import { x } from '../math/vector.js';"],
  ] as const;
  it.each(refused)('refuses %s to write %s', async (file, code) => {
    expect(await messages(file, code)).toHaveLength(1);
  });

  it('says what may be done instead', async () => {
    const [message] = await messages('src/index.ts', "import { makePanel } from './gui/panel.js';");
    expect(message).toBe('src/index may import gui only by import() or import type.');
  });

  it('is switched on for every file of src/', async () => {
    const real = new ESLint();
    for (const file of ['src/math/x.ts', 'src/model/x.ts', 'src/index.ts']) {
      const config = (await real.calculateConfigForFile(file)) as { rules: Record<string, unknown[]> };
      expect(config.rules['house/layers']?.[0]).toBe(2);
    }
  });
});
