// Does a bright colour survive the split into picker and brightness, and does changing one keep the other?

import fc from 'fast-check';
import { expect, it } from 'vitest';
import { brightnessOf, colorOf, ColorMix, hexOf } from '../../src/gui/color-control.js';
import { triple } from './arbitraries.js';

const bright = triple(fc.double({ min: 0, max: 1e6, noNaN: true }).map((n) => (n < 1e-6 ? 0 : n)));
const picked = triple(fc.integer({ min: 0, max: 255 }));
const brightness = fc.double({ min: 0.01, max: 100, noNaN: true });

it('takes a picked colour for a value up to 255, and the value for the colour', () => {
  fc.assert(
    fc.property(picked, picked, (value, color) => {
      expect(new ColorMix().split(value)).toEqual({ color: value, factor: 1 });
      expect(new ColorMix().recolor(value, color)).toEqual(color);
      expect(colorOf(hexOf(color))).toEqual(color);
    }),
  );
});

it('scales a brighter value so that its largest channel is full', () => {
  expect(new ColorMix().split([510, 255, 0])).toEqual({ color: [255, 127.5, 0], factor: 2 });
});

it('keeps the picked colour, however dark, and the factor of a brighter value', () => {
  fc.assert(
    fc.property(bright, picked, (value, color) => {
      fc.pre(Math.max(...value) > 0 && Math.max(...value) < 1e5);
      const mix = new ColorMix();
      const { factor } = mix.split(value);
      expect(mix.split(mix.recolor(value, color))).toEqual({ color, factor });
    }),
  );
});

it('keeps the hue while the brightness goes to zero and up again', () => {
  fc.assert(
    fc.property(bright, fc.array(brightness, { minLength: 1 }), (value, turns) => {
      fc.pre(Math.max(...value) > 1e-3);
      const mix = new ColorMix();
      let now = value;
      for (const turn of [...turns, 0]) now = mix.brighten(now, turn);
      expect(now).toEqual([0, 0, 0]);
      const again = mix.brighten(now, brightnessOf(value));
      // Six digits, rounded once a turn.
      again.forEach((n, i) =>
        expect(Math.abs(n - value[i]!)).toBeLessThanOrEqual(1e-5 * (turns.length + 1) * value[i]! + 1e-9),
      );
    }),
  );
});

it('stays within the domain of colours, starts at white, and rounds to what a screen can show', () => {
  expect(new ColorMix().brighten([255, 0, 0], 1e5)).toEqual([1e6, 0, 0]);
  expect(new ColorMix().brighten([0, 0, 0], 0.5)).toEqual([127.5, 127.5, 127.5]);
  expect(hexOf([127.5, 300, -1])).toBe('#80ff00');
});
