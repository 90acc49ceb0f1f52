// Does the build's shader stripping keep the program the same?

import { expect, it } from 'vitest';
import { stripGlsl } from '../../.ci/strip-glsl.js';

it.each([
  [
    'no comments, blank lines or needless spaces',
    '/* a\n * b */\nfloat f( float x ) { // half\n\n  return 0.5 * x;\n}\n',
    'float f(float x){return 0.5*x;}\n',
  ],
  [
    'every directive on a line of its own',
    'int a;\n  #ifdef HAS_SPOT // why\nint b;\nint c;\n#endif\nint d;',
    'int a;\n#ifdef HAS_SPOT\nint b;int c;\n#endif\nint d;\n',
  ],
  [
    'a continued macro with its spaces: F(x) differs from F (x)',
    '#define F (x) \\\n   + 1',
    '#define F (x) + 1\n',
  ],
  ['no two operators joined into one', 'a = b - -c + +d;', 'a=b - -c + +d;\n'],
  ['separate words', 'const\nhighp  float x;', 'const highp float x;\n'],
])('a stripped shader has %s, and stays if stripped again', (_, text, stripped) => {
  expect(stripGlsl(text)).toBe(stripped);
  expect(stripGlsl(stripped)).toBe(stripped);
});
