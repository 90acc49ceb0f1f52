// @ts-check
// The lint rules of src/ that oxlint does not have: the layers (.ci/layers.mjs), #private instead
// of `private`, what `breaches` says more, and arithmetic that is the same in every engine in the
// files that stills import. Not a plugin of oxlint: with one it takes 4 GiB of address space for
// each core, and a small machine refuses that.

import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { posix } from 'node:path';
import { parseSync, Visitor } from 'vite';
import { entries } from './entries.mjs';
import { forbidden } from './layers.mjs';

/**
 * What is wrong in a file, with its line before each message.
 * @param {string} file path with forward slashes
 * @param {string} code
 * @returns {string[]}
 */
export function breaches(file, code) {
  /** @type {string[]} */
  const found = [];
  /** @param {{ start: number }} node @param {string | undefined} message */
  const report = ({ start }, message) => {
    if (message !== undefined) {
      found.push(`${code.slice(0, start).split('\n').length}: ${message}`);
    }
  };
  /** @param {any} source @param {boolean} isLazy */
  const visit = (source, isLazy) => {
    if (typeof source?.value === 'string') {
      report(source, forbidden(file, source.value, isLazy));
    }
  };
  /** @param {any} node */
  const plain = ({ source, importKind, exportKind }) => {
    visit(source, importKind === 'type' || exportKind === 'type');
  };
  /** @param {any} node */
  const lazy = ({ source }) => {
    visit(source, true);
  };
  /** @param {any} node */
  const member = (node) => {
    if (node.accessibility === 'private') {
      report(node, 'Private members are #private.');
    }
  };
  /** @param {any} node */
  const abort = (node) => {
    const { callee } = node;
    if (callee.property?.name === 'abort' && node.arguments.length === 0) {
      report(
        node,
        'abort() makes an error that keeps its callers alive: give a text as the reason.',
      );
    }
  };
  /** @param {any} node */
  const forIn = (node) => {
    report(node, 'for … in also visits what a page added to Object.prototype: use Object.keys.');
  };
  const { program, errors } = parseSync(file, code);
  // Of what does not parse there is no tree. Oxlint and tsc say more.
  for (const { message } of errors) {
    report({ start: 0 }, message);
  }
  new Visitor({
    ImportDeclaration: plain,
    ExportNamedDeclaration: plain,
    ExportAllDeclaration: plain,
    ImportExpression: lazy,
    TSImportType: lazy,
    PropertyDefinition: member,
    MethodDefinition: member,
    CallExpression: abort,
    ForInStatement: forIn,
  }).visit(program);
  return found;
}

/** What all engines compute alike, to the last bit, and constants. */
const EXACT = /^(abs|min|max|floor|ceil|round|trunc|sign|sqrt|imul|fround|PI|SQRT2|SQRT1_2)$/;

/**
 * Where engines may differ in the last bits, with its line before each message: other functions of
 * `Math`, and `**` but for two literals, of which the compiler makes a constant.
 * @param {string} file @param {string} code
 * @returns {string[]}
 */
export function inexact(file, code) {
  /** @type {string[]} */
  const found = [];
  /** @param {{ start: number }} node @param {string} what */
  const report = ({ start }, what) => {
    const line = code.slice(0, start).split('\n').length;
    found.push(`${line}: ${what} differs between engines: use src/phong/math/elementary.ts.`);
  };
  new Visitor({
    MemberExpression: (node) => {
      const { object, property, computed } = /** @type {any} */ (node);
      if (object.name !== 'Math') return;
      if (computed || !EXACT.test(property.name)) {
        report(node, `Math.${property.name}`);
      }
    },
    BinaryExpression: (node) => {
      const { operator, left, right } = /** @type {any} */ (node);
      const isConstant = [left, right.argument ?? right].every(({ type }) => type === 'Literal');
      if (operator === '**' && !isConstant) {
        report(node, 'x ** y');
      }
    },
  }).visit(parseSync(file, code).program);
  return found;
}

/** What extras import of the viewer: it only passes names on. */
const FACADE = 'src/viewer/extra.ts';

/**
 * The file that each name of {@link FACADE} comes from.
 * @returns {Map<string, string>}
 */
function facadeNames() {
  const { program } = parseSync(FACADE, readFileSync(FACADE, 'utf8'));
  /** @type {Map<string, string>} */
  const names = new Map();
  new Visitor({
    ExportNamedDeclaration: (node) => {
      const { source, specifiers } = /** @type {any} */ (node);
      for (const { exported } of specifiers) {
        names.set(exported.name, pathFrom(FACADE, source.value));
      }
    },
  }).visit(program);
  return names;
}

/** @param {string} file @param {string} specifier */
const pathFrom = (file, specifier) =>
  posix.join(posix.dirname(file), specifier.replace(/\.js$/, '.ts'));

/**
 * The files of src/ that run in a still: those that it imports, in turn, but for types and what the
 * build leaves out.
 * @returns {string[]}
 */
export function filesOfStills() {
  const stills = entries.filter(({ name }) => name === 'still' || name === 'still-worker');
  const found = new Set(stills.map(({ source }) => `src/${source}`));
  const facade = facadeNames();
  for (const file of found) {
    const { program } = parseSync(file, readFileSync(file, 'utf8'));
    /** @param {any} node */
    const visit = ({ source, importKind, exportKind, specifiers = [] }) => {
      if (importKind === 'type' || exportKind === 'type' || !source?.value?.startsWith('.')) return;
      const path = pathFrom(file, source.value);
      const paths =
        path === FACADE
          ? specifiers
              .filter((/** @type {any} */ one) => one.importKind !== 'type')
              .map((/** @type {any} */ one) => facade.get(one.imported.name) ?? FACADE)
          : [path];
      for (const each of paths) {
        if (each.endsWith('.ts') && existsSync(each) && !WITHOUT.test(each)) {
          found.add(each);
        }
      }
    };
    new Visitor({
      ImportDeclaration: visit,
      ExportNamedDeclaration: visit,
      ExportAllDeclaration: visit,
      ImportExpression: visit,
    }).visit(program);
  }
  return [...found];
}

/** Decoders that stills refuse, and what opens dropped pictures. */
const WITHOUT = /\/(decoders|ktx2)\/|\/(draco|meshopt|open-scene)/;

/** The same for all files of src/, with their paths. */
export function breachesInSrc() {
  const files = readdirSync('src', { recursive: true }).map((name) =>
    `src/${name}`.replaceAll('\\', '/'),
  );
  const ofStills = new Set(filesOfStills());
  return files
    .filter((file) => file.endsWith('.ts'))
    .flatMap((file) => {
      const code = readFileSync(file, 'utf8');
      const found = [...breaches(file, code), ...(ofStills.has(file) ? inexact(file, code) : [])];
      return found.map((one) => `${file}:${one}`);
    });
}
