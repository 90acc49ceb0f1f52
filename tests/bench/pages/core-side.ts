// `phong-viewer/core`'s material and lights in a plain three.js page.
import { LinearSRGBColorSpace, MathUtils, Scene } from 'three';
import { LightState, PhongLighting, PhongMaterial } from 'phong-viewer/core';
import { SURFACE, thetaAt } from './scenes.js';
import type { OpenSide } from './side.js';
import { threeMeshes, threeRenderer } from './three-side.js';

export const openCore: OpenSide = async (holder, bench) => {
  const { renderer, camera } = threeRenderer(holder);
  renderer.outputColorSpace = LinearSRGBColorSpace; // the equation's colours are encoded already
  const lighting = new PhongLighting();
  for (const values of bench.lights) lighting.lights.add(new LightState(values));
  const material = new PhongMaterial(lighting);
  material.sides = 'closed'; // as the element has it for a sphere
  const { ka, kd, ks, shininess } = SURFACE;
  material.setSurface({ ka: [ka, ka, ka], kd: [kd, kd, kd], ks: [ks, ks, ks], shininess });
  const scene = new Scene();
  scene.add(...(await threeMeshes(bench, material)));
  const draw = (i: number): void => {
    const theta = bench.motion === 'camera' ? MathUtils.degToRad(thetaAt(i)) : 0;
    camera.position.set(bench.radius * Math.sin(theta), 0, bench.radius * Math.cos(theta));
    camera.lookAt(0, 0, 0);
    camera.updateMatrixWorld();
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
