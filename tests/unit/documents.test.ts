// Can the documents be followed? Their links lead to files and headings that exist, and the README stays short.

import { existsSync, readdirSync, readFileSync, statSync } from 'node:fs';
import { dirname, join, relative } from 'node:path';
import { fileURLToPath } from 'node:url';
import { describe, expect, it } from 'vitest';
import { VIEWER_FIELDS } from '../../src/element/fields/viewer-fields.js';
import { LIGHT_FIELDS } from '../../src/light/light-state.js';
import { MESH_FIELDS } from '../../src/scene/mesh/mesh-fields.js';

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

/** First cells of the rows of the README's table under a heading: the names between backticks. */
function namesUnder(heading: string): readonly string[] {
  const section = read('README.md').split(`\n### \`<${heading}>\`\n`)[1]?.split('\n#')[0] ?? '';
  return Array.from(section.matchAll(/^\| (`[^|]+`) \|/gm)).flatMap(([, cell = '']) =>
    Array.from(cell.matchAll(/`([^`]+)`/g), ([, name = '']) => name),
  );
}

const attribute = (property: string): string =>
  property === 'crossOrigin' ? 'crossorigin' : property.replaceAll(/[A-Z]/g, (c) => `-${c.toLowerCase()}`);

describe('the documents', () => {
  it.each([
    ['phong-light', LIGHT_FIELDS],
    ['phong-mesh', MESH_FIELDS],
    ['phong-viewer', VIEWER_FIELDS],
  ])('list every attribute of <%s> in the README, and no other', (element, fields) => {
    expect([...namesUnder(element)].sort()).toEqual(Object.keys(fields).map(attribute).sort());
  });

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
