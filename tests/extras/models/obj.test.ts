// Does an OBJ file with its MTL libraries come out as written: triangles, normals by smoothing
// group, and the materials' coefficients?
import { RepeatWrapping, ClampToEdgeWrapping, NoColorSpace, Vector2, type Texture } from 'three';
import { describe, expect, it } from 'vitest';
import { modelContent } from '../../../src/extras/models/model-content.js';
import type { BaseLook } from '../../../src/phong/material/file-surface.js';
import type { SurfaceValues } from '../../../src/phong/material/material-values.js';
import { scale, type Vec3 } from '../../../src/phong/math/vector.js';
import {
  cornersOf,
  failureOf,
  type FileContent,
  heardWarnings,
  indexOf,
  loadFiles,
  numbersOf,
  OPTIONS,
  png,
  standInImages,
} from './model-files.js';

const QUAD = 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n';
const TEXTURED = 'f 1/1 2/1 3/1\n';
const FACING_Z = [0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1];
const obj = (text: string) => loadFiles({ 'a.obj': text });

const warnings = heardWarnings();

describe('the geometry of an OBJ file', () => {
  it('splits a polygon into triangles in its own order', async () => {
    const model = await obj(`${QUAD}f 1 2 3 4\n`);
    expect(cornersOf(model, 'position')).toEqual([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 0, 0], [1, 1, 0], [0, 1, 0]]); // oxfmt-ignore
    expect(numbersOf(model, 'normal')).toEqual(FACING_Z);
    expect(warnings).toEqual([]);
  });

  it('is recognised by its media type if nothing else names the format', async () => {
    const text = encodeURIComponent(`unknown words\n${QUAD}f 1 2 3`);
    expect((await modelContent(new URL(`data:model/obj,${text}`), OPTIONS)).parts).toHaveLength(1);
  });

  it('shares a vertex where position, texture coordinates and normal agree, and nowhere else', async () => {
    const model = await obj(
      `${QUAD}vn 0 0 2\nvn 0 3 4\nf 1//1 2//1 3//1\nf 1//1 3//1 4//2\nf 1//2 3//1 4//2`,
    );
    expect(model.parts[0]?.geometry.getAttribute('position').count).toBe(5);
    expect(cornersOf(model, 'normal')[5]).toEqual([0, 0.6, 0.8]);
  });

  it('is faceted with `s off`, smooth with `s 1`, and has edges at sharp angles if nothing is said', async () => {
    // Two squares that meet at the given angle along the y axis.
    const bent = (degrees: number) => {
      const [c, s] = [Math.cos((degrees * Math.PI) / 180), Math.sin((degrees * Math.PI) / 180)];
      return `v 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 0\nv ${-c} 1 ${-s}\nv ${-c} 0 ${-s}\n`;
    };
    const faces = 'f 1 2 3 4\nf 4 3 5 6\n';
    const distinct = async (text: string) => {
      const corners = cornersOf(await obj(text), 'normal').map((normal) => normal.join(' '));
      return new Set(corners).size;
    };
    expect(await distinct(`${bent(30)}s off\n${faces}`)).toBe(2);
    expect(await distinct(`${bent(80)}s 1\n${faces}`)).toBe(3);
    expect(await distinct(bent(39) + faces)).toBe(3);
    expect(await distinct(bent(41) + faces)).toBe(2);
    expect(await distinct(`${bent(10)}s 1\nf 1 2 3 4\ns 2\nf 4 3 5 6`)).toBe(2);
  });

  it('weights faces by their angle at the vertex, however they are split into triangles', async () => {
    // A corner of a cube: each of three faces counts the same, though one has two triangles there.
    const cube = 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 0 1 1\n';
    const model = await obj(`${cube}s 1\nf 1 3 2\nf 1 4 3\nf 1 2 6 5\nf 1 5 7 4`);
    for (const value of cornersOf(model, 'normal')[0]!) {
      expect(value).toBeCloseTo(-Math.sqrt(1 / 3), 5);
    }
  });

  it('keeps the precision of far coordinates by moving them to an origin', async () => {
    const model = await obj(
      'v 500000.001 4000000 0\nv 500000.002 4000000 0\nv 500000.001 4000000.001 0\nf 1 2 3',
    );
    expect(numbersOf(model, 'position')).toEqual([0, 0, 0, 0.001, 0, 0, 0, 0.001, 0]);
    expect(model.parts[0]?.matrix.elements.slice(12, 15)).toEqual([500000.001, 4000000, 0]);
    expect(numbersOf(model, 'normal').slice(0, 3)).toEqual([0, 0, 1]);
  });

  it.each([
    [
      'as they are written',
      'v 0 0 0\nv 1 0 0 0.5 0.25 1.9\nv 0 1 0 0 1 0\nv 0 2 0 1\nv 0 0 0\n',
      [[1, 1, 1], [0.5, 0.25, 1], [0, 1, 0], [1, 1, 1], [1, 1, 1]], // oxfmt-ignore
    ],
    [
      'that count to 255 if one of them is above 2',
      'v 0 0 0\nv 1 0 0 255 127.5 0\nv 0 1 0 51 2 -3\nv 0 2 0\nv 1 2 0 300 51 1e999\n',
      [[1, 1, 1], [1, 0.5, 0], [0.2, 0.007843, 0], [1, 1, 1], [1, 0.2, 1]], // oxfmt-ignore
    ],
  ])('has the colours of its vertices %s, white where there is none', async (_, text, colors) => {
    const model = await obj(`${text}f 1 2 3\nf 1 4 5`);
    expect(cornersOf(model, 'color')).toEqual([0, 1, 2, 0, 3, 4].map((vertex) => colors[vertex]));
    expect(warnings).toEqual([]);
    expect((await obj(`${QUAD}f 1 2 3`)).parts[0]?.geometry.hasAttribute('color')).toBe(false);
  });

  it('ends a number at a #, with a blank before it or without', async () => {
    const plain = 'v 0 0 0 1 0 0\nv 1 0 0 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0.25 0.5\nvn 0 1 0\ns 7\n';
    const faces = 'f 1 2 3\nf 1/1/1 3/1/1 4/1/1\nf -4//1 -3//1 -2//1';
    const model = await obj(plain + faces);
    for (const comment of ['#', '#9', ' # 0.5 0.5 0.5', '#\\', '# / //']) {
      const commented = await obj((plain + faces).replace(/$/gm, comment));
      for (const name of ['position', 'normal', 'color']) {
        expect(cornersOf(commented, name), comment).toEqual(cornersOf(model, name));
      }
    }
    expect(warnings).toEqual([]);
    await obj(`${QUAD}v 1 2# 3\nf 1 2 3\nf 1 2 5`);
    expect(warnings).toEqual([expect.stringMatching(/1 vertex \(a number is missing\)/)]);
  });

  it('may have its words in capitals', async () => {
    const model = await loadFiles({
      'a.obj': `MTLLIB a.mtl\n${`${QUAD}vn 0 1 0\n`.toUpperCase()}USEMTL Oak\nF 1//1 2//1 3//1\n`,
      'a.mtl': 'NEWMTL Oak\nKD 1 0 0',
    });
    expect(numbersOf(model, 'normal').slice(0, 3)).toEqual([0, 1, 0]);
    expect(model.parts).toMatchObject([{ name: 'Oak', surface: { kd: [255, 0, 0] } }]);
  });

  it('is one part per object and material, named after the object', async () => {
    const faces = 'f 1 2 3\nf 1 3 4\n';
    const table = `o table\nusemtl oak\n${faces}usemtl iron\n${faces}usemtl oak\n${faces}`;
    const model = await obj(`${QUAD}${table}o lamp\ng shade\n${faces}`);
    const parts = model.parts.map(({ name, geometry }) => [name, geometry.index?.count]);
    expect(parts).toEqual([['table', 12], ['table', 6], ['lamp', 6]]); // oxfmt-ignore
  });

  it('becomes one part per material where it has thousands of objects', async () => {
    const screw = (_: unknown, i: number) =>
      `o screw${i}\nusemtl ${i % 2 === 0 ? 'a' : 'b'}\nf 1 2 3\n`;
    const text = QUAD + Array.from({ length: 1200 }, screw).join('');
    expect((await obj(text)).parts.map(({ geometry }) => geometry.index?.count)).toEqual([
      1800, 1800,
    ]);
  });

  // oxfmt-ignore
  it.each([
    ['missing texture coordinates and normals', 'vt 0 0\nf 1/1 2/2 3/3/9 4/-7',
      /: 1 face's texture coordinates \(.*\), 1 face's normals \(/],
    ['a reference of 0', 'f 1/0/0 2/0 3//0 4', /: 1 face's texture coordinates .*1 face's normals/],
    ['slashes with nothing behind them', 'f 1/ 2// 3/// 4', null],
    ['a fourth reference', 'f 1/1/1/1 2 3 4\nvt 0 0\nvn 0 0 1', /: 1 end of a corner of a face \("1\/1\/1\/1"/],
    ['words for texture coordinates', 'f 1 2/e 3\nf 1 3/e 4', /: 2 faces' texture coordinates \("2\/e"/],
    ['unused vertices that are no numbers', 'v nan nan nan\nv 1e16 0 0\nf 1 2 3 4', /: 2 vertices \("nan"/],
    ['faces with such a vertex', 'v nan 0 0\nf 1 2 5 4\nf 5 1 2\nf 1 2 3 4', /: 1 vertex .*, 2 faces/],
    ['faces whose vertex is missing', 'f 1 2 3 9\nf 1 2 0\nf 1 -9 2\nf x y z\nf 1;2 2 3\nf 1 2 3 4',
      /: 5 faces \(.*not there/],
    ['lines, points and curves', 'f 1 2 3 4\nl 1 2\nl 2 3 4\np 1\ncurv 0 1 1 2', /: 2 lines, 1 point, 1 curve/],
  ])('is shown without %s', async (_, text, warning) => {
    const model = await obj(QUAD + text);
    expect(indexOf(model)).toEqual([0, 1, 2, 0, 2, 3]);
    expect(numbersOf(model, 'normal')).toEqual(FACING_Z);
    const said = warning === null ? [] : [expect.stringMatching(warning)];
    expect(warnings.map((line) => line.replace('a.obj is shown without', ':'))).toEqual(said);
  });

  it.each(['0 0 0', 'nan nan nan', 'inf 0 0', ''])('computes a normal for `vn %s`', async (vn) => {
    const model = await obj(`${QUAD}vn ${vn}\nf 1//1 2//1 3//1 4//1`);
    expect(numbersOf(model, 'normal')).toEqual(FACING_Z);
  });

  it('gives a face its own normal where the smoothed one is not on its side', async () => {
    // A tilted one: the sums cancel but for rounding.
    const tilted = await obj(
      'v 0.1 0.2 0.3\nv 1.7 0.4 0.9\nv 0.3 1.1 1.3\ns 1\nf 1 2 3\nf 3 2 1\nf 2 1 3',
    );
    const [[x = 0, y = 0, z = 0] = [], , , ...others] = cornersOf(tilted, 'normal');
    expect(Math.hypot(x, y, z)).toBeCloseTo(1, 5);
    for (const [ox = 0, oy = 0, oz = 0] of others) {
      expect(ox * x + oy * y + oz * z).toBeCloseTo(-1, 5);
    }
  });

  it('is smooth on each side of a dome that is written twice, front and back, in one group', async () => {
    const n = 7;
    const vertices = Array.from({ length: n * n }, (_, k) => {
      const [a, b] = [(k % n) / 3 - 1, Math.floor(k / n) / 3 - 1];
      return `v ${a} ${b} ${Math.sqrt(3 - a * a - b * b)}\n`;
    });
    const quads = Array.from({ length: n * n }, (_, k) => k + 1)
      .filter((k) => k % n !== 0 && k <= n * (n - 1))
      .map((k) => [k, k + 1, k + 1 + n, k + n]);
    const normalsOf = async (faces: readonly number[][]) => {
      const lines = faces.map((face) => `f ${face.join(' ')}\n`);
      const model = await obj(`${vertices.join('')}s 1\n${lines.join('')}`);
      const [places, normals] = [cornersOf(model, 'position'), cornersOf(model, 'normal')];
      const text = (normal: readonly number[]) => normal.map((c) => c.toFixed(5)).join(' ');
      return new Map(places.map((place, i) => [place.join(' '), text(normals[i]!)]));
    };
    const backs = quads.map((face) => face.toReversed());
    const [front, back] = [await normalsOf(quads), await normalsOf(backs)];
    // Of the side that comes last, a corner overwrites that of the other.
    expect(await normalsOf([...backs, ...quads])).toEqual(front);
    expect(await normalsOf([...quads, ...backs])).toEqual(back);
    expect(await normalsOf(quads.flatMap((face, i) => [face, backs[i]!]))).toEqual(back);
    expect(new Set(front.values()).size).toBe(n * n);
  });

  it.each([
    ['v 0 0\nf 1 1 1', /a number is missing/],
    ['v 0 0 3.1+e2\nf 1 1 1', /"3\.1\+e2" is not a number/],
    [`v 0 ${'x'.repeat(500)} 0\nf 1 1 1`, /"x{100}\.\.\." is not a number/],
    ['v 0 0 ü\nf 1 1 1', /"ü" is not a number/],
    ['# x\r\n\r\nv 0 0 1e16', /1e15/],
    [`${QUAD}\nf 1 2 9`, /it refers to vertex 9, but there are only 4/],
    [`${QUAD}f 1 2 0`, /not there/],
    [`${QUAD}f 1 2 -5`, /not there/],
    [`${QUAD}f 1 2 c`, /"c" is not a corner of a face/],
    [`${QUAD}f 1;2 2 3`, /v\/vt\/vn/],
    [`${QUAD}f 1 2 8\nf 1 2 9`, /it refers to vertex 9/],
    [QUAD, /no faces/],
    [`${QUAD}l 1 2 3`, /no faces/],
    [`${QUAD}f 1 2`, /no faces/],
  ])('is an error for an author to understand: %j', async (text, message) => {
    const error = await failureOf({ 'a.obj': text });
    expect(error.code).toBe('bad-model');
    expect(error.message).toMatch(message);
  });

  it('is refused with a face of more than 65,536 corners', async () => {
    const face = (corners: number) => `${QUAD}f${' 1 2 3 4'.repeat(corners / 4)}`;
    expect((await obj(face(2 ** 16))).parts).toHaveLength(1);
    expect(await failureOf({ 'a.obj': face(2 ** 16 + 4) })).toMatchObject({ code: 'too-large' });
  });

  it.each(['x', ' ', '\n'])(
    'is refused with a line, word or gap of 4 MiB of %j',
    async (character) => {
      const long = character.repeat(2 ** 22 + 1);
      for (const text of [`#${long}${QUAD}`, `usemtl ${long}${QUAD}`]) {
        expect((await failureOf({ 'a.obj': text })).message).toMatch(/longer than 4 MiB/);
      }
    },
  );
});

describe('the materials of an OBJ file', () => {
  /** As written in the file, in HTML's units. */
  const inHtml = (...color: Vec3) => scale(color, 255);
  const bytesOf = (characters: string) => Uint8Array.from(characters, (c) => c.charCodeAt(0));
  const withMtl = async (
    mtl: string,
    images: Readonly<Record<string, FileContent>> = {},
  ): Promise<Partial<SurfaceValues & BaseLook>> => {
    const text = `mtllib a.mtl\n${QUAD}vt 0 0\nusemtl m\n${TEXTURED}`;
    const [part] = (await loadFiles({ 'a.obj': text, 'a.mtl': mtl, ...images })).parts;
    return { ...part?.look, ...part?.surface };
  };

  it('are the coefficients of the equation, exactly as written', async () => {
    const look = await withMtl(
      'newmtl m\nKa 0.1 0.2 0.3\nKd .4 5e-1 0.600\nKs 0.7 0.8 0.9\nNs 96.078431\nd 0.25\nNi 1.45\nillum 2\n',
    );
    expect(look).toMatchObject({
      ka: inHtml(0.1, 0.2, 0.3),
      kd: inHtml(0.4, 0.5, 0.6),
      ks: inHtml(0.7, 0.8, 0.9),
      shininess: 96.078431,
      opacity: 0.25,
      alphaMode: 'blend',
      baseColor: [1, 1, 1],
    });
    expect(warnings).toEqual([]);
  });

  /** Each byte as the character of its number. */
  it.each([
    ['UTF-8', '\xc3\xa4', '\xc3\xb6', 'ä'],
    ['Latin-1', '\xe4', '\xf6', 'ä'],
    ['Latin-1 with two accented letters in a row', '\xf6\xdf', '\xf6\xe4', 'öß'],
    ['GBK', '\xb4\xf3\xd0\xa1', '\xb4\xf3\xb4\xf3', '大小'],
    ['GBK with a single character', '\xb4\xf3', '\xd0\xa1', '大'],
    ['GBK with a character of an odd kind', '\xb4\xf3\x8a\x41', '\xb4\xf3', '大夾'],
    ['an unknown encoding', '\xff\x20\xe4', '\xff\x20\xe5', 'ÿ ä'],
  ])('may have names in %s', async (_, name, other, text) => {
    standInImages();
    const model = await loadFiles({
      'a.obj': bytesOf(
        `mtllib l${name}.mtl\n${QUAD}vt 0 0\nusemtl m${name}\nf 1/1 2/1 3/1\n` +
          `usemtl m${other}\nf 1/1 3/1 4/1`,
      ),
      // The server has the names as Unicode.
      [`l${text}.mtl`]: bytesOf(
        `newmtl m${name}\nKd 1 0 0\nmap_Kd maps\\${name}.png\nnewmtl m${other}\nKd 0 1 0\n`,
      ),
      [`maps/${text}.png`]: png(),
    });
    expect(model.parts.map(({ surface }) => surface.kd)).toEqual([inHtml(1, 0, 0), inHtml(0, 1, 0)]); // oxfmt-ignore
    expect(model.parts.map(({ look }) => look.map === null)).toEqual([false, true]);
    expect([model.missing, warnings]).toEqual([[], []]);
  });

  it('name a missing file once, whatever the encoding of its name', async () => {
    const text = `mtllib \xe4.mtl\nusemtl m\n${QUAD}f 1 2 3`;
    const model = await loadFiles({ 'a.obj': bytesOf(text) });
    expect(model.missing).toEqual(['ä.mtl']);
    expect(warnings).toHaveLength(1);
  });

  const grey = inHtml(0.5, 0.5, 0.5);
  it.each([
    // MeshLab, Blender and 3ds Max write it beside a bright Ks where there is no highlight.
    ['Kd 0.5 0.5 0.5\nKs 1 1 1\nillum 2\nNs 0.000000', { kd: grey, ks: [0, 0, 0] }],
    ['Ks 1 1 1\nNs 0.1', { ks: inHtml(1, 1, 1), shininess: 0.1 }],
    ['d 0.5\nTr 1', { opacity: 0.5 }],
    ['Tr 1\nd 1', { opacity: 1 }],
    ['Tr 0.75', { opacity: 0.25 }],
    // An invisible material makes no sense: such exporters mean opacity.
    ['Tr 1.000000', { opacity: 1 }],
    ['d -halo 0.5', { opacity: 0.5 }],
    ['Kd 0.5 0.5 0.5#1\nd 0.5#\nNs 10#', { kd: grey, opacity: 0.5, shininess: 10 }],
    ['Kd 0.5 # 1 1\nd 0.5 # half\nTf 1 1 1 # none', { kd: grey, opacity: 0.5 }],
    ['d 7', { opacity: 1 }],
    ['d', { opacity: 1 }],
    ['d x\nTr y', { opacity: 1 }],
    // The equation cannot take these.
    ['Kd spectral red.rfl', { kd: undefined }],
    ['Kd xyz 1 1 1', { kd: undefined }],
    ['Kd -1 2 16\nKe 0 0 1e9', { kd: [0, 510, 4080], emissive: [0, 0, 1e6 / 255] }],
    // A library with more counts to 255.
    [
      'Kd 255 128 0\nKs 51\nKe 1 2 3',
      { ka: [255, 128, 0], kd: [255, 128, 0], ks: [51, 51, 51], emissive: [1, 2, 3] },
    ],
    ['Ka 20\nmap_Kd x.png', { ka: [20, 20, 20], kd: [255, 255, 255] }],
    ['Kd nan 0 0', { kd: undefined }],
    ['Ke 0.8 0.4 0', { emissive: [0.8, 0.4, 0], emissiveMap: null }],
    ['Kd 1 1 1\nKe 0 0 0\nmap_Ke x.png', { emissive: [0, 0, 0], emissiveMap: null }],
  ])('follow the words of the file: %j', async (lines, values) => {
    const look = await withMtl(`newmtl m\n${lines}`);
    const found = Object.keys(values).map((name) => [name, look[name as keyof typeof look]]);
    expect(Object.fromEntries(found)).toEqual(values);
  });

  it('use Kd as Ka if the file has none, and leave the rest to the element', async () => {
    const look = await withMtl('newmtl m\nKd 0.5\n');
    expect(look).toMatchObject({ ka: grey, kd: grey, opacity: 1, alphaMode: 'opaque' });
    expect(look).not.toHaveProperty('ks');
    expect(look).not.toHaveProperty('shininess');
    expect(await withMtl('newmtl other\nKd 1 0 0')).not.toHaveProperty('kd');
  });

  it('have a texture with straight texels, its rows from the top, its scale, offset and borders as written', async () => {
    const images = standInImages();
    const options = '-s 2 3 1 -o 0.25 0.5 -clamp on -bm 1';
    const mtl = `newmtl m\nmap_Kd ${options} pictures\\oak wood #2.png\nnewmtl n\nmap_Kd pictures/oak wood #2.png`;
    const faces = 'usemtl m\nf 1/1 2/2 3/3\nusemtl n\nf 1 2 3\n';
    const text = `mtllib lib/a.mtl\n${QUAD}vt 0 0\nvt 1 0\nvt 1 0.75\n${faces}`;
    const model = await loadFiles({
      'a.obj': text,
      'lib/a.mtl': mtl,
      'lib/pictures/oak wood #2.png': png(),
    });
    const map = model.parts[0]?.look.map as Texture;
    expect(map).toMatchObject({
      flipY: false,
      colorSpace: NoColorSpace,
      wrapS: ClampToEdgeWrapping,
    });
    expect(model.parts[0]?.surface).toMatchObject({ ka: [255, 255, 255], kd: [255, 255, 255] });
    expect(cornersOf(model, 'uv')[2]).toEqual([1, 0.25]);
    // The file's coordinates (1, 0.75), scaled and moved, are (2.25, 2.75): from the top, that is 1
    // − 2.75.
    expect(new Vector2(1, 0.25).applyMatrix3(map.matrix).toArray()).toEqual([2.25, -1.75]);
    expect(model.parts[1]?.look.map).toMatchObject({ wrapT: RepeatWrapping });
    expect(images.decoded()).toBe(1);
    model.dispose();
    model.dispose();
    await expect.poll(images.closed).toBe(1);
  });

  it('emit by the map of Ke', async () => {
    standInImages();
    const look = await withMtl('newmtl m\nmap_Ke x.png', { 'x.png': png() });
    expect(look).toMatchObject({ emissive: [1, 1, 1], map: null });
    expect(look.emissiveMap).not.toBeNull();
  });

  it('name what they leave out once, if a face uses them', async () => {
    const text = `mtllib a.mtl\n${QUAD}usemtl m\nf 1 2 3\nusemtl n\nf 1 2 4\nusemtl none\nf 2 3 4`;
    const mtl =
      'newmtl m\nmap_Bump b.png\nTf 1 1 1\nillum 2\nNi 1\nmap_Kd k.png\nmap_Ka k.png\nnewmtl n\nmap_bump c.png\nTf 0.5 1 1\nnewmtl o\ndisp d.png';
    await loadFiles({ 'a.obj': text, 'a.mtl': mtl });
    expect(warnings).toEqual([
      'a.obj is shown without 1 material that no library has (none), map_bump, Tf.',
    ]);
  });

  it.each([
    ['mtllib "a b.mtl"', 'newmtl m', 'usemtl m'],
    ['mtllib none.txt "a b.mtl"', 'newmtl m', 'usemtl m'],
    ['mtllib a b.mtl # of the house', 'newmtl m', 'usemtl m'],
    ['mtllib other.mtl a b.mtl', 'newmtl m', 'usemtl m'],
    ['mtllib\ta b.mtl', 'newmtl m # red', 'usemtl m # the red one'],
    ['mtllib a b.mtl', 'newmtl "m"', 'usemtl m'],
    ['mtllib a b.mtl', 'newmtl m n', 'usemtl "m n"'],
    ['mtllib a b.mtl', 'newmtl Material #25\nKd 0 1 0\nnewmtl Material #26', 'usemtl Material #26'],
  ])('are found by their names: %s, %s, %s', async (library, newmtl, usemtl) => {
    const text = `${library}\n${QUAD}${usemtl}\nf 1 2 3`;
    const model = await loadFiles({
      'a.obj': text,
      'a b.mtl': `${newmtl}\nKd 1 0 0`,
      'other.mtl': '',
    });
    expect(model.parts[0]?.surface).toMatchObject({ kd: [255, 0, 0] });
  });

  it.each([
    ['"a b.png"', 1, false],
    ['-s 2 2 1 a b.png', 2, false],
    ['a b.png -s 2 2 1 -clamp on', 2, true],
    ['"a b.png" -S 2 2 1 -clamp on', 2, true],
    ['-clamp on -s 2 2 "a b.png"', 2, true],
    ['a b.png # the wood', 1, false],
    ['.\\a b.png -bm 1', 1, false],
  ])('have an image by its name: %s', async (written, repeat, clamped) => {
    standInImages();
    const { map } = await withMtl(`newmtl m\nmap_Kd ${written}`, { 'a b.png': png() });
    expect(map?.repeat.toArray()).toEqual([repeat, repeat]);
    expect(map?.wrapS).toBe(clamped ? ClampToEdgeWrapping : RepeatWrapping);
  });

  it.each(['//host/x.mtl', '//no host/x.mtl', '\\\\server\\share\\x.mtl', 'http://host/x.mtl'])(
    'are left out with a warning where the library is %s',
    async (library) => {
      expect((await obj(`mtllib ${library}\n${QUAD}f 1 2 3`)).parts).toHaveLength(1);
      expect(warnings).toEqual([expect.stringMatching(/a\.obj is shown without 1 of the files/)]);
    },
  );

  it.each(['utf-16le', 'utf-16be'] as const)(
    'and the geometry can be written in %s',
    async (encoding) => {
      const encoded = (text: string) => {
        const bytes = Buffer.from(`\ufeff${text}`, 'utf16le');
        return Uint8Array.from(encoding === 'utf-16le' ? bytes : bytes.swap16());
      };
      const text = `mtllib größe.mtl\n${QUAD}usemtl rötlich\nf 1 2 3`;
      const model = await loadFiles({
        a: encoded(text),
        'größe.mtl': encoded('newmtl rötlich\nKd 1 0 0\n'),
      });
      expect(model.parts[0]?.surface).toMatchObject({ kd: [255, 0, 0] });
    },
  );

  it('are too-large past the limit of pixels, and all images are closed', async () => {
    const images = standInImages();
    const text = `mtllib a.mtl\n${QUAD}vt 0 0\nusemtl m\n${TEXTURED}usemtl n\n${TEXTURED}usemtl o\n${TEXTURED}`;
    const mtl = 'newmtl m\nmap_Kd x.png\nnewmtl n\nmap_Kd y.png\nnewmtl o\nmap_Kd z.png';
    const large = png(8192, 4096);
    const pictures = { 'x.png': large, 'y.png': large, 'z.png': png(1, 1) };
    const tooLarge = await failureOf({ 'a.obj': text, 'a.mtl': mtl, ...pictures });
    expect(tooLarge.code).toBe('too-large');
    expect(images.decoded()).toBe(2);
    expect(images.closed()).toBe(2);
  });
});
