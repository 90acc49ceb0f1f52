// Makes a module of three's copy of the Basis Universal transcoder, one that needs no eval: its
// compiler's output makes functions from text in two places, which a strict Content-Security-Policy
// refuses.

import type { Plugin } from 'vite';
import { scriptAsModule } from './script-as-module.js';

const SCRIPT = '/libs/basis/basis_transcoder.js';

/**
 * From the first text to the second, and what stands there instead. The variables are those of
 * Emscripten's own functions: values go to the form that the compiled code takes, and back.
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
    config: () => ({
      optimizeDeps: { exclude: ['three/examples/jsm/libs/basis/basis_transcoder.js'] },
    }),
    transform(code, id) {
      if (!id.endsWith(SCRIPT)) return null;
      return scriptAsModule(withoutEval(code));
    },
  };
}
