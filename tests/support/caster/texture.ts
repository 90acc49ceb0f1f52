// A base colour between the texels of its largest level.
import type { Vec3 } from '../../../src/phong/math/vector.js';
import type { CastTexture, Wrap } from './scene.js';

/** Bilinear, 0–1; texel centres are at halves. */
export function colorOf(texture: CastTexture, u: number, v: number): Vec3 {
  const { width, height, wrapS = 'repeat', wrapT = 'repeat' } = texture;
  const [x, y] = [u * width - 0.5, v * height - 0.5];
  const [i, j] = [Math.floor(x), Math.floor(y)];
  const [left, right] = [wrapped(i, width, wrapS), wrapped(i + 1, width, wrapS)];
  const [above, below] = [wrapped(j, height, wrapT), wrapped(j + 1, height, wrapT)];
  const channel = (c: number): number => {
    const at = (column: number, row: number): number =>
      texture.data[4 * (row * width + column) + c]!;
    const top = at(left, above) + (at(right, above) - at(left, above)) * (x - i);
    const bottom = at(left, below) + (at(right, below) - at(left, below)) * (x - i);
    return (top + (bottom - top) * (y - j)) / 255;
  };
  return [channel(0), channel(1), channel(2)];
}

function wrapped(i: number, size: number, wrap: Wrap): number {
  if (wrap === 'clamp') return Math.min(Math.max(i, 0), size - 1);
  const turn = ((i % size) + size) % size;
  return wrap === 'mirror' && Math.floor(i / size) % 2 !== 0 ? size - 1 - turn : turn;
}
