// Is an STL file read as written, binary and text: triangles, face normals, names, and colours by
// both conventions?
import { describe, expect, it } from 'vitest';
import { failureOf, type FileContent, heardWarnings, loadFiles, numbersOf } from './model-files.js';

const warnings = heardWarnings();

const TRIANGLE = [0, 0, 0, 1, 0, 0, 0, 1, 0];

interface Facet {
  readonly corners?: readonly number[];
  readonly bits?: number;
}

/** A binary file; its stated normals are all wrong. */
function binary(facets: readonly Facet[], header = '', claimed = facets.length) {
  const bytes = new Uint8Array(84 + 50 * facets.length);
  bytes.set(Uint8Array.from(header, (c) => c.charCodeAt(0)));
  const view = new DataView(bytes.buffer);
  view.setUint32(80, claimed, true);
  facets.forEach(({ corners = TRIANGLE, bits = 0 }, i) => {
    const at = 84 + 50 * i;
    [-1, 0, 0, ...corners].forEach((value, k) => view.setFloat32(at + 4 * k, value, true));
    view.setUint16(at + 48, bits, true);
  });
  return bytes;
}

async function fails(content: FileContent, message: RegExp) {
  const error = await failureOf({ 'a.stl': content });
  expect(error.code).toBe('bad-model');
  expect(error.message).toMatch(message);
}

const facet =
  'facet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n';

const NOT_A_NUMBER = facet.replace('1 0 0', 'nan 0 0');
const TWO_CORNERS = facet.replace('vertex 0 1 0\n', '');
const FOUR_CORNERS = facet.replace('endloop', 'vertex 1 1 1');

describe('a binary STL file', () => {
  it('has the normals of its triangles, whatever the file states', async () => {
    const model = await loadFiles({
      'a.stl': binary([{}, { corners: [0, 0, 0, 0, 2, 0, 0, 0, 2] }]),
    });
    expect(numbersOf(model, 'position')).toEqual([...TRIANGLE, 0, 0, 0, 0, 2, 0, 0, 0, 2]);
    expect(numbersOf(model, 'normal')).toEqual([
      0, 0, 1, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 1, 0, 0,
    ]);
    expect(model.parts[0]).toMatchObject({ sides: 'double', look: { baseColor: [1, 1, 1] } });
    expect(model.parts[0]?.geometry.hasAttribute('color')).toBe(false);
  });

  it.each([
    ['begin with `solid`', binary([{}], 'solid but binary\n facet'), 1],
    [
      'begin as a text does, with bytes after its last triangle',
      new Uint8Array([...binary([{}], 'solid\nfacet normal 0 0 1'), 1, 2]),
      1,
    ],
    ['have bytes after its last triangle', new Uint8Array([...binary([{}]), 1, 2, 3]), 1],
    ['have triangles after a count of 0', binary([{}, {}], '', 0), 2],
  ])('may %s', async (_, bytes, triangles) => {
    expect(numbersOf(await loadFiles({ 'a.stl': bytes }), 'position')).toHaveLength(9 * triangles);
  });

  const BODY = 'made by hand COLOR=\x33\x66\xff\xff';
  const SPACED = 'COLOR=\x7f\x7f\x7f MATERIAL=\x7f\x7f\x7f \x7f\x7f\x7f \x7f\x7f\x7f ';

  const CLEAR = 'COLOR=\xff\xff\xff\x33';

  // Magics: COLOR= for the body, bit 15 clear and red in the low bits of a triangle.
  it.each([
    ['the body', 0x8000, BODY, { baseColor: [0.2, 0.4, 1], opacity: 1 }],
    [
      'the body if all triangles have 0, which would be black',
      0,
      BODY,
      { baseColor: [0.2, 0.4, 1] },
    ],
    ['a translucent body', 0x8000, CLEAR, { opacity: 0.2, alphaMode: 'blend' }],
    [
      'three bytes and a space, which are opaque',
      0x8000,
      SPACED,
      { opacity: 1, alphaMode: 'opaque' },
    ],
  ])('has the colour of %s', async (_, bits, head, look) => {
    const { parts } = await loadFiles({ 'a.stl': binary([{ bits }, { bits }], head) });
    expect(parts[0]?.look).toMatchObject(look);
    expect(parts[0]?.geometry.hasAttribute('color')).toBe(false);
  });

  it.each([
    ['beside the body', BODY, 0x8000, 31 | (5 << 5), [0.2, 0.4, 1, 1, 0.16129, 0]],
    ['beside black ones', BODY, 0, 31, [0, 0, 0, 1, 0, 0]],
    // VisCAM: bit 15 set, blue in the low bits; white without it.
    ['as VisCAM writes them', '', 0, 0xfca1, [1, 1, 1, 1, 0.16129, 0.032258]],
  ])('has colours of triangles %s', async (_, head, first, second, colors) => {
    const model = await loadFiles({ 'a.stl': binary([{ bits: first }, { bits: second }], head) });
    expect(numbersOf(model, 'color').slice(6, 12)).toEqual(colors);
    expect(model.parts[0]?.look.baseColor).toEqual([1, 1, 1]);
  });

  it('is shown without a triangle that is no number, the others with their own colours', async () => {
    const [red, blue] = [0x8000 | (31 << 10), 0x8000 | 31];
    const bad = [NaN, 0, 0, 0, 0, 0, 0, 0, 0];
    const model = await loadFiles({
      'a.stl': binary([{ bits: red }, { corners: bad }, { bits: blue }]),
    });
    expect(numbersOf(model, 'position')).toEqual([...TRIANGLE, ...TRIANGLE]);
    expect(numbersOf(model, 'color').slice(6, 12)).toEqual([1, 0, 0, 0, 0, 1]);
    expect(warnings).toEqual([
      expect.stringContaining('without 1 triangle (a vertex has the coordinate NaN'),
    ]);
  });

  it.each([
    [binary([{}], '', 2), /truncated: 134 of 184 bytes for 2 triangles/],
    [binary([{}], '', 0xffffffff), /truncated/],
    [binary([]), /no triangles/],
    [new Uint8Array(50), /ends inside its header/],
    [binary([{ corners: [NaN, 0, 0, 0, 0, 0, 0, 0, 0] }]), /coordinate NaN/],
  ])('that is broken gives a readable error (%#)', fails);
});

describe('a text STL file', () => {
  const plate = `solid a facet plate\n${facet}endsolid a facet plate\nsolid b\n${facet}endsolid b\n`;
  const words = 'vertex 1 2 3 facet normal';
  it.each([
    [
      'a name, or none',
      `solid left\n${facet}endsolid left\nSOLID\n${facet}ENDSOLID\n`,
      ['left', ''],
    ],
    ['a byte order mark', `\ufeff${plate}`, ['a facet plate', 'b']],
    ['one line', plate.replace(/\s+/g, ' '), ['a facet plate', 'b']],
    [
      'one line and a byte order mark',
      `\ufeff${plate.replace(/\s+/g, ' ')}`,
      ['a facet plate', 'b'],
    ],
    ['comments', `# made by hand\n; 2\n// 3\nsolid a\n${facet}endsolid a\n`, ['a']],
    ['a name made of words of the format', `solid ${words}\n${facet}endsolid ${words}\n`, [words]],
    [
      'upper case',
      `SOLID FACET ENDLOOP\n${facet.toUpperCase()}ENDSOLID FACET ENDLOOP\n`,
      ['FACET ENDLOOP'],
    ],
  ])('with %s has a part for each solid', async (_, text, names) => {
    const model = await loadFiles({ model: text });
    expect(model.parts.map(({ name }) => name)).toEqual(names);
    for (const part of names.keys()) {
      expect(numbersOf(model, 'position', part)).toEqual(TRIANGLE);
      expect(numbersOf(model, 'normal', part)).toEqual([0, 0, 1, 0, 0, 1, 0, 0, 1]);
    }
    expect(warnings).toEqual([]);
  });

  it('is shown without facets that have not three sound vertices', async () => {
    const bad = [NOT_A_NUMBER, TWO_CORNERS, FOUR_CORNERS].join('');
    const model = await loadFiles({ 'a.stl': `solid\n${bad}${facet}endsolid` });
    expect(numbersOf(model, 'position')).toEqual(TRIANGLE);
    expect(warnings).toEqual(['a.stl is shown without 3 triangles ("nan" is not a number).']);
  });

  it.each([
    [`solid\n${TWO_CORNERS}`, /a facet has fewer than three/],
    [`solid\n${FOUR_CORNERS}`, /a facet has more than three/],
    [`solid\n${NOT_A_NUMBER}`, /"nan" is not a number/],
    [`solid\n${facet.slice(0, 60)}`, /truncated/],
    ['solid\nendsolid', /no triangles/],
  ])('that is broken gives a readable error (%#)', fails);
});
