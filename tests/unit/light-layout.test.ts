// Do the GLSL's defines and the packing's offsets come from one table, and does the table hold together?

import { describe, expect, it } from 'vitest';
import {
  GRID,
  HEADER,
  LARGEST_INTEGER_POWER,
  LARGEST_MILD_CUTOFF,
  LARGEST_MILD_POWER,
  layoutDefines,
  LEAST_EXPONENT,
  LIMIT_OPEN,
  NEAREST,
  ROWS,
  TEXTURE_ROWS_LOG2,
} from '../../src/light/light-layout.js';

const defines = new Map(
  layoutDefines()
    .split('\n')
    .map((line) => {
      const match = /^#define ([A-Z][A-Z_0-9]*) (\S+)$/.exec(line);
      if (match === null) throw new Error(`not a define: ${line}`);
      return [match[1]!, match[2]!] as const;
    }),
);

describe('the defines of the layout', () => {
  it('name each thing once', () => {
    expect(defines.size).toBe(layoutDefines().split('\n').length);
  });

  it('are ints for whole numbers and floats for others', () => {
    expect(defines.get('TEXTURE_ROWS_LOG2')).toBe('10');
    expect(defines.get('LIMIT_OPEN')).toBe('4.0');
    for (const name of ['NEAREST_SQUARED', 'LEAST_EXPONENT', 'TINY'])
      expect(defines.get(name)).toMatch(/[.e]/);
    expect(Number(defines.get('TINY'))).toBe(2 ** -120);
    expect(Number(defines.get('NEAREST_SQUARED'))).toBeCloseTo(1e-30, 44);
  });
});

describe('the layout', () => {
  it.each(Object.entries(ROWS))(
    'gives the rows of a %s light distinct places that fill it',
    (_, { rows, ...offsets }) => {
      const places = Object.values(offsets).sort((a, b) => a - b);
      expect(places).toStrictEqual(Array.from({ length: rows }, (_row, i) => i));
    },
  );

  it('gives the rows before a grid’s lists distinct places that fill them', () => {
    const { rows, ...offsets } = GRID;
    expect(Object.values(offsets)).toStrictEqual(Array.from({ length: rows }, (_row, i) => i));
  });

  it('has its header before the first light', () => {
    expect([HEADER.counts, HEADER.ambient].sort()).toStrictEqual([0, 1]);
    expect(HEADER.rows).toBe(2);
  });

  it('begins a spot as a point light, so that one writer serves both', () => {
    const { rows: _rows, ...point } = ROWS.point;
    expect(ROWS.spot).toMatchObject(point);
  });

  it('finds texture rows by a shift', () => {
    expect(2 ** TEXTURE_ROWS_LOG2).toBeLessThanOrEqual(2048);
  });

  it('has no series only for powers whose errors stay invisible: 2^-25 multiplied out, twice 2^-21 of a lawful log2', () => {
    expect(LARGEST_INTEGER_POWER * 2 ** -25).toBeLessThan(2e-6);
    expect(2 * LARGEST_MILD_POWER * 2 ** -21 * Math.LN2).toBeLessThan(0.05 / 255);
    expect(2 * LARGEST_MILD_CUTOFF * 2 ** -21 * Math.LN2).toBeLessThan(0.01 / 255);
    expect(Math.log2(LARGEST_INTEGER_POWER) % 1).toBe(0);
  });

  it('keeps its thresholds normal float32 numbers', () => {
    const normal = 2 ** -126;
    for (const n of [NEAREST, NEAREST * NEAREST, LEAST_EXPONENT])
      expect(Math.fround(n)).toBeGreaterThan(normal);
  });

  it('disables a cone by a limit that no chord reaches and float32 holds exactly', () => {
    expect(LIMIT_OPEN).toBeGreaterThan(1);
    expect(Math.fround(LIMIT_OPEN)).toBe(LIMIT_OPEN);
  });
});
