// How does the standalone file fetch its chunks? Again after a failure, and models without waiting
// for what their chunks import, nor for each function to be compiled. Not for the ES modules: a
// user's bundler gives their chunks other names, requests what these import itself, and drops
// comments.
//
// Browsers used to remember a failed import() by its address
// (https://github.com/whatwg/html/issues/6768; Chromium until 2026, Firefox 153 still does:
// https://bugzilla.mozilla.org/show_bug.cgi?id=2055211): another import() of it fails without a
// request. So later attempts use another address of the same file.

import type { Plugin, Rolldown } from 'vite';

/** A function of `lazyCode` in minified code that imports a chunk. */
const loader = /\(\)=>import\(`(\.\.?\/[^`$]+)`\)/g;

/**
 * The code with each such function taking the number of failures so far, as `lazyCode` calls it. The plain import
 * stays, because a bundler finds the chunk by it; the comments keep bundlers from resolving the other address. In
 * parentheses, because a call of `then` may follow.
 * @param beside the files that are requested with the first attempt, by a name from the import.
 */
export function retried(code: string, beside: (path: string) => readonly string[]): string {
  return code.replace(loader, (_, path: string) => {
    const plain = `import(\`${path}\`)`;
    const again = `import(/*webpackIgnore:true*//*@vite-ignore*/\`${path}?\`+n)`;
    const first = beside(path).map((file) => `$ahead(\`${file}\`)`);
    return `n=>(n?${again}.catch(()=>${plain}):${first.length === 0 ? plain : `(${[...first, plain].join()})`})`;
  });
}

/**
 * Requests a file once that chunks are going to import. Not by `import()`, nor as `modulepreload`: what
 * they fail to fetch is remembered.
 */
const ahead =
  'function $ahead(f){if($ahead[f])return;$ahead[f]=1;let l=document.createElement(`link`);l.rel=`preload`;l.as=`script`;l.crossOrigin=``;l.href=new URL(f,import.meta.url).href;l.onload=l.onerror=()=>l.remove();document.head?.append(l)}';

/** Each of these is one request of a first picture. The first is requested with each of the others. */
const MODELS = /\/model-content\./;
const READERS = /\/read-\w+\./;

/**
 * The code of a chunk that the browser compiles as a whole while it fetches it, beside the page's
 * thread (https://v8.dev/blog/explicit-compile-hints). Otherwise V8 compiles each function with its
 * first call, and reading one model calls hundreds. The line goes behind the licences.
 */
const compiledAhead = (code: string): string =>
  code.replace(/^(\/\*![^]*?\*\/\n)?/, '$&//# allFunctionsCalledOnLoad\n');

export function retriedImports(): Plugin {
  return {
    name: 'retried-imports',
    generateBundle(_options, bundle) {
      const chunks = Object.values(bundle).filter((file) => file.type === 'chunk');
      const readers = chunks.filter(
        ({ fileName: name }) => MODELS.test(name) || READERS.test(name),
      );
      const compiled = new Set(readers.flatMap(({ fileName, imports }) => [fileName, ...imports]));
      for (const file of chunks) {
        const beside = (path: string): readonly string[] => {
          if (!file.isEntry || !(MODELS.test(path) || READERS.test(path))) return [];
          const models = chunks.find(({ fileName }) => MODELS.test(fileName));
          const known = READERS.test(path) ? (models?.imports ?? []) : [];
          return importsOf(path, chunks).filter((name) => !known.includes(name.slice(2)));
        };
        file.code = retried(file.code, beside);
        if (!file.isEntry && compiled.has(file.fileName)) {
          file.code = compiledAhead(file.code);
        }
        if (file.code.includes('$ahead(')) {
          file.code += ahead;
        }
      }
    },
  };
}

/** What the chunk at this address imports beside the entry, in the form of that address. */
function importsOf(path: string, chunks: readonly Rolldown.OutputChunk[]): readonly string[] {
  const entries = new Set(chunks.filter(({ isEntry }) => isEntry).map(({ fileName }) => fileName));
  const found = chunks.find(({ fileName }) => `./${fileName}` === path);
  return (found?.imports ?? []).filter((name) => !entries.has(name)).map((name) => `./${name}`);
}
