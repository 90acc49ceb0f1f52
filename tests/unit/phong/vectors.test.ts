// Are the test vectors what the guide's own example computes?
import { readFileSync } from 'node:fs';
import { expect, it } from 'vitest';
import { vectors, type VectorRow } from '../../../.ci/vectors.js';
import { SCENE_NAMES } from '../../../src/phong/mistakes/sheet.js';

const rows = vectors();
const KEYS = ['ambient', 'diffuse', 'specular', 'specularBlinn'] as const;

const farthest = (of: (row: VectorRow) => Pick<VectorRow, (typeof KEYS)[number]>) =>
  Math.max(
    ...rows.flatMap((row) => {
      const found = of(row);
      return KEYS.flatMap((key) => row[key].map((x, k) => Math.abs(x - found[key][k]!)));
    }),
  );

it('the vectors have 30 points of each scene, with numbers only', () => {
  expect(rows.length).toBe(30 * SCENE_NAMES.length);
  const numbers = rows.flatMap((row) => KEYS.flatMap((key) => [...row[key]]));
  expect(numbers.every(Number.isFinite)).toBe(true);
  // Each term is seen.
  for (const key of KEYS) {
    expect(rows.filter((row) => Math.max(...row[key]) > 0.1).length).toBeGreaterThan(40);
  }
});

it("the guide's example in JavaScript gives every row to 1e-12", () => {
  const guide = readFileSync('demo/guide/vectors.md', 'utf8');
  const code = /```js\n(const dot[^]*?)```/.exec(guide)![1]!;
  const terms = new Function(`${code}; return terms;`)() as (row: VectorRow) => VectorRow;
  expect(farthest(terms)).toBeLessThan(1e-12);
});
