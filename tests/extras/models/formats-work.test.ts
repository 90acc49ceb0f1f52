// Does reading a text format let other tasks run after a bounded amount of work, whatever the file
// is made of: one line, one list, one polygon, one vertex, one word? Its pauses
// count the slices.
import { expect, it } from 'vitest';
import { countedPauses, heardWarnings, loadFiles, type FileContent } from './model-files.js';

heardWarnings();

const pauses = countedPauses();

type Files = Readonly<Record<string, FileContent>>;

const MANY = 2 ** 18;
const QUAD = 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n';
const SOUND = `${QUAD}f 1 2 3 4\n`;
const obj = (text: string): Files => ({ 'a.obj': text });
const withMtl = (mtl: FileContent): Files => ({ 'a.obj': `mtllib a.mtl\n${SOUND}`, 'a.mtl': mtl });

const VERTICES = ['element vertex 4', 'property float x', 'property float y', 'property float z'];
const FACES = ['element face 1', 'property list uint int vertex_indices'];
const SQUARE = '0 0 0\n1 0 0\n1 1 0\n0 1 0\n';
const SKIPPED = ['element x 1', 'property list uint int y'];
const ply = (body: string, lines: readonly string[] = [...VERTICES, ...FACES]): Files => ({
  'a.ply': ['ply', 'format ascii 1.0', ...lines, 'end_header', body].join('\n'),
});

/** Comments of `#` without an end. */
const utf16 = Uint8Array.from(
  { length: 8 * MANY },
  (_, i) => [0xff, 0xfe][i] ?? (i % 2 === 0 ? 35 : 0),
);

/** 255 triangles at each of 64 vertices. */
const FANS = Array.from(
  { length: 85 * 64 },
  (_, i) => `3 ${i % 64} ${(i + 1 + (i % 7)) % 64} ${(i + 9) % 64}\n`,
);
const POINTS = Array.from(
  { length: 64 },
  (_, i) => `${Math.sin(i)} ${Math.cos(3 * i)} ${Math.sin(5 * i)}\n`,
);
const HEAD_OF_FANS = [
  `element vertex 64`,
  ...VERTICES.slice(1),
  `element face ${FANS.length}`,
  FACES[1]!,
];

const FACET =
  'facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n';
const NAMES = `solid ${'facet normal '.repeat(100)}\nendsolid\n`.repeat(MANY / 1300);

it.each<[what: string, files: Files]>([
  ['an OBJ comment', obj(`# ${'x'.repeat(MANY)}\n${SOUND}`)],
  ['empty lines', obj(`${QUAD}${'\n'.repeat(MANY)}f 1 2 3 4`)],
  ['blanks in a line', obj(`${SOUND}f 1 2${' '.repeat(MANY)}3`)],
  ['a word', obj(`${SOUND}v ${'1'.repeat(MANY)} 2 3`)],
  ['statements of MTL', withMtl('newmtl m\n' + 'Kd 1 1 1\n'.repeat(MANY / 9))],
  ['a line of MTL', withMtl(`newmtl m\nmap_Kd ${'x'.repeat(MANY)}`)],
  ['MTL in UTF-16', withMtl(utf16)],
  ['a polygon of PLY', ply(`${SQUARE}${MANY / 2} ${'0 1 2 3 '.repeat(MANY / 8)}`)],
  [
    'a list that is skipped',
    ply(`${MANY / 2} ${'1 '.repeat(MANY / 2)}\n${SQUARE}4 0 1 2 3`, [
      ...SKIPPED,
      ...VERTICES,
      ...FACES,
    ]),
  ],
  [
    'a header of PLY',
    ply(`${SQUARE}4 0 1 2 3`, [...Array<string>(MANY / 8).fill('x'), ...VERTICES, ...FACES]),
  ],
  ['comments of PLY', ply(`${'comment\n'.repeat(MANY / 8)}${SQUARE}4 0 1 2 3`)],
  ['corners around a vertex', ply(POINTS.join('') + FANS.join(''), HEAD_OF_FANS)],
  ['names of STL', { 'a.stl': `${NAMES}solid a\n${FACET}endsolid` }],
])('other tasks can run while a file is read made of %s', async (_, files) => {
  expect((await loadFiles(files)).parts.length).toBeGreaterThan(0);
  expect(pauses.count).toBeGreaterThanOrEqual(8);
});
