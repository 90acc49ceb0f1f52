// Does the package carry the licences of the code that it contains? Against dist/ as the build step
// left it, since minification is what drops notices.

import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect, test } from '@playwright/test';
import { outputFolder } from '../../.ci/output-folder.mjs';
import { repository } from '../support/repository.mjs';

const dist = outputFolder('dist');

/** What stands before the code of a file below dist/: its notice, and what it tells the browser. */
const notice = (path: string) =>
  /^\/\*![^]*?\*\/(\n\/\/#.*)?/.exec(readFileSync(join(dist, path), 'utf8'))?.[0] ?? '';

function version(name: string) {
  const text = readFileSync(join(repository, 'node_modules', name, 'package.json'), 'utf8');
  return (JSON.parse(text) as { version: string }).version;
}

const licences = () => readFileSync(join(dist, 'THIRD-PARTY-LICENSES.txt'), 'utf8');

for (const name of ['three', '@lit/reactive-element', 'lil-gui']) {
  test(`THIRD-PARTY-LICENSES.txt holds the licence of ${name} with its version`, () => {
    const folder = join(repository, 'node_modules', name);
    const file = readdirSync(folder).find((entry) => /^licen[cs]e/i.test(entry))!;
    expect(licences()).toContain(`\n${name} ${version(name)}\n`);
    expect(licences()).toContain(readFileSync(join(folder, file), 'utf8').trim());
  });
}

test('THIRD-PARTY-LICENSES.txt holds the licences of the decoders in three, and of what their WebAssembly contains', () => {
  for (const [decoder, ...words] of [
    ['Draco decoder', 'Copyright The Draco Authors', 'Apache License'],
    ['Basis Universal transcoder', 'Binomial LLC', 'For Zstandard software'],
    ['meshoptimizer decoder', 'Arseny Kapoulkine'],
  ]) {
    for (const text of [`\n${decoder} (in three ${version('three')})\n`, ...words]) {
      expect(licences()).toContain(text);
    }
  }
});

test('every bundle that contains code of others begins with a notice that names it', () => {
  const chunk = (folder: string, name: string) =>
    `${folder}/${readdirSync(join(dist, folder)).find((file) => file.startsWith(name) && file.endsWith('.js'))}`;
  const expected: readonly (readonly [path: string, holders: readonly RegExp[]])[] = [
    ['phong-viewer.standalone.js', [/three\.js authors/, /Google LLC/]],
    [
      'phong-viewer.classic.js',
      [/three\.js authors/, /Google LLC/, /George Michael Brower/, /Draco Authors/],
    ],
    [chunk('chunks', 'panel-rows'), [/George Michael Brower/]],
    // Compiled while it is fetched, not function by function.
    [chunk('chunks', 'read-gltf'), [/three\.js authors[^]*\n\/\/# allFunctionsCalledOnLoad$/]],
    [chunk('chunks', 'teapot'), [/three\.js authors/]],
    [chunk('chunks', 'meshopt'), [/Arseny Kapoulkine/]],
    [chunk('chunks', 'draco'), [/Draco Authors/]],
    [chunk('chunks', 'draco-worker'), [/Draco Authors/]],
    [chunk('chunks', 'ktx2-worker'), [/Binomial LLC/]],
  ];
  for (const [path, holders] of expected) {
    for (const holder of holders) {
      expect(notice(path), path).toMatch(holder);
    }
    expect(notice(path), path).toContain('THIRD-PARTY-LICENSES.txt');
  }
});

test("every entry begins with the package's own name, version and licence", () => {
  const own = JSON.parse(readFileSync(join(repository, 'package.json'), 'utf8')) as {
    version: string;
  };
  const entries = [
    'index',
    'core',
    'reference',
    'react',
    'phong-viewer.standalone',
    'phong-viewer.classic',
  ];
  for (const entry of entries) {
    expect(notice(`${entry}.js`), entry).toContain(`phong-viewer ${own.version}, MIT`);
  }
});
