// `phong-viewer/core`'s material and lights in a plain three.js page.
import { LinearSRGBColorSpace } from 'three';
import { LightState, PhongLighting, PhongMaterial } from 'phong-viewer/core';
import { SURFACE } from './scenes.js';
import type { OpenSide } from './side.js';
import { threePage } from './three-page.js';
import { threeMeshes, turn } from './three-side.js';

export const openCore: OpenSide = async (holder, bench) => {
  const { renderer, camera, scene } = threePage(holder, 0.05, 100);
  renderer.outputColorSpace = LinearSRGBColorSpace; // the equation's colours are encoded already
  const lighting = new PhongLighting();
  for (const values of bench.lights) lighting.lights.add(new LightState(values));
  const material = new PhongMaterial(lighting);
  material.sides = 'closed'; // as the element has it for a sphere
  const { ka, kd, ks, shininess } = SURFACE;
  material.setSurface({ ka: [ka, ka, ka], kd: [kd, kd, kd], ks: [ks, ks, ks], shininess });
  scene.add(...(await threeMeshes(bench, material)));
  const draw = (i: number): void => {
    turn(camera, bench, i);
    camera.updateMatrixWorld();
    lighting.update(camera);
    renderer.render(scene, camera);
  };
  draw(0);
  return {
    async frame(i) {
      await Promise.resolve();
      draw(i);
    },
  };
};
