// Lights in cells: no cell misses a light that brings something there, nor keeps many that do not. The lists are read back as the
// GLSL reads them, its float32 included.

import { describe, expect, it } from 'vitest';
import { LEAST_DIVIDED, divide } from '../../src/light/light-grid.js';
import { GRID, HEADER, ROWS } from '../../src/light/light-layout.js';
import type { Box, Reflectance } from '../../src/light/light-reach.js';
import type { LightValues } from '../../src/light/light-state.js';
import { emptyPack, KINDS, type PackedLights } from '../../src/light/pack-lights.js';
import { radians } from '../../src/math/angle.js';
import { dot, length, normalize, subtract, type Vec3 } from '../../src/math/vector.js';
import { float32, Random } from '../stress/random.js';
import { light } from './arbitraries.js';
import { pack } from './packed-reader.js';

const SEED = Number(process.env['PHONG_VIEWER_SEED'] ?? 1);
const WHITE: Reflectance = { ka: [1, 1, 1], kd: [1, 1, 1], ks: [1, 1, 1] };
const FLOOR: Box = [-10, 0, -10, 10, 0, 10];
const ROOM: Box = [-4, -3, -2, 4, 3, 2];
const DOWN: Vec3 = [0, -1, 0];

/** Over the box, downward but for a little, each with colours of its own, by which it is told. */
function spotsOver(box: Box, count: number, random: Random, more: Partial<LightValues> = {}): LightValues[] {
  const unit = Math.max(box[3] - box[0], box[4] - box[1], box[5] - box[2]) / 8;
  const inside = (k: 0 | 2): number => random.from(box[k], box[k + 3]!);
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

interface Divided {
  readonly into: PackedLights;
  readonly size: Vec3;
  readonly step: Vec3;
}

function divided(lights: readonly LightValues[], box: Box, budget = 0, surface = WHITE): Divided {
  const into = emptyPack();
  expect(divide(pack(lights), box, surface, budget, into)).toBe(true);
  const size = float32(rowOf(into, gridOf(into) + GRID.size));
  return { into, size, step: [0, 1, 2].map((k) => (box[k + 3]! - box[k]!) / size[k]!) as unknown as Vec3 };
}

const rowOf = ({ data }: PackedLights, row: number): Vec3 => [data[row * 4]!, data[row * 4 + 1]!, data[row * 4 + 2]!]; // prettier-ignore
const lastOf = ({ data }: PackedLights, row: number): number => data[row * 4 + 3]!;
const gridOf = (into: PackedLights): number => lastOf(into, HEADER.counts);

/** The rows of all lights, by kind. */
function rowsOf({ counts }: PackedLights): number[][] {
  let row: number = HEADER.rows;
  return KINDS.map((kind) =>
    Array.from({ length: counts[kind] }, () => {
      row += ROWS[kind].rows;
      return row - ROWS[kind].rows;
    }),
  );
}

/** The rows of the lights that the GLSL adds at p: as cellList and listedRow do, in float32. */
function addedAt(into: PackedLights, p: Vec3): number[] {
  const grid = gridOf(into);
  const [low, scales, size] = [GRID.low, GRID.scale, GRID.size].map((row) => rowOf(into, grid + row)) as [Vec3, Vec3, Vec3]; // prettier-ignore
  const cell = low.map((from, k) => {
    const at = Math.floor(Math.fround(Math.fround(Math.fround(p[k]!) - from) * scales[k]!));
    return Math.min(Math.max(at, 0), size[k]! - 1);
  });
  const index = cell[0]! + size[0] * (cell[1]! + size[1] * cell[2]!);
  const [first, points, spots] = rowOf(into, lastOf(into, grid + GRID.low) + index);
  const lists = lastOf(into, grid + GRID.scale) * 4;
  const listed = [...into.data.subarray(lists + first, lists + first + points + spots)];
  const all = rowsOf(into);
  const everywhere = rowOf(into, grid + GRID.everywhere);
  // The kinds of a list stand in order, and each row is one of its kind's.
  listed.forEach((row, i) => {
    expect(all[i < points ? 1 : 2]).toContain(row);
  });
  return [...all.flatMap((rows, kind) => rows.slice(0, everywhere[kind])), ...listed];
}

/** Anywhere in the box, its corners and the corners of its cells among it; float32, as fragments have it. */
function pointIn(random: Random, box: Box, size: Vec3): Vec3 {
  const p = [0, 1, 2].map((k) => {
    const [low, high] = [box[k]!, box[k + 3]!];
    const corner = low + (Math.floor(random.from(0, size[k]! + 1)) / size[k]!) * (high - low);
    return random.pick([random.from(low, high), random.from(low, high), corner, low, high]);
  });
  return float32(p as unknown as Vec3);
}

/** The most that a light brings at p in any channel, whatever the surface faces: by its values, not by its rows. */
function most({ position, axis, aperture, cutoff, attenuation, ...colors }: LightValues, p: Vec3): number {
  const { ambient, diffuse, specular } = colors;
  const channels = (factor: number, own: number): number =>
    Math.max(...[0, 1, 2].map((k) => own * ambient[k]! + factor * (diffuse[k]! + specular[k]!))) / 255;
  if (position[3] === 0) return channels(1, 0);
  const from = subtract(p, [position[0], position[1], position[2]]);
  const d = length(from);
  const att = 1 / Math.max(attenuation[0] + d * (attenuation[1] + d * attenuation[2]), 1);
  if (aperture === 180 && cutoff === 0) return channels(att, 0); // ambient is of all lamps together
  const c = dot(normalize(from), normalize(axis));
  if (aperture < 180 && Math.acos(Math.min(Math.max(c, -1), 1)) > radians(aperture)) return 0;
  const decay = ((c + 1) / 2) ** cutoff;
  return channels(att * decay, decay);
}

/** The rows that each of `lights` has in `into`, found by its red ambient light, which is its number: spots alone. */
const rowByNumber = (into: PackedLights): Map<number, number> =>
  new Map(rowsOf(into)[2]!.map((row) => [Math.round(255 * into.data[(row + ROWS.spot.ambient) * 4]!), row]));

describe('lights in cells', () => {
  it.each([
    ['a floor', FLOOR],
    ['a room', ROOM],
    ['a far wall', [1000, 2000, -3000, 1000, 2010, -2980] as Box],
  ])('are all listed where their cones reach, on %s (seed ' + String(SEED) + ')', (_, box) => {
    const random = new Random(SEED);
    const lights = spotsOver(box, 60, random);
    const { into, size } = divided(lights, box);
    const rows = rowByNumber(into);
    let found = 0;
    for (let i = 0; i < 4000; i++) {
      const p = pointIn(random, box, size);
      const added = new Set(addedAt(into, p));
      lights.forEach((one, k) => {
        if (most(one, p) === 0) return;
        found += 1;
        if (!added.has(rows.get(k + 1)!)) expect.fail(`light ${k} at ${String(p)}`);
      });
    }
    expect(found).toBeGreaterThan(500);
  });

  it('are listed where rounding takes a point into the next cell or out of the box', () => {
    const random = new Random(SEED + 1);
    const lights = spotsOver(FLOOR, 60, random);
    const { into, size, step } = divided(lights, FLOOR);
    const rows = rowByNumber(into);
    for (let i = 0; i < 4000; i++) {
      const at = pointIn(random, FLOOR, size);
      // 8e-4 of a cell: within what cells are larger by.
      const p: Vec3 = [at[0] + random.sign() * 8e-4 * step[0], at[1], at[2] + random.sign() * 8e-4 * step[2]];
      const added = new Set(addedAt(into, p));
      lights.forEach((one, k) => {
        if (most(one, at) > 0 && !added.has(rows.get(k + 1)!)) expect.fail(`light ${k} at ${String(p)}`);
      });
    }
  });

  it('are listed at few cells beside those that they reach', () => {
    const spot = (i: number): LightValues =>
      light({ position: [3 * (i % 6) - 7.5, 2, 3 * Math.floor(i / 6) - 7.5, 1], axis: DOWN, aperture: 20, ambient: [i + 1, 0, 0] }); // prettier-ignore
    const { into, size, step } = divided(
      Array.from({ length: 36 }, (_, i) => spot(i)),
      FLOOR,
    );
    const lists = addedAt.bind(null, into);
    let listed = 0;
    for (let x = 0; x < size[0]; x++)
      for (let z = 0; z < size[2]; z++)
        listed += lists([FLOOR[0] + (x + 0.5) * step[0], 0, FLOOR[2] + (z + 0.5) * step[2]]).length;
    const circle = (radius: number): number => (36 * Math.PI * radius ** 2) / (step[0] * step[2]);
    const radius = 2 * Math.tan(radians(20));
    const diagonal = Math.hypot(step[0], step[2]);
    expect(listed).toBeGreaterThan(circle(radius));
    expect(listed).toBeLessThan(circle(radius + 2 * diagonal)); // whole cells, of whose balls the cone is asked
  });

  it('are all there, once, those of everywhere first of their kind', () => {
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
    const told = (one: PackedLights): string[] => {
      let i = 0;
      return rowsOf(one).flatMap((rows, kind) =>
        rows.map((row) => {
          const values = one.data.slice(row * 4, (row + ROWS[KINDS[kind]!].rows) * 4);
          return `${String(one.shapes[i++])}: ${values.join()}`;
        }),
      );
    };
    expect(told(into).toSorted()).toEqual(told(packed).toSorted());
    expect(rowOf(into, gridOf(into) + GRID.everywhere)).toEqual([1, 1, 1]);
    expect(into.data[(rowsOf(into)[2]![0]! + ROWS.spot.ambient) * 4]).toBe(Math.fround(200 / 255));
    // In the order in which they were, otherwise: the same lists from one frame to the next.
    expect(told(into).slice(3)).toEqual(told(packed).filter((text) => told(into).slice(3).includes(text)));
  });

  it('that fade are left out where all that are bring less than the budget', () => {
    const random = new Random(SEED + 3);
    for (const [box, ka] of [
      [FLOOR, 1],
      [ROOM, 0.3],
    ] as const) {
      const budget = 2 / 255;
      const surface: Reflectance = { ka: [ka, ka, ka], kd: [0.4, 0.9, 0.2], ks: [0.1, 0.1, 0.6] };
      const lamps = Array.from({ length: 30 }, () =>
        light({
          position: [random.from(box[0], box[3]), box[4] + 0.1, random.from(box[2], box[5]), 1],
          diffuse: random.color(200),
          specular: random.color(200),
          attenuation: [1, 0, random.from(1000, 3000)],
        }),
      );
      const decaying = { aperture: 180, cutoff: 60, attenuation: [1, 0, 4] as const };
      const lights = [...lamps, ...spotsOver(box, 20, random, decaying)];
      const { into, size } = divided(lights, box, budget, surface);
      const [, points = [], spots = []] = rowsOf(into);
      const keyOf = (row: number): string => into.data.subarray(row * 4, row * 4 + 12).join();
      const whole = pack(lights);
      const keys = rowsOf(whole).flat().map((row) => whole.data.subarray(row * 4, row * 4 + 12).join()); // prettier-ignore
      const byKey = new Map([...points, ...spots].map((row) => [keyOf(row), row]));
      const rows = keys.map((key) => byKey.get(key)!);
      let left = 0;
      let kept = 0;
      for (let i = 0; i < 2000; i++) {
        const p = pointIn(random, box, size);
        const added = new Set(addedAt(into, p));
        let sum = 0;
        lights.forEach((one, k) => {
          if (added.has(rows[k]!)) kept += 1;
          else sum += most({ ...one, ...reflected(one, surface) }, p);
        });
        expect(sum, String(p)).toBeLessThanOrEqual(budget);
        left = Math.max(left, sum);
      }
      expect(left).toBeGreaterThan(budget / 20); // something is
      expect(kept / 2000).toBeLessThan(lights.length / 2);
    }
  });
});

/** The colours as a surface gives them back. */
const reflected = ({ ambient, diffuse, specular }: LightValues, { ka, kd, ks }: Reflectance) => {
  const times = (color: Vec3, by: ArrayLike<number>): Vec3 =>
    [0, 1, 2].map((k) => color[k]! * by[k]!) as unknown as Vec3;
  return { ambient: times(ambient, ka), diffuse: times(diffuse, kd), specular: times(specular, ks) };
};

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

  it('are written anew over others', () => {
    const random = new Random(SEED);
    const into = emptyPack();
    for (const [box, count] of [
      [FLOOR, 60],
      [ROOM, 30],
      [FLOOR, 40],
    ] as const) {
      const lights = spotsOver(box, count, random);
      expect(divide(pack(lights), box, WHITE, 0, into)).toBe(true);
      const fresh = divided(lights, box).into;
      expect(into.rows).toBe(fresh.rows);
      expect(into.data.subarray(0, into.rows * 4)).toEqual(fresh.data.subarray(0, fresh.rows * 4));
    }
  });
});

describe('no cells are made', () => {
  const random = new Random(SEED);
  const isDivided = (lights: readonly LightValues[], box: Box = FLOOR, budget = 0): boolean =>
    divide(pack(lights), box, WHITE, budget, emptyPack());
  const sun = light({ position: [0, 1, 0, 0] });
  const lamp = light({ position: [0, 1, 0, 1], attenuation: [1, 0, 1000] });
  const times = (count: number, one: LightValues): LightValues[] => Array.from({ length: count }, () => one);

  it('for few lights', () => {
    expect(isDivided(spotsOver(FLOOR, LEAST_DIVIDED - 1, random))).toBe(false);
    expect(isDivided(spotsOver(FLOOR, LEAST_DIVIDED, random))).toBe(true);
    expect(isDivided([...spotsOver(FLOOR, LEAST_DIVIDED - 1, random), sun])).toBe(false);
  });

  it('where half of the lights reach everywhere anyway', () => {
    const spots = spotsOver(FLOOR, 30, random);
    expect(isDivided([...spots, ...times(26, sun)])).toBe(true);
    expect(isDivided([...spots, ...times(31, sun)])).toBe(false);
    expect(isDivided([...spots, ...times(31, lamp)])).toBe(false);
    expect(isDivided([...spots, ...times(31, lamp)], FLOOR, 1 / 255)).toBe(true);
  });

  it('where each light reaches most of the cells, or all together more than half', () => {
    const wide = (aperture: number): LightValues[] => spotsOver(FLOOR, 40, random, { aperture, axis: DOWN });
    expect(isDivided(wide(88))).toBe(false);
    expect(isDivided([...wide(88).slice(0, 10), ...spotsOver(FLOOR, 30, random)])).toBe(true);
    const half = (height: number): LightValues[] =>
      spotsOver(FLOOR, 40, random, { position: [0, height, 0, 1], axis: DOWN, aperture: 45 });
    expect(isDivided(half(6))).toBe(true); // 113 of 400
    expect(isDivided(half(9))).toBe(false); // 254
  });

  it('of a point', () => {
    expect(isDivided(spotsOver(FLOOR, 40, random), [1, 1, 1, 1, 1, 1])).toBe(false);
  });

  it('reads no light of lists that are not to be: what it was given stays', () => {
    const packed = pack(spotsOver(FLOOR, 40, random));
    const before = [packed.rows, packed.sent, ...packed.data.subarray(0, packed.rows * 4)];
    divide(packed, FLOOR, WHITE, 0, emptyPack());
    expect([packed.rows, packed.sent, ...packed.data.subarray(0, packed.rows * 4)]).toEqual(before);
  });
});
