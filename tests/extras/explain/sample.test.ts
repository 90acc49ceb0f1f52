// What is the value of a magnified texture at texture coordinates, by OpenGL ES 3.0's rules for
// filters and wrapping?

import {
  ClampToEdgeWrapping,
  LinearMipmapLinearFilter,
  type MagnificationTextureFilter,
  type MinificationTextureFilter,
  NearestMipmapLinearFilter,
  PlaneGeometry,
  Texture,
  LinearFilter,
  MirroredRepeatWrapping,
  NearestFilter,
  RepeatWrapping,
  type Wrapping,
} from 'three';
import { describe, expect, it } from 'vitest';
import { srgbDecode } from '../../../src/phong/math/color.js';
import { isMinified, sampleTexture, type Sampler } from '../../../src/extras/explain/sample.js';

/** Red tells the column, green the row, in codes of 255. */
const texels = {
  width: 4,
  height: 2,
  data: Uint8Array.from(
    [0, 1].flatMap((row) => [0, 1, 2, 3].flatMap((column) => [column, row, 0, 255])),
  ),
};

const sampler = (
  wrap: Wrapping,
  magFilter: Sampler['magFilter'] = NearestFilter,
  flipY = false,
): Sampler => ({
  magFilter,
  wrapS: wrap,
  wrapT: wrap,
  flipY,
});

/** Column and row, or what lies between them. */
const at = (map: Sampler, u: number, v: number) =>
  sampleTexture(texels, map, u, v)
    .slice(0, 2)
    .map((x) => Math.round(x * 255 * 1e9) / 1e9);

describe('a texture', () => {
  it('has its first row at v = 0, or at v = 1 where it is flipped', () => {
    expect(at(sampler(RepeatWrapping), 0.1, 0.1)).toEqual([0, 0]);
    expect(at(sampler(RepeatWrapping), 0.9, 0.6)).toEqual([3, 1]);
    expect(at(sampler(RepeatWrapping, NearestFilter, true), 0.9, 0.6)).toEqual([3, 0]);
  });

  it.each([
    ['repeats', RepeatWrapping, [3, 0, 1, 2, 3, 0, 1]],
    ['is mirrored', MirroredRepeatWrapping, [0, 0, 1, 2, 3, 3, 2]],
    ['ends with its edge', ClampToEdgeWrapping, [0, 0, 1, 2, 3, 3, 3]],
  ] as const)('%s beyond its sides', (_, wrap, columns) => {
    const read = [-1, 0, 1, 2, 3, 4, 5].map(
      (column) => at(sampler(wrap), (column + 0.5) / 4, 0.25)[0],
    );
    expect(read).toEqual(columns);
    // Far away, and by whole periods.
    const period = wrap === ClampToEdgeWrapping ? 0 : 2;
    for (const far of [-7, 5]) {
      expect(at(sampler(wrap), 0.375 + far * period, 0.25)[0]).toBe(1);
    }
  });

  it('is interpolated between the centres of texels, also across its borders', () => {
    const linear = (wrap: Wrapping) => sampler(wrap, LinearFilter);
    expect(at(linear(ClampToEdgeWrapping), 1.5 / 4, 0.25)).toEqual([1, 0]);
    expect(at(linear(ClampToEdgeWrapping), 1.75 / 4, 0.25 + 0.05)).toEqual([1.25, 0.1]);
    expect(at(linear(ClampToEdgeWrapping), 0, 0)).toEqual([0, 0]);
    expect(at(linear(RepeatWrapping), 0, 0)).toEqual([1.5, 0.5]);
    expect(at(linear(MirroredRepeatWrapping), 1, 0)).toEqual([3, 0]);
  });

  it('is decoded before it is interpolated, but for alpha', () => {
    const data = new Uint8Array([0, 0, 0, 0, 255, 255, 255, 255]);
    const between = (decoded: boolean) =>
      sampleTexture({ width: 2, height: 1, data }, sampler(ClampToEdgeWrapping, LinearFilter), 0.375, 0.5, decoded); // oxfmt-ignore
    expect(between(true)).toEqual([0.25, 0.25, 0.25, 0.25]);
    data.fill(128);
    const [red, , , alpha] = between(true);
    expect([red, alpha]).toEqual([srgbDecode(128 / 255), 128 / 255]);
    expect(between(false)[0]).toBe(128 / 255);
  });
});

describe('a texture with two filters', () => {
  /**
   * Whether it counts as filtered at so many texels a pixel, turned by an angle against the pixels.
   */
  const isFiltered = (
    mag: MagnificationTextureFilter,
    min: MinificationTextureFilter,
    texels: number,
    turn = 0,
  ) => {
    const geometry = new PlaneGeometry(2, 2);
    const image = { width: 64, height: 64 };
    const map = Object.assign(new Texture(image), { magFilter: mag, minFilter: min });
    map.rotation = turn;
    map.updateMatrix();
    // The first triangle of the plane, at depth 1 in front of the ray.
    const places = [[-1, 1, 1], [-1, -1, 1], [1, 1, 1]] as const; // oxfmt-ignore
    const hit = {
      triangle: 0,
      corners: [0, 2, 1],
      weights: [0, 0.5, 0.5],
      depth: 1,
      front: true,
      rayPlaces: places,
    } as const;
    return isMinified(map, geometry, hit, [texels / 32, texels / 32]);
  };

  it('is filtered wherever a GPU may take the other one, if they differ', () => {
    for (const [mag, min] of [
      [NearestFilter, LinearFilter],
      [NearestFilter, LinearMipmapLinearFilter],
      [LinearFilter, NearestFilter],
      [LinearFilter, NearestMipmapLinearFilter],
    ] as const) {
      expect(isFiltered(mag, min, 0.25)).toBe(false);
      for (const texels of [0.98, 0.999, 1, 1.0005, 2]) {
        expect(isFiltered(mag, min, texels), String(texels)).toBe(true);
      }
    }
  });

  it('is filtered where levels begin, if the filters are of one kind', () => {
    for (const turn of [0, Math.PI / 4]) {
      expect(isFiltered(LinearFilter, LinearMipmapLinearFilter, 0.99, turn)).toBe(false);
      expect(isFiltered(LinearFilter, LinearMipmapLinearFilter, 1.01, turn)).toBe(true);
      expect(isFiltered(LinearFilter, LinearFilter, 3, turn)).toBe(false);
    }
  });
});
