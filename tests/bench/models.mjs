// @ts-check
// The model files that the bench loads in every viewer: five by other people and five made here,
// each with another kind of work (triangles, textures, parts, materials, several files). Knows no
// viewer.

import { cpSync, mkdirSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { basename, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { bounds, Gltf, glbOf, gltfOf } from './glb.mjs';

/**
 * A surface over (u, v) in 0–1, as glTF's attributes. @typedef {Required<import('./glb.mjs').Grid>}
 * Grid
 */

/** Name of each model, and its file in the folder that `writeModels` fills. */
export const MODELS = /** @type {const} */ ({
  bunny: 'bunny.glb',
  suzi: 'suzi.glb',
  pmndrs: 'pmndrs.glb',
  '10 k triangles': '10k.glb',
  '100 k triangles': '100k.glb',
  '400 k triangles': '400k.glb',
  'four textures': 'textures.glb',
  '500 parts': 'parts.glb',
  controller: 'magicleap-two.glb',
  engine: '2CylinderEngine.gltf',
});

/**
 * Models whose first picture is compared with that of a page with three.js's own loader, and their
 * files.
 */
export const FIRST_MODELS = /** @type {const} */ ({
  'GLB of 1 MB': 'first-1.glb',
  'GLB of 10 MB': 'first-10.glb',
  Draco: 'bunny.glb',
  '.gltf with .bin': 'first.gltf',
  'text STL': 'first.stl',
  '64 images': 'images.glb',
  'PLY of 0.8 M triangles': 'first.ply',
});

/** The model of a whole picture, whose error is measured. */
const CHECKS = 'checks.glb';

const LINEAR = 9729;
const SHORT = 5122;
const BYTE = 5120;
const TEXTURE_SIZE = 1024;
const CHECKS_SIZE = 64;
const PARTS = 500;

const assets = fileURLToPath(new URL('../../demo/assets/models/', import.meta.url));
/**
 * Licences: demo/assets/models/real/NOTICE.md. The engine is a text file with a .bin; it and the
 * first three use Draco.
 */
const REAL = [
  'bunny.glb',
  'real/suzi.glb',
  'real/pmndrs.glb',
  'real/magicleap-two.glb',
  'real/engine/2CylinderEngine.gltf',
  'real/engine/2CylinderEngine.bin',
];

/** @param {string} folder */
export function writeModels(folder) {
  mkdirSync(folder, { recursive: true });
  /** @param {string} name @param {string | Uint8Array} file */
  const write = (name, file) => writeFileSync(join(folder, name), file);
  for (const file of REAL) {
    cpSync(join(assets, file), join(folder, basename(file)));
  }
  write(MODELS['10 k triangles'], glbOf(bumpySphere(100, 51)));
  write(MODELS['100 k triangles'], glbOf(bumpySphere(320, 158)));
  write(MODELS['400 k triangles'], quantizedPatches().glb());
  write(MODELS['four textures'], texturedSpheres().glb());
  write(MODELS['500 parts'], manyParts().glb());
  write(CHECKS, checkedSphere().glb());
  write(FIRST_MODELS['GLB of 1 MB'], glbOf(bumpySphere(230, 115)));
  write(FIRST_MODELS['GLB of 10 MB'], glbOf(bumpySphere(540, 380)));
  const [json, bin] = gltfOf(bumpySphere(230, 115)).pair('first.bin');
  write(FIRST_MODELS['.gltf with .bin'], json);
  write('first.bin', bin);
  write(FIRST_MODELS['text STL'], textStl(bumpySphere(160, 80)));
  write(FIRST_MODELS['64 images'], texturedSpheres(64, 64).glb());
  write(FIRST_MODELS['PLY of 0.8 M triangles'], binaryPly(bumpySphere(800, 500)));
}

/**
 * A sphere of radius about 1 with bumps: `columns` × `rows` quads, over a part of the turn.
 * @param {number} columns @param {number} rows @param {number} [from] 0–1 @param {number} [to] 0–1
 * @returns {Grid}
 */
function bumpySphere(columns, rows, from = 0, to = 1) {
  const count = (columns + 1) * (rows + 1);
  const [positions, normals, uvs] = [3, 3, 2].map((size) => new Float32Array(size * count));
  const indices = new (count > 65_535 ? Uint32Array : Uint16Array)(6 * columns * rows);
  let [vertex, index] = [0, 0];
  for (let row = 0; row <= rows; row++) {
    for (let column = 0; column <= columns; column++, vertex++) {
      const [u, v] = [from + ((to - from) * column) / columns, row / rows];
      const [turn, polar] = [2 * Math.PI * u, Math.PI * v];
      const normal = [
        Math.sin(polar) * Math.cos(turn),
        Math.cos(polar),
        -Math.sin(polar) * Math.sin(turn),
      ];
      const radius = 1 + 0.03 * Math.sin(12 * turn) * Math.sin(9 * polar);
      positions?.set(
        normal.map((x) => x * radius),
        3 * vertex,
      );
      normals?.set(normal, 3 * vertex);
      uvs?.set([u, v], 2 * vertex);
      if (row === rows || column === columns) continue;
      const below = vertex + columns + 1;
      indices.set([vertex, below, vertex + 1, vertex + 1, below, below + 1], index);
      index += 6;
    }
  }
  return /** @type {Grid} */ ({ positions, normals, uvs, indices });
}

/** 400,000 triangles in 4.8 MB: KHR_mesh_quantization, in patches that short indices reach. */
function quantizedPatches() {
  const gltf = new Gltf();
  const patches = 8;
  for (let i = 0; i < patches; i++) {
    const { positions, normals, indices } = bumpySphere(125, 200, i / patches, (i + 1) / patches);
    const count = positions.length / 3;
    // 1.1 is more than the largest radius. Vertices are aligned to 4 bytes.
    const places = new Int16Array(4 * count);
    const directions = new Int8Array(4 * count);
    for (let at = 0; at < positions.length; at++) {
      const slot = 4 * Math.floor(at / 3) + (at % 3);
      places[slot] = Math.round(((positions[at] ?? 0) / 1.1) * 32_767);
      directions[slot] = Math.round((normals[at] ?? 0) * 127);
    }
    const box = bounds(places.filter((_, slot) => slot % 4 < 3));
    const vector = { count, type: 'VEC3', normalized: true };
    const attributes = {
      POSITION: gltf.accessor(
        places,
        { ...vector, componentType: SHORT, ...box },
        { byteStride: 8 },
      ),
      NORMAL: gltf.accessor(directions, { ...vector, componentType: BYTE }, { byteStride: 4 }),
    };
    gltf.addPrimitive(attributes, indices);
  }
  const used = ['KHR_mesh_quantization'];
  Object.assign(gltf.json, { extensionsUsed: used, extensionsRequired: used });
  return gltf;
}

function texturedSpheres(count = 4, size = TEXTURE_SIZE) {
  const gltf = new Gltf();
  const row = Math.sqrt(count);
  const numbers = Array.from({ length: count }, (_, i) => i);
  texture(
    gltf,
    numbers.map((i) => noisePng(size, i + 1)),
    numbers.map((source) => ({ source })),
  );
  numbers.forEach((material) => {
    const translation = [2.2 * (material % row), 2.2 * Math.floor(material / row), 0];
    gltf.add(bumpySphere(48, 24), { material }, { translation });
  });
  return gltf;
}

/**
 * Adds images and a material for each texture. @param {Gltf} gltf @param {readonly Uint8Array[]}
 * pngs @param {readonly object[]} textures
 */
const texture = (gltf, pngs, textures) =>
  Object.assign(gltf.json, {
    images: pngs.map((file) => ({ mimeType: 'image/png', bufferView: gltf.view(file) })),
    textures,
    materials: textures.map((_, index) => ({
      pbrMetallicRoughness: { baseColorTexture: { index }, metallicFactor: 0 },
    })),
  });

/** @param {Grid} grid */
function textStl({ positions, normals, indices }) {
  /** @param {Float32Array} list @param {number} i */
  const at = (list, i) => list.subarray(3 * i, 3 * i + 3).join(' ');
  let text = 'solid sphere\n';
  for (let i = 0; i < indices.length; i += 3) {
    const corners = [...indices.subarray(i, i + 3)].map(
      (corner) => `vertex ${at(positions, corner)}\n`,
    );
    text += `facet normal ${at(normals, indices[i] ?? 0)}\nouter loop\n${corners.join('')}endloop\nendfacet\n`;
  }
  return `${text}endsolid sphere\n`;
}

/** @param {Grid} grid */
function binaryPly({ positions, indices }) {
  const header = [
    'ply',
    'format binary_little_endian 1.0',
    `element vertex ${positions.length / 3}`,
    ...['x', 'y', 'z'].map((axis) => `property float ${axis}`),
    `element face ${indices.length / 3}`,
    'property list uchar int vertex_indices',
    'end_header',
    '',
  ].join('\n');
  const faces = Buffer.alloc((13 * indices.length) / 3, 3);
  indices.forEach((corner, i) =>
    faces.writeUInt32LE(corner, 13 * Math.floor(i / 3) + 1 + 4 * (i % 3)),
  );
  return Buffer.concat([Buffer.from(header), Buffer.from(positions.buffer), faces]);
}

/**
 * A texture so small that each texel covers several pixels: its sampling is exact without smaller
 * levels.
 */
function checkedSphere() {
  const gltf = new Gltf();
  Object.assign(gltf.json, { samplers: [{ magFilter: LINEAR, minFilter: LINEAR }] });
  texture(gltf, [png(CHECKS_SIZE, checks)], [{ source: 0, sampler: 0 }]);
  gltf.add(bumpySphere(64, 32), { material: 0 });
  return gltf;
}

/** Two colours in squares of 4 texels. @param {number} x @param {number} y */
const checks = (x, y) => (((x >> 2) + (y >> 2)) % 2 === 0 ? [230, 200, 120] : [60, 90, 150]);

function manyParts() {
  const gltf = new Gltf();
  Object.assign(gltf.json, {
    materials: Array.from({ length: 10 }, (_, i) => ({
      pbrMetallicRoughness: { baseColorFactor: [0.1 * i, 0.5, 1 - 0.1 * i, 1], metallicFactor: 0 },
    })),
  });
  for (let i = 0; i < PARTS; i++) {
    const translation = [i % 10, Math.floor(i / 10) % 10, Math.floor(i / 100)];
    gltf.add(bumpySphere(10, 6), { material: i % 10 }, { translation, scale: [0.45, 0.45, 0.45] });
  }
  return gltf;
}

/**
 * An RGB picture of stripes under noise of 8 levels, so that it shrinks to about a third as
 * photographs do. @param {number} size @param {number} seed
 */
function noisePng(size, seed) {
  let state = seed;
  return png(size, (x) => {
    state = (Math.imul(state, 1_664_525) + 1_013_904_223) >>> 0;
    const light = 96 + 64 * ((x >> 6) % 2) + 8 * (state >>> 29);
    return [light, light - 10 * (seed % 8), light - 40];
  });
}

/**
 * A square RGB picture. @param {number} size @param {(x: number, y: number) => number[]} colorAt
 * row by row
 */
function png(size, colorAt) {
  // Only now: measuring built pages needs the names of models, and no package.
  const { PNG } = /** @type {typeof import('pngjs')} */ (createRequire(import.meta.url)('pngjs'));
  const picture = new PNG({ width: size, height: size });
  for (let y = 0; y < size; y++) {
    for (let x = 0; x < size; x++) {
      picture.data.set([...colorAt(x, y), 255], 4 * (y * size + x));
    }
  }
  return PNG.sync.write(picture, {
    colorType: 2,
    filterType: 0,
    deflateLevel: 6,
    deflateStrategy: 0,
  });
}
