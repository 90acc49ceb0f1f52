// A-Frame among its peers: its own box and light, loaded as its documentation says. Without the button for headsets, which
// a page in a document would not show.
import { next, openPeers } from './peer-page.js';

await openPeers({
  tag: 'a-scene',
  markup: `<a-scene embedded light="defaultLightsEnabled: false" xr-mode-ui="enabled: false">
    <a-box color="#ccc"></a-box>
    <a-entity light="type: directional; intensity: 2.5" position="1 2 3"></a-entity>
    <a-entity camera="fov: 45" position="1.1 0.8 1.9" rotation="-19.9 30.1 0"></a-entity>
  </a-scene>`,
  // Its frames begin with the one after this event.
  loaded: (scene) => next(scene, 'renderstart'),
});
