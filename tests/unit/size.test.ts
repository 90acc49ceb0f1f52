// How large may the project be? Counts tokens: comments, blank lines, imports and re-exports are
// free, so that nothing is gained by packing lines. A budget rises only with the reason in the
// commit's body.

import { readdirSync, readFileSync } from 'node:fs';
import ts from 'typescript';
import { expect, it } from 'vitest';
import { EXTRAS } from '../../.ci/layers.mjs';
import { repository } from '../support/repository.mjs';

/** Tokens of a file, as TypeScript's parser splits it. */
function tokensOf(path: string): number {
  const file = ts.createSourceFile(path, readFileSync(path, 'utf8'), ts.ScriptTarget.Latest, true);
  const count = (node: ts.Node): number => {
    if (ts.isImportDeclaration(node)) return 0;
    if (ts.isExportDeclaration(node) && node.moduleSpecifier !== undefined) return 0;
    if (node.kind >= ts.SyntaxKind.FirstJSDocNode && node.kind <= ts.SyntaxKind.LastJSDocNode) {
      return 0;
    }
    const children = node.getChildren(file);
    if (children.length === 0) return node.kind === ts.SyntaxKind.EndOfFileToken ? 0 : 1;
    return children.reduce((sum, child) => sum + count(child), 0);
  };
  return count(file);
}

/** Tokens of all scripts below a folder. */
const tokensBelow = (folder: string) =>
  readdirSync(repository + folder, { recursive: true, withFileTypes: true })
    .filter(({ name, parentPath }) => {
      const isScript = /\.(ts|mjs|js)$/.test(name) && !name.endsWith('.d.ts');
      return isScript && !/node_modules|fixtures/.test(parentPath);
    })
    .reduce((sum, { parentPath, name }) => sum + tokensOf(`${parentPath}/${name}`), 0);

const BUDGETS = {
  'src/phong': 69_695,
  'src/viewer': 59_689,
  'src/extras/models': 65_766,
  'src/extras/overlay': 30_148,
  'src/extras/probe': 11_830,
  'src/extras/panel': 19_359,
  'src/extras/still': 22_210,
  'src/extras/png': 1_940,
  'src/extras/lazy': 830,
  'src/extras/explain': 8_930,
  'src/extras/samples': 4_970,
  'src/extras/compare': 4_580,
  'src/extras/playwright': 4_090,
  'src/extras/frameworks': 1_070,
  'src/extras/exercise': 10_000,
  'src/extras/diagnosis': 2_279,
  tests: 493_973,
};

it.each(Object.entries(BUDGETS))('%s has no more tokens than its budget', (folder, most) => {
  const tokens = tokensBelow(folder);
  expect(tokens).toBeLessThanOrEqual(most);
  // Far above the size, the number would let it grow unseen.
  expect(tokens).toBeGreaterThan(0.97 * most);
});

it('each extra has a budget of its own, and src no folder beside phong, viewer and extras', () => {
  const folders = readdirSync(`${repository}src`).filter((name) => !name.includes('.'));
  expect(folders.sort()).toEqual(['decisions', 'extras', 'phong', 'viewer']);
  const extras = EXTRAS.map((name) => `src/extras/${name}`);
  expect(Object.keys(BUDGETS)).toEqual(expect.arrayContaining(extras));
});
