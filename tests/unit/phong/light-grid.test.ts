// A light grid: no cell misses a light that reaches it, few cells list one that does not, and no
// grid is made where it does not pay.

import { describe, expect, it } from 'vitest';
import { LEAST_DIVIDED, divideLights } from '../../../src/phong/light/light-grid.js';
import { KINDS } from '../../../src/phong/light/light-state.js';
import { floatOf, GRID, HEADER, ROWS } from '../../../src/phong/light/light-layout.js';
import type { Box } from '../../../src/phong/light/cull-lights.js';
import type { LightValues } from '../../../src/phong/light/light-state.js';
import { emptyPack, type PackedLights } from '../../../src/phong/light/pack-lights.js';
import { radians } from '../../../src/phong/math/angle.js';
import { cross, dot, length, subtract, type Vec3 } from '../../../src/phong/math/vector.js';
import { fullOr, SEED } from '../../support/repeats.js';
import { float32, Random } from '../../stress/random.js';
import { light } from '../arbitraries.js';
import { pack } from '../packed-reader.js';

const FLOOR: Box = [-10, 0, -10, 10, 0, 10];
const ROOM: Box = [-4, -3, -2, 4, 3, 2];
const DOWN: Vec3 = [0, -1, 0];

/** Spots above the box that point nearly downward. Red ambient light numbers them from 1. */
function spotsOver(box: Box, count: number, random: Random, more: Partial<LightValues> = {}) {
  const unit = Math.max(box[3] - box[0], box[4] - box[1], box[5] - box[2]) / 8;
  const inside = (k: 0 | 2) => random.from(box[k], box[k + 3]!);
  return Array.from({ length: count }, (_, i) =>
    light({
      position: [inside(0), box[4] + unit * random.from(0.5, 2), inside(2), 1],
      axis: subtract(DOWN, random.vector(-0.3, 0.3)),
      aperture: random.from(8, 25),
      ambient: [i + 1, 0, 0],
      ...more,
    }),
  );
}

/** The grid of a box, the number of its cells along each axis, and the size of one. */
function divided(lights: readonly LightValues[], box: Box) {
  const into = emptyPack();
  expect(divideLights(pack(lights), box, into)).toBe(true);
  const size = float32(rowOf(into, gridOf(into) + GRID.size));
  return {
    into,
    size,
    step: [0, 1, 2].map((k) => (box[k + 3]! - box[k]!) / size[k]!) as unknown as Vec3,
  };
}

const rowOf = ({ data }: PackedLights, row: number): Vec3 => [
  data[row * 4]!,
  data[row * 4 + 1]!,
  data[row * 4 + 2]!,
];
const lastOf = ({ data }: PackedLights, row: number) => data[row * 4 + 3]!;
const gridOf = (into: PackedLights) => lastOf(into, HEADER.counts);

/** The number of spots without a list entry; they come first. */
const unlistedOf = (into: PackedLights) => lastOf(into, gridOf(into) + GRID.size);

/** The rows of all lights, by kind. */
function rowsOf({ counts }: PackedLights) {
  let row: number = HEADER.rows;
  return KINDS.map((kind) =>
    Array.from({ length: counts[kind] }, () => {
      row += ROWS[kind].rows;
      return row - ROWS[kind].rows;
    }),
  );
}

/**
 * The rows of the lights that the GLSL adds at p, computed as cellSpots and listedRow do, in
 * float32.
 */
function addedAt(into: PackedLights, p: Vec3) {
  const grid = gridOf(into);
  const [low, scales, size] = [GRID.low, GRID.scale, GRID.size].map((row) =>
    rowOf(into, grid + row),
  ) as [Vec3, Vec3, Vec3];
  const cell = low.map((from, k) => {
    const at = Math.floor(Math.fround(Math.fround(Math.fround(p[k]!) - from) * scales[k]!));
    return Math.min(Math.max(at, 0), size[k]! - 1);
  });
  const index = cell[0]! + size[0] * (cell[1]! + size[1] * cell[2]!);
  const [first, count] = rowOf(into, lastOf(into, grid + GRID.low) + index);
  const lists = lastOf(into, grid + GRID.scale) * 4;
  const listed = [...into.data.subarray(lists + first, lists + first + count)];
  const [directional, point, spot] = rowsOf(into) as [number[], number[], number[]];
  for (const row of listed) {
    expect(spot).toContain(row);
  }
  return [...directional, ...point, ...spot.slice(0, unlistedOf(into)), ...listed];
}

/**
 * Anywhere in the box, its corners and the corners of its cells among it; float32, as fragments
 * have it.
 */
function pointIn(random: Random, box: Box, size: Vec3) {
  const p = [0, 1, 2].map((k) => {
    const [low, high] = [box[k]!, box[k + 3]!];
    const corner = low + (Math.floor(random.from(0, size[k]! + 1)) / size[k]!) * (high - low);
    return random.pick([random.from(low, high), random.from(low, high), corner, low, high]);
  });
  return float32(p as unknown as Vec3);
}

/** Whether p is within a spot's cone: by its values, not by its rows. */
function isLit({ position: [x, y, z], axis, aperture }: LightValues, p: Vec3) {
  const v = subtract(p, [x, y, z]);
  return Math.atan2(length(cross(v, axis)), dot(v, axis)) <= radians(aperture);
}

/**
 * The rows that each of `lights` has in `into`, found by its red ambient light, which is its
 * number: spots alone.
 */
const rowByNumber = (into: PackedLights) =>
  new Map(
    rowsOf(into)[2]!.map((row) => [
      Math.round(255 * into.data[row * 4 + floatOf('spot', 'ambient')]!),
      row,
    ]),
  );

/**
 * The corner of a cell and a spot whose cone ends just before it with an upright wall: the nearest
 * point of the next cell's ball is the corner itself. `at` is within the cone, and `p`, as which
 * rounding may take it, in the next cell. In the middle of the box, where a cone itself is taken
 * larger by next to nothing.
 */
function cornerCase(
  random: Random,
  box: Box,
  flat: number,
  [u, v]: readonly [number, number],
  size: Vec3,
  step: Vec3,
  pad: number,
) {
  const corner = [box[0], box[1], box[2]];
  for (const k of [u, v]) {
    corner[k]! += step[k]! * Math.floor(random.from(0.45, 0.55) * size[k]!);
  }
  const outward = [0, 0, 0];
  for (const k of [u, v]) {
    outward[k] = random.sign() * Math.SQRT1_2;
  }
  const moved = (by: number) => corner.map((x, k) => x + by * outward[k]!) as unknown as Vec3;
  const wall = [...moved(-1.3 * pad)];
  wall[flat]! += 1;
  const tilt = radians(20);
  const axis = outward.map((x) => -Math.sin(tilt) * x);
  axis[flat] = -Math.cos(tilt);
  const position = [...wall, 1] as unknown as LightValues['position'];
  const lamp = light({ position, axis: axis as unknown as Vec3, aperture: 20 });
  return { lamp, at: moved(-1.38 * pad), p: moved(0.3 * pad) };
}

describe('lights in a grid', () => {
  it.each([
    ['a floor', FLOOR],
    ['a room', ROOM],
    ['a far wall', [1000, 2000, -3000, 1000, 2010, -2980] as Box],
  ])(
    'are listed in every cell that their cones reach, on %s (seed ' + String(SEED) + ')',
    (_, box) => {
      const random = new Random(SEED);
      const lights = spotsOver(box, 60, random);
      const { into, size } = divided(lights, box);
      const rows = rowByNumber(into);
      let found = 0;
      const points = fullOr(4000, 600);
      for (let i = 0; i < points; i++) {
        const p = pointIn(random, box, size);
        const added = new Set(addedAt(into, p));
        lights.forEach((one, k) => {
          if (!isLit(one, p)) return;
          found += 1;
          if (!added.has(rows.get(k + 1)!)) {
            expect.fail(`light ${k} at ${p}`);
          }
        });
      }
      expect(found).toBeGreaterThan(points / 8);
    },
  );

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
      const cases = Array.from({ length: 60 }, () =>
        cornerCase(random, box, flat, [u, v], size, step, pad),
      );
      const { into } = divided(
        cases.map(({ lamp }, i) => ({ ...lamp, ambient: [i + 1, 0, 0] as const })),
        box,
      );
      const rows = rowByNumber(into);
      cases.forEach(({ lamp, at, p }, i) => {
        expect(isLit(lamp, at)).toBe(true);
        expect(addedAt(into, p), `flat along ${flat}, at ${p}`).toContain(rows.get(i + 1));
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
    for (let x = 0; x < size[0]; x++) {
      for (let z = 0; z < size[2]; z++) {
        listed += addedAt(into, [
          FLOOR[0] + (x + 0.5) * step[0],
          0,
          FLOOR[2] + (z + 0.5) * step[2],
        ]).length;
      }
    }
    const circle = (radius: number) => (36 * Math.PI * radius ** 2) / (step[0] * step[2]);
    const radius = 2 * Math.tan(radians(20));
    const diagonal = Math.hypot(step[0], step[2]);
    expect(listed).toBeGreaterThan(circle(radius));
    expect(listed).toBeLessThan(circle(radius + 2 * diagonal)); // whole cells, by their bounding spheres
  });

  it('are all packed once, unlisted spots before listed ones', () => {
    const random = new Random(SEED + 2);
    const lights = [
      ...spotsOver(FLOOR, 20, random),
      light({ position: [1, 2, 3, 0], diffuse: [1, 2, 3] }),
      light({ position: [0, 4, 0, 1], diffuse: [7, 8, 9], attenuation: [1, 0.5, 0] }),
      light({ position: [1, 1, 1, 1], axis: DOWN, aperture: 179 }),
      ...spotsOver(FLOOR, 30, random, { cutoff: 3 }),
    ];
    const packed = pack(lights);
    const { into } = divided(lights, FLOOR);
    expect(into).toMatchObject({ active: packed.active, sent: packed.sent, counts: packed.counts });
    expect(rowOf(into, HEADER.ambient)).toEqual(rowOf(packed, HEADER.ambient));
    expect(rowOf(into, HEADER.counts)).toEqual(rowOf(packed, HEADER.counts));
    const texts = (one: PackedLights) => {
      let i = 0;
      return rowsOf(one).flatMap((rows, kind) =>
        rows.map((row) => {
          const values = one.data.slice(row * 4, (row + ROWS[KINDS[kind]!].rows) * 4);
          return `${String(one.features[i++])}: ${values.join()}`;
        }),
      );
    };
    expect(unlistedOf(into)).toBe(1);
    // Otherwise in their old order: the lists are the same from one frame to the next.
    const [sun, lamp, ...spots] = texts(packed);
    const wide = spots.splice(20, 1);
    expect(texts(into)).toEqual([sun, lamp, ...wide, ...spots]);
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
    const { size, step } = divided(spotsOver(box, 40, new Random(SEED)), box);
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
  const times = (count: number, one: LightValues) => Array.from({ length: count }, () => one);
  const suns = (count: number) => times(count, light({ position: [0, 1, 0, 0] }));
  const lamps = (count: number) =>
    times(count, light({ position: [0, 1, 0, 1], attenuation: [1, 0, 1000] }));
  const spots = (count: number) => spotsOver(FLOOR, count, random);
  const wide = (count: number) => spotsOver(FLOOR, count, random, { axis: DOWN, aperture: 88 });
  const above = (count: number, height: number, aperture: number) =>
    spotsOver(FLOOR, count, random, { position: [0, height, 0, 1], axis: DOWN, aperture });

  it.each([
    ['too few spots', spots(LEAST_DIVIDED - 1), false],
    ['as many as it takes', spots(LEAST_DIVIDED), true],
    ['too few and a sun', [...spots(LEAST_DIVIDED - 1), ...suns(1)], false],
    ['somewhat less than half suns', [...spots(30), ...suns(26)], true],
    ['more than half suns', [...spots(30), ...suns(31)], false],
    ['more than half lamps', [...spots(30), ...lamps(31)], false],
    ['spots that reach most cells', wide(40), false],
    ['a quarter of such spots', [...wide(10), ...spots(30)], true],
    [
      'one of them, and spots that reach nearly half of the cells',
      [...wide(1), ...above(30, 6.5, 48)],
      true,
    ],
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
