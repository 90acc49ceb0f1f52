// Are the test vectors what the guide's own example computes?
import { readFileSync } from 'node:fs';
import { expect, it } from 'vitest';
import { vectors, type VectorRow } from '../../../.ci/vectors.js';
import { TERMS } from '../../../src/phong/light/light-state.js';
import { exactAt, STEP, sumAt } from '../../../src/phong/mistakes/judge.js';
import { formsOf, MISTAKE_IDS } from '../../../src/phong/mistakes/mistakes.js';

const rows = vectors();

it('the vectors show each form of each usual mistake', () => {
  const cases = (['phong', 'blinn-phong'] as const).flatMap((reflection) =>
    rows.map((row) => [{ ...row, reflection, terms: TERMS }]),
  );
  for (const form of MISTAKE_IDS.flatMap(formsOf)) {
    const seen = cases.filter((at) =>
      sumAt(at, form).some((x, k) => !(Math.abs(x - exactAt(at)[k]!) < STEP)),
    );
    expect(seen.length).toBeGreaterThanOrEqual(4);
  }
});

it("the guide's example in JavaScript gives every row to 1e-12", () => {
  const guide = readFileSync('demo/guide/vectors.md', 'utf8');
  expect(guide).toContain(`has ${rows.length} points`);
  const code = /```js\n(const dot[^]*?)```/.exec(guide)![1]!;
  const terms = new Function(`${code}; return terms;`)() as (row: VectorRow) => VectorRow;
  const differences = rows.flatMap((row) => {
    const found = terms(row);
    return (['ambient', 'diffuse', 'specular', 'specularBlinn'] as const).flatMap((key) =>
      row[key].map((x, k) => Math.abs(x - found[key][k]!)),
    );
  });
  expect(Math.max(...differences)).toBeLessThan(1e-12);
});
