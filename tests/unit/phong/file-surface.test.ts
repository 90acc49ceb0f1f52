// Does a file's roughness become a highlight without an edge? surfaces.spec.ts compares the
// shader's function with this one.
import { describe, expect, it } from 'vitest';
import { exponentOfRoughness } from '../../../src/phong/material/file-surface.js';

describe('the exponent for a roughness', () => {
  it('follows the published relation up to 0.75', () => {
    expect(exponentOfRoughness(0.5)).toBeCloseTo(7.5);
    expect(exponentOfRoughness(0.2)).toBeCloseTo(312);
    expect(exponentOfRoughness(0.75)).toBeCloseTo(1.08);
    expect(exponentOfRoughness(0)).toBeCloseTo(121_932, 0);
  });

  it('lets the highlight of rougher surfaces fade out: no flat patch, and no edge where R·V reaches 0', () => {
    for (const roughness of [0.77, 0.8, 0.9, 0.99, 1]) {
      const n = exponentOfRoughness(roughness);
      expect(0.5 ** n, `half way, at ${roughness}`).toBeLessThan(0.6);
      expect(0.01 ** n, `near the rim, at ${roughness}`).toBeLessThan(0.02);
    }
  });
});
