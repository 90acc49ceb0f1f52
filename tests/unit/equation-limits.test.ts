// The reference at degenerate input, row by row of the table of limits, and at values worked out by hand.

import { describe, expect, it } from 'vitest';
import type { LightValues } from '../../src/light/light-state.js';
import type { Vec3 } from '../../src/math/vector.js';
import {
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
  shade({ ...floor, ...fragment }, { ...white, ...surface }, [light(values)], options).shares[0]!;

const close = (got: Vec3, want: Vec3): void => {
  got.forEach((x, i) => {
    expect(Math.abs(x - want[i]!)).toBeLessThan(1e-15);
  });
};
const even = (x: number): Vec3 => [x, x, x];

describe('by hand', () => {
  it('a light straight above lights fully, and its highlight is full', () => {
    const { ambient, diffuse, specular, NoL, RoV } = one({ ...grey, position: [0, 0, 3, 0] });
    close(ambient, even(0.2));
    close(diffuse, even(0.4));
    close(specular, even(0.6));
    expect([NoL, RoV]).toStrictEqual([1, 1]);
  });

  it('a light 60 degrees off has half the diffuse light, and a quarter of the highlight at exponent 2', () => {
    const share = one({ ...grey, position: [Math.sqrt(3), 0, 1, 0] });
    expect(share.NoL).toBeCloseTo(0.5, 15);
    expect(share.RoV).toBeCloseTo(0.5, 15);
    close(share.diffuse, even(0.2));
    close(share.specular, even(0.15));
  });

  it("Blinn's half vector is 30 degrees off then: three quarters", () => {
    const share = one({ ...grey, position: [Math.sqrt(3), 0, 1, 0] }, {}, {}, { reflection: 'blinn-phong' });
    expect(share.RoV).toBeCloseTo(Math.sqrt(0.75), 15);
    close(share.specular, even(0.45));
  });

  it('a lamp at distance 2 loses light as 1/(kc + kl·d + kq·d²)', () => {
    const share = one({ ...grey, position: [0, 0, 2, 1], attenuation: [1, 0.5, 0.5] });
    expect(share).toMatchObject({ d: 2, att: 0.25 });
    close(share.ambient, even(0.2)); // not attenuated
    close(share.diffuse, even(0.1));
    close(share.specular, even(0.15));
  });

  it('a spot 60 degrees off its axis decays by (3/4)^cutoff, ambient light included', () => {
    const share = one({ ...grey, position: [0, 0, 2, 1], axis: [Math.sqrt(3), 0, -1], cutoff: 2 });
    expect(share.c).toBeCloseTo(0.5, 15);
    close([share.decay, 0, 0], [0.5625, 0, 0]);
    close(share.ambient, even(0.2 * 0.5625));
    close(share.diffuse, even(0.4 * 0.5625));
  });

  it('directional lights have cones and decays too, but no attenuation', () => {
    const sun = { ...grey, position: [0, 0, 2, 0], attenuation: [9, 9, 9] } as const;
    expect(one(sun)).toMatchObject({ att: 1, d: Infinity });
    expect(one({ ...sun, axis: [1, 0, -1], aperture: 44 }).insideCone).toBe(false);
    expect(one({ ...sun, axis: [1, 0, -1], aperture: 46 }).insideCone).toBe(true);
    expect(one({ ...sun, axis: [1, 0, 0], cutoff: 1 }).decay).toBeCloseTo(0.5, 15);
  });

  it('outside its cone a light adds nothing, its ambient light included', () => {
    const share = one({ ...grey, position: [0, 0, 2, 1], axis: [1, 0, 0], aperture: 60 });
    expect(share).toMatchObject({ insideCone: false, ambient: even(0), diffuse: even(0), specular: even(0) });
  });

  it('a base colour multiplies Ka and Kd, not Ks', () => {
    const share = one({ ...grey, position: [0, 0, 1, 0] }, {}, { baseColor: [0.5, 0, 1] });
    close(share.ambient, [0.1, 0, 0.2]);
    close(share.diffuse, [0.2, 0, 0.4]);
    close(share.specular, even(0.6));
  });

  it('a metal loses diffuse light and reflects its base colour; an unlit surface has that alone', () => {
    const look = { baseColor: [0.5, 0, 1], metalness: 0.25, lobeScale: 0.5 } as const;
    const { diffuse, specular } = one({ ...grey, position: [0, 0, 1, 0] }, {}, look);
    close(diffuse, [0.15, 0, 0.3]);
    close(specular, [0.3, 0.225, 0.375]);
    const unlit = shade(floor, { ...white, ...look, unlit: true }, [
      light({ ...grey, position: [0, 0, 1, 0] }),
    ]);
    expect([unlit.sum, unlit.shares[0]?.ambient]).toStrictEqual([[0.5, 0, 1], even(0)]);
  });

  it('sums are clamped for the colour alone', () => {
    const { sum, color } = shade(floor, white, [
      light({ ...grey, diffuse: [510, 0, 0], position: [0, 0, 1, 0] }),
    ]);
    expect(sum[0]).toBeCloseTo(2.8, 15);
    expect(color).toStrictEqual([1, sum[1], sum[2]]);
  });

  it('linear light is decoded first and encoded last', () => {
    const lights = [light({ diffuse: [128, 128, 128], specular: [0, 0, 0], position: [0, 0, 1, 0] })];
    const { color } = shade(floor, white, lights, { linear: true });
    close(color, even(128 / 255));
    const twice = shade(floor, white, [...lights, ...lights], { linear: true }).color[0];
    expect(twice).toBeCloseTo(1.055 * (2 * 0.2158605) ** (1 / 2.4) - 0.055, 7);
  });

  it('a light in camera space stands and points by the camera', () => {
    const camera = { right: [0, 0, -1], up: [0, 1, 0], back: [1, 0, 0] } as const;
    const share = one(
      { position: [0, 0, -2, 1], axis: [0, 0, -1], aperture: 20, space: 'camera' },
      { p: [2, 0, 0], normal: [1, 0, 0], eye: [6, 0, 0] },
      {},
      { camera },
    );
    expect(share).toMatchObject({ d: 2, NoL: 1, c: 1, insideCone: true });
    expect(() => one({ space: 'camera' })).toThrow('a light in camera space needs options.camera');
  });

  it('only the terms in `terms` are summed', () => {
    const lights = [light({ ...grey, position: [0, 0, 1, 0] })];
    close(shade(floor, white, lights, { terms: ['ambient'] }).sum, even(0.2));
    close(shade(floor, white, lights, { terms: ['specular', 'diffuse'] }).sum, even(1));
    close(shade(floor, white, lights, { terms: [] }).sum, even(0));
  });

  it('the sum is black without lights, and an inactive light has no share', () => {
    expect(shade(floor, white, [])).toMatchObject({ sum: even(0), color: even(0), shares: [] });
    expect(shade(floor, white, [light({ active: false }), light()]).shares[0]).toBeNull();
  });
});

describe('limits', () => {
  const above = { ...grey, position: [0, 0, 2, 1] } as const;

  it.each([0, 1e-300, 9.9e-7])('exponent %d turns every base into 1 where light falls', (n) => {
    const spec = (position: LightValues['position']): number =>
      one({ ...grey, position }, {}, { shininess: n }).specular[0];
    expect(spec([0, 0, 1, 0])).toBe(0.6);
    expect(spec([1, 0, 1e-3, 0])).toBe(0.6); // R·V below 0
    expect(spec([1, 0, 1, 0])).toBe(0.6);
    expect(spec([1, 0, 0, 0])).toBe(0); // NoL = 0
    expect(spec([1, 0, -1, 0])).toBe(0);
    expect(one({ ...above, axis: [0, 0, 1], cutoff: n }).decay).toBe(1);
  });

  it.each([1e-6, 0.5, 1, 1e6])('exponent %d turns base 0 into 0', (n) => {
    const aside = { eye: [0, 3, 4] } as const;
    const share = one({ position: [0, 1, 0.1, 0] }, aside, { shininess: n });
    expect(share.RoV).toBeLessThan(0);
    expect(share.NoL).toBeGreaterThan(0);
    expect(share.specular).toStrictEqual(even(0));
    expect(one({ ...above, axis: [0, 0, 1], cutoff: n })).toMatchObject({ decay: 0, ambient: even(0) });
  });

  it('aperture 180 accepts every direction, even the one right behind', () => {
    expect(one({ ...above, axis: [0, 0, 1], aperture: 180 })).toMatchObject({ insideCone: true, decay: 1 });
    expect(one({ ...above, axis: [0, 0, 1], aperture: 179.9 }).insideCone).toBe(false);
  });

  it('aperture 0 accepts only what is exactly on the axis', () => {
    expect(one({ ...above, axis: [0, 0, -3], aperture: 0 }).insideCone).toBe(true);
    expect(one({ ...above, position: [1, 2, 3, 1], axis: [-7, -14, -21], aperture: 0 }).insideCone).toBe(
      true,
    );
    expect(one({ ...above, axis: [1e-12, 0, -1], aperture: 0 }).insideCone).toBe(false);
  });

  it('an axis of zero length means no cone and no decay', () => {
    expect(one({ ...above, axis: [0, 0, 0], aperture: 1, cutoff: 99 })).toMatchObject({
      insideCone: true,
      decay: 1,
      c: 1,
    });
  });

  it.each([0, 5e-324, 9.9e-16])('a light %d from the fragment has no direction', (d) => {
    const share = one(
      {
        ...grey,
        position: [0, 0, d, 1],
        axis: [0, 0, 1],
        aperture: 1,
        cutoff: 99,
        attenuation: [4, 1e6, 1e6],
      },
      {},
      { shininess: 0 },
    );
    expect(share).toMatchObject({ L: even(0), NoL: 0, insideCone: true, decay: 1, att: 0.25 });
    close(share.ambient, even(0.2));
    expect([share.diffuse, share.specular]).toStrictEqual([even(0), even(0)]);
  });

  it('a light 1e-15 away has one', () => {
    expect(one({ ...grey, position: [0, 0, 1e-15, 1] })).toMatchObject({ L: [0, 0, 1], NoL: 1 });
  });

  it('a directional light without a vector leaves its ambient light', () => {
    const share = one({ ...grey, position: [0, 0, 0, 0], aperture: 1, cutoff: 99 }, {}, { shininess: 0 });
    close(share.ambient, even(0.2));
    expect(share).toMatchObject({ NoL: 0, decay: 1, diffuse: even(0), specular: even(0) });
    expect(one({ position: [0, 0, 5e-324, 0] }).NoL).toBe(1);
  });

  it('a normal of zero length leaves ambient light', () => {
    const share = one(above, { normal: [0, 0, 0] }, { shininess: 0 });
    close(share.ambient, even(0.2));
    expect(share).toMatchObject({ NoL: 0, diffuse: even(0), specular: even(0) });
    expect(one(above, { normal: [0, 0, 1e-310] }).NoL).toBe(1);
  });

  it('attenuation 0 0 0, or anything below 1, does not brighten', () => {
    expect(one({ ...above, attenuation: [0, 0, 0] }).att).toBe(1);
    expect(one({ ...above, attenuation: [0.1, 0.1, 0.1] }).att).toBe(1);
  });

  it('an eye at the fragment sees no highlight', () => {
    expect(one(above, { eye: [0, 0, 0] }).specular).toStrictEqual(even(0));
  });
});

describe('powers near their ends', () => {
  it('keeps the decay right behind a spot, where the cosine has no digits left', () => {
    const x = 2e-9; // (1 + c)/2 = x²/4, to 1e-18
    const { decay } = one({ position: [0, 0, 1, 1], axis: [x, 0, 1], cutoff: 0.1 });
    expect(Math.abs(decay / ((x * x) / 4) ** 0.1 - 1)).toBeLessThan(1e-12);
  });

  it('keeps a light’s place relative to the eye where the eye is 1e15 from the origin', () => {
    const place = [1e15, 0, 0] as const;
    const camera = { right: [1, 0, 0], up: [0, 1, 0], back: [0, 0, 1] } as const;
    const beside = { position: [0.03, 0, 0, 1], space: 'camera' } as const;
    expect(one(beside, { p: place, eye: place }, {}, { camera }).d).toBe(0.03);
  });

  it('keeps the highlight at exponent 1e6', () => {
    const off = 1e-3;
    const { specular } = one(
      { position: [Math.sin(off), 0, Math.cos(off), 0], specular: [255, 0, 0] },
      {},
      { shininess: 1e6 },
    );
    expect(Math.abs(specular[0] - Math.exp(1e6 * Math.log(Math.cos(off))))).toBeLessThan(1e-10);
  });
});

it.each([
  { position: [0, 1, 1, 0], axis: [1, 0, 1], aperture: 120 },
  { position: [-3, -3, 0, 0], axis: [-3, 0, -3], aperture: 120 },
  { position: [0.3, 0.3, 0.2, 0], axis: [-3, -3, -2], aperture: 0 },
] as const)('accepts a direction of round numbers exactly at the edge of $aperture degrees', (spot) => {
  expect(one(spot).insideCone).toBe(true);
});
