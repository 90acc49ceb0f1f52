// How the lights of one mesh lie to its bounds: whether any stands at it, and where there are many small ones divided into
// cells. Looks anew only where they were chosen anew. Knows neither meshes nor programs nor frames.
import { divide } from '../light/light-grid.js';
import { areApart } from '../light/light-apart.js';
import { emptyPack } from '../light/pack-lights.js';
import { LightList } from './light-list.js';
import type { MeshChoice, ReflectingSurface } from './mesh-lights.js';

/**
 * Looks in vain that are skipped at most before the next: one can take tens of milliseconds (measured: 27 with 43 wide spots),
 * which lights that move would cost in every frame.
 */
const MOST_SKIPPED = 63;

export class NearLights {
  readonly #list = new LightList();
  readonly #into = emptyPack();
  #version = -1;
  /** A division was skipped, and how many times more one is to be. */
  #owed = false;
  #skips = 0;
  /** Twice as many after each one in vain. */
  #nextSkips = 0;
  #divided = false;
  #apart = false;

  /** Looks at what was chosen as it is now; again in each frame. */
  update(choice: MeshChoice, surface: ReflectingSurface): void {
    const { box, list, left, version } = choice;
    const changed = this.#version !== version;
    if (!changed && !this.#owed) return;
    this.#version = version;
    if (changed) this.#apart = box !== null && areApart(list.packed, box);
    if (changed) this.#divided = false;
    this.#owed = this.#skips > 0;
    if (this.#owed) {
      this.#skips -= 1;
      return;
    }
    this.#divided = box !== null && divide(list.packed, box, surface.reflectance, left, this.#into);
    this.#nextSkips = this.#divided ? 0 : Math.min(2 * this.#nextSkips + 1, MOST_SKIPPED);
    this.#skips = this.#nextSkips;
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
