// Small glTF documents for tests, as data: addresses: one curved patch with normals, tangents and two sets of texture
// coordinates, and textures made of texels.
import { PNG } from 'pngjs';
import { viewsOf } from '../fuzz/glb.js';

export type Texel = readonly [number, number, number, number?];

export interface PatchOptions {
  /** The material, as in glTF; textures refer to `textures` by index. */
  readonly material: Readonly<Record<string, unknown>>;
  /** Square textures, row by row. */
  readonly textures?: readonly (readonly Texel[])[];
  /** Whether textures have smaller levels. Default false: they are sampled at full size. */
  readonly mipmaps?: boolean;
  /** Whether the file has tangents of its own. Default false. */
  readonly tangents?: boolean;
  /** The node's matrix. */
  readonly matrix?: readonly number[];
}

const FLOAT = 5126;
const USHORT = 5123;
const LINEAR = 9729;
const LINEAR_MIPMAP_LINEAR = 9987;
/** Quads along each side. */
const CELLS = 2;

/** The address of a patch of edge 2 in xy, bent about y: it faces +z in its middle. */
export function patch(options: PatchOptions): string {
  const { material, textures = [], mipmaps = false, tangents = false, matrix } = options;
  const vertices = Array.from({ length: (CELLS + 1) ** 2 }, (_, i) => {
    const u = (i % (CELLS + 1)) / CELLS;
    const v = Math.floor(i / (CELLS + 1)) / CELLS;
    const angle = (u - 0.5) * 0.9;
    return {
      POSITION: [2 * u - 1, 1 - 2 * v, 0.3 * Math.cos(angle)],
      NORMAL: [Math.sin(angle), 0, Math.cos(angle)],
      TEXCOORD_0: [u, v],
      TEXCOORD_1: [1.5 * v, u + 0.25],
      // N × T points up the image, as green does.
      TANGENT: [Math.cos(angle), 0, -Math.sin(angle), 1],
    };
  });
  const indices = Array.from({ length: CELLS * CELLS }, (_, i) => {
    const at = (i % CELLS) + Math.floor(i / CELLS) * (CELLS + 1);
    return [at, at + CELLS + 1, at + 1, at + 1, at + CELLS + 1, at + CELLS + 2];
  }).flat();
  const names = ['POSITION', 'NORMAL', 'TEXCOORD_0', 'TEXCOORD_1', ...(tangents ? ['TANGENT'] : [])] as const;
  const views = names.map((name) =>
    Buffer.from(new Float32Array(vertices.flatMap((vertex) => vertex[name as keyof typeof vertex])).buffer),
  );
  views.push(Buffer.from(new Uint16Array(indices).buffer));
  const { bufferViews, buffers, body } = viewsOf(views);
  const data = (type: string, bytes: Buffer): string => `data:${type};base64,${bytes.toString('base64')}`;
  const attributes = Object.fromEntries(names.map((name, i) => [name, i]));
  const primitive = { attributes, indices: names.length, material: 0 };
  const document = {
    asset: { version: '2.0' },
    scenes: [{ nodes: [0] }],
    nodes: [{ mesh: 0, ...(matrix === undefined ? {} : { matrix }) }],
    meshes: [{ primitives: [primitive] }],
    materials: [{ doubleSided: true, ...material }],
    textures: textures.map((_, source) => ({ source, sampler: 0 })),
    samplers: [{ magFilter: LINEAR, minFilter: mipmaps ? LINEAR_MIPMAP_LINEAR : LINEAR }],
    images: textures.map((texels) => ({ uri: data('image/png', pngOf(texels)) })),
    accessors: [
      ...names.map((_, i) => ({
        bufferView: i,
        componentType: FLOAT,
        count: vertices.length,
        type: ['VEC3', 'VEC3', 'VEC2', 'VEC2', 'VEC4'][i],
      })),
      { bufferView: names.length, componentType: USHORT, count: indices.length, type: 'SCALAR' },
    ],
    bufferViews,
    buffers: [{ ...buffers[0], uri: data('application/octet-stream', body) }],
  };
  return data('model/gltf+json', Buffer.from(JSON.stringify(document)));
}

function pngOf(texels: readonly Texel[]): Buffer {
  const size = Math.sqrt(texels.length);
  const png = new PNG({ width: size, height: size });
  texels.forEach(([r, g, b, a = 255], i) => png.data.set([r, g, b, a], 4 * i));
  return PNG.sync.write(png);
}
