// A bundled page with 64 viewers, each with the bench's three lights.
import { sphereViewer } from './sphere-viewer.js';
import { pictureIsThere } from './start-viewers.js';

const viewers = Array.from({ length: 64 }, sphereViewer);
document.body.append(...viewers);

const drawn = viewers.map(
  (viewer) => new Promise((resolve) => viewer.addEventListener('render', resolve)),
);
void Promise.all(drawn).then(() =>
  pictureIsThere(viewers.at(-1)!.shadowRoot!.querySelector('canvas')!),
);
