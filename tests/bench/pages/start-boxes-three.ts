// A plain three.js page with the same boxes, of one material.
import { BoxGeometry, Mesh, MeshPhongMaterial } from 'three';
import { ORIGIN, sceneOf } from './scenes.js';
import { threePage } from './three-page.js';
import { threeLight } from './three-side.js';

const bench = sceneOf(new URLSearchParams(location.search).get('scene')!);
const { renderer, camera, scene } = threePage(document.getElementById('holder')!, 0.1, 100);
for (const light of bench.lights) {
  scene.add(threeLight(light));
}
const [geometry, material] = [new BoxGeometry(), new MeshPhongMaterial({ shininess: 32 })];
for (const { position = ORIGIN, scale = 1 } of bench.meshes) {
  const mesh = new Mesh(geometry, material);
  mesh.position.set(...position);
  mesh.scale.setScalar(scale);
  scene.add(mesh);
}
camera.position.z = bench.radius;
renderer.render(scene, camera);
