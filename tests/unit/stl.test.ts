// Is an STL file read as written, binary and text: triangles, face normals, names, and colours by both conventions?
import { describe, expect, it } from 'vitest';
import { failureOf, heardWarnings, loadFiles, numbersOf } from './model-files.js';

const warnings = heardWarnings();

const TRIANGLE = [0, 0, 0, 1, 0, 0, 0, 1, 0];

interface Facet {
  readonly corners?: readonly number[];
  readonly bits?: number;
}

/** A binary file; its stated normals are all wrong. */
function binary(facets: readonly Facet[], header = '', claimed = facets.length): Uint8Array<ArrayBuffer> {
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

const facet = 'facet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n';

describe('a binary STL file', () => {
  it('has the normals of its triangles, whatever the file states', async () => {
    const model = await loadFiles({ 'a.stl': binary([{}, { corners: [0, 0, 0, 0, 2, 0, 0, 0, 2] }]) });
    expect(numbersOf(model, 'position')).toEqual([...TRIANGLE, 0, 0, 0, 0, 2, 0, 0, 0, 2]);
    expect(numbersOf(model, 'normal')).toEqual([0, 0, 1, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 1, 0, 0]);
    expect(model.parts[0]).toMatchObject({ sides: 'double', look: { baseColor: [1, 1, 1] } });
    expect(model.parts[0]?.geometry.hasAttribute('color')).toBe(false);
  });

  it('may begin with `solid`, and may have bytes after its last triangle', async () => {
    const bytes = binary([{}], 'solid but binary\n facet');
    expect((await loadFiles({ 'a.stl': bytes })).parts).toHaveLength(1);
    const longer = new Uint8Array([...binary([{}]), 1, 2, 3]);
    expect((await loadFiles({ 'a.stl': longer })).parts).toHaveLength(1);
  });

  it('has colours as VisCAM writes them: bit 15 set, blue in the low bits; white without it', async () => {
    const model = await loadFiles({ 'a.stl': binary([{}, { bits: 0x8000 | (31 << 10) | (5 << 5) | 1 }]) });
    const colors = numbersOf(model, 'color');
    expect(colors.slice(0, 9)).toEqual([1, 1, 1, 1, 1, 1, 1, 1, 1]);
    expect(colors.slice(15, 18)).toEqual([1, 0.16129, 0.032258]);
  });

  it('has colours as Magics writes them: COLOR= for the body, bit 15 clear and red in the low bits', async () => {
    const header = 'made by hand COLOR=\x33\x66\xff\xff';
    const body = await loadFiles({ 'a.stl': binary([{ bits: 0x8000 }], header) });
    expect(body.parts[0]?.look).toMatchObject({ baseColor: [0.2, 0.4, 1], opacity: 1 });
    expect(body.parts[0]?.geometry.hasAttribute('color')).toBe(false);
    const mixed = await loadFiles({ 'a.stl': binary([{ bits: 0x8000 }, { bits: 31 | (5 << 5) }], header) });
    expect(numbersOf(mixed, 'color').slice(6, 12)).toEqual([0.2, 0.4, 1, 1, 0.16129, 0]);
    expect(mixed.parts[0]?.look.baseColor).toEqual([1, 1, 1]);
  });

  it('has the colour of the body if every triangle has 0, which would be black', async () => {
    const model = await loadFiles({ 'a.stl': binary([{}, {}], 'COLOR=\x33\x66\xff\xff') });
    expect(model.parts[0]?.look).toMatchObject({ baseColor: [0.2, 0.4, 1], opacity: 1 });
    expect(model.parts[0]?.geometry.hasAttribute('color')).toBe(false);
    const black = await loadFiles({ 'a.stl': binary([{}, { bits: 31 }], 'COLOR=\x33\x66\xff\xff') });
    expect(numbersOf(black, 'color').slice(6, 12)).toEqual([0, 0, 0, 1, 0, 0]);
  });

  it('is opaque if a space follows three bytes of colour: COLOR=rgb MATERIAL=', async () => {
    const header = 'COLOR=\x7f\x7f\x7f MATERIAL=\x7f\x7f\x7f \x7f\x7f\x7f \x7f\x7f\x7f ';
    const model = await loadFiles({ 'a.stl': binary([{ bits: 0x8000 }], header) });
    expect(model.parts[0]?.look).toMatchObject({ opacity: 1, alphaMode: 'opaque' });
  });

  it('can be translucent as a whole', async () => {
    const model = await loadFiles({ 'a.stl': binary([{ bits: 0x8000 }], 'COLOR=\xff\xff\xff\x33') });
    expect(model.parts[0]?.look).toMatchObject({ opacity: 0.2, alphaMode: 'blend' });
  });

  it('is shown without a triangle that is no number, the others with their own colours', async () => {
    const [red, blue] = [0x8000 | (31 << 10), 0x8000 | 31];
    const bad = [NaN, 0, 0, 0, 0, 0, 0, 0, 0];
    const model = await loadFiles({ 'a.stl': binary([{ bits: red }, { corners: bad }, { bits: blue }]) });
    expect(numbersOf(model, 'position')).toEqual([...TRIANGLE, ...TRIANGLE]);
    expect(numbersOf(model, 'color').slice(6, 12)).toEqual([1, 0, 0, 0, 0, 1]);
    expect(warnings).toHaveLength(1);
    expect(warnings[0]).toMatch(/without 1 triangle \(a vertex has the coordinate NaN/);
  });

  it('has all triangles that follow a count of 0', async () => {
    expect(numbersOf(await loadFiles({ 'a.stl': binary([{}, {}], '', 0) }), 'position')).toHaveLength(18);
  });

  it.each([
    [binary([{}], '', 2), 'bad-model', /truncated: 134 of 184 bytes for 2 triangles/],
    [binary([{}], '', 0xffffffff), 'bad-model', /truncated/],
    [binary([]), 'bad-model', /no triangles/],
    [new Uint8Array(50), 'bad-model', /ends inside its header/],
    [binary([{ corners: [NaN, 0, 0, 0, 0, 0, 0, 0, 0] }]), 'bad-model', /coordinate NaN/],
  ])('that is broken gives a readable error', async (bytes, code, message) => {
    const error = await failureOf({ 'a.stl': bytes });
    expect(error.code).toBe(code);
    expect(error.message).toMatch(message);
  });
});

describe('a text STL file', () => {
  it('has one part per solid, with its name', async () => {
    const text = `solid left wing\n${facet}endsolid left wing\nSOLID\n${facet.toUpperCase()}ENDSOLID\n`;
    const model = await loadFiles({ 'a.stl': text });
    expect(model.parts.map(({ name }) => name)).toEqual(['left wing', '']);
    expect(numbersOf(model, 'position', 1)).toEqual(TRIANGLE);
    expect(numbersOf(model, 'normal', 1)).toEqual([0, 0, 1, 0, 0, 1, 0, 0, 1]);
  });

  it('can begin with a byte order mark, and stand on one line', async () => {
    const lines = `solid a facet plate\n${facet}endsolid a facet plate\nsolid b\n${facet}endsolid b\n`;
    for (const text of [
      `\ufeff${lines}`,
      lines.replace(/\s+/g, ' '),
      `\ufeff${lines.replace(/\s+/g, ' ')}`,
    ]) {
      const model = await loadFiles({ model: text });
      expect(model.parts.map(({ name }) => name)).toEqual(['a facet plate', 'b']);
      expect(numbersOf(model, 'position', 1)).toEqual(TRIANGLE);
    }
  });

  it.each([
    ['comments', `# made by hand\n; 2\n// 3\nsolid a\n${facet}endsolid a\n`, 'a'],
    [
      'a name made of words of the format',
      `solid vertex 1 2 3 facet normal\n${facet}endsolid vertex 1 2 3 facet normal\n`,
      'vertex 1 2 3 facet normal',
    ],
    [
      'such a name, in upper case',
      `SOLID FACET ENDLOOP\n${facet.toUpperCase()}ENDSOLID FACET ENDLOOP\n`,
      'FACET ENDLOOP',
    ],
  ])('can begin with %s', async (_, text, name) => {
    // prettier-ignore
    const model = await loadFiles({ 'a.stl': text });
    expect(model.parts.map((part) => part.name)).toEqual([name]);
    expect(numbersOf(model, 'position')).toEqual(TRIANGLE);
    expect(warnings).toEqual([]);
  });

  it('is shown without facets that have not three sound vertices', async () => {
    const bad = [['1 0 0', 'nan 0 0'], ['vertex 0 1 0\n', ''], ['endloop', 'vertex 1 1 1']].map(([from = '', to = '']) => facet.replace(from, to)); // prettier-ignore
    const model = await loadFiles({ 'a.stl': `solid\n${bad.join('')}${facet}endsolid` });
    expect(numbersOf(model, 'position')).toEqual(TRIANGLE);
    expect(warnings).toEqual(['a.stl is shown without 3 triangles (line 5: "nan" is not a number).']);
  });

  it.each([
    [`solid\n${facet.replace('vertex 0 1 0\n', '')}`, /line 7: a facet has fewer than three/],
    [`solid\n${facet.replace('endloop', 'vertex 1 1 1')}`, /line 7: a facet has more than three/],
    [`solid\n${facet.replace('1 0 0', '1 zero 0')}`, /line 5: "zero" is not a number/],
    [`solid\n${facet.slice(0, 60)}`, /truncated/],
    ['solid\nendsolid', /no triangles/],
  ])('is an error for an author to understand: %j', async (text, message) => {
    const error = await failureOf({ 'a.stl': text });
    expect(error.code).toBe('bad-model');
    expect(error.message).toMatch(message);
  });
});
