// The lights of one picture on their way to its materials: packs them when lights, origin or colour
// space changed, collects the features that programs need, and holds what all materials of the
// picture share.
import { type Camera, Matrix4, type Mesh, Vector3, type WebGLRenderer } from 'three';
import { sameValue } from '../fields/field-store.js';
import { declaredFeatures } from '../light/light-features.js';
import { LightSet } from '../light/light-set.js';
import { moveLights, packLights, type PackedLights } from '../light/pack-lights.js';
import { dot, type Vec3 } from '../math/vector.js';
import { type Device, deviceOf } from './device.js';
import type { LightBuffer } from './light-buffer.js';
import { MeshLights } from './mesh-lights.js';
import { ProgramCache } from './program/program-cache.js';
import type { Form } from './program/variant.js';
import type { PictureView } from './views.js';

/**
 * From where a picture is seen. Shading space has the world's axes and its origin at `origin`.
 * Differences to it are taken in float64, so that scenes far from the world's origin shade like
 * scenes at it. It does not move while the camera turns about its target, and the packed lights
 * stay as they are.
 */
export interface ShadingFrame {
  /** World position of shading space's origin: the camera's target. */
  readonly origin: Vec3;
  readonly eye: Vec3;
  /** Camera basis, orthonormal, in world axes; back points from the target to the eye. */
  readonly right: Vec3;
  readonly up: Vec3;
  readonly back: Vec3;
}

/**
 * Most lights that software inlines: 16 take 291 ms to compile, 32 take 897 (SwiftShader on two
 * cores).
 */
const MOST_INLINED = 16;

export class PhongLighting {
  readonly lights: LightSet;
  /** Uniform `uEye`, shared by all materials. */
  readonly eye = { value: new Vector3() };
  /** Uniform `uShadingToClip`, shared by all materials; see {@link aim}. */
  readonly clip = { value: new Matrix4() };
  /**
   * Uniform `uMapBias`, shared by all materials: levels added to the one that a map is sampled
   * from. Default 0.
   */
  readonly mapBias = { value: 0 };
  /** Specialised programs of this picture. */
  readonly programs = new ProgramCache();
  readonly #meshLights = new MeshLights();
  /**
   * Shown in place of the shaded colour; null: nothing. Materials need a call of `setStyle`
   * afterwards.
   */
  view: PictureView | null = null;
  #origin: Vec3 = [0, 0, 0];
  #declared = 0;
  #restyles = 0;
  /** Versions of the light set, and what else the lights were last packed for. */
  #packedFor = { lights: -1, kinds: -1, view: null as PictureView | null, linear: false };
  /** This frame changed the packed lights. */
  #changed = false;
  /** A light turns with the eye, active or not. */
  #followsCamera = false;
  #capacity = 0;
  #device: Device | null = null;
  #uploads = 0;
  /** Shading space to the view of the frame's own camera. */
  readonly #frameView = new Matrix4();
  #frameCamera: Camera | null = null;
  /** Goes up with {@link clip}. */
  #aims = 0;
  readonly #aimed = { view: new Matrix4(), projection: new Matrix4() };
  readonly #worldToShading = new Matrix4();
  readonly #cameraToShading = new Matrix4();
  readonly #space = {
    worldToShading: this.#worldToShading.elements,
    cameraToShading: this.#cameraToShading.elements,
    linear: false,
  };

  constructor(lights = new LightSet()) {
    this.lights = lights;
  }

  /**
   * Shade in linear light: colours are decoded first, and the sum is encoded last. Default false.
   */
  get linear(): boolean {
    return this.#space.linear;
  }

  set linear(linear: boolean) {
    this.#space.linear = linear;
    this.restyled();
  }

  /** Other programs may be needed. */
  restyled(): void {
    this.#restyles += 1;
  }

  /** Goes up with what decides which general programs are needed. */
  get needs(): number {
    return this.#restyles + this.lights.kindVersion;
  }

  /** Adds the features of all lights to {@link declared}. */
  declare(): void {
    this.#declared |= declaredFeatures(this.lights.values);
  }

  /** World position that fragments are shaded relative to. */
  get origin(): Vec3 {
    return this.#origin;
  }

  /** What all lights since load need: see {@link declaredFeatures}. Bits are only ever added. */
  get declared(): number {
    return this.#declared;
  }

  get packed(): Readonly<PackedLights> {
    return this.#meshLights.all.packed;
  }

  /** How often light data that differs from the last draw's was sent. */
  get uploads(): number {
    return this.#uploads;
  }

  /**
   * Call before each frame, after moving the camera: takes its world matrix and whatever changed
   * about the lights.
   * @param camera any three.js camera with an up-to-date `matrixWorld`
   * @param target where the scene is, in world coordinates: shading is computed relative to it.
   * Default: the world's origin. For scenes far away give their centre, and keep it still while
   * only the camera moves.
   */
  update(camera: Camera, target: Vec3 = [0, 0, 0]): void {
    const e = camera.matrixWorld.elements;
    this.updateFrame({
      origin: target,
      eye: [e[12] - target[0], e[13] - target[1], e[14] - target[2]],
      right: [e[0], e[1], e[2]],
      up: [e[4], e[5], e[6]],
      back: [e[8], e[9], e[10]],
    });
  }

  /**
   * The same from a frame whose eye is known relative to the origin, more precisely than world
   * coordinates can say. `camera` is the one that stands there: vertices are then placed by the
   * frame, not by its matrices.
   */
  updateFrame(frame: ShadingFrame, camera: Camera | null = null): void {
    const { origin, eye } = frame;
    this.#frameCamera = camera;
    writeView(this.#frameView, frame, eye);
    this.eye.value.set(eye[0], eye[1], eye[2]);
    const moved = !sameValue(origin, this.#origin);
    if (moved) {
      this.#origin = [origin[0], origin[1], origin[2]];
    }
    this.#meshLights.begin(this.#origin);
    this.programs.begin();
    this.#changed = false;
    const { lights, kinds, view, linear } = this.#packedFor;
    const isOther = view !== this.view || linear !== this.linear;
    const { values, version, kindVersion } = this.lights;
    if (kinds !== kindVersion) {
      this.declare();
      this.#followsCamera = values.some(({ space }) => space === 'camera');
    }
    if (isOther || moved || this.#followsCamera || lights !== version) {
      this.#pack(frame, isOther || kinds !== kindVersion);
    }
  }

  /**
   * Call before each draw: updates {@link clip} to `camera`. Returns a version that increments when
   * it changes.
   */
  aim(camera: Camera): number {
    const { view: last, projection } = this.#aimed;
    const seen = camera === this.#frameCamera ? this.#frameView : this.#viewOf(camera);
    if (last.equals(seen) && projection.equals(camera.projectionMatrix)) return this.#aims;
    last.copy(seen);
    projection.copy(camera.projectionMatrix);
    this.clip.value.multiplyMatrices(projection, last);
    return (this.#aims += 1);
  }

  /** The lights that `mesh` is drawn with. Its world matrix must be up to date. */
  lightsOf(mesh: Mesh): LightBuffer {
    return this.#meshLights.of(mesh);
  }

  /** The same lights in a grid over the mesh; null where that is not worth it. */
  gridOf(mesh: Mesh): LightBuffer | null {
    return this.#meshLights.gridOf(mesh);
  }

  /** How many lights reach any of these meshes; all of them where there are no meshes. */
  countReaching(meshes: Iterable<Mesh>): number {
    const list = [...meshes];
    const { sent } = this.packed;
    if (list.length === 0) return sent;
    let count = 0;
    for (let light = 0; light < sent; light++) {
      if (list.some((mesh) => this.#meshLights.reaches(mesh, light))) {
        count += 1;
      }
    }
    return count;
  }

  /** Call before drawing with `renderer`. Another renderer is sent everything again. */
  drawWith(renderer: WebGLRenderer): void {
    if (this.#device?.renderer === renderer) return;
    this.dispose();
    this.#device = deviceOf(renderer);
    this.#capacity = 0;
    this.#fit();
  }

  /** Rows of the uniform array in general programs, or 0 for a texture. */
  get capacity(): number {
    return this.#device?.capacities[this.#capacity] ?? 0;
  }

  /** The form of a specialised program for these lights; null if the general program is best. */
  formFor(buffer: LightBuffer, grid: LightBuffer | null): Form | null {
    if (this.#device === null) return null;
    if (grid !== null) return 'grid';
    const { sent } = buffer.packed;
    const { software, capacities } = this.#device;
    // Inlined numbers that change in every frame would make a key each, for nothing.
    if (software) return sent <= MOST_INLINED && !this.#changed ? 'inlined' : null;
    return this.#capacity < capacities.length ? 'counted' : null;
  }

  /** Counts a draw that sent these lights. */
  countUpload(buffer: LightBuffer): void {
    if (buffer.counted === buffer.revision) return;
    buffer.counted = buffer.revision;
    this.#uploads += 1;
  }

  /** Frees what the GPU holds; drawing again sends it again. */
  dispose(): void {
    this.#meshLights.dispose();
    this.programs.dispose();
    this.#device = null;
  }

  #viewOf({ matrixWorldInverse }: Camera): Matrix4 {
    const [x, y, z] = this.#origin;
    return view.makeTranslation(x, y, z).premultiply(matrixWorldInverse);
  }

  /** `all`: more than places and the space's matrices may have changed. */
  #pack(frame: ShadingFrame, all: boolean): void {
    const [x, y, z] = frame.origin;
    const buffer = this.#meshLights.all;
    const { packed, revision } = buffer;
    const { values, version, kindVersion } = this.lights;
    const space = this.#space;
    this.#worldToShading.makeTranslation(-x, -y, -z);
    writeCamera(this.#cameraToShading, frame, frame.eye);
    if (this.view !== null) {
      this.view.pack(values, space, packed);
    } else if (all || !moveLights(space, packed)) {
      packLights(values, space, packed);
    }
    this.#packedFor = {
      lights: version,
      kinds: kindVersion,
      view: this.view,
      linear: space.linear,
    };
    this.#fit();
    buffer.changed();
    this.#changed = buffer.revision !== revision;
  }

  /**
   * Makes the uniform array long enough. It never shrinks: lights that come and go compile once.
   */
  #fit(): void {
    const { rows } = this.packed;
    const capacities = this.#device?.capacities ?? [];
    while (rows > (capacities[this.#capacity] ?? Infinity)) {
      this.#capacity += 1;
    }
  }
}

/** Overwritten by each call of `#viewOf`. */
const view = /* @__PURE__ */ new Matrix4();

type Axes = Pick<ShadingFrame, 'right' | 'up' | 'back'>;

/** Writes the matrix from the view of an eye to the space of these axes' coordinates. */
export function writeCamera(into: Matrix4, { right, up, back }: Axes, eye: Vec3): void {
  // oxfmt-ignore
  into.set(
    right[0], up[0], back[0], eye[0],
    right[1], up[1], back[1], eye[1],
    right[2], up[2], back[2], eye[2],
    0, 0, 0, 1,
  );
}

/** Writes the inverse of {@link writeCamera}'s matrix. */
export function writeView(into: Matrix4, { right, up, back }: Axes, eye: Vec3): void {
  // oxfmt-ignore
  into.set(
    right[0], right[1], right[2], -dot(right, eye),
    up[0], up[1], up[2], -dot(up, eye),
    back[0], back[1], back[2], -dot(back, eye),
    0, 0, 0, 1,
  );
}
