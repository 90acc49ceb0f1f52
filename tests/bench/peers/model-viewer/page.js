// ?count=64: so many <model-viewer>, the same box as a file each, all on screen.
import '@google/model-viewer';
import { pictureShown } from '../../pages/first-picture.js';

const count = Number(new URLSearchParams(location.search).get('count'));
document.body.innerHTML = '<model-viewer src="box.glb" loading="eager" reveal="auto"></model-viewer>'.repeat(
  count,
);
const viewers = [...document.querySelectorAll('model-viewer')];
// Its event for it is held back; asked each frame it says so at once.
const look = () => {
  if (viewers.every((viewer) => viewer.modelIsVisible)) pictureShown();
  else requestAnimationFrame(look);
};
look();
