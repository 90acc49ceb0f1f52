// The uniforms that hold what a file says about a surface. Their first values; the material writes those that depend on
// its style.
import { Matrix3, type Texture, Vector3 } from 'three';
import type { BaseLook } from './base-look.js';

/** Uniforms of what a file says; those of a map that a program does not sample are never sent. */
export function fileUniforms(look: BaseLook) {
  const { map, emissiveMap, metalRoughMap, normalMap } = look;
  const transform = (texture: Texture | null) => ({ value: texture?.matrix ?? new Matrix3() });
  return {
    uMap: { value: map },
    uMapTransform: transform(map),
    uEmissiveMap: { value: emissiveMap },
    uEmissiveMapTransform: transform(emissiveMap),
    uMetalRoughMap: { value: metalRoughMap },
    uMetalRoughMapTransform: transform(metalRoughMap),
    uNormalMap: { value: normalMap },
    uNormalMapTransform: transform(normalMap),
    uNormalScale: { value: look.normalScale },
    uMirrored: { value: 1 },
    uBaseColor: { value: new Vector3() },
    uEmissive: { value: new Vector3() },
    uMetalness: { value: look.metalness },
    uRoughness: { value: look.roughness ?? 1 },
    uLobeScale: { value: 1 },
  };
}
