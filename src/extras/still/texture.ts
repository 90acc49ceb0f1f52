// An image between the texels of its largest level.
import { clamp } from '../../phong/math/vector.js';
import type { CastTexture, Wrap } from './cast-scene.js';

/** What a texel's code stands for. */
export type Decode = Float64Array;

/**
 * Writes r, g, b and a, 0–1, to `out`: bilinear, texel centres are at halves. Texels are decoded
 * before they are filtered; alpha is not.
 */
export function readTexture(
  texture: CastTexture,
  u: number,
  v: number,
  decode: Decode,
  out: Float64Array,
): void {
  const { width, height, wrapS = 'repeat', wrapT = 'repeat', data, nearest = false } = texture;
  const half = nearest ? 0 : 0.5;
  const [x, y] = [u * width - half, v * height - half];
  const [i, j] = [Math.floor(x), Math.floor(y)];
  const [right, down] = nearest ? [0, 0] : [x - i, y - j];
  const [above, below] = [
    4 * width * wrapped(j, height, wrapT),
    4 * width * wrapped(j + 1, height, wrapT),
  ];
  const [near, far] = [4 * wrapped(i, width, wrapS), 4 * wrapped(i + 1, width, wrapS)];
  for (let c = 0; c < 4; c++) {
    const at = (texel: number): number =>
      c < 3 ? decode[data[texel + c]!]! : data[texel + c]! / 255;
    const top = at(above + near) + (at(above + far) - at(above + near)) * right;
    const bottom = at(below + near) + (at(below + far) - at(below + near)) * right;
    out[c] = top + (bottom - top) * down;
  }
}

function wrapped(i: number, size: number, wrap: Wrap): number {
  if (wrap === 'clamp') return clamp(i, 0, size - 1);
  const turn = ((i % size) + size) % size;
  return wrap === 'mirror' && Math.floor(i / size) % 2 !== 0 ? size - 1 - turn : turn;
}
