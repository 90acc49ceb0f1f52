// Do the less common shapes of a glTF document come out right: quantised, interleaved, shared, skinned, in strips,
// with moved textures? Documents are written here and loaded as data: addresses.
import { afterEach, describe, expect, it, vi } from 'vitest';
import { pngOf } from '../fuzz/glb.js';
import { bitmapOf } from './model-files.js';
import type { Content } from '../../src/model/model.js';
import { FLOAT, gltf, type Json, mesh, numbers, SHORT, TRIANGLE, UBYTE } from './gltf-files.js';

afterEach(() => {
  vi.unstubAllGlobals();
});

describe('attributes', () => {
  it('may be normalised integers, interleaved, the last element without its padding', async () => {
    const values = new Int16Array([0, 0, 0, 99, 32767, 0, 0, 99, 0, 32767, 0]);
    const model = await gltf(
      [values],
      [{ bufferView: 0, type: 'VEC3', count: 3, componentType: SHORT, normalized: true }],
      { ...mesh({ POSITION: 0 }), strides: [8], extensionsRequired: ['KHR_mesh_quantization'] },
    );
    expect(numbers(model, 'position')).toEqual(TRIANGLE);
  });

  it('have their normals normalised, and those without a direction computed anew', async () => {
    const model = await gltf(
      [new Float32Array(TRIANGLE), new Float32Array([0, 3 * 2 ** 100, 4 * 2 ** 100, NaN, 0, 1, 0, 0, 0])],
      [
        { bufferView: 0, type: 'VEC3', count: 3, componentType: FLOAT },
        { bufferView: 1, type: 'VEC3', count: 3, componentType: FLOAT },
      ],
      mesh({ POSITION: 0, NORMAL: 1 }),
    );
    expect(numbers(model, 'normal')).toEqual([0, 0.6, 0.8, 0, 0, 1, 0, 0, 1].map(Math.fround));
  });

  it('must be as many as there are vertices, and triangles must name vertices that exist', async () => {
    const position = { bufferView: 0, type: 'VEC3', count: 3, componentType: FLOAT };
    const fewer = { bufferView: 0, type: 'VEC3', count: 2, componentType: FLOAT };
    const blob = new Float32Array(TRIANGLE);
    await expect(gltf([blob], [position, fewer], mesh({ POSITION: 0, NORMAL: 1 }))).rejects.toThrow(
      /fewer normal/,
    );
    const index = { bufferView: 1, type: 'SCALAR', count: 3, componentType: UBYTE };
    await expect(
      gltf([blob, new Uint8Array([0, 1, 3])], [position, index], mesh({ POSITION: 0 }, { indices: 1 })),
    ).rejects.toThrow(/vertex 3 of 3/);
  });

  it('may have strided indices', async () => {
    const model = await gltf(
      [new Float32Array(TRIANGLE), new Uint16Array([2, 9, 1, 9, 0, 9])],
      [
        { bufferView: 0, type: 'VEC3', count: 3, componentType: FLOAT },
        { bufferView: 1, type: 'SCALAR', count: 3, componentType: 5123 },
      ],
      { ...mesh({ POSITION: 0, NORMAL: 0 }, { indices: 1 }), strides: [12, 4] },
    );
    expect(Array.from(model.parts[0]?.geometry.index?.array ?? [])).toEqual([2, 1, 0]);
  });

  it('may form a fan, whose triangles share the first vertex', async () => {
    const model = await gltf(
      [new Float32Array([0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0])],
      [{ bufferView: 0, type: 'VEC3', count: 4, componentType: FLOAT }],
      mesh({ POSITION: 0, NORMAL: 0 }, { mode: 6 }),
    );
    expect(Array.from(model.parts[0]?.geometry.index?.array ?? [])).toEqual([1, 2, 0, 2, 3, 0]);
  });

  it('may form a strip, in which every second triangle is reversed', async () => {
    const model = await gltf(
      [new Float32Array([0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0])],
      [{ bufferView: 0, type: 'VEC3', count: 4, componentType: FLOAT }],
      mesh({ POSITION: 0 }, { mode: 5 }),
    );
    expect(numbers(model, 'position')).toHaveLength(18);
    expect(numbers(model, 'normal').filter((_, i) => i % 3 === 2)).toEqual([1, 1, 1, 1, 1, 1]);
  });
});

describe('nodes', () => {
  const position = { bufferView: 0, type: 'VEC3', count: 3, componentType: FLOAT };

  it('that share a mesh share its geometry, each with its own matrix', async () => {
    const model = await gltf([new Float32Array(TRIANGLE)], [position], {
      ...mesh({ POSITION: 0 }),
      scenes: [{ nodes: [0] }],
      nodes: [
        { name: 'pair', translation: [0, 0, 1e8], children: [1, 2] },
        { mesh: 0, name: 'one', translation: [0.1, 0, 0] },
        { mesh: 0, name: 'two: mirrored', scale: [-1, 1, 1] },
      ],
    });
    const [one, two] = model.parts;
    expect(one?.geometry).toBe(two?.geometry);
    expect([one?.name, two?.name]).toEqual(['one', 'two: mirrored']);
    expect(one?.matrix.elements.slice(12)).toEqual([0.1, 0, 1e8, 1]);
    expect(two?.matrix.determinant()).toBeCloseTo(-1, 12);
  });

  it('of other scenes are not shown', async () => {
    const model = await gltf([new Float32Array(TRIANGLE)], [position], {
      ...mesh({ POSITION: 0 }),
      scene: 1,
      scenes: [{ nodes: [0] }, { nodes: [1] }],
      nodes: [
        { mesh: 0, name: 'hidden' },
        { mesh: 0, name: 'shown' },
      ],
    });
    expect(model.parts.map(({ name }) => name)).toEqual(['shown']);
  });

  it('with a skin take the pose of their joints, wherever the node itself is', async () => {
    const half = Math.SQRT1_2;
    const model = await gltf(
      [
        new Float32Array(TRIANGLE),
        new Float32Array([0, 0, 1, 0, 0, 1, 0, 0, 1]),
        new Uint8Array([0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0]),
        new Float32Array([1, 0, 0, 0, 1, 0, 0, 0, 0.5, 0.5, 0, 0]),
      ],
      [
        position,
        { bufferView: 1, type: 'VEC3', count: 3, componentType: FLOAT },
        { bufferView: 2, type: 'VEC4', count: 3, componentType: UBYTE },
        { bufferView: 3, type: 'VEC4', count: 3, componentType: FLOAT },
      ],
      {
        ...mesh({ POSITION: 0, NORMAL: 1, JOINTS_0: 2, WEIGHTS_0: 3 }),
        scenes: [{ nodes: [0, 1, 2] }],
        nodes: [
          { mesh: 0, skin: 0, translation: [50, 50, 50] },
          { translation: [10, 0, 0], rotation: [half, 0, 0, half] },
          { translation: [20, 0, 0], rotation: [half, 0, 0, half] },
        ],
        skins: [{ joints: [1, 2] }],
      },
    );
    // A quarter turn about x brings y to z and z to -y.
    const expected = [10, 0, 0, 11, 0, 0, 15, 0, 1];
    numbers(model, 'position').forEach((value, i) => {
      expect(value).toBeCloseTo(expected[i] ?? NaN, 5);
    });
    numbers(model, 'normal').forEach((value, i) => {
      expect(value).toBeCloseTo([0, -1, 0][i % 3] ?? NaN, 6);
    });
    expect(model.parts[0]?.matrix.elements).toEqual([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]);
  });
});

describe('textures', () => {
  // The head of a PNG of 1 × 1 pixels; the rest is up to the decoder, which is a stand-in here.
  const image = `data:image/png;base64,${pngOf(1, 1, 32).toString('base64')}`;
  const uvs = (texCoord: Json): Promise<Content> =>
    gltf(
      [
        new Float32Array(TRIANGLE),
        new Float32Array([9, 9, 9, 9, 9, 9]),
        new Float32Array([0, 0, 1, 0, 0, 1]),
      ],
      [
        { bufferView: 0, type: 'VEC3', count: 3, componentType: FLOAT },
        { bufferView: 1, type: 'VEC2', count: 3, componentType: FLOAT },
        { bufferView: 2, type: 'VEC2', count: 3, componentType: FLOAT },
      ],
      {
        ...mesh({ POSITION: 0, TEXCOORD_0: 1, TEXCOORD_1: 2 }, { material: 0 }),
        materials: [
          {
            pbrMetallicRoughness: { baseColorTexture: { index: 0, ...texCoord } },
            occlusionTexture: { index: 1 },
          },
        ],
        textures: [{ source: 0 }, { source: 1 }],
        images: [{ uri: image }, { uri: 'https://example.com/never-asked-for.png' }],
        extensionsUsed: ['KHR_texture_transform'],
      },
    );

  it('use the coordinates and the transform that the file names, and unused ones are not fetched', async () => {
    vi.stubGlobal('createImageBitmap', bitmapOf);
    const model = await uvs({
      texCoord: 1,
      extensions: { KHR_texture_transform: { offset: [0.25, 0.5], scale: [2, 3] } },
    });
    expect(numbers(model, 'uv1')).toEqual([0, 0, 1, 0, 0, 1]);
    const map = model.parts[0]?.look.map;
    expect(map?.channel).toBe(1);
    expect(map?.matrix.elements.map((value) => value + 0)).toEqual([2, 0, 0, 0, 3, 0, 0.25, 0.5, 1]);
  });

  it('keep their coordinates where two meshes share one material', async () => {
    vi.stubGlobal('createImageBitmap', bitmapOf);
    const primitive = (position: number): Json => ({
      attributes: { POSITION: position, TEXCOORD_0: 1, TEXCOORD_1: 2 },
      material: 0,
    });
    const model = await gltf(
      [
        new Float32Array(TRIANGLE),
        new Float32Array([9, 9, 9, 9, 9, 9]),
        new Float32Array([0, 0, 1, 0, 0, 1]),
      ],
      [
        { bufferView: 0, type: 'VEC3', count: 3, componentType: FLOAT },
        { bufferView: 1, type: 'VEC2', count: 3, componentType: FLOAT },
        { bufferView: 2, type: 'VEC2', count: 3, componentType: FLOAT },
        { bufferView: 0, type: 'VEC3', count: 3, componentType: FLOAT },
      ],
      {
        meshes: [{ primitives: [primitive(0), primitive(3)] }],
        materials: [{ pbrMetallicRoughness: { baseColorTexture: { index: 0, texCoord: 1 } } }],
        textures: [{ source: 0 }],
        images: [{ uri: image }],
      },
    );
    expect(model.parts).toHaveLength(2);
    for (const part of [0, 1]) expect(numbers(model, 'uv1', part)).toEqual([0, 0, 1, 0, 0, 1]);
  });

  it('are closed when another part of the model fails', async () => {
    const close = vi.fn();
    vi.stubGlobal('createImageBitmap', (blob: Blob) => bitmapOf(blob, close));
    await expect(
      gltf(
        [new Float32Array([NaN, 0, 0, 1, 0, 0, 0, 1, 0])],
        [{ bufferView: 0, type: 'VEC3', count: 3, componentType: FLOAT }],
        {
          ...mesh({ POSITION: 0 }, { material: 0 }),
          materials: [{ pbrMetallicRoughness: { baseColorTexture: { index: 0 } } }],
          textures: [{ source: 0 }],
          images: [{ uri: image }],
        },
      ),
    ).rejects.toMatchObject({ code: 'bad-model' });
    await expect.poll(() => close).toHaveBeenCalledTimes(1);
  });
});

describe('sides', () => {
  it('are single unless the material says double, and single without a material', async () => {
    const corners = { type: 'VEC3', count: 3, componentType: FLOAT, bufferView: 0 };
    const part = (material?: number): Json => ({ attributes: { POSITION: 0 }, material });
    const model = await gltf([new Float32Array(TRIANGLE)], [corners], {
      materials: [{ doubleSided: true }, { doubleSided: false }, {}],
      meshes: [{ primitives: [part(0), part(1), part(2), part()] }],
    });
    expect(model.parts.map(({ sides }) => sides)).toEqual(['double', 'single', 'single', 'single']);
  });
});
