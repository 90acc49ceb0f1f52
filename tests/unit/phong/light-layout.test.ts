// Do the GLSL's defines name the layout's numbers, and are its limits within what float32 holds?

import { readdirSync, readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { KINDS } from '../../../src/phong/light/light-state.js';
import {
  FEATURES,
  LIGHT_FEATURES,
  layoutDefines,
  PACKED_VALUES,
  TEXTURE_ROWS_LOG2,
} from '../../../src/phong/light/light-layout.js';
import {
  LARGEST_INTEGER_POWER,
  LARGEST_MILD_CUTOFF,
  LARGEST_MILD_POWER,
  LEAST_EXPONENT,
  LIMIT_OPEN,
  NEAREST,
} from '../../../src/phong/light/precision.js';

/** Names and texts. Read in each test: what a module does while it loads no test is charged with. */
const readDefines = () =>
  new Map(
    layoutDefines()
      .split('\n')
      .map((line) => {
        const match = /^#define ([A-Z][A-Z_0-9]*) (\S+)$/.exec(line);
        if (match === null) throw new Error(`not a define: ${line}`);
        return [match[1]!, match[2]!] as const;
      }),
  );

it('the defines of the layout name each thing once, ints for whole numbers and floats for others', () => {
  const defines = readDefines();
  expect(defines.size).toBe(layoutDefines().split('\n').length);
  expect(defines.get('TEXTURE_ROWS_LOG2')).toBe('10');
  expect(defines.get('LIMIT_OPEN')).toBe('4.0');
  for (const name of ['NEAREST_SQUARED', 'LEAST_EXPONENT', 'TINY']) {
    expect(defines.get(name)).toMatch(/[.e]/);
  }
  expect(Number(defines.get('LEAST_EXPONENT'))).toBe(LEAST_EXPONENT);
  expect(Number(defines.get('FEATURE_POWER_SHIFT'))).toBe(LIGHT_FEATURES.powerShift);
  expect(defines.get('POINT_ROWS')).toMatch(/^[1-9]$/);
  expect(Number(defines.get('TINY'))).toBe(2 ** -120);
  expect(Number(defines.get('NEAREST_SQUARED'))).toBeCloseTo(1e-30, 44);
});

describe('the loop over the lights', () => {
  const shaders = readdirSync('shaders')
    .map((name) => readFileSync(`shaders/${name}`, 'utf8'))
    .join('\n');

  it.each(KINDS)('reads every value that is packed for a %s light', (kind) => {
    const name = `${kind.charAt(0).toUpperCase()}${kind.slice(1)}`;
    const body = new RegExp(`void add${name}\\([^]*?\\n\\}`).exec(shaders)?.[0] ?? '';
    const isRead = (value: string) => new RegExp(`\\blight\\.${value}\\b`).test(body);
    expect(PACKED_VALUES[kind].map((value) => value.name).filter((one) => !isRead(one))).toEqual(
      [],
    );
  });

  it('asks for every feature that the mask has a bit for', () => {
    const names = FEATURES.map(({ name }) => name.replace(/[A-Z]/g, '_$&').toUpperCase());
    expect(names.filter((name) => !shaders.includes(`FEATURE_${name}`))).toEqual([]);
  });
});

describe('the layout', () => {
  it('has no series only for powers whose errors stay invisible', () => {
    // 2^-25 for each multiplication, twice 2^-21 for a lawful log2.
    expect(LARGEST_INTEGER_POWER * 2 ** -25).toBeLessThan(2e-6);
    expect(2 * LARGEST_MILD_POWER * 2 ** -21 * Math.LN2).toBeLessThan(0.05 / 255);
    expect(2 * LARGEST_MILD_CUTOFF * 2 ** -21 * Math.LN2).toBeLessThan(0.01 / 255);
    expect(Math.log2(LARGEST_INTEGER_POWER) % 1).toBe(0);
  });

  it('has thresholds that float32 holds, a limit that no chord reaches, and texture rows for every device', () => {
    for (const n of [NEAREST, NEAREST * NEAREST, LEAST_EXPONENT]) {
      expect(Math.fround(n)).toBeGreaterThan(2 ** -126); // normal numbers
    }
    expect(LIMIT_OPEN).toBeGreaterThan(1);
    expect(Math.fround(LIMIT_OPEN)).toBe(LIMIT_OPEN);
    expect(2 ** TEXTURE_ROWS_LOG2).toBeLessThanOrEqual(2048);
  });
});
