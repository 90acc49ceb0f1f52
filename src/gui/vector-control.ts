// How does the user edit a vector? In one row, with a field per component. Knows no light, mesh or camera.
import { Controller, type GUI } from 'lil-gui';
import type { ViewerText } from '../element/fields/text-list.js';
import type { Vec3 } from '../math/vector.js';
import { bound, type Bound } from './bound.js';
import { label, nameRow } from './label.js';
import { NumberField } from './number-field.js';
import type { Travel } from './travel.js';

/** Accessible names of x, y and z. `{row}` is the row's name. */
export type ComponentNames = readonly [ViewerText, ViewerText, ViewerText];

export const AXES: ComponentNames = ['{row} x', '{row} y', '{row} z'];

export class VectorControl extends Controller {
  readonly #fields: readonly NumberField[];

  constructor(
    folder: GUI,
    value: Bound<Vec3>,
    name: ViewerText,
    components: ComponentNames,
    travel: (axis: 0 | 1 | 2) => Travel,
  ) {
    super(folder, value, 'value', 'vector');
    nameRow(this, name);
    this.#fields = ([0, 1, 2] as const).map((axis) => {
      const component = bound(
        () => value.value[axis],
        (number) => {
          const [x, y, z] = value.value;
          value.value = [axis === 0 ? number : x, axis === 1 ? number : y, axis === 2 ? number : z];
        },
      );
      const field = new NumberField(component, travel(axis));
      const { input } = field;
      this.$widget.append(input);
      label(input, (say) => {
        input.title = say(components[axis], { row: say(name) });
        input.setAttribute('aria-label', input.title);
      });
      return field;
    });
    this.updateDisplay();
  }

  set travel(travel: (axis: 0 | 1 | 2) => Travel) {
    this.#fields.forEach((field, axis) => {
      field.travel = travel(axis as 0 | 1 | 2);
    });
  }

  override updateDisplay(): this {
    for (const field of this.#fields) field.update();
    return this;
  }
}
