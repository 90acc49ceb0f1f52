// Lets chunks of the standalone file be fetched again after a failure. Browsers used to remember a
// failed import() by its address (https://github.com/whatwg/html/issues/6768; Chromium until 2026,
// Firefox 153 still does: https://bugzilla.mozilla.org/show_bug.cgi?id=2055211): another import()
// of it fails without a request. So later attempts use another address of the same file. Not for
// the ES modules: a user's bundler gives their chunks other names.

import type { Plugin } from 'vite';

/** A function of `lazyCode` in minified code that imports a chunk. */
const loader = /\(\)=>import\(`(\.\.?\/[^`$]+)`\)/g;

/**
 * The code with each such function taking the number of failures so far, as `lazyCode` calls it. The plain import
 * stays, because a bundler finds the chunk by it; the comments keep bundlers from resolving the other address. In
 * parentheses, because a call of `then` may follow.
 */
export function retried(code: string): string {
  const plain = 'import(`$1`)';
  const again = 'import(/*webpackIgnore:true*//*@vite-ignore*/`$1?`+n)';
  return code.replace(loader, `n=>(n?${again}.catch(()=>${plain}):${plain})`);
}

export function retriedImports(): Plugin {
  return {
    name: 'retried-imports',
    generateBundle(_options, bundle) {
      for (const file of Object.values(bundle)) {
        if (file.type === 'chunk') {
          file.code = retried(file.code);
        }
      }
    },
  };
}
