// A plain three.js page with the same sphere under the nearest lights that three.js has.
import {
  AmbientLight,
  DirectionalLight,
  Mesh,
  MeshPhongMaterial,
  PointLight,
  SphereGeometry,
  SpotLight,
} from 'three';
import { threePage } from './three-page.js';

const { renderer, camera, scene } = threePage(document.getElementById('holder')!, 0.1, 10);
scene.add(
  new Mesh(
    new SphereGeometry(0.5, 64, 32),
    new MeshPhongMaterial({ shininess: 32, specular: 0x808080 }),
  ),
);
const sun = new DirectionalLight(0x969696, Math.PI);
sun.position.set(1, 2, 3);
const lamp = new PointLight(0xc8783c, 20);
lamp.position.set(-2, 1, 2);
const spot = new SpotLight(0x5078c8, 30, 0, Math.PI / 6, 0.5);
spot.position.set(0, 3, 2);
scene.add(sun, lamp, spot, spot.target, new AmbientLight(0x141414, Math.PI));

camera.position.set(0.64, 0.47, 1.12);
camera.lookAt(0, 0, 0);
renderer.render(scene, camera);
