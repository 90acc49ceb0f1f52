// Are hostile and broken sources refused before anything is compiled, and all others let through?
import { describe, expect, it } from 'vitest';
import { checked } from '../../../src/extras/exercise/guard.js';
import { GIVEN_GLSL } from '../../../src/extras/exercise/solution.js';
import { LIGHT_FIELDS } from '../../../src/phong/light/light-state.js';
import { REFUSED_ONES, RIGHT, RIGHT_ONES, UNUSUAL_ONES, WRONG_ONES } from './functions.js';

const HEAD = 'vec3 shade(Light light, Material m, vec3 p, vec3 normal, vec3 eye) {';

describe('is refused with its reason:', () => {
  const own = Object.entries(REFUSED_ONES).filter(([, [, reason]]) => !reason.startsWith('Line'));
  it.each(own)('%s', (_, [source, reason]) => {
    const reading = checked(source);
    expect(
      'fault' in reading
        ? reading.fault.text.replace(/\{(\w+)\}/g, (_all, key) => String(reading.fault.values[key]))
        : '',
    ).toContain(reason);
  });
});

it('the function gets every value of a light that enters the equation', () => {
  const struct = /struct Light \{[^}]*/.exec(GIVEN_GLSL)?.[0] ?? '';
  const values = Object.entries(LIGHT_FIELDS).filter(
    ([, { shading }]) => typeof shading === 'object',
  );
  expect(values.map(([key]) => key).filter((key) => !struct.includes(key))).toEqual([]);
});

it('lets through what learners write, right or wrong', () => {
  const all = [RIGHT_ONES, UNUSUAL_ONES, ...Object.values(WRONG_ONES)].flatMap(Object.values);
  expect(all.length).toBeGreaterThan(70);
  for (const source of all) {
    expect(checked(source)).toHaveProperty('glsl');
  }
});

it.each([
  'for (int i = 0; i < 8; i++) { x += float(i); }',
  'for (int i = 8; i > 0; --i) x += 1.0;',
  'for (uint i = 0u; i <= 8u; i += 2u) x += 1.0;',
  'for (float t = 0.0; t < 1.0; t += 0.125) { x += t; }',
  'for (int i = 0; i < 100; i++) for (int k = 0; k < 100; k++) { x += 1.0; }',
  'for (int i = -4; i < 4; ++i) { if (i == 0) continue; x += pow(2.0, float(i)); }',
])('a loop whose bounds can be read is let through: %s', (loop) => {
  expect(checked(`${HEAD} float x = 0.0; ${loop} return vec3(x); }`)).toHaveProperty('glsl');
});

it.each([
  [
    'overloads in a chain',
    `float f(float x); float f(vec2 x); float f(vec3 x);
float f(vec3 x) { return f(x.xy) + x.z; }
float f(vec2 x) { return f(x.x) + x.y; }
float f(float x) { return max(x, 0.0); }
${HEAD} return vec3(f(p)); }`,
  ],
  [
    'a function between two overloads',
    `float g(float x); vec2 g(vec2 x); float f(float x) { return g(x); }
vec2 g(vec2 x) { return vec2(f(x.x), f(x.y)); }
float g(float x) { return max(x, 0.0); }
${HEAD} return g(p.xy).xyy; }`,
  ],
  [
    'a macro in what the same macro is given',
    `#define MOST(a, b) ((a) > (b) ? (a) : (b))\n${HEAD} return vec3(MOST(p.x, MOST(p.y, p.z))); }`,
  ],
])('lets through %s', (_, source) => {
  expect(checked(source)).toHaveProperty('glsl');
});

it('keeps each line in its place, with macros and constants put in', () => {
  const reading = checked(
    `// one\n/* two\nthree */ const int N = 3;\n#define TWICE(x) (2.0 * (x))\n${HEAD}\nfloat y = TWICE(\np.x);\nreturn vec3(y * float(N)); }`,
  );
  expect('glsl' in reading ? reading.glsl.split('\n').map((line) => line.trim()) : []).toEqual([
    '',
    '',
    'const int N = 3 ;',
    '',
    'vec3 shade ( Light light , Material m , vec3 p , vec3 normal , vec3 eye ) {',
    'float y = ( 2.0 * ( p . x ) )',
    ';',
    'return vec3 ( y * float ( 3 ) ) ; }',
  ]);
});

it('lets through a macro that is given to a macro', () => {
  const source = `#define D(x) ((x)+(x))\n#define C(f, x) f(f(f(x)))\n${HEAD} return C(D, p); }`;
  const reading = checked(source);
  expect('glsl' in reading && reading.glsl.match(/\bp\b/g)).toHaveLength(9);
});

it('names the line of a fault', () => {
  const at = (source: string) => {
    const reading = checked(source);
    return 'fault' in reading ? reading.fault.line : 'none';
  };
  expect(at(`${RIGHT}\n/* open`)).toBe(RIGHT.split('\n').length + 1);
  expect(at(`float a;\n#version 300 es`)).toBe(2);
  expect(at(`${HEAD}\n\nwhile (true) {}\nreturn p; }`)).toBe(3);
});
