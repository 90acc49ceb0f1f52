// What do extras take of the viewer, and can they be taken out?

import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import { VIEWER_ROWS } from '../../src/extras/panel/viewer-rows.js';
import { VIEWER_FIELDS } from '../../src/viewer/element/fields/viewer-fields.js';
import { panelRows } from '../../src/viewer/element/panel-rows.js';
import { brokenImports, TABLE, typeErrors, withDependents } from '../support/without-extra.js';
import { EXTRAS } from '../../.ci/layers.mjs';
import { repository } from '../support/repository.mjs';

/** What extras may import of the viewer. Fewer is better: a name that goes takes this number down. */
const MOST_NAMES = 39;

describe('the door of extras', () => {
  const door = readFileSync(join(repository, 'src/viewer/extra.ts'), 'utf8');
  // The last word of each item.
  const names = [...door.matchAll(/export (?:type )?\{([^}]*)\}/g)].flatMap(
    ([, list = '']) => list.match(/\w+(?=\s*(?:,|$))/g) ?? [],
  );

  it(`has at most ${MOST_NAMES} names, types too`, () => {
    expect(door, 'no namespaces').not.toMatch(/export \*/);
    expect(names.length).toBeLessThanOrEqual(MOST_NAMES);
  });

  it('has none that no extra imports', () => {
    const files = readdirSync(join(repository, 'src/extras'), { recursive: true }) as string[];
    const code = files
      .filter((file) => file.endsWith('.ts'))
      .map((file) => readFileSync(join(repository, 'src/extras', file), 'utf8'))
      .join('\n');
    const imported = code
      .match(/import (?:type )?\{[^}]*\} from '[^']*viewer\/extra\.js'/g)!
      .join();
    const unused = names.filter((name) => !new RegExp(`\\b${name}\\b`).test(imported));
    expect(unused).toEqual([]);
  });
});

it('every value of the viewer has a row in the panel, is said to have none, or an extra brings one', async () => {
  const astray = Object.entries(VIEWER_ROWS).filter(([, row]) => row && !row.folder);
  expect(astray, 'rows in no folder, which the panel would not show').toEqual([]);
  const left = Object.keys(VIEWER_FIELDS).filter((key) => !Object.hasOwn(VIEWER_ROWS, key));
  const brought = await Promise.all(panelRows.map((load) => load()));
  const row = () => ({ add: () => undefined });
  const kit = { flag: row, flags: row, oneOf: row, oneName: row };
  expect(brought.flatMap(({ rows }) => Object.keys(rows(kit))).sort()).toEqual(left.sort());
});

describe('an extra', () => {
  it('goes with those that depend on it', () => {
    expect(withDependents('explain')).toContain('probe');
    expect([...withDependents('panel')]).toEqual(['panel']);
  });

  it.each(EXTRAS)('%s is imported by nothing that is left without it', (name) => {
    expect(brokenImports(withDependents(name))).toEqual([]);
  });

  // Of all files, and of each extra alone: tests/release/extras.test.ts.
  it('and another one can be left out of the table, which compiles', { timeout: 120_000 }, () => {
    const gone = new Set([...withDependents('panel'), ...withDependents('explain')]);
    expect(typeErrors(gone, TABLE)).toEqual([]);
  });
});
