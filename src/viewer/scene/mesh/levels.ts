// Gives the round shapes of a picture as many segments as its pixels show, and cuts flat ones that
// are large for the eye's distance. Camera, transforms and size alone decide: the same scene
// has the same triangles.
import type { Mesh } from 'three';
import type { Bounds } from '../../../phong/camera/fit.js';
import type { Shading } from '../../../phong/material/material-values.js';
import type { Frustum } from '../../../phong/geometry/frustum-clip.js';
import { keyOfCut, MOST_CUT_TRIANGLES } from '../../../phong/model/shapes/cut-faces.js';
import {
  cutFor,
  hasNoLarge,
  isLargeFor,
  levelIn,
  reducedLevelIn,
  within,
} from '../../../phong/model/shapes/segments.js';
import {
  coarsestOf,
  type GeometryName,
  roundOf,
  trianglesOf,
} from '../../../phong/model/shapes/shapes.js';
import type { Frame } from '../frame.js';
import { FIXED, type Level } from './shared-shapes.js';

/**
 * A picture may always have this many triangles, the fixed number of the teapot. Without them 24 %
 * of the pixels of a torus 60 pixels wide would be within a code of the round one's, and 31 % of a
 * teapot in 400 × 400; with them it is 100 % and 91 %. Meshes share them, so a thousand dots are
 * not a thousand fine spheres.
 */
const FREE_TRIANGLES = 16384;

/** Pictures whose outlines meet. */
interface SharedLevels {
  /** One of them shows a round shape by its fixed number of segments, so all do. */
  readonly isFixed: boolean;
}

/** What a mesh shows: perhaps a shape with automatic segments. */
interface LevelledContent {
  /** The shape that has them; null where it shows anything else. */
  readonly auto: GeometryName | null;
  /** Its number of segments is part of the picture. */
  readonly isFixed: boolean;
  /** The segments of {@link auto}, or `FIXED`, or how its faces are cut. */
  level: Level;
  readonly parts: readonly { readonly mesh: Mesh }[];
}

interface LevelledPicture {
  readonly style: { readonly shading: Shading };
  readonly meshes: Iterable<{ readonly shown: LevelledContent }>;
  /** In triangles. */
  readonly budget: { readonly limit: number; readonly used: number };
}

export class Levels {
  readonly #picture: LevelledPicture;
  /** Chooses together with other pictures; null: alone. */
  shared: SharedLevels | null = null;
  /** Round shapes; null after a change of the meshes. */
  #round: number | null = null;
  /** All shapes are flat, and shown whole. */
  #areWhole = true;
  /** The time was over: {@link choose} is to be called again. */
  isPaused = false;

  constructor(picture: LevelledPicture) {
    this.#picture = picture;
  }

  /**
   * The number of segments of round shapes is part of this picture: Gouraud or flat shading shows
   * it.
   */
  get isFixed(): boolean {
    if (this.#picture.style.shading !== 'phong') return true;
    for (const { shown } of this.#picture.meshes) {
      if (isRound(shown.auto) && shown.isFixed) return true;
    }
    return false;
  }

  /** Meshes show other contents. */
  changed(): void {
    this.#round = null;
  }

  /**
   * Chooses for a frame whose world matrices are up to date; builds and shows what is chosen.
   * `bounds`: all meshes are inside. Far from thousands of boxes it looks at none. After the time
   * `until` of `performance.now()` it builds no other shape.
   */
  choose(frame: Frame, bounds: Bounds | null, until = Infinity): void {
    this.isPaused = false;
    this.#round ??= [...this.#picture.meshes].filter(({ shown }) => isRound(shown.auto)).length;
    const count = this.#round;
    const wereWhole = this.#areWhole;
    this.#areWhole = count === 0 && hasNoLarge(frame.view, bounds);
    if (wereWhole && this.#areWhole) return;
    const isFixed = this.shared?.isFixed ?? false;
    for (const { shown } of this.#picture.meshes) {
      const { auto } = shown;
      if (auto === null) continue;
      let level: Level = FIXED;
      if (!isRound(auto)) {
        level = shown.isFixed ? FIXED : this.#flatLevelOf(shown, auto, frame.view);
      } else if (!isFixed && !shown.isFixed) {
        level = this.#levelOf(shown, auto, frame, count);
      }
      if (level === shown.level) continue;
      if (this.isPaused) return;
      shown.level = level;
      this.isPaused = performance.now() > until;
    }
  }

  /**
   * `count`: of round shapes. Finer levels than the coarsest one, which is claimed, take what room
   * is left.
   */
  #levelOf(
    { parts, level }: LevelledContent,
    name: GeometryName,
    { view, height, samples, share }: Frame,
    count: number,
  ): Level {
    const { elements } = parts[0]!.mesh.matrixWorld;
    const whole = levelIn(view, height, samples > 1, name, elements, FREE_TRIANGLES / count);
    if (whole === null) return level; // out of view it stays as it is
    const wanted =
      share < 1 ? Math.min(whole, reducedLevelIn(view, share * height, name, elements)) : whole;
    return within(this.#room + trianglesOf(name, coarsestOf(name)), wanted, name);
  }

  get #room(): number {
    const { limit, used } = this.#picture.budget;
    return limit - used;
  }

  #flatLevelOf({ parts, level }: LevelledContent, name: GeometryName, view: Frustum): Level {
    const { elements } = parts[0]!.mesh.matrixWorld;
    if (!isLargeFor(view, name, elements)) return FIXED;
    const room = this.#room + trianglesOf(name, undefined);
    if (name !== 'box' && name !== 'plane') {
      return trianglesOf(name, LARGE_SEGMENTS) <= room ? LARGE_SEGMENTS : FIXED;
    }
    if (MOST_CUT_TRIANGLES > room) return FIXED;
    const cut = cutFor(view, name, elements);
    return typeof level === 'object' && keyOfCut(level) === keyOfCut(cut) ? level : cut;
  }
}

const isRound = (name: GeometryName | null): boolean =>
  name !== null && roundOf(name) !== undefined;

/** Segments of a pyramid that is large for the eye's distance. */
const LARGE_SEGMENTS = 64;
