// The value of a magnified texture at given texture coordinates. Filtered and wrapped by the texture's own settings, in
// float64, without mipmaps.
import {
  ClampToEdgeWrapping,
  MirroredRepeatWrapping,
  NearestFilter,
  type Texture,
  type Wrapping,
} from 'three';
import type { Vec4 } from '../../math/vector.js';
import type { Texels } from './texels.js';

/** The settings of a texture that sampling depends on. */
export type Sampler = Pick<Texture, 'magFilter' | 'wrapS' | 'wrapT' | 'flipY'>;

/** Channels, 0–1, at u, v after the texture's transform. */
export function sample(texels: Texels, map: Sampler, u: number, v: number): Vec4 {
  const x = u * texels.width;
  const y = (map.flipY ? 1 - v : v) * texels.height;
  const column = (i: number): number => wrap(i, texels.width, map.wrapS);
  const row = (j: number): number => wrap(j, texels.height, map.wrapT);
  if (map.magFilter === NearestFilter) return texel(texels, column(Math.floor(x)), row(Math.floor(y)));
  const [i, j] = [Math.floor(x - 0.5), Math.floor(y - 0.5)];
  const [right, below] = [x - 0.5 - i, y - 0.5 - j];
  const line = (at: number): Vec4 =>
    mix(texel(texels, column(i), row(at)), texel(texels, column(i + 1), row(at)), right);
  return mix(line(j), line(j + 1), below);
}

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
  if (wrapping === ClampToEdgeWrapping) return Math.min(Math.max(i, 0), size - 1);
  const turn = ((i % size) + size) % size;
  const mirrored = wrapping === MirroredRepeatWrapping && Math.floor(i / size) % 2 !== 0;
  return mirrored ? size - 1 - turn : turn;
}
