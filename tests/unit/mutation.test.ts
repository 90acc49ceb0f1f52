// Does the list of mutants still speak of this code, and its table of this list? `npm run mutation` makes them.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { describe, expect, it } from 'vitest';
import { ENCODING_GLSL } from '../../src/material/shader-source.js';
import { mutated, MUTANTS, nameOf, UNIT_TESTS } from '../mutation/mutants.mjs';
import { table } from '../mutation/table.mjs';
import { cellChecks } from '../glsl/cell-checks.js';
import { exactChecks } from '../glsl/exact-checks.js';
import { FOOTPRINT_CHECKS } from '../glsl/footprint-checks.js';
import { WHOLE_LOOP_GLSL } from '../glsl/whole-loop.js';
import { CATEGORIES } from '../stress/categories.js';

const repository = fileURLToPath(new URL('../..', import.meta.url));
interface Result {
  readonly name: string;
  readonly file: string;
  readonly removes: string;
  readonly killedBy: string | null;
}

const read = (path: string): string => readFileSync(join(repository, path), 'utf8');

const results = JSON.parse(read('tests/mutation/results.json')) as readonly Result[];

const joined = `${WHOLE_LOOP_GLSL}\n${ENCODING_GLSL}`;

/** Every file of which each guard has to have its mutant. */
const FILES = [
  ...['attenuation', 'diffuse_lobe', 'footprint', 'guard', 'light_loop', 'nearest_code', 'power'],
  ...[
    'averaged_blinn_phong',
    'averaged_phong',
    'cell_list',
    'specular_blinn_phong',
    'specular_phong',
    'spot',
    'srgb',
    'surface_color',
  ],
].map((chunk) => `shaders/${chunk}.glsl`);

describe('the mutants', () => {
  it.each(MUTANTS.map((mutant) => [nameOf(mutant), mutant] as const))('%s', (_, mutant) => {
    expect(mutated(read(mutant.file), mutant)).not.toBe(read(mutant.file));
    // GLSL is edited in the joined text.
    if (mutant.file.endsWith('.glsl')) expect(joined.split(mutant.from)).toHaveLength(2);
  });

  it('have names of their own', () => {
    expect(new Set(MUTANTS.map(nameOf)).size).toBe(MUTANTS.length);
  });

  it('are of every chunk of the loop, and of every file that has unit tests for them', () => {
    expect(new Set(MUTANTS.map(({ file }) => file))).toStrictEqual(
      new Set([...FILES, ...Object.keys(UNIT_TESTS)]),
    );
  });
});

describe('the results of the last run', () => {
  it('are of exactly these mutants, and none lived', () => {
    expect(results.map(({ name }) => name)).toStrictEqual(MUTANTS.map(nameOf).sort());
    expect(results.filter(({ killedBy }) => killedBy === null)).toStrictEqual([]);
  });

  it('name tests that are there', () => {
    const titles = CATEGORIES.map(({ title }) => title);
    for (const { killedBy } of results) {
      const [suite = '', test = ''] = (killedBy ?? '').split(' › ');
      if (suite === 'stress') {
        const [sentence] = test.split(/: (?=not finite|inexact|error)/);
        expect([...titles, 'all together', ...chunkTitles()]).toContain(sentence);
      } else {
        expect(() => read(suite)).not.toThrow();
      }
    }
  });

  it('are what the table shows', () => {
    expect(read('tests/mutation/TABLE.md')).toBe(table(results));
  });
});

/** Of tests/glsl, which only a browser can load. */
const chunkTitles = (): string[] => [
  ...[...read('tests/glsl/chunk-checks.ts').matchAll(/title:\s+'([^']+)'/g)].map((match) => match[1]!),
  ...[...exactChecks(), ...cellChecks(), ...FOOTPRINT_CHECKS].map(({ title }) => title),
];
