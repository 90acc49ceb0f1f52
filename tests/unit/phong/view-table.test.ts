// Does every view of the table have the GLSL function that its program calls, of the type that its
// legend's scale says, and every such function a view?

import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { LIGHT_FIELDS, type LightValues } from '../../../src/phong/light/light-state.js';
import { emptyPack } from '../../../src/phong/light/pack-lights.js';
import { pictureView } from '../../../src/phong/material/view/picture-view.js';
import { viewEntry, viewValue } from '../../../src/phong/material/view/view-table.js';
import quantityText from '../../../shaders/view_quantity.glsl?raw';
import { light, worldLight } from '../arbitraries.js';
import { WORLD } from '../packed-reader.js';
import { VIEWS } from '../../../src/phong/material/views.js';

const quantities = VIEWS.flatMap((view) => {
  const { shows, scale } = viewEntry(view);
  if (shows.by !== 'quantity') return [];
  const name = /view\w+/.exec(viewValue(view))?.[0];
  return [
    { view, text: quantityText, head: `${scale === 'unit' ? 'float' : 'vec3'} ${name ?? ''}(` },
  ];
});

describe('views that show a quantity', () => {
  it.each(quantities)('have a GLSL function: $view', ({ text, head }) => {
    expect(text.split('\n').filter((line) => line.startsWith(head))).toEqual([
      `${head}Viewed at) {`,
    ]);
    expect(text).toContain('return VIEW_VALUE;');
  });

  it('follow every value of their light but its colours and its cone', () => {
    const { pack, program } = pictureView('decay', (lights) => lights);
    const lights = fc.sample(worldLight, { seed: 52, numRuns: 20 });
    for (const [key, { shading }] of Object.entries(LIGHT_FIELDS)) {
      if (typeof shading === 'string' || shading.as === 'light' || key === 'aperture') continue;
      const seen = lights.map((one) => {
        pack([light({ [key]: one[key as keyof LightValues] })], WORLD, emptyPack());
        return JSON.stringify(program!.uniforms);
      });
      expect(new Set(seen).size, key).toBeGreaterThan(2);
    }
  });

  it('are all that the GLSL has functions for', () => {
    const text = quantities[0]?.text ?? '';
    const heads = Array.from(text.matchAll(/^\w+ view\w+\(/gm), String);
    expect(heads.toSorted()).toEqual(quantities.map(({ head }) => head).toSorted());
  });
});
