// Does the worst lawful driver replace what it should, and nothing else?
import { expect, it } from 'vitest';
import { LIGHT_LOOP_GLSL } from '../../src/phong/material/program/source.js';
import { divisionsAsCalls, onDriver } from '../glsl/worst-driver.js';

it.each([
  ['a / b', 'worst_divide(a, b)'],
  ['1.0 / max(x, 1.0)', 'worst_divide(1.0, max(x, 1.0))'],
  ['near / (2.0 - near)', 'worst_divide(near, (2.0 - near))'],
  ['floor(x * 255.0 + 0.5) / 255.0', 'worst_divide(floor(x * 255.0 + 0.5), 255.0)'],
  ['(a + b) / (c + d) / e', 'worst_divide(worst_divide((a + b), (c + d)), e)'],
  ['v.xyz / w[1]', 'worst_divide(v.xyz, w[1])'],
  ['f(a / b) * c', 'f(worst_divide(a, b)) * c'],
  ['#define X a/b', '#define X a/b'],
])('writes %s as %s', (from, to) => {
  expect(divisionsAsCalls(from)).toBe(to);
});

it('the shipped loop on the worst driver has no inaccurate built-in left, and is unchanged for the real one', () => {
  const worst = onDriver(LIGHT_LOOP_GLSL, 'up');
  const own = worst.slice(worst.indexOf('#define HEADER_COUNTS'));
  expect(own).toMatch(/worst_exp2\(.*/);
  expect(own).not.toMatch(/(?<!worst_)\b(exp2|log2|inversesqrt|sqrt|pow)\s*\(/);
  expect(own.replace(/^#.*$/gm, '')).not.toMatch(/\//);
  expect(onDriver(LIGHT_LOOP_GLSL, 'shipped')).toBe(LIGHT_LOOP_GLSL);
});

it('refuses built-ins with an unknown error allowance', () => {
  expect(() => onDriver('x = normalize(y);', 'up')).toThrow(/normalize/);
});
