// Do the less common shapes of a glTF document come out right: quantised, interleaved, shared, skinned, in strips,
// with moved textures? Documents are written here and loaded as data: addresses.
import { afterEach, describe, expect, it, vi } from 'vitest';
import { type Json, pngOf } from '../fuzz/glb.js';
import { FLOAT, gltf, mesh, numbers, SHORT, TRIANGLE, UBYTE } from './gltf-files.js';
import { bitmapOf, indexOf, view } from './model-files.js';

const POSITION = view(0, 'VEC3');
const triangle = new Float32Array(TRIANGLE);

afterEach(() => {
  vi.unstubAllGlobals();
});

describe('attributes', () => {
  it('may be normalised integers, interleaved, the last element without its padding', async () => {
    const values = new Int16Array([0, 0, 0, 99, 32767, 0, 0, 99, 0, 32767, 0]);
    const model = await gltf([values], [{ ...view(0, 'VEC3', SHORT), normalized: true }], {
      ...mesh({ POSITION: 0 }),
      strides: [8],
      extensionsRequired: ['KHR_mesh_quantization'],
    });
    expect(numbers(model, 'position')).toEqual(TRIANGLE);
  });

  it('must be as many as there are vertices, and triangles must name vertices that exist', async () => {
    const fewer = view(0, 'VEC3', FLOAT, 2);
    await expect(gltf([triangle], [POSITION, fewer], mesh({ POSITION: 0, NORMAL: 1 }))).rejects.toThrow(/fewer normal/);
    const indexed = mesh({ POSITION: 0 }, { indices: 1 });
    await expect(
      gltf([triangle, new Uint8Array([0, 1, 3])], [POSITION, view(1, 'SCALAR', UBYTE)], indexed),
    ).rejects.toThrow(/vertex 3 of 3/);
  });

  it('may have strided indices', async () => {
    const model = await gltf([triangle, new Uint16Array([2, 9, 1, 9, 0, 9])], [POSITION, view(1, 'SCALAR', 5123)], {
      ...mesh({ POSITION: 0, NORMAL: 0 }, { indices: 1 }),
      strides: [12, 4],
    });
    expect(indexOf(model)).toEqual([2, 1, 0]);
  });

  it.each([
    ['fan, whose triangles share the first vertex', 6, [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0]],
    ['strip, in which every second triangle is reversed', 5, [0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0]],
  ])('may form a %s', async (_, mode, square) => {
    const positions = [new Float32Array(square)];
    const model = await gltf(positions, [view(0, 'VEC3', FLOAT, 4)], mesh({ POSITION: 0 }, { mode }));
    expect(numbers(model, 'position')).toHaveLength(18);
    expect(numbers(model, 'normal').filter((_, i) => i % 3 === 2)).toEqual([1, 1, 1, 1, 1, 1]);
  });
});

it('nodes that share a mesh share its geometry, each with its own matrix, and those of other scenes are not shown', async () => {
  const model = await gltf([triangle], [POSITION], {
    ...mesh({ POSITION: 0 }),
    scene: 1,
    scenes: [{ nodes: [3] }, { nodes: [0] }],
    nodes: [
      { name: 'pair', translation: [0, 0, 1e8], children: [1, 2] },
      { mesh: 0, name: 'one', translation: [0.1, 0, 0] },
      { mesh: 0, name: 'two: mirrored', scale: [-1, 1, 1] },
      { mesh: 0, name: 'hidden' },
    ],
  });
  const [one, two] = model.parts;
  expect(model.parts.map(({ name }) => name)).toEqual(['one', 'two: mirrored']);
  expect(one?.geometry).toBe(two?.geometry);
  expect(one?.matrix.elements.slice(12)).toEqual([0.1, 0, 1e8, 1]);
  expect(two?.matrix.determinant()).toBeCloseTo(-1, 12);
});

describe('textures', () => {
  // The head of a PNG of 1 × 1 pixels; the rest is up to the decoder, which is a stand-in here.
  const image = `data:image/png;base64,${pngOf(1, 1, 32).toString('base64')}`;

  it('use the coordinates and the transform that the file names, in all meshes, and unused ones are not fetched', async () => {
    vi.stubGlobal('createImageBitmap', bitmapOf);
    const primitive = (position: number): Json => ({
      attributes: { POSITION: position, TEXCOORD_0: 1, TEXCOORD_1: 2 },
      material: 0,
    });
    const moved = { KHR_texture_transform: { offset: [0.25, 0.5], scale: [2, 3] } };
    const baseColorTexture = { index: 0, texCoord: 1, extensions: moved };
    const model = await gltf(
      [triangle, new Float32Array(6).fill(9), new Float32Array([0, 0, 1, 0, 0, 1])],
      [POSITION, view(1, 'VEC2'), view(2, 'VEC2'), POSITION],
      {
        meshes: [{ primitives: [primitive(0), primitive(3)] }],
        materials: [{ pbrMetallicRoughness: { baseColorTexture }, occlusionTexture: { index: 1 } }],
        textures: [{ source: 0 }, { source: 1 }],
        images: [{ uri: image }, { uri: 'https://example.com/never-asked-for.png' }],
        extensionsUsed: ['KHR_texture_transform'],
      },
    );
    expect(model.parts).toHaveLength(2);
    for (const [part, { look }] of model.parts.entries()) {
      expect(numbers(model, 'uv1', part)).toEqual([0, 0, 1, 0, 0, 1]);
      expect(look.map?.channel).toBe(1);
      const matrix = look.map?.matrix.elements.map((value) => value + 0);
      expect(matrix).toEqual([2, 0, 0, 0, 3, 0, 0.25, 0.5, 1]);
    }
  });

  it('are closed when another part of the model fails', async () => {
    const close = vi.fn();
    vi.stubGlobal('createImageBitmap', (blob: Blob) => bitmapOf(blob, close));
    const broken = gltf([new Float32Array([NaN, 0, 0, 1, 0, 0, 0, 1, 0])], [POSITION], {
      ...mesh({ POSITION: 0 }, { material: 0 }),
      materials: [{ pbrMetallicRoughness: { baseColorTexture: { index: 0 } } }],
      textures: [{ source: 0 }],
      images: [{ uri: image }],
    });
    await expect(broken).rejects.toMatchObject({ code: 'bad-model' });
    await expect.poll(() => close).toHaveBeenCalledTimes(1);
  });
});

it('sides are single unless the material says double, and single without a material', async () => {
  const part = (material?: number): Json => ({ attributes: { POSITION: 0 }, material });
  const model = await gltf([triangle], [POSITION], {
    materials: [{ doubleSided: true }, { doubleSided: false }, {}],
    meshes: [{ primitives: [part(0), part(1), part(2), part()] }],
  });
  expect(model.parts.map(({ sides }) => sides)).toEqual(['double', 'single', 'single', 'single']);
});
