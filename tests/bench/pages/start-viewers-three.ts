// A plain three.js page with 64 pictures of a sphere: scenes of their own, drawn by one renderer
// and copied.
import {
  Mesh,
  MeshPhongMaterial,
  PerspectiveCamera,
  Scene,
  SphereGeometry,
  WebGLRenderer,
} from 'three';
import { mixedLights } from './scenes.js';
import { pictureIsThere } from './start-viewers.js';
import { threeLight } from './three-side.js';

const renderer = new WebGLRenderer({ antialias: true, alpha: true });
const pictures = Array.from({ length: 64 }, () => {
  const canvas = document.body.appendChild(document.createElement('canvas'));
  const scene = new Scene();
  scene.add(new Mesh(new SphereGeometry(0.5, 64, 32), new MeshPhongMaterial({ shininess: 32 })));
  for (const light of mixedLights(3)) {
    scene.add(threeLight(light));
  }
  const { clientWidth: width, clientHeight: height } = canvas;
  const camera = new PerspectiveCamera(45, width / height, 0.1, 10);
  camera.position.z = 1.6;
  return {
    canvas,
    scene,
    camera,
    width: devicePixelRatio * width,
    height: devicePixelRatio * height,
  };
});
for (const { canvas, scene, camera, width, height } of pictures) {
  renderer.setSize(width, height, false);
  renderer.render(scene, camera);
  Object.assign(canvas, { width, height });
  canvas.getContext('2d')!.drawImage(renderer.domElement, 0, 0);
}
pictureIsThere(pictures.at(-1)!.canvas);
// Kept, as by a page that draws again: the heap is read after the first picture.
Object.assign(window, { pictures, renderer });
