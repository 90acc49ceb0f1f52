// three.js's MeshPhongMaterial on the same sphere: ?case=as-it-comes, with the numbers under the names it has for them; or
// with its output left unencoded, the light scaled by π so that the diffuse term is Kd · N·L, and its highlight made as high as Ks:
// own-exponent (n), nearest-exponent (4n), diffuse (none).
import {
  Color,
  DirectionalLight,
  LinearSRGBColorSpace,
  Mesh,
  MeshPhongMaterial,
  PerspectiveCamera,
  Scene,
  SphereGeometry,
  WebGLRenderer,
} from 'three';
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
import { openPeers } from './peer-page.js';

const asked = new URLSearchParams(location.search).get('case');

function material(): MeshPhongMaterial {
  if (asked === 'as-it-comes')
    return new MeshPhongMaterial({ color: hex(KD), specular: hex(KS), shininess: SHININESS });
  const exponent = asked === 'nearest-exponent' ? LOBE_WIDTHS * SHININESS : SHININESS;
  const specular = asked === 'diffuse' ? 0 : specularForLobe(KS[0], exponent);
  return new MeshPhongMaterial({
    color: new Color(KD[0] / 255, KD[1] / 255, KD[2] / 255),
    specular: new Color(specular, specular, specular),
    shininess: exponent,
  });
}

await openPeers({
  size: 'square',
  tag: '.peer',
  markup: '<div class="peer"></div>',
  loaded(holder) {
    const renderer = new WebGLRenderer({ antialias: true, alpha: true });
    if (asked !== 'as-it-comes') renderer.outputColorSpace = LinearSRGBColorSpace;
    renderer.setSize(holder.clientWidth, holder.clientHeight);
    holder.append(renderer.domElement);
    const scene = new Scene();
    scene.add(new Mesh(new SphereGeometry(SPHERE.radius, SPHERE.around, SPHERE.down), material()));
    const light = new DirectionalLight(0xffffff, asked === 'as-it-comes' ? 1 : Math.PI);
    light.position.set(...TO_LIGHT);
    scene.add(light);
    const camera = new PerspectiveCamera(FOV, 1, 0.1, 10);
    camera.position.z = EYE_Z;
    renderer.render(scene, camera);
    return Promise.resolve();
  },
});
