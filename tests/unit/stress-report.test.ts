// Do the published tables match the results of every category and stack, and does the contract hold there?
import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { CATEGORIES } from '../stress/categories.js';
import { BRANCHES, CONE_EDGE, EXACT } from '../stress/contract.js';
import { readmeText, readStacks, readTessellation, reportText } from '../stress/report.mjs';
import { LOOP_MARK, markOf } from '../glsl/loop-mark.js';
import { WORST_DRIVERS } from '../glsl/worst-driver.js';

const text = (path: string): string => readFileSync(new URL(`../../${path}`, import.meta.url), 'utf8');
const stacks = readStacks();

describe('the published contract', () => {
  it('agrees with the results, in the report and in the README', () => {
    expect(text('tests/stress/REPORT.md')).toBe(reportText(stacks, readTessellation(), LOOP_MARK));
    expect(text('README.md')).toContain(readmeText(stacks));
  });

  it('marks the measured loop by its code, whatever its comments and line breaks', () => {
    expect(LOOP_MARK).toMatch(/^[0-9a-f]{8}$/);
    expect(markOf('a * b; // twice\n/* c */ d')).toBe(markOf('a * b;\n\n  d'));
    expect(markOf('a * b;')).not.toBe(markOf('a + b;'));
    const row = reportText([{ ...stacks[0]!, loop: LOOP_MARK }], readTessellation(), LOOP_MARK);
    expect(row).toContain('| as shipped |');
    expect(reportText([{ ...stacks[0]!, loop: '' }], readTessellation(), LOOP_MARK)).toContain(
      '| an earlier one |',
    );
  });

  it('was measured in software and on a GPU, on at least four stacks', () => {
    expect(stacks.length).toBeGreaterThanOrEqual(4);
    expect(stacks.map(({ renderer }) => renderer).join()).toMatch(/SwiftShader.*NVIDIA|NVIDIA.*SwiftShader/);
  });

  describe.each(stacks)('on $name', ({ contract, drivers }) => {
    it('was measured with today’s categories, bounds and exclusions', () => {
      const { checked: _checked, ...shipped } = drivers['shipped']!;
      const measured = shipped.measured.map(({ id, bound }) => ({ id, bound }));
      expect(measured).toEqual(CATEGORIES.map(({ id, bound }) => ({ id, bound })));
      expect({ edge: contract.edge, exact: contract.exact }).toEqual({ edge: CONE_EDGE, exact: EXACT });
      // What left out less, and held, holds.
      for (const key of Object.keys(BRANCHES) as (keyof typeof BRANCHES)[]) {
        expect(contract.branches[key], key).toBeLessThanOrEqual(BRANCHES[key]);
      }
    });

    it('holds, on its own driver and on the worst lawful ones', () => {
      expect(Object.keys(drivers).sort()).toEqual(['shipped', ...WORST_DRIVERS].sort());
      for (const { broken } of Object.values(drivers)) expect(broken).toEqual([]);
    });
  });
});
