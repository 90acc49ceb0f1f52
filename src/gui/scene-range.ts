// The range that sliders for positions cover: the surroundings of the scene. Measured when meshes are added, removed or
// loaded, and not while one of them is being moved by a slider. World space, scene units.
import type { PhongViewer } from '../element/phong-viewer.js';
import type { Vec3 } from '../math/vector.js';
import { niceCeil } from '../math/round-number.js';
import { measure } from '../scene/bounds.js';
import { linear, type SliderScale } from './travel.js';

/** In radii of the scene, because lights are placed around a scene as well as inside it. */
const REACH = 3;

const EMPTY_REACH = 5;

export class SceneRange {
  readonly #viewer: PhongViewer;
  #center: Vec3 = [0, 0, 0];
  #reach = EMPTY_REACH;
  #stale = true;

  constructor(viewer: PhongViewer) {
    this.#viewer = viewer;
  }

  /** Marks the range as outdated: the next read measures the scene again. */
  expire(): void {
    this.#stale = true;
  }

  get center(): Vec3 {
    this.#measure();
    return this.#center;
  }

  /** Half the range of the sliders. */
  get reach(): number {
    this.#measure();
    return this.#reach;
  }

  /** For a position in world space. */
  place(axis: 0 | 1 | 2): SliderScale {
    this.#measure();
    const step = niceCeil(this.#reach / 500);
    const middle = Math.round(this.#center[axis] / step) * step;
    // If the scene is close to the origin, 0 is the middle of the sliders.
    const shift = Math.abs(middle) < this.#reach / 2 ? 0 : middle;
    return linear(shift - this.#reach, shift + this.#reach, step);
  }

  /** For a vector around zero: a direction, or a position in camera space. */
  vector(): SliderScale {
    return linear(-this.reach, this.reach, niceCeil(this.reach / 500));
  }

  #measure(): void {
    if (!this.#stale) return;
    this.#stale = false;
    const { scene } = this.#viewer;
    scene.updateMatrixWorld();
    const extent = measure(scene);
    const radius = extent.empty ? 0 : extent.radiusAbout(extent.center);
    this.#center = extent.center;
    this.#reach = radius > 0 ? niceCeil(REACH * radius) : EMPTY_REACH;
  }
}
