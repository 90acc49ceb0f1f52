// Where is the camera now, and how does the user move it? The camera's folder of the panel. Moves go through the viewer's public
// properties with the source `panel`. Reset returns to what was declared before the panel moved anything. Degrees, scene units.
import type { GUI } from 'lil-gui';
import { fieldsOf, moveCameraFrom } from '../element/internals.js';
import type { PhongViewer } from '../element/phong-viewer.js';
import type { CameraState } from '../element/viewer/camera.js';
import { sameValue } from '../fields/field-store.js';
import type { Vec3 } from '../math/vector.js';
import { Folder } from './folder.js';
import { Readout } from './readout.js';
import { addButton, addNumber, addVector, axesOf } from './rows.js';
import type { SceneRange } from './scene-range.js';
import { linear, logarithmic, numberText } from './travel.js';

const MOVED = ['theta', 'phi', 'radius', 'target'] as const;

/** Declared values; null for those that are not given. */
type Declaration = readonly unknown[];

export class CameraFolder {
  readonly folder: Folder;
  readonly #viewer: PhongViewer;
  readonly #range: SceneRange;
  #now: CameraState;
  /** The declaration before the panel's first move, and what the panel wrote since. Null before its first move. */
  #before: { readonly declared: Declaration; readonly written: Declaration } | null = null;

  constructor(root: GUI, viewer: PhongViewer, range: SceneRange) {
    this.#viewer = viewer;
    this.#range = range;
    this.#now = viewer.camera;
    this.folder = new Folder(root, 'Camera', (gui) => this.#build(gui));
  }

  update(): void {
    this.folder.update();
  }

  #build(gui: GUI): () => void {
    const viewer = this.#viewer;
    addNumber(
      gui,
      'θ azimuth °',
      linear(-180, 180, 1),
      () => this.#now.theta,
      (theta) => {
        this.#move(() => (viewer.theta = theta));
      },
    );
    addNumber(
      gui,
      'φ polar °',
      linear(0, 180, 1),
      () => this.#now.phi,
      (phi) => {
        this.#move(() => (viewer.phi = phi));
      },
    );
    const radius = addNumber(
      gui,
      'radius',
      this.#radiusTravel,
      () => this.#now.radius,
      (distance) => {
        this.#move(() => (viewer.radius = distance));
      },
    );
    new Readout(gui, () => this.#eyeText, 'eye');
    const target = addVector(
      gui,
      axesOf('target'),
      (axis) => this.#range.place(axis),
      () => this.#now.target,
      (place) => {
        this.#setTarget(place);
      },
    );
    addNumber(
      gui,
      'fov °',
      linear(1, 170, 1),
      () => viewer.fov,
      (fov) => (viewer.fov = fov),
    );
    const turning = addNumber(
      gui,
      'auto-rotate',
      linear(-90, 90, 1),
      () => viewer.autoRotate,
      (speed) => (viewer.autoRotate = speed),
    );
    turning.domElement.title = 'Degrees per second about y';
    addButton(gui, 'reset camera', () => {
      this.#reset();
    });
    return () => {
      this.#now = viewer.camera;
      radius.travel = this.#radiusTravel;
      target.forEach((row, axis) => {
        row.travel = this.#range.place(axis as 0 | 1 | 2);
      });
    };
  }

  get #radiusTravel() {
    return logarithmic(this.#range.reach / 100, this.#range.reach * 10);
  }

  /** Rounded to a thousandth of the distance, which removes rounding noise. */
  get #eyeText(): string {
    const { eye, radius } = this.#now;
    const unit = 10 ** (Math.floor(Math.log10(radius)) - 3);
    return eye.map((n) => numberText(Math.round(n / unit) * unit, unit)).join(', ');
  }

  /** Moves only the target. A radius of `auto` would be refitted, so the present radius is written first. */
  #setTarget(place: Vec3): void {
    const viewer = this.#viewer;
    this.#move(() => {
      if (viewer.radius === 'auto') viewer.radius = this.#now.radius;
      viewer.target = place;
    });
  }

  #move(write: () => void): void {
    const declared = this.#declaration;
    const unchanged = this.#before !== null && sameDeclaration(this.#before.written, declared);
    try {
      moveCameraFrom(this.#viewer, 'panel', write);
    } finally {
      this.#before = { declared: unchanged ? this.#before!.declared : declared, written: this.#declaration };
      this.#now = this.#viewer.camera;
    }
  }

  #reset(): void {
    const before = this.#before;
    const unchanged = before !== null && sameDeclaration(before.written, this.#declaration);
    const declared = unchanged ? before.declared : this.#declaration;
    this.#before = null;
    // Assigning a camera property moves the camera, even if the value is the same.
    moveCameraFrom(this.#viewer, 'panel', () => {
      MOVED.forEach((key, i) => fieldsOf(this.#viewer).set(key, declared[i]));
    });
  }

  get #declaration(): Declaration {
    const { store } = fieldsOf(this.#viewer);
    return MOVED.map((key) => (store.given(key) ? store.values[key] : null));
  }
}

const sameDeclaration = (a: Declaration, b: Declaration): boolean =>
  a.every((value, i) => sameValue(value, b[i]));
