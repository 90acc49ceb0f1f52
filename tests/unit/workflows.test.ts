// Would the workflows run? No machine here runs them, so what they name must exist: npm scripts,
// options and steps of our own commands, files, versions. Reads them line by line, which suffices
// for how they are written.

import { execFileSync } from 'node:child_process';
import { accessSync, constants, existsSync, readdirSync, readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';

const folder = '.github/workflows';
const textOf = (name: string) => readFileSync(`${folder}/${name}`, 'utf8');
const workflows = readdirSync(folder).map((name) => ({ name, text: textOf(name) }));
const jsonOf = (path: string): unknown => JSON.parse(readFileSync(path, 'utf8'));
const { scripts, engines, dependencies, peerDependencies } = jsonOf('package.json') as Readonly<
  Record<
    'scripts' | 'engines' | 'dependencies' | 'peerDependencies',
    Readonly<Record<string, string>>
  >
>;

/** The text of each job, by its file and name. */
const jobs = workflows.flatMap(({ name, text }) =>
  text
    .slice(text.indexOf('\njobs:\n'))
    .split(/\n(?= {2}[a-z]+:\n)/)
    .slice(1)
    .map((job) => ({ name: `${name} ${/[a-z]+/.exec(job)![0]}`, text: job })),
);

/** The values of a key in all workflows, without quotes. */
const valuesOf = (key: string, text: string) =>
  Array.from(text.matchAll(new RegExp(`^[ -]*${key}: (.+)$`, 'gm')), ([, value = '']) =>
    value.replaceAll("'", ''),
  );

/** The entries of a list in brackets. */
const listOf = (key: string, text: string) =>
  (valuesOf(key, text)[0] ?? '')
    .replaceAll(/[[\]]/g, '')
    .split(',')
    .map((entry) => entry.trim());

/** The run lines that pass arguments to one of our scripts: `.ci/run` is `npm test --`. */
const runs = workflows.flatMap(({ name, text }) =>
  valuesOf('run', text).flatMap((line) => {
    const [, script, rest = ''] =
      /^npm run (\S+)(?: -- (.*))?$/.exec(line) ?? /^\.ci\/(run)(?: (.*))?$/.exec(line) ?? [];
    if (script === undefined) return [];
    const args = rest.split(' ').filter((arg) => arg !== '');
    return [{ name, line, script: script === 'run' ? 'test' : script, args }];
  }),
);

/** What `--help` prints, by script. */
const helps = new Map<string, string>();
function helpOf(script: string) {
  const [, program = ''] = /^node (\S+)/.exec(scripts[script] ?? '') ?? [];
  const help =
    helps.get(script) ?? execFileSync(process.execPath, [program, '--help'], { encoding: 'utf8' });
  helps.set(script, help);
  return help;
}

describe('the workflows', () => {
  it('run commands of this repository', () => {
    expect(runs.map(({ line }) => line)).toContain('.ci/run');
    accessSync('.ci/run', constants.X_OK);
  });

  it.each(runs)('$name: `$line` names a script, and options that it has', ({ script, args }) => {
    expect(scripts).toHaveProperty([script]);
    const paths = args.filter((arg) => arg.startsWith('tests/'));
    expect(paths.filter((path) => !existsSync(path))).toEqual([]);
    if (args.length === 0 || !/^node /.test(scripts[script]!)) return;
    const words = helpOf(script).split(/[\s,[\]]+/);
    const known = args.filter((arg) => arg.startsWith('--') || script === 'test');
    for (const arg of known) {
      expect(words).toContain(arg);
    }
  });

  it.each(workflows)(
    '$name uploads only what a step writes, and watches files that exist',
    ({ text }) => {
      const outs = Array.from(text.matchAll(/--out (\S+)/g), ([, file]) => file);
      for (const path of valuesOf('path', text)) {
        expect(['test-results', 'site', '*.tgz', ...outs]).toContain(path);
      }
      const watched = /^ +paths: /m.test(text) ? listOf('paths', text) : [];
      expect(watched.filter((path) => !existsSync(path.replace('/**', '')))).toEqual([]);
    },
  );

  it('take each action by one commit, and say which release that is', () => {
    const used = new Set(workflows.flatMap(({ text }) => valuesOf('uses', text)));
    for (const each of used) {
      // A tag can be moved to other code; a commit cannot.
      expect(each).toMatch(/^[\w/-]+@[0-9a-f]{40} # v\d+\.\d+\.\d+$/);
    }
    expect(new Set(Array.from(used, (each) => each.split('@')[0])).size).toBe(used.size);
  });

  it('let only jobs that check out and install nothing write anywhere or have an identity', () => {
    const writing = jobs.filter(({ text }) => / [a-z-]+: write$/m.test(text));
    expect(writing.map(({ name }) => name)).toEqual(['release.yml publish', 'site.yml deploy']);
    for (const { name, text } of writing) {
      // The environment is where the repository's settings ask a person.
      expect(text, name).toMatch(/^ {4}environment:/m);
      expect(text, name).not.toMatch(/actions\/checkout|npm (ci|install|run)|npx|\.ci\//);
    }
    for (const { name, text } of workflows) {
      const head = text.slice(0, text.indexOf('\njobs:\n'));
      expect(head, name).toMatch(/^permissions:\n {2}contents: read\n(?! )/m);
    }
  });

  it('publish the tarball that a job without rights packed, and run none of its scripts', () => {
    const [, publish = ''] = /\n {2}publish:\n([^]*)$/.exec(textOf('release.yml')) ?? [];
    expect(publish).toMatch(/needs: \[test, pack\]/);
    expect(valuesOf('run', publish)).toEqual([
      'npm publish ./*.tgz --ignore-scripts --provenance --access public',
    ]);
    expect(publish).toContain('package-manager-cache: false');
  });

  it('get updates of what the package brings along, and of the actions', () => {
    const text = readFileSync('.github/dependabot.yml', 'utf8');
    expect(valuesOf('package-ecosystem', text)).toEqual(['github-actions', 'npm']);
    expect(valuesOf('dependency-name', text).toSorted()).toEqual(
      Object.keys(dependencies).toSorted(),
    );
  });

  it('test with the oldest Node and every three.js that package.json allows, and with the latest', () => {
    expect(`>=${listOf('node', textOf('ci.yml'))[0]!}`).toBe(engines['node']);
    const versions = listOf('three', textOf('three-versions.yml'));
    expect(peerDependencies['three']).toMatch(new RegExp(`^>=${versions[0]!} `));
    expect(versions.at(-1)).toBe('latest');
    const minors = versions.slice(0, -1).map((version) => Number(version.split('.')[1]));
    expect(minors).toEqual(minors.map((_, i) => minors[0]! + i));
    const installed = jsonOf('node_modules/three/package.json') as { readonly version: string };
    expect(minors.at(-1)).toBe(Number(installed.version.split('.')[1]) - 1);
  });

  it('make mutants of every folder', () => {
    const [, folders = ''] = /--folder NAME .*: (.+)/.exec(helpOf('mutation')) ?? [];
    expect(listOf('folder', textOf('nightly.yml'))).toEqual(folders.split(', '));
  });
});
