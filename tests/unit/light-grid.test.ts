// A light grid: no cell misses a light that reaches it, few cells list one that does not, and no grid is made where it
// does not pay.

import { describe, expect, it } from 'vitest';
import { LEAST_DIVIDED, divideLights } from '../../src/light/light-grid.js';
import { KINDS } from '../../src/light/light-state.js';
import { floatOf, HEADER, ROWS } from '../../src/light/light-layout.js';
import type { Box } from '../../src/light/cull-lights.js';
import type { LightValues } from '../../src/light/light-state.js';
import { emptyPack, type PackedLights } from '../../src/light/pack-lights.js';
import { radians } from '../../src/math/angle.js';
import { fullOr } from '../support/repeats.js';
import { Random } from '../stress/random.js';
import { light } from './arbitraries.js';
import {
  DOWN,
  FLOOR,
  ROOM,
  SEED,
  addedAt,
  cornerCase,
  divided,
  isLit,
  pointIn,
  rowByNumber,
  rowOf,
  rowsOf,
  spotsOver,
  unlistedOf,
} from './grid-lists.js';
import { pack } from './packed-reader.js';

describe('lights in a grid', () => {
  it.each([
    ['a floor', FLOOR],
    ['a room', ROOM],
    ['a far wall', [1000, 2000, -3000, 1000, 2010, -2980] as Box],
  ])('are listed in every cell that their cones reach, on %s (seed ' + String(SEED) + ')', (_, box) => {
    const random = new Random(SEED);
    const lights = spotsOver(box, 60, random);
    const { into, size } = divided(lights, box);
    const rows = rowByNumber(into);
    let found = 0;
    const points = fullOr(4000, 1500);
    for (let i = 0; i < points; i++) {
      const p = pointIn(random, box, size);
      const added = new Set(addedAt(into, p));
      lights.forEach((one, k) => {
        if (!isLit(one, p)) return;
        found += 1;
        if (!added.has(rows.get(k + 1)!)) expect.fail(`light ${k} at ${String(p)}`);
      });
    }
    expect(found).toBeGreaterThan(points / 8);
  });

  it.each([
    ['beside the origin', 0],
    ['far from it', 1e4],
  ])('are listed where rounding moves a point into the next cell, %s', (_, away) => {
    const random = new Random(SEED + 1);
    for (const flat of [0, 1, 2]) {
      const low = [0, 1, 2].map((k) => (k === flat ? away : away - 10));
      const box = [...low, ...low.map((x, k) => (k === flat ? x : x + 20))] as unknown as Box;
      const [u, v] = [(flat + 1) % 3, (flat + 2) % 3] as [number, number];
      const { size, step } = divided(spotsOver(box, 60, random, { aperture: 1 }), box);
      // The margin of cells: a share of their size and of the coordinates.
      const pad = 1e-3 * step[u]! + 1e-6 * Math.max(...box.map(Math.abs));
      const cases = Array.from({ length: 60 }, () => cornerCase(random, box, flat, [u, v], size, step, pad));
      const { into } = divided(
        cases.map(({ lamp }, i) => ({ ...lamp, ambient: [i + 1, 0, 0] as const })),
        box,
      );
      const rows = rowByNumber(into);
      cases.forEach(({ lamp, at, p }, i) => {
        expect(isLit(lamp, at)).toBe(true);
        expect(addedAt(into, p), `flat along ${flat}, at ${String(p)}`).toContain(rows.get(i + 1));
      });
    }
  });

  it('are listed in few cells that they do not reach', () => {
    const lights = Array.from({ length: 36 }, (_, i) => {
      const [x, z] = [3 * (i % 6) - 7.5, 3 * Math.floor(i / 6) - 7.5];
      return light({ position: [x, 2, z, 1], axis: DOWN, aperture: 20 });
    });
    const { into, size, step } = divided(lights, FLOOR);
    let listed = 0;
    for (let x = 0; x < size[0]; x++)
      for (let z = 0; z < size[2]; z++)
        listed += addedAt(into, [FLOOR[0] + (x + 0.5) * step[0], 0, FLOOR[2] + (z + 0.5) * step[2]]).length;
    const circle = (radius: number): number => (36 * Math.PI * radius ** 2) / (step[0] * step[2]);
    const radius = 2 * Math.tan(radians(20));
    const diagonal = Math.hypot(step[0], step[2]);
    expect(listed).toBeGreaterThan(circle(radius));
    expect(listed).toBeLessThan(circle(radius + 2 * diagonal)); // whole cells, by their bounding spheres
  });

  it('are all packed once, unlisted spots before listed ones', () => {
    const random = new Random(SEED + 2);
    const wide = { axis: DOWN, aperture: 179 } as const;
    const lights = [
      ...spotsOver(FLOOR, 20, random),
      light({ position: [1, 2, 3, 0], diffuse: [1, 2, 3] }),
      light({ position: [0, 4, 0, 1], diffuse: [7, 8, 9], attenuation: [1, 0.5, 0] }),
      light({ position: [1, 1, 1, 1], diffuse: [5, 5, 5], ...wide, ambient: [200, 0, 0] }),
      ...spotsOver(FLOOR, 30, random, { cutoff: 3 }),
    ];
    const packed = pack(lights);
    const { into } = divided(lights, FLOOR);
    expect(into).toMatchObject({ active: packed.active, sent: packed.sent, counts: packed.counts });
    expect(rowOf(into, HEADER.ambient)).toEqual(rowOf(packed, HEADER.ambient));
    expect(rowOf(into, HEADER.counts)).toEqual(rowOf(packed, HEADER.counts));
    const texts = (one: PackedLights): string[] => {
      let i = 0;
      return rowsOf(one).flatMap((rows, kind) =>
        rows.map((row) => {
          const values = one.data.slice(row * 4, (row + ROWS[KINDS[kind]!].rows) * 4);
          return `${String(one.features[i++])}: ${values.join()}`;
        }),
      );
    };
    expect(texts(into).toSorted()).toEqual(texts(packed).toSorted());
    expect(unlistedOf(into)).toBe(1);
    expect(into.data[rowsOf(into)[2]![0]! * 4 + floatOf('spot', 'ambient')]).toBe(Math.fround(200 / 255));
    // Otherwise in their old order: the lists are the same from one frame to the next.
    expect(texts(into).slice(3)).toEqual(texts(packed).filter((text) => texts(into).slice(3).includes(text)));
  });
});

describe('cells', () => {
  it.each([
    ['a floor', FLOOR],
    ['a room', ROOM],
    ['a cube', [0, 0, 0, 1, 1, 1] as Box],
    ['a line', [0, 0, 0, 0, 0, 9] as Box],
    ['a plank', [0, 0, 0, 9, 0.01, 1] as Box],
    ['a floor of 1e15', [-1e15, 0, -1e15, 1e15, 0, 1e15] as Box],
  ])('of %s are as long as they are wide, and 4,096 at most', (_, box) => {
    const extent = [0, 1, 2].map((k) => box[k + 3]! - box[k]!);
    const unit = Math.max(...extent);
    const random = new Random(SEED);
    const lights = spotsOver(FLOOR, 40, random).map((one) => {
      const place = [0, 1, 2].map((k) => random.from(box[k]!, box[k + 3]!));
      place[1]! += 0.05 * unit;
      return { ...one, position: [...place, 1] as unknown as LightValues['position'], aperture: 20 };
    });
    const { size, step } = divided(lights, box);
    const count = size[0] * size[1] * size[2];
    expect(count).toBeLessThanOrEqual(4096);
    expect(count).toBeGreaterThan(0.7 * 4096);
    const edges = step.filter((_, k) => size[k]! > 1);
    expect(Math.max(...edges) / Math.min(...edges)).toBeLessThan(1.5);
  });

  it('overwrite those of an earlier grid', () => {
    const random = new Random(SEED);
    const into = emptyPack();
    for (const [box, count] of [
      [FLOOR, 60],
      [ROOM, 30],
      [FLOOR, 40],
    ] as const) {
      const lights = spotsOver(box, count, random);
      expect(divideLights(pack(lights), box, into)).toBe(true);
      const fresh = divided(lights, box).into;
      expect(into.rows).toBe(fresh.rows);
      expect(into.data.subarray(0, into.rows * 4)).toEqual(fresh.data.subarray(0, fresh.rows * 4));
    }
  });
});

describe('a grid is made where it pays', () => {
  const random = new Random(SEED);
  const times = (count: number, one: LightValues): LightValues[] => Array.from({ length: count }, () => one);
  const suns = (count: number) => times(count, light({ position: [0, 1, 0, 0] }));
  const lamps = (count: number) => times(count, light({ position: [0, 1, 0, 1], attenuation: [1, 0, 1000] }));
  const spots = (count: number) => spotsOver(FLOOR, count, random);
  const wide = (count: number) => spotsOver(FLOOR, count, random, { axis: DOWN, aperture: 88 });
  const above = (count: number, height: number, aperture: number) =>
    spotsOver(FLOOR, count, random, { position: [0, height, 0, 1], axis: DOWN, aperture });

  it.each<[string, readonly LightValues[], boolean]>([
    ['too few spots', spots(LEAST_DIVIDED - 1), false],
    ['as many as it takes', spots(LEAST_DIVIDED), true],
    ['too few and a sun', [...spots(LEAST_DIVIDED - 1), ...suns(1)], false],
    ['somewhat less than half suns', [...spots(30), ...suns(26)], true],
    ['more than half suns', [...spots(30), ...suns(31)], false],
    ['more than half lamps', [...spots(30), ...lamps(31)], false],
    ['spots that reach most cells', wide(40), false],
    ['a quarter of such spots', [...wide(10), ...spots(30)], true],
    ['one of them, and spots that reach nearly half of the cells', [...wide(1), ...above(30, 6.5, 48)], true],
    ['ten of them, and such spots', [...wide(10), ...above(30, 6.5, 48)], false],
    ['spots that reach 113 of 400 cells', above(40, 6, 45), true],
    ['spots that reach 254 of 400 cells', above(40, 9, 45), false],
  ])('%s', (_, lights, expected) => {
    expect(divideLights(pack(lights), FLOOR, emptyPack())).toBe(expected);
  });

  it('never of a point, and the given lights are not changed', () => {
    const packed = pack(spots(40));
    const before = [packed.rows, packed.sent, ...packed.data.subarray(0, packed.rows * 4)];
    expect(divideLights(packed, [1, 1, 1, 1, 1, 1], emptyPack())).toBe(false);
    expect(divideLights(packed, FLOOR, emptyPack())).toBe(true);
    expect([packed.rows, packed.sent, ...packed.data.subarray(0, packed.rows * 4)]).toEqual(before);
  });
});
