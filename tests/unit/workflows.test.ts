// Would the workflows run? No machine here runs them, so what they name must exist: npm scripts, options and steps of
// our own commands, files, versions. Reads them line by line, which suffices for how they are written.

import { execFileSync } from 'node:child_process';
import { accessSync, constants, existsSync, readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { describe, expect, it } from 'vitest';

const repository = fileURLToPath(new URL('../..', import.meta.url));
const folder = join(repository, '.github/workflows');
const workflows = readdirSync(folder).map((name) => ({
  name,
  text: readFileSync(join(folder, name), 'utf8'),
}));
const { scripts, engines, peerDependencies } = JSON.parse(
  readFileSync(join(repository, 'package.json'), 'utf8'),
) as Readonly<Record<'scripts' | 'engines' | 'peerDependencies', Readonly<Record<string, string>>>>;

/** The values of a key in all workflows, without quotes. */
const valuesOf = (key: string, text: string): readonly string[] =>
  Array.from(text.matchAll(new RegExp(`^[ -]*${key}: (.+)$`, 'gm')), ([, value = '']) =>
    value.replaceAll("'", ''),
  );

/** The entries of a list in brackets. */
const listOf = (key: string, text: string): readonly string[] =>
  (valuesOf(key, text)[0] ?? '')
    .replaceAll(/[[\]]/g, '')
    .split(',')
    .map((entry) => entry.trim());

const textOf = (name: string): string => readFileSync(join(folder, name), 'utf8');

/** What a run line passes to which of our scripts: `.ci/run` is `npm test --`. Undefined where it runs none. */
function scriptOf(line: string): { readonly script: string; readonly args: readonly string[] } | undefined {
  const [, script, rest = ''] = /^npm run (\S+)(?: -- (.*))?$/.exec(line) ?? /^\.ci\/(run)(?: (.*))?$/.exec(line) ?? []; // prettier-ignore
  if (script === undefined) return undefined;
  return { script: script === 'run' ? 'test' : script, args: rest.split(' ').filter((arg) => arg !== '') };
}

const runs = workflows.flatMap(({ name, text }) =>
  valuesOf('run', text).flatMap((line) => {
    const found = scriptOf(line);
    return found === undefined ? [] : [{ name, line, ...found }];
  }),
);

/** What `--help` prints, by script. */
const helps = new Map<string, string>();
function helpOf(script: string): string {
  const known = helps.get(script);
  if (known !== undefined) return known;
  const [, program = ''] = /^node (\S+)/.exec(scripts[script] ?? '') ?? [];
  const help = execFileSync(process.execPath, [program, '--help'], { cwd: repository, encoding: 'utf8' });
  helps.set(script, help);
  return help;
}

describe('the workflows', () => {
  it('run commands of this repository', () => {
    expect(runs.map(({ line }) => line)).toContain('.ci/run');
    accessSync(join(repository, '.ci/run'), constants.X_OK);
  });

  it.each(runs)('$name: `$line` names a script, and options that it has', ({ script, args }) => {
    expect(scripts).toHaveProperty([script]);
    for (const arg of args)
      if (arg.startsWith('tests/')) expect(existsSync(join(repository, arg)), arg).toBe(true);
    if (args.length === 0 || !/^node /.test(scripts[script]!)) return;
    const words = helpOf(script).split(/[\s,[\]]+/);
    const known = args.filter((arg) => arg.startsWith('--') || script === 'test');
    for (const arg of known) expect(words).toContain(arg);
  });

  it.each(workflows)('$name uploads only what a step writes', ({ text }) => {
    const written = [
      'test-results',
      'site',
      ...Array.from(text.matchAll(/--out (\S+)/g), ([, file]) => file),
    ];
    for (const path of valuesOf('path', text)) expect(written).toContain(path);
  });

  it.each(workflows)('$name watches files that exist', ({ text }) => {
    if (!/^ +paths: /m.test(text)) return;
    for (const path of listOf('paths', text))
      expect(existsSync(join(repository, path.replace('/**', ''))), path).toBe(true);
  });

  it('use one version of each action', () => {
    const versions = new Map<string, string>();
    for (const used of workflows.flatMap(({ text }) => valuesOf('uses', text))) {
      const [action = '', version = ''] = used.split('@');
      expect(version, used).toMatch(/^v\d+$/);
      expect(versions.get(action) ?? version, used).toBe(version);
      versions.set(action, version);
    }
  });

  it('check with the oldest Node that package.json allows', () => {
    expect(`>=${listOf('node', textOf('ci.yml'))[0]!}`).toBe(engines['node']);
  });

  it('test with every three.js that package.json allows, and with the latest', () => {
    const versions = listOf('three', textOf('three-versions.yml'));
    expect(peerDependencies['three']).toMatch(new RegExp(`^>=${versions[0]!} `));
    expect(versions.at(-1)).toBe('latest');
    const minors = versions.slice(0, -1).map((version) => Number(version.split('.')[1]));
    expect(minors).toEqual(minors.map((_, i) => minors[0]! + i));
    const installed = JSON.parse(
      readFileSync(join(repository, 'node_modules/three/package.json'), 'utf8'),
    ) as { readonly version: string };
    expect(minors.at(-1)).toBe(Number(installed.version.split('.')[1]) - 1);
  });

  it('make mutants of every folder', () => {
    const [, folders = ''] = /--folder NAME .*: (.+)/.exec(helpOf('mutation')) ?? [];
    expect(listOf('folder', textOf('nightly.yml'))).toEqual(folders.split(', '));
  });
});
