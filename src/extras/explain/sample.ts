// The value of a magnified texture, or of a vertex attribute, at a point of a triangle. Textures
// are filtered and wrapped by their own settings, in float64, without mipmaps: levels are up to the
// GPU's driver.
import {
  ClampToEdgeWrapping,
  MirroredRepeatWrapping,
  NearestFilter,
  NearestMipmapLinearFilter,
  NearestMipmapNearestFilter,
  type Texture,
  type Wrapping,
  type BufferGeometry,
} from 'three';
import { isDecodable } from '../../phong/material/decoded-texture.js';
import { srgbDecode } from '../../phong/math/color.js';
import { clamp, type Vec4 } from '../../phong/math/vector.js';
import { type TriangleHit, type TrianglePoint, weightsBeside } from './ray-triangles.js';
import { NoWebGL2Error } from '../../phong/material/device.js';

export type Sampler = Pick<Texture, 'magFilter' | 'wrapS' | 'wrapT' | 'flipY'>;

/**
 * Channels, 0–1, at u, v after the texture's transform. @param decoded whether the colours of
 * texels are decoded before they are filtered.
 */
export function sampleTexture(
  texels: Texels,
  map: Sampler,
  u: number,
  v: number,
  decoded = false,
): Vec4 {
  const x = u * texels.width;
  const y = (map.flipY ? 1 - v : v) * texels.height;
  const column = (i: number): number => wrap(i, texels.width, map.wrapS);
  const row = (j: number): number => wrap(j, texels.height, map.wrapT);
  const at = (i: number, j: number): Vec4 => {
    const own = texel(texels, column(i), row(j));
    return decoded ? decode(own) : own;
  };
  if (map.magFilter === NearestFilter) return at(Math.floor(x), Math.floor(y));
  const [i, j] = [Math.floor(x - 0.5), Math.floor(y - 0.5)];
  const [right, below] = [x - 0.5 - i, y - 0.5 - j];
  const line = (k: number): Vec4 => mix(at(i, k), at(i + 1, k), right);
  return mix(line(j), line(j + 1), below);
}

const decode = ([r, g, b, a]: Vec4): Vec4 => [srgbDecode(r), srgbDecode(g), srgbDecode(b), a];

const mix = (a: Vec4, b: Vec4, t: number): Vec4 => [
  a[0] + (b[0] - a[0]) * t,
  a[1] + (b[1] - a[1]) * t,
  a[2] + (b[2] - a[2]) * t,
  a[3] + (b[3] - a[3]) * t,
];

function texel({ width, data }: Texels, column: number, row: number): Vec4 {
  const at = 4 * (row * width + column);
  return [data[at]! / 255, data[at + 1]! / 255, data[at + 2]! / 255, data[at + 3]! / 255];
}

/** Index of the texel that `i` wraps to, in a row of `size`. */
function wrap(i: number, size: number, wrapping: Wrapping): number {
  if (wrapping === ClampToEdgeWrapping) return clamp(i, 0, size - 1);
  const turn = ((i % size) + size) % size;
  const mirrored = wrapping === MirroredRepeatWrapping && Math.floor(i / size) % 2 !== 0;
  return mirrored ? size - 1 - turn : turn;
}

/**
 * A texture at the hit, through its own coordinates and transform. @param linear whether it is
 * wanted in linear light.
 */
export function sampleAt(
  texture: Texture,
  geometry: BufferGeometry,
  hit: TrianglePoint,
  linear: boolean,
): Vec4 {
  const place = coordinatesAt(texture, geometry, hit);
  const isDecoded = linear && isDecodable(texture);
  const value = sampleTexture(texelsOf(texture), texture, ...place, isDecoded);
  return linear && !isDecoded ? decode(value) : value;
}

/** u, v after the texture's transform. */
function coordinatesAt(
  { channel, matrix }: Texture,
  geometry: BufferGeometry,
  place: TrianglePoint,
): [number, number] {
  const [u = 0, v = 0] = interpolated(
    geometry,
    channel === 0 ? 'uv' : `uv${String(channel)}`,
    place,
  );
  const m = matrix.elements;
  return [m[0] * u + m[3] * v + m[6], m[1] * u + m[4] * v + m[7]];
}

/** Slopes of the view ray from one pixel to the next, across and down. */
export type PixelSlopes = readonly [across: number, down: number];

/**
 * Texels in a pixel from which on several of them are averaged; more than 1 by the rounding of a
 * texture that is drawn at its own size. A level that is too coarse by this much is 0.2 codes off
 * between black and white.
 */
const MOST_TEXELS = 1.001;

/**
 * A GPU may take a texture for minified where the larger steps along u and along v add up to more
 * texels: OpenGL ES 3.0, 3.8.9.1, lets it estimate as much. The rest is for its rounding.
 */
const MOST_ESTIMATED = 0.99;

/** Whether a filter takes the nearest texel, with mipmaps or without. */
const isNearest = (filter: number): boolean =>
  filter === NearestFilter ||
  filter === NearestMipmapNearestFilter ||
  filter === NearestMipmapLinearFilter;

/**
 * Whether the GPU averages texels at the hit: the texture is drawn smaller than it is, with another
 * filter.
 */
export function isMinified(
  texture: Texture,
  geometry: BufferGeometry,
  hit: TriangleHit,
  [across, down]: PixelSlopes,
): boolean {
  const { minFilter, magFilter } = texture;
  // The filters without mipmaps are those of magnification.
  if ((minFilter as number) === magFilter) return false;
  const { width, height } = texture.image as Image;
  const [u, v] = coordinatesAt(texture, geometry, hit);
  const texelsTo = (x: number, y: number): readonly [number, number] => {
    const weights = weightsBeside(hit, x, y);
    const [there, below] = coordinatesAt(texture, geometry, { ...hit, weights });
    return [(there - u) * width, (below - v) * height];
  };
  // A GPU takes differences within squares of four pixels, so its neighbour is on either side.
  // Without a level between the two filters, the picture jumps where the GPU takes the other one.
  const jumps = isNearest(magFilter) !== isNearest(minFilter);
  return [1, -1].some((side) => {
    const [a, b] = texelsTo(side * across, 0);
    const [c, d] = texelsTo(0, side * down);
    if (jumps) {
      const most = Math.max(Math.abs(a), Math.abs(c)) + Math.max(Math.abs(b), Math.abs(d));
      return !(most <= MOST_ESTIMATED);
    }
    // The larger singular value: no step as long as a pixel's side crosses more, whatever its
    // direction.
    const most = (Math.hypot(a + d, b - c) + Math.hypot(a - d, b + c)) / 2;
    return !(most <= MOST_TEXELS);
  });
}

/**
 * A vertex attribute at the hit; empty if the geometry lacks it. @param convert is applied to each
 * corner's numbers before.
 */
export function interpolated(
  geometry: BufferGeometry,
  name: string,
  { corners, weights }: TrianglePoint,
  convert: (value: number, component: number) => number = (value) => value,
): number[] {
  if (!geometry.hasAttribute(name)) return [];
  const attribute = geometry.getAttribute(name);
  return Array.from({ length: attribute.itemSize }, (_, c) =>
    corners.reduce(
      (sum, corner, k) => sum + weights[k]! * convert(attribute.getComponent(corner, c), c),
      0,
    ),
  );
}

/** The bytes that a texture's image has on the GPU. */
export interface Texels {
  readonly width: number;
  readonly height: number;
  /** r, g, b, a of each texel with straight alpha, rows as in the image. */
  readonly data: Uint8Array;
}

type Image = TexImageSource & { readonly width: number; readonly height: number };

/** Each image is read once, because fragments are usually explained one after another. */
const read = new WeakMap<object, Texels>();

function texelsOf(map: Texture): Texels {
  if ((map as { isCompressedTexture?: boolean }).isCompressedTexture === true) {
    throw new Error('compressed textures cannot be read');
  }
  const image = map.image as Image;
  const texels = read.get(image) ?? readTexels(image);
  read.set(image, texels);
  return texels;
}

/**
 * Uses a short-lived WebGL context of its own. A 2D canvas would premultiply alpha, and transparent
 * texels would lose the colour that filtering mixes into their neighbours.
 */
function readTexels(image: Image): Texels {
  const gl = document.createElement('canvas').getContext('webgl2');
  if (gl === null) {
    throw new NoWebGL2Error('this browser gives no WebGL 2 context to read a texture with');
  }
  try {
    return readThrough(gl, image);
  } finally {
    gl.getExtension('WEBGL_lose_context')?.loseContext();
  }
}

function readThrough(gl: WebGL2RenderingContext, image: Image): Texels {
  const { width, height } = image;
  const data = new Uint8Array(4 * width * height);
  const texture = gl.createTexture();
  gl.pixelStorei(gl.UNPACK_COLORSPACE_CONVERSION_WEBGL, gl.NONE);
  gl.bindTexture(gl.TEXTURE_2D, texture);
  gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, gl.RGBA, gl.UNSIGNED_BYTE, image);
  gl.bindFramebuffer(gl.FRAMEBUFFER, gl.createFramebuffer());
  gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
  gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, data);
  if (gl.getError() !== gl.NO_ERROR) {
    throw new Error(`a texture of ${String(width)} × ${String(height)} texels cannot be read`);
  }
  return { width, height, data };
}
