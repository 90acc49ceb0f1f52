// A plain three.js page with the same sphere under the nearest lights that three.js has.
import {
  AmbientLight,
  DirectionalLight,
  Mesh,
  MeshPhongMaterial,
  PerspectiveCamera,
  PointLight,
  Scene,
  SphereGeometry,
  SpotLight,
  WebGLRenderer,
} from 'three';

const holder = document.getElementById('holder')!;
const renderer = new WebGLRenderer({ antialias: true, alpha: true });
renderer.setPixelRatio(devicePixelRatio);
renderer.setSize(holder.clientWidth, holder.clientHeight);
holder.append(renderer.domElement);

const scene = new Scene();
scene.add(
  new Mesh(new SphereGeometry(0.5, 64, 32), new MeshPhongMaterial({ shininess: 32, specular: 0x808080 })),
);
const sun = new DirectionalLight(0x969696, Math.PI);
sun.position.set(1, 2, 3);
const lamp = new PointLight(0xc8783c, 20);
lamp.position.set(-2, 1, 2);
const spot = new SpotLight(0x5078c8, 30, 0, Math.PI / 6, 0.5);
spot.position.set(0, 3, 2);
scene.add(sun, lamp, spot, spot.target, new AmbientLight(0x141414, Math.PI));

const camera = new PerspectiveCamera(45, holder.clientWidth / holder.clientHeight, 0.1, 10);
camera.position.set(0.64, 0.47, 1.12);
camera.lookAt(0, 0, 0);
renderer.render(scene, camera);
// Kept, as by a page that draws again: the heap is read after the first picture.
Object.assign(window, { scene, camera, renderer });
