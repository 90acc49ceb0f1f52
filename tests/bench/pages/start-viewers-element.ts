// A bundled page with 64 viewers, each with the bench's three lights.
import 'phong-viewer';
import { mixedLights } from './scenes.js';
import { pictureIsThere } from './start-viewers.js';

const viewers = Array.from({ length: 64 }, () => {
  const viewer = Object.assign(document.createElement('phong-viewer'), {
    alt: 'A sphere',
    geometry: 'sphere',
  });
  viewer.append(
    ...mixedLights(3).map((light) => Object.assign(document.createElement('phong-light'), light)),
  );
  return viewer;
});
document.body.append(...viewers);

const drawn = viewers.map(
  (viewer) => new Promise((resolve) => viewer.addEventListener('render', resolve)),
);
void Promise.all(drawn).then(() =>
  pictureIsThere(viewers.at(-1)!.shadowRoot!.querySelector('canvas')!),
);
