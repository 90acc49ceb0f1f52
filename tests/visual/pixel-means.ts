// What `antialias="full"` must converge to, in float64: for each pixel the mean, over its square, of the clamped colour
// of the nearest triangle and of its coverage. Takes the triangles that a page draws; world space relative to the
// camera's target. Knows nothing of WebGL.
import type { LightValues } from '../../src/light/light-state.js';
import { add, cross, dot, scale, subtract, type Vec3 } from '../../src/math/vector.js';
import { type ReferenceOptions, shade, type Surface } from '../../src/reference/equation.js';

export interface DrawnMesh {
  /** Three numbers a vertex, in the mesh's own space. */
  readonly positions: readonly number[];
  readonly normals: readonly number[];
  readonly index: readonly number[];
  /** Column by column, as three.js keeps it. Rigid with one scale, so that it turns normals too. */
  readonly matrix: readonly number[];
  readonly surface: Surface;
}

export interface DrawnScene {
  readonly meshes: readonly DrawnMesh[];
  readonly eye: Vec3;
  readonly right: Vec3;
  readonly up: Vec3;
  readonly back: Vec3;
  /** Vertical, degrees. */
  readonly fov: number;
  readonly lights: readonly LightValues[];
  readonly options?: Omit<ReferenceOptions, 'camera'>;
}

interface Triangle {
  readonly places: readonly [Vec3, Vec3, Vec3];
  readonly normals: readonly [Vec3, Vec3, Vec3];
  /** Products of the corners as seen from the eye: a ray's products with them have one sign inside the triangle. */
  readonly sides: readonly [Vec3, Vec3, Vec3];
  readonly volume: number;
  readonly surface: Surface;
  /** First and last column and row of pixels. */
  readonly box: readonly [number, number, number, number];
}

/**
 * Codes, not rounded, r, g, b, a of each pixel, premultiplied, row by row from the top. `side`: samples along a pixel's
 * side, where a quarter of them and an eighth do not give the same mean.
 */
export function pixelMeans(scene: DrawnScene, width: number, height: number, side = 32): Float64Array {
  const tan = Math.tan((scene.fov * Math.PI) / 360);
  const pixel = (2 * tan) / height;
  const rows = rowsOf(trianglesOf(scene, width, height, pixel), height);
  const means = new Float64Array(4 * width * height);
  const camera = { right: scene.right, up: scene.up, back: scene.back };
  const colorAt = (triangles: readonly Triangle[], x: number, y: number): readonly number[] => {
    const ray: Vec3 = [(x - width / 2) * pixel, (height / 2 - y) * pixel, -1];
    let least = Infinity;
    let nearest: Triangle | null = null;
    let shares: Vec3 = [0, 0, 0];
    for (const triangle of triangles) {
      const [s, t, u] = triangle.sides;
      const [a, b, c] = [dot(ray, s), dot(ray, t), dot(ray, u)];
      if (!((a >= 0 && b >= 0 && c >= 0) || (a <= 0 && b <= 0 && c <= 0))) continue;
      const distance = triangle.volume / (a + b + c);
      if (!(distance > 0 && distance < least)) continue;
      least = distance;
      nearest = triangle;
      shares = [a / (a + b + c), b / (a + b + c), c / (a + b + c)];
    }
    if (nearest === null) return EMPTY;
    const p = mix(nearest.places, shares);
    const outward = mix(nearest.normals, shares);
    const { places } = nearest;
    const face = cross(subtract(places[1], places[0]), subtract(places[2], places[0]));
    const turned = dot(face, subtract(p, scene.eye)) > 0;
    const fragment = { p, normal: turned ? scale(outward, -1) : outward, eye: scene.eye };
    const { color } = shade(fragment, nearest.surface, scene.lights, { ...scene.options, camera });
    return [255 * color[0], 255 * color[1], 255 * color[2], 255];
  };
  const mean = (triangles: readonly Triangle[], x: number, y: number, n: number): number[] => {
    const sum = [0, 0, 0, 0];
    for (let i = 0; i < n * n; i++) {
      const color = colorAt(triangles, x + ((i % n) + 0.5) / n, y + (Math.floor(i / n) + 0.5) / n);
      for (let k = 0; k < 4; k++) sum[k]! += color[k]!;
    }
    return sum.map((code) => code / (n * n));
  };
  rows.forEach((row, y) => {
    for (let x = 0; x < width; x++) {
      const triangles = row.filter(({ box }) => box[0] <= x && x <= box[1]);
      if (triangles.length === 0) continue;
      const coarse = mean(triangles, x, y, side / 8);
      let found = mean(triangles, x, y, side / 4);
      if (found.some((code, k) => Math.abs(code - coarse[k]!) > NEGLIGIBLE))
        found = mean(triangles, x, y, side);
      means.set(found, 4 * (y * width + x));
    }
  });
  return means;
}

const EMPTY = [0, 0, 0, 0];

/** Codes. A smooth colour's error falls by four from one grid to the next: what is left is a third of this. */
const NEGLIGIBLE = 0.05;

const mix = ([a, b, c]: readonly [Vec3, Vec3, Vec3], [u, v, w]: Vec3): Vec3 =>
  add(add(scale(a, u), scale(b, v)), scale(c, w));

/** Those that may touch each row of pixels. */
function rowsOf(triangles: readonly Triangle[], height: number): Triangle[][] {
  const rows = Array.from({ length: height }, (): Triangle[] => []);
  for (const triangle of triangles)
    for (let y = triangle.box[2]; y <= triangle.box[3]; y++) rows[y]?.push(triangle);
  return rows;
}

/** All of them lie before the eye. */
function trianglesOf(
  { meshes, eye, right, up, back }: DrawnScene,
  width: number,
  height: number,
  pixel: number,
): Triangle[] {
  return meshes.flatMap(({ positions, normals, index, matrix: m, surface }) => {
    const turned = (list: readonly number[], i: number): Vec3 => {
      const [x, y, z] = [list[3 * i]!, list[3 * i + 1]!, list[3 * i + 2]!];
      const axis = (k: number): number => m[k]! * x + m[k + 4]! * y + m[k + 8]! * z;
      return [axis(0), axis(1), axis(2)];
    };
    const middle: Vec3 = [m[12]!, m[13]!, m[14]!];
    const vertices = Array.from({ length: positions.length / 3 }, (_, i) => {
      const place = add(turned(positions, i), middle);
      const from = subtract(place, eye);
      const seen: Vec3 = [dot(from, right), dot(from, up), dot(from, back)];
      return { place, normal: turned(normals, i), seen };
    });
    return Array.from({ length: index.length / 3 }, (_, i): Triangle => {
      const [a, b, c] = [0, 1, 2].map((k) => vertices[index[3 * i + k]!]!) as [Vertex, Vertex, Vertex];
      const sides = [cross(b.seen, c.seen), cross(c.seen, a.seen), cross(a.seen, b.seen)] as const;
      const xs = [a, b, c].map(({ seen }) => width / 2 - seen[0] / seen[2] / pixel);
      const ys = [a, b, c].map(({ seen }) => height / 2 + seen[1] / seen[2] / pixel);
      return {
        places: [a.place, b.place, c.place],
        normals: [a.normal, b.normal, c.normal],
        sides,
        volume: dot(a.seen, sides[0]),
        surface,
        box: [
          Math.floor(Math.min(...xs)),
          Math.floor(Math.max(...xs)),
          Math.max(Math.floor(Math.min(...ys)), 0),
          Math.min(Math.floor(Math.max(...ys)), height - 1),
        ],
      };
    });
  });
}

interface Vertex {
  readonly place: Vec3;
  readonly normal: Vec3;
  readonly seen: Vec3;
}
