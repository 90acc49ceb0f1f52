// Does the reference agree with the same equation in 50 digits? The vectors come from vectors/make_vectors.py, which
// knows only the written equation.

/// <reference types="vite/client" />
import { expect, it } from 'vitest';
import type { LightValues } from '../../src/light/light-state.js';
import type { Vec3 } from '../../src/math/vector.js';
import { type Fragment, type ReferenceOptions, shade, type Surface } from '../../src/reference/equation.js';
import { light } from './arbitraries.js';
import text from './vectors/equation.jsonl?raw';

const FACTS = ['c', 'att', 'decay', 'NoL', 'RoV'] as const;

interface Vector {
  readonly name: string;
  readonly fragment: Fragment;
  readonly surface: Surface;
  readonly lights: readonly Partial<LightValues>[];
  readonly options: ReferenceOptions;
  readonly want: {
    readonly sum: Vec3;
    readonly shares: readonly (
      (Readonly<Record<(typeof FACTS)[number], number>> & { readonly inside: boolean }) | null
    )[];
    /** Sum over the lights of the brightest channels of Ia, Id and Is. */
    readonly intensity: number;
  };
}

const vectors = text
  .trimEnd()
  .split('\n')
  .map((line) => JSON.parse(line) as Vector);
const names = [...new Set(vectors.map(({ name }) => name))];

it.each(names)('the reference agrees with 50 digits: %s', (name) => {
  for (const vector of vectors.filter((one) => one.name === name)) {
    const { fragment, surface, lights, options, want } = vector;
    const got = shade(fragment, surface, lights.map(light), options);
    const bound = 1e-12 * Math.max(1, want.intensity);
    want.sum.forEach((x, i) => {
      const message = `${JSON.stringify(vector)} gave ${got.sum.join(' ')}`;
      expect(Math.abs(got.sum[i]! - x), message).toBeLessThan(bound);
      expect(got.color[i]).toBe(Math.min(Math.max(got.sum[i]!, 0), 1));
    });
    want.shares.forEach((facts, i) => {
      const share = got.shares[i]!;
      if (facts === null) {
        expect(share).toBeNull();
        return;
      }
      expect(share.insideCone).toBe(facts.inside);
      for (const fact of FACTS)
        expect(Math.abs(share[fact] - facts[fact]), `${fact} of ${JSON.stringify(vector)}`).toBeLessThan(1e-12);
    });
  }
});
