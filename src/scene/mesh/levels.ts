// Gives the round shapes of a picture as many segments as its pixels show. The choice follows from camera, transforms
// and size alone: the same scene at the same size has the same triangles.
import { lazyCode } from '../../model/lazy-code.js';
import { stretch } from '../bounds.js';
import type { Vec3 } from '../../math/vector.js';
import type { View } from '../view-cut.js';
import type { Budget } from '../../model/budget.js';
import type { SceneMesh } from './scene-mesh.js';
import type { SharedMaterials } from './shared-materials.js';
import { FIXED, isBuilt, levelKey } from './shapes/shared-shapes.js';
import {
  coarsestOf,
  flatTrianglesOf,
  GEOMETRIES,
  type GeometryName,
  type Round,
  roundOf,
  trianglesOf,
} from './shapes/shapes.js';

/** Most that an outline may be off the round shape, in device pixels: in the plain picture. */
export const OUTLINE_TOLERANCE = 1 / 8;

/** The same in the samples of a still picture, whose mean shows an eighth of a plain picture's error. */
export const SAMPLED_TOLERANCE = 1 / 64;

/** Triangles that a frame may build before it is drawn: 2 ms for a sphere, 10 ms for a teapot. */
const AT_ONCE = 2 ** 16;

/** Pictures whose outlines meet. */
export interface SharedLevels {
  /** One of them shows a round shape by its fixed number of segments, so all do. */
  readonly isFixed: boolean;
  /** That may have changed. */
  reshaded(): void;
}

/** What a choice follows from, beside the meshes. */
type Condition =
  'camera' | 'moves' | 'slopeX' | 'slopeY' | 'height' | 'used' | 'limit' | 'isFixed' | 'atOnce';

const buildsCode = /* @__PURE__ */ lazyCode(() => import('./level-builds.js'), 'finer shapes');

export class Levels {
  readonly #meshes: ReadonlySet<SceneMesh>;
  readonly #budget: Budget;
  readonly #materials: SharedMaterials;
  readonly #built: (samples: boolean) => void;
  #tolerance = OUTLINE_TOLERANCE;
  #shared: SharedLevels | null = null;
  /** As {@link shared} was last told. */
  #wasFixed = false;
  #stale = true;
  /** What the last choice was made for. */
  readonly #chosenFor: Partial<Record<Condition, number | boolean>> = {};
  // The round shapes and their levels in the present choice, and the levels that are being built for them.
  readonly #round: SceneMesh[] = [];
  readonly #levels: number[] = [];
  readonly #building = new Set<string>();
  /** Triangles that a frame may build, and what is left of them in the present one. */
  #inFrames = AT_ONCE;
  #mayBuild = 0;

  /** `built` is called when a level that was missing is there; `samples`: for the samples of a still picture. */
  constructor(
    meshes: ReadonlySet<SceneMesh>,
    budget: Budget,
    materials: SharedMaterials,
    built: (samples: boolean) => void,
  ) {
    this.#meshes = meshes;
    this.#budget = budget;
    this.#materials = materials;
    this.#built = built;
  }

  /** Most that an outline may be off the round shape. Device pixels, above 0. */
  set outlineTolerance(pixels: number) {
    this.#stale ||= pixels !== this.#tolerance;
    this.#tolerance = pixels;
  }

  /** Chooses together with other pictures; null, the default: alone. */
  set shared(shared: SharedLevels | null) {
    this.#shared = shared;
    this.#wasFixed = this.isFixed;
    this.#stale = true;
  }

  /** A mesh, the shading, or what this picture is shared with has changed. */
  changed(): void {
    this.#stale = true;
    if (this.#shared === null || this.isFixed === this.#wasFixed) return;
    this.#wasFixed = !this.#wasFixed;
    this.#shared.reshaded();
  }

  /** Some round shapes are still coarser than they will be. */
  get pending(): boolean {
    return this.#building.size > 0;
  }

  /** The number of segments of round shapes is part of this picture: Gouraud or flat shading shows it. */
  get isFixed(): boolean {
    if (this.#materials.style.shading !== 'phong') return true;
    for (const { round, isFixed } of this.#meshes) if (round !== null && isFixed) return true;
    return false;
  }

  /**
   * Chooses for a picture of `height` device pixels, and shows what is chosen as far as it is built. `camera` and
   * `moves`: the versions of the camera and of the meshes' places; for other changes see {@link changed}. `atOnce`:
   * builds all that is missing now. World matrices must be up to date.
   */
  choose(view: View, height: number, atOnce: boolean, camera: number, moves: number): void {
    const { used, limit } = this.#budget;
    const isFixed = this.#shared?.isFixed ?? false;
    this.#compare('camera', camera);
    this.#compare('moves', moves);
    this.#compare('slopeX', view.slopeX);
    this.#compare('slopeY', view.slopeY);
    this.#compare('height', height);
    this.#compare('used', used);
    this.#compare('limit', limit);
    this.#compare('isFixed', isFixed);
    this.#compare('atOnce', atOnce);
    if (!this.#stale) return;
    this.#stale = false;
    this.#list(view, height / (2 * view.slopeY), isFixed);
    while (this.#triangles() > limit - used && this.#coarsen());
    this.#mayBuild = atOnce ? Infinity : this.#inFrames;
    this.#round.forEach((mesh, i) => this.#show(mesh, this.#levels[i]!));
  }

  /** In place: every frame, and every sample of a still picture, comes by. */
  #compare(condition: Condition, value: number | boolean): void {
    this.#stale ||= value !== this.#chosenFor[condition];
    this.#chosenFor[condition] = value;
  }

  /** `pixels`: of a unit of length at depth 1. */
  #list(view: View, pixels: number, isFixed: boolean): void {
    this.#round.length = this.#levels.length = 0;
    for (const mesh of this.#meshes) {
      const { round: name } = mesh;
      if (name === null) continue;
      const round = roundOf(name)!;
      const { elements } = mesh.parts[0]!.mesh.matrixWorld;
      const needed =
        isFixed || mesh.isFixed ? FIXED : segmentsIn(view, pixels / this.#tolerance, round, elements);
      this.#round.push(mesh);
      // Out of view it stays as it is.
      this.#levels.push(needed === null ? mesh.level : needed === FIXED ? FIXED : levelFor(needed, name));
    }
  }

  /** What the levels hold beyond the coarsest one, which the meshes have claimed. Equal ones count once. */
  #triangles(): number {
    distinct.clear();
    let total = 0;
    this.#round.forEach((mesh, i) => {
      const round = mesh.round!;
      const level = this.#levels[i]!;
      // Most are like the one before, and this is every frame's.
      if (level === this.#levels[i - 1] && round === this.#round[i - 1]!.round) return;
      const key = levelNumber(round, level);
      if (level === FIXED || distinct.has(key)) return;
      distinct.add(key);
      const more = trianglesOf(round, level) - trianglesOf(round, coarsestOf(round));
      total += mesh.wantsFlat ? more + flatTrianglesOf(more) : more;
    });
    return total;
  }

  /** The next coarser levels, all of them. False where there is none. */
  #coarsen(): boolean {
    let changed = false;
    this.#round.forEach(({ round }, i) => {
      const level = this.#levels[i]!;
      const coarser = level === FIXED ? FIXED : coarserThan(level, round!);
      changed ||= coarser < level;
      this.#levels[i] = coarser;
    });
    return changed;
  }

  #show(mesh: SceneMesh, level: number): void {
    if (level === mesh.level) return;
    const name = mesh.round!;
    if (this.#isAtHand(name, level)) mesh.level = level;
    else {
      this.#order(name, level);
      let next = level;
      // If it is the first picture, or the camera has jumped: what can be had at once.
      while (next > mesh.level && !this.#isAtHand(name, next)) next = coarserThan(next, name);
      if (next > mesh.level) mesh.level = next;
    }
  }

  /** It is built, or may be built in this frame. */
  #isAtHand(name: GeometryName, level: number): boolean {
    if (level === FIXED || isBuilt(levelKey(name, level))) return true;
    const triangles = trianglesOf(name, level);
    if (triangles > this.#mayBuild) return false;
    this.#mayBuild -= triangles;
    return true;
  }

  #order(name: GeometryName, level: number): void {
    const text = `${name} ${String(level)}`;
    if (this.#building.has(text)) return;
    this.#building.add(text);
    const wanted = (): boolean =>
      this.#round.some((mesh, i) => mesh.round === name && this.#levels[i] === level);
    const build = async (): Promise<void> => {
      try {
        await (await buildsCode()).buildLevel(levelKey(name, level), wanted);
      } catch {
        this.#inFrames = Infinity; // without that code, or the memory, finer shapes take longer frames
      }
      this.#building.delete(text);
      this.#stale = true;
      this.#built(this.#tolerance === SAMPLED_TOLERANCE);
    };
    void build();
  }
}

const distinct = new Set<number>();

const levelNumber = (name: GeometryName, level: number): number => GEOMETRIES.indexOf(name) * 2 ** 12 + level;

/**
 * At least so many segments as a level: a multiple of an eighth of the next power of two, so that at most a quarter is
 * more than needed and a camera that comes near passes few levels.
 */
export function levelFor(segments: number, name: GeometryName): number {
  const least = coarsestOf(name);
  const { most } = roundOf(name)!;
  if (segments >= most) return most;
  const step = segments <= 64 ? 8 : 2 ** Math.ceil(Math.log2(segments)) / 8;
  const level = Math.ceil(segments / step) * step;
  return level > least ? Math.min(level, most) : least;
}

/** A coarser level, about half the triangles; the coarsest one itself. */
const coarserThan = (level: number, name: GeometryName): number => levelFor(level / 1.5, name);

/**
 * Segments that keep the outline of a round shape close enough to the true one. `finest`: how many times the allowed
 * distance goes into a unit of length at depth 1. Null where the shape is out of view.
 */
export function segmentsIn(
  { frame, slopeX, slopeY }: View,
  finest: number,
  { gap, half, radius }: Round,
  m: readonly number[],
): number | null {
  const { origin, eye, right, up, back } = frame;
  // From the eye to the shape's middle.
  const x = m[12]! - origin[0] - eye[0];
  const y = m[13]! - origin[1] - eye[1];
  const z = m[14]! - origin[2] - eye[2];
  const depth = -(x * back[0] + y * back[1] + z * back[2]);
  const across = Math.abs(x * right[0] + y * right[1] + z * right[2]);
  const upward = Math.abs(x * up[0] + y * up[1] + z * up[2]);
  const size = stretch(m);
  const reach = size * radius;
  if (across - slopeX * depth > reach * Math.sqrt(1 + slopeX * slopeX)) return null;
  if (upward - slopeY * depth > reach * Math.sqrt(1 + slopeY * slopeY)) return null;
  if (depth < -reach) return null;
  const squared = x * x + y * y + z * z;
  const distance = Math.sqrt(squared);
  const ball = isBall(half, m, reach);
  const outline = ball
    ? ballOutline(distance, reach)
    : Math.max(distance - reach, distanceToBox(half, m, x, y, z));
  // The farther from the middle of the view, the more pixels an angle has.
  let cos = 1 / Math.sqrt(1 + slopeX * slopeX + slopeY * slopeY);
  if (distance > reach) {
    const sinReach = reach / distance;
    const cosReach = Math.sqrt(1 - sinReach * sinReach);
    const sinMiddle = Math.sqrt(across * across + upward * upward) / distance;
    cos = Math.max(cos, (depth / distance) * cosReach - sinMiddle * sinReach);
  }
  // The view's corner that is farthest from the middle of the shape.
  const corner = depth - slopeX * across - slopeY * upward;
  const cornerSquared = corner > 0 ? (corner * corner) / (1 + slopeX * slopeX + slopeY * slopeY) : 0;
  const fillsView = ball && (distance < reach || cornerSquared >= squared - reach * reach);
  const nearest = fillsView ? Math.max(outline, FACES * Math.abs(distance - reach)) : outline;
  return Math.sqrt((gap * size * finest) / (nearest * cos * cos));
}

/**
 * How many times farther from the round shape a picture without its outline may be. In the plain picture that is a
 * pixel: shading moves by at most as much, and has no edge that would show it. A sphere that fills the view takes 1.5
 * times as long in software without this (one light; see the bench).
 */
const FACES = 8;

/** Whether a shape is still a ball, of radius `reach`, under its matrix. */
function isBall(half: Vec3, m: readonly number[], reach: number): boolean {
  for (let axis = 0; axis < 3; axis++)
    if (Math.abs(half[axis as 0] * columnLength(m, axis) - reach) > ROUNDING * reach) return false;
  return true;
}

/** From the eye to where its rays touch a ball. Seen from inside it has no outline, and its surface counts. */
const ballOutline = (distance: number, radius: number): number =>
  distance < radius ? radius - distance : Math.sqrt(distance * distance - radius * radius);

/** At most the distance from the eye to a shape's box, whose middle is x, y, z away. */
function distanceToBox(half: Vec3, m: readonly number[], x: number, y: number, z: number): number {
  let outside = 0; // squared
  for (let axis = 0; axis < 3; axis++) {
    const length = columnLength(m, axis);
    if (length === 0) continue;
    const along = Math.abs(x * m[4 * axis]! + y * m[4 * axis + 1]! + z * m[4 * axis + 2]!) / length;
    const beyond = along - half[axis as 0] * length;
    if (beyond > 0) outside += beyond * beyond;
  }
  return Math.sqrt(outside);
}

function columnLength(m: readonly number[], axis: number): number {
  const x = m[4 * axis]!;
  const y = m[4 * axis + 1]!;
  const z = m[4 * axis + 2]!;
  return Math.sqrt(x * x + y * y + z * z);
}

/** Relative. A turned ball's axes are equal up to float64's rounding. */
const ROUNDING = 1e-9;
