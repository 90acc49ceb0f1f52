// What the element must draw of its own triangles, in float64: the nearest triangle through each pixel's centre, place
// and normal interpolated over it, and the equation there. World space relative to the camera's target; knows nothing of
// WebGL.
import type { BufferGeometry } from 'three';
import { flatGeometry } from '../../src/material/flat-geometry.js';
import { srgbEncode } from '../../src/math/color.js';
import { add, cross, dot, map, scale, subtract, type Vec3 } from '../../src/math/vector.js';
import { shade, type Shaded } from '../../src/reference/equation.js';
import { createGeometry } from '../../src/scene/mesh/shapes/shapes.js';
import { type CastMesh, type DeclaredScene, coneMargin, lens, placement } from './ray-cast.js';

interface TriangleHit {
  /** 0–1. */
  readonly color: Vec3;
  /** Pixels from the pixel's centre to the nearest edge of its triangle. */
  readonly edge: number;
  /** The colour of the same triangle's plane so many pixels to the right and down. */
  readonly beside: (dx: number, dy: number) => Vec3;
  /** As in ray-cast.ts: of the fragment, or the least of the vertices' under Gouraud. */
  readonly coneMargin: number;
}

interface Vertex {
  /** Relative to the target. */
  readonly place: Vec3;
  readonly normal: Vec3;
  /** Right, up and back of the eye. */
  readonly view: Vec3;
}

interface Triangle {
  readonly corners: readonly [Vertex, Vertex, Vertex];
  /**
   * Products of the corners as seen from the eye: a ray's product with them says on which side of an edge it passes.
   */
  readonly sides: readonly [Vec3, Vec3, Vec3];
  /** Six times the volume that it spans with the eye; below 0 where its corners run counter-clockwise on screen. */
  readonly volume: number;
  readonly front: boolean;
}

/**
 * The hits of all pixels, row by row from the top; null where there is none. One mesh, whose shape needs no chunk of
 * its own; `shading` as the attribute.
 */
export function castTriangles(
  scene: DeclaredScene,
  width: number,
  height: number,
  shading: string,
): (TriangleHit | null)[] {
  const view = lens(scene, width, height);
  const triangles = trianglesOf(scene, view, shading);
  const depth = new Float64Array(width * height).fill(Infinity);
  const nearest = new Int32Array(width * height).fill(-1);
  triangles.forEach((triangle, i) => {
    const [low, high] = extent(triangle, view.pixel, width, height);
    for (let y = low[1]; y <= high[1]; y++) {
      for (let x = low[0]; x <= high[0]; x++) {
        const t = distance(triangle, view.plane(x, y));
        if (t >= depth[y * width + x]!) continue;
        depth[y * width + x] = t;
        nearest[y * width + x] = i;
      }
    }
  });
  const color = shading === 'gouraud' ? perVertex(scene, view) : perFragment(scene, view);
  return Array.from(nearest, (i, at) => {
    if (i < 0) return null;
    const triangle = triangles[i]!;
    const [x, y] = [at % width, Math.floor(at / width)];
    const ray = passes(triangle, view.plane(x, y));
    const edge = Math.min(
      ...triangle.sides.map(([sx, sy], k) => Math.abs(ray[k]!) / (Math.hypot(sx, sy) * view.pixel)),
    );
    const beside = (dx: number, dy: number): Vec3 =>
      color(triangle, weights(passes(triangle, view.plane(x + dx, y + dy)))).color;
    return { ...color(triangle, weights(ray)), edge, beside };
  });
}

type Lens = ReturnType<typeof lens>;
type Through = readonly [number, number];

function trianglesOf(scene: DeclaredScene, { axes, eyeOffset }: Lens, shading: string): Triangle[] {
  const [mesh] = scene.meshes as [CastMesh];
  const { position, outward, normal } = placement(mesh);
  const made = createGeometry(mesh.geometry, mesh.segments) as BufferGeometry;
  const geometry = shading === 'flat' ? flatGeometry(made) : made;
  const places = geometry.getAttribute('position');
  const normals = geometry.getAttribute('normal');
  const middle = subtract(position, scene.pose.target);
  const vertices = Array.from({ length: places.count }, (_, i): Vertex => {
    const place = add(outward([places.getX(i), places.getY(i), places.getZ(i)]), middle);
    const seen = subtract(place, eyeOffset);
    return {
      place,
      normal: normal([normals.getX(i), normals.getY(i), normals.getZ(i)]),
      view: [dot(axes.right, seen), dot(axes.up, seen), dot(axes.back, seen)],
    };
  });
  const { index } = geometry;
  const at = (i: number): Vertex => vertices[index ? index.getX(i) : i]!;
  const mirrored = mesh.scale[0] * mesh.scale[1] * mesh.scale[2] < 0;
  return Array.from({ length: (index ?? places).count / 3 }, (_, i): Triangle => {
    const corners = [at(3 * i), at(3 * i + 1), at(3 * i + 2)] as const;
    const [a, b, c] = corners;
    const sides = [cross(b.view, c.view), cross(c.view, a.view), cross(a.view, b.view)] as const;
    const volume = dot(a.view, sides[0]);
    return { corners, sides, volume, front: volume < 0 !== mirrored };
  });
}

/** The ray's side of each edge; all of one sign where it goes through the triangle, and then in the corners' ratio. */
function passes({ sides }: Triangle, [x, y]: Through): Vec3 {
  const side = (s: Vec3): number => x * s[0] + y * s[1] - s[2];
  return [side(sides[0]), side(sides[1]), side(sides[2])];
}

/** The corners' shares in what is seen; they add up to 1. */
const weights = (ray: Vec3): Vec3 => scale(ray, 1 / (ray[0] + ray[1] + ray[2]));

/** Along the view; Infinity where the ray misses. */
function distance(triangle: Triangle, through: Through): number {
  const [a, b, c] = passes(triangle, through);
  const inside = (a >= 0 && b >= 0 && c >= 0) || (a <= 0 && b <= 0 && c <= 0);
  const t = triangle.volume / (a + b + c);
  return inside && t > 0 ? t : Infinity;
}

/**
 * The pixels among which a triangle's are: first and last of columns and rows. All of them where it reaches behind the
 * eye.
 */
function extent({ corners }: Triangle, pixel: number, width: number, height: number) {
  const behind = corners.filter(({ view }) => view[2] >= 0).length;
  if (behind === 3) return [[0, 0], [-1, -1]] as const; // prettier-ignore
  if (behind > 0) return [[0, 0], [width - 1, height - 1]] as const; // prettier-ignore
  const xs = corners.map(({ view }) => width / 2 - view[0] / view[2] / pixel);
  const ys = corners.map(({ view }) => height / 2 + view[1] / view[2] / pixel);
  const low = (list: readonly number[]): number => Math.max(Math.floor(Math.min(...list)), 0);
  const high = (list: readonly number[], size: number): number => Math.min(Math.ceil(Math.max(...list)), size - 1);
  return [[low(xs), low(ys)], [high(xs, width), high(ys, height)]] as const; // prettier-ignore
}

type Color = (triangle: Triangle, shares: Vec3) => Omit<TriangleHit, 'edge' | 'beside'>;

const mix = (corners: readonly Vec3[], shares: Vec3): Vec3 => corners.map((v, i) => scale(v, shares[i]!)).reduce(add);

/** The reference at a place relative to the target. */
function shader(scene: DeclaredScene, { axes, eyeOffset }: Lens): (place: Vec3, normal: Vec3) => Shaded {
  const { target } = scene.pose;
  const eye = add(target, eyeOffset);
  const options = { ...scene.options, camera: axes };
  return (place, normal) => shade({ p: add(target, place), normal, eye }, scene.meshes[0]!, scene.lights, options);
}

function perFragment(scene: DeclaredScene, view: Lens): Color {
  const at = shader(scene, view);
  return ({ corners, front }, shares) => {
    const place = mix(corners.map((corner) => corner.place), shares); // prettier-ignore
    const outside = mix(corners.map((corner) => corner.normal), shares); // prettier-ignore
    const shaded = at(place, front ? outside : scale(outside, -1));
    return { color: shaded.color, coneMargin: coneMargin(scene.lights, shaded) };
  };
}

/** Gouraud: the vertices' colours are interpolated before they are clamped and, for linear light, encoded. */
function perVertex(scene: DeclaredScene, view: Lens): Color {
  const at = shader(scene, view);
  // One picture of a sphere never shows both sides of a vertex.
  const known = new Map<Vertex, { readonly sum: Vec3; readonly margin: number }>();
  const shadeVertex = (vertex: Vertex, front: boolean) => {
    const present = known.get(vertex);
    if (present) return present;
    const shaded = at(vertex.place, front ? vertex.normal : scale(vertex.normal, -1));
    const terms = shaded.shares.flatMap((s) => (s === null ? [] : [s.ambient, s.diffuse, s.specular]));
    const made = { sum: terms.reduce(add, [0, 0, 0]), margin: coneMargin(scene.lights, shaded) };
    known.set(vertex, made);
    return made;
  };
  return ({ corners, front }, shares) => {
    const shaded = corners.map((corner) => shadeVertex(corner, front));
    const sum = mix(shaded.map((s) => s.sum), shares); // prettier-ignore
    const encoded = scene.options.linear === true ? map(sum, srgbEncode) : sum;
    return {
      color: map(encoded, (x) => Math.min(Math.max(x, 0), 1)),
      coneMargin: Math.min(...shaded.map((s) => s.margin)),
    };
  };
}
