// Do the commands of package.json explain themselves, refuse what they do not know in one line, and
// say in one line what is missing? A stack trace tells a user nothing.

import { execFile } from 'node:child_process';
import { mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { firstOf } from '../support/repeats.js';
import { repository } from '../support/repository.mjs';

const { scripts } = JSON.parse(readFileSync(join(repository, 'package.json'), 'utf8')) as {
  readonly scripts: Readonly<Record<string, string>>;
};
const names = [
  'test',
  'stress',
  'bench',
  'bench:report',
  'stress:report',
  'mutation',
  'readme:picture',
  'site:picture',
  'site:models',
];

/** Its script, run with arguments and variables of its own. */
function run(
  name: string,
  args: readonly string[],
  variables: Readonly<Record<string, string>> = {},
): Promise<{ readonly code: number; readonly out: string; readonly said: string }> {
  // npm adds arguments to the last program of a script: one program must be all of it.
  const [, ...own] = scripts[name]!.split(' ');
  expect(own).not.toContain('&&');
  return new Promise((resolve) => {
    execFile(
      process.execPath,
      [...own, ...args],
      { cwd: repository, env: { ...process.env, ...variables } },
      (error, out, said) =>
        resolve({ code: typeof error?.code === 'number' ? error.code : 0, out, said }),
    );
  });
}

// They share the code that reads a command line, so one stands for the others.
describe.each(firstOf(names, 2))('npm run %s', (name) => {
  it.concurrent('explains itself with --help', async ({ expect }) => {
    const { code, out, said } = await run(name, ['--help']);
    expect({ code, said }).toEqual({ code: 0, said: '' });
    expect(out).toContain(name === 'test' ? 'npm test' : `npm run ${name}`);
  });

  it.concurrent('refuses an unknown option and an unknown name in one line', async ({ expect }) => {
    for (const strange of ['--nonsense', 'nonsense']) {
      const { code, out, said } = await run(name, [strange]);
      expect({ code, out }).toEqual({ code: 2, out: '' });
      expect(said).toBe(
        `Unknown ${strange.startsWith('-') ? 'option' : 'argument'} '${strange}'. See --help.\n`,
      );
    }
  });
});

it('npm run bench lists its subjects', async () => {
  expect((await run('bench', ['--list'])).out).toContain('sphere, 8 lights\n');
});

describe('a command', () => {
  const folder = mkdtempSync(join(tmpdir(), 'phong-viewer-'));
  const broken = join(folder, 'results/software.json');
  beforeAll(() => {
    mkdirSync(join(folder, 'results'));
    writeFileSync(broken, '{ "stack": ');
  });
  afterAll(() => rmSync(folder, { recursive: true }));

  const NOWHERE = '/no/such/folder';
  it.each<[string, RegExp, readonly string[]]>([
    ['bench', /^--launches takes a number of at least 1, not '0'/, ['--launches', '0']],
    ['bench', /^No subject contains 'a teapot'/, ['--only', 'a teapot']],
    ['bench', /^There are no built pages in \/no\/such\/folder/, ['--built', NOWHERE]],
    ['bench:report', /software\.json is no JSON that can be read/, ['--folder', folder]],
    ['stress', /^Unknown driver 'left'/, ['--drivers', 'left']],
    // Before hours of measuring.
    ['stress', /software\.json is no JSON that can be read/, ['--out', broken]],
    ['mutation', /^Unknown folder 'attic'/, ['--folder', 'attic']],
  ])('npm run %s says in one line what is wrong: %s', async (name, message, args) => {
    const { code, out, said } = await run(name, args);
    expect({ code, out }).toEqual({ code: 2, out: '' });
    expect(said).toMatch(/^[^\n]+\. See --help\.\n$/);
    expect(said).toMatch(message);
  });

  it.each(firstOf(['site:picture', 'readme:picture', 'site:models'], 1))(
    'npm run %s says in one line that there is no build',
    async (name) => {
      const { code, said } = await run(name, [], { PHONG_VIEWER_OUT: folder });
      expect(code).toBe(2);
      expect(said).toMatch(
        /^\S+ is missing: run `npm run build(?::site)?` first\. See --help\.\n$/,
      );
    },
  );
});
