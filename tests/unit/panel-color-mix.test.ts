// Does a bright colour survive the split into colour and intensity, and does changing one keep the other?

import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { colorOf, ColorMix, hexOf } from '../../src/gui/color-mix.js';
import type { Vec3 } from '../../src/math/vector.js';

const channel = fc.double({ min: 0, max: 1e6, noNaN: true }).map((n) => (n < 1e-6 ? 0 : n));
const bright: fc.Arbitrary<Vec3> = fc.tuple(channel, channel, channel);
const picked: fc.Arbitrary<Vec3> = fc.tuple(
  ...([1, 2, 3].map(() => fc.integer({ min: 0, max: 255 })) as [
    fc.Arbitrary<number>,
    fc.Arbitrary<number>,
    fc.Arbitrary<number>,
  ]),
);
const intensity = fc.double({ min: 0, max: 100, noNaN: true });
const BLACK: Vec3 = [0, 0, 0];

describe('ColorMix', () => {
  it('makes the largest channel full', () => {
    expect(new ColorMix().split([400, 200, 0])).toEqual({ color: [255, 127.5, 0], intensity: 400 / 255 });
  });

  it('keeps the picked colour, however dark, and keeps the intensity', () => {
    fc.assert(
      fc.property(bright, picked, (value, color) => {
        fc.pre(Math.max(...value) > 0 && Math.max(...value) < 1e5);
        const mix = new ColorMix();
        const before = mix.split(value).intensity;
        const tint = mix.split(mix.recolor(value, color));
        expect(tint).toEqual({ color, intensity: before });
      }),
    );
  });

  it('keeps the colour while the intensity goes to zero and up again', () => {
    fc.assert(
      fc.property(bright, fc.array(intensity, { minLength: 1 }), (value, turns) => {
        fc.pre(Math.max(...value) > 0);
        const mix = new ColorMix();
        const { color } = mix.split(value);
        let now = value;
        for (const turn of [...turns, 0]) now = mix.intensify(now, turn);
        expect(now).toEqual(BLACK);
        expect(mix.split(now)).toEqual({ color, intensity: 0 });
      }),
    );
  });

  it('keeps six digits', () => {
    fc.assert(
      fc.property(bright, (value) => {
        fc.pre(Math.max(...value) > 0);
        const mix = new ColorMix();
        const again = mix.intensify(value, mix.split(value).intensity);
        again.forEach((n, i) => expect(Math.abs(n - value[i]!)).toBeLessThanOrEqual(6e-6 * value[i]!));
      }),
    );
  });

  it('stays within the domain of colours', () => {
    expect(new ColorMix().intensify([255, 0, 0], 1e5)).toEqual([1e6, 0, 0]);
  });

  it('remembers the colour of a light that a script set to black', () => {
    const mix = new ColorMix();
    mix.split([255, 0, 0]);
    expect(mix.split(BLACK)).toEqual({ color: [255, 0, 0], intensity: 0 });
  });

  it('starts from intensity 1 or from white if the value has always been black', () => {
    expect(new ColorMix().recolor(BLACK, [10, 20, 30])).toEqual([10, 20, 30]);
    expect(new ColorMix().intensify(BLACK, 0.5)).toEqual([127.5, 127.5, 127.5]);
  });
});

describe('hexOf', () => {
  it('is inverted by colorOf for integer channels', () => {
    fc.assert(
      fc.property(picked, (color) => {
        expect(colorOf(hexOf(color))).toEqual(color);
      }),
    );
  });

  it('rounds and clamps to what a screen can show', () => {
    expect(hexOf([127.5, 300, -1])).toBe('#80ff00');
  });
});
