// Is the equation in steps the reference's, and does each usual mistake show?
import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { LightState } from '../../../src/phong/light/light-state.js';
import { scale, type Vec3 } from '../../../src/phong/math/vector.js';
import { both, formsOf, MISTAKE_IDS, MISTAKES } from '../../../src/phong/mistakes/mistakes.js';
import { evaluate, type Given } from '../../../src/phong/mistakes/steps.js';
import { shade } from '../../../src/phong/reference/equation.js';
import { between, triple, worldLight } from '../arbitraries.js';

const TERMS = ['ambient', 'diffuse', 'specular'] as const;

const vector = (size: number) => triple(between(-size, size));
const color = triple(between(0, 1));

const given: fc.Arbitrary<Given> = fc.record({
  light: fc.tuple(worldLight, fc.boolean()).map(([one, isSpot]) => ({
    ...one,
    axis: isSpot ? one.axis : ([0, 0, 0] as const),
    ambient: unit(one.ambient),
    diffuse: unit(one.diffuse),
    specular: unit(one.specular),
    // The steps are written as people write them: behind a spot (c + 1) / 2 cancels digits, and an
    // exponent below 1 would bring the loss back.
    cutoff: Math.ceil(one.cutoff),
  })),
  material: fc.record({ ka: color, kd: color, ks: color, shininess: between(1, 256) }),
  p: vector(2),
  normal: vector(1),
  eye: vector(6),
  reflection: fc.constantFrom('phong', 'blinn-phong'),
  terms: fc.subarray([...TERMS]),
});

/** The reference takes colours as HTML writes them. */
const html = (color: Vec3) => scale(color, 255);
const unit = (color: Vec3) => scale(color, 1 / 255);

function byReference({ light, material, terms, reflection, ...fragment }: Given) {
  const { ambient, diffuse, specular } = light;
  const values = new LightState({
    ...light,
    ambient: html(ambient),
    diffuse: html(diffuse),
    specular: html(specular),
  }).values;
  const surface = {
    ka: html(material.ka),
    kd: html(material.kd),
    ks: html(material.ks),
    shininess: material.shininess,
  };
  return shade(fragment, surface, [values], { terms, reflection }).shares[0]!;
}

it('the equation in steps is the reference, term by term', () => {
  fc.assert(
    fc.property(given, (at) => {
      const found = evaluate(at);
      const expected = byReference(at);
      for (const term of TERMS) {
        for (const channel of [0, 1, 2] as const) {
          expect(Math.abs(found[term][channel] - expected[term][channel])).toBeLessThan(1e-10);
        }
      }
    }),
    { numRuns: 2000 },
  );
});

describe('each mistake', () => {
  it('has a sentence of its own', () => {
    const sentences = new Set(MISTAKE_IDS.map((id) => MISTAKES[id].sentence));
    expect(sentences.size).toBe(MISTAKE_IDS.length);
  });

  it('two of them are one function where they replace different steps', () => {
    const [clamp] = formsOf('no-clamp');
    const [ambient] = formsOf('no-ambient');
    const together = both(clamp!, ambient!)!;
    fc.assert(
      fc.property(given, (at) => {
        expect(evaluate(at, together)).toEqual({ ...evaluate(at, clamp), ambient: [0, 0, 0] });
      }),
    );
    expect(both(clamp!, formsOf('abs-for-max')[0]!)).toBeUndefined();
  });
});
