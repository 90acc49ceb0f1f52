// Turns a glTF material's values into the equation's terms. See BaseLook for their meaning. Knows three's parsed
// material, not how it was read.
import type { BufferGeometry, MeshStandardMaterial, Texture } from 'three';
import { LIMITS } from '../../light/light-state.js';
import { type BaseLook, exponentOfRoughness } from '../../material/file-surface.js';
import { SURFACE_FIELDS, type SurfaceValues } from '../../material/material-values.js';
import { srgbEncode } from '../../math/color.js';
import { map, multiply, type Vec3 } from '../../math/vector.js';
import type { MaterialValues } from './materials.js';

/** The maps of a material that are drawn, with those that the geometry has no coordinates for left out. */
export function mapsOf(material: MeshStandardMaterial, geometry: BufferGeometry) {
  const usable = (map: Texture | null): Texture | null =>
    map !== null && geometry.hasAttribute(uvNameOf(map)) ? map : null;
  const { unlit = false, emissive = [] } = valuesOf(material) ?? {};
  return {
    map: usable(material.map),
    emissiveMap: emissive.some((c) => c > 0) && !unlit ? usable(material.emissiveMap) : null,
    metalRoughMap: unlit ? null : usable(material.metalnessMap),
    normalMap: unlit ? null : usable(material.normalMap),
  };
}

/** The attribute of a map's texture coordinates. */
export const uvNameOf = ({ channel }: Texture): string => (channel === 0 ? 'uv' : `uv${String(channel)}`);

/** The values of a material that are not maps. */
export function surfaceOf(
  material: MeshStandardMaterial,
): Pick<BaseLook, 'unlit' | 'emissive' | 'metalness' | 'roughness' | 'normalScale'> {
  const values = valuesOf(material);
  const { emissive: glows, metalRough: rough } = values?.mapped ?? {};
  // The usual factors are 1: without the images, all of it would glow, or be metal.
  const emissive = glows === true && material.emissiveMap === null ? [] : values?.emissive;
  const metalRough = rough === true && material.metalnessMap === null ? null : values?.metalRough;
  const { metalness = 0, roughness = null } = metalRough ?? {};
  return {
    unlit: values?.unlit ?? false,
    emissive: encoded(emissive ?? []),
    metalness,
    roughness,
    normalScale: Math.min(Math.max(values?.normalScale ?? 1, -LIMITS.color), LIMITS.color),
  };
}

/** Ks and the exponent, where the file says something: the specular factor multiplies the default Ks. */
export function coefficientsOf(
  material: MeshStandardMaterial,
  { roughness }: Pick<BaseLook, 'roughness'>,
): Partial<SurfaceValues> {
  const specular = valuesOf(material)?.specular ?? null;
  return {
    ...(specular === null ? {} : { ks: multiply(encoded(specular), SURFACE_FIELDS.ks.fallback) }),
    ...(roughness === null ? {} : { shininess: exponentOfRoughness(roughness) }),
  };
}

/** Null for the parser's own material of meshes that name none. */
const valuesOf = ({ userData }: MeshStandardMaterial): MaterialValues | null =>
  (userData as { surface?: MaterialValues }).surface ?? null;

/** Within a colour's domain: products with texels stay finite. */
const encoded = ([r = 0, g = 0, b = 0]: readonly number[]): Vec3 =>
  map([r, g, b], (c) => Math.min(srgbEncode(c), LIMITS.color / 255));
