// A file's surface values at one point, with its textures: in float64, as phong.frag.glsl computes
// them.
import type { BufferGeometry, Texture } from 'three';
import {
  type BaseLook,
  exponentOfRoughness,
  hasMetalness,
  lobeScale,
  usesRoughnessMap,
} from '../../phong/material/file-surface.js';
import type { SurfaceValues } from '../../phong/material/material-values.js';
import { srgbDecode, srgbEncode } from '../../phong/math/color.js';
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
} from '../../phong/math/vector.js';
import type { OwnDrawn } from '../../phong/geometry/scene-snapshot.js';
import type { TriangleHit, TrianglePoint } from './ray-triangles.js';
import { interpolated, isMinified, type PixelSlopes, sampleAt } from './sample.js';

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
  { look, style, linear, surface }: OwnDrawn['phong'],
  geometry: BufferGeometry,
  hit: TrianglePoint,
  base: BaseColor,
): SurfaceHere {
  const { unlit, emissiveMap, metalRoughMap, roughness } = look;
  const metalRough = metalRoughMap === null ? WHITE : texelAt(metalRoughMap, geometry, hit);
  const varies = metalRoughMap !== null && style.shading !== 'gouraud';
  const shininess =
    roughness !== null && varies
      ? exponentOfRoughness(roughness * metalRough[1])
      : surface.shininess;
  const light = emissiveMap === null ? WHITE : texelAt(emissiveMap, geometry, hit, linear);
  const emissive = linear
    ? map(multiply(map(look.emissive, srgbDecode), light), srgbEncode)
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

/** Whether the GPU averages texels of a texture that the surface is read from at one point. */
export function isFiltered(
  { look, style }: OwnDrawn['phong'],
  geometry: BufferGeometry,
  hit: TriangleHit,
  pixel: PixelSlopes,
): boolean {
  const { unlit, map, emissiveMap, metalRoughMap, normalMap } = look;
  const textures = [
    map,
    unlit ? null : emissiveMap,
    hasMetalness(look) || usesRoughnessMap(look, style) ? metalRoughMap : null,
    unlit || style.shading !== 'phong' ? null : normalMap,
  ];
  return textures.some((texture) => texture !== null && isMinified(texture, geometry, hit, pixel));
}

/**
 * N by the normal map, if any; `N` and `tangent` are those of the visible side, in shading space.
 */
export function mappedNormalAt(
  { look, style }: OwnDrawn['phong'],
  geometry: BufferGeometry,
  hit: TrianglePoint,
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

function texelAt(
  texture: Texture,
  geometry: BufferGeometry,
  hit: TrianglePoint,
  linear = false,
): Vec3 {
  const [r, g, b] = sampleAt(texture, geometry, hit, linear);
  return [r, g, b];
}

export interface BaseColor {
  /** Encoded sRGB, 0–1. */
  readonly color: Vec3;
  /** 0–1; 1 where the look does not blend. */
  readonly opacity: number;
  readonly discarded: boolean;
}

/**
 * The look's colour times its texture times its vertex colours. With `linear`, colours are decoded
 * before they are filtered or interpolated, and the product is encoded again.
 */
export function baseColorAt(
  look: BaseLook,
  geometry: BufferGeometry,
  hit: TrianglePoint,
  linear: boolean,
): BaseColor {
  const own = linear ? map(look.baseColor, srgbDecode) : look.baseColor;
  const factors: Vec4[] = [[...own, look.opacity]];
  if (look.map !== null) {
    factors.push(sampleAt(look.map, geometry, hit, linear));
  }
  if (look.vertexColors !== false) {
    factors.push(vertexColorAt(look.vertexColors === 'linear', geometry, hit, linear));
  }
  const product = (channel: 0 | 1 | 2): number => {
    const value = factors.reduce((all, factor) => all * factor[channel], 1);
    return linear ? srgbEncode(value) : value;
  };
  const alpha = factors.reduce((all, factor) => all * factor[3], 1);
  return {
    color: [product(0), product(1), product(2)],
    opacity: look.alphaMode === 'blend' ? alpha : 1,
    discarded: look.alphaMode === 'mask' && alpha < look.alphaCutoff,
  };
}

/** @param storedLinear whether the attribute is in linear light, otherwise encoded. */
function vertexColorAt(
  storedLinear: boolean,
  geometry: BufferGeometry,
  hit: TrianglePoint,
  linear: boolean,
): Vec4 {
  const decode = linear && !storedLinear;
  const [r = 1, g = 1, b = 1, a = 1] = interpolated(geometry, 'color', hit, (value, component) =>
    decode && component < 3 ? srgbDecode(value) : value,
  );
  const color: Vec3 = [r, g, b];
  return [...(storedLinear && !linear ? map(color, srgbEncode) : color), a];
}
