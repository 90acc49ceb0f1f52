// What the materials of a picture share: its lights on their way to the GPU, the space that it is
// shaded in, and what its programs depend on.
import type { Camera, WebGLRenderer } from 'three';
import { LightSet } from '../light/light-set.js';
import { LightPacking } from './light-packing.js';
import { MeshLights } from './mesh-lights.js';
import { ProgramNeeds } from './program/program-needs.js';
import type { SpecialPrograms } from './program/special-programs.js';
import { type ShadingFrame, ShadingSpace } from './shading-space.js';

export class PhongLighting {
  readonly lights: LightSet;
  readonly packing: LightPacking;
  readonly meshLights: MeshLights;
  readonly needs: ProgramNeeds;
  readonly space = new ShadingSpace();
  /** Specialised programs of this picture; null while their code is not there. */
  special: SpecialPrograms | null = null;
  #pass = 0;
  /** What {@link passOf} saw last. */
  #frame = 0;
  #camera: Camera | null = null;

  constructor(lights = new LightSet()) {
    this.lights = lights;
    this.packing = new LightPacking(lights);
    this.meshLights = new MeshLights(this.packing.buffer);
    this.needs = new ProgramNeeds(lights);
  }

  /**
   * Shade in linear light: colours are decoded first, and the sum is encoded last. Default false.
   */
  get linear(): boolean {
    return this.packing.space.linear;
  }

  set linear(linear: boolean) {
    this.packing.space.linear = linear;
    this.needs.restyled();
  }

  /**
   * Call before each frame: takes whatever changed about the lights. The frame's eye is relative to
   * the origin, more precise than world coordinates. `camera` is the one that stands there:
   * vertices are then placed by the frame, not by its matrices.
   */
  updateFrame(frame: ShadingFrame, camera: Camera | null = null): void {
    const { space, packing, needs } = this;
    this.#pass += 1;
    space.follow(frame, camera);
    this.meshLights.begin(space.origin);
    this.special?.begin();
    needs.declare();
    packing.update(frame, space.origin);
    needs.fit(packing.buffer.packed.rows);
  }

  /**
   * Call before each draw: counts the passes over the meshes. In one, a frame of three.js seen by one
   * camera, draws differ by their meshes alone.
   */
  passOf(renderer: WebGLRenderer, camera: Camera): number {
    const { frame } = renderer.info.render;
    if (frame !== this.#frame || camera !== this.#camera || renderer !== this.needs.renderer) {
      this.#frame = frame;
      this.#camera = camera;
      this.#pass += 1;
    }
    return this.#pass;
  }

  /** Call before drawing with `renderer`. Another renderer is sent everything again. */
  drawWith(renderer: WebGLRenderer): void {
    if (this.needs.renderer === renderer) return;
    this.dispose();
    this.needs.renderer = renderer;
    this.needs.fit(this.packing.buffer.packed.rows);
  }

  /** Frees what the GPU holds; drawing again sends it again. */
  dispose(): void {
    this.meshLights.dispose();
    this.special?.dispose();
    this.needs.renderer = null;
  }
}
