// A light's folder: its rows, and a switch beside the title.
import type { GUI } from 'lil-gui';
import { fieldsOf } from '../element/internals.js';
import { numberedName, type PhongLight } from '../element/phong-light.js';
import type { PhongViewer } from '../element/phong-viewer.js';
import { historyOf, valuesOf } from '../element/viewer/history.js';
import { isSpot, kindOf } from '../light/light-features.js';
import { KINDS, LIGHT_SPACES, type LightValues } from '../light/light-state.js';
import type { Vec3, Vec4 } from '../math/vector.js';
import type { ChildEditor } from './child-editor.js';
import { ChildFolder } from './child-folders.js';
import { label } from './label.js';
import { KindChange } from './light-values.js';
import {
  color,
  edited,
  flag,
  mapped,
  number,
  oneOf,
  type RowContext,
  type Row,
  type RowTable,
  text,
  vector,
} from './rows.js';
import type { SceneRange } from './scene-range.js';
import { linear, logarithmic } from './travel.js';

/** Initial end of the brightness slider; 1 is 255. */
const USUAL_BRIGHTNESS = 4;

const valuesIn = (light: PhongLight): Readonly<LightValues> => fieldsOf(light).store.values;
const hasPlace = (light: PhongLight): boolean => valuesIn(light).position[3] === 1;
const hasCone = (light: PhongLight): boolean => isSpot(valuesIn(light));

/** Sliders for a place follow the scene, those for a direction or in camera space surround zero. */
const position: Row<Vec3, PhongLight> = vector('position', ({ element, range }, axis) =>
  hasPlace(element) && valuesIn(element).space === 'world' ? range.place(axis) : range.vector(),
);

/** No field says the kind: position, axis, aperture and cutoff do. */
const kind: Row<unknown, PhongLight> = {
  add: (gui, place) => {
    const { element: light, viewer } = place;
    const change = new KindChange();
    const row = oneOf(
      'kind',
      KINDS,
      'Directional: w = 0. Point: w = 1. Spot: w = 1 with a cone or decay; the other kinds set aperture 180 and cutoff 0.',
    );
    const value = edited(
      viewer,
      valuesOf(light),
      () => kindOf(valuesIn(light)),
      (next) => {
        const { store } = fieldsOf(light);
        Object.assign(light, change.writesFor(store.values, next, store.given('axis'), aimOf(place)));
      },
    );
    row.add(gui, place, value);
  },
};

/** The point that a new spot is aimed at, in the light's own space. */
function aimOf({ element, viewer }: RowContext<PhongLight>): Vec3 {
  const { target, radius } = viewer.camera;
  return element.space === 'camera' ? [0, 0, -radius] : target;
}

export const LIGHT_ROWS = {
  name: text('name'),
  active: flag('active'),
  kind,
  ambient: color('ambient', USUAL_BRIGHTNESS),
  diffuse: color('diffuse', USUAL_BRIGHTNESS),
  specular: color('specular', USUAL_BRIGHTNESS),
  position: mapped(
    position,
    ([x, y, z]: Vec4): Vec3 => [x, y, z],
    ([x, y, z], [, , , w]) => [x, y, z, w],
  ),
  axis: { ...vector('axis', linear(-1, 1, 0.01)), shown: hasCone },
  aperture: { ...number('aperture °', linear(0, 180, 0.5)), shown: hasCone },
  cutoff: { ...number('cutoff', logarithmic(1, 1000)), shown: hasCone },
  attenuation: {
    ...vector('attenuation', linear(0, 2, 0.01), ['kc constant', 'kl linear', 'kq quadratic']),
    shown: hasPlace,
  },
  space: oneOf('space', LIGHT_SPACES),
} satisfies RowTable<LightValues, PhongLight, 'kind'>;

export class LightFolder extends ChildFolder<PhongLight> {
  readonly #switch = document.createElement('input');

  constructor(group: GUI, light: PhongLight, viewer: PhongViewer, range: SceneRange, editor: ChildEditor<PhongLight>) {
    super(group, light, viewer, range, LIGHT_ROWS, editor);
    this.#addSwitch();
  }

  override update(index: number): void {
    const { active } = valuesIn(this.element);
    this.#switch.checked = active;
    this.folder.gui.domElement.classList.toggle('off', !active);
    super.update(index);
  }

  /**
   * The same default as the element's `name`, without its search through all siblings, which is slow with hundreds of
   * lights.
   */
  protected override titleAt(index: number): string {
    return valuesIn(this.element).name || numberedName(index, this.viewer.texts);
  }

  protected override showTitle(title: string): void {
    super.showTitle(title);
    label(this.#switch, (say) => this.#switch.setAttribute('aria-label', say('{name} active', { name: title })));
  }

  /** Turns the light on and off without opening the folder. */
  #addSwitch(): void {
    const { element: light, viewer } = this;
    this.#switch.type = 'checkbox';
    this.#switch.className = 'switch';
    this.#switch.addEventListener('change', () =>
      historyOf(viewer).edit(valuesOf(light), () => (light.active = this.#switch.checked)),
    );
    this.folder.gui.$title.after(this.#switch);
  }
}
