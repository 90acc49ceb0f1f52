// What the comparison with peers makes of what it sees: rows, lit viewers, and a sphere whose every pixel has a right answer.
import { describe, expect, test } from 'vitest';
import { litCount, NOTHING, peerLine, rowsOf } from '../bench/figures/peer-row.mjs';
import { distanceOf, fragmentAt } from '../bench/pages/distance-truth.js';
import { KD, KS, SHININESS, SIZE, specularForLobe, SPHERE, TO_LIGHT } from '../bench/pages/distance-scene.js';
import { LightState } from '../../src/light/light-state.js';
import { shade } from '../../src/reference/equation.js';

const peers = [
  { name: 'ours', version: '1' },
  { name: 'theirs', version: '2' },
];

describe('rows of peers', () => {
  test('have ratios to the first peer, paired within rounds', () => {
    const [ours, theirs] = rowsOf(
      peers,
      'start',
      'ms',
      [
        [1, 10],
        [3, 20],
      ],
      (ms) => ms,
    );
    expect(ours).toEqual({
      ...{ what: 'start', peer: 'ours', version: '1', unit: 'ms' },
      value: { median: 5.5, low: 3.25, high: 7.75, count: 2 },
    });
    expect(theirs?.ratio).toEqual({ median: 2.5, low: 2.25, high: 2.75, count: 2 });
  });

  test('have no value and no ratio where a sample never came, and survive JSON', () => {
    const rows = rowsOf(
      peers,
      'to all lit',
      'ms',
      [
        [1, 10],
        [3, NaN],
      ],
      (ms) => ms,
      { note: () => 'why' },
    );
    expect(rows[1]).toEqual({
      ...{ what: 'to all lit', peer: 'theirs', version: '2', unit: 'ms' },
      ...{ value: NOTHING, note: 'why' },
    });
    expect(JSON.parse(JSON.stringify(rows))).toEqual(rows);
    expect(peerLine(rows[1]!)).toMatch(/theirs 2 +– +why$/);
  });

  test('have no ratio to nothing at all', () => {
    const rows = rowsOf(peers, 'draws', 'calls', [[0], [60]], (calls) => calls);
    expect(rows[1]).not.toHaveProperty('ratio');
    expect(peerLine(rows[0]!)).toContain(' 0 calls');
  });
});

describe('lit viewers', () => {
  const box = [160, 160, 170] as const;

  test('are those that show what one alone shows, a fade aside', () => {
    expect(litCount([box, [150, 150, 160], [180, 180, 190]], box)).toBe(3);
  });

  test('are neither white pages, nor splash screens, nor buttons', () => {
    expect(
      litCount(
        [
          [255, 255, 255],
          [0, 0, 0],
          [128, 128, 140],
        ],
        box,
      ),
    ).toBe(0);
  });

  test('may be nearly as white as the page, but not as white', () => {
    expect(
      litCount(
        [
          [245, 245, 245],
          [255, 255, 255],
        ],
        [246, 246, 246],
      ),
    ).toBe(1);
  });
});

describe('the sphere that distances are measured on', () => {
  const middle = SIZE / 2;

  test('is met on its surface, its normals pointing to the eye’s side', () => {
    for (const [x, y] of [
      [middle, middle],
      [40, middle],
      [middle, 220],
      [70, 80],
    ] as const) {
      const { p, normal } = fragmentAt(x, y)!;
      // Two roundings of a double at lengths about 1.
      expect(Math.abs(Math.hypot(...p) - SPHERE.radius)).toBeLessThan(1e-15);
      expect(normal[2]).toBeGreaterThan(0);
    }
  });

  test('has its right side right and its upper side up', () => {
    expect(fragmentAt(200, middle)!.p[0]).toBeGreaterThan(0.1);
    expect(fragmentAt(middle, 60)!.p[1]).toBeGreaterThan(0.1);
  });

  test('ends before its edge', () => {
    expect(fragmentAt(0, 0)).toBeNull();
    const row = Array.from({ length: SIZE }, (_, x) => fragmentAt(x, middle)).filter((f) => f !== null);
    for (const { p, eye } of row) {
      const toEye = [eye[0] - p[0], eye[1] - p[1], eye[2] - p[2]];
      const NoV =
        (p[0] * toEye[0]! + p[1] * toEye[1]! + p[2] * toEye[2]!) / SPHERE.radius / Math.hypot(...toEye);
      expect(NoV).toBeGreaterThanOrEqual(0.3 - 1e-15);
    }
    expect(row.length).toBeGreaterThan(SIZE / 2);
  });

  const light = new LightState({ position: [...TO_LIGHT, 0] }).values;
  const surface = { ka: [0, 0, 0], kd: KD, ks: KS, shininess: SHININESS } as const;
  /** Red, green and blue of each pixel, 255 is full; null off the sphere. */
  const exact = Array.from({ length: SIZE * SIZE }, (_, i) => {
    const fragment = fragmentAt(i % SIZE, Math.floor(i / SIZE));
    return fragment && shade(fragment, surface, [light]).color.map((c) => 255 * c);
  });
  /** As a picture. */
  const drawn = (change: (value: number) => number): number[] =>
    exact.flatMap((color) => [...(color ?? [255, 255, 255]).map(change), 255]);

  test('is nowhere so bright that it is clamped, so that no difference hides', () => {
    const lit = exact.flatMap((color) => color ?? []);
    expect(Math.max(...lit)).toBeLessThan(255);
  });

  test('is at no distance from itself, and at that of rounding in 8 bits', () => {
    expect(
      distanceOf(
        drawn((value) => value),
        {},
      ).max,
    ).toBe(0);
    const { rmse, max, pixels } = distanceOf(drawn(Math.round), {});
    expect(max).toBeLessThanOrEqual(0.5);
    // 1/√12 = 0.2887 for evenly spread remainders; measured 0.2868.
    expect(Math.abs(rmse - 1 / Math.sqrt(12))).toBeLessThan(0.003);
    expect(pixels).toBeGreaterThan(SIZE * SIZE * 0.3);
  });

  test('is at the distance of what a picture adds', () => {
    const { rmse, max } = distanceOf(
      drawn((value) => value + 2),
      {},
    );
    expect(rmse).toBeCloseTo(2, 12);
    expect(max).toBeCloseTo(2, 12);
  });
});

test('a highlight made as high as Ks is so by three.js’s own normalisation', () => {
  // BRDF_BlinnPhong at N·H = N·L = 1: specular · 0.25 · (n/2 + 1), its 1/π against the light's π.
  expect(specularForLobe(76, 32) * 0.25 * (32 * 0.5 + 1)).toBeCloseTo(76 / 255, 15);
});
