// Do the house's own lint rules report what they should? Asks them about texts under made-up paths.

import { describe, expect, it } from 'vitest';
import { breaches } from '../../.ci/house-rules.mjs';

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
  it.each(allowed)('lets %s write %s', (file, code) => {
    expect(breaches(file, code)).toEqual([]);
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
    ['src/math/vector.ts', "export * from '../light/light-set.js';"],
    ['src/math/vector.ts', "export type X = import('../light/light-set.js').X;"],
  ] as const;
  it.each(refused)('refuses %s to write %s', (file, code) => {
    expect(breaches(file, code)).toHaveLength(1);
  });

  it('says where, and what may be done instead', () => {
    const found = breaches('src/index.ts', "\nimport { makePanel } from './gui/panel.js';");
    expect(found).toEqual(['2: src/index may import gui only by import() or import type.']);
  });

  it.each([
    ['class A { private a = 1; }', ['1: Private members are #private.']],
    ['class A {\n  private a(): void {}\n}', ['2: Private members are #private.']],
    ['class A { protected a = 1; #b = 2; }', []],
  ])('wants #private: %j', (code, found) => {
    expect(breaches('src/math/vector.ts', code)).toEqual(found);
  });
});
