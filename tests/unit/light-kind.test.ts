// Which kind of light some values make, and which facts about declared lights a program must know.

import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { gatherFacts, isAttenuated, isSpot, kindOf, noFacts } from '../../src/light/light-features.js';
import type { LightValues } from '../../src/light/light-state.js';
import { anyLight, light } from './arbitraries.js';

const at = { position: [0, 2, 0, 1] } as const satisfies Partial<LightValues>;

describe('the kind of a light', () => {
  it.each<[string, Partial<LightValues>, string]>([
    ['w = 0', {}, 'directional'],
    ['w = 0 with a cone', { aperture: 20, cutoff: 5 }, 'directional'],
    ['w = 1', at, 'point'],
    ['a cone', { ...at, aperture: 179.999 }, 'spot'],
    ['a cone of no width', { ...at, aperture: 0 }, 'spot'],
    ['a decay', { ...at, cutoff: 1e-6 }, 'spot'],
    ['a decay too slight to be one', { ...at, cutoff: 9.99e-7 }, 'point'],
    ['an axis alone', { ...at, axis: [1, 2, 3] }, 'point'],
    ['a cone without an axis', { ...at, aperture: 20, cutoff: 5, axis: [0, 0, 0] }, 'point'],
    ['a cone about the shortest axis', { ...at, aperture: 20, axis: [0, 5e-324, 0] }, 'spot'],
  ])('with %s is %s', (_, values, kind) => {
    expect(kindOf(light(values))).toBe(kind);
  });

  it('is spot only for positional lights that have an axis and a cone or a decay', () => {
    fc.assert(
      fc.property(anyLight, (values) => {
        expect(kindOf(values) === 'spot').toBe(values.position[3] === 1 && isSpot(values));
        expect(kindOf(values) === 'directional').toBe(values.position[3] === 0);
      }),
    );
  });
});

describe('attenuation', () => {
  it.each<[readonly [number, number, number], boolean]>([
    [[1, 0, 0], false],
    [[0, 0, 0], false],
    [[0.5, 0, 0], false],
    [[1.01, 0, 0], true],
    [[0, 5e-324, 0], true],
    [[0, 0, 0.1], true],
  ])('%j of a lamp needs code: %s', (attenuation, needed) => {
    expect(isAttenuated(light({ ...at, attenuation }))).toBe(needed);
    expect(isAttenuated(light({ attenuation }))).toBe(false);
  });

  it('without code is 1 at every distance', () => {
    fc.assert(
      fc.property(anyLight, fc.double({ min: 0, max: 1e16, noNaN: true }), (values, d) => {
        const [kc, kl, kq] = isAttenuated({ ...values, position: [0, 0, 0, 1] })
          ? ([values.attenuation[0] % 1, 0, 0] as const)
          : values.attenuation;
        expect(isAttenuated(light({ ...at, attenuation: [kc, kl, kq] }))).toBe(false);
        expect(1 / Math.max(kc + kl * d + kq * d * d, 1)).toBe(1);
      }),
    );
  });
});

describe('the facts', () => {
  it('are none at first', () => {
    expect(Object.values(noFacts()).some(Boolean)).toBe(false);
  });

  it('name exactly what one light needs', () => {
    const facts = noFacts();
    gatherFacts(light({ ...at, diffuse: [0, 0, 1], specular: [0, 0, 0] }), facts);
    expect(facts).toStrictEqual({ ...noFacts(), point: true, diffuse: true });
    gatherFacts(light({ ambient: [1, 0, 0] }), facts);
    expect(facts).toStrictEqual({
      ...noFacts(),
      point: true,
      directional: true,
      ambient: true,
      diffuse: true,
      specular: true,
    });
    gatherFacts(light({ ...at, aperture: 20, attenuation: [1, 1, 0] }), facts);
    gatherFacts(light({ ...at, cutoff: 2 }), facts);
    expect(Object.values(facts).every(Boolean)).toBe(true);
  });

  it.each<[string, Partial<LightValues>, readonly string[]]>([
    ['a cone', { ...at, aperture: 20 }, ['spot', 'cone']],
    ['a cone of no width', { ...at, aperture: 0 }, ['spot', 'cone']],
    ['a decay', { ...at, cutoff: 1e-6 }, ['spot', 'decay']],
    ['a cone with a decay too slight to be one', { ...at, aperture: 179, cutoff: 9.99e-7 }, ['spot', 'cone']],
    ['both', { ...at, aperture: 20, cutoff: 2 }, ['spot', 'cone', 'decay']],
    ['both, about no axis', { ...at, aperture: 20, cutoff: 2, axis: [0, 0, 0] }, ['point']],
    ['both, of a directional light', { aperture: 20, cutoff: 2 }, ['directional']],
  ])('name of %s no more than a lamp with it needs, and keep it', (_, values, needed) => {
    const black = { ambient: [0, 0, 0], diffuse: [0, 0, 0], specular: [0, 0, 0] } as const;
    const facts = noFacts();
    gatherFacts(light({ ...black, ...values }), facts);
    const named = Object.entries(facts).filter(([, known]) => known);
    expect(named.map(([fact]) => fact).sort()).toStrictEqual([...needed].sort());
    const before = { ...facts };
    gatherFacts(light({ ...black, ...at }), facts);
    expect(facts).toStrictEqual({ ...before, point: true });
  });

  it.each(['ambient', 'diffuse', 'specular'] as const)(
    'of %s light need it, and stay when it goes',
    (term) => {
      const black = { ...at, ambient: [0, 0, 0], diffuse: [0, 0, 0], specular: [0, 0, 0] } as const;
      const facts = noFacts();
      gatherFacts(light(black), facts);
      expect(facts).toStrictEqual({ ...noFacts(), point: true });
      gatherFacts(light({ ...black, [term]: [0, 0, 1] }), facts);
      expect(facts).toStrictEqual({ ...noFacts(), point: true, [term]: true });
      gatherFacts(light(black), facts);
      expect(facts).toStrictEqual({ ...noFacts(), point: true, [term]: true });
    },
  );

  it('do not ask whether a light is switched on, so that switching it compiles nothing', () => {
    fc.assert(
      fc.property(anyLight, (values) => {
        const on = noFacts();
        const off = noFacts();
        gatherFacts({ ...values, active: true }, on);
        gatherFacts({ ...values, active: false }, off);
        expect(off).toStrictEqual(on);
      }),
    );
  });

  it('only ever grow', () => {
    fc.assert(
      fc.property(fc.array(anyLight, { maxLength: 6 }), anyLight, (before, next) => {
        const facts = noFacts();
        for (const values of before) gatherFacts(values, facts);
        const earlier = { ...facts };
        gatherFacts(next, facts);
        for (const [fact, known] of Object.entries(earlier)) {
          if (known) expect(facts[fact as keyof typeof facts]).toBe(true);
        }
        const again = { ...facts };
        gatherFacts(next, facts);
        expect(facts).toStrictEqual(again);
      }),
    );
  });
});
