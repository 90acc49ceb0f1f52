// Is a PLY file read as written, as text and in both byte orders: vertices, normals, colours,
// polygons and strips?
import { describe, expect, it } from 'vitest';
import { cross, subtract, type Vec3 } from '../../../src/phong/math/vector.js';
import {
  cornersOf,
  failureOf,
  heardWarnings,
  indexOf,
  loadFiles,
  numbersOf,
} from './model-files.js';

const header = (...lines: readonly string[]) =>
  ['ply', 'format ascii 1.0', ...lines, 'end_header\n'].join('\n');
const axes = (prefix: string) => ['x', 'y', 'z'].map((axis) => `property float ${prefix}${axis}`);
const xyz = axes('');
const list = 'property list uchar int vertex_indices';
/** A header of this many vertices and faces, which may have colours. */
const mesh = (
  vertices: number | string,
  faces: number,
  colors: string[] = [],
  ofFaces: string[] = [],
) =>
  header(
    `element vertex ${vertices}`,
    ...xyz,
    ...colors,
    `element face ${faces}`,
    list,
    ...ofFaces,
  );
const rgb = (type: string, names = ['red', 'green', 'blue']) =>
  names.map((name) => `property ${type} ${name}`);
const SQUARE = '0 0 0\n1 0 0\n1 1 0\n0 1 0\n';
const TWO_TRIANGLES = [0, 1, 2, 0, 2, 3];

/**
 * The same square with normals, byte colours and a scalar before them, in a byte order and with
 * these line ends.
 */
function binary(little: boolean, lineEnd: string) {
  const text = [
    'ply',
    `format binary_${little ? 'little' : 'big'}_endian 1.0`,
    'comment a square',
    'element vertex 4',
    'property uchar quality',
    'property double x',
    'property float y',
    'property short z',
    ...axes('n'),
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
  [
    [0, 0],
    [1, 0],
    [1, 1],
    [0, 1],
  ].forEach(([x = 0, y = 0]) => {
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
  });
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
    expect(indexOf(model)).toEqual(TWO_TRIANGLES);
    expect(model.parts[0]).toMatchObject({
      sides: 'double',
      look: { alphaMode: 'opaque', map: null },
    });
  });

  it('is read as text, with polygons, float colours and lists that are skipped', async () => {
    const text =
      header(
        ...['element face 2', 'property list uchar float texcoord', list],
        ...['element vertex 4', ...xyz, ...rgb('float')],
      ) + '2 9 9 3 0 1 2\n0 3 0 2 3\n0 0 0 1 0 0\n1 0 0 0 0.5 0\n1 1 0 0 0 1.5\n0 1 0 0 0 0\n';
    const model = await loadFiles({ 'a.ply': text });
    expect(indexOf(model)).toEqual(TWO_TRIANGLES);
    expect(cornersOf(model, 'color').slice(0, 3)).toEqual([[1, 0, 0], [0, 0.5, 0], [0, 0, 1]]); // oxfmt-ignore
  });

  it('without normals is smooth, with edges where faces meet at a sharp angle', async () => {
    const cube =
      mesh(8, 6) +
      '0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n' +
      '4 3 2 1 0\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n';
    const edged = await loadFiles({ 'a.ply': cube });
    expect(edged.parts[0]?.geometry.getAttribute('position').count).toBe(24);
    expect(cornersOf(edged, 'normal').slice(0, 3)).toEqual([[0, 0, -1], [0, 0, -1], [0, 0, -1]]); // oxfmt-ignore
    const ridge = mesh(4, 2) + '0 0 0\n1 0 0\n0 1 0\n-1 0 -0.2\n3 0 1 2\n3 0 2 3\n';
    expect(
      (await loadFiles({ 'a.ply': ridge })).parts[0]?.geometry.getAttribute('position').count,
    ).toBe(4);
  });

  it('may have strips of triangles, every second one reversed', async () => {
    const text =
      header(
        'element vertex 4',
        ...xyz,
        'element tristrips 1',
        'property list int int vertex_indices',
      ) + `${SQUARE}8 0 1 3 2 -1 0 1 2`;
    expect(indexOf(await loadFiles({ 'a.ply': text }))).toEqual([0, 1, 2, 2, 1, 3, 0, 1, 3]);
  });

  const RED = [1, 0, 0];
  const BLUE = [0, 0, 1];
  const GREY = [0.035294, 0.035294, 0.035294];
  const OF_FACES = [RED, RED, RED, BLUE, BLUE, BLUE];
  /** A square that has colours in both. */
  const both = (color: string) =>
    `${mesh(4, 2, rgb('uchar'), rgb('uchar'))}0 0 0 ${color}\n1 0 0 ${color}\n1 1 0 9 9 9\n0 1 0 9 9 9\n` +
    '3 0 1 2 255 0 0\n3 0 2 3 0 0 255\n';

  const before =
    header('element vertex 4', ...xyz, 'element face 2', ...rgb('uchar'), list) + SQUARE;
  const behind = mesh(4, 2, [], rgb('float', ['red', 'green', 'blue', 'alpha'])) + SQUARE;

  it.each([
    [
      'its faces, bytes before corners',
      `${before}255 0 0 3 0 1 2\n0 0 255 3 0 2 3\n`,
      OF_FACES,
      null,
    ],
    [
      'its faces, floats behind, with alpha',
      `${behind}3 0 1 2 1 0 0 1\n3 0 2 3 0 0 1 1\n`,
      OF_FACES,
      null,
    ],
    [
      'its faces, floats from 0 to 255, with alpha',
      `${behind}3 0 1 2 255 0 0 255\n3 0 2 3 0 -1 300 255\n`,
      OF_FACES,
      null,
    ],
    [
      'its faces, floats from 0 to 255, with alpha as fractions',
      `${behind}3 0 1 2 255 0 0 1\n3 0 2 3 0 0 255 1\n`,
      OF_FACES,
      null,
    ],
    [
      'its faces, floats from 0 to 255, and translucent',
      `${behind}3 0 1 2 255 0 0 255\n3 0 2 3 0 0 255 128\n`,
      OF_FACES,
      'alpha',
    ],
    [
      'its vertices, doubles from 0 to 255',
      `${mesh(4, 2, rgb('double', ['r', 'g', 'b']))}0 0 0 255 0 0\n1 0 0 0 0 255\n1 1 0 9 9 9\n0 1 0 1 1 1\n3 0 1 2\n3 0 2 3\n`,
      [RED, BLUE, GREY],
      null,
    ],
    [
      'its vertices, whole numbers of 32 bits, which count to 255',
      `${mesh(4, 2, rgb('int'))}0 0 0 255 0 0\n1 0 0 0 0 1000\n1 1 0 9 9 9\n0 1 0 1 1 1\n3 0 1 2\n3 0 2 3\n`,
      [RED, BLUE, GREY],
      null,
    ],
    [
      'its vertices, whole numbers of 16 bits, which count to 255 where none is above that',
      `${mesh(4, 2, rgb('ushort', ['Red', 'Green', 'Blue', 'Alpha']))}0 0 0 255 0 0 255\n1 0 0 0 0 255 255\n1 1 0 9 9 9 255\n0 1 0 1 1 1 255\n3 0 1 2\n3 0 2 3\n`,
      [RED, BLUE, GREY],
      null,
    ],
    [
      'its vertices, whole numbers of 16 bits, which count to 65535 where one is above 255',
      `${mesh(4, 2, rgb('uint16', ['diffuse_r', 'diffuse_g', 'diffuse_b']))}0 0 0 65535 0 0\n1 0 0 0 0 65535\n1 1 0 2313 2313 2313\n0 1 0 256 0 0\n3 0 1 2\n3 0 2 3\n`,
      [RED, BLUE, GREY],
      null,
    ],
    [
      'its faces where its vertices have all the same',
      both('9 9 9'),
      OF_FACES,
      'the colours of its vertices',
    ],
    [
      'its vertices where they differ',
      both('0 0 255'),
      [BLUE, BLUE, GREY],
      'the colours of its faces',
    ],
  ] as const)('has the colours of %s', async (_, text, colors, omitted) => {
    expect(cornersOf(await loadFiles({ 'a.ply': text }), 'color').slice(0, colors.length)).toEqual(
      colors,
    );
    expect(warnings).toEqual(
      omitted === null ? [] : [expect.stringContaining(`without ${omitted}`)],
    );
  });

  it.each([
    ['0 0 0', '0 1 2 3'],
    ['nan nan nan', '0 1 2 3'],
    ['0 0 1', '3 2 1 0'],
  ])('has normals on the side of its faces where the file has %s for %s', async (normal, face) => {
    const model = await loadFiles({
      'a.ply': `${mesh(4, 1, axes('n'))}${SQUARE.replaceAll('\n', ` ${normal}\n`)}4 ${face}\n`,
    });
    expect(numbersOf(model, 'normal')).toEqual([0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1]);
    const [a, b, c] = cornersOf(model, 'position').map(([x = 0, y = 0, z = 0]): Vec3 => [x, y, z]);
    expect(cross(subtract(b!, a!), subtract(c!, a!))[2]).toBe(1);
  });

  it.each([
    [
      'a vertex that is nan',
      mesh(5, 2),
      `nan 0 0\n${SQUARE}3 1 2 3\n3 1 3 4`,
      /1 vertex \("nan" is not a number\)/,
    ],
    [
      'a face of a huge one',
      mesh(5, 2),
      `${SQUARE}1 1e99 1\n4 0 1 2 3\n3 0 1 4`,
      /1 vertex \(.*1e\+99.*\), 1 face/,
    ],
    [
      'faces of no vertex',
      mesh(4, 3),
      `${SQUARE}4 0 1 2 3\n4 0 1 2 -1\n3 0 1 4`,
      /2 faces \(.* the vertex -1\)/,
    ],
    [
      'values that no header names',
      mesh(4, 1),
      `${SQUARE}4 0 1 2 3 6 0.5 1 1\n`,
      /1 line with more values/,
    ],
    [
      'a texture',
      mesh(4, 1).replace('element', 'comment TextureFile a.png\n$&'),
      `${SQUARE}4 0 1 2 3`,
      /TextureFile/,
    ],
    ['a comment', mesh(4, 1), `comment a\n${SQUARE}# b\n4 0 1 2 3`, null],
    ['line ends within rows', mesh(4, 1), '0 0\n0 1 0 0 1 1\n0 0 1 0\n4\n0 1\n2 3', null],
    ['any line ends', mesh(4, 1), '0 0 0 1 0 0 1 1 0 0 1 0 4 0 1 2 3', null],
    ['some line ends', mesh(4, 1), '0 0 0 1 0 0\n1 1 0 0 1 0\n4 0 1 2 3', null],
  ])('is shown without %s', async (_, head, rows, warning) => {
    expect(indexOf(await loadFiles({ 'a.ply': head + rows }))).toEqual(TWO_TRIANGLES);
    expect(warnings).toEqual(warning === null ? [] : [expect.stringMatching(warning)]);
  });

  it('of over 1,000 elements is refused', async () => {
    const text = header(...Array<string>(1001).fill('element a 0'));
    expect((await failureOf({ 'a.ply': text })).message).toMatch(/over 1,000 elements/);
  });

  it.each([
    [
      header('element vertex 4', ...xyz) + SQUARE,
      /4 points without faces. Only surfaces can be lit/,
    ],
    [mesh(4, 0) + SQUARE, /cloud of 4 points/],
    [mesh(0, 1) + '3 0 0 0', /no vertices/],
    [mesh(4, 1) + `${SQUARE}2 0 1 `, /no triangles/],
    [mesh(4, 1) + `${SQUARE}3 0 1 4`, /vertex 4 of 4/],
    [mesh(4, 1) + `${SQUARE}3 0 1`, /truncated: it ends before its last value/],
    [mesh(4, 1) + `${SQUARE}x 0 1 2`, /"x" is not a number/],
    [mesh(4_000_000_000, 1) + SQUARE, /truncated: its header announces/],
    [mesh(1, 1).replace('float y', 'float q') + '0 0 0\n3 0 0 0', /no x, y and z/],
    [mesh(1, 1) + '0 inf 0\n3 0 0 0', /"inf" is not a number/],
    [mesh('four', 1), /an element has no count/],
    [header('property float x'), /a property comes before any element/],
    [header('element vertex 1', 'property constructor x'), /the type constructor is unknown/],
    ['ply\nformat binary 1.0\nend_header\n', /the format binary is unknown/],
    ['ply\nend_header\n', /no format/],
    ['ply\nformat ascii 1.0\nelement vertex 1\n', /no end/],
  ])('that is broken gives a readable error: %j', async (text, message) => {
    expect(await failureOf({ 'a.ply': text })).toMatchObject({
      code: 'bad-model',
      message: expect.stringMatching(message) as string,
    });
  });
});
