// A bundled page with the element and a scene of boxes: start-boxes-element.html?scene=boxes:3.
import 'phong-viewer';
import { FOV, sceneOf } from './scenes.js';

const scene = sceneOf(new URLSearchParams(location.search).get('scene')!);
const viewer = document.createElement('phong-viewer');
Object.assign(viewer, {
  alt: 'Boxes',
  theta: 0,
  phi: 90,
  target: [0, 0, 0],
  radius: scene.radius,
  fov: FOV,
});
viewer.append(
  ...scene.lights.map((light) => Object.assign(document.createElement('phong-light'), light)),
  ...scene.meshes.map(({ position, scale }) =>
    Object.assign(document.createElement('phong-mesh'), { geometry: 'box', position, scale }),
  ),
);
document.getElementById('holder')!.replaceWith(viewer);
