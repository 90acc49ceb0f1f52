// Where do sliders for places reach? About the scene, as large as it was when its meshes last came, went or loaded: not
// as it is while one of them is being dragged. World space, scene units.
import type { PhongViewer } from '../element/phong-viewer.js';
import type { Vec3 } from '../math/vector.js';
import { measure } from '../scene/bounds.js';
import { linear, niceCeil, type Travel } from './travel.js';

/** Of the scene's radius: lights stand around a scene, not only in it. */
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

  /** The scene has another size: it is measured when that is next asked for. */
  expire(): void {
    this.#stale = true;
  }

  get center(): Vec3 {
    this.#measure();
    return this.#center;
  }

  /** How far from the centre the sliders go. */
  get reach(): number {
    this.#measure();
    return this.#reach;
  }

  /** For a place in world space. */
  place(axis: 0 | 1 | 2): Travel {
    this.#measure();
    const step = niceCeil(this.#reach / 500);
    const middle = Math.round(this.#center[axis] / step) * step;
    // A scene that is hardly off the middle gets sliders whose middle is 0.
    const shift = Math.abs(middle) < this.#reach / 2 ? 0 : middle;
    return linear(shift - this.#reach, shift + this.#reach, step);
  }

  /** For a vector about nothing: a direction, or a place before the eye. */
  vector(): Travel {
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
