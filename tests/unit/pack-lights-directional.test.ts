// A directional light's cone and decay are the same everywhere: packing applies them once, in float64.

import { describe, expect, it } from 'vitest';
import type { LightValues } from '../../src/light/light-state.js';
import { shade } from '../../src/reference/equation.js';
import { light } from './arbitraries.js';
import { pack, read } from './packed-reader.js';

describe('the cone and decay of a directional light', () => {
  const toward = (degrees: number, more: Partial<LightValues>): LightValues => {
    const angle = (degrees * Math.PI) / 180;
    return light({
      position: [Math.sin(angle), Math.cos(angle), 0, 0],
      axis: [0, -2, 0],
      ambient: [255, 0, 0],
      ...more,
    });
  };

  it('multiply all of its colours', () => {
    const { ambient, directional } = read(pack([toward(60, { cutoff: 2 })]));
    const decay = 0.75 ** 2; // ((1 + cos 60°)/2)²
    expect(ambient[0]).toBeCloseTo(decay, 7);
    expect(directional[0]!['diffuse']!.xyz[2]).toBeCloseTo(decay, 7);
    expect(directional[0]!['specular']!.xyz[0]).toBeCloseTo(decay, 7);
  });

  it.each([1e-3, 0.5, 10, 45, 89, 91, 120, 179, 179.999])('end at %d degrees', (aperture) => {
    expect(pack([toward(aperture * (1 - 1e-9), { aperture })]).sent).toBe(1);
    expect(pack([toward(aperture * (1 + 1e-9), { aperture })]).sent).toBe(0);
  });

  it.each<[number, readonly [number, number, number], readonly [number, number, number]]>([
    [0, [1, 2, 3], [-1, -2, -3]],
    [0, [1, 2, 3], [-0.1, -0.2, -0.3]],
    [45, [1, 1, 0], [-1, 0, 0]],
    [45, [1, 1, 0], [0, -7, 0]],
    [60, [1, Math.sqrt(3), 0], [-1, 0, 0]],
    [90, [0, 0, 5], [-1, -3, 0]],
    [135, [1, 1, 0], [1, 0, 0]],
  ])('take a direction exactly at the edge of %d degrees in', (aperture, [x, y, z], axis) => {
    expect(pack([light({ position: [x, y, z, 0], axis, aperture })]).sent).toBe(1);
  });

  it('of no width accept only what is on the axis', () => {
    const off = (x: number): LightValues => light({ position: [x, 1, 0, 0], axis: [0, -1, 0], aperture: 0 });
    expect(pack([off(0)]).sent).toBe(1);
    expect([1e-3, 1e-8, 1e-10, 1e-14].map((x) => pack([off(x)]).sent)).toStrictEqual([0, 0, 0, 0]);
  });

  it('just below 180 degrees leave out what is right behind', () => {
    const behind = (x: number): LightValues =>
      light({ position: [x, 1, 0, 0], axis: [0, 1, 0], aperture: 180 - 1e-9 });
    expect([0, 1e-12].map((x) => pack([behind(x)]).sent)).toStrictEqual([0, 0]);
    expect([1e-10, 1e-3].map((x) => pack([behind(x)]).sent)).toStrictEqual([1, 1]);
  });

  it('keep the digits of a decay right behind, also with a tiny cutoff', () => {
    const off = 2e-9;
    const behind = (values: Partial<LightValues>): number => {
      const packed = pack([light({ position: [off, 1, 0, 0], axis: [0, 1, 0], ...values })]);
      return read(packed).directional[0]!['diffuse']!.xyz[0];
    };
    // (1 + c)/2 = off²/4, to 1e-18.
    expect(behind({ cutoff: 0.1 }) / ((off * off) / 4) ** 0.1).toBeCloseTo(1, 6);
    expect(behind({ cutoff: 9.9e-7, aperture: 180 - 1e-9 })).toBe(1);
  });

  it('need an axis and a direction', () => {
    const open = { aperture: 0, cutoff: 9, ambient: [255, 0, 0] } as const;
    expect(read(pack([light({ ...open, axis: [0, 0, 0] })])).directional[0]!['diffuse']!.xyz[0]).toBe(1);
    expect(read(pack([light({ ...open, position: [0, 0, 0, 0] })])).ambient[0]).toBe(1);
  });
});

it('include the same round numbers exactly at the edge as the equation', () => {
  const whole = [-2, -1, 0, 1, 2].flatMap((x) =>
    [-2, -1, 0, 1, 2].flatMap((y) => [-1, 0, 1].map((z) => [x, y, z] as const)),
  );
  const vectors = whole.filter((v) => v.some((x) => x !== 0));
  const disagreeing: string[] = [];
  for (const aperture of [0, 30, 45, 60, 90, 120, 135, 150]) {
    for (const [x, y, z] of vectors) {
      for (const axis of vectors) {
        const spot = light({ position: [x, y, z, 0], axis, aperture });
        const { shares } = shade({ p: [0, 0, 0], normal: [0, 1, 0], eye: [0, 1, 0] }, SURFACE, [spot]);
        if (shares[0]?.insideCone !== (pack([spot]).sent === 1))
          disagreeing.push(`${[x, y, z].join(' ')} | ${axis.join(' ')} | ${aperture}`);
      }
    }
  }
  expect(disagreeing).toEqual([]);
});

const SURFACE = { ka: [255, 255, 255], kd: [255, 255, 255], ks: [255, 255, 255], shininess: 1 } as const;
