// Without each extra, in a copy: does what is left compile, build, and pass its tests? A copy has no
// folder, no row and no entry of the extra, nor those that depend on it.

import { spawnSync } from 'node:child_process';
import {
  cpSync,
  existsSync,
  mkdtempSync,
  readdirSync,
  readFileSync,
  rmSync,
  symlinkSync,
  writeFileSync,
} from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join, resolve } from 'node:path';
import { afterAll, describe, expect, it } from 'vitest';
import { TABLE, tableWithout, typeErrors, withDependents } from '../support/without-extra.js';
import { EXTRAS } from '../../.ci/layers.mjs';
import { repository } from '../support/repository.mjs';

/** What the build and the tests read. */
const COPIED = [
  '.ci',
  'src',
  'shaders',
  'tests',
  'demo/assets/models',
  'demo/guide',
  'package.json',
  'tsconfig.json',
  'vitest.config.ts',
];

function copyWithout(gone: ReadonlySet<string>) {
  const copy = mkdtempSync(join(tmpdir(), 'without-'));
  for (const name of COPIED) {
    cpSync(join(repository, name), join(copy, name), { recursive: true });
  }
  symlinkSync(join(repository, 'node_modules'), join(copy, 'node_modules'));
  for (const name of gone) {
    rmSync(join(copy, 'src/extras', name), { recursive: true });
    rmSync(join(copy, 'tests/extras', name), { recursive: true, force: true });
  }
  writeFileSync(join(copy, TABLE), tableWithout(gone));
  return copy;
}

/** Whether all that a file of the copy imports is there, in turn, by the package's name too. */
function isWhole(copy: string, file: string, seen = new Set<string>()): boolean {
  if (seen.has(file)) return true;
  seen.add(file);
  if (!file.endsWith('.ts')) return true;
  const code = readFileSync(file, 'utf8');
  const specifiers = [...code.matchAll(/(?:from|import\() ?'((?:\.|phong-viewer\/)[^'?]*)/g)];
  return specifiers.every(([, specifier = '']) => {
    if (!specifier.startsWith('.')) {
      return Object.hasOwn(exportsOf(copy), specifier.replace('phong-viewer', '.'));
    }
    const path = resolve(dirname(file), specifier);
    const found = [path.replace(/\.js$/, '.ts'), path].find((one) => existsSync(one));
    return found !== undefined && isWhole(copy, found, seen);
  });
}

const exportsOf = (copy: string) =>
  (JSON.parse(readFileSync(join(copy, 'package.json'), 'utf8')) as { readonly exports: object })
    .exports;

/**
 * Tests of the viewer and of the extras that are left. What lies below cannot differ, and others are
 * of the project as a whole, such as its documents.
 */
function testsIn(copy: string): readonly string[] {
  const folders = ['tests/unit/viewer', 'tests/extras'];
  return folders.flatMap((folder) =>
    (readdirSync(join(copy, folder), { recursive: true }) as string[])
      .map((name) => join(folder, name))
      .filter((name) => name.endsWith('.test.ts') && isWhole(copy, join(copy, name))),
  );
}

/** Without the long forms of tests: what they find does not depend on an extra that is gone. */
const { PHONG_VIEWER_RELEASE: _release, ...shortTests } = process.env;

/** Runs a script of Node; empty, or what it said where it failed. */
function run(copy: string, ...args: readonly string[]) {
  const { status, stdout, stderr } = spawnSync(process.execPath, args, {
    cwd: copy,
    encoding: 'utf8',
    env: { ...shortTests, PHONG_VIEWER_OUT: copy },
  });
  return status === 0 ? '' : stdout + stderr;
}

/** All of them, or the one that `npx vitest run tests/release/extras.test.ts -t 'without panel'` names. */
describe.each(EXTRAS)('without %s, the rest', { timeout: 900_000 }, (name) => {
  const gone = withDependents(name);
  let copy = '';

  afterAll(() => {
    if (copy !== '') {
      rmSync(copy, { recursive: true });
    }
  });

  it('compiles', () => {
    expect(typeErrors(gone)).toEqual([]);
  });

  it('builds, and has no entry of it', () => {
    copy = copyWithout(gone);
    for (const [config, mode] of [
      ['lib', 'index'],
      ['standalone', 'production'],
    ] as const) {
      const file = `.ci/vite/${config}.config.ts`;
      expect(
        run(copy, 'node_modules/vite/bin/vite.js', 'build', '--config', file, '--mode', mode),
      ).toBe('');
    }
    expect(run(copy, '.ci/manifest.mjs')).toBe('');
    for (const each of gone) {
      expect(JSON.stringify(exportsOf(copy))).not.toContain(`extras/${each}/`);
    }
  });

  it('passes its tests', () => {
    const tests = testsIn(copy);
    expect(tests.length).toBeGreaterThan(15);
    expect(run(copy, 'node_modules/vitest/vitest.mjs', 'run', ...tests)).toBe('');
  });
});
