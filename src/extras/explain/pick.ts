// Finds the fragment that a picture shows at a pixel: the nearest point of a snapshot on the
// pixel's ray, in float64.
import {
  type BufferGeometry,
  type Intersection,
  Matrix3,
  type Object3D,
  type PerspectiveCamera,
  Raycaster,
  Vector3,
} from 'three';
import { cullsBackFaces } from '../../phong/material/back-faces.js';
import type { ShadingFrame } from '../../phong/material/shading-space.js';
import { normalMatrix } from '../../phong/material/normal-matrix.js';
import { radians } from '../../phong/math/angle.js';
import {
  add,
  cross,
  dot,
  length,
  normalize,
  ORIGIN,
  perpendicular,
  scale,
  subtract,
  type Vec3,
  type Vec4,
} from '../../phong/math/vector.js';
import type { OwnDrawn, SceneSnapshot } from '../../phong/geometry/scene-snapshot.js';
import type { PixelSlopes } from './sample.js';
import {
  type BaseColor,
  baseColorAt,
  isFiltered,
  mappedNormalAt,
  surfaceAt,
} from './surface-at.js';
import {
  type RaySearch,
  searchNear,
  searchTriangles,
  type TriangleHit,
  type TrianglePoint,
  type ViewRay,
  weighted,
} from './ray-triangles.js';

/** A point of a Phong-lit surface. */
export interface Hit<Owner = unknown> extends TrianglePoint {
  readonly drawn: OwnDrawn<Owner>;
  readonly frame: ShadingFrame;
  /** Place relative to the frame's origin. */
  readonly p: Vec3;
  readonly base: BaseColor;
  /** The picture averages a texture that is read at one point here. */
  readonly filtered: boolean;
}

/** The one seen through a pixel. */
export type SeenHit<Owner = unknown> = Hit<Owner> & TriangleHit;

/**
 * The point seen through the centre of a device pixel, counted from the top left corner; fractions
 * are places beside the centre. Null if there is none, or if a page author's own mesh or sprite is
 * nearer; lines, points and culled back faces are ignored. Of blended surfaces the nearest counts,
 * whatever its opacity.
 */
export function* pick<Owner>(
  snapshot: SceneSnapshot<Owner>,
  column: number,
  row: number,
): RaySearch<SeenHit<Owner> | null> {
  const { width, height, camera, frame } = snapshot;
  if (!(column >= -0.5 && column < width - 0.5 && row >= -0.5 && row < height - 0.5)) return null;
  const { near, far, aspect } = camera;
  const tan = Math.tan(radians(camera.fov) / 2);
  const across = (column + 0.5) / width;
  const down = (row + 0.5) / height;
  const ray: ViewRay = {
    frame,
    slopeX: (2 * across - 1) * tan * aspect,
    slopeY: (1 - 2 * down) * tan,
    near,
    far,
  };
  const pixel: PixelSlopes = [(2 * tan * aspect) / width, (-2 * tan) / height];
  let nearest: SeenHit<Owner> | null = null;
  let depth = Infinity;
  // Depth of the nearest surface that a mask cuts out here, though perhaps not in the picture.
  let cutOut = Infinity;
  for (const drawn of snapshot.objects) {
    if (drawn.phong === null) {
      const foreign = foreignDepth(drawn.object, camera, ray);
      if (foreign < depth) {
        [nearest, depth] = [null, foreign];
      }
      yield;
      continue;
    }
    const { geometry, matrixWorld, phong } = drawn;
    const culled = cullsBackFaces(phong.sides, geometry, matrixWorld, camera);
    const hit = yield* searchSurface(drawn, ray, (hitDepth, front, read) => {
      // As the depth test does: of two at the same depth the later one stays.
      if ((culled && !front) || hitDepth > depth * (1 + COPLANAR)) return false;
      if (isCutOut(drawn, read)) {
        if (hitDepth < cutOut && isFiltered(phong, geometry, read(), pixel)) {
          cutOut = hitDepth;
        }
        return false;
      }
      depth = hitDepth;
      return true;
    });
    if (hit !== null) {
      nearest = {
        ...hit,
        drawn,
        base: baseColorAt(phong.look, geometry, hit, phong.linear),
        filtered: isFiltered(phong, geometry, hit, pixel),
        frame,
        p: add(frame.eye, scale(directionOf(ray), hit.depth)),
      };
    }
  }
  return nearest === null || cutOut > depth ? nearest : { ...nearest, filtered: true };
}

/**
 * Distance of the nearest surface of any mesh from a place along a unit vector in world space, or
 * Infinity.
 */
export function* distanceAlong(
  snapshot: SceneSnapshot,
  from: Vec3,
  along: Vec3,
): RaySearch<number> {
  const ray = rayAlong(from, ORIGIN, along);
  let nearest = Infinity;
  for (const drawn of snapshot.objects) {
    if (drawn.phong === null) {
      nearest = Math.min(nearest, foreignDepth(drawn.object, snapshot.camera, ray));
      yield;
    } else {
      yield* searchSurface(drawn, ray, (depth, _, read) => {
        if (depth < nearest && !isCutOut(drawn, read)) {
          nearest = depth;
        }
        return false;
      });
    }
  }
  return nearest;
}

/** The point of any surface, drawn or not, that is nearest to another; null if none is near. */
export function* pickNear<Owner>(
  { frame, objects }: SceneSnapshot<Owner>,
  point: Vec3,
): RaySearch<Hit<Owner> | null> {
  const place = subtract(point, frame.origin);
  let nearest: Hit<Owner> | null = null;
  let distance = NEAR * length(subtract(place, frame.eye));
  for (const drawn of objects) {
    if (drawn.phong === null) continue;
    const { geometry, matrixWorld, phong } = drawn;
    const near = yield* searchNear(
      frame,
      place,
      geometry,
      matrixWorld,
      rangeOf(geometry),
      distance,
      (found) => !isCutOut(drawn, () => found),
    );
    if (near !== null) {
      distance = length(near.away);
      const base = baseColorAt(phong.look, geometry, near, phong.linear);
      nearest = { ...near, drawn, base, filtered: false, frame, p: add(place, near.away) };
    }
  }
  return nearest;
}

/** A share of the distance from the eye: curved shapes are made of flat triangles. */
const NEAR = 0.005;

function rayAlong(origin: Vec3, eye: Vec3, along: Vec3): ViewRay {
  const right = perpendicular(along);
  const frame = { origin, eye, right, up: cross(right, along), back: scale(along, -1) };
  return { frame, slopeX: 0, slopeY: 0, near: 0, far: Infinity };
}

/** Relative. Faces in one plane differ in depth by a few roundings of float64, 1e-16 each. */
const COPLANAR = 1e-12;

/** All of an object, what its texture cuts out included, from either side. */
function searchSurface(
  { geometry, matrixWorld }: OwnDrawn,
  ray: ViewRay,
  keeps: Parameters<typeof searchTriangles>[4],
): RaySearch<TriangleHit | null> {
  return searchTriangles(ray, geometry, matrixWorld, rangeOf(geometry), keeps);
}

/** The corners that are drawn. */
function rangeOf({ index, drawRange, attributes }: BufferGeometry): readonly [number, number] {
  const { count } = index ?? attributes['position']!;
  return [Math.max(drawRange.start, 0), Math.min(drawRange.start + drawRange.count, count)];
}

const isCutOut = ({ geometry, phong: { look, linear } }: OwnDrawn, read: () => TrianglePoint) =>
  look.alphaMode === 'mask' && baseColorAt(look, geometry, read(), linear).discarded;

const directionOf = ({ frame: { right, up, back }, slopeX, slopeY }: ViewRay): Vec3 =>
  subtract(add(scale(right, slopeX), scale(up, slopeY)), back);

/**
 * Depth of a page author's own mesh or sprite, by three.js's raycaster; Infinity where it is not
 * hit.
 */
function foreignDepth(object: Object3D, camera: PerspectiveCamera, ray: ViewRay): number {
  const { isMesh, isSprite } = object as { isMesh?: boolean; isSprite?: boolean };
  if (isMesh !== true && isSprite !== true) return Infinity;
  const { frame } = ray;
  const caster = new Raycaster();
  caster.camera = camera;
  caster.ray.origin.set(...add(frame.origin, frame.eye));
  caster.ray.direction.set(...directionOf(ray)).normalize();
  const hits: Intersection[] = [];
  object.raycast(caster, hits);
  let nearest = Infinity;
  for (const { point } of hits) {
    const depth = -dot(subtract(subtract(point.toArray(), frame.origin), frame.eye), frame.back);
    if (depth >= ray.near && depth <= ray.far) {
      nearest = Math.min(nearest, depth);
    }
  }
  return nearest;
}

/** A corner in shading space. */
interface Corner {
  /** Place relative to the frame's origin. */
  readonly p: Vec3;
  /** Unit length, or zero; flipped on back faces. */
  readonly N: Vec3;
  /**
   * Unit, along the u of a normal map; w is the side of its v. Null where the geometry has none.
   * Not flipped.
   */
  readonly tangent: Vec4 | null;
}

/** The corners of the triangle that was hit, as the vertex shader computes them. */
export function cornersOf({
  drawn: { geometry, matrixWorld },
  corners,
  front,
  frame,
}: Hit): readonly [Corner, Corner, Corner] {
  const toShading = matrixWorld.clone();
  const e = toShading.elements;
  for (let i = 0; i < 3; i++) {
    e[12 + i]! -= frame.origin[i]!;
  }
  const turn = new Matrix3();
  normalMatrix(toShading, turn);
  const { position, normal, tangent } = geometry.attributes;
  const sign = toShading.determinant() < 0 ? -1 : 1;
  const linear = new Matrix3().setFromMatrix4(toShading);
  const tangentOf = (vertex: number): Vec4 | null => {
    if (tangent === undefined) return null;
    const T = new Vector3().fromBufferAttribute(tangent, vertex).applyMatrix3(linear);
    return [...normalize(T.toArray()), sign * tangent.getW(vertex)];
  };
  const corner = (vertex: number): Corner => {
    const p = new Vector3().fromBufferAttribute(position!, vertex).applyMatrix4(toShading);
    const N = new Vector3();
    if (normal !== undefined) {
      N.fromBufferAttribute(normal, vertex).applyMatrix3(turn);
    }
    return {
      p: p.toArray(),
      N: scale(normalize(N.toArray()), front ? 1 : -1),
      tangent: tangentOf(vertex),
    };
  };
  return [corner(corners[0]), corner(corners[1]), corner(corners[2])];
}

/** The surface at a hit, its normal as it is shaded, and the corners of its triangle. */
export function shadedPoint(hit: Hit) {
  const { weights } = hit;
  const { phong, geometry } = hit.drawn;
  const corners = cornersOf(hit);
  const [a, b, c] = corners;
  const N = weighted(weights, [a.N, b.N, c.N]);
  return {
    corners,
    surface: surfaceAt(phong, geometry, hit, hit.base),
    normal: mappedNormalAt(phong, geometry, hit, N, tangentAt(weights, corners)),
  };
}

/** The tangent at a hit; null without one. */
function tangentAt(weights: Vec3, corners: readonly Corner[]): Vec4 | null {
  const [a, b, c] = corners.map(({ tangent }) => tangent);
  if (!a || !b || !c) return null;
  const mix = (i: 0 | 1 | 2 | 3): number =>
    a[i] * weights[0] + b[i] * weights[1] + c[i] * weights[2];
  return [mix(0), mix(1), mix(2), mix(3)];
}
