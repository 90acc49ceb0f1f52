// The lights of one picture on their way to its materials: packs when lights or eye have changed, keeps the facts
// that programs are made by, and holds what all materials of the picture share. Knows neither meshes nor frames.
import { type Mesh, Vector3 } from 'three';
import { gatherFacts, type LightFacts, noFacts } from '../light/light-kind.js';
import { LightSet } from '../light/light-set.js';
import { emptyPack, packLights, type PackedLights, repackPlaces } from '../light/pack-lights.js';
import { SRGB } from '../math/color.js';
import { sameValue } from '../fields/field-store.js';
import type { Vec3 } from '../math/vector.js';
import type { LightList } from './light-list.js';
import { type MeshChoice, MeshLights, type ReflectingSurface } from './mesh-lights.js';

/**
 * Where a picture is seen from. Shading space has the world's axes and its origin at `origin`: differences to it are
 * taken in float64, so scenes far from the world's origin shade like scenes at it, and turning the eye about the
 * target leaves all light data as it is.
 */
export interface ShadingFrame {
  /** World position of shading space's origin: the camera's target. */
  readonly origin: Vec3;
  /** The eye in shading space. */
  readonly eye: Vec3;
  /** Camera basis, orthonormal, in world axes; back points from the target to the eye. */
  readonly right: Vec3;
  readonly up: Vec3;
  readonly back: Vec3;
}

export class PhongLighting {
  readonly lights: LightSet;
  /** Uniform `uEye`, shared by all materials. */
  readonly eye = { value: new Vector3() };
  /** What any light declared so far needs of a program. Only ever grows. */
  readonly facts: LightFacts = noFacts();
  /** Shade in linear light: colours decoded first, the sum encoded last. */
  linear = false;
  /** Colour, in 1/255, that may be given up per fragment for fewer lights. */
  errorBudget = 0;
  readonly #lists = new MeshLights();
  #origin: Vec3 = [0, 0, 0];
  readonly #packed: PackedLights = emptyPack();
  #packedFor = { version: -1, kindVersion: -1, linear: false, origin: this.#origin };
  /** The lights' kinds that facts and {@link #turning} were last found for. */
  #kindVersion = -1;
  /** A light turns with the eye. */
  #turning = false;
  #programVersion = 0;
  readonly #worldToShading = identity();
  readonly #cameraToShading = identity();

  constructor(lights = new LightSet()) {
    this.lights = lights;
  }

  /** World position that fragments are shaded relative to. */
  get origin(): Vec3 {
    return this.#origin;
  }

  /** Goes up when materials may need other programs: what lights need or the colour space has changed. */
  get programVersion(): number {
    return this.#programVersion;
  }

  /** The lights as last packed: how many took part, how many were sent. */
  get packed(): Readonly<PackedLights> {
    return this.#packed;
  }

  /** Before each frame: takes the eye and whatever changed. */
  update(frame: ShadingFrame): void {
    this.#lists.begin();
    this.#origin = frame.origin;
    this.eye.value.set(frame.eye[0], frame.eye[1], frame.eye[2]);
    if (this.#gather() || this.linear !== this.#packedFor.linear) this.#programVersion += 1;
    if (this.#packedFor.version !== this.lights.version || !this.#isSteady(frame)) this.#pack(frame);
  }

  /**
   * Leaves out for `mesh` the lights that cannot reach its bounds; without it a mesh is drawn with all. After
   * {@link update}, in every frame, with the mesh's world matrix up to date.
   */
  reach(mesh: Mesh, surface: ReflectingSurface): MeshChoice {
    // In linear light the last step, the curve, makes more of a small difference: its slope is largest at black.
    const budget = this.errorBudget / 255 / (this.linear ? SRGB.slope : 1);
    return this.#lists.choose(mesh, { origin: this.#origin, budget, surface });
  }

  /** The lights that `mesh` is drawn with. */
  lightsOf(mesh: object): LightList {
    return this.#lists.of(mesh);
  }

  /** How many lights reach any of these meshes. */
  reaching(meshes: Iterable<object>): number {
    return this.#lists.reaching(meshes);
  }

  /** How often light data has been sent. */
  get uploads(): number {
    return this.#lists.uploads;
  }

  /** Another GPU, or one that has lost everything: all is sent again. */
  restore(): void {
    this.#lists.restore();
  }

  /** Frees what the GPU holds; drawing again sends it again. */
  dispose(): void {
    this.#lists.dispose();
  }

  /** True where the lights need something of a program that none has needed before. */
  #gather(): boolean {
    const { kindVersion, values } = this.lights;
    if (this.#kindVersion === kindVersion) return false;
    this.#kindVersion = kindVersion;
    this.#turning = values.some(({ active, space }) => active && space === 'camera');
    const before = countTrue(this.facts);
    for (const light of values) gatherFacts(light, this.facts);
    return countTrue(this.facts) !== before;
  }

  /** Lights are packed as they last were, unless some have moved. */
  #isSteady({ origin }: ShadingFrame): boolean {
    const last = this.#packedFor;
    return (
      last.kindVersion === this.lights.kindVersion &&
      last.linear === this.linear &&
      sameValue(last.origin, origin) &&
      !this.#turning
    );
  }

  #pack(frame: ShadingFrame): void {
    const { version, kindVersion, values } = this.lights;
    const space = {
      worldToShading: this.#worldToShading,
      cameraToShading: this.#cameraToShading,
      linear: this.linear,
    };
    if (!this.#isSteady(frame) || !repackPlaces(space, this.#packed)) {
      const { origin, eye, right, up, back } = frame;
      setColumns(this.#worldToShading, X, Y, Z, [-origin[0], -origin[1], -origin[2]]);
      setColumns(this.#cameraToShading, right, up, back, eye);
      packLights(values, space, this.#packed);
    }
    this.#lists.take(this.#packed);
    this.#packedFor = { version, kindVersion, linear: this.linear, origin: frame.origin };
  }
}

const X: Vec3 = [1, 0, 0];
const Y: Vec3 = [0, 1, 0];
const Z: Vec3 = [0, 0, 1];

const identity = (): Float64Array => new Float64Array([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]);

function setColumns(m: Float64Array, x: Vec3, y: Vec3, z: Vec3, place: Vec3): void {
  m.set(x, 0);
  m.set(y, 4);
  m.set(z, 8);
  m.set(place, 12);
}

const countTrue = (facts: LightFacts): number => Object.values(facts).filter(Boolean).length;
