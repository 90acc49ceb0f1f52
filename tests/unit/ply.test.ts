// Is a PLY file read as written, as text and in both byte orders: vertices, normals, colours, polygons and strips?
import { describe, expect, it } from 'vitest';
import { cornersOf, failureOf, heardWarnings, indexOf, loadFiles, numbersOf } from './model-files.js';

const header = (...lines: readonly string[]): string => ['ply', 'format ascii 1.0', ...lines, 'end_header\n'].join('\n'); // prettier-ignore
const xyz = ['property float x', 'property float y', 'property float z'];
const faces = (count: number): string[] => [
  `element face ${count}`,
  'property list uchar int vertex_indices',
];
const SQUARE = '0 0 0\n1 0 0\n1 1 0\n0 1 0\n';

/** The same square with normals, byte colours and a scalar before them, in a byte order and with these line ends. */
function binary(little: boolean, lineEnd: string): Uint8Array<ArrayBuffer> {
  const text = [
    'ply',
    `format binary_${little ? 'little' : 'big'}_endian 1.0`,
    'comment a square',
    'element vertex 4',
    'property uchar quality',
    'property double x',
    'property float y',
    'property short z',
    'property float nx',
    'property float ny',
    'property float nz',
    'property uchar red',
    'property uchar green',
    'property ushort blue',
    'element face 1',
    'property uint8 flags',
    'property list uint8 uint16 vertex_index',
    'end_header',
    '',
  ].join(lineEnd);
  const bytes = new Uint8Array(text.length + 4 * 31 + 10);
  bytes.set(new TextEncoder().encode(text));
  const view = new DataView(bytes.buffer);
  let at = text.length;
  [[0, 0], [1, 0], [1, 1], [0, 1]].forEach(([x = 0, y = 0]) => {
    view.setUint8(at, 10); // also a line feed, right after the header
    view.setFloat64(at + 1, x, little);
    view.setFloat32(at + 9, y, little);
    view.setInt16(at + 13, -3, little);
    view.setFloat32(at + 15, 0, little);
    view.setFloat32(at + 19, 3, little);
    view.setFloat32(at + 23, 4, little);
    view.setUint8(at + 27, 51);
    view.setUint8(at + 28, 255);
    view.setUint16(at + 29, 13107, little);
    at += 31;
  }); // prettier-ignore
  view.setUint8(at, 7);
  view.setUint8(at + 1, 4);
  [0, 1, 2, 3].forEach((vertex, i) => view.setUint16(at + 2 + 2 * i, vertex, little));
  return bytes;
}

const warnings = heardWarnings();

describe('a PLY file', () => {
  it.each([
    [true, '\n'],
    [true, '\r\n'],
    [true, '\r'],
    [false, '\n'],
    [false, '\r'],
  ])('is read in binary, little endian %s, lines ended by %j', async (little, lineEnd) => {
    const model = await loadFiles({ 'a.ply': binary(little, lineEnd) });
    expect(numbersOf(model, 'position')).toEqual([0, 0, -3, 1, 0, -3, 1, 1, -3, 0, 1, -3]);
    expect(numbersOf(model, 'normal').slice(0, 3)).toEqual([0, 0.6, 0.8]);
    expect(numbersOf(model, 'color').slice(9)).toEqual([0.2, 1, 0.2]);
    expect(indexOf(model)).toEqual([0, 1, 2, 0, 2, 3]);
    expect(model.parts[0]).toMatchObject({ sides: 'double', look: { alphaMode: 'opaque', map: null } });
  });

  it('is read as text, with polygons, float colours and lists that are skipped', async () => {
    const text =
      header(
        'element face 2',
        'property list uchar float texcoord',
        'property list uchar int vertex_indices',
        'element vertex 4',
        ...xyz,
        'property float red',
        'property float green',
        'property float blue',
      ) + '2 9 9 3 0 1 2\n0 3 0 2 3\n0 0 0 1 0 0\n1 0 0 0 0.5 0\n1 1 0 0 0 7\n0 1 0 0 0 0\n';
    const model = await loadFiles({ 'a.ply': text });
    expect(indexOf(model)).toEqual([0, 1, 2, 0, 2, 3]);
    expect(cornersOf(model, 'color').slice(0, 3)).toEqual([[1, 0, 0], [0, 0.5, 0], [0, 0, 1]]); // prettier-ignore
  });

  it('without normals is smooth, with edges where faces meet at a sharp angle', async () => {
    const cube =
      header('element vertex 8', ...xyz, ...faces(6)) +
      '0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n' +
      '4 3 2 1 0\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n';
    const edged = await loadFiles({ 'a.ply': cube });
    expect(edged.parts[0]?.geometry.getAttribute('position').count).toBe(24);
    expect(cornersOf(edged, 'normal').slice(0, 3)).toEqual([[0, 0, -1], [0, 0, -1], [0, 0, -1]]); // prettier-ignore
    const ridge = header('element vertex 4', ...xyz, ...faces(2)) + '0 0 0\n1 0 0\n0 1 0\n-1 0 -0.2\n3 0 1 2\n3 0 2 3\n'; // prettier-ignore
    expect((await loadFiles({ 'a.ply': ridge })).parts[0]?.geometry.getAttribute('position').count).toBe(4);
  });

  it('may have strips of triangles, every second one reversed', async () => {
    const text = header('element vertex 4', ...xyz, 'element tristrips 1', 'property list int int vertex_indices') + `${SQUARE}8 0 1 3 2 -1 0 1 2`; // prettier-ignore
    expect(indexOf(await loadFiles({ 'a.ply': text }))).toEqual([0, 1, 2, 2, 1, 3, 0, 1, 3]);
  });

  const rgb = (type: string): string[] =>
    ['red', 'green', 'blue', 'alpha'].map((name) => `property ${type} ${name}`);
  const RED = [1, 0, 0];
  const BLUE = [0, 0, 1];

  it.each([
    ['bytes before the corners', rgb('uchar').slice(0, 3), [], '255 0 0 3 0 1 2\n0 0 255 3 0 2 3\n'],
    ['floats behind them, with an alpha', [], rgb('float'), '3 0 1 2 1 0 0 1\n3 0 2 3 0 0 1 1\n'],
  ])('has the colours of its faces: %s', async (_, before, behind, rows) => {
    const list = 'property list uchar int vertex_indices';
    const text =
      header('element vertex 4', ...xyz, 'element face 2', ...before, list, ...behind) + SQUARE + rows;
    const model = await loadFiles({ 'a.ply': text });
    expect(cornersOf(model, 'color')).toEqual([RED, RED, RED, BLUE, BLUE, BLUE]);
    expect(warnings).toEqual([]);
  });

  it.each([
    [
      'its faces where its vertices have all the same',
      '9 9 9',
      [RED, RED, RED, BLUE, BLUE, BLUE],
      /without the colours of its vertices/,
    ],
    [
      'its vertices where they differ',
      '0 0 255',
      [
        [0, 0, 1],
        [0, 0, 1],
        [0.035294, 0.035294, 0.035294],
      ],
      /without the colours of its faces/,
    ],
  ])('has the colours of %s', async (_, first, colors, warning) => {
    // prettier-ignore
    const vertices = `0 0 0 ${first}\n1 0 0 ${first}\n1 1 0 9 9 9\n0 1 0 9 9 9\n`;
    const text = header('element vertex 4', ...xyz, ...rgb('uchar').slice(0, 3), ...faces(2), ...rgb('uchar').slice(0, 3)) + `${vertices}3 0 1 2 255 0 0\n3 0 2 3 0 0 255\n`; // prettier-ignore
    expect(cornersOf(await loadFiles({ 'a.ply': text }), 'color').slice(0, colors.length)).toEqual(colors);
    expect(warnings).toHaveLength(1);
    expect(warnings[0]).toMatch(warning);
  });

  const normals = ['property float nx', 'property float ny', 'property float nz'];
  it.each(['0 0 0', 'nan nan nan', '0 0 1'])(
    'has normals on the side of its faces where the file has %s',
    async (n) => {
      const vertices = SQUARE.replaceAll('\n', ` ${n}\n`);
      const turned = n === '0 0 1';
      const text = header('element vertex 4', ...xyz, ...normals, ...faces(1)) + `${vertices}4 ${turned ? '3 2 1 0' : '0 1 2 3'}\n`; // prettier-ignore
      const model = await loadFiles({ 'a.ply': text });
      expect(numbersOf(model, 'normal')).toEqual([0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1]);
      const [[ax = 0, ay = 0] = [], [bx = 0, by = 0] = [], [cx = 0, cy = 0] = []] = cornersOf(
        model,
        'position',
      );
      expect((bx - ax) * (cy - ay) - (by - ay) * (cx - ax)).toBe(1);
    },
  );

  const five = header('element vertex 5', ...xyz, ...faces(2));
  it.each([
    [
      'a vertex that is no number and no face uses',
      `${five}nan 0 0\n${SQUARE}3 1 2 3\n3 1 3 4`,
      /1 vertex \("nan" is not a number\)/,
    ],
    [
      'a face that uses it',
      `${five}${SQUARE}1 1e99 1\n4 0 1 2 3\n3 0 1 4`,
      /1 vertex \(.*1e\+99.*\), 1 face/,
    ],
    [
      'faces whose vertex is missing',
      `${header('element vertex 4', ...xyz, ...faces(3))}${SQUARE}4 0 1 2 3\n4 0 1 2 -1\n3 0 1 4`,
      /2 faces \(a face refers to the vertex -1\)/,
    ],
    [
      'values that its header does not name',
      `${header('element vertex 4', ...xyz, ...faces(1))}${SQUARE}4 0 1 2 3 6 0.5 1 1\n`,
      /1 line with more values/,
    ],
    [
      'a texture',
      header('comment TextureFile a.png', 'element vertex 4', ...xyz, ...faces(1)) + `${SQUARE}4 0 1 2 3`,
      /TextureFile/,
    ],
    [
      'a comment, without a word',
      `${header('element vertex 4', ...xyz, ...faces(1))}comment a\n${SQUARE}# b\n4 0 1 2 3`,
      null,
    ],
  ])('is shown without %s', async (_, text, warning) => {
    // prettier-ignore
    const model = await loadFiles({ 'a.ply': text });
    expect(indexOf(model)).toEqual([0, 1, 2, 0, 2, 3]);
    expect(warnings).toHaveLength(warning === null ? 0 : 1);
    if (warning !== null) expect(warnings[0]).toMatch(warning);
  });

  it.each([
    ['rows in several lines', '0 0\n0 1 0 0 1 1\n0 0 1 0\n4\n0 1\n2 3'],
    ['all rows in one line', '0 0 0 1 0 0 1 1 0 0 1 0 4 0 1 2 3'],
    ['two rows in a line', '0 0 0 1 0 0\n1 1 0 0 1 0\n4 0 1 2 3'],
  ])('may have %s', async (_, rows) => {
    const model = await loadFiles({ 'a.ply': header('element vertex 4', ...xyz, ...faces(1)) + rows });
    expect(indexOf(model)).toEqual([0, 1, 2, 0, 2, 3]);
    expect(warnings).toEqual([]);
  });

  it.each([
    [
      header('element vertex 4', ...xyz) + SQUARE,
      /cloud of 4 points without faces. Only surfaces can be lit/,
    ],
    [header('element vertex 4', ...xyz, ...faces(0)) + SQUARE, /cloud of 4 points/],
    [header('element vertex 0', ...xyz, ...faces(1)) + '3 0 0 0', /no vertices/],
    [header('element vertex 4', ...xyz, ...faces(1)) + `${SQUARE}2 0 1 `, /no triangles/],
    [header('element vertex 4', ...xyz, ...faces(1)) + `${SQUARE}3 0 1 4`, /vertex 4 of 4/],
    [header('element vertex 4', ...xyz, ...faces(1)) + `${SQUARE}3 0 1 -1`, /refers to the vertex -1/],
    [
      header('element vertex 4', ...xyz, ...faces(1)) + `${SQUARE}3 0 1`,
      /truncated: it ends before its last value/,
    ],
    [header('element vertex 4', ...xyz, ...faces(1)) + `${SQUARE}x 0 1 2`, /"x" is not a number/],
    [header('element vertex 4000000000', ...xyz, ...faces(1)) + SQUARE, /truncated: its header announces/],
    [header('element vertex 4', 'property float x', ...faces(1)) + '0 0 0 0 3 0 1 2', /no x, y and z/],
    [header('element vertex 1', ...xyz, ...faces(1)) + '0 inf 0\n3 0 0 0', /"inf" is not a number/],
    [header('element vertex four', ...xyz), /line 3: an element has no count/],
    [header('property float x'), /line 3: a property comes before any element/],
    [header('element vertex 1', 'property constructor x'), /line 4: the type constructor is unknown/],
    ['ply\nformat binary 1.0\nend_header\n', /line 2: the format binary is unknown/],
    ['ply\nend_header\n', /no format/],
    ['ply\nformat ascii 1.0\nelement vertex 1\n', /no end/],
    [header(...Array.from({ length: 1001 }, () => 'element x 0')), /more than 1000 lines/],
  ])('that is broken gives a readable error: %j', async (text, message) => {
    const error = await failureOf({ 'a.ply': text });
    expect(error.code).toBe('bad-model');
    expect(error.message).toMatch(message);
  });
});
