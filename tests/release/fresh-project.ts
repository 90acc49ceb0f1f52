// Makes a project in a temporary folder with the packed tarball installed as a user would. The
// tarball comes from dist/ as `npm run build` left it, other packages from the registry at the
// versions in this repository's package.json.

import { exec, execSync, spawn } from 'node:child_process';
import {
  cpSync,
  existsSync,
  mkdirSync,
  mkdtempSync,
  readFileSync,
  rmSync,
  writeFileSync,
} from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import type { Page } from '@playwright/test';
import { outputFolder } from '../../.ci/output-folder.mjs';
import { startSite, strictPolicy } from '../support/site.js';
import { allReady, test } from '../support/test.js';
import { repository } from '../support/repository.mjs';

export const manifest = JSON.parse(readFileSync(join(repository, 'package.json'), 'utf8')) as {
  readonly version: string;
  readonly devDependencies: Readonly<Record<string, string>>;
  readonly peerDependencies: Readonly<Record<string, string>>;
};

/**
 * For the tests of the describe block it is called in, which then run in order: makes the project
 * before the first and removes it after the last.
 */
export function useFreshProject(
  packages: readonly string[],
  prepare: (project: FreshProject) => unknown = () => undefined,
): () => FreshProject {
  let project: FreshProject | undefined;
  test.describe.configure({ mode: 'serial', timeout: TIMEOUT });
  test.beforeAll(async () => {
    test.setTimeout(TIMEOUT);
    project = freshProject(packages);
    await prepare(project);
  });
  test.afterAll(() => project?.remove());
  return () => project!;
}

/** Installing a framework and building a page with it takes minutes. */
const TIMEOUT = 400_000;

/** @param packages names of this repository's devDependencies, or `name@range`. */
export function freshProject(packages: readonly string[]) {
  const folder = mkdtempSync(join(tmpdir(), 'phong-viewer-fresh-'));
  const ends: (() => unknown)[] = [];
  const project = {
    folder,
    write(path: string, text: string) {
      mkdirSync(dirname(join(folder, path)), { recursive: true });
      writeFileSync(join(folder, path), text);
    },
    /** Returns the command's output. Throws with all of it if the command fails. */
    run: (command: string) => run(command, folder),
    /** The same without blocking this process. */
    runBeside: (command: string) => runBeside(command, folder),
    /**
     * Starts a server by a script of an installed package, until the project is removed. Gives the
     * address that it prints, such as `http://localhost:40123`.
     */
    serve(script: string, args: readonly string[]) {
      const { origin, stop } = serve(join(folder, 'node_modules', script), args, folder);
      ends.push(stop);
      return origin;
    },
    /** Builds a page with this body by Vite. Returns the output folder. */
    build(body: string) {
      project.write('index.html', pageOf(body));
      project.run('npx vite build --base ./ --logLevel warn');
      return join(folder, 'dist');
    },
    /**
     * Opens the index page of a folder under this policy, and waits until its viewers are drawn.
     */
    async open(page: Page, root: string, policy = strictPolicy) {
      const site = await startSite({ '/': root }, policy);
      ends.push(() => site.close());
      await page.goto(`${site.origin}/`);
      await allReady(page);
    },
    async remove() {
      for (const end of ends) {
        await end();
      }
      rmSync(folder, { recursive: true, force: true });
    },
  };
  project.write('package.json', JSON.stringify({ name: 'fresh', private: true, type: 'module' }));
  const wanted = [pack(folder), ...packages.map(versioned)].map((name) => JSON.stringify(name));
  project.run(`npm install --no-audit --no-fund ${wanted.join(' ')}`);
  return project;
}

type FreshProject = ReturnType<typeof freshProject>;

/** A page without a request for an icon. */
export const pageOf = (body: string): string =>
  '<!doctype html><html lang="en"><head><meta charset="utf-8"><title>Fresh</title>' +
  `<link rel="icon" href="data:,"></head><body>${body}</body></html>`;

/** Compiler options of a strict project that also checks the types of libraries. */
export const strictOptions = {
  strict: true,
  noEmit: true,
  target: 'ES2022',
  module: 'ESNext',
  moduleResolution: 'bundler',
  exactOptionalPropertyTypes: true,
  skipLibCheck: false,
  types: [],
};

/**
 * The first block of code under a heading of the README, or of the guide's pages about installing
 * and core.
 */
export function readmeSample(heading: string): string {
  for (const page of ['README.md', 'demo/guide/install.md', 'demo/guide/core.md']) {
    const text = readFileSync(join(repository, page), 'utf8');
    const [, section = ''] = text.split(new RegExp(`\n##+ ${heading}\n`));
    const sample = /```(?:js|jsx)\n([^]*?)```/.exec(section)?.[1];
    if (sample !== undefined) return sample;
  }
  throw new Error(`No page has code under "${heading}"`);
}

/** The scripts of the documents that import the elements or ask `shadeAt`, in their order. */
export const readmeScripts = (): string[] =>
  ['README.md', 'demo/guide/install.md', 'demo/guide/reference.md']
    .flatMap((page) => [
      ...readFileSync(join(repository, page), 'utf8').matchAll(/```(?:ts|js)\n([^]*?)```/g),
    ])
    .map(([, code = '']) => code)
    .filter((code) => /(?:from|import) 'phong-viewer'|\.shadeAt\(/.test(code));

/** Packs a copy, because PHONG_VIEWER_OUT may put dist/ elsewhere than beside package.json. */
function pack(folder: string) {
  const staged = join(folder, 'packed');
  mkdirSync(staged);
  for (const name of ['package.json', 'README.md', 'LICENSE', 'CHANGELOG.md']) {
    if (existsSync(join(repository, name))) {
      cpSync(join(repository, name), join(staged, name));
    }
  }
  cpSync(outputFolder('dist'), join(staged, 'dist'), { recursive: true });
  run(`npm pack --ignore-scripts --pack-destination ${JSON.stringify(folder)}`, staged);
  rmSync(staged, { recursive: true });
  return `./phong-viewer-${manifest.version}.tgz`;
}

function versioned(name: string) {
  if (name.lastIndexOf('@') > 0) return name;
  const range = manifest.devDependencies[name];
  if (range === undefined) throw new Error(`${name} is not a devDependency: add a range`);
  return `${name}@${range}`;
}

/** Frameworks report on their use unless these variables forbid it. */
const env = { ...process.env, NEXT_TELEMETRY_DISABLED: '1', ASTRO_TELEMETRY_DISABLED: '1' };

function serve(script: string, args: readonly string[], cwd: string) {
  const server = spawn(process.execPath, [script, ...args], { cwd, env, stdio: 'pipe' });
  let said = '';
  const origin = new Promise<string>((resolve, reject) => {
    const hear = (chunk: Buffer) => {
      said += chunk.toString();
      const [, port] =
        /http:\/\/(?:localhost|127\.0\.0\.1|0\.0\.0\.0|\[::\]):(\d+)/.exec(said) ?? [];
      if (port !== undefined) {
        resolve(`http://localhost:${port}`);
      }
    };
    server.stdout.on('data', hear);
    server.stderr.on('data', hear);
    server.on('exit', () => reject(new Error(`The server has ended:\n${said}`)));
  });
  return { origin, stop: () => server.kill() };
}

function run(command: string, cwd: string) {
  try {
    return execSync(command, { cwd, env, encoding: 'utf8', stdio: 'pipe', timeout: 240_000 });
  } catch (error) {
    const { stdout, stderr } = error as { stdout: string; stderr: string };
    throw new Error(`${command}\n${stdout}\n${stderr}`, { cause: error });
  }
}

function runBeside(command: string, cwd: string): Promise<string> {
  // Playwright tells workers by variables, which a Playwright of the project's own must not
  // inherit.
  const own = Object.fromEntries(
    Object.entries(env).filter(([name]) => !/^(TEST_|PW_|PLAYWRIGHT_)/.test(name)),
  );
  return new Promise((resolve, reject) =>
    exec(command, { cwd, env: own, timeout: 240_000 }, (error, stdout, stderr) => {
      if (error === null) {
        resolve(stdout);
      } else {
        reject(new Error(`${command}\n${stdout}\n${stderr}`, { cause: error }));
      }
    }),
  );
}
