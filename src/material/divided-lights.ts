// The lights of one mesh, divided into cells of its bounds where there are many small ones. Divides anew only where lights,
// place or surface have changed. Knows neither programs nor frames.
import { Matrix4, type Mesh } from 'three';
import { divide, LEAST_DIVIDED } from '../light/light-grid.js';
import { emptyPack } from '../light/pack-lights.js';
import { LightList } from './light-list.js';
import { boundsOf } from './mesh-lights.js';
import type { PhongLighting } from './phong-lighting.js';
import type { PhongMaterial } from './phong-material.js';

export class DividedLights {
  readonly #list = new LightList();
  readonly #into = emptyPack();
  readonly #place = new Matrix4();
  #from: LightList | null = null;
  #version = -1;
  #surface = -1;
  #left = -1;
  #divided = false;

  /** The mesh's lights in cells; null where that is not worth it. */
  of(mesh: Mesh, material: PhongMaterial, lighting: PhongLighting): LightList | null {
    const from = lighting.lightsOf(mesh);
    if (from.packed.counts.point + from.packed.counts.spot < LEAST_DIVIDED) return null;
    const left = lighting.budgetLeft(mesh);
    const { surfaceVersion, reflectance } = material;
    const same =
      this.#from === from &&
      this.#version === from.version &&
      this.#left === left &&
      (left === 0 || this.#surface === surfaceVersion) &&
      this.#place.equals(mesh.matrixWorld);
    if (!same) {
      this.#from = from;
      this.#version = from.version;
      this.#left = left;
      this.#surface = surfaceVersion;
      this.#place.copy(mesh.matrixWorld);
      const box = boundsOf(mesh, lighting.origin);
      this.#divided = box !== null && divide(from.packed, box, reflectance, left, this.#into);
      if (this.#divided) this.#list.take(this.#into);
    }
    return this.#divided ? this.#list : null;
  }

  /** How often light data has been sent. */
  get uploads(): number {
    return this.#list.rows.uploads;
  }

  dispose(): void {
    this.#list.rows.dispose();
  }
}
