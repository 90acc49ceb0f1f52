// Which files are in the package, and what happens when Node imports its entries? Tests dist/ as
// `npm run build` left it.

import { execFileSync, spawnSync } from 'node:child_process';
import { readdirSync, readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { expect, test } from '@playwright/test';
import { outputFolder } from '../../.ci/output-folder.mjs';
import { repository } from '../support/repository.mjs';

const dist = outputFolder('dist');

const manifest = JSON.parse(readFileSync(join(repository, 'package.json'), 'utf8')) as {
  readonly exports: Record<string, string | Record<string, string>>;
  readonly homepage: string;
  readonly repository: { readonly url: string };
  readonly bugs: string;
};

let packed: readonly { readonly path: string; readonly size: number }[] | undefined;
let packedBytes = NaN;

function packedFiles() {
  if (packed !== undefined) return packed;
  // Through a shell, because npm is a script on Windows.
  const json = execFileSync('npm pack --dry-run --json --ignore-scripts', {
    cwd: repository,
    encoding: 'utf8',
    shell: true,
    stdio: ['ignore', 'pipe', 'ignore'],
  });
  const [pack] = JSON.parse(json) as [{ files: NonNullable<typeof packed>; size: number }];
  packedBytes = pack.size;
  return (packed = pack.files);
}

// One worker for all, so that the package is packed once.
test.describe.configure({ mode: 'default' });

test.describe('the packed package', () => {
  const intended = [
    /^(package\.json|README\.md|LICENSE|CHANGELOG\.md)$/,
    // What the README links to.
    /^(demo\/guide\/[a-z]+\.md|\.github\/SECURITY\.md|tests\/(bench|stress)\/REPORT\.md|demo\/assets\/images\/readme\.webp)$/,
    /^dist\/(index|trusted-types|core|reference|react|react-standalone|react-lazy|lazy|playwright)\.js$/,
    /^dist\/react(-standalone|-lazy)?-client\.js$/,
    /^dist\/(still(-threads|-worker|-markup)?|cli|check)\.js$/,
    /^dist\/still\/[\w-]+\.js$/,
    /^dist\/phong-viewer\.(standalone|classic|lazy)\.js$/,
    /^dist\/embed\.(html|js)$/,
    /^dist\/shared\/[\w.-]+\.js$/,
    /^dist\/chunks\/[\w.-]+\.js$/,
    /^dist\/chunks\/(basis_transcoder|draco_decoder)\.wasm$/,
    /^dist\/types\/[\w./-]+\.d\.ts$/,
    /^dist\/texts\/[\w-]+\.(js|json|d\.ts)$/,
    /^dist\/[\w.-]+\.json$/,
    /^dist\/THIRD-PARTY-LICENSES\.txt$/,
  ];

  test('contains the files for users and no others', () => {
    const strays = packedFiles().filter(
      ({ path }) => !intended.some((pattern) => pattern.test(path)),
    );
    expect(strays).toEqual([]);
  });

  test('is not larger than measured', () => {
    packedFiles();
    expect(packedBytes).toBeLessThan(1_700_000); // measured 1,694,600, of which 0.25 MB unpack KTX2
  });

  test('holds each decoder once', () => {
    const decoders = packedFiles().flatMap(
      ({ path }) => /^dist\/.*\/(basis_\w+|draco\w*|ktx2)\b[^/]*$/.exec(path)?.slice(1) ?? [],
    );
    const once = ['basis_transcoder', 'draco', 'draco', 'draco_decoder', 'ktx2'];
    expect(decoders.sort(), 'Draco in JavaScript and its worker').toEqual(once);
  });

  test('contains every file that its exports name', () => {
    const present = packedFiles().map(({ path }) => `./${path}`);
    // One `*` stands for any language.
    const isThere = (name: string) => {
      const [start = '', end] = name.split('*');
      return present.some((path) =>
        end === undefined ? path === name : path.startsWith(start) && path.endsWith(end),
      );
    };
    const named = Object.values(manifest.exports).flatMap((entry) =>
      typeof entry === 'string' ? [entry] : Object.values(entry),
    );
    expect(named.filter((path) => !isThere(path))).toEqual([]);
  });

  test('names one repository as its source, its home and its issue tracker', () => {
    const { homepage, repository: source, bugs } = manifest;
    const address = source.url.replace(/^git\+|\.git$/g, '');
    expect([homepage, bugs]).toEqual([`${address}#readme`, `${address}/issues`]);
  });

  test('has in each file of types what other files import from it', () => {
    const folder = join(dist, 'types');
    const missing = readdirSync(folder, { recursive: true, encoding: 'utf8' })
      .filter((name) => name.endsWith('.d.ts'))
      .flatMap((name) => {
        const text = readFileSync(join(folder, name), 'utf8');
        const imports = text.matchAll(
          /^(?:im|ex)port (?:type )?\{([^}]*)\} from '(\.[^']*)\.js';/gm,
        );
        return [...imports].flatMap(([, names = '', from = '']) => {
          const source = readFileSync(join(folder, dirname(name), `${from}.d.ts`), 'utf8');
          const wanted = names
            .split(',')
            .map((one) => one.replace(/^\s*type |\s+as .*$/g, '').trim());
          return wanted.filter(
            (one) => one !== '' && !new RegExp(`^export .*\\b${one}\\b`, 'm').test(source),
          );
        });
      });
    expect(missing).toEqual([]);
  });
});

test('importing the entries in Node prints nothing, adds no global and lets Node exit', () => {
  const entries = ['index', 'core', 'reference', 'react', 'react-lazy', 'lazy', 'playwright'];
  const addresses = entries.map((entry) => pathToFileURL(join(dist, `${entry}.js`)).href);
  // Lit itself leaves a registry and its versions on globalThis, Playwright its copy of zod.
  const code = `
    const names = () => Object.keys(globalThis).filter((name) => !/^(lit|reactiveElement|customElements|__zod_)/.test(name));
    const before = names().length;
    for (const address of ${JSON.stringify(addresses)}) {
      const exported = Object.keys(await import(address));
      process.stdout.write(names().length === before && exported.length > 0 ? 'quiet ' : address + names());
    }
  `;
  const { status, stdout, stderr } = spawnSync(
    process.execPath,
    ['--input-type=module', '-e', code],
    { cwd: repository, encoding: 'utf8', timeout: 20_000 },
  );
  const quiet = 'quiet '.repeat(entries.length);
  expect({ status, stdout, stderr }).toEqual({ status: 0, stdout: quiet, stderr: '' });
});

/** What Node resolves for stills. */
const FOR_STILLS = /^(three(\/|$)|node:|parse5$|fflate$|jpeg-js$|pngjs)/;

test.describe('dist/', () => {
  const scripts = () =>
    readdirSync(dist, { recursive: true, encoding: 'utf8' })
      .filter((path) => path.endsWith('.js'))
      .map((path) => ({ path, text: readFileSync(join(dist, path), 'utf8') }));

  test('contains no path of the machine that built it', () => {
    const strays = scripts().filter(({ text }) => text.includes(repository));
    expect(strays.map(({ path }) => path)).toEqual([]);
  });

  test('keeps three, Lit, lil-gui and React out of the ES modules and inside the files for pages without a bundler', () => {
    const statement =
      /(?:^|[;}\s])(?:import|export)(?:[^"'`;()]*?from)?\s*\(?\s*["'`]([^"'`\s]+)["'`]/g;
    const imports = (text: string) => Array.from(text.matchAll(statement), (match) => match[1]!);
    for (const { path, text } of scripts()) {
      const bare = imports(text).filter((name) => !name.startsWith('.'));
      if (/^(phong-viewer\.|chunks)/.test(path)) {
        expect(bare, path).toEqual([]);
      } else {
        for (const name of bare) {
          expect(name, path).toMatch(
            /^(still|cli)/.test(path)
              ? FOR_STILLS
              : path === 'check.js'
                ? /^(@playwright\/test$|node:)/
                : /^(three|lit$|lil-gui|react$|@playwright\/test$)/,
          );
        }
      }
    }
  });

  test("gives 'use client' to servers that render React components alone: bundlers warn of it", () => {
    for (const entry of ['react', 'react-standalone', 'react-lazy']) {
      const code = (name: string) => readFileSync(join(dist, `${name}.js`), 'utf8');
      const client = new RegExp(
        `^'use client';\\nexport \\{ (Phong\\w+, )+PhongViewer \\} from './${entry}\\.js';\\n$`,
      );
      expect(code(`${entry}-client`)).toMatch(client);
      expect(code(entry)).not.toContain('use client');
    }
  });
});
