// Small glTF documents for tests, as data: addresses: one curved patch with normals, tangents and
// two sets of texture coordinates, and textures made of texels.
import { PNG } from 'pngjs';
import { Gltf } from '../bench/glb.mjs';

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
  const gltf = new Gltf();
  const list = (name: keyof (typeof vertices)[number], type: string) => {
    const values = Float32Array.from(vertices.flatMap((vertex) => vertex[name]));
    return gltf.accessor(values, { componentType: FLOAT, count: vertices.length, type });
  };
  const attributes = {
    POSITION: list('POSITION', 'VEC3'),
    NORMAL: list('NORMAL', 'VEC3'),
    TEXCOORD_0: list('TEXCOORD_0', 'VEC2'),
    TEXCOORD_1: list('TEXCOORD_1', 'VEC2'),
    ...(tangents && { TANGENT: list('TANGENT', 'VEC4') }),
  };
  gltf.addPrimitive(attributes, Uint16Array.from(indices), { material: 0 }, matrix && { matrix });
  const data = (type: string, bytes: Uint8Array) =>
    `data:${type};base64,${Buffer.from(bytes).toString('base64')}`;
  Object.assign(gltf.json, {
    materials: [{ doubleSided: true, ...material }],
    textures: textures.map((_, source) => ({ source, sampler: 0 })),
    samplers: [{ magFilter: LINEAR, minFilter: mipmaps ? LINEAR_MIPMAP_LINEAR : LINEAR }],
    images: textures.map((texels) => ({ uri: data('image/png', pngOf(texels)) })),
  });
  const [, bin] = gltf.pair('');
  const [json] = gltf.pair(data('application/octet-stream', bin));
  return data('model/gltf+json', Buffer.from(json));
}

function pngOf(texels: readonly Texel[]) {
  const size = Math.sqrt(texels.length);
  const png = new PNG({ width: size, height: size });
  texels.forEach(([r, g, b, a = 255], i) => png.data.set([r, g, b, a], 4 * i));
  return PNG.sync.write(png);
}
