// Do the house's own lint rules report what they should? Asks them about texts under made-up paths.

import { describe, expect, it } from 'vitest';
import { breaches, filesOfStills, inexact } from '../../.ci/house-rules.mjs';

describe('layers of src/', () => {
  const allowed = [
    ['src/phong/light/light-set.ts', "import { dot } from '../math/vector.js';"],
    ['src/phong/light/light-set.ts', "import { one } from './light-state.js';"],
    [
      'src/phong/material/phong-material.ts',
      "import text from '../../../shaders/phong.frag.glsl?raw';",
    ],
    [
      'src/extras/models/gltf.ts',
      "import { material } from '../../phong/material/phong-material.js';",
    ],
    ['src/extras/models/gltf.ts', "const m = import('three/examples/jsm/loaders/GLTFLoader.js');"],
    ['src/viewer/element/phong-viewer.ts', "import { LitElement } from 'lit';"],
    ['src/viewer/element/phong-viewer.ts', "const r = import('../../phong/reference/index.js');"],
    ['src/viewer/element/phong-viewer.ts', "import type { Scene } from 'three';"],
    ['src/viewer/extras.ts', "const panel = () => import('../extras/panel/panel.js');"],
    ['src/viewer/index.ts', "import './extras.js';"],
    ['src/phong/core.ts', "export { pack } from './light/pack-lights.js';"],
    ['src/extras/panel/panel.ts', "import { historyOf } from '../../viewer/extra.js';"],
    ['src/extras/overlay/probe/sum.ts', "import { pick } from '../../explain/pick.js';"],
    [
      'src/extras/playwright/subpixel.ts',
      "import type { PhongViewer } from '../../viewer/index.js';",
    ],
  ] as const;
  it.each(allowed)('lets %s write %s', (file, code) => {
    expect(breaches(file, code)).toEqual([]);
  });

  const refused = [
    ['src/phong/math/vector.ts', "import { x } from '../light/light-set.js';"],
    ['src/phong/light/light-set.ts', "import { Vector3 } from 'three';"],
    ['src/viewer/scene/gpu/stage.ts', "export { html } from 'lit';"],
    ['src/viewer/element/phong-viewer.ts', "import { x } from '../../extras/panel/panel.js';"],
    [
      'src/viewer/element/phong-viewer.ts',
      "import { explain } from '../../phong/reference/index.js';",
    ],
    ['src/viewer/element/phong-viewer.ts', "import { Vector3 } from 'three';"],
    ['src/viewer/extras.ts', "import { makePanel } from '../extras/panel/panel.js';"],
    ['src/viewer/index.ts', "const panel = () => import('../extras/panel/panel.js');"],
    ['src/viewer/model/model.ts', "import type { Slices } from '../../extras/models/slices.js';"],
    ['src/phong/core.ts', "import { LitElement } from 'lit';"],
    ['src/extras/panel/panel.ts', "import type { PhongViewer } from '../../viewer/index.js';"],
    ['src/extras/panel/panel.ts', "import { write } from '../../viewer/element/dom.js';"],
    ['src/extras/panel/panel.ts', "import { pick } from '../explain/pick.js';"],
    ['src/viewer/element/dom.ts', "import { historyOf } from '../extra.js';"],
    ['src/extras/playwright/index.ts', "import { PhongViewer } from '../../viewer/index.js';"],
    ['src/viewer/index.ts', "import { settled } from '../extras/playwright/index.js';"],
    [
      'src/phong/reference/index.ts',
      "import type { Judgement } from '../../extras/playwright/judge-in-page.js';",
    ],
    ['src/phong/light/light-set.ts', "import { x } from '../../../tests/support/test.js';"],
    [
      'src/viewer/element/phong-viewer.ts',
      "import text from '../../../shaders/phong.frag.glsl?raw';",
    ],
    ['src/helpers/anything.ts', "import { x } from '../phong/math/vector.js';"],
    ['src/phong/math/vector.ts', "export * from '../light/light-set.js';"],
    ['src/phong/math/vector.ts', "export type X = import('../light/light-set.js').X;"],
  ] as const;
  it.each(refused)('refuses %s to write %s', (file, code) => {
    expect(breaches(file, code)).toHaveLength(1);
  });

  it('says where, and what may be done instead', () => {
    const found = breaches(
      'src/viewer/extras.ts',
      "\nimport { makePanel } from '../extras/panel/panel.js';",
    );
    expect(found).toEqual([
      '2: src/viewer/extras.ts may import extras/panel only by import() or import type.',
    ]);
  });

  it('wants a reason of each abort, and no for … in', () => {
    const file = 'src/viewer/index.ts';
    expect(breaches(file, "a.abort('ended');\na.#b?.abort();")).toEqual([
      expect.stringMatching(/^2: abort\(\) makes an error that keeps its callers alive/),
    ]);
    expect(breaches(file, 'for (const key in a) {}\nfor (const key of a) {}')).toEqual([
      expect.stringMatching(/^1: for … in also visits/),
    ]);
  });

  it.each([
    ['class A { private a = 1; }', ['1: Private members are #private.']],
    ['class A {\n  private a(): void {}\n}', ['2: Private members are #private.']],
    ['class A { protected a = 1; #b = 2; }', []],
  ])('wants #private: %j', (code, found) => {
    expect(breaches('src/phong/math/vector.ts', code)).toEqual(found);
  });
});

describe('files that stills import', () => {
  it('are found through other files, without types and decoders', () => {
    const files = filesOfStills();
    expect(files).toContain('src/extras/still/tracer.ts');
    expect(files).toContain('src/phong/math/angle.ts');
    expect(files).toContain('src/phong/model/shapes/teapot.ts');
    expect(files).toContain('src/extras/models/triangles/smooth-normals.ts');
    expect(files).not.toContain('src/phong/material/phong-material.ts');
    expect(files).not.toContain('src/extras/models/gltf/draco.ts');
  });

  it.each(['Math.pow(x, 2)', 'angles.map(Math.cos)', 'x ** 2', "Math['sin'](x)", '2 ** x'])(
    'may not compute %s',
    (code) => {
      expect(inexact('src/phong/math/angle.ts', code)).toHaveLength(1);
    },
  );

  it.each(['Math.sqrt(x)', 'x * x', '2 ** 20', '2 ** -23', 'Math.PI'])('may compute %s', (code) => {
    expect(inexact('src/phong/math/angle.ts', code)).toEqual([]);
  });
});
