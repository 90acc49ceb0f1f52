// Does reading a glTF document let other tasks run after a bounded amount of work, whichever of its
// lists is long? Every look at the clock says that the task has taken long enough, so that the
// pauses count the slices.
import { Mesh } from 'three';
import { expect, it, vi } from 'vitest';
import { glbOf, type Json } from '../../fuzz/glb.js';
import { triangleDocument, triangleGlb } from '../../fuzz/models.js';
import { countedPauses, heardWarnings, loadFiles } from './model-files.js';

heardWarnings();

const pauses = countedPauses();

const MANY = 2 ** 13;

const loadTriangle = (more: Json) => loadFiles({ 'a.glb': new Uint8Array(triangleGlb(more)) });

/** Pauses of a load of the triangle with this in its document, readable or not. */
async function pausesWith(more: Json) {
  await loadTriangle(more).catch(() => undefined);
  return pauses.count;
}

const SCALAR = { componentType: 5126, count: 1, type: 'SCALAR' };
const VEC3 = { componentType: 5126, count: 1, type: 'VEC3' };
const [POSITIONS] = triangleDocument()['accessors'] as Json[];
const sampler = { input: 1, output: 2 };
const channel = { sampler: 0, target: { node: 0, path: 'translation' } };
/** Its times are out of order. */
const broken = { samplers: [{ input: 3, output: 2 }], channels: [channel] };
const back = { ...SCALAR, count: 2, bufferView: 0, byteOffset: 12 };

it.each<[what: string, more: Json]>([
  ['skins', { skins: Array<Json>(MANY).fill({ joints: [0] }) }],
  ['materials', { materials: Array<Json>(MANY).fill({}) }],
  ['textures', { textures: Array<Json>(MANY).fill({}) }],
  ['empty animations', { animations: Array<Json>(MANY).fill({}) }],
  ['animations without samplers', { animations: Array<Json>(MANY).fill({ channels: [channel] }) }],
  [
    'animations whose times go back',
    {
      accessors: [POSITIONS!, SCALAR, { ...VEC3, count: 2 }, back],
      animations: Array<Json>(MANY).fill(broken),
    },
  ],
  [
    'animations that play',
    {
      accessors: [POSITIONS!, SCALAR, VEC3],
      animations: Array<Json>(MANY).fill({ samplers: [sampler], channels: [channel] }),
    },
  ],
])('a document is read in slices of many %s', async (_, more) => {
  const before = await pausesWith({});
  pauses.count = 0;
  // Besides parsing, which pauses after some thousand values.
  expect((await pausesWith(more)) - before).toBeGreaterThanOrEqual(MANY / 32);
});

it('a GLB of many empty chunks is read in slices', async () => {
  pauses.count = 0;
  const before = await pausesWith({});
  const plain = triangleGlb({});
  const chunks = new Uint8Array(plain.byteLength + 8 * MANY);
  chunks.set(new Uint8Array(plain));
  new DataView(chunks.buffer).setUint32(8, chunks.length, true);
  pauses.count = 0;
  await loadFiles({ 'a.glb': chunks });
  expect(pauses.count).toBeGreaterThanOrEqual(before + MANY / 2048);
});

/** Items of all lists together. */
const itemsIn = (lists: readonly unknown[]) =>
  lists.reduce<number>((sum, list) => sum + (list as unknown[]).length, 0);

it('the nodes that a scene names thousands of times are visited once, and shown once', async () => {
  const flatMap = vi.spyOn(Array.prototype, 'flatMap');
  const [children, roots] = [300, 1000];
  const { parts } = await loadTriangle({
    // The second one lies below the first.
    scenes: [{ nodes: Array.from({ length: roots }, (_, i) => i % 2) }],
    nodes: [
      { children: Array.from({ length: children }, (_, i) => i + 1) },
      { mesh: 0 },
      ...Array<Json>(children - 1).fill({}),
    ],
  });
  expect(parts).toHaveLength(1);
  expect(itemsIn(flatMap.mock.results.map(({ value }) => value as unknown))).toBeLessThan(
    10 * (children + roots),
  );
});

it('copies of a mesh that many nodes name are made with pauses in between', async () => {
  const count = 200;
  const nodes = Array<Json>(count).fill({ mesh: 0 });
  const children = Array.from({ length: count }, (_, i) => i + 1);
  /** Copies by the pauses before them. */
  const copies: number[] = [];
  const clone = vi.spyOn(Mesh.prototype, 'clone').mockImplementation(function (this: Mesh) {
    copies[pauses.count] = (copies[pauses.count] ?? 0) + 1;
    return new Mesh().copy(this);
  });
  const more = { nodes: [{ children }, ...nodes], scenes: [{ nodes: [0] }], scene: 0 };
  await loadFiles({ 'a.glb': new Uint8Array(triangleGlb(more)) });
  clone.mockRestore();
  expect(copies.reduce((sum, each) => sum + each, 0)).toBe(count);
  expect(Math.max(...copies.filter((each) => each > 0))).toBeLessThanOrEqual(8);
});

it('lists of another length than wanted are not walked', async () => {
  const isFinite = vi.spyOn(Number, 'isFinite');
  const long = Array<number>(10_000).fill(1);
  const material = { pbrMetallicRoughness: { baseColorFactor: long } };
  await expect(loadTriangle({ materials: [material] })).rejects.toThrow(/is not 4 numbers/);
  expect(isFinite.mock.calls.length).toBeLessThan(1000);
});

it('thousands of buffers in base64 are found by their keys', async () => {
  const buffers = Array.from({ length: 400 }, (_, i) => {
    const bytes = Buffer.alloc(3072 + 3 * i);
    return {
      byteLength: bytes.length,
      uri: `data:application/octet-stream;base64,${bytes.toString('base64')}`,
    };
  });
  const find = vi.spyOn(Array.prototype, 'find');
  const document = triangleDocument({
    buffers,
    bufferViews: buffers.map(({ byteLength }, buffer) => ({ buffer, byteLength })),
    accessors: buffers.map((_, bufferView) => ({ ...POSITIONS!, bufferView })),
    scenes: [{ nodes: buffers.map((_, i) => i) }],
    nodes: buffers.map((_, mesh) => ({ mesh })),
    meshes: buffers.map((_, i) => ({ primitives: [{ attributes: { POSITION: i } }] })),
  });
  const { parts } = await loadFiles({ 'a.glb': new Uint8Array(glbOf(document)) });
  expect(parts).toHaveLength(buffers.length);
  expect(itemsIn(find.mock.contexts)).toBeLessThan(20 * buffers.length);
});

it('no long text is searched, and no long view copied, in one piece', async () => {
  const size = 2 ** 22;
  /** Bytes of each search and each copy. */
  const lengths: number[] = [];
  const proto = Uint8Array.prototype;
  const { indexOf, set } = proto;
  vi.spyOn(proto, 'indexOf').mockImplementation(function (this: Uint8Array, byte, from = 0) {
    lengths.push(this.length - from);
    return indexOf.call(this, byte, from);
  });
  vi.spyOn(proto, 'set').mockImplementation(function (this: Uint8Array, bytes, at) {
    lengths.push(bytes.length);
    set.call(this, bytes, at);
  });
  const uri = `data:;base64,${Buffer.alloc(size).toString('base64')}`;
  const byteLength = size;
  const more = { buffers: [{ byteLength, uri }], bufferViews: [{ buffer: 0, byteLength }] };
  const file = new TextEncoder().encode(JSON.stringify(triangleDocument(more)));
  expect((await loadFiles({ 'a.gltf': file })).parts).toHaveLength(1);
  vi.restoreAllMocks();
  const long = lengths.filter((length) => length >= size);
  expect(long, 'what Node reads of a file').toEqual([file.length]);
});
