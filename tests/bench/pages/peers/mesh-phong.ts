// three.js's own MeshPhongMaterial under the same lights: as it comes, or without encoding its colours to sRGB.
import {
  Color,
  DirectionalLight,
  MathUtils,
  MeshBasicMaterial,
  MeshPhongMaterial,
  type Object3D,
  PointLight,
  SpotLight,
} from 'three';
import { bentPlane, type Light, lightsOf, SURFACE } from '../scenes.js';
import type { PeerMaker } from './peer.js';
import { geometryOf, plainThree, threePeer } from './plain-three.js';

/** How three.js has the same light: the nearest that it offers. Penumbra and decay are its cone and attenuation. */
export function lightOf({ position, diffuse, axis, aperture = 180 }: Light): Object3D[] {
  const color = new Color(diffuse[0] / 255, diffuse[1] / 255, diffuse[2] / 255);
  const place = position.slice(0, 3) as [number, number, number];
  if (position[3] === 0) {
    const light = new DirectionalLight(color, Math.PI);
    light.position.set(...place);
    return [light];
  }
  // At decay 2 the brightness of a point light falls with the distance squared: so bright that the picture is as before.
  const intensity = Math.PI * position[2] ** 2;
  if (axis === undefined) {
    const light = new PointLight(color, intensity, 0, 2);
    light.position.set(...place);
    return [light];
  }
  const light = new SpotLight(color, intensity, 0, MathUtils.degToRad(aperture), 0.5, 2);
  light.position.set(...place);
  light.target.position.set(place[0] + axis[0], place[1] + axis[1], place[2] + axis[2]);
  return [light, light.target];
}

const maker =
  (encode: boolean): PeerMaker =>
  (holder, query) => {
    const material = new MeshPhongMaterial({ shininess: SURFACE.shininess });
    const three = plainThree(holder, geometryOf(bentPlane()), material, encode);
    for (const light of lightsOf(query)) if (light.active === true) three.scene.add(...lightOf(light));
    return Promise.resolve(threePeer(three));
  };

export const meshPhong = maker(true);
export const meshPhongLinear = maker(false);

/** The same mesh in one colour, by no light at all. */
export const unlit: PeerMaker = (holder) =>
  Promise.resolve(threePeer(plainThree(holder, geometryOf(bentPlane()), new MeshBasicMaterial(), false)));
