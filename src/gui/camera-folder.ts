// Where is the camera now, and how does the user move it? The camera's folder of the panel. It moves the camera as a drag does, with the
// source `panel`: the declared values stay, and reset returns to them. Degrees, scene units.
import type { GUI } from 'lil-gui';
import type { Pose } from '../camera/orbit.js';
import { fieldsOf, viewerCameras } from '../element/internals.js';
import type { PhongViewer } from '../element/phong-viewer.js';
import type { CameraState } from '../element/viewer/camera.js';
import { cameraOf, historyOf, valuesOf } from '../element/viewer/history.js';
import { Folder } from './folder.js';
import { Readout } from './readout.js';
import { explain } from './label.js';
import { addButton, addNumber, addVector, type Rows } from './rows.js';
import type { SceneRange } from './scene-range.js';
import { linear, logarithmic, numberText } from './travel.js';
import { AXES } from './vector-control.js';

export class CameraFolder {
  readonly folder: Folder;
  readonly #viewer: PhongViewer;
  readonly #range: SceneRange;
  #now: CameraState;

  constructor(root: GUI, viewer: PhongViewer, range: SceneRange) {
    this.#viewer = viewer;
    this.#range = range;
    this.#now = viewer.camera;
    const history = historyOf(viewer);
    this.folder = new Folder(
      root,
      'Camera',
      (write, gesture) => {
        history.edit(cameraOf(viewer), write, gesture);
      },
      (rows) => this.#build(rows),
    );
  }

  update(): void {
    this.folder.update();
  }

  #build(rows: Rows): () => void {
    const viewer = this.#viewer;
    addNumber(
      rows,
      'θ azimuth °',
      linear(-180, 180, 1),
      () => this.#now.theta,
      (theta) => {
        this.#move({ theta });
      },
    );
    addNumber(
      rows,
      'φ polar °',
      linear(0, 180, 1),
      () => this.#now.phi,
      (phi) => {
        this.#move({ phi });
      },
    );
    const radius = addNumber(
      rows,
      'radius',
      this.#radiusTravel,
      () => this.#now.radius,
      (distance) => {
        this.#move({ radius: distance });
      },
    );
    new Readout(rows.gui, () => this.#eyeText, 'eye');
    const target = addVector(
      rows,
      'target',
      AXES,
      (axis) => this.#range.place(axis),
      () => this.#now.target,
      (place) => {
        this.#move({ target: place });
      },
    );
    this.#addLens(rows);
    addButton(rows.gui, 'reset camera', () => {
      rows.edit(() => viewerCameras.get(viewer)?.reset('panel'), null);
    });
    return () => {
      this.#now = viewer.camera;
      radius.travel = this.#radiusTravel;
      target.travel = (axis) => this.#range.place(axis);
    };
  }

  /** The declared values, which may differ from the current camera. */
  #addLens({ gui }: Rows): void {
    const viewer = this.#viewer;
    const history = historyOf(viewer);
    const rows: Rows = {
      gui,
      edit: (write, gesture) => {
        history.edit(valuesOf(viewer), write, gesture);
      },
    };
    addNumber(
      rows,
      'fov °',
      linear(1, 170, 1),
      () => viewer.fov,
      (fov) => (viewer.fov = fov),
    );
    const turning = addNumber(
      rows,
      'auto-rotate',
      linear(-90, 90, 1),
      () => viewer.autoRotate,
      (speed) => (viewer.autoRotate = speed),
    );
    explain(turning.domElement, 'Degrees per second about y');
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

  /** Throws RangeError, as the properties do, for values outside their domain. Nothing fits the camera to the scene afterwards. */
  #move(part: Partial<Pose>): void {
    const viewer = this.#viewer;
    const { fields } = fieldsOf(viewer).store;
    for (const [key, value] of Object.entries(part)) fields[key as keyof Pose].check(value);
    const camera = viewerCameras.get(viewer);
    camera?.place({ pose: { ...camera.placement.pose, ...part }, framing: null }, 'panel');
    this.#now = viewer.camera;
  }
}
