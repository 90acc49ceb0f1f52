// The reference at values worked out by hand, and at the ends of its domain that equation-vectors.test.ts leaves out.

import { describe, expect, it } from 'vitest';
import type { LightValues } from '../../src/light/light-state.js';
import type { Vec3 } from '../../src/math/vector.js';
import {
  coefficientsOf,
  type Fragment,
  type LightShare,
  type ReferenceOptions,
  shade,
  type Surface,
} from '../../src/reference/equation.js';
import { light } from './arbitraries.js';

/** A floor seen from straight above: N = V = +z. */
const floor: Fragment = { p: [0, 0, 0], normal: [0, 0, 1], eye: [0, 0, 5] };
const white: Surface = { ka: [255, 255, 255], kd: [255, 255, 255], ks: [255, 255, 255], shininess: 2 };
const grey = { ambient: [51, 51, 51], diffuse: [102, 102, 102], specular: [153, 153, 153] } as const;

const one = (
  values: Partial<LightValues>,
  fragment: Partial<Fragment> = {},
  surface: Partial<Surface> = {},
  options: ReferenceOptions = {},
): LightShare =>
  shade({ ...floor, ...fragment }, { ...white, ...surface }, [light({ ...grey, ...values })], options).shares[0]!;

const close = (got: Vec3, want: Vec3): void => {
  got.forEach((x, i) => {
    expect(Math.abs(x - want[i]!)).toBeLessThan(1e-15);
  });
};
const even = (x: number): Vec3 => [x, x, x];

it('takes Ka, Kd and Ks as they are encoded, unless shading is linear', () => {
  const { ka } = coefficientsOf({ ...white, ka: [51, 51, 51] });
  expect(ka).toEqual(even(0.2));
  expect(coefficientsOf({ ...white, ka: [51, 51, 51] }, true).ka[0]).toBeCloseTo(0.0331, 4);
});

it('has no highlight by Blinn where light and eye are exactly opposite, whatever the normal', () => {
  for (let i = 1; i <= 100; i++) {
    const fragment = { normal: [i, 1, 7] as const, eye: [-4, 0, 0] as const };
    const { specular, NoL } = one({ position: [2, 0, 0, 1] }, fragment, {}, { reflection: 'blinn-phong' });
    expect([...specular, NoL > 0]).toEqual([0, 0, 0, true]);
  }
});

describe('by hand', () => {
  const aside = [Math.sqrt(3), 0, 1, 0] as const;
  const above = [0, 0, 2, 1] as const;

  it.each<[string, Partial<LightValues>, ReferenceOptions, Partial<LightShare>, Vec3]>([
    ['a light straight above is full', { position: [0, 0, 3, 0] }, {}, { NoL: 1, RoV: 1 }, [0.2, 0.4, 0.6]],
    ['a light 60° off is half', { position: aside }, {}, { NoL: 0.5, RoV: 0.5 }, [0.2, 0.2, 0.15]],
    [
      'its half vector is 30° off',
      { position: aside },
      { reflection: 'blinn-phong' },
      { RoV: Math.sqrt(0.75) },
      [0.2, 0.2, 0.45],
    ],
    [
      'a lamp loses light as 1/(kc + kl·d + kq·d²), but not its ambient light',
      { position: above, attenuation: [1, 0.5, 0.5] },
      {},
      { d: 2, att: 0.25 },
      [0.2, 0.1, 0.15],
    ],
    [
      'a spot 60° off its axis decays by (3/4)^cutoff, ambient light included',
      { position: above, axis: [Math.sqrt(3), 0, -1], cutoff: 2 },
      {},
      { c: 0.5, decay: 0.5625 },
      [0.1125, 0.225, 0.3375],
    ],
    [
      'a directional light has a decay, but no attenuation',
      { position: [0, 0, 2, 0], axis: [1, 0, 0], cutoff: 1, attenuation: [9, 9, 9] },
      {},
      { att: 1, d: Infinity, decay: 0.5 },
      [0.1, 0.2, 0.3],
    ],
    [
      'a directional light has a cone, outside of which it adds nothing',
      { position: [0, 0, 2, 0], axis: [1, 0, -1], aperture: 44 },
      {},
      { decay: 1 },
      [0, 0, 0],
    ],
    [
      'a lamp has a cone, outside of which it adds nothing',
      { position: above, axis: [1, 0, 0], aperture: 60 },
      {},
      { c: 0 },
      [0, 0, 0],
    ],
  ])('%s', (_, values, options, facts, [ambient, diffuse, specular]) => {
    const share = one(values, {}, {}, options);
    for (const [name, value] of Object.entries(facts))
      expect(share[name as keyof LightShare], name).toBeCloseTo(value as number, 15);
    close(share.ambient, even(ambient));
    close(share.diffuse, even(diffuse));
    close(share.specular, even(specular));
  });

  it('a base colour multiplies Ka and Kd, not Ks', () => {
    const share = one({ position: [0, 0, 1, 0] }, {}, { baseColor: [0.5, 0, 1] });
    close(share.ambient, [0.1, 0, 0.2]);
    close(share.diffuse, [0.2, 0, 0.4]);
    close(share.specular, even(0.6));
  });

  it('a metal loses diffuse light and reflects its base colour; an unlit surface has that alone', () => {
    const look = { baseColor: [0.5, 0, 1], metalness: 0.25, lobeScale: 0.5 } as const;
    const { diffuse, specular } = one({ position: [0, 0, 1, 0] }, {}, look);
    close(diffuse, [0.15, 0, 0.3]);
    close(specular, [0.3, 0.225, 0.375]);
    const unlit = shade(floor, { ...white, ...look, unlit: true }, [light({ ...grey })]);
    expect([unlit.sum, unlit.shares[0]?.ambient]).toStrictEqual([[0.5, 0, 1], even(0)]);
  });

  it('linear light is decoded first and encoded last', () => {
    const lights = [light({ diffuse: [128, 128, 128], specular: [0, 0, 0], position: [0, 0, 1, 0] })];
    close(shade(floor, white, lights, { linear: true }).color, even(128 / 255));
    const twice = shade(floor, white, [...lights, ...lights], { linear: true }).color[0];
    expect(twice).toBeCloseTo(1.055 * (2 * 0.2158605) ** (1 / 2.4) - 0.055, 7);
  });

  it('a light in camera space needs the camera, and an inactive light has no share', () => {
    expect(() => one({ space: 'camera' })).toThrow('a light in camera space needs options.camera');
    expect(shade(floor, white, [light({ active: false }), light()]).shares[0]).toBeNull();
  });
});

describe('limits', () => {
  const above = { position: [0, 0, 2, 1] } as const;

  it.each([0, 1e-300, 9.9e-7, 1e-6, 0.5, 1, 1e6])('exponent %d turns base 0 into 1 only below 1e-6', (n) => {
    const power = n < 1e-6 ? 1 : 0;
    const share = one({ position: [0, 1, 0.1, 0] }, { eye: [0, 3, 4] }, { shininess: n });
    expect(share.RoV).toBeLessThan(0);
    expect(share.specular).toStrictEqual(even(0.6 * power));
    expect(one({ position: [1, 0, 0, 0] }, {}, { shininess: n }).specular).toStrictEqual(even(0)); // NoL = 0
    expect(one({ ...above, axis: [0, 0, 1], cutoff: n }).decay).toBe(power);
  });

  it('a cone below 180 degrees leaves out what is right behind, and one of 0 degrees all off the axis', () => {
    expect(one({ ...above, axis: [0, 0, 1], aperture: 179.9 }).insideCone).toBe(false);
    expect(one({ ...above, axis: [1e-12, 0, -1], aperture: 0 }).insideCone).toBe(false);
  });

  it.each([
    { position: [0, 1, 1, 0], axis: [1, 0, 1], aperture: 120 },
    { position: [-3, -3, 0, 0], axis: [-3, 0, -3], aperture: 120 },
    { position: [0.3, 0.3, 0.2, 0], axis: [-3, -3, -2], aperture: 0 },
  ] as const)('a direction of round numbers exactly at the edge of $aperture degrees is inside', (spot) => {
    expect(one(spot).insideCone).toBe(true);
  });

  const cone = { axis: [0, 0, 1], aperture: 1, cutoff: 99, attenuation: [4, 1e6, 1e6] } as const;
  it.each<[string, Partial<LightValues>, Partial<Fragment>, number]>([
    ['a light at the fragment', { ...cone, position: [0, 0, 0, 1] }, {}, 0.25],
    ['a light 5e-324 from the fragment', { ...cone, position: [0, 0, 5e-324, 1] }, {}, 0.25],
    ['a light 9.9e-16 from the fragment', { ...cone, position: [0, 0, 9.9e-16, 1] }, {}, 0.25],
    ['a directional light without a vector', { ...cone, position: [0, 0, 0, 0] }, {}, 1],
    ['a normal of zero length', above, { normal: [0, 0, 0] }, 1],
  ])('%s leaves ambient light alone', (_, values, fragment, att) => {
    const share = one(values, fragment, { shininess: 0 });
    const dark = { diffuse: even(0), specular: even(0) };
    expect(share).toMatchObject({ NoL: 0, insideCone: true, decay: 1, att, ...dark });
    close(share.ambient, even(0.2));
  });

  it.each<[string, Partial<LightValues>, Partial<Fragment>]>([
    ['a light 1e-15 from the fragment', { position: [0, 0, 1e-15, 1] }, {}],
    ['a directional light with a vector of 5e-324', { position: [0, 0, 5e-324, 0] }, {}],
    ['a normal of length 1e-310', above, { normal: [0, 0, 1e-310] }],
  ])('%s has a direction', (_, values, fragment) => {
    expect(one(values, fragment)).toMatchObject({ L: [0, 0, 1], NoL: 1 });
  });

  it('a light by the camera keeps its place relative to the eye where the eye is 1e15 from the origin', () => {
    const place = [1e15, 0, 0] as const;
    const camera = { right: [1, 0, 0], up: [0, 1, 0], back: [0, 0, 1] } as const;
    const beside = { position: [0.03, 0, 0, 1], space: 'camera' } as const;
    expect(one(beside, { p: place, eye: place }, {}, { camera }).d).toBe(0.03);
  });
});
