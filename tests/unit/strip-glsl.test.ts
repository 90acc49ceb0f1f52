// Does the build's shader stripping keep the program the same?

import { describe, expect, it } from 'vitest';
import { stripGlsl } from '../../.ci/strip-glsl.js';

describe('stripGlsl', () => {
  it('drops comments of both kinds, blank lines and needless spaces', () => {
    expect(stripGlsl('/* a\n * b */\nfloat f( float x ) { // half\n\n  return 0.5 * x;\n}\n')).toBe(
      'float f(float x){return 0.5*x;}\n',
    );
  });

  it('keeps every directive on a line of its own', () => {
    expect(stripGlsl('int a;\n  #ifdef HAS_SPOT // why\nint b;\nint c;\n#endif\nint d;')).toBe(
      'int a;\n#ifdef HAS_SPOT\nint b;int c;\n#endif\nint d;\n',
    );
  });

  it('joins a continued macro and keeps its spaces, because F(x) differs from F (x)', () => {
    expect(stripGlsl('#define F (x) \\\n   + 1')).toBe('#define F (x) + 1\n');
  });

  it('never joins two operators into one', () => {
    expect(stripGlsl('a = b - -c + +d;')).toBe('a=b - -c + +d;\n');
  });

  it('keeps words separate', () => {
    expect(stripGlsl('const\nhighp  float x;')).toBe('const highp float x;\n');
  });

  it('changes nothing that is stripped already', () => {
    const once = stripGlsl('#version 300 es\nvoid main()\n{\n  x = -1.0;\n}\n');
    expect(stripGlsl(once)).toBe(once);
  });
});
