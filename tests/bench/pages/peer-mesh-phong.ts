// Plain three.js among its peers, as one writes it first: a renderer of its own for each canvas, MeshPhongMaterial, one
// directional light, drawn once.
import {
  BoxGeometry,
  DirectionalLight,
  Mesh,
  MeshPhongMaterial,
  PerspectiveCamera,
  Scene,
  WebGLRenderer,
} from 'three';
import { openPeers } from './peer-page.js';

await openPeers({
  tag: '.peer',
  markup: '<div class="peer"></div>',
  loaded(holder) {
    const renderer = new WebGLRenderer({ antialias: true, alpha: true });
    renderer.setPixelRatio(devicePixelRatio);
    renderer.setSize(holder.clientWidth, holder.clientHeight);
    holder.append(renderer.domElement);
    const scene = new Scene();
    scene.add(new Mesh(new BoxGeometry(), new MeshPhongMaterial()));
    const light = new DirectionalLight(0xffffff, 2.5);
    light.position.set(1, 2, 3);
    scene.add(light);
    const camera = new PerspectiveCamera(45, holder.clientWidth / holder.clientHeight, 0.1, 10);
    camera.position.set(1.1, 0.8, 1.9);
    camera.lookAt(0, 0, 0);
    renderer.render(scene, camera);
    return Promise.resolve();
  },
});
