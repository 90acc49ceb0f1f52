// Do the published tables match the results of every category and stack, and does the contract hold there?
import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { CATEGORIES } from '../stress/categories.js';
import { BRANCHES, CONE_EDGE, EXACT } from '../stress/contract.js';
import { formNames, readmeText, readStacks, reportText } from '../stress/report.mjs';
import { formsOfAll } from '../glsl/loop-coverage.js';
import { LOOP_MARK, markOf } from '../glsl/loop-mark.js';
import { WORST_DRIVERS } from '../glsl/worst-driver.js';

const text = (path: string): string => readFileSync(new URL(`../../${path}`, import.meta.url), 'utf8');
const stacks = readStacks();

describe('the published contract', () => {
  it('agrees with the results, in the report and in the README', () => {
    expect(text('tests/stress/REPORT.md')).toBe(reportText(stacks, LOOP_MARK));
    expect(text('README.md')).toContain(readmeText(stacks));
  });

  it('marks the measured loop by its code, whatever its comments and line breaks', () => {
    expect(markOf('a * b; // twice\n/* c */ d')).toBe(markOf('a * b;\n\n  d'));
    expect(markOf('a * b;')).not.toBe(markOf('a + b;'));
  });

  it('says where an earlier loop was measured, and where a category was not', () => {
    const first = stacks[0]!;
    const { title, bound } = CATEGORIES[0]!;
    const { shipped, ...worst } = first.drivers;
    const drivers = { ...worst, shipped: { ...shipped!, measured: shipped!.measured.slice(1) } };
    const both = [
      { ...first, loop: '', drivers },
      { ...first, loop: LOOP_MARK },
    ];
    const report = reportText(both, LOOP_MARK);
    for (const part of ['| as shipped |', '| an earlier one |', `| ${title} | ${String(bound)} | not measured here |`])
      expect(report).toContain(part);
  });

  it('was measured in software and on a GPU, on at least four stacks', () => {
    expect(stacks.length).toBeGreaterThanOrEqual(4);
    expect(stacks.map(({ renderer }) => renderer).join()).toMatch(/SwiftShader.*NVIDIA|NVIDIA.*SwiftShader/);
  });

  it('was measured in every category and every form of program on one stack at least', () => {
    const forms = formsOfAll();
    const whole = stacks.filter(
      (stack) =>
        Object.values(stack.drivers).every(({ measured }) => measured.length === CATEGORIES.length) &&
        [...forms].every((form) => formNames([stack]).includes(form)),
    );
    expect(whole.map(({ name }) => name)).not.toEqual([]);
  });

  describe.each(stacks)('on $name', ({ contract, drivers }) => {
    it('was measured with today’s bounds and exclusions or tighter ones, in categories that are still there', () => {
      const measured = drivers['shipped']!.measured.map(({ id, bound }) => ({ id, bound }));
      const ids = measured.map(({ id }) => id);
      const today = CATEGORIES.filter(({ id }) => ids.includes(id));
      expect(ids).toEqual(today.map(({ id }) => id));
      measured.forEach(({ id, bound }, i) => expect(bound, id).toBeLessThanOrEqual(today[i]!.bound));
      expect([contract.edge, contract.exact.share]).toEqual([CONE_EDGE, EXACT.share]);
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
