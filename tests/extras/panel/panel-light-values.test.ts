// Does choosing a kind of light in the panel keep its other values, and a colour its hue and
// brightness?

import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { brightnessOf, colorOf, ColorMix, hexOf } from '../../../src/extras/panel/color-control.js';
import { KindChange } from '../../../src/extras/panel/light-rows.js';
import { kindOf } from '../../../src/phong/light/light-features.js';
import {
  KINDS,
  type LightKind,
  LightState,
  type LightValues,
} from '../../../src/phong/light/light-state.js';
import type { Vec3 } from '../../../src/phong/math/vector.js';
import { between, triple } from '../../unit/arbitraries.js';

const place = triple(between(-1e15, 1e15));
const someValues: fc.Arbitrary<Partial<LightValues>> = fc.record(
  {
    position: fc.tuple(place, fc.constantFrom(0, 1)).map(([xyz, w]) => [...xyz, w] as const),
    axis: place,
    aperture: fc.constantFrom(0, 20, 90, 180),
    cutoff: fc.constantFrom(0, 1e-9, 12, 1e6),
  },
  { requiredKeys: [] },
);

function choose(light: LightState, change: KindChange, kind: LightKind, target: Vec3): void {
  light.assign(change.writesFor(light.values, kind, light.given('axis'), target));
}

describe('KindChange', () => {
  it('turns any light into the chosen kind at the same place', () => {
    fc.assert(
      fc.property(
        someValues,
        fc.array(fc.constantFrom(...KINDS)),
        place,
        (values, kinds, target) => {
          const light = new LightState(values);
          const choice = new KindChange();
          const before = light.values.position.slice(0, 3);
          for (const kind of kinds) {
            choose(light, choice, kind, target);
            expect(kindOf(light.values)).toBe(kind);
          }
          expect(light.values.position.slice(0, 3)).toEqual(before);
        },
      ),
    );
  });

  it('restores the cone of a spot after other kinds in between', () => {
    fc.assert(
      fc.property(someValues, fc.array(fc.constantFrom(...KINDS)), (values, kinds) => {
        const light = new LightState(values);
        fc.pre(kindOf(light.values) === 'spot');
        const before = { ...light.values };
        const choice = new KindChange();
        for (const kind of [...kinds, 'spot' as const]) {
          choose(light, choice, kind, [0, 0, 0]);
        }
        expect(light.values).toEqual(before);
      }),
    );
  });

  it('writes nothing if the light is of that kind already, and points a spot without a target down', () => {
    const { values } = new LightState({ position: [1, 2, 3, 1] });
    expect(new KindChange().writesFor(values, 'point', false, [0, 0, 0])).toEqual({});
    expect(new KindChange().writesFor(values, 'spot', false, [1, 2, 3]).axis).toEqual([0, -1, 0]);
  });
});

const bright = triple(between(0, 1e6).map((n) => (n < 1e-6 ? 0 : n)));
const picked = triple(fc.integer({ min: 0, max: 255 }));
const brightness = between(0.01, 100);

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
      for (const turn of [...turns, 0]) {
        now = mix.brighten(now, turn);
      }
      expect(now).toEqual([0, 0, 0]);
      const again = mix.brighten(now, brightnessOf(value));
      // Six digits, rounded once a turn.
      again.forEach((n, i) =>
        expect(Math.abs(n - value[i]!)).toBeLessThanOrEqual(
          1e-5 * (turns.length + 1) * value[i]! + 1e-9,
        ),
      );
    }),
  );
});

it('stays within the domain of colours, starts at white, and rounds to what a screen can show', () => {
  expect(new ColorMix().brighten([255, 0, 0], 1e5)).toEqual([1e6, 0, 0]);
  expect(new ColorMix().brighten([0, 0, 0], 0.5)).toEqual([127.5, 127.5, 127.5]);
  expect(hexOf([127.5, 300, -1])).toBe('#80ff00');
});
