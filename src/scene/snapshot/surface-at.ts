// A file's surface values at one point: emissive colour, metalness, roughness, mapped normal. From its textures, in
// float64, as phong.frag.glsl computes them.
import type { BufferGeometry, Texture } from 'three';
import { exponentOfRoughness, lobeScale } from '../../material/file-surface.js';
import type { SurfaceValues } from '../../material/material-values.js';
import { srgbDecode, srgbEncode } from '../../math/color.js';
import {
  add,
  cross,
  map,
  multiply,
  negate,
  normalize,
  scale,
  type Vec3,
  type Vec4,
} from '../../math/vector.js';
import type { BaseColor } from './base-color.js';
import type { DrawnLook } from './scene-snapshot.js';
import type { TriangleHit } from './ray-triangles.js';
import { sampleAt } from './sample-at.js';

/** A surface as the reference equation takes it. */
export interface SurfaceHere extends Readonly<SurfaceValues> {
  readonly baseColor: Vec3;
  readonly metalness: number;
  readonly lobeScale: number;
  readonly emissive: Vec3;
  readonly unlit: boolean;
}

/** The surface at a hit. Under Gouraud shading the exponent has no texture. */
export function surfaceAt(
  { look, style, linear, surface }: DrawnLook,
  geometry: BufferGeometry,
  hit: TriangleHit,
  base: BaseColor,
): SurfaceHere {
  const { unlit, emissiveMap, metalRoughMap, roughness } = look;
  const metalRough = metalRoughMap === null ? WHITE : texelAt(metalRoughMap, geometry, hit);
  const varies = metalRoughMap !== null && style.shading !== 'gouraud';
  const shininess =
    roughness !== null && varies ? exponentOfRoughness(roughness * metalRough[1]) : surface.shininess;
  const light = emissiveMap === null ? WHITE : texelAt(emissiveMap, geometry, hit);
  const emissive = linear
    ? map(multiply(map(look.emissive, srgbDecode), map(light, srgbDecode)), srgbEncode)
    : multiply(look.emissive, light);
  return {
    ...surface,
    shininess,
    baseColor: base.color,
    metalness: look.metalness * metalRough[2],
    lobeScale: roughness === null ? 1 : lobeScale(shininess),
    emissive: unlit ? BLACK : emissive,
    unlit,
  };
}

/**
 * N by the normal map where there is one; `N` and `tangent` are interpolated in shading space, for the visible side.
 */
export function mappedNormalAt(
  { look, style }: DrawnLook,
  geometry: BufferGeometry,
  hit: TriangleHit,
  N: Vec3,
  tangent: Vec4 | null,
): Vec3 {
  const { normalMap, normalScale, unlit } = look;
  if (normalMap === null || tangent === null || style.shading !== 'phong' || unlit) return N;
  const front = normalize(hit.front ? N : negate(N));
  const T: Vec3 = [tangent[0], tangent[1], tangent[2]];
  const B = scale(cross(front, T), tangent[3]);
  const [x, y, z] = map(texelAt(normalMap, geometry, hit), (c) => 2 * c - 1);
  const mapped = add(scale(add(scale(T, x), scale(B, y)), normalScale), scale(front, z));
  return hit.front ? mapped : negate(mapped);
}

const BLACK: Vec3 = [0, 0, 0];
const WHITE: Vec3 = [1, 1, 1];

function texelAt(texture: Texture, geometry: BufferGeometry, hit: TriangleHit): Vec3 {
  const [r, g, b] = sampleAt(texture, geometry, hit);
  return [r, g, b];
}
