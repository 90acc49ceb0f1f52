// Are hostile and broken sources refused before anything is compiled, and all others let through?
import { expect, it } from 'vitest';
import { guarded, Refused } from '../../../src/extras/exercise/guard.js';
import { LAMP } from '../../../src/extras/exercise/program.js';
import { GIVEN_GLSL, solutionFor } from '../../../src/extras/exercise/solution.js';
import { KINDS, LIGHT_FIELDS, TERMS } from '../../../src/phong/light/light-state.js';
import {
  REFUSED_ONES,
  RIGHT,
  RIGHT_ONES,
  STOPPED_ONES,
  UNUSUAL_ONES,
  WRONG_ONES,
} from './functions.js';

/** The fault, or null for a text that is let through. */
function faultIn(source: string) {
  try {
    guarded(source);
    return null;
  } catch (error) {
    return error instanceof Refused ? error.faults[0]! : null;
  }
}

const HEAD = 'vec3 shade(Light light, Material m, vec3 p, vec3 normal, vec3 eye) {';

it.each(Object.entries(REFUSED_ONES))('is refused with its reason: %s', (_, [source, reason]) => {
  const { text = '', values = {} } = faultIn(source) ?? {};
  expect(text.replace(/\{(\w+)\}/g, (_all, key) => String(values[key]))).toContain(reason);
});

it('the function gets every value of a light that enters the equation, and the exact one reads it', () => {
  const struct = /struct Light \{[^}]*/.exec(GIVEN_GLSL)?.[0] ?? '';
  expect(Array.from(struct.matchAll(/\w+(?=[,;])/g), String)).toEqual([...LAMP]);
  const exact = solutionFor({ terms: TERMS, kinds: KINDS, reflection: 'phong' });
  const missing = Object.entries(LIGHT_FIELDS).filter(
    ([key, { shading }]) =>
      typeof shading === 'object' && !(struct.includes(key) && exact.includes(`light.${key}`)),
  );
  expect(missing).toEqual([]);
});

/** With what the compiler knows, and the guard does not. */
const LET_THROUGH = {
  'overloads in a chain': `float f(float x); float f(vec2 x); float f(vec3 x);
float f(vec3 x) { return f(x.xy) + x.z; }
float f(vec2 x) { return f(x.x) + x.y; }
float f(float x) { return max(x, 0.0); }
${HEAD} return vec3(f(p)); }`,
  'a function between two overloads': `float g(float x); vec2 g(vec2 x); float f(float x) { return g(x); }
vec2 g(vec2 x) { return vec2(f(x.x), f(x.y)); }
float g(float x) { return max(x, 0.0); }
${HEAD} return g(p.xy).xyy; }`,
  'a macro in what the same macro is given': `#define MOST(a, b) ((a) > (b) ? (a) : (b))
${HEAD} return vec3(MOST(p.x, MOST(p.y, p.z))); }`,
};

it('lets through what learners write, right or wrong', () => {
  const all = [RIGHT_ONES, UNUSUAL_ONES, LET_THROUGH, ...Object.values(WRONG_ONES)].flatMap(
    Object.values,
  );
  all.push(...Object.values(STOPPED_ONES).map(([source]) => source));
  expect(all.length).toBeGreaterThan(90);
  for (const source of all) {
    expect(faultIn(source), source).toBeNull();
  }
});

it('keeps each line in its place', () => {
  const source = `// one\n/* two\nthree */ const float N = 3.0;\n#define TWICE(x) (2.0 * (x))\n${RIGHT}`;
  const bare = source.replace(/\/\/.*|\/\*[^]*\*\//g, (comment) => comment.replace(/./g, ''));
  const wordsOf = (text: string) => text.split('\n').map((line) => line.replace(/\s/g, ''));
  expect(wordsOf(guarded(source))).toEqual(wordsOf(bare));
});

it('names the line of a fault', () => {
  const at = (source: string) => faultIn(source)?.line;
  expect(at(`#define ONE 1.0 + \\\n  0.0\n#version 300 es`)).toBe(3);
  expect(at(RIGHT.replace('(toLight);', '(toLight;'))).toBe(5);
  expect(at(`${HEAD}\n\nwhile (true) {}\nreturn p; }`)).toBe(3);
});
