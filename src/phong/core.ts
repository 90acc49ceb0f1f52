/**
 * `phong-viewer/core`: the material, the lights and the orbit for plain three.js, without elements;
 * and the light loop's GLSL with the function that packs lights for it, for any WebGL 2 program.
 */
import type { Camera } from 'three';
import { PhongLighting as Lighting } from './material/lighting.js';
import { SpecialPrograms } from './material/program/special-programs.js';
import type { Vec3 } from './math/vector.js';

export { type Basis, Orbit, type Pose } from './camera/orbit.js';
export { OrbitInput, type OrbitInputHost } from './camera/orbit-input.js';
export { HEADER, ROWS } from './light/light-layout.js';
export { LightSet } from './light/light-set.js';
export {
  LIGHT_FIELDS,
  type LightSpace,
  LightState,
  type LightValues,
} from './light/light-state.js';
export { emptyPack, type PackedLights, packLights, type PackSpace } from './light/pack-lights.js';
export { declaredFeatures } from './light/light-features.js';
export { coneLimit } from './light/precision.js';
export { SURFACE_FIELDS, type SurfaceValues } from './material/material-values.js';
export { type ShadingFrame } from './material/shading-space.js';
export { type BaseLook } from './material/file-surface.js';
export { PhongMaterial } from './material/phong-material.js';
export { type ShadingStyle } from './material/material-values.js';
export { type Sides } from './material/back-faces.js';
export { LIGHT_LOOP_GLSL } from './material/program/source.js';
export type { Vec3, Vec4 } from './math/vector.js';
export { flatGeometry } from './material/flat-geometry.js';

/** The lights of one picture on their way to its materials. */
export class PhongLighting extends Lighting {
  override readonly special: SpecialPrograms = new SpecialPrograms(this);

  /**
   * Call before each frame, after moving the camera: takes its world matrix and whatever changed
   * about the lights.
   * @param camera any three.js camera with an up-to-date `matrixWorld`
   * @param target where the scene is, in world coordinates: shading is computed relative to it.
   * Default: the world's origin. For scenes far away give their centre, and keep it still while
   * only the camera moves.
   */
  update(camera: Camera, target: Vec3 = [0, 0, 0]): void {
    const e = camera.matrixWorld.elements;
    this.updateFrame({
      origin: target,
      eye: [e[12] - target[0], e[13] - target[1], e[14] - target[2]],
      right: [e[0], e[1], e[2]],
      up: [e[4], e[5], e[6]],
      back: [e[8], e[9], e[10]],
    });
  }
}
