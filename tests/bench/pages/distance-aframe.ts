// A-Frame's `shader: phong` on the same sphere: ?case=as-it-comes, or unencoded (`colorManagement: false`) with the light scaled
// and the highlight as high as Ks, without dithering: own-exponent (n), nearest-exponent (4n). Greys in hsl(), which alone takes
// fractions.
import {
  EYE_Z,
  FOV,
  hex,
  KD,
  KS,
  LOBE_WIDTHS,
  SHININESS,
  specularForLobe,
  SPHERE,
  TO_LIGHT,
} from './distance-scene.js';
import { next, openPeers } from './peer-page.js';

const asked = new URLSearchParams(location.search).get('case');
const plain = asked === 'as-it-comes';
const exponent = asked === 'nearest-exponent' ? LOBE_WIDTHS * SHININESS : SHININESS;
const specular = plain ? hex(KS) : `hsl(0, 0%, ${(100 * specularForLobe(KS[0], exponent)).toFixed(6)}%)`;

await openPeers({
  size: 'square',
  tag: 'a-scene',
  markup: `<a-scene embedded light="defaultLightsEnabled: false" xr-mode-ui="enabled: false"
      renderer="colorManagement: ${plain}">
    <a-entity
      geometry="primitive: sphere; radius: ${SPHERE.radius}; segmentsWidth: ${SPHERE.around}; segmentsHeight: ${SPHERE.down}"
      material="shader: phong; color: ${hex(KD)}; specular: ${specular}; shininess: ${exponent}; dithering: ${plain}"></a-entity>
    <a-entity light="type: directional; color: #fff${plain ? '' : `; intensity: ${Math.PI}`}"
      position="${TO_LIGHT.join(' ')}"></a-entity>
    <a-entity camera="fov: ${FOV}; near: 0.1" position="0 0 ${EYE_Z}"></a-entity>
  </a-scene>`,
  loaded: (scene) => next(scene, 'renderstart'),
});
