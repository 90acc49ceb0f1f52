// X_ITE's Material on the same sphere, as triangles like the others' (its own sphere is coarser): ?case=own-exponent (n),
// nearest-exponent (4n). X3D names an exponent by its 128th, and its colours are the equation's already.
import { SphereGeometry } from 'three';
import { EYE_Z, FOV, KD, KS, LOBE_WIDTHS, SHININESS, SPHERE, TO_LIGHT } from './distance-scene.js';
import { next, openPeers } from './peer-page.js';

const asked = new URLSearchParams(location.search).get('case');
const exponent = asked === 'nearest-exponent' ? LOBE_WIDTHS * SHININESS : SHININESS;
const { attributes, index } = new SphereGeometry(SPHERE.radius, SPHERE.around, SPHERE.down);
const list = (name: string): string => attributes[name]!.array.join(' ');
const color = (of: readonly number[]): string => of.map((c) => c / 255).join(' ');

await openPeers({
  size: 'square',
  tag: 'x3d-canvas',
  markup: `<x3d-canvas><X3D profile="Interchange" version="4.0"><Scene>
    <Background transparency="1"></Background>
    <NavigationInfo headlight="false"></NavigationInfo>
    <DirectionalLight direction="${TO_LIGHT.map((c) => -c).join(' ')}" ambientIntensity="0"></DirectionalLight>
    <Viewpoint position="0 0 ${EYE_Z}" fieldOfView="${(FOV * Math.PI) / 180}"></Viewpoint>
    <Shape>
      <Appearance>
        <Material ambientIntensity="0" diffuseColor="${color(KD)}" specularColor="${color(KS)}"
          shininess="${exponent / 128}"></Material>
      </Appearance>
      <IndexedTriangleSet index="${index!.array.join(' ')}">
        <Coordinate point="${list('position')}"></Coordinate>
        <Normal vector="${list('normal')}"></Normal>
      </IndexedTriangleSet>
    </Shape>
  </Scene></X3D></x3d-canvas>`,
  loaded: (canvas) => next(canvas, 'load'),
});
