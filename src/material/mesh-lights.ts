// Which lights each mesh of a picture is drawn with: all of them, or those that reach its bounds. Meshes that the same lights
// reach share one list. Works anew only where lights, surface or place have changed. Knows neither frames nor programs.
import { Box3, type BufferGeometry, Matrix4, type Mesh } from 'three';
import { type Box, type Reached, reachedLights, type Reflectance } from '../light/light-reach.js';
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

/** What was chosen for a mesh. */
export interface MeshChoice {
  readonly list: LightList;
  /** What may still be given up at each point, 1 being full. */
  readonly left: number;
  /** The mesh's bounds in shading space; null where it has none. */
  readonly box: Box | null;
  /** Goes up whenever the choice was made anew: its lights, their places or the mesh's may be others. */
  readonly version: number;
}

class Choice implements MeshChoice {
  readonly #mesh: Mesh;
  #box: Box | null | undefined;
  list: LightList;
  left = 0;
  version = 0;
  /** Null where all lights are meant. */
  subset: Subset | null = null;
  mask = new Uint8Array(0);
  lights = -1;
  surfaceVersion = -1;
  budget = 0;
  #geometry: BufferGeometry | null = null;
  #origin: Vec3 = [0, 0, 0];
  readonly #place = new Matrix4();

  constructor(mesh: Mesh, list: LightList) {
    this.#mesh = mesh;
    this.list = list;
  }

  /** Found when first asked for: it may take a pass over all vertices. */
  get box(): Box | null {
    if (this.#box === undefined) this.#box = boundsOf(this.#mesh, this.#origin);
    return this.#box;
  }

  /** Whether the mesh lies elsewhere, or has another shape, than when last asked. */
  moved(origin: Vec3): boolean {
    const { geometry, matrixWorld } = this.#mesh;
    const [x, y, z] = this.#origin;
    const stays =
      this.#geometry === geometry &&
      this.#place.equals(matrixWorld) &&
      x === origin[0] &&
      y === origin[1] &&
      z === origin[2];
    if (stays) return false;
    this.#geometry = geometry;
    this.#origin = [origin[0], origin[1], origin[2]];
    this.#place.copy(matrixWorld);
    this.#box = undefined;
    return true;
  }
}

interface Subset {
  readonly list: LightList;
  lights: number;
  /** The last round that a mesh was drawn with it in. */
  round: number;
}

export class MeshLights {
  /** The list of all lights that are sent. */
  readonly all = new LightList();
  readonly #subsets = new Map<string, Subset>();
  readonly #choices = new WeakMap<object, Choice>();
  #lights = 0;
  #round = 0;
  #uploads = 0;

  /** A frame begins, in which each mesh is chosen for: lists that the last one had no use for are freed. */
  begin(): void {
    for (const [key, subset] of this.#subsets) {
      if (subset.round === this.#round) continue;
      this.#uploads += subset.list.rows.uploads;
      subset.list.rows.dispose();
      subset.lights = -1; // whoever has chosen it chooses anew
      this.#subsets.delete(key);
    }
    this.#round += 1;
  }

  /** The lights have changed. */
  take(packed: PackedLights): void {
    this.all.take(packed);
    this.#lights += 1;
  }

  /** The list that `mesh` was last chosen, or all. */
  of(mesh: object): LightList {
    return this.#choices.get(mesh)?.list ?? this.all;
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
      for (let i = 0; i < packed.sent; i++) if (choice.mask[i] === 1) reached[i] = 1;
    }
    return some ? reached.reduce((sum, one) => sum + one, 0) : packed.sent;
  }

  /** Chooses the lights for `mesh`, whose world matrix is up to date. */
  choose(mesh: Mesh, { origin, surface, budget }: ReachQuestion): MeshChoice {
    let choice = this.#choices.get(mesh);
    if (choice === undefined) this.#choices.set(mesh, (choice = new Choice(mesh, this.all)));
    const { subset } = choice;
    if (subset !== null) subset.round = this.#round;
    const same =
      !choice.moved(origin) &&
      choice.lights === this.#lights &&
      (subset === null || subset.lights === this.#lights) &&
      choice.budget === budget &&
      (budget === 0 || choice.surfaceVersion === surface.surfaceVersion);
    if (same) return choice;
    choice.lights = this.#lights;
    choice.surfaceVersion = surface.surfaceVersion;
    choice.budget = budget;
    choice.version += 1;
    this.#find(choice, surface);
    return choice;
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

  #find(choice: Choice, surface: ReflectingSurface): void {
    const { packed } = this.all;
    const { budget } = choice;
    choice.left = budget;
    choice.subset = null;
    choice.list = this.all;
    // Without a cone nothing is exactly out of reach.
    if (packed.counts.spot === 0 && (budget === 0 || packed.sent === 0)) return;
    const { box } = choice;
    if (box === null) return;
    reachedLights(packed, box, surface.reflectance, budget, reached);
    choice.left = budget - reached.given;
    if (reached.count === packed.sent) return;
    const mask = reached.mask.subarray(0, packed.sent);
    if (choice.mask.length === mask.length) choice.mask.set(mask);
    else choice.mask = mask.slice();
    const subset = this.#subsetOf(mask);
    choice.subset = subset;
    choice.list = subset.list;
    subset.round = this.#round;
    if (subset.lights === this.#lights) return;
    subset.lights = this.#lights;
    subset.list.select(packed, mask);
  }

  #subsetOf(mask: Uint8Array): Subset {
    const key = asText.decode(mask);
    const present = this.#subsets.get(key);
    if (present !== undefined) return present;
    const subset = { list: new LightList(), lights: -1, round: this.#round };
    this.#subsets.set(key, subset);
    return subset;
  }

  *#lists(): Iterable<LightList> {
    yield this.all;
    for (const { list } of this.#subsets.values()) yield list;
  }
}

const asText = /* @__PURE__ */ new TextDecoder('latin1');
const reached: Reached = { mask: new Uint8Array(64), count: 0, given: 0 };
const bounds = /* @__PURE__ */ new Box3();

/** The mesh's bounds in shading space; null where it has none. */
function boundsOf({ geometry, matrixWorld }: Mesh, origin: Vec3): Box | null {
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
