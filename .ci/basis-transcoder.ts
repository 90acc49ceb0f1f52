// How do three's copy of the Basis Universal transcoder and its WebAssembly become parts of the package? The script becomes a module that
// needs no eval: its compiler's output makes functions from text in two places, which a strict Content-Security-Policy refuses. In dist/
// the WebAssembly is a file beside the code, at an address that users' bundlers know.

import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import type { Plugin } from 'vite';
import { scriptAsModule } from './script-as-module.js';

const SCRIPT = '/libs/basis/basis_transcoder.js';
const FILE = 'basis_transcoder.wasm';

/**
 * From the first text to the second, and what stands there instead. The variables are those of Emscripten's own functions: values go to
 * the form that the compiled code takes, and back.
 */
const REPLACED: readonly (readonly [from: string, to: string, instead: string])[] = [
  [
    'var closureArgs=[humanName,',
    'newFunc(Function,args)(...closureArgs);',
    `var invokerFn = function (...given) {
      if (given.length !== argCount - 2)
        throwBindingError('function ' + humanName + ' called with ' + given.length + ' arguments, expected ' + (argCount - 2));
      var destructors = needsDestructorStack ? [] : null;
      var types = argTypes.slice(2);
      var wired = given.map((value, i) => types[i].toWireType(destructors, value));
      if (isClassMethodFunc) {
        types.unshift(argTypes[1]);
        wired.unshift(argTypes[1].toWireType(destructors, this));
      }
      var value = cppInvokerFunc(cppTargetFunc, ...wired);
      if (needsDestructorStack) runDestructors(destructors);
      else types.forEach(({ destructorFunction }, i) => destructorFunction?.(wired[i]));
      return returns ? argTypes[0].fromWireType(value) : undefined;
    };`,
  ],
  [
    'var functionBody=`return function (obj,',
    'newFunc(Function,params)(...args);',
    `var invokerFunction = function (object, func, destructorsRef, pointer) {
      var values = types.map((type) => {
        var value = type.readValueFromPointer(pointer);
        pointer += type.argPackAdvance;
        return value;
      });
      var value = kind === 1 ? new func(...values) : func.call(object, ...values);
      return retType.isVoid ? undefined : emval_returnValue(retType, destructorsRef, value);
    };`,
  ],
];

function withoutEval(code: string): string {
  return REPLACED.reduce((text, [from, to, instead]) => {
    const start = text.indexOf(from);
    const end = text.indexOf(to, start);
    if (start < 0 || end < 0) throw new Error(`This three.js release has no ${from} in ${SCRIPT}.`);
    return text.slice(0, start) + instead + text.slice(end + to.length);
  }, code);
}

/** The transcoder as a module, in the dev server, in Node tests, in workers and in dist/. */
export function basisTranscoder(): Plugin {
  return {
    name: 'basis-transcoder-as-module',
    enforce: 'pre',
    config: () => ({ optimizeDeps: { exclude: ['three/examples/jsm/libs/basis/basis_transcoder.js'] } }),
    transform(code, id) {
      if (!id.endsWith(SCRIPT)) return null;
      return scriptAsModule(withoutEval(code));
    },
  };
}

/**
 * `import address from '….wasm?url'` as Vite's own servers understand it, in a library: Vite would put the bytes into the script.
 * @param file false: there is no file, and the address is empty. For scripts that are no modules.
 */
export function basisFile({ file = true } = {}): Plugin {
  const wanted = `/libs/basis/${FILE}?url`;
  const placeholder = 'basis-file:address';
  return {
    name: 'basis-file',
    enforce: 'pre',
    resolveId: (specifier) => (specifier.endsWith(wanted) ? `\0${specifier}` : null),
    load(id) {
      if (!id.endsWith(wanted)) return null;
      // The sum hides it from Vite, and is one text after minification.
      return `export default ${file ? `new URL('' + '${placeholder}', import.meta.url).href` : "''"};`;
    },
    generateBundle(_options, bundle) {
      for (const chunk of Object.values(bundle)) {
        if (chunk.type !== 'chunk' || !chunk.code.includes(placeholder)) continue;
        chunk.code = chunk.code.replace(placeholder, `./${FILE}`);
        const folder = chunk.fileName.slice(0, chunk.fileName.lastIndexOf('/') + 1);
        const path = fileURLToPath(import.meta.resolve(`three/examples/jsm/libs/basis/${FILE}`));
        this.emitFile({ type: 'asset', fileName: folder + FILE, source: readFileSync(path) });
      }
    },
  };
}
