// Does the GLSL mutator change code alone, one place at a time, and never the head of a loop?

import { describe, expect, it } from 'vitest';
import { glslMutants } from '../mutation/glsl-mutants.mjs';
import { drawn } from '../mutation/sample.mjs';

const inFunction = (statements: string) => `void f() {\n  ${statements}\n}\n`;
const changes = (text: string) =>
  glslMutants(text).map(({ what, before, after }) => `${what}: ${before} -> ${after}`);

describe('mutants of GLSL', () => {
  it.each([
    ['float y = a + b;', ['swap + and -: + -> -']],
    ['float y = -a * b;', ['drop a sign: - -> ']],
    [
      'float y = min(a, 0.5);',
      ['swap min and max: min -> max', 'change a constant: 0.5 -> 1.0e+0'],
    ],
    ['float y = 1e-20;', ['change a constant: 1e-20 -> 2.0e-20']],
    ['int k = a & 3;', ['change a constant: 3 -> 4']],
    ['a += b;', ['drop a statement: a += b; -> ;', 'swap + and -: += -> -=']],
    ['bool y = a <= b;', ['flip a comparison: <= -> >']],
    ['if (a) b = c;', ['never take a branch: a -> false']],
    ['float y; // a + b', []],
    ['for (int i = 0; i < n; i++) g();', ['drop a statement: g(); -> ;']],
  ])('of %j are %j', (statement, expected) => {
    expect(changes(inFunction(statement))).toEqual(expected);
  });

  it('leave directives and comments as they are', () => {
    expect(glslMutants('#define N (1 + 2)\n#if N > 2\n#endif\n/* a = b + 1; */\n')).toEqual([]);
  });

  it('differ from the text in one place, which they name', () => {
    const text = inFunction('float y = a + 2.0; // + 2.0\n  y *= max(y, 1.0);');
    const mutants = glslMutants(text);
    expect(mutants.length).toBeGreaterThan(4);
    expect(new Set(mutants.map((mutant) => mutant.text)).size).toBe(mutants.length);
    for (const mutant of mutants) {
      let at = 0;
      while (text[at] === mutant.text[at]) {
        at += 1;
      }
      expect(text.slice(0, at).split('\n').length).toBe(mutant.line);
      expect(mutant.text.length - text.length).toBe(mutant.after.length - mutant.before.length);
    }
  });
});

it('a sample draws the same for the same seed, evenly, and others for another', () => {
  const names = Array.from({ length: 4000 }, (_, i) => `src/a.ts ${i} x`);
  const sample = (seed: number) => names.filter((name) => drawn(name, seed) < 0.25);
  expect(sample(1)).toEqual(sample(1));
  expect(sample(1)).not.toEqual(sample(2));
  expect(Math.abs(sample(1).length - 1000)).toBeLessThan(150);
});
