// The one light of a view of a single quantity, as uniforms in shading space. From float64, as packed lights are.
import { Vector4 } from 'three';
import type { LightValues } from '../../light/light-state.js';
import type { PackSpace } from '../../light/pack-lights.js';
import { type Mat4, normalize, type Vec3 } from '../../math/vector.js';

/** Declared in shaders/view_quantity.glsl. */
export const quantityUniforms = () => ({
  uViewPosition: { value: new Vector4() },
  uViewAxis: { value: new Vector4() },
  uViewAttenuation: { value: new Vector4() },
});

/** Writes the light; without one, or with an inactive one, every quantity is 0. */
export function writeQuantityLight(
  into: ReturnType<typeof quantityUniforms>,
  light: Readonly<LightValues> | undefined,
  space: PackSpace,
): void {
  const { uViewPosition, uViewAxis, uViewAttenuation } = into;
  if (light?.active !== true) {
    uViewAttenuation.value.set(1, 0, 0, 0);
    return;
  }
  const matrix = light.space === 'camera' ? space.cameraToShading : space.worldToShading;
  const [x, y, z, w] = light.position;
  const place: Vec3 = w === 0 ? normalize([x, y, z]) : [x, y, z];
  uViewPosition.value.set(...through(matrix, place, w), w);
  uViewAxis.value.set(...through(matrix, normalize(light.axis), 0), light.cutoff);
  uViewAttenuation.value.set(...light.attenuation, 1);
}

const through = (m: Mat4, [x, y, z]: Vec3, w: number): Vec3 => [
  m[0]! * x + m[4]! * y + m[8]! * z + m[12]! * w,
  m[1]! * x + m[5]! * y + m[9]! * z + m[13]! * w,
  m[2]! * x + m[6]! * y + m[10]! * z + m[14]! * w,
];
