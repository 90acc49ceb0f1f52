// `phong-viewer still`, as `npm run build` left it: what it writes into pages, and what it refuses.
import { spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, mkdtempSync, readFileSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { expect, test } from '@playwright/test';
import { PNG } from 'pngjs';
import { withText } from '../../../src/extras/png/chunks.js';
import { outputFolder } from '../../../.ci/output-folder.mjs';

const command = join(outputFolder('dist'), 'cli.js');
const POSTER = (src: string, width: number, height: number) =>
  `<img slot="poster" src="${src}" width="${width}" height="${height}" alt="" decoding="async">`;

/** A folder with these files. */
function folderOf(files: Readonly<Record<string, string | Uint8Array>>) {
  const folder = mkdtempSync(join(tmpdir(), 'stills-'));
  const path = (name: string) => join(folder, name);
  for (const [name, content] of Object.entries(files)) {
    writeFileSync(path(name), content);
  }
  return {
    path,
    text: (name: string) => readFileSync(path(name), 'utf8'),
    png: (name: string) => PNG.sync.read(readFileSync(path(name))),
    run(...args: string[]) {
      const run = spawnSync(process.execPath, [command, ...args], {
        cwd: folder,
        encoding: 'utf8',
        timeout: 30_000,
      });
      return { status: run.status, out: run.stdout, err: run.stderr };
    },
  };
}

test('a page gets its posters, and no other byte of it changes', () => {
  const before = [
    '\ufeff<!DOCTYPE html>\r\n<p>Ümlaut &amp; <b>unclosed\r\n',
    '<phong-viewer style="width:40px;height:30px" geometry=box>',
    '\r\n\t<!-- a comment --><phong-light  position="1 2 3"/></phong-light>\r\n</phong-viewer>',
    '<Phong-Viewer id="the ring" width=24 height=12 geometry="torus">',
    '</Phong-Viewer>\n<phong-viewer gui style="width: 700px; height: 8px">',
    '</phong-viewer>\n<template><phong-viewer></phong-viewer></template>',
    '<!-- <phong-viewer></phong-viewer> --><script>"<phong-viewer></phong-viewer>"</script>\n',
  ];
  const folder = folderOf({ 'a b.html': before.join('') });
  const { status, out, err } = folder.run('still', 'a b.html');
  expect({ status, err }).toEqual({ status: 0, err: '' });
  expect(out).toMatch(/^a b\.html:3: a%20b\.1\.png, 40 × 30, drawn in .*\na b\.html:5: /);
  const after = [...before];
  after[1] += `\r\n\t${POSTER('a%20b.1.png', 40, 30)}`;
  after[3] += POSTER('a%20b.the-ring.png', 24, 12);
  // Without the place of the panel.
  after[4] += POSTER('a%20b.3.png', 394, 8);
  expect(folder.text('a b.html')).toBe(after.join(''));
  expect(folder.png('a b.the-ring.png')).toMatchObject({ width: 24, height: 12 });
});

test('what is up to date is left alone, and --check fails where something is not', () => {
  const scene = (light: string) =>
    `<phong-viewer src="box.ply" style="width: 20px">${light}</phong-viewer>`;
  const light = '<phong-light></phong-light>';
  const model = fileURLToPath(new URL('../../fixtures/models/coloured.ply', import.meta.url));
  const folder = folderOf({ 'index.html': scene(light), 'box.ply': readFileSync(model) });
  const check = (...args: string[]) => folder.run('still', '--check', 'index.html', ...args);
  const fails = (reason: string, ...args: string[]) => {
    const { status, err } = check(...args);
    expect({ status, err }).toEqual({ status: 1, err: `index.html:1: index.1.png ${reason}.\n` });
  };
  fails('is not there');
  expect(existsSync(folder.path('index.1.png'))).toBe(false);
  expect(folder.run('still', 'index.html').status).toBe(0);
  const page = folder.text('index.html');
  expect(page).toBe(scene(POSTER('index.1.png', 20, 10) + light));
  expect(check()).toEqual({ status: 0, out: '', err: '' });
  expect(folder.run('still', 'index.html').out).toBe('index.html:1: index.1.png is up to date.\n');

  fails('is of another size', '--scale', '2');
  writeFileSync(folder.path('index.html'), page.replace('width="20" ', ''));
  fails('is not the image in the page, or not in its size');
  expect(folder.run('still', 'index.html').status).toBe(0);
  expect(folder.text('index.html')).toContain('<img width="20" slot="poster"');
  writeFileSync(
    folder.path('index.html'),
    page.replace('<phong-light>', '<phong-light diffuse="9">'),
  );
  fails('is of another markup');
  writeFileSync(folder.path('index.html'), page);
  writeFileSync(folder.path('box.ply'), folder.text('box.ply').replace('ply\n', 'ply\ncomment\n'));
  fails('is of another box.ply');
});

test('a poster has the background of its viewer, and --scale gives it more pixels', () => {
  const viewer = (background: string) =>
    `<phong-viewer style="width: 9px; aspect-ratio: 1; ${background}" geometry="box"></phong-viewer>`;
  const folder = folderOf({
    'a.html': viewer('background: rgb(10 20 30)'),
    'b.html': viewer('background: #1238; color: red'),
  });
  const { status, err } = folder.run('still', '--scale', '2', 'a.html', 'b.html');
  expect(status).toBe(0);
  expect(err).toBe(
    'b.html:1: the background "#1238" is no opaque colour, so the poster is transparent.\n',
  );
  const corner = (name: string): readonly number[] => {
    const { width, data } = folder.png(name);
    return [width, ...data.subarray(0, 4)];
  };
  expect(corner('a.1.png')).toEqual([18, 10, 20, 30, 255]);
  expect(corner('b.1.png')).toEqual([18, 0, 0, 0, 0]);
  expect(folder.text('a.html')).toContain('width="9" height="9"');
});

test('a viewer has the size and the background of a rule in <style>, the strongest one', () => {
  const page = `<style>/* p { */ @media (width < 9px) { phong-viewer { width: 1px } } @import "a";
    .wide.b, phong-viewer { width: 20px; height: 10px; background: #123 }
    #a { height: 14px } .wide { width: 24px; height: 9px } main phong-viewer { width: 1px }</style>
    <phong-viewer></phong-viewer><PHONG-VIEWER class="x wide"></PHONG-VIEWER>
    <phong-viewer id="a" class="wide" style="/* width: 1px; */ background: red"></phong-viewer>`;
  const folder = folderOf({ 'p.html': page });
  expect(folder.run('still', 'p.html').status).toBe(0);
  const found = ['1', '2', 'a'].map((name) => {
    const { width, height, data } = folder.png(`p.${name}.png`);
    return [width, height, ...data.subarray(0, 3)];
  });
  expect(found).toEqual([
    [20, 10, 17, 34, 51],
    [24, 9, 17, 34, 51],
    [24, 14, 255, 0, 0],
  ]);
});

/** What comes before a viewer's image and after it, where something stands in its way. */
const UNUSUAL = [
  ['<PHONG-VIEWER STYLE=WIDTH:8PX;HEIGHT:8PX ALT=a&lt;b>', '</PHONG-VIEWER>'],
  // A NUL and lone carriage returns.
  ['a\0b\r<phong-viewer width=8 height=8>', '\r</phong-viewer>\0'],
  ['<table><phong-viewer width=8 height=8>', '</phong-viewer><tr><td>x</table>'],
  ['<svg><foreignObject><phong-viewer width=8 height=8>', '</phong-viewer></svg>'],
  // An address that is none, and an empty id.
  ['<base href="http://["><phong-viewer id width=8 height=8>', '</phong-viewer>'],
  // An id of other letters, longer than names of files.
  [`<phong-viewer id="к/../я${'x'.repeat(300)}" width=8 height=8>`, '</phong-viewer>'],
];
const LONG_ID = `%D0%BA-%D1%8F${'x'.repeat(47)}`;

test('unusual pages get their posters, and no other byte of them changes', () => {
  const names = UNUSUAL.map((_, i) => `${i}.html`);
  const folder = folderOf(Object.fromEntries(UNUSUAL.map((page, i) => [names[i], page.join('')])));
  const { status, err } = folder.run('still', ...names);
  expect({ status, err }).toEqual({ status: 0, err: '' });
  for (const [i, page] of UNUSUAL.entries()) {
    const viewer = page[0]!.includes('id="') ? LONG_ID : 1;
    expect(folder.text(`${i}.html`)).toBe(page.join(POSTER(`${i}.${viewer}.png`, 8, 8)));
  }
  expect(folder.run('still', '--check', ...names).status).toBe(0);
});

test('a poster in a folder that is not there makes it', () => {
  const page = `<phong-viewer><img slot=poster src="a/b/c.png" width="8" height="8"></phong-viewer>`;
  const folder = folderOf({ 'p.html': page });
  expect(folder.run('still', 'p.html').status).toBe(0);
  expect(existsSync(folder.path('a/b/c.png'))).toBe(true);
  expect(folder.text('p.html')).toBe(page);
});

test('a stamp made to attack is no poster, or not up to date', () => {
  const plain = new Uint8Array(PNG.sync.write(new PNG({ width: 1, height: 1 })));
  const folder = folderOf({ 'p.html': '<phong-viewer width="8" height="8"></phong-viewer>' });
  folder.run('still', 'p.html');
  const page = folder.text('p.html');
  const own = JSON.parse(
    folder.text('p.1.png').match(/phong-viewer still\0*(\{.*?\}\})/)![1]!,
  ) as object;
  for (const stamp of [
    'null',
    '7',
    '[]',
    '{"version":"\\u001b[2J"}',
    JSON.stringify({ ...own, files: { '/dev/zero': 'x' } }),
    JSON.stringify({ ...own, files: { 'http://127.0.0.1:9/a': 'x' } }),
    JSON.stringify({ ...own, files: 'abc' }),
  ]) {
    writeFileSync(folder.path('p.1.png'), withText(plain, 'phong-viewer still', stamp));
    const { status, err } = folder.run('still', '--check', 'p.html');
    expect(status, stamp).not.toBeNull();
    expect(err, stamp).not.toContain('\u001b');
    expect(err, stamp).not.toContain('    at ');
  }
  expect(folder.text('p.html')).toBe(page);
});

test('images that the command has not made are neither written over nor replaced', () => {
  const png = PNG.sync.write(new PNG({ width: 1, height: 1 }));
  const viewer = (attributes: string, inner: string) =>
    `<phong-viewer geometry="box" width="8" height="8" ${attributes}>${inner}</phong-viewer>\n`;
  const page = [
    viewer('', '<img slot="poster" src="mine.png">'),
    viewer('', '<img slot="poster" src="photo.jpg">'),
    viewer('', '<img slot="poster" src="https://example.org/a.png">'),
    viewer('', '<picture slot="poster"></picture>'),
    viewer('poster="mine.png"', ''),
    `<phong-compare>${viewer('', '')}</phong-compare>`,
    viewer('', ''),
  ].join('');
  const folder = folderOf({ 'p.html': page, 'mine.png': png, 'p.7.png': png });
  const { status, out, err } = folder.run('still', 'p.html');
  expect({ status, err }).toEqual({ status: 0, err: '' });
  expect(out.match(/left alone/g)).toHaveLength(6);
  expect(readFileSync(folder.path('mine.png')).equals(png)).toBe(true);
  expect(readFileSync(folder.path('p.7.png')).equals(png)).toBe(true);
  expect(folder.text('p.html').match(/<img[^>]*src="p\.[^>]*>/g)).toEqual([
    POSTER('p.7.2.png', 8, 8),
  ]);
});

test('a script from the command line draws on threads', () => {
  const still = JSON.stringify(pathToFileURL(join(outputFolder('dist'), 'still.js')));
  const script = `import { still } from ${still};
    process.stdout.write((await still('<phong-viewer></phong-viewer>', { width: 9, height: 8, threads: 1e6 })).png.subarray(1, 4));`;
  const run = spawnSync(process.execPath, ['--input-type=module', '-e', script], {
    encoding: 'utf8',
  });
  expect(run).toMatchObject({ stdout: 'PNG', stderr: '' });
});

test('--out draws one picture and leaves the page as it is', () => {
  const page = '<phong-viewer geometry="box"></phong-viewer>';
  const folder = folderOf({ 'a.html': page });
  expect(folder.run('still', 'a.html', '--out', 'scene.png', '--size', '12x8').status).toBe(0);
  expect(folder.text('a.html')).toBe(page);
  expect(folder.png('scene.png')).toMatchObject({ width: 12 });
});

const sized = (attributes: string, inner = '') =>
  `<p>\n<phong-viewer style="width:8px;height:8px" ${attributes}>${inner}</phong-viewer>`;

/** Pages, each with its error after the file's name. */
const FAULTY = [
  ['<phong-viewer geometry="box"></phong-viewer>', '1: the viewer has no'],
  ['<p>\n<phong-viewer geometry="box"><p>', '2: <phong-viewer> needs'],
  [sized('', '<b><phong-viewer></phong-viewer></b>'), '2: <phong-viewer> holds another'],
  ['<p>', ' has no <phong-viewer>'],
  [sized('src="none.glb"'), '2: The file none.glb cannot be read'],
  [sized('src="http://127.0.0.1:9/a.glb"'), '2: '],
  [sized('src="/dev/zero" type="model/gltf-binary"'), '2: The file zero'],
  // Where it is no viewer.
  ['<svg><phong-viewer width="8" height="8" /></svg>', ' has no'],
  [`<base href="https://a.example/">${sized('')}`, '2: <base href> leads to'],
  ['<phong-viewer width="99999" height="99999"></phong-viewer>', '1: a still has'],
] as const;

test('what fails is an error with file and line and stays as it is, all others are done', () => {
  const names = FAULTY.map((_, i) => `${i}.html`);
  const folder = folderOf({
    ...Object.fromEntries(FAULTY.map(([page], i) => [names[i], page])),
    'a.html': sized('src="none.glb"') + sized(''),
    'b.html': sized(''),
    'latin.html': Uint8Array.of(0xe4),
  });
  mkdirSync(folder.path('folder'));
  const all = ['folder', 'none.html', 'latin.html', ...names, 'a.html', 'b.html'];
  const { status, out, err } = folder.run('still', ...all);
  expect(status).toBe(1);
  expect(err.trim().split('\n')).toEqual([
    expect.stringMatching(/^folder: is a folder/),
    'none.html: there is no such file.',
    'latin.html: is not UTF-8.',
    ...FAULTY.map(([, part], i) => expect.stringContaining(`${i}.html:${part}`) as unknown),
    expect.stringMatching(/^a\.html:2: /),
  ]);
  expect(out).toMatch(/^a\.html:3: .*\nb\.html:2: .*\n$/);
  expect(names.map(folder.text)).toEqual(FAULTY.map(([page]) => page));
});

for (const [args, part] of [
  [[], 'Say what to do'],
  [['draw'], 'There is no command "draw"'],
  [['still'], 'Name the pages'],
  [['still', 'a.html', '--size', '760'], '--size takes'],
  [['still', 'a.html', '--scale', '0'], '--scale takes'],
  [['still', 'a.html', '--zoom', '2'], "Unknown option '--zoom'"],
  [['still', 'a.html', 'b.html', '--out', 'a.png'], '--out is for one'],
  [['still', '--out', 'a.html', 'a.html'], 'a file that ends with .png'],
] as const) {
  test(`phong-viewer ${args.join(' ')} is one line and status 2`, () => {
    const { status, out, err } = folderOf({}).run(...args);
    expect({ status, out }).toEqual({ status: 2, out: '' });
    expect(err).toMatch(/^.+ See phong-viewer --help\.\n$/);
    expect(err).toContain(part);
  });
}

test('--help says what the command does', () => {
  const { status, out } = folderOf({}).run('--help');
  expect(status).toBe(0);
  expect(out.split('\n')).toContain('  --help, --version');
});
