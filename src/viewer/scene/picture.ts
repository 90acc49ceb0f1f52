// What one viewer shows: scene, lights and camera. It is drawn alike for the page, for files and
// for samples.
import {
  Scene,
  type Material,
  type Mesh,
  type WebGLRenderer,
  type Object3D,
  type ShaderMaterial,
  Texture,
} from 'three';
import type { Bounds } from '../../phong/camera/fit.js';
import { Orbit } from '../../phong/camera/orbit.js';
import type { LightSet } from '../../phong/light/light-set.js';
import { PhongLighting } from '../../phong/material/lighting.js';
import type { ShadingStyle } from '../../phong/material/material-values.js';
import type { PictureView } from '../../phong/material/views.js';
import { FieldStore } from '../../phong/fields/field-store.js';
import { Budget } from '../../phong/model/budget.js';
import { MESH_FIELDS } from '../../phong/model/mesh-fields.js';
import { NO_CONTENT } from '../../phong/model/model.js';
import { fasterCode, lazyCode } from '../../phong/lazy-code.js';
import { AutoFit } from './auto-fit.js';
import { forgetBounds } from '../../phong/geometry/bounds.js';
import { Frame } from './frame.js';
import type { Region, Size } from '../../phong/math/region.js';
import { Animations } from './mesh/animations.js';
import { Levels } from './mesh/levels.js';
import type { Part } from './mesh/parts.js';
import type { SceneMesh } from './mesh/scene-mesh.js';
import { SharedMaterials } from './mesh/shared-materials.js';
import { ShownContent } from './mesh/shown-content.js';
import type { ViewportStats } from './viewport-stats.js';
import {
  copyFrame,
  drawnObjects,
  type SceneSnapshot,
} from '../../phong/geometry/scene-snapshot.js';

const specialCode = /* @__PURE__ */ fasterCode(
  /* @__PURE__ */ lazyCode(
    () => import('../../phong/material/program/special-programs.js'),
    'specialised programs',
  ),
);

/** From this many frames on it moves. Before, it only gets its files, its size and its shapes. */
const MOTION = 10;

export class Picture {
  readonly scene = new Scene();
  readonly orbit = new Orbit();
  readonly animations = new Animations();
  readonly budget = new Budget();
  readonly lighting: PhongLighting;
  readonly materials: SharedMaterials;
  readonly levels = new Levels(this);
  readonly fit = new AutoFit(this);
  readonly frame = new Frame(this.orbit);
  readonly nothing: ShownContent;
  readonly #meshes = new Set<SceneMesh>();
  readonly #changed: () => void;
  readonly #fitted: () => void;
  /** Counts the changes of anything but lights. */
  #version = 0;
  /** The version whose lights were sent last. */
  #lit = -1;
  #drawCalls = 0;
  /** The page has put objects of its own into the scene. */
  #hasOthers = false;
  /** Frames drawn, for {@link MOTION}. */
  #frames = 0;
  /** The version of the lighting's needs whose programs are there. */
  #needs = -1;

  /** `changed`: another version is to be drawn. `fitted`: `auto` has moved the camera. */
  constructor(lights: LightSet, changed: () => void, fitted: () => void) {
    this.lighting = new PhongLighting(lights);
    lights.changed.listen(changed);
    this.materials = new SharedMaterials(this.lighting);
    this.nothing = new ShownContent(NO_CONTENT, null, null, new FieldStore(MESH_FIELDS), this);
    this.#changed = changed;
    this.#fitted = fitted;
    this.scene.matrixWorldAutoUpdate = false; // `make` updates matrices, before it measures
  }

  /** In drawing order. */
  get meshes(): ReadonlySet<SceneMesh> {
    return this.#meshes;
  }

  /**
   * Counts the changes of what it shows. Two frames of one version, size and number of samples are
   * the same.
   */
  get version(): number {
    return this.#version + this.lighting.lights.version;
  }

  /** It is to be drawn again: something other than a light has changed. */
  invalidate(): void {
    this.#version += 1;
    this.#changed();
  }

  /**
   * Meshes were added or removed, or show another geometry; `moved`: this one was only moved. `auto`
   * is fitted again.
   */
  reshaped(moved?: Object3D): void {
    this.levels.changed();
    this.fit.reshaped(moved);
  }

  /** Measures the whole scene again, vertices included, and fits `auto` to it. */
  refit(): void {
    forgetBounds(this.scene);
    this.reshaped();
  }

  get style(): ShadingStyle {
    return this.materials.style;
  }

  set style(style: ShadingStyle) {
    this.materials.style = style;
    this.#restyle();
  }

  /** What is drawn in place of the shaded colours. Null, the default: these are drawn. */
  set view(view: PictureView | null) {
    this.lighting.packing.view = view;
    this.materials.restyle();
    this.#restyle();
  }

  #restyle(): void {
    for (const mesh of this.meshes) {
      mesh.restyle();
    }
    this.reshaped();
  }

  set linear(linear: boolean) {
    if (linear === this.lighting.linear) return;
    this.lighting.linear = linear;
    this.invalidate();
  }

  add(mesh: SceneMesh): void {
    this.#meshes.add(mesh);
    mesh.attach(this.scene);
    this.reshaped();
  }

  remove(mesh: SceneMesh): void {
    this.#meshes.delete(mesh);
    mesh.dispose();
    this.reshaped();
  }

  /**
   * The order in which the scene is drawn: meshes that are not among these, these, the page
   * author's own objects. Where surfaces coincide, the last one drawn shows.
   */
  arrange(meshes: readonly SceneMesh[]): void {
    for (const mesh of meshes) {
      if (this.#meshes.delete(mesh)) {
        this.#meshes.add(mesh);
      }
    }
    this.invalidate();
  }

  /**
   * Updates order and world matrices before drawing or measuring. A mesh that has not moved costs
   * one call. A user's objects are computed again each time, as three.js does.
   */
  updateMatrices(): void {
    const { children } = this.scene;
    let own = 0;
    for (const { shown } of this.#meshes) {
      const { root } = shown;
      if (root?.parent !== this.scene) continue; // the page may have put it into an object of its own
      if (children[own] !== root) {
        this.#sort();
      }
      own += 1;
    }
    for (let i = 0; i < children.length; i++) {
      children[i]!.updateMatrixWorld(i >= own);
    }
    this.#hasOthers = own < children.length;
  }

  /**
   * Samples a side of a pixel that can be drawn at once, as one picture of so many times the size.
   * Only one where something may be a number of pixels wide: lines and points of the page's own, or
   * lines between triangles. Call after {@link updateMatrices}.
   */
  get samplesASide(): number {
    return this.#hasOthers || this.lighting.packing.view?.separate === true ? 1 : 2;
  }

  #sort(): void {
    const ranks = new Map<Object3D, number>();
    for (const { shown } of this.#meshes) {
      const { root } = shown;
      if (root !== null) {
        ranks.set(root, ranks.size);
      }
    }
    const rank = (object: Object3D): number => ranks.get(object) ?? ranks.size;
    this.scene.children.sort((a, b) => rank(a) - rank(b));
  }

  /** Fits the camera to the scene if radius or target is `auto` and something has changed. */
  settle(): void {
    if (this.fit.settle()) {
      this.#fitted();
    }
  }

  /**
   * The meshes' bounds, measured unless nothing has changed since; null where the scene shows
   * nothing.
   */
  measure(): Bounds | null {
    this.settle();
    return this.fit.measure().bounds;
  }

  /**
   * Computes the frame that {@link draw} draws: the scene as it is now, at this size in pixels, of
   * which `share` a side are drawn. `until`: see {@link Levels.choose}.
   */
  make(size: Size, samples: number, share = 1, until?: number): void {
    const { frame, scene } = this;
    this.settle();
    this.updateMatrices();
    if (frame.update(this.fit.fov, size, samples, this.#version, share) || this.levels.isPaused) {
      this.levels.choose(frame, this.fit.measure().bounds, until);
    }
    frame.aim(scene, this.fit.depthBounds());
  }

  /**
   * Call after {@link needsPrograms}. Whether programs of the next drawing are being compiled in the
   * background. Lights that no uniform array holds any more are found out later. Thousands of
   * materials may share a program: one of them asks for it, which takes 40 µs.
   */
  compiles(renderer: WebGLRenderer): boolean {
    const asked: string[] = [];
    const compiling = [...this.materials.all].filter((one) =>
      one.compiles(renderer, this.frame.camera, asked),
    );
    if (compiling.length > 0) return true;
    this.#needs = this.lighting.needs.version;
    return false;
  }

  /** Declares what the lights need. True where {@link compiles} may be. */
  needsPrograms(): boolean {
    const { needs } = this.lighting;
    needs.declare();
    return this.#needs !== needs.version;
  }

  /** Draws {@link frame}, or the part of it that `part` is, which need not lie on whole pixels. */
  draw(renderer: WebGLRenderer, part?: Region): void {
    const { frame, lighting, scene } = this;
    if (part !== undefined) {
      frame.show(part);
    }
    // The samples of one picture have its lights, and count as no frames for programs.
    if (frame.samples === 1 || this.#lit !== this.version) {
      lighting.updateFrame(frame.shading, frame.camera);
      this.#specialise();
    }
    this.#lit = this.version;
    lighting.space.mapBias.value = mapBiasOf(frame.samples, this.samplesASide);
    renderer.render(scene, frame.camera);
    this.#drawCalls = renderer.info.render.calls;
  }

  /** Specialised programs are used from the next frame on, once their code is there. */
  #specialise(): void {
    const { lighting } = this;
    this.#frames += 1;
    if (lighting.special !== null || this.#frames < MOTION) return;
    const code = specialCode();
    if (code !== null) {
      lighting.special = new code.SpecialPrograms(lighting, MOTION);
    }
  }

  /**
   * Everything that a frame of this size shows, as it is now. `ownerOf` names the owner of a mesh.
   */
  snapshot<Owner>(
    { width, height }: Size,
    samples: number,
    ownerOf: (mesh: SceneMesh) => Owner,
  ): SceneSnapshot<Owner> {
    this.make({ width, height }, samples);
    const { camera, shading } = this.frame;
    const owners = new Map<Object3D, Owner>();
    for (const mesh of this.meshes) {
      for (const part of mesh.shown.parts) {
        owners.set(part.mesh, ownerOf(mesh));
      }
    }
    const objects = drawnObjects(this.scene, camera, (object) => owners.get(object));
    return { width, height, frame: copyFrame(shading), camera: camera.clone(), objects };
  }

  /** Gives back what the GPU holds; drawing sends it again. */
  release(): void {
    // Not only what is in the scene: a content may wait for the one after it to be drawn, and
    // three.js keeps each material that it has drawn alive, and so the lighting and the viewer.
    const materials = new Set<Material>(this.materials.all);
    this.scene.traverse((object) => {
      const { geometry, material = [] } = object as Partial<Mesh>;
      geometry?.dispose();
      for (const one of [material].flat()) {
        materials.add(one);
      }
    });
    this.materials.sweep();
    for (const { geometries } of this.meshes) {
      for (const geometry of geometries) {
        geometry.dispose();
      }
    }
    for (const material of materials) {
      material.dispose();
      const { uniforms = {} } = material as Partial<ShaderMaterial>;
      for (const { value } of Object.values(uniforms)) {
        if (value instanceof Texture) {
          value.dispose();
        }
      }
    }
    this.lighting.dispose();
  }

  get stats(): Pick<
    ViewportStats,
    'lightsActive' | 'lightsSent' | 'lightsSentByMesh' | 'uploads' | 'drawCalls'
  > {
    const { lighting } = this;
    const reaching = (parts: readonly Part[]): number =>
      lighting.meshLights.countReaching(parts.map(({ mesh }) => mesh));
    const shown = Array.from(this.meshes, (mesh) => mesh.shown.parts).filter(
      (parts) => parts.length > 0,
    );
    return {
      lightsActive: lighting.packing.buffer.packed.active,
      lightsSent: reaching(shown.flat()),
      lightsSentByMesh: shown.map(reaching),
      uploads: lighting.meshLights.uploads,
      drawCalls: this.#drawCalls,
    };
  }
}

/**
 * Levels of maps suit a whole pixel, and a sample stands for a share of it. Left so, a floor whose
 * texture is minified 2 to 16 times is 10.1 codes (RMSE) off the exact mean, whatever the number of
 * samples; by this formula 1.7, 0.50 and 0.33 with 16, 64 and 256 (H200). −1/2, the share's side,
 * leaves 1.3 times the error with 64: a level's texels reach farther than the share. GPUs may stop
 * at −2. Where a sample is drawn as a pixel of a larger picture, its levels are finer already.
 */
const mapBiasOf = (samples: number, side: number): number =>
  samples === 1 ? 0 : Math.log2(side) - (2 / 3) * Math.log2(samples);
