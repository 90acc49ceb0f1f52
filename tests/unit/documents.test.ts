// Do the documents match the code? Links lead to files and headings that exist, in the
// repository, in the package and on the site, and they stay short.

import { execFileSync } from 'node:child_process';
import { existsSync, readFileSync, statSync } from 'node:fs';
import { dirname, join, posix } from 'node:path';
import { describe, expect, it } from 'vitest';
import { guide } from '../../.ci/site/contents.js';
import { EXTRAS } from '../../.ci/layers.mjs';
import { anchorOf } from '../../.ci/site/markdown.js';
import { guidePage, markdownOf, pagePaths } from '../../.ci/site/pages.js';
import { layoutDefines } from '../../src/phong/light/light-layout.js';
import { VIEWS } from '../../src/phong/material/views.js';

/** Files of the repository, new ones included. */
function filesOf(...patterns: string[]) {
  const args = ['ls-files', '--cached', '--others', '--exclude-standard', ...patterns];
  const paths = execFileSync('git', args, { encoding: 'utf8' });
  return paths.split('\n').filter(existsSync);
}

/** Every page of the repository. */
const documents = filesOf('*.md');
/** What the package's users read. */
const forUsers = documents.filter((path) => /^(README|CHANGELOG|demo\/guide\/.*)\.md$/.test(path));
const decisions = documents.filter((path) => path.startsWith('src/decisions/'));

const read = (path: string) => readFileSync(path, 'utf8');

const anchorsOf = (path: string) =>
  Array.from(read(path).matchAll(/^#+ (.+)$/gm), ([, heading = '']) => anchorOf(heading));

/** Links of a page to files of the repository and to headings in them. */
const linksOf = (path: string) =>
  Array.from(
    read(path)
      .replaceAll(/^```[^]*?^```/gm, '')
      .matchAll(/\]\(([^)\s]+)\)/g),
    ([, target = '']) => target,
  )
    .filter((target) => !/^https?:/.test(target))
    .map((target) => {
      const [file = '', anchor] = target.split('#');
      return { file: file === '' ? path : join(dirname(path), file), anchor };
    });

function isBroken({ file, anchor }: ReturnType<typeof linksOf>[number]) {
  if (!existsSync(file)) return true;
  return (
    anchor !== undefined && (statSync(file).isDirectory() || !anchorsOf(file).includes(anchor))
  );
}

const codeIn = (cell: string) => Array.from(cell.matchAll(/`([^`]+)`/g), ([, text = '']) => text);

describe('the documents', () => {
  it.each(documents)('%s links to files and headings that exist', (path) => {
    expect(linksOf(path).filter(isBroken)).toEqual([]);
  });

  // For contributors: they name files relative to themselves, to src/ or to the repository.
  const guides = documents.filter((path) => /^(src\/.*|tests\/|\.ci\/)README\.md$/.test(path));

  it.each(guides)('%s names files and folders that exist', (path) => {
    const named = codeIn(read(path).replaceAll(/^```[^]*?^```/gm, ''))
      .filter((text) => /^[\w.-]*[\w-](\/[\w.-]+)*(\/|\.(ts|mjs|js|css|json|glsl))$/.test(text))
      .filter((text) => !/^(dist|site)\//.test(text));
    const from = [dirname(path), 'src', '.'];
    expect(named.filter((name) => !from.some((at) => existsSync(join(at, name))))).toEqual([]);
  });

  it('introduce each folder of src, and each extra, in 10 to 30 lines beside the list of extras', () => {
    const extras = EXTRAS.map((name) => `extras/${name}`);
    expect(linksOf('src/extras/README.md').map(({ file }) => dirname(file))).toEqual(
      expect.arrayContaining(extras.map((name) => `src/${name}`)),
    );
    for (const folder of ['phong', 'viewer', 'extras', ...extras]) {
      const isOfAnExtra = (line: string) => /^\| \[\w+\]\(\w+\/README\.md\)/.test(line);
      const text = read(`src/${folder}/README.md`).split('\n');
      const lines = text.filter((line) => !isOfAnExtra(line)).length;
      expect([folder, lines >= 10 && lines <= 30]).toEqual([folder, true]);
    }
  });

  it('list every decision', () => {
    const listed = read('src/decisions/README.md');
    for (const path of decisions.filter((name) => !name.endsWith('README.md'))) {
      expect(listed).toContain(`(${path.replace('src/decisions/', '')})`);
    }
  });

  it('are short: 15,000 words for users, 900 of them in the README', () => {
    const words = (...paths: string[]) => paths.map(read).join('').match(/\S+/g)?.length;
    expect(words('README.md')).toBeLessThanOrEqual(950);
    expect(words('CHANGELOG.md')).toBeLessThanOrEqual(420);
    expect(words('src/README.md')).toBeLessThanOrEqual(2150);
    expect(words(...forUsers)).toBeLessThanOrEqual(15_000);
  });

  it('for users are pages of the guide, each once in its contents', () => {
    const pages = documents.filter((path) => path.startsWith('demo/guide/'));
    expect(guide.map(({ path }) => `demo/${path.slice(0, -1)}.md`).sort()).toEqual(pages.sort());
  });

  it.each(VIEWS)('for users say what the view %s shows', (view) => {
    expect(read('demo/guide/see.md')).toContain(`\`${view}\``);
  });

  it.each(forUsers)('%s links only to files of the package', (path) => {
    const { files } = JSON.parse(read('package.json')) as { readonly files: readonly string[] };
    // npm adds these by itself.
    const shipped = ['README.md', 'LICENSE', ...files].map(
      (pattern) => new RegExp(`^${pattern.replaceAll('.', '\\.').replaceAll('*', '[^/]*')}(/|$)`),
    );
    const isShipped = (file: string) => shipped.some((pattern) => pattern.test(file));
    expect(linksOf(path).filter(({ file }) => !isShipped(file))).toEqual([]);
  });

  it.each(forUsers)('%s has no page that a phone would show as wide as a desk', (path) => {
    expect(read(path)).not.toMatch(/^<!doctype html>\n(?:(?!name="viewport")[^])*?^<\/html>/m);
  });

  it.each(guide)('$path links to pages and places of the site', ({ path }) => {
    const hrefs = Array.from(
      guidePage(markdownOf(path)!, '').html.matchAll(/<a href="([^"]+)"/g),
      ([, href = '']) => href,
    );
    const broken = hrefs
      .filter((href) => !/^https?:/.test(href))
      .filter((href) => {
        const [to = '', id] = href.split('#');
        const page = to === '' ? path : posix.join(path, to);
        if (!pagePaths().includes(page)) return true;
        return id !== undefined && !guidePage(markdownOf(page)!, '').html.includes(`id="${id}"`);
      });
    expect(broken).toEqual([]);
  });

  it('of the shaders names only files, functions and defines that exist', () => {
    const sources = filesOf('shaders/*.glsl');
    const typescript = filesOf(
      'src/phong/material/program/*.ts',
      'src/phong/light/*.ts',
      'src/phong/math/*.ts',
    );
    const text = [
      ...sources,
      ...typescript.map(read),
      ...sources.map(read),
      layoutDefines(),
    ].join();
    const words = new Set(text.match(/\w+/g));
    const named = Array.from(read('shaders/README.md').matchAll(/`([^`]+)`/g), ([, code = '']) =>
      code.replace(/\(.*\)/, ''),
    );
    const unknown = named
      .filter((code) => !existsSync(code))
      .flatMap((code) => code.match(/\w{2,}(?!\w*…)/g) ?? [])
      .filter((word) => !words.has(word));
    expect(unknown).toEqual([]);
    // Bits of the mask are spelled as the shaders do: prose about them goes stale unseen.
    const [paragraph = ''] =
      /\*\*Features\*\*[^]*?(?=\n\n|$)/.exec(read('shaders/README.md')) ?? [];
    const bits = Array.from(paragraph.matchAll(/`FEATURE_\w+`/g));
    expect(bits.length).toBeGreaterThan(3);
  });
});
