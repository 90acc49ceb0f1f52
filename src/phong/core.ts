/**
 * `phong-viewer/core`: the material, the lights and the orbit for plain three.js, without elements;
 * and the light loop's GLSL with the function that packs lights for it, for any WebGL 2 program.
 */
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
export { PhongLighting } from './material/lighting.js';
export { type ShadingFrame } from './material/shading-space.js';
export { type BaseLook } from './material/file-surface.js';
export { PhongMaterial } from './material/phong-material.js';
export { type ShadingStyle } from './material/material-values.js';
export { type Sides } from './material/back-faces.js';
export { LIGHT_LOOP_GLSL } from './material/program/source.js';
export type { Vec3, Vec4 } from './math/vector.js';
export { flatGeometry } from './material/flat-geometry.js';
