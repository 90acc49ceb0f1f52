// How does the user edit a light? One row per attribute of <phong-light>, written through the element's public properties. Units as
// in HTML. Knows neither the other lights nor the panel around it.
import type { GUI } from 'lil-gui';
import type { ViewerText } from '../element/fields/text-list.js';
import { fieldsOf } from '../element/internals.js';
import { numberedName, type PhongLight } from '../element/phong-light.js';
import type { PhongViewer } from '../element/phong-viewer.js';
import { isSpot, kindOf } from '../light/light-features.js';
import { LIGHT_SPACES } from '../light/light-state.js';
import type { Vec3 } from '../math/vector.js';
import { historyOf, valuesOf } from '../element/viewer/history.js';
import type { ChildEditor } from './child-editor.js';
import type { ChildFolder } from './child-folders.js';
import { Folder } from './folder.js';
import { KindChoice, LIGHT_KINDS } from './kind-choice.js';
import { explain, label, type Say } from './label.js';
import {
  addChoice,
  addColor,
  addFlag,
  addNumber,
  addText,
  addVector,
  type Edit,
  named,
  type Rows,
} from './rows.js';
import type { SceneRange } from './scene-range.js';
import type { TextControl } from './text-control.js';
import { linear, logarithmic } from './travel.js';
import { AXES } from './vector-control.js';

/** Tooltip of the kind. */
const KIND_RULE: ViewerText =
  'Directional: w = 0. Point: w = 1. Spot: w = 1 with a cone or decay; the other kinds set aperture 180 and cutoff 0.';

/** Initial end of the brightness slider. */
const USUAL_BRIGHTNESS = 4;

export class LightFolder implements ChildFolder {
  readonly folder: Folder;
  readonly #light: PhongLight;
  readonly #viewer: PhongViewer;
  readonly #range: SceneRange;
  readonly #editor: ChildEditor<PhongLight>;
  readonly #edit: Edit;
  readonly #kind = new KindChoice();
  readonly #switch = document.createElement('input');
  #nameRow: TextControl | null = null;
  #index = -1;
  #name = '';
  #title = '';

  constructor(
    group: GUI,
    light: PhongLight,
    viewer: PhongViewer,
    range: SceneRange,
    editor: ChildEditor<PhongLight>,
  ) {
    this.#light = light;
    this.#viewer = viewer;
    this.#range = range;
    this.#editor = editor;
    const history = historyOf(viewer);
    this.#edit = (write, gesture) => {
      history.edit(valuesOf(light), write, gesture);
    };
    this.folder = new Folder(group, null, this.#edit, (rows) => this.#build(rows));
    this.#addSwitch();
    editor.listenToKeys(this.folder, light, () => {
      this.folder.gui.open();
      this.#nameRow?.input.focus();
    });
  }

  update(index: number): void {
    const { name, active } = fieldsOf(this.#light).store.values;
    if (index !== this.#index || name !== this.#name) {
      this.#index = index;
      this.#name = name;
      label(this.folder.gui.$title, (say) => {
        this.#writeTitle(say);
      });
    }
    this.#switch.checked = active;
    this.folder.gui.domElement.classList.toggle('off', !active);
    this.folder.update();
  }

  #writeTitle(say: Say): void {
    // The same default as the element's `name`, without its search through all siblings, which is slow with hundreds of lights.
    const name = this.#name === '' ? numberedName(this.#index, this.#viewer.texts) : this.#name;
    this.#title = name;
    this.folder.gui.title(name);
    this.#switch.setAttribute('aria-label', say('{name} active', { name }));
    if (this.#nameRow !== null) this.#nameRow.input.placeholder = name;
  }

  /** Turns the light on and off without opening the folder. */
  #addSwitch(): void {
    this.#switch.type = 'checkbox';
    this.#switch.className = 'switch';
    this.#switch.addEventListener('change', () => {
      this.#edit(() => (this.#light.active = this.#switch.checked), null);
    });
    this.folder.gui.$title.after(this.#switch);
  }

  #build(rows: Rows): () => void {
    const light = this.#light;
    const { store } = fieldsOf(light);
    const { values } = store;
    const name = addText(
      rows,
      'name',
      () => values.name,
      (text) => (light.name = text),
    );
    this.#nameRow = name;
    addFlag(
      rows,
      'active',
      () => values.active,
      (active) => (light.active = active),
    );
    const kind = addChoice(
      rows,
      'kind',
      named(LIGHT_KINDS),
      () => kindOf(values),
      (choice) => {
        Object.assign(light, this.#kind.writesFor(values, choice, store.given('axis'), this.#target));
      },
    );
    explain(kind.domElement, KIND_RULE);
    for (const key of ['ambient', 'diffuse', 'specular'] as const) {
      addColor(
        rows,
        key,
        USUAL_BRIGHTNESS,
        () => values[key],
        (color) => (light[key] = color),
      );
    }
    const position = addVector(
      rows,
      'position',
      AXES,
      () => this.#range.vector(),
      () => [values.position[0], values.position[1], values.position[2]],
      ([x, y, z]) => (light.position = [x, y, z, values.position[3]]),
    );
    const spot = this.#addSpot(rows);
    const attenuation = addVector(
      rows,
      'attenuation',
      ['kc constant', 'kl linear', 'kq quadratic'],
      () => linear(0, 2, 0.01),
      () => values.attenuation,
      (factors) => (light.attenuation = factors),
    );
    addChoice(
      rows,
      'space',
      named(LIGHT_SPACES),
      () => values.space,
      (space) => (light.space = space),
    );
    this.#editor.addButtons(rows.gui, light);
    return () => {
      name.input.placeholder = this.#title;
      const placed = values.position[3] === 1;
      attenuation.show(placed);
      // Keep a row visible while it is being edited.
      const cone = isSpot(values) || spot.some((row) => row.domElement.matches(':focus-within'));
      for (const row of spot) row.show(cone);
      const inWorld = placed && values.space === 'world';
      position.travel = (axis) => (inWorld ? this.#range.place(axis) : this.#range.vector());
    };
  }

  #addSpot(rows: Rows) {
    const light = this.#light;
    const { values } = fieldsOf(light).store;
    return [
      addVector(
        rows,
        'axis',
        AXES,
        () => linear(-1, 1, 0.01),
        () => values.axis,
        (axis) => (light.axis = axis),
      ),
      addNumber(
        rows,
        'aperture °',
        linear(0, 180, 0.5),
        () => values.aperture,
        (aperture) => (light.aperture = aperture),
      ),
      addNumber(
        rows,
        'cutoff',
        logarithmic(1, 1000),
        () => values.cutoff,
        (cutoff) => (light.cutoff = cutoff),
      ),
    ];
  }

  /** The point that a new spot is aimed at, in the light's own space. */
  get #target(): Vec3 {
    const { target, radius } = this.#viewer.camera;
    return this.#light.space === 'camera' ? [0, 0, -radius] : target;
  }
}
