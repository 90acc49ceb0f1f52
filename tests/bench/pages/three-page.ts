// What plain three.js pages have in common: a canvas as large as the holder, made as the element
// makes its own, and a camera.
import { PerspectiveCamera, Scene, WebGLRenderer } from 'three';
import { FOV } from './scenes.js';

export function threePage(holder: HTMLElement, near: number, far: number) {
  const renderer = new WebGLRenderer({ antialias: true, alpha: true });
  renderer.setPixelRatio(devicePixelRatio);
  renderer.setSize(holder.clientWidth, holder.clientHeight);
  holder.append(renderer.domElement);
  const camera = new PerspectiveCamera(FOV, holder.clientWidth / holder.clientHeight, near, far);
  const page = { renderer, camera, scene: new Scene() };
  // Kept, as by a page that draws again: the heap is read after the first picture.
  return Object.assign(window, { page }).page;
}
