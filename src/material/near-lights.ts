// How the lights of one mesh lie to its bounds: whether any stands at it, and where there are many small ones divided into
// cells. Looks anew only where lights, place or surface have changed. Knows neither programs nor frames.
import { Matrix4, type Mesh } from 'three';
import { divide } from '../light/light-grid.js';
import { areApart } from '../light/light-reach.js';
import { emptyPack } from '../light/pack-lights.js';
import { LightList } from './light-list.js';
import { boundsOf } from './mesh-lights.js';
import type { PhongLighting } from './phong-lighting.js';
import type { PhongMaterial } from './phong-material.js';

export class NearLights {
  readonly #list = new LightList();
  readonly #into = emptyPack();
  readonly #place = new Matrix4();
  #from: LightList | null = null;
  #version = -1;
  #surface = -1;
  #left = -1;
  #divided = false;
  #apart = false;

  /** Looks at `mesh` as it is now. */
  update(mesh: Mesh, material: PhongMaterial, lighting: PhongLighting): void {
    const from = lighting.lightsOf(mesh);
    const left = lighting.budgetLeft(mesh);
    const { surfaceVersion } = material;
    const same =
      this.#from === from &&
      this.#version === from.version &&
      this.#left === left &&
      (left === 0 || this.#surface === surfaceVersion) &&
      this.#place.equals(mesh.matrixWorld);
    if (same) return;
    this.#from = from;
    this.#version = from.version;
    this.#left = left;
    this.#surface = surfaceVersion;
    this.#place.copy(mesh.matrixWorld);
    const box = boundsOf(mesh, lighting.origin);
    this.#apart = box !== null && areApart(from.packed, box);
    this.#divided = box !== null && divide(from.packed, box, material.reflectance, left, this.#into);
    if (this.#divided) this.#list.take(this.#into);
  }

  /** No light stands at the mesh. */
  get apart(): boolean {
    return this.#apart;
  }

  /** The mesh's lights in cells; null where that is not worth it. */
  get cells(): LightList | null {
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
