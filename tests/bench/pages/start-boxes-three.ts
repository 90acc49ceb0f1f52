// A plain three.js page with the same boxes, of one material.
import { BoxGeometry, Mesh, MeshPhongMaterial, PerspectiveCamera, Scene, WebGLRenderer } from 'three';
import { FOV, ORIGIN, sceneOf } from './scenes.js';
import { threeLight } from './three-side.js';

const bench = sceneOf(new URLSearchParams(location.search).get('scene')!);
const holder = document.getElementById('holder')!;
const renderer = new WebGLRenderer({ antialias: true, alpha: true });
renderer.setPixelRatio(devicePixelRatio);
renderer.setSize(holder.clientWidth, holder.clientHeight);
holder.append(renderer.domElement);
const scene = new Scene();
for (const light of bench.lights) scene.add(threeLight(light));
const [geometry, material] = [new BoxGeometry(), new MeshPhongMaterial({ shininess: 32 })];
for (const { position = ORIGIN, scale = 1 } of bench.meshes) {
  const mesh = new Mesh(geometry, material);
  mesh.position.set(...position);
  mesh.scale.setScalar(scale);
  scene.add(mesh);
}
const camera = new PerspectiveCamera(FOV, holder.clientWidth / holder.clientHeight, 0.1, 100);
camera.position.z = bench.radius;
renderer.render(scene, camera);
// Kept, as by a page that draws again: the heap is read after the first picture.
Object.assign(window, { scene, camera, renderer });
