// Which lights each mesh of a picture is drawn with: all of them, or those that reach its bounds. Meshes that the same lights
// reach share one list. Works anew only where lights, surface or place have changed. Knows neither frames nor programs.
import { Box3, type BufferGeometry, Matrix4, type Mesh } from 'three';
import {
  type Box,
  forEachLight,
  type Reached,
  reachedLights,
  type Reflectance,
} from '../light/light-reach.js';
import type { PackedLights } from '../light/pack-lights.js';
import type { Vec3 } from '../math/vector.js';
import { LightList } from './light-list.js';

/** What of a material counts: what it gives back at most, and a number that goes up when that changes. */
export interface ReflectingSurface {
  readonly reflectance: Reflectance;
  readonly surfaceVersion: number;
}

/** What the choice is made from, besides mesh and lights. */
export interface ReachQuestion {
  readonly origin: Vec3;
  readonly surface: ReflectingSurface;
  /** Colour that may be given up, 1 being full. */
  readonly budget: number;
}

interface Choice {
  list: LightList;
  /** What of the budget is left over. */
  left: number;
  mask: Uint8Array;
  lights: number;
  surfaceVersion: number;
  budget: number;
  geometry: BufferGeometry | null;
  readonly place: Matrix4;
}

interface Subset {
  readonly list: LightList;
  lights: number;
  used: number;
}

export class MeshLights {
  /** The list of all lights that are sent. */
  readonly all = new LightList();
  readonly #subsets = new Map<string, Subset>();
  readonly #choices = new WeakMap<object, Choice>();
  #lights = 0;
  #uploads = 0;
  #some = false;

  /** The lights have changed. */
  take(packed: PackedLights): void {
    this.all.take(packed);
    this.#lights += 1;
    this.#some = packed.counts.spot > 0;
    for (const [key, { list, used }] of this.#subsets) {
      if (used >= this.#lights - 1) continue;
      this.#uploads += list.rows.uploads;
      list.rows.dispose();
      this.#subsets.delete(key);
    }
  }

  /** The list that `mesh` was last chosen, or all. */
  of(mesh: object): LightList {
    return this.#choices.get(mesh)?.list ?? this.all;
  }

  /** What may still be given up at each point of `mesh`, 1 being full. */
  budgetLeft(mesh: object): number {
    return this.#choices.get(mesh)?.left ?? 0;
  }

  /** How many lights reach any of these meshes; all where there are none. */
  reaching(meshes: Iterable<object>): number {
    const { packed } = this.all;
    let some = false;
    const reached = new Uint8Array(packed.sent);
    for (const mesh of meshes) {
      some = true;
      const choice = this.#choices.get(mesh);
      if (choice === undefined || choice.list === this.all) return packed.sent;
      forEachLight(packed, (light) => {
        if (choice.mask[light] === 1) reached[light] = 1;
      });
    }
    return some ? reached.reduce((sum, one) => sum + one, 0) : packed.sent;
  }

  /** Chooses the lights for `mesh`, whose world matrix is up to date. */
  choose(mesh: Mesh, question: ReachQuestion): LightList {
    const { geometry, matrixWorld } = mesh;
    let choice = this.#choices.get(mesh);
    if (choice === undefined) {
      const { budget } = question;
      const { surfaceVersion } = question.surface;
      choice = {
        ...{
          list: this.all,
          left: 0,
          mask: new Uint8Array(0),
          lights: -1,
          geometry: null,
          place: new Matrix4(),
        },
        ...{ surfaceVersion, budget },
      };
      this.#choices.set(mesh, choice);
    }
    const same =
      choice.lights === this.#lights &&
      choice.surfaceVersion === question.surface.surfaceVersion &&
      choice.budget === question.budget &&
      choice.geometry === geometry &&
      choice.place.equals(matrixWorld);
    if (same) return choice.list;
    choice.lights = this.#lights;
    choice.surfaceVersion = question.surface.surfaceVersion;
    choice.budget = question.budget;
    choice.geometry = geometry;
    choice.place.copy(matrixWorld);
    choice.list = this.#listFor(mesh, question, choice);
    return choice.list;
  }

  get uploads(): number {
    let sum = this.#uploads + this.all.rows.uploads;
    for (const { list } of this.#subsets.values()) sum += list.rows.uploads;
    return sum;
  }

  restore(): void {
    for (const list of this.#lists()) list.rows.restore();
  }

  dispose(): void {
    for (const list of this.#lists()) list.rows.dispose();
  }

  #listFor(mesh: Mesh, { origin, surface, budget }: ReachQuestion, choice: Choice): LightList {
    const { packed } = this.all;
    choice.left = budget;
    // Without a cone nothing is exactly out of reach.
    if (!this.#some && !(budget > 0 && packed.sent > 0)) return this.all;
    const box = boundsOf(mesh, origin);
    if (box === null) return this.all;
    reachedLights(packed, box, surface.reflectance, budget, reached);
    choice.left = budget - reached.given;
    if (reached.count === packed.sent) return this.all;
    choice.mask = reached.mask.slice(0, packed.sent);
    const key = asText.decode(choice.mask);
    let subset = this.#subsets.get(key);
    if (subset === undefined) {
      subset = { list: new LightList(), lights: -1, used: 0 };
      this.#subsets.set(key, subset);
    }
    subset.used = this.#lights;
    if (subset.lights !== this.#lights) {
      subset.lights = this.#lights;
      subset.list.select(packed, choice.mask);
    }
    return subset.list;
  }

  *#lists(): Iterable<LightList> {
    yield this.all;
    for (const { list } of this.#subsets.values()) yield list;
  }
}

const asText = new TextDecoder('latin1');
const reached: Reached = { mask: new Uint8Array(64), count: 0, given: 0 };
const bounds = new Box3();

/** The mesh's bounds in shading space; null where it has none. */
export function boundsOf({ geometry, matrixWorld }: Mesh, origin: Vec3): Box | null {
  if (geometry.boundingBox === null) geometry.computeBoundingBox();
  if (geometry.boundingBox === null) return null;
  const { min, max } = bounds.copy(geometry.boundingBox).applyMatrix4(matrixWorld);
  const box: Box = [
    min.x - origin[0],
    min.y - origin[1],
    min.z - origin[2],
    max.x - origin[0],
    max.y - origin[1],
    max.z - origin[2],
  ];
  return box.every((x, i) => Number.isFinite(x) && (i < 3 || x >= box[i - 3]!)) ? box : null;
}
