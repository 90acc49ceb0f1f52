// Does a page of posters wait for every element that shows nothing without the package?
import { readFileSync } from 'node:fs';
import { expect, it } from 'vitest';
import * as elements from '../../../src/viewer/index.js';

it('fetches the package for every element but lights and meshes', () => {
  const [, tags = ''] = /STILL = `:is\(([^)]*)\)/.exec(
    readFileSync(new URL('../../../src/extras/lazy/index.ts', import.meta.url), 'utf8'),
  )!;
  expect(tags.replace('${VIEWER}', 'phong-viewer').split(',').sort()).toEqual(
    Object.keys(elements)
      .map((name) => name.replace(/\B[A-Z]/, '-$&').toLowerCase())
      .filter((tag) => !['phong-light', 'phong-mesh'].includes(tag)),
  );
});
