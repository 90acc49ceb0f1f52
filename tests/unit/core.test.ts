// `phong-viewer/core` has at once what elements fetch when a picture asks for it.

import { expect, it } from 'vitest';
import { LightSet, LightState, PhongLighting, PhongMaterial } from '../../src/core.js';

it('averages highlights at once', () => {
  const lights = new LightSet();
  lights.add(new LightState());
  const lighting = new PhongLighting(lights);
  lighting.update({ origin: [0, 0, 0], eye: [0, 0, 5], right: [1, 0, 0], up: [0, 1, 0], back: [0, 0, 1] });
  const material = new PhongMaterial(lighting);
  material.setStyle({ antialias: 'highlights' });
  material.chooseProgram();
  expect(material.defines).toHaveProperty('FILTER_HIGHLIGHTS');
  expect(material.fragmentShader).toContain('averagedLobe(');
});
