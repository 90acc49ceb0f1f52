// Do the figures of error say what their names say: on pictures whose errors are known, on the published pairs of CIEDE2000,
// and as NVIDIA's own evaluator of FLIP?
import { readFileSync } from 'node:fs';
import { converter, modeLab65, modeRgb, useMode } from 'culori/fn';
import { describe, expect, test } from 'vitest';
import { errorOf, type ColorPicture } from '../bench/error/error-figures.js';
import { flipMap } from '../bench/error/flip.js';
import { flipPairs } from './vectors/flip-pictures.mjs';

useMode(modeRgb);
useMode(modeLab65);
const rgbOf = converter('rgb');

const row = (...data: number[]): ColorPicture => ({
  width: data.length / 3,
  height: 1,
  data: Float64Array.from(data),
});

describe('errors of channels', () => {
  test('are all nothing between equal pictures', () => {
    const { truth } = flipPairs()[0]!;
    const { pixels, ...errors } = errorOf(truth, truth);
    expect(pixels).toBe(96 * 40);
    expect(errors).toEqual({ rmse: 0, p999: 0, max: 0, share: 0, deltaE: 0, deltaEMax: 0, flip: 0 });
  });

  test('are those of channels, not of pixels', () => {
    const { rmse, max, share } = errorOf(row(10, 20, 30, 40, 50, 60), row(10, 23, 30, 40, 46, 60));
    expect(rmse).toBe(Math.sqrt((3 ** 2 + 4 ** 2) / 6));
    expect(max).toBe(4);
    expect(share).toBe(2 / 6);
  });

  test('leave the last thousandth to the maximum', () => {
    // 3,000 channels, of errors 0, 1/100, … 29.99: linear between the neighbours of rank 0.999 * 2999.
    const data = Float64Array.from({ length: 3000 }, (_, i) => i / 100);
    const picture = { width: 50, height: 20, data };
    const { p999, max } = errorOf(picture, { ...picture, data: new Float64Array(3000) });
    expect(p999).toBeCloseTo((0.999 * 2999) / 100, 12);
    expect(max).toBe(29.99);
  });

  test('count a channel as another code only where its nearest code is another', () => {
    expect(errorOf(row(9.6, 10.49, 10.5), row(10.4, 10, 10)).share).toBe(1 / 3);
    expect(errorOf(row(-3, 255, 300), row(0.4, 255.6, 254.5)).share).toBe(0);
  });

  test('go on where a screen ends, but what is seen does not', () => {
    const { rmse, deltaE, flip } = errorOf(row(300, 255, 255), row(255, 255, 255));
    expect(rmse).toBe(45 / Math.sqrt(3));
    expect([deltaE, flip]).toEqual([0, 0]);
  });

  test.each([
    ['sizes that differ', row(1, 2, 3), row(1, 2, 3, 4, 5, 6), 'sizes differ: 1×1 and 2×1'],
    [
      'data that is not as large as it says',
      { width: 2, height: 2, data: new Float32Array(9) },
      row(0, 0, 0),
      'the picture has 9 numbers for 2×2 pixels',
    ],
    ['no pixels', { width: 0, height: 3, data: new Float32Array(0) }, row(0, 0, 0), 'the picture has 0'],
    ['NaN', row(1, 2, 3), row(1, NaN, 3), 'the truth has NaN in channel 1 of pixel 0, 0'],
    ['infinity', row(1, 2, 3, 4, 5, Infinity), row(1, 2, 3, 4, 5, 6), 'Infinity in channel 2 of pixel 1, 0'],
  ] satisfies [string, ColorPicture, ColorPicture, string][])('refuse %s', (_, picture, truth, message) => {
    expect(() => errorOf(picture, truth)).toThrow(message);
  });
});

describe('CIEDE2000', () => {
  // Sharma, Wu, Dalal: "The CIEDE2000 Color-Difference Formula: Implementation Notes, Supplementary Test Data, and Mathematical
  // Observations", Color Research and Application 30 (1), 2005, table 1: the pairs with both colours in sRGB's gamut.
  const PUBLISHED = [
    [[50, 2.5, 0], [50, 0, -2.5], 4.3065],
    [[50, 2.5, 0], [73, 25, -18], 27.1492],
    [[50, 2.5, 0], [61, -5, 29], 22.8977],
    [[50, 2.5, 0], [56, -27, -3], 31.903],
    [[50, 2.5, 0], [58, 24, 15], 19.4535],
    [[50, 2.5, 0], [50, 3.1736, 0.5854], 1],
    [[50, 2.5, 0], [50, 3.2972, 0], 1],
    [[50, 2.5, 0], [50, 1.8634, 0.5757], 1],
    [[50, 2.5, 0], [50, 3.2592, 0.335], 1],
    [[60.2574, -34.0099, 36.2677], [60.4626, -34.1751, 39.4387], 1.2644],
    [[63.0109, -31.0961, -5.8663], [62.8187, -29.7946, -4.0864], 1.263],
    [[61.2901, 3.7196, -5.3901], [61.4292, 2.248, -4.962], 1.8731],
    [[22.7233, 20.0904, -46.694], [23.0331, 14.973, -42.5619], 2.0373],
    [[36.4612, 47.858, 18.3852], [36.2715, 50.5065, 21.2231], 1.4146],
    [[90.8027, -2.0831, 1.441], [91.1528, -1.6435, 0.0447], 1.4441],
    [[90.9257, -0.5406, -0.9208], [88.6381, -0.8985, -0.7239], 1.5381],
    [[6.7747, -0.2908, -2.4247], [5.8714, -0.0985, -2.2286], 0.6377],
  ] as const;

  const pictureOf = ([l, a, b]: readonly [number, number, number]): ColorPicture => {
    const { r, g, b: blue } = rgbOf({ mode: 'lab65', l, a, b });
    return row(255 * r, 255 * g, 255 * blue);
  };

  test.each(PUBLISHED)('of %j and %j is %d, as published', (ours, theirs, published) => {
    const [picture, truth] = [pictureOf(ours), pictureOf(theirs)];
    for (const channel of [...picture.data, ...truth.data]) {
      expect(channel).toBeGreaterThanOrEqual(0);
      expect(channel).toBeLessThanOrEqual(255);
    }
    const { deltaE, deltaEMax } = errorOf(picture, truth);
    expect(Math.abs(deltaE - published)).toBeLessThan(1e-4);
    expect(deltaEMax).toBe(deltaE);
  });

  test('is averaged over all pixels, those that agree included', () => {
    const one = errorOf(row(10, 20, 30), row(60, 20, 30)).deltaE;
    const { deltaE, deltaEMax } = errorOf(row(9, 9, 9, 10, 20, 30), row(9, 9, 9, 60, 20, 30));
    expect(deltaE).toBe(one / 2);
    expect(deltaEMax).toBe(one);
  });
});

describe('FLIP', () => {
  interface Vector {
    readonly name: string;
    readonly mean: number;
    readonly max: number;
    readonly diagonal: readonly number[];
  }
  // flip_evaluator 1.7, by vectors/make_flip.py.
  const vectors = readFileSync(new URL('vectors/flip.jsonl', import.meta.url), 'utf8')
    .trim()
    .split('\n')
    .map((line) => JSON.parse(line) as Vector);
  const pairs = flipPairs();

  test('has a vector for each pair', () => {
    expect(vectors.map(({ name }) => name)).toEqual(pairs.map(({ name }) => name));
  });

  test.each(pairs.map((pair, i) => ({ ...pair, vector: vectors[i]! })))(
    "is NVIDIA's own: $name",
    ({ truth, picture, vector }) => {
      const map = flipMap(picture, truth);
      const mean = map.reduce((sum, x) => sum + x, 0) / map.length;
      const parts = vector.diagonal.length;
      const diagonal = vector.diagonal.map((_, k) => {
        const [x, y] = [Math.floor((k * truth.width) / parts), Math.floor((k * truth.height) / parts)];
        return map[y * truth.width + x]!;
      });
      // What their float32 leaves: measured 2.7e-7 of means, 5.1e-7 of maxima, 2.7e-6 of single pixels.
      expect(Math.abs(mean - vector.mean)).toBeLessThan(5e-7);
      expect(Math.abs(Math.max(...map) - vector.max)).toBeLessThan(1e-6);
      const pixels = diagonal.map((x, k) => Math.abs(x - vector.diagonal[k]!));
      expect(Math.max(...pixels)).toBeLessThan(4e-6);
    },
  );

  test('is the same of pictures that are turned over, turned round or swapped', () => {
    const { truth, picture } = pairs.find(({ name }) => name === 'a highlight that has moved')!;
    const { flip } = errorOf(picture, truth);
    expect(errorOf(truth, picture).flip).toBe(flip);
    // Only sums run in another order: measured 1.4e-16.
    expect(errorOf(mirror(picture), mirror(truth)).flip).toBeCloseTo(flip, 14);
    expect(errorOf(transpose(picture), transpose(truth)).flip).toBeCloseTo(flip, 14);
  });
});

const mirror = (picture: ColorPicture): ColorPicture =>
  rearranged(picture, picture.width, (x, y) => [picture.width - 1 - x, y]);

const transpose = (picture: ColorPicture): ColorPicture =>
  rearranged(picture, picture.height, (x, y) => [y, x]);

function rearranged(
  { width, height, data }: ColorPicture,
  newWidth: number,
  from: (x: number, y: number) => readonly [number, number],
): ColorPicture {
  const pixel = (i: number): number[] => {
    const [x, y] = from(i % newWidth, Math.floor(i / newWidth));
    return [...data.subarray(3 * (y * width + x), 3 * (y * width + x) + 3)];
  };
  const all = Array.from({ length: width * height }, (_, i) => pixel(i)).flat();
  return { width: newWidth, height: (width * height) / newWidth, data: Float64Array.from(all) };
}
