// Which element does a tag name give in `document.querySelector` and `createElement`? Types only.
import type { PhongLight } from '../phong-light.js';
import type { PhongMesh } from '../phong-mesh.js';
import type { PhongViewer } from '../phong-viewer.js';

declare global {
  interface HTMLElementTagNameMap {
    'phong-light': PhongLight;
    'phong-mesh': PhongMesh;
    'phong-viewer': PhongViewer;
  }
}
