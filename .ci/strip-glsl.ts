// Removes comments and spaces from shaders in dist/: in a build, `*.glsl?raw` imports give the
// stripped text. The dev server and the tests use the files unchanged, so that the line numbers in
// a compiler's messages are right.

import { readFileSync } from 'node:fs';
import type { Plugin } from 'vite';

/**
 * The same program without comments, blank lines and needless spaces; each directive stays on a
 * line of its own.
 */
export function stripGlsl(source: string): string {
  const lines = source
    .replace(/\r\n?/g, '\n')
    .replace(/\\\n/g, ' ')
    .replace(/\/\*[^]*?\*\/|\/\/[^\n]*/g, ' ')
    .split('\n')
    .map((line) => line.replace(/\s+/g, ' ').trim())
    .filter((line) => line !== '');
  let out = '';
  let besideDirective = true;
  for (const line of lines) {
    const isDirective = line.startsWith('#');
    out += (isDirective || besideDirective ? '\n' : ' ') + line;
    besideDirective = isDirective;
  }
  return out.trim().replace(/^[^#].*$/gm, tighten) + '\n';
}

// Not + and -: `a - -b` must not become a decrement.
function tighten(line: string): string {
  return line.replace(/ ?([(){}[\],;=*/<>?:&|^!]) ?/g, '$1');
}

export function strippedGlsl(): Plugin {
  return {
    name: 'stripped-glsl',
    enforce: 'pre',
    apply: 'build',
    load(id) {
      const [path, query] = id.split('?');
      if (path === undefined || query !== 'raw' || !path.endsWith('.glsl')) return null;
      this.addWatchFile(path);
      return `export default ${JSON.stringify(stripGlsl(readFileSync(path, 'utf8')))};`;
    },
  };
}
