// The element types that `document.querySelector` and `createElement` give for the tag names. Types only.
import type { PhongLight } from '../elements.js';
import type { PhongMesh } from '../elements.js';
import type { PhongViewer } from '../elements.js';

declare global {
  interface HTMLElementTagNameMap {
    'phong-light': PhongLight;
    'phong-mesh': PhongMesh;
    'phong-viewer': PhongViewer;
  }
}
