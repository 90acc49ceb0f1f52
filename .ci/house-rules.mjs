// @ts-check
// The lint rules of src/ that oxlint does not have: the layers (.ci/layers.mjs), #private instead of
// `private`, and what `breaches` says more. Not a plugin of oxlint: with one it takes 4 GiB of
// address space for each core, and a small machine refuses that.

import { readdirSync, readFileSync } from 'node:fs';
import { parseSync, Visitor } from 'vite';
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
  }).visit(program);
  return found;
}

/** The same for all files of src/, with their paths. */
export function breachesInSrc() {
  const files = readdirSync('src', { recursive: true }).map((name) =>
    `src/${name}`.replaceAll('\\', '/'),
  );
  return files
    .filter((file) => file.endsWith('.ts'))
    .flatMap((file) =>
      breaches(file, readFileSync(file, 'utf8')).map((found) => `${file}:${found}`),
    );
}
