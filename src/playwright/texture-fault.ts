// Finds pixels whose texture shadeAt cannot explain to the last code: it samples without mipmaps, at the pixel's exact
// centre.
import { dot, subtract, type Vec3 } from '../math/vector.js';
import type { PhongViewer } from '../index.js';

/** What shadeAt gives for a point of a surface. */
export type Explained = NonNullable<Awaited<ReturnType<PhongViewer['shadeAt']>>>;

type Attribute = { getX(i: number): number; getY(i: number): number; getZ(i: number): number };

type Mapped = {
  isTexture?: boolean;
  channel: number;
  matrix: { elements: number[] };
  magFilter: number;
  image: { width: number; height: number };
};

type Pair = readonly [number, number];

/** three.js's constant. */
const NEAREST_FILTER = 1003;

/** Texels to a pixel at which minification may begin: 1, or 2^0.5 with some filters; and a reserve. */
const MOST_TEXELS = 0.7;

/**
 * Whether several texels share a pixel (`minified`), or the device may be on another texel (`edges`), in any texture of
 * the surface.
 * @param steps in world space, from the point to those one pixel to the right and one below.
 */
export function textureFault(
  here: Explained,
  steps: readonly Vec3[],
  subpixelBits: number,
): 'minified' | 'edges' | null {
  const textures = texturesOf(here);
  if (textures.length === 0) return null;
  const object = here.object as typeof here.object & { isSkinnedMesh?: boolean };
  // Their vertices are elsewhere than in the geometry.
  if (object.isSkinnedMesh === true || (object.morphTargetInfluences?.length ?? 0) > 0) return 'minified';
  const corners = cornersOf(here);
  let fault: 'edges' | null = null;
  for (const texture of textures) {
    const texels = texelsOf(texture, here, corners);
    if (texels === null) continue;
    const along = steps.map((step) => texelsAlong(step, corners, texels));
    if (along.some(([u, v]) => Math.hypot(u, v) > MOST_TEXELS)) return 'minified';
    if (texture.magFilter !== NEAREST_FILTER) continue;
    const from = texelsAlong(subtract(here.p, corners.a), corners, texels);
    for (const axis of [0, 1] as const) {
      const at = texels[0][axis] + from[axis];
      const reach = along.reduce((sum, step) => sum + Math.abs(step[axis]), 0) * 2 ** -subpixelBits;
      if (Math.abs(at - Math.round(at)) <= reach) fault = 'edges';
    }
  }
  return fault;
}

export const isTextured = (here: Explained): boolean => texturesOf(here).length > 0;

function texturesOf({ object }: Explained): readonly Mapped[] {
  const { look } = object.material as unknown as { look?: object };
  return Object.values(look ?? {}).filter(
    (value: unknown): value is Mapped => (value as Mapped | null)?.isTexture === true,
  );
}

/** The triangle: its vertices' numbers, its first corner and its edges from there, in world space. */
interface Corners {
  readonly vertices: readonly [number, number, number];
  readonly a: Vec3;
  readonly e: Vec3;
  readonly f: Vec3;
}

function cornersOf({ object: { geometry, matrixWorld }, triangle }: Explained): Corners {
  const m = matrixWorld.elements;
  const position = geometry.getAttribute('position') as Attribute;
  const vertexOf = (k: number): number => geometry.index?.getX(3 * triangle + k) ?? 3 * triangle + k;
  const vertices = [vertexOf(0), vertexOf(1), vertexOf(2)] as const;
  const [a, b, c] = vertices.map((i): Vec3 => {
    const [x, y, z] = [position.getX(i), position.getY(i), position.getZ(i)];
    const axis = (k: 0 | 1 | 2): number => m[k] * x + m[4 + k]! * y + m[8 + k]! * z + m[12 + k]!;
    return [axis(0), axis(1), axis(2)];
  }) as [Vec3, Vec3, Vec3];
  return { vertices, a, e: subtract(b, a), f: subtract(c, a) };
}

/** Column and row of the texture at each corner; null where the geometry has no coordinates for it. */
function texelsOf(
  { channel, matrix, image }: Mapped,
  { object: { geometry } }: Explained,
  { vertices }: Corners,
): readonly [Pair, Pair, Pair] | null {
  const uv = geometry.getAttribute(channel === 0 ? 'uv' : `uv${String(channel)}`) as Attribute | undefined;
  if (uv === undefined) return null;
  const t = matrix.elements;
  const texel = (i: number): Pair => [
    (t[0]! * uv.getX(i) + t[3]! * uv.getY(i) + t[6]!) * image.width,
    (t[1]! * uv.getX(i) + t[4]! * uv.getY(i) + t[7]!) * image.height,
  ];
  return [texel(vertices[0]), texel(vertices[1]), texel(vertices[2])];
}

/** Texels along a vector of the triangle's plane. */
function texelsAlong(step: Vec3, { e, f }: Corners, [ta, tb, tc]: readonly [Pair, Pair, Pair]): Pair {
  const [ee, ef, ff, se, sf] = [dot(e, e), dot(e, f), dot(f, f), dot(step, e), dot(step, f)];
  const [v, w] = [ff * se - ef * sf, ee * sf - ef * se];
  const along = (axis: 0 | 1): number =>
    (v * (tb[axis] - ta[axis]) + w * (tc[axis] - ta[axis])) / (ee * ff - ef * ef);
  return [along(0), along(1)];
}
