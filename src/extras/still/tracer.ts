// What a ray from the eye sees of a scene: the nearest surfaces, and their colour by the equation.
import { srgbEncode } from '../../phong/math/color.js';
import {
  add,
  clamp,
  cross,
  dot,
  map,
  scale,
  subtract,
  type Vec3,
} from '../../phong/math/vector.js';
import type { CastScene } from './cast-scene.js';
import { Hit } from './hit.js';
import { LightSums } from './lights.js';
import { nearOf, type PixelLists, pixelLists } from './pixel-lists.js';
import { countOf, IDENTITY, unit, vectorAt } from './placed.js';
import { Screen } from './screen.js';
import { ObjectSurface, RGB, type SurfacePoint } from './surfaces.js';

/** One sample, written over by the next. */
export interface Sample {
  /** Codes, 0–255, not rounded, premultiplied; 0 where nothing is met. */
  readonly color: [number, number, number, number];
  /**
   * Equal in samples between which the colour changes smoothly: objects, sides, lights' cones and
   * horizons, and channels that are full.
   */
  piece: number;
}

/** The piece of a sample that meets nothing. */
export const NOTHING = 0;

/**
 * Largest exponent whose highlights nine points of a pixel find. With them, a knot of exponent
 * 2,000 is 1.02 codes (RMSE) off the screen and 0.61 without, a teapot of 120 0.77 and 0.70.
 */
const LARGEST_WIDE_EXPONENT = 64;

export class Tracer {
  readonly screen: Screen;
  readonly #scene: CastScene;
  readonly #lights: LightSums;
  readonly #surfaces: readonly ObjectSurface[];
  readonly lists: PixelLists;
  /** By object: the number of its first triangle among all. */
  readonly #firsts: number[] = [];
  /** {@link STRIDE} numbers of each triangle that was asked for lately, and whose they are. */
  readonly #records = new Float64Array(STRIDE * RECORDS);
  readonly #owners = new Int32Array(RECORDS).fill(-1);
  /** Gouraud: the sums at the corners of triangles that were met lately, and whose they are. */
  readonly #corners = new Float64Array(27 * CORNERS);
  readonly #cornersOwners = new Int32Array(CORNERS).fill(-1);
  /** By object: the depth of its centre. */
  readonly #depths: readonly number[];
  /** The direction of the last ray. */
  #d: Vec3 = [0, 0, 0];
  #hit = new Hit();
  /** Where a hit is written before it is known to count. */
  #next = new Hit();
  /** The blended surfaces on the last ray. */
  readonly #layers: Hit[] = [];
  readonly #color: [number, number, number] = [0, 0, 0];

  /** `lists`: those of another tracer of the same scene. */
  constructor(scene: CastScene, width: number, height: number, lists?: PixelLists) {
    const { objects, camera, lights, linear = false } = scene;
    this.#scene = scene;
    this.screen = new Screen(camera, width, height);
    const { eye, back } = camera;
    this.#depths = objects.map(({ matrix = IDENTITY, center = vectorAt(matrix, 12) }) =>
      dot(subtract(eye, center), back),
    );
    this.#surfaces = objects.map((object) => new ObjectSurface(object, eye, scene));
    let first = 0;
    for (const { shape } of objects) {
      this.#firsts.push(first);
      first += countOf(shape);
    }
    this.lists = lists ?? pixelLists(this.screen, this.#surfaces);
    this.#lights = new LightSums(lights, camera, linear, this.lists.reach);
  }

  /** Where the numbers of a triangle are, until another one's take their place. */
  #recordOf(thing: number): number {
    const slot = thing % RECORDS;
    const at = STRIDE * slot;
    if (this.#owners[slot] !== thing) {
      this.#owners[slot] = thing;
      this.#write(thing, at);
    }
    return at;
  }

  #write(thing: number, at: number): void {
    const object = this.lists.objects[thing]!;
    const triangle = thing - this.#firsts[object]!;
    const surface = this.#surfaces[object]!;
    const corners = surface.cornersOf(triangle);
    const normals = surface.verticesOf(triangle).flatMap((vertex) => surface.normal(vertex));
    const [a, b, c] = corners;
    const [bc, ca, ab] = [cross(b, c), cross(c, a), cross(a, b)];
    const near = nearOf(corners, this.screen);
    const least = near - NEARER * Math.abs(near);
    const normal = add(add(bc, ca), ab);
    this.#records.set([...bc, ...ca, ...ab, dot(a, bc), least, object, ...normal, ...normals], at);
  }

  #turn(hit: Hit, isOutward: boolean): void {
    const at = this.#recordOf(hit.thing) + NORMALS;
    this.#surfaces[hit.object]!.turn(hit, this.#records, at, isOutward);
  }

  /** Whether a hit counts. A blended one is a layer instead. */
  #accepts(hit: Hit): boolean {
    const { object } = hit;
    const { alphaMode = 'opaque', alphaCutoff = 0.5 } = this.#scene.objects[object]!.material;
    if (alphaMode === 'mask') return this.#surfaces[object]!.opacityAt(hit) >= alphaCutoff;
    if (alphaMode === 'blend') {
      this.#layers.push(Object.assign(new Hit(), hit));
    }
    return alphaMode === 'opaque';
  }

  /** The last ray has met a surface whose highlight may be narrower than the points are apart. */
  get isNarrow(): boolean {
    return [...this.#layers, this.#hit].some(
      ({ t, object }) =>
        t < Infinity && this.#scene.objects[object]!.material.shininess > LARGEST_WIDE_EXPONENT,
    );
  }

  /** Whether a pixel may show a surface that its points miss, if all of them meet one piece. */
  isCrossed(column: number, row: number): boolean {
    const { t } = this.#trace(column + 0.5, row + 0.5);
    const { starts, things } = this.lists;
    const pixel = row * this.screen.width + column;
    for (const thing of things.subarray(starts[pixel], starts[pixel + 1])) {
      if (this.#records[this.#recordOf(thing) + NEAR]! > t) break;
      if ((t === Infinity || this.#isApart(thing)) && this.#reaches(thing, column, row)) {
        return true;
      }
    }
    return false;
  }

  /**
   * Whether a triangle lies before what the last ray has met, and is of another object, or apart from
   * it, or turned. Rods, dots and wires may be thinner than the points are apart.
   */
  #isApart(thing: number): boolean {
    const { thing: met, object: own, t } = this.#hit;
    const { slopeY, height } = this.screen;
    const at = this.#recordOf(thing);
    const normal = vectorAt(this.#records, at + NORMAL);
    const facing = dot(normal, this.#d);
    const object = this.#records[at + OBJECT]!;
    const nearer = (t * facing) / this.#records[at + VOLUME]!;
    if (nearer <= ROUNDED) return false;
    const { alphaMode = 'opaque' } = this.#scene.objects[object]!.material;
    if (alphaMode !== 'opaque') return false;
    if (object !== own || nearer > 1 + (2 * APART * slopeY) / height) return true;
    const other = vectorAt(this.#records, this.#recordOf(met) + NORMAL);
    const along = dot(normal, other);
    return (
      along * facing * dot(other, this.#d) < 0 ||
      along * along < PARALLEL * dot(normal, normal) * dot(other, other)
    );
  }

  /** Whether a triangle may reach into a pixel. */
  #reaches(thing: number, column: number, row: number): boolean {
    const at = this.#recordOf(thing);
    const volume = this.#records[at + VOLUME]!;
    const corners = [0, 1, 2, 3].map((k) =>
      this.screen.direction(column + (k & 1), row + (k >> 1)),
    );
    // Inside each edge at a corner, as they are linear.
    return [0, 3, 6].every((k) => {
      const edge = vectorAt(this.#records, at + k);
      return corners.some((corner) => volume * dot(edge, corner) > 0);
    });
  }

  /**
   * The nearest opaque surface at a place in the picture; written over by the next call. Its normal
   * is in world space, outward.
   */
  hitAt(x: number, y: number): Hit {
    const hit = this.#trace(x, y);
    if (hit.t < Infinity) {
      this.#turn(hit, true);
    }
    return hit;
  }

  #trace(x: number, y: number): Hit {
    const { width, height } = this.screen;
    const column = clamp(Math.floor(x), 0, width - 1);
    const row = clamp(Math.floor(y), 0, height - 1);
    this.#d = this.screen.direction(x, y);
    this.#layers.length = 0;
    this.#hit.t = Infinity;
    const [dx, dy, dz] = this.#d;
    const records = this.#records;
    let most = Infinity;
    const { starts, things } = this.lists;
    const end = starts[row * width + column + 1]!;
    for (let i = starts[row * width + column]!; i < end; i++) {
      const thing = things[i]!;
      const at = this.#recordOf(thing);
      if (records[at + NEAR]! > most) break;
      const a = dx * records[at]! + dy * records[at + 1]! + dz * records[at + 2]!;
      const b = dx * records[at + 3]! + dy * records[at + 4]! + dz * records[at + 5]!;
      const c = dx * records[at + 6]! + dy * records[at + 7]! + dz * records[at + 8]!;
      if (!((a >= 0 && b >= 0 && c >= 0) || (a <= 0 && b <= 0 && c <= 0))) continue;
      const sum = a + b + c;
      const t = records[at + VOLUME]! / sum;
      if (!(t > 0 && t <= most)) continue;
      const [hit, next] = [this.#hit, this.#next];
      next.thing = thing;
      next.object = records[at + OBJECT]!;
      next.triangle = thing - this.#firsts[next.object]!;
      next.t = t;
      next.front = sum < 0 !== this.#surfaces[next.object]!.mirrored;
      next.a = a / sum;
      next.b = b / sum;
      next.c = c / sum;
      if (!this.#accepts(next)) continue;
      // Where two coincide, the last one shows.
      if (thing < hit.thing && next.t * ROUNDED >= hit.t) continue;
      most = next.t * ROUNDED;
      this.#hit = next;
      this.#next = hit;
    }
    return this.#hit;
  }

  /** What is drawn at a place in the picture. */
  sampleAt(x: number, y: number, sample: Sample): void {
    const hit = this.#trace(x, y);
    sample.color.fill(0);
    sample.piece = NOTHING;
    if (hit.t < Infinity) {
      this.#lay(hit, sample);
    }
    if (this.#layers.length === 0) return;
    // As they are drawn: the farthest object first, triangle by triangle, each with the depth test.
    const depth = ({ object }: Hit): number => this.#depths[object]!;
    this.#layers.sort((a, b) => depth(b) - depth(a) || a.thing - b.thing);
    let nearest = hit.t;
    for (const layer of this.#layers) {
      if (!(layer.t <= nearest)) continue;
      nearest = layer.t;
      this.#lay(layer, sample);
    }
  }

  /** Adds a surface before those that the sample has. */
  #lay(hit: Hit, sample: Sample): void {
    const { color } = sample;
    const surface = this.#surfaces[hit.object]!;
    const point = surface.point ?? surface.at(hit);
    const { alpha } = point;
    sample.piece = Math.imul(sample.piece, 0x9e3779b1) + this.#shade(hit, surface, point);
    for (let i = 0; i < 4; i++) {
      const value = i < 3 ? this.#color[i as 0] : 1;
      color[i as 0] = 255 * alpha * value + (1 - alpha) * color[i as 0];
    }
  }

  /** Writes the colour at a hit, and returns its piece. */
  #shade(hit: Hit, surface: ObjectSurface, point: SurfacePoint): number {
    const { material } = surface.object;
    const { quantity, linear = false } = this.#scene;
    let color = point.base;
    let piece = 2 * hit.object + Number(hit.front) + 1;
    if (quantity !== undefined || material.unlit !== true) {
      if (quantity === undefined && material.shading === 'gouraud') {
        this.#mixSums(hit);
      } else {
        this.#turn(hit, hit.front);
        const d = this.#d;
        this.#lights.at(scale(d, hit.t), hit.normal, unit(d, -1), point.n, surface.isBlinn);
        piece = Math.imul(piece, 0x9e3779b1) + this.#lights.piece;
      }
      if (material.shading === 'flat') {
        piece = Math.imul(piece, 0x9e3779b1) + hit.triangle;
      }
      const { ka, kd, ks, emissive } = point;
      const { sums } = this.#lights;
      for (const i of RGB) {
        const lit = ka[i] * sums[i]! + kd[i] * sums[i + 3]! + ks[i] * sums[i + 6]!;
        this.#color[i] = lit + emissive[i];
      }
      color = this.#color;
    }
    if (quantity !== undefined) {
      color = this.#measure(hit, quantity);
    }
    for (const i of RGB) {
      const value = linear && quantity === undefined ? srgbEncode(color[i]) : color[i];
      piece = 2 * piece + Number(value > 1);
      this.#color[i] = clamp(value, 0, 1);
    }
    return piece | 0;
  }

  #measure({ normal }: Hit, quantity: NonNullable<CastScene['quantity']>): Vec3 {
    if (quantity === 'normals') return map(normal, (x) => (x + 1) / 2);
    const { NoL, RoV, att, decay } = this.#lights.last;
    const values = { 'n-dot-l': NoL, 'r-dot-v': NoL > 0 ? RoV : 0, attenuation: att, decay };
    const value = this.#lights.count > 0 ? values[quantity] : 0;
    return [value, value, value];
  }

  /** Gouraud: writes the corners' sums, interpolated, in place of the lights'. */
  #mixSums(hit: Hit): void {
    const { thing, a, b, c } = hit;
    const slot = thing % CORNERS;
    const at = 27 * slot;
    if (this.#cornersOwners[slot] !== thing) {
      this.#cornersOwners[slot] = thing;
      const surface = this.#surfaces[hit.object]!;
      const sums = surface.verticesOf(hit.triangle).flatMap((vertex) => {
        const p = surface.place(vertex);
        // A triangle is seen from one side only.
        const N = scale(surface.normal(vertex), hit.front ? 1 : -1);
        this.#lights.at(p, N, unit(p, -1), surface.object.material.shininess, surface.isBlinn);
        return [...this.#lights.sums];
      });
      this.#corners.set(sums, at);
    }
    const corners = this.#corners;
    for (let i = at; i < at + 9; i++) {
      this.#lights.sums[i - at] = a * corners[i]! + b * corners[i + 9]! + c * corners[i + 18]!;
    }
  }
}

/**
 * Numbers of a triangle: b×c, c×a and a×b of its corners as seen from the eye, a·(b×c), the least
 * depth at which a ray meets it, its object, its normal (as long as twice its area) and its corners'
 * normals.
 */
const STRIDE = 24;
const [VOLUME, NEAR, OBJECT, NORMAL, NORMALS] = [9, 10, 11, 12, 15];

/**
 * How many triangles keep their numbers (25 MB), and how many their corners' sums (2 MB). The first
 * is a prime, so that two triangles in one pixel of a regular grid rarely share a place.
 */
const RECORDS = 131_071;
const CORNERS = 2 ** 13;

/**
 * Share of its depth by which rounding may let a ray meet a triangle nearer than its corners. More
 * than 2^-28, the part of a depth that sorting ignores.
 */
const NEARER = 1e-8;

/** Pixels by which a surface is apart from another of the same object. */
const APART = 2;

/** Squared cosine of 10°: between normals of one surface that bends. */
const PARALLEL = 0.97;

/** Surfaces in one plane are met at depths that differ by rounding: less than this. */
const ROUNDED = 1 + 1e-12;
