// Do the readers of OBJ, MTL, STL and PLY return a model or throw a ModelError for every file,
// however broken? The files are damaged valid ones and random sequences of the formats' words. The
// time of each is bounded by its size.
import fc from 'fast-check';
import { beforeEach, describe, expect, it } from 'vitest';
import { ModelError, type Content } from '../../../src/phong/model/model.js';
import { fullOr, SEED } from '../../support/repeats.js';
import { heardWarnings, loadFiles, png, standInImages } from './model-files.js';
import { between } from '../../unit/arbitraries.js';

const RUNS = fullOr(20_000, 200);

const encoder = new TextEncoder();

/** A sphere-like grid of quads with everything that a text format can have. */
function grid(
  vertex: (i: number, x: number, y: number) => string,
  face: (a: number, b: number) => string,
) {
  let text = '';
  for (let i = 0; i < 16; i += 1) {
    text += vertex(i, i % 4, Math.floor(i / 4));
  }
  for (let i = 0; i < 11; i += 1) {
    if (i % 4 < 3) {
      text += face(i, i + 4);
    }
  }
  return text;
}

const objText =
  'mtllib a.mtl\no grid\ng one two\ns 1\nusemtl m\nvn 0 0 1\n' +
  grid(
    (i, x, y) => `v ${x} ${y} ${Math.sin(i)} 0.5 0.5 0.5\nvt ${x / 4} ${y / 4}\n`,
    (a, b) => `f ${a + 1}/${a + 1}/1 ${a + 2}/${a + 2} ${b + 2}//1 -${16 - b}\n`,
  );
const mtlText =
  'newmtl m\nKa 1 1 1\nKd 0.5 0.5 0.5\nKs 1 1 1\nNs 20\nd 0.5\nTr 0.5\nmap_Kd -s 1 2 3 -o 0 1 -clamp on x.png\n';
const plyText =
  'ply\nformat ascii 1.0\nelement vertex 16\nproperty float x\nproperty float y\nproperty double z\nproperty uchar red\nproperty uchar green\nproperty uchar blue\nelement face 9\nproperty list uchar int vertex_indices\nend_header\n' +
  grid(
    (i, x, y) => `${x} ${y} ${Math.cos(i)} ${i} 200 0\n`,
    (a, b) => `4 ${a} ${a + 1} ${b + 1} ${b}\n`,
  );
const stlText =
  'solid x\n' +
  'facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1e0 0\nendloop\nendfacet\n'.repeat(
    4,
  ) +
  'endsolid x\n';

function stlBinary() {
  const bytes = new Uint8Array(84 + 50 * 6);
  bytes.set(encoder.encode('COLOR=abcd'));
  bytes[80] = 6;
  for (let i = 84; i < bytes.length; i += 1) {
    bytes[i] = (i * 37) % 63;
  }
  return bytes;
}

function plyBinary(big: boolean) {
  const head = encoder.encode(
    `ply\nformat binary_${big ? 'big' : 'little'}_endian 1.0\nelement vertex 8\nproperty float x\nproperty float y\nproperty float z\nproperty float nx\nproperty float ny\nproperty float nz\nelement tristrips 1\nproperty list int int vertex_indices\nend_header\n`,
  );
  const bytes = new Uint8Array(head.length + 8 * 24 + 36);
  bytes.set(head);
  const view = new DataView(bytes.buffer, head.length);
  for (let i = 0; i < 48; i += 1) {
    view.setFloat32(4 * i, Math.sin(i), !big);
  }
  [8, 0, 1, 2, 3, -1, 4, 5, 6].forEach((value, i) => view.setInt32(192 + 4 * i, value, !big));
  return bytes;
}

type Files = Readonly<Record<string, Uint8Array<ArrayBuffer>>>;

const OBJ: Files = { 'a.obj': encoder.encode(objText), 'a.mtl': encoder.encode(mtlText) };

const SOUND: readonly (readonly [damaged: string, Files])[] = [
  ['a.obj', OBJ],
  ['a.mtl', { ...OBJ, 'x.png': png() }],
  ['text.ply', { 'text.ply': encoder.encode(plyText) }],
  ['little.ply', { 'little.ply': plyBinary(false) }],
  ['big.ply', { 'big.ply': plyBinary(true) }],
  ['text.stl', { 'text.stl': encoder.encode(stlText) }],
  ['binary.stl', { 'binary.stl': stlBinary() }],
];

/** Accepts a consistent model or a ModelError, nothing else. */
async function requireOutcome(files: Files) {
  const result: unknown = await loadFiles(files).catch((error: unknown) => error);
  if (result instanceof ModelError) {
    expect(result.message.length).toBeLessThan(600);
    return;
  }
  if (result instanceof Error) throw result;
  const model = result as Content;
  expect(model.parts.length).toBeGreaterThan(0);
  for (const { geometry, matrix, look, surface } of model.parts) {
    const { count } = geometry.getAttribute('position');
    for (const attribute of Object.values(geometry.attributes)) {
      expect(attribute.count).toBe(count);
      expect(attribute.array.every(Number.isFinite)).toBe(true);
    }
    expect(geometry.index?.array.every((vertex) => vertex < count) ?? true).toBe(true);
    expect(matrix.elements.every(Number.isFinite)).toBe(true);
    const values = [look.opacity, ...(surface.kd ?? []), ...(look.map?.matrix.elements ?? [])];
    expect(values.every(Number.isFinite)).toBe(true);
  }
  model.dispose();
}

type Change = readonly [kind: 'set' | 'cut' | 'double' | 'swap', at: number, value: number];

const change: fc.Arbitrary<Change> = fc.tuple(
  fc.constantFrom('set', 'cut', 'double', 'swap'),
  between(0, 1),
  fc.oneof(fc.constantFrom(0, 10, 13, 32, 45, 46, 47, 48, 57, 92, 101, 127, 128, 255), fc.nat(255)),
);

function changed(bytes: Uint8Array<ArrayBuffer>, changes: readonly Change[]) {
  let list = Array.from(bytes);
  for (const [kind, share, value] of changes) {
    const at = Math.min(Math.floor(share * list.length), list.length - 1);
    if (kind === 'set') {
      list[at] = value;
    } else if (kind === 'cut') {
      list.splice(at, value);
    } else if (kind === 'double') {
      list.splice(at, 0, ...list.slice(at, at + value));
    } else {
      list = [...list.slice(at), ...list.slice(0, at)];
    }
  }
  return Uint8Array.from(list);
}

heardWarnings(); // of files that are missing
beforeEach(() => void standInImages());

describe('every file is a model or a ModelError', () => {
  it.each(SOUND)(`where %s is damaged (seed ${SEED})`, async (damaged, files) => {
    await requireOutcome(files);
    await fc.assert(
      fc.asyncProperty(fc.array(change, { minLength: 1, maxLength: 6 }), async (changes) => {
        await requireOutcome({ ...files, [damaged]: changed(files[damaged]!, changes) });
      }),
      { seed: SEED, numRuns: RUNS },
    );
  });

  const words = [
    'v',
    'vt',
    'vn',
    'f',
    's',
    'o',
    'g',
    'usemtl',
    'mtllib',
    'off',
    '1',
    '2',
    '3',
    '-1',
    '0',
    '1/1',
    '1//1',
    '1/1/1',
    '1e308',
    '1e-400',
    '99999999999999999999',
    'nan',
    'x',
    '#',
    '\\\n',
    '\n',
    '\n',
    '\n',
    '\r',
    '/',
    '\0',
    '1.5.2',
    '+',
    '.',
    '1e',
  ];
  it(`where a text is made of the words of OBJ (seed ${SEED})`, async () => {
    await fc.assert(
      fc.asyncProperty(fc.array(fc.constantFrom(...words), { maxLength: 80 }), async (list) => {
        await requireOutcome({
          'a.obj': encoder.encode(`v 0 0 0\nv 1 0 0\nv 0 1 0\n${list.join(' ')}`),
        });
      }),
      { seed: SEED, numRuns: RUNS },
    );
  });

  const lines = [
    'element vertex 3',
    'element face 1',
    'element face 4294967295',
    'element tristrips 2',
    'element x 9',
    'property float x',
    'property float y',
    'property double z',
    'property uchar red',
    'property char green',
    'property list uchar int vertex_indices',
    'property list float double vertex_index',
    'property list int int y',
    'comment',
    'obj_info x',
    'end_header',
  ];
  it(`where a header is made of the lines of PLY (seed ${SEED})`, async () => {
    const format = fc.constantFrom('ascii', 'binary_little_endian', 'binary_big_endian');
    await fc.assert(
      fc.asyncProperty(
        format,
        fc.array(fc.constantFrom(...lines), { maxLength: 14 }),
        fc.uint8Array({ maxLength: 200 }),
        async (kind, list, body) => {
          const head = encoder.encode(`ply\nformat ${kind} 1.0\n${list.join('\n')}\nend_header\n`);
          await requireOutcome({ 'a.ply': new Uint8Array([...head, ...body]) });
        },
      ),
      { seed: SEED, numRuns: RUNS },
    );
  });
});
