// @ts-check
// Pairs of pictures that FLIP is tried on, made anew wherever they are needed: sums, products and roots alone, so that every
// machine gets the same numbers. `node flip-pictures.mjs FOLDER` writes them for make_flip.py as float32, 0-1, rows from the top.

import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

const SEED = 20200713;

/**
 * @typedef {{ width: number, height: number, data: Float32Array }} Picture channels in 0-255
 * @typedef {{ name: string, truth: Picture, picture: Picture }} Pair
 * @returns {Pair[]}
 */
export function flipPairs() {
  const next = random(SEED);
  const ball = sphere([0.4, 0.5, 0.75]);
  return [
    pair('a gradient two codes too bright', painted(96, 40, slope(0)), painted(96, 40, slope(2))),
    pair('a highlight that has moved', ball, sphere([0.47, 0.46, 0.74])),
    pair(
      'shades in steps of eight codes',
      ball,
      mapped(ball, (x) => x - (x % 8)),
    ),
    pair(
      'one pixel off',
      painted(61, 53, () => [90, 120, 150]),
      painted(61, 53, (x, y) => (x === 30 && y === 20 ? [255, 255, 255] : [90, 120, 150])),
    ),
    pair(
      'noise of forty codes',
      ball,
      mapped(ball, (x) => within(x + 80 * (next() - 0.5))),
    ),
    pair(
      'noise of all colours',
      painted(64, 64, () => [255 * next(), 255 * next(), 255 * next()]),
      painted(64, 64, () => [255 * next(), 255 * next(), 255 * next()]),
    ),
    pair('stripes a pixel aside', painted(70, 50, stripes(0)), painted(70, 50, stripes(1))),
    pair(
      'green for blue',
      painted(32, 24, () => [0, 0, 255]),
      painted(32, 24, () => [0, 255, 0]),
    ),
    pair('smaller than the filters', painted(7, 5, slope(0)), painted(7, 5, stripes(0))),
    pair('the same', ball, ball),
  ];
}

/** @param {string} name @param {Picture} truth @param {Picture} picture @returns {Pair} */
const pair = (name, truth, picture) => ({ name, truth, picture });

/** @param {number} more @returns {(x: number, y: number) => number[]} */
const slope = (more) => (x, y) => [within(2.5 * x + more), within(6 * y + more), within(120 - x + more)];

/**
 * Three colours, so that no stripe mirrors itself: where features cancel to zero, FLIP takes the root of what float32 left.
 * @param {number} aside @returns {(x: number) => number[]}
 */
const stripes = (aside) => (x) => {
  const at = (x + aside) % 11;
  return at < 3 ? [240, 230, 20] : at < 6 ? [120, 60, 90] : [10, 20, 60];
};

/** A ball before black, with the highlight that R·V to the 32nd gives. @param {number[]} towards the light, about a unit long */
function sphere([lx = 0, ly = 0, lz = 0]) {
  const size = 80;
  return painted(size, size, (column, row) => {
    const x = (2 * column + 1) / size - 1;
    const y = 1 - (2 * row + 1) / size;
    const square = 1 - (x * x + y * y) / 0.81;
    if (square <= 0) return [0, 0, 0];
    const [nx, ny, nz] = [x / 0.9, y / 0.9, Math.sqrt(square)];
    const c = nx * lx + ny * ly + nz * lz;
    if (c <= 0) return [20, 10, 5];
    let lobe = Math.max(0, 2 * c * nz - lz);
    for (let i = 0; i < 5; i++) lobe *= lobe;
    return [20 + 180 * c, 10 + 90 * c, 5 + 40 * c].map((base) => within(base + 160 * lobe));
  });
}

/** @param {number} width @param {number} height @param {(x: number, y: number) => number[]} color @returns {Picture} */
function painted(width, height, color) {
  const data = new Float32Array(3 * width * height);
  for (let y = 0; y < height; y++) for (let x = 0; x < width; x++) data.set(color(x, y), 3 * (y * width + x));
  return { width, height, data };
}

/** @param {Picture} picture @param {(channel: number) => number} change @returns {Picture} */
const mapped = ({ width, height, data }, change) => ({ width, height, data: data.map(change) });

/** @param {number} channel */
const within = (channel) => Math.min(255, Math.max(0, channel));

/** Uniform in [0, 1): xorshift32 (Marsaglia), enough for noise in pictures. @param {number} seed */
function random(seed) {
  let state = seed;
  return () => {
    state ^= state << 13;
    state ^= state >>> 17;
    state ^= state << 5;
    return (state >>> 0) / 2 ** 32;
  };
}

const [, script, folder] = process.argv;
if (script === fileURLToPath(import.meta.url) && folder !== undefined) {
  const pairs = flipPairs();
  pairs.forEach(({ truth, picture }, i) => {
    writeFileSync(
      join(folder, `${i}-truth.f32`),
      truth.data.map((x) => x / 255),
    );
    writeFileSync(
      join(folder, `${i}-picture.f32`),
      picture.data.map((x) => x / 255),
    );
  });
  const list = pairs.map(({ name, truth: { width, height } }) => ({ name, width, height }));
  writeFileSync(join(folder, 'pairs.json'), JSON.stringify(list));
}
