// Which pixels of a viewer's picture differ from what shadeAt explains? Runs inside the page: the function is sent there as text, so
// it must not use anything outside itself. Positions are device pixels from the top left, colours 8-bit codes.
import type { LightValues } from '../light/light-state.js';
import type { Vec3 } from '../math/vector.js';
import type { PhongViewer } from '../index.js';

/** What the equation takes at one pixel, as `shadeAt` gives it. */
export interface Point {
  readonly p: Vec3;
  readonly N: Vec3;
  readonly ka: Vec3;
  readonly kd: Vec3;
  readonly ks: Vec3;
  readonly shininess: number;
  readonly emissive: Vec3;
  readonly sum: Vec3;
}

/** A pixel that is more codes off than allowed at its centre. */
export interface Suspect {
  readonly x: number;
  readonly y: number;
  /** r, g, b, a. */
  readonly drawn: readonly number[];
  /** 255 times the colour by the equation, not rounded. */
  readonly expected: Vec3;
  readonly reflection: 'phong' | 'blinn-phong';
  /** The sum is interpolated (Gouraud shading) or independent of the lights (unlit). */
  readonly interpolated: boolean;
  readonly here: Point;
  /** One pixel to the right, and one pixel down, on the same face. */
  readonly right: Point;
  readonly below: Point;
}

export interface Judgement {
  readonly width: number;
  readonly height: number;
  /** Bits of the grid that the device moves vertices to. */
  readonly subpixelBits: number;
  /** Pixels that show a Phong-lit surface, without the picture's border. */
  readonly surface: number;
  readonly judged: number;
  /** Pixels of surfaces that are not judged, by reason: edges of triangles or texels, opacity, textures. */
  readonly edges: number;
  readonly translucent: number;
  readonly minified: number;
  readonly suspects: readonly Suspect[];
  /** All of them; `suspects` holds the first `most`. */
  readonly suspectCount: number;
  readonly eye: Vec3;
  readonly target: Vec3;
  readonly up: Vec3;
  readonly terms: readonly ('ambient' | 'diffuse' | 'specular')[];
  readonly linear: boolean;
  /** Empty for the head-light. */
  readonly lights: readonly LightValues[];
}

export interface JudgeOptions {
  readonly codes: number;
  /** Suspects returned at most. */
  readonly most: number;
  /** Names of a light's values. */
  readonly lightKeys: readonly string[];
}

/**
 * Judges a pixel if its four neighbours show the same triangle: the diamond between their centres contains the pixel's square.
 * Translucent surfaces are left out, because shadeAt explains them without what lies behind, and so are textures where several
 * texels share a pixel, because it samples without mipmaps. Borders of texels that are not filtered count as edges.
 */
export async function judgeInPage(
  viewer: PhongViewer,
  { codes, most, lightKeys }: JudgeOptions,
): Promise<Judgement> {
  // three.js's constant.
  const NEAREST_FILTER = 1003;
  type Explained = NonNullable<Awaited<ReturnType<PhongViewer['shadeAt']>>>;
  if (viewer.antialias === 'highlights')
    throw new Error(
      'antialias="highlights" averages highlights over a pixel, so single points of the equation are not shown',
    );
  const before = JSON.stringify(viewer.camera);
  const bitmap = await createImageBitmap(await viewer.toBlob(), {
    premultiplyAlpha: 'none',
    colorSpaceConversion: 'none',
  });
  const { width, height } = bitmap;
  const canvas = Object.assign(document.createElement('canvas'), { width, height });
  const context = canvas.getContext('2d', { willReadFrequently: true });
  const gl = document.createElement('canvas').getContext('webgl2');
  const surfaceBox = viewer.shadowRoot?.querySelector('[part=surface]');
  if (context === null || gl === null || !surfaceBox) throw new Error('the viewer cannot be drawn here');
  context.drawImage(bitmap, 0, 0);
  const { data } = context.getImageData(0, 0, width, height);
  const subpixelBits = Number(gl.getParameter(gl.SUBPIXEL_BITS));
  gl.getExtension('WEBGL_lose_context')?.loseContext();

  // shadeAt takes CSS pixels of the picture before any transform; inside CSS zoom, those of pointer events.
  const style = getComputedStyle(surfaceBox);
  const zoom = (surfaceBox as { currentCSSZoom?: number }).currentCSSZoom ?? 1;
  const cssX = (parseFloat(style.width) * zoom) / width;
  const cssY = (parseFloat(style.height) * zoom) / height;
  const explain = (x: number, y: number) => viewer.shadeAt((x + 0.5) * cssX, (y + 0.5) * cssY);
  const row = (y: number) => Promise.all(Array.from({ length: width }, (_, x) => explain(x, y)));

  type Attribute = { getX(i: number): number; getY(i: number): number; getZ(i: number): number };
  type Mapped = {
    isTexture?: boolean;
    channel: number;
    matrix: { elements: number[] };
    magFilter: number;
    image: { width: number; height: number };
  };
  const texturesOf = ({ object }: Explained): Mapped[] => {
    const { look } = object.material as unknown as { look?: object };
    return Object.values(look ?? {}).filter(
      (value: unknown): value is Mapped => (value as Mapped | null)?.isTexture === true,
    );
  };
  const sub = (a: Vec3, b: Vec3): Vec3 => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
  const dot = (a: Vec3, b: Vec3): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  /** Whether several texels share a pixel, or the device may be on another texel, in any texture of the surface. */
  const textureFault = (here: Explained, steps: readonly Vec3[]): 'minified' | 'edges' | null => {
    const textures = texturesOf(here);
    if (textures.length === 0) return null;
    const { geometry, matrixWorld, isSkinnedMesh, morphTargetInfluences } =
      here.object as typeof here.object & {
        isSkinnedMesh?: boolean;
      };
    // Their vertices are elsewhere than in the geometry.
    if (isSkinnedMesh === true || (morphTargetInfluences?.length ?? 0) > 0) return 'minified';
    const m = matrixWorld.elements;
    const position = geometry.getAttribute('position') as Attribute;
    const vertices = [0, 1, 2].map(
      (k) => geometry.index?.getX(3 * here.triangle + k) ?? 3 * here.triangle + k,
    ) as [number, number, number];
    const [a, b, c] = vertices.map((i): Vec3 => {
      const [x, y, z] = [position.getX(i), position.getY(i), position.getZ(i)];
      const axis = (k: 0 | 1 | 2): number => m[k] * x + m[4 + k]! * y + m[8 + k]! * z + m[12 + k]!;
      return [axis(0), axis(1), axis(2)];
    }) as [Vec3, Vec3, Vec3];
    const [e, f] = [sub(b, a), sub(c, a)];
    const [ee, ef, ff] = [dot(e, e), dot(e, f), dot(f, f)];
    let fault: 'edges' | null = null;
    for (const { channel, matrix, image, magFilter } of textures) {
      const uv = geometry.getAttribute(channel === 0 ? 'uv' : `uv${String(channel)}`) as
        Attribute | undefined;
      if (uv === undefined) continue;
      const t = matrix.elements;
      /** Column and row of the texture that belong to a vertex. */
      const texel = (i: number): readonly [number, number] => [
        (t[0]! * uv.getX(i) + t[3]! * uv.getY(i) + t[6]!) * image.width,
        (t[1]! * uv.getX(i) + t[4]! * uv.getY(i) + t[7]!) * image.height,
      ];
      const [ta, tb, tc] = [texel(vertices[0]), texel(vertices[1]), texel(vertices[2])];
      /** Texels along a vector of the triangle's plane. */
      const along = (step: Vec3, axis: 0 | 1): number => {
        const [se, sf] = [dot(step, e), dot(step, f)];
        const [v, w] = [ff * se - ef * sf, ee * sf - ef * se];
        return (v * (tb[axis] - ta[axis]) + w * (tc[axis] - ta[axis])) / (ee * ff - ef * ef);
      };
      // Minification begins at one texel a pixel, or at 2^0.5 with some filters.
      if (steps.some((step) => Math.hypot(along(step, 0), along(step, 1)) > 0.7)) return 'minified';
      if (magFilter !== NEAREST_FILTER) continue;
      for (const axis of [0, 1] as const) {
        const at = ta[axis] + along(sub(here.p, a), axis);
        const reach = steps.reduce((sum, step) => sum + Math.abs(along(step, axis)), 0) * 2 ** -subpixelBits;
        if (Math.abs(at - Math.round(at)) <= reach) fault = 'edges';
      }
    }
    return fault;
  };

  const point = ({ p, N, ka, kd, ks, shininess, emissive, sum }: Explained): Point => ({
    ...{ p, N, ka, kd, ks, shininess, emissive, sum },
  });
  const counts = { surface: 0, judged: 0, edges: 0, translucent: 0, minified: 0, suspectCount: 0 };
  const suspects: Suspect[] = [];
  let rows = [await row(0), await row(Math.min(1, height - 1))];
  for (let y = 1; y < height - 1; y++) {
    const [above, line, under] = [rows[0]!, rows[1]!, await row(y + 1)];
    rows = [line, under];
    for (let x = 1; x < width - 1; x++) {
      const here = line[x];
      if (!here) continue;
      counts.surface += 1;
      const [right, below] = [line[x + 1], under[x]];
      const neighbours = [line[x - 1], right, above[x], below];
      if (
        !right ||
        !below ||
        !neighbours.every((one) => one?.object === here.object && one.triangle === here.triangle)
      ) {
        counts.edges += 1;
        continue;
      }
      if (here.opacity < 1) {
        counts.translucent += 1;
        continue;
      }
      const fault = textureFault(here, [sub(right.p, here.p), sub(below.p, here.p)]);
      if (fault !== null) {
        counts[fault] += 1;
        continue;
      }
      counts.judged += 1;
      const drawn = [...data.subarray(4 * (y * width + x), 4 * (y * width + x) + 4)];
      const expected: Vec3 = [255 * here.color[0], 255 * here.color[1], 255 * here.color[2]];
      const off = expected.some((value, channel) => Math.abs(Math.round(value) - drawn[channel]!) > codes);
      if (!off && drawn[3] === 255) continue;
      counts.suspectCount += 1;
      if (suspects.length >= most) continue;
      const own = here.mesh === viewer ? null : here.mesh;
      const interpolated = (own?.shading ?? viewer.shading) === 'gouraud' || here.unlit;
      suspects.push({
        ...{ x, y, drawn, expected, interpolated },
        reflection: own?.reflection ?? viewer.reflection,
        ...{ here: point(here), right: point(right), below: point(below) },
      });
    }
  }
  if (JSON.stringify(viewer.camera) !== before)
    throw new Error('the camera moved while the picture was judged');
  const { eye, target, up } = viewer.camera;
  const values = (light: object): LightValues =>
    Object.fromEntries(
      lightKeys.map((key) => [key, Reflect.get(light, key) as unknown]),
    ) as unknown as LightValues;
  return {
    ...{ width, height, subpixelBits, ...counts, suspects, eye, target, up },
    terms: viewer.terms,
    linear: viewer.colorInterpolation === 'linear',
    lights: viewer.lights.map(values),
  };
}
