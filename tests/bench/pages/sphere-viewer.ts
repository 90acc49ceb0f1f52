// A viewer of a sphere under the bench's three lights.
import 'phong-viewer';
import { mixedLights } from './scenes.js';

export function sphereViewer(): HTMLElementTagNameMap['phong-viewer'] {
  const viewer = document.createElement('phong-viewer');
  Object.assign(viewer, { alt: 'A sphere', geometry: 'sphere' });
  viewer.append(
    ...mixedLights(3).map((light) => Object.assign(document.createElement('phong-light'), light)),
  );
  return viewer;
}
