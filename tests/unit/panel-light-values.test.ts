// Does choosing a kind of light make it that kind without losing its other values?

import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { KindChange } from '../../src/gui/light-rows.js';
import { kindOf } from '../../src/light/light-features.js';
import { KINDS, type LightKind, LightState, type LightValues } from '../../src/light/light-state.js';
import type { Vec3 } from '../../src/math/vector.js';
import { triple } from './arbitraries.js';

const place = triple(fc.double({ min: -1e15, max: 1e15, noNaN: true }));
const someValues: fc.Arbitrary<Partial<LightValues>> = fc.record(
  {
    position: fc.tuple(place, fc.constantFrom(0, 1)).map(([xyz, w]) => [...xyz, w] as const),
    ...{ axis: place, aperture: fc.constantFrom(0, 20, 90, 180), cutoff: fc.constantFrom(0, 1e-9, 12, 1e6) },
  },
  { requiredKeys: [] },
);

function choose(light: LightState, change: KindChange, kind: LightKind, target: Vec3): void {
  light.assign(change.writesFor(light.values, kind, light.given('axis'), target));
}

describe('KindChange', () => {
  it('turns any light into the chosen kind at the same place', () => {
    fc.assert(
      fc.property(someValues, fc.array(fc.constantFrom(...KINDS)), place, (values, kinds, target) => {
        const light = new LightState(values);
        const choice = new KindChange();
        const before = light.values.position.slice(0, 3);
        for (const kind of kinds) {
          choose(light, choice, kind, target);
          expect(kindOf(light.values)).toBe(kind);
        }
        expect(light.values.position.slice(0, 3)).toEqual(before);
      }),
    );
  });

  it('restores the cone of a spot after other kinds in between', () => {
    fc.assert(
      fc.property(someValues, fc.array(fc.constantFrom(...KINDS)), (values, kinds) => {
        const light = new LightState(values);
        fc.pre(kindOf(light.values) === 'spot');
        const before = { ...light.values };
        const choice = new KindChange();
        for (const kind of [...kinds, 'spot' as const]) choose(light, choice, kind, [0, 0, 0]);
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
