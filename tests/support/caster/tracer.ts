// What a ray from the eye sees of a scene: the nearest surface, and its colour by the reference
// equation.
import {
  type LightShare,
  shade,
  type Shaded,
  type Surface,
} from '../../../src/phong/reference/index.js';
import {
  add,
  cross,
  dot,
  length,
  multiply,
  scale,
  subtract,
  type Vec3,
} from '../../../src/phong/math/vector.js';
import { type Hit, type Intersect, newHit } from './hit.js';
import type { CastScene } from './scene.js';
import { Screen } from './screen.js';
import { colorOf } from './texture.js';
import { columnsOf, times, Triangles, type Vec3Matrix } from './triangles.js';
import { trueShape } from './true-shapes.js';

/** A true shape in the scene. */
interface Solid {
  readonly intersect: Intersect;
  readonly object: number;
  /** Directions and normals between world and shape. */
  readonly toShape: Vec3Matrix;
  readonly toWorld: Vec3Matrix;
  /** The eye, in the shape's space. */
  readonly eye: Vec3;
  /** A sphere around it, as seen from the eye. */
  readonly center: Vec3;
  readonly radius: number;
}

/** One sample, written over by the next. */
export interface Sample {
  /** Codes, 0–255, not rounded; 0 where nothing is met. */
  readonly color: [number, number, number, number];
  /**
   * Equal in samples between which the colour changes smoothly: object, side, and lights' cones and
   * horizons.
   */
  piece: number;
}

/** The piece of a sample that meets nothing. */
export const NOTHING = 0;

export class Tracer {
  readonly screen: Screen;
  readonly #scene: CastScene;
  readonly #solids: Solid[] = [];
  readonly #triangles: Triangles;
  readonly #hit = newHit();

  constructor(scene: CastScene, width: number, height: number) {
    this.#scene = scene;
    this.screen = new Screen(scene.camera, width, height);
    this.#triangles = new Triangles(this.screen);
    scene.objects.forEach((object, i) => {
      const { shape } = object;
      const matrix = columnsOf(object.matrix);
      if (shape.kind === 'triangles') {
        this.#triangles.add(shape, i, matrix);
      } else {
        this.#solids.push(solidOf(trueShape(shape), i, matrix, scene.camera.eye));
      }
    });
    this.#triangles.sort();
  }

  /** False: no ray through this pixel meets anything. */
  mayMeet(column: number, row: number): boolean {
    const { width, height, slopeY } = this.screen;
    if (this.#triangles.meets(row * width + column)) return true;
    const d = this.screen.direction(column + 0.5, row + 0.5);
    const halfDiagonal = (Math.SQRT2 * slopeY) / height;
    return this.#solids.some(({ center, radius }) => {
      const apart = length(cross(center, d)) / length(d);
      // A ray through the pixel leaves its middle by less than that for each unit of length.
      return apart <= radius + halfDiagonal * length(center);
    });
  }

  /**
   * The nearest surface at a place in the picture; written over by the next call. Its normal is in
   * world space.
   */
  hitAt(x: number, y: number): Readonly<Hit> {
    const { width, height } = this.screen;
    const hit = this.#hit;
    hit.t = Infinity;
    hit.triangle = -1;
    const column = Math.min(Math.max(Math.floor(x), 0), width - 1);
    const row = Math.min(Math.max(Math.floor(y), 0), height - 1);
    const direction = this.screen.direction(x, y);
    this.#triangles.intersect(row * width + column, direction, hit);
    for (const { intersect, object, toShape, toWorld, eye } of this.#solids) {
      if (!intersect(eye, times(toShape, direction), hit)) continue;
      [hit.nx, hit.ny, hit.nz] = times(toWorld, [hit.nx, hit.ny, hit.nz]);
      hit.object = object;
      hit.triangle = -1;
    }
    return hit;
  }

  /** The equation at a place in the picture; null where nothing is met. */
  shadedAt(x: number, y: number): Shaded | null {
    const hit = this.hitAt(x, y);
    if (hit.t === Infinity) return null;
    const { camera, lights, objects } = this.#scene;
    const { material } = objects[hit.object]!;
    const p = add(camera.eye, scale(this.screen.direction(x, y), hit.t));
    const normal = scale([hit.nx, hit.ny, hit.nz], hit.front ? 1 : -1);
    let surface: Surface = material;
    if (material.texture !== undefined) {
      const texel = colorOf(material.texture, hit.u, hit.v);
      surface = { ...material, baseColor: multiply(material.baseColor ?? WHITE, texel) };
    }
    return shade({ p, normal, eye: camera.eye }, surface, lights, this.#scene);
  }

  /** What is drawn at a place in the picture. */
  sampleAt(x: number, y: number, sample: Sample): void {
    const { color } = sample;
    const shaded = this.shadedAt(x, y);
    for (let i = 0; i < 3; i++) {
      color[i as 0] = shaded === null ? 0 : 255 * shaded.color[i as 0];
    }
    color[3] = shaded === null ? 0 : 255;
    sample.piece = shaded === null ? NOTHING : pieceOf(this.#hit, shaded.shares);
  }
}

const WHITE: Vec3 = [1, 1, 1];

/** A hash; two pieces with the same one are as unlikely as any two of 2^32 numbers. */
function pieceOf({ object, front }: Hit, shares: readonly (LightShare | null)[]): number {
  let piece = 2 * object + Number(front) + 1;
  for (const share of shares) {
    piece =
      Math.imul(piece, 0x9e3779b1) + Number(share?.insideCone) + 2 * Number((share?.NoL ?? 0) > 0);
  }
  return piece | 0;
}

function solidOf(intersect: Intersect, object: number, matrix: Vec3Matrix, eye: Vec3): Solid {
  const { x, y, z } = matrix;
  const rows = [cross(y, z), cross(z, x), cross(x, y)] as const; // of the adjugate
  const determinant = dot(x, rows[0]);
  // The inverse by its rows is the cofactors' transpose over the determinant; as columns, the
  // inverse transpose.
  const toWorld: Vec3Matrix = {
    x: scale(rows[0], 1 / determinant),
    y: scale(rows[1], 1 / determinant),
    z: scale(rows[2], 1 / determinant),
    origin: [0, 0, 0],
  };
  const column = (i: 0 | 1 | 2): Vec3 => [toWorld.x[i], toWorld.y[i], toWorld.z[i]];
  const toShape = { x: column(0), y: column(1), z: column(2), origin: matrix.origin };
  const center = subtract(matrix.origin, eye);
  // No point of a true shape is farther from its middle than √½.
  const radius = Math.SQRT1_2 * Math.hypot(length(x), length(y), length(z));
  const inShape = times(toShape, scale(center, -1));
  return { intersect, object, toShape, toWorld, eye: inShape, center, radius };
}
