// Writes the models that demo and tests load: the bunny out of its package, and small glTF files
// made here, good and broken. Run by hand (`node .ci/models.mjs`) and committed; the same input
// gives the same bytes.

import { mkdirSync, writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { deflateSync } from 'node:zlib';
import { encodeToKTX2 } from 'ktx2-encoder';
import { MeshoptEncoder } from 'meshoptimizer';
import bunny from '@pmndrs/assets/models/bunny.glb.js';

const fixtures = fileURLToPath(new URL('../tests/fixtures/models/', import.meta.url));
const assets = fileURLToPath(new URL('../demo/assets/models/', import.meta.url));
for (const folder of [fixtures, assets, `${fixtures}beside/`]) {
  mkdirSync(folder, { recursive: true });
}

const base64Of = (dataUri) => dataUri.slice(dataUri.indexOf(',') + 1);
writeFileSync(`${assets}bunny.glb`, Buffer.from(base64Of(bunny), 'base64'));

// -- pieces
// -------------------------------------------------------------------------------------------------

const FLOAT = 5126;
const USHORT = 5123;
const UBYTE = 5121;

const floats = (values) => Buffer.from(new Float32Array(values).buffer);
const shorts = (values) => Buffer.from(new Uint16Array(values).buffer);

/**
 * A unit square in xy, facing +z; texture coordinates with (0, 0) at the top left, as glTF has
 * them.
 */
const quad = {
  positions: floats([-0.5, -0.5, 0, 0.5, -0.5, 0, 0.5, 0.5, 0, -0.5, 0.5, 0]),
  normals: floats([0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1]),
  uvs: floats([0, 1, 1, 1, 1, 0, 0, 0]),
  indices: shorts([0, 1, 2, 2, 3, 0]),
};

const crcTable = Array.from({ length: 256 }, (_, n) => {
  let c = n;
  for (let k = 0; k < 8; k += 1) {
    c = c & 1 ? 0xedb88320 ^ (c >>> 1) : c >>> 1;
  }
  return c >>> 0;
});

function pngChunk(type, data) {
  const body = Buffer.concat([Buffer.from(type, 'latin1'), data]);
  let crc = 0xffffffff;
  for (const byte of body) {
    crc = crcTable[(crc ^ byte) & 0xff] ^ (crc >>> 8);
  }
  const frame = Buffer.alloc(8);
  frame.writeUInt32BE(data.length, 0);
  frame.writeUInt32BE((crc ^ 0xffffffff) >>> 0, 4);
  return Buffer.concat([frame.subarray(0, 4), body, frame.subarray(4)]);
}

/** An 8-bit RGBA PNG of rows of [r, g, b, a]. */
function png(rows) {
  const header = Buffer.alloc(13);
  header.writeUInt32BE(rows[0].length, 0);
  header.writeUInt32BE(rows.length, 4);
  header.set([8, 6, 0, 0, 0], 8);
  const raw = Buffer.concat(rows.map((row) => Buffer.from([0, ...row.flat()])));
  return Buffer.concat([
    Buffer.from([0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a]),
    pngChunk('IHDR', header),
    pngChunk('IDAT', deflateSync(raw, { level: 9 })),
    pngChunk('IEND', Buffer.alloc(0)),
  ]);
}

/**
 * No two texels alike, and no symmetry: a flip, a swap or a colour conversion shows. The last has
 * half alpha.
 */
const texels = [
  [
    [255, 0, 0, 255],
    [0, 255, 0, 255],
  ],
  [
    [0, 0, 255, 255],
    [188, 64, 20, 128],
  ],
];
const texture = png(texels);

/** Puts blobs into one buffer, four-byte aligned, with a buffer view each. */
function pack(blobs) {
  const bufferViews = [];
  const parts = [];
  let byteOffset = 0;
  for (const blob of blobs) {
    bufferViews.push({ buffer: 0, byteOffset, byteLength: blob.length });
    const padding = Buffer.alloc((4 - (blob.length % 4)) % 4);
    parts.push(blob, padding);
    byteOffset += blob.length + padding.length;
  }
  return { bufferViews, bytes: Buffer.concat(parts) };
}

const accessor = (bufferView, type, count, componentType = FLOAT, more = {}) => ({
  bufferView,
  type,
  count,
  componentType,
  ...more,
});

/** A document of one node with one mesh; attributes and accessors in the order of the blobs. */
function document({ attributes, accessors, indices, material, packed, more = {} }) {
  const primitive = { attributes };
  if (indices !== undefined) {
    primitive.indices = indices;
  }
  if (material) {
    primitive.material = 0;
  }
  return {
    asset: { version: '2.0' },
    scene: 0,
    scenes: [{ nodes: [0] }],
    nodes: [{ mesh: 0, name: 'quad' }],
    meshes: [{ primitives: [primitive] }],
    ...(material ? { materials: [material] } : {}),
    accessors,
    bufferViews: packed.bufferViews,
    buffers: [{ byteLength: packed.bytes.length }],
    ...more,
  };
}

function glb(json, body) {
  const text = Buffer.from(JSON.stringify(json), 'utf8');
  const jsonChunk = Buffer.concat([text, Buffer.alloc((4 - (text.length % 4)) % 4, ' ')]);
  const header = Buffer.alloc(20);
  header.write('glTF', 0, 'latin1');
  header.writeUInt32LE(2, 4);
  header.writeUInt32LE(28 + jsonChunk.length + body.length, 8);
  header.writeUInt32LE(jsonChunk.length, 12);
  header.write('JSON', 16, 'latin1');
  const bodyHeader = Buffer.alloc(8);
  bodyHeader.writeUInt32LE(body.length, 0);
  bodyHeader.write('BIN\0', 4, 'latin1');
  return Buffer.concat([header, jsonChunk, bodyHeader, body]);
}

const write = (name, data) => writeFileSync(fixtures + name, data);
const writeJson = (name, json) => write(name, `${JSON.stringify(json, null, 2)}\n`);
const dataUri = (type, bytes) => `data:${type};base64,${bytes.toString('base64')}`;

// -- good
// -------------------------------------------------------------------------------------------------

const NEAREST_CLAMPED = { magFilter: 9728, minFilter: 9728, wrapS: 33071, wrapT: 33071 };
const textured = (image) => ({
  material: { pbrMetallicRoughness: { baseColorTexture: { index: 0 } } },
  more: { textures: [{ source: 0, sampler: 0 }], samplers: [NEAREST_CLAMPED], images: [image] },
});
const quadParts = {
  attributes: { POSITION: 0, NORMAL: 1, TEXCOORD_0: 2 },
  accessors: [
    accessor(0, 'VEC3', 4),
    accessor(1, 'VEC3', 4),
    accessor(2, 'VEC2', 4),
    accessor(3, 'SCALAR', 6, USHORT),
  ],
  indices: 3,
};
const quadBlobs = [quad.positions, quad.normals, quad.uvs, quad.indices];

{
  const packed = pack([...quadBlobs, texture]);
  const json = document({
    ...quadParts,
    ...textured({ bufferView: 4, mimeType: 'image/png' }),
    packed,
  });
  write('textured.glb', glb(json, packed.bytes));
  // The last byte of the body is missing, the header still counts it.
  write('truncated.glb', glb(json, packed.bytes).subarray(0, -1));
  const wrong = Buffer.from(glb(json, packed.bytes));
  wrong.write('glTX', 0, 'latin1');
  write('wrong-magic.glb', wrong);
}

const packedQuad = pack(quadBlobs);
function quadFile(image, uri) {
  const json = document({ ...quadParts, ...textured(image), packed: packedQuad });
  json.buffers[0].uri = uri;
  return json;
}
writeJson(
  'data-uris.gltf',
  quadFile(
    { uri: dataUri('image/png', texture) },
    dataUri('application/octet-stream', packedQuad.bytes),
  ),
);
writeJson('beside/quad.gltf', quadFile({ uri: 'textures/four%20colours.png' }, 'quad.bin'));
write('beside/quad.bin', packedQuad.bytes);
mkdirSync(`${fixtures}beside/textures`, { recursive: true });
write('beside/textures/four colours.png', texture);

{
  const packed = pack([quad.positions, quad.indices]);
  const accessors = [accessor(0, 'VEC3', 4), accessor(1, 'SCALAR', 6, USHORT)];
  write(
    'no-normals.glb',
    glb(document({ attributes: { POSITION: 0 }, accessors, indices: 1, packed }), packed.bytes),
  );
}
{
  // Bytes of linear light: 55 / 255 encodes to almost one half.
  const colors = Buffer.from([255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 55, 55, 55, 128]);
  const packed = pack([quad.positions, quad.normals, colors, quad.indices]);
  const json = document({
    attributes: { POSITION: 0, NORMAL: 1, COLOR_0: 2 },
    accessors: [
      accessor(0, 'VEC3', 4),
      accessor(1, 'VEC3', 4),
      accessor(2, 'VEC4', 4, UBYTE, { normalized: true }),
      accessor(3, 'SCALAR', 6, USHORT),
    ],
    indices: 3,
    material: { pbrMetallicRoughness: { baseColorFactor: [0.21404114, 1, 0.5, 1] } },
    packed,
  });
  write('vertex-colours.glb', glb(json, packed.bytes));
}
{
  const packed = pack([...quadBlobs, texture]);
  const { material, more } = textured({ bufferView: 4, mimeType: 'image/png' });
  const masked = { ...material, alphaMode: 'MASK', alphaCutoff: 0.6 };
  write('mask.glb', glb(document({ ...quadParts, material: masked, more, packed }), packed.bytes));
}

{
  // The same square as in no-normals.glb. The second buffer is where the unpacked bytes would be.
  await MeshoptEncoder.ready;
  const encoded = [
    MeshoptEncoder.encodeGltfBuffer(quad.positions, 4, 12, 'ATTRIBUTES'),
    MeshoptEncoder.encodeGltfBuffer(quad.indices, 6, 2, 'TRIANGLES'),
  ].map((bytes) => Buffer.from(bytes));
  const packed = pack(encoded);
  const accessors = [accessor(0, 'VEC3', 4), accessor(1, 'SCALAR', 6, USHORT)];
  const json = document({ attributes: { POSITION: 0 }, accessors, indices: 1, packed });
  const kinds = [
    { count: 4, byteStride: 12, mode: 'ATTRIBUTES' },
    { count: 6, byteStride: 2, mode: 'TRIANGLES' },
  ];
  json.bufferViews = packed.bufferViews.map((view, i) => {
    const { count, byteStride } = kinds[i];
    const extensions = { EXT_meshopt_compression: { ...view, ...kinds[i] } };
    return { buffer: 1, byteOffset: 48 * i, byteLength: count * byteStride, extensions };
  });
  const fallback = { EXT_meshopt_compression: { fallback: true } };
  json.buffers.push({ byteLength: 60, extensions: fallback });
  json.extensionsUsed = json.extensionsRequired = ['EXT_meshopt_compression'];
  write('meshopt.glb', glb(json, packed.bytes));
  const broken = structuredClone(json);
  broken.bufferViews[0].extensions.EXT_meshopt_compression.count = 5;
  write('meshopt-claims.glb', glb(broken, packed.bytes));
  const damaged = Buffer.from(packed.bytes);
  damaged.fill(255, 0, 8);
  write('meshopt-damaged.glb', glb(json, damaged));
}

// -- KTX2
// -------------------------------------------------------------------------------------------------

/**
 * The four texels of {@link texture}, each as a block of 4 × 4: UASTC keeps blocks of one colour
 * exactly.
 */
async function ktx2(options) {
  const side = 8;
  const data = new Uint8Array(4 * side * side);
  for (let i = 0; i < side * side; i += 1) {
    data.set(texels[Math.floor(i / side / 4)][Math.floor((i % side) / 4)], 4 * i);
  }
  const imageDecoder = async () => ({ width: side, height: side, data });
  return Buffer.from(await encodeToKTX2(new Uint8Array(1), { ...options, imageDecoder }));
}

function ktx2Glb(image) {
  const packed = pack([...quadBlobs, image]);
  const { material, more } = textured({ bufferView: 4, mimeType: 'image/ktx2' });
  more.textures = [{ sampler: 0, extensions: { KHR_texture_basisu: { source: 0 } } }];
  const json = document({ ...quadParts, material, more, packed });
  json.extensionsUsed = json.extensionsRequired = ['KHR_texture_basisu'];
  return glb(json, packed.bytes);
}

{
  const uastc = await ktx2({ isUASTC: true, needSupercompression: true, generateMipmap: true });
  write('ktx2.glb', ktx2Glb(uastc));
  write('ktx2-etc1s.glb', ktx2Glb(await ktx2({ isUASTC: false, generateMipmap: false })));
  const damaged = Buffer.from(uastc);
  damaged.fill(255, damaged.length - 40);
  write('ktx2-damaged.glb', ktx2Glb(damaged));
}

// -- broken or refused
// -------------------------------------------------------------------------------------------------

{
  const packed = pack([quad.positions, quad.indices]);
  const claims = (positions, indices) => [
    accessor(0, 'VEC3', positions),
    accessor(1, 'SCALAR', indices, USHORT),
  ];
  const make = (accessors) =>
    glb(document({ attributes: { POSITION: 0 }, accessors, indices: 1, packed }), packed.bytes);
  write('claims-too-much.glb', make(claims(4_000_000_000, 6)));
  const zeros = claims(4_000_000_000, 6);
  delete zeros[0].bufferView;
  write('claims-zeros.glb', make(zeros));
  const loop = document({
    attributes: { POSITION: 0 },
    accessors: claims(4, 6),
    indices: 1,
    packed,
  });
  loop.nodes = [{ children: [1] }, { mesh: 0, children: [0] }];
  write('node-loop.glb', glb(loop, packed.bytes));
  const unknown = document({
    attributes: { POSITION: 0 },
    accessors: claims(4, 6),
    indices: 1,
    packed,
  });
  unknown.extensionsUsed = unknown.extensionsRequired = ['EXT_mesh_of_tomorrow'];
  write('unknown-extension.glb', glb(unknown, packed.bytes));
  const points = document({ attributes: { POSITION: 0 }, accessors: claims(4, 6), packed });
  points.meshes[0].primitives[0].mode = 0;
  write('points-only.glb', glb(points, packed.bytes));
  const nan = pack([floats([NaN, 0, 0, 1, 0, 0, 0, 1, 0]), shorts([0, 1, 2])]);
  const nanJson = document({
    attributes: { POSITION: 0 },
    accessors: claims(3, 3),
    indices: 1,
    packed: nan,
  });
  write('not-a-number.glb', glb(nanJson, nan.bytes));
}
writeJson(
  'other-origin.gltf',
  quadFile({ uri: dataUri('image/png', texture) }, 'https://example.com/quad.bin'),
);
writeJson(
  'folder-above.gltf',
  quadFile({ uri: dataUri('image/png', texture) }, '../models/beside/../../quad.bin'),
);
writeJson('missing-buffer.gltf', quadFile({ uri: dataUri('image/png', texture) }, 'nowhere.bin'));

// -- OBJ, STL, PLY
// -------------------------------------------------------------------------------------------------

// Two squares side by side, facing +z: a plain one, and one with the texture. Its four corners show
// the four texels.
write(
  'quads.obj',
  `mtllib quads.mtl
v -1 -0.5 0
v 0 -0.5 0
v 0 0.5 0
v -1 0.5 0
v 1 -0.5 0
v 1 0.5 0
vt 0 0
vt 1 0
vt 1 1
vt 0 1
vn 0 0 1
usemtl plain
f 1//1 2//1 3//1 4//1
usemtl picture
f 2/1/1 5/2/1 6/3/1 3/4/1
`,
);
write(
  'quads.mtl',
  `newmtl plain
Ka 0.1 0.2 0.3
Kd 0.8 0.4 0.2
Ks 0.5 0.25 0.125
Ns 20
newmtl picture
Kd 1 1 1
Ks 0 0 0
map_Kd beside/textures/four colours.png
`,
);
{
  // A square of two triangles, red and blue by the convention of VisCAM.
  const bytes = Buffer.alloc(84 + 2 * 50);
  bytes.writeUInt32LE(2, 80);
  const corners = [
    -0.5, -0.5, 0, 0.5, -0.5, 0, 0.5, 0.5, 0, -0.5, -0.5, 0, 0.5, 0.5, 0, -0.5, 0.5, 0,
  ];
  corners.forEach((value, i) => bytes.writeFloatLE(value, 84 + 12 + 4 * i + (i >= 9 ? 14 : 0)));
  bytes.writeUInt16LE(0x8000 | (31 << 10), 84 + 48);
  bytes.writeUInt16LE(0x8000 | 31, 84 + 98);
  write('coloured.stl', bytes);
}
write(
  'coloured.ply',
  `ply
format ascii 1.0
element vertex 4
property float x
property float y
property float z
property uchar red
property uchar green
property uchar blue
element face 1
property list uchar int vertex_indices
end_header
-0.5 -0.5 0 255 0 0
0.5 -0.5 0 0 255 0
0.5 0.5 0 0 0 255
-0.5 0.5 0 255 255 255
4 0 1 2 3
`,
);
