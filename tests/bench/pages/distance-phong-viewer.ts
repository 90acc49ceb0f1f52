// The element's sphere: ?case=phong or blinn-phong.
import 'phong-viewer';
import { EYE_Z, FOV, KD, KS, SHININESS, SPHERE, TO_LIGHT } from './distance-scene.js';
import { openPeers } from './peer-page.js';

const reflection = new URLSearchParams(location.search).get('case') ?? '';

await openPeers({
  size: 'square',
  tag: 'phong-viewer',
  markup: `<phong-viewer geometry="sphere" segments="${SPHERE.around}" reflection="${reflection}"
    ka="0" kd="${KD.join(' ')}" ks="${KS.join(' ')}" shininess="${SHININESS}"
    theta="0" phi="90" target="0 0 0" radius="${EYE_Z}" fov="${FOV}">
    <phong-light position="${TO_LIGHT.join(' ')} 0"></phong-light>
  </phong-viewer>`,
  loaded: (viewer) => (viewer as HTMLElementTagNameMap['phong-viewer']).ready,
});
