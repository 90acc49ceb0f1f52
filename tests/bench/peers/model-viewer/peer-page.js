// <model-viewer> among its peers: the same box as a file. Its lighting is the one it comes with: no attribute names a light.
import '@google/model-viewer';
import { nextFrame, openPeers } from '../../pages/peer-page.js';

await openPeers({
  tag: 'model-viewer',
  markup: '<model-viewer src="box.glb" loading="eager" reveal="auto"></model-viewer>',
  // Its event for it is held back; asked each frame it says so at once.
  async loaded(viewer) {
    while (!viewer.modelIsVisible) await nextFrame();
  },
});
