/**
 * `phong-viewer/reference`: the shading equation in float64, to check pictures against and to
 * explain fragments with.
 */
export { LightState, type LightSpace, type LightValues } from '../light/light-state.js';
export type { Vec3, Vec4 } from '../math/vector.js';
export {
  type CameraAxes,
  coefficientsOf,
  type Fragment,
  type LightShare,
  type ReferenceOptions,
  shade,
  type Shaded,
  sumOf,
  type Surface,
} from './equation.js';
