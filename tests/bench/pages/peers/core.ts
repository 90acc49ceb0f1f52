// `phong-viewer/core`'s material in a plain three.js page: the element's programs where the page chooses how to draw.
import { LightSet, LightState, PhongLighting, PhongMaterial, type ShadingFrame } from 'phong-viewer/core';
import { bentPlane, CAMERA, lightsOf, SURFACE } from '../scenes.js';
import type { PeerMaker } from './peer.js';
import { geometryOf, plainThree, threePeer } from './plain-three.js';

const FRAME: ShadingFrame = {
  origin: [0, 0, 0],
  eye: [0, 0, CAMERA.radius],
  right: [1, 0, 0],
  up: [0, 1, 0],
  back: [0, 0, 1],
};

export const core: PeerMaker = (holder, query) => {
  const lights = new LightSet();
  lights.assign(lightsOf(query).map((values) => new LightState(values)));
  const lighting = new PhongLighting(lights);
  const material = new PhongMaterial(lighting);
  const { ka, kd, ks, shininess } = SURFACE;
  material.setSurface({ ka: [ka, ka, ka], kd: [kd, kd, kd], ks: [ks, ks, ks], shininess });
  const three = plainThree(holder, geometryOf(bentPlane()), material, false);
  const peer = threePeer(three);
  return Promise.resolve({
    ...peer,
    draw() {
      lighting.update(FRAME);
      peer.draw();
    },
  });
};
