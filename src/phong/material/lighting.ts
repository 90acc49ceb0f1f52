// What the materials of a picture share: its lights on their way to the GPU, the space that it is
// shaded in, and what its programs depend on.
import type { Camera, WebGLRenderer } from 'three';
import { LightSet } from '../light/light-set.js';
import type { Vec3 } from '../math/vector.js';
import { LightPacking } from './light-packing.js';
import { MeshLights } from './mesh-lights.js';
import { ProgramCache } from './program/program-cache.js';
import { ProgramNeeds } from './program/program-needs.js';
import { type ShadingFrame, ShadingSpace } from './shading-space.js';

export class PhongLighting {
  readonly lights: LightSet;
  readonly packing: LightPacking;
  readonly meshLights: MeshLights;
  readonly needs: ProgramNeeds;
  readonly space = new ShadingSpace();
  /** Specialised programs of this picture. */
  readonly programs = new ProgramCache();

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
    const { space, packing, needs } = this;
    space.follow(frame, camera);
    this.meshLights.begin(space.origin);
    this.programs.begin();
    needs.declare();
    packing.update(frame, space.origin);
    needs.fit(packing.buffer.packed.rows);
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
    this.programs.dispose();
    this.needs.renderer = null;
  }
}
