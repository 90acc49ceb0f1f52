// Can the documents be followed? Their links lead to files and headings that exist, and the README stays short.

import { existsSync, readdirSync, readFileSync, statSync } from 'node:fs';
import { dirname, join, relative } from 'node:path';
import { fileURLToPath } from 'node:url';
import { describe, expect, it } from 'vitest';

const repository = fileURLToPath(new URL('../..', import.meta.url));
const decisions = readdirSync(join(repository, 'src/decisions')).map((name) => `src/decisions/${name}`);
const documents = [
  'README.md',
  'CHANGELOG.md',
  'shaders/README.md',
  'src/README.md',
  'src/CORE.md',
  ...decisions,
];

const read = (path: string): string => readFileSync(join(repository, path), 'utf8');

/** Anchors of a page's headings, as GitHub makes them. */
const anchorsOf = (path: string): readonly string[] =>
  Array.from(read(path).matchAll(/^#+ (.+)$/gm), ([, heading = '']) =>
    heading
      .toLowerCase()
      .replaceAll(/[^\p{L}\p{N} _-]/gu, '')
      .replaceAll(' ', '-'),
  );

/** Links of a page that lead nowhere. */
function brokenLinks(path: string): readonly string[] {
  const text = read(path).replaceAll(/^```[^]*?^```/gm, '');
  return Array.from(text.matchAll(/\]\(([^)\s]+)\)/g), ([, target = '']) => target)
    .filter((target) => !/^https?:/.test(target))
    .filter((target) => {
      const [file = '', anchor] = target.split('#');
      const found = file === '' ? join(repository, path) : join(repository, dirname(path), file);
      if (!existsSync(found)) return true;
      if (anchor === undefined) return false;
      return statSync(found).isDirectory() || !anchorsOf(relative(repository, found)).includes(anchor);
    });
}

describe('the documents', () => {
  it.each(documents)('%s links to files and headings that exist', (path) => {
    expect(brokenLinks(path)).toEqual([]);
  });

  it('list every decision', () => {
    const listed = read('src/decisions/README.md');
    for (const path of decisions.filter((name) => !name.endsWith('README.md')))
      expect(listed).toContain(`(${path.replace('src/decisions/', '')})`);
  });

  it('begin with a README of at most 350 lines', () => {
    expect(read('README.md').split('\n').length).toBeLessThanOrEqual(350);
  });
});
