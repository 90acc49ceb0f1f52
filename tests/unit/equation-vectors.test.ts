// Does the reference agree with the same equation in 50 digits? The vectors come from vectors/make_vectors.py, which
// knows only the written equation.

import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import type { LightValues } from '../../src/light/light-state.js';
import type { Vec3 } from '../../src/math/vector.js';
import { type Fragment, type ReferenceOptions, shade, type Surface } from '../../src/reference/equation.js';
import { light } from './arbitraries.js';

interface Vector {
  readonly name: string;
  readonly fragment: Fragment;
  readonly surface: Surface;
  readonly lights: readonly Partial<LightValues>[];
  readonly options: ReferenceOptions;
  readonly want: {
    readonly sum: Vec3;
    readonly shares: readonly (
      | (Readonly<Record<'c' | 'att' | 'decay' | 'NoL' | 'RoV', number>> & {
          readonly inside: boolean;
        })
      | null
    )[];
    /** Sum over the lights of the brightest channels of Ia, Id and Is. */
    readonly intensity: number;
  };
}

const file = new URL('vectors/equation.jsonl', import.meta.url);
const vectors = readFileSync(file, 'utf8')
  .trimEnd()
  .split('\n')
  .map((line) => JSON.parse(line) as Vector);
const names = [...new Set(vectors.map(({ name }) => name))];

const run = ({ fragment, surface, lights, options }: Vector): ReturnType<typeof shade> =>
  shade(fragment, surface, lights.map(light), options);

it('the reference is checked at hundreds of fragments', () => {
  expect(vectors.length).toBeGreaterThanOrEqual(300);
});

describe('the reference agrees with 50 digits', () => {
  it.each(names)('%s', (name) => {
    for (const vector of vectors.filter((one) => one.name === name)) {
      const got = run(vector);
      const { sum, shares, intensity } = vector.want;
      const bound = 1e-12 * Math.max(1, intensity);
      sum.forEach((x, i) => {
        expect(Math.abs(got.sum[i]! - x), `${JSON.stringify(vector)} gave ${got.sum.join(' ')}`).toBeLessThan(
          bound,
        );
        expect(got.color[i]).toBe(Math.min(Math.max(got.sum[i]!, 0), 1));
      });
      shares.forEach((want, i) => {
        const share = got.shares[i]!;
        if (want === null) {
          expect(share).toBeNull();
          return;
        }
        expect(share.insideCone).toBe(want.inside);
        for (const fact of ['c', 'att', 'decay', 'NoL', 'RoV'] as const) {
          expect(Math.abs(share[fact] - want[fact]), `${fact} of ${JSON.stringify(vector)}`).toBeLessThan(
            1e-12,
          );
        }
      });
    }
  });
});
