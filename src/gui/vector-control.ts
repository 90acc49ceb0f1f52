// How does the user edit a vector? In one row, with a field per component. Knows no light, mesh or camera.
import { Controller, type GUI } from 'lil-gui';
import type { Vec3 } from '../math/vector.js';
import { bound, type Bound } from './bound.js';
import { NumberField } from './number-field.js';
import type { Travel } from './travel.js';

export class VectorControl extends Controller {
  readonly #fields: readonly NumberField[];

  /** `labels`: accessible names of the components. */
  constructor(
    folder: GUI,
    value: Bound<Vec3>,
    label: string,
    labels: readonly [string, string, string],
    travel: (axis: 0 | 1 | 2) => Travel,
  ) {
    super(folder, value, 'value', 'vector');
    this.name(label);
    this.#fields = ([0, 1, 2] as const).map((axis) => {
      const component = bound(
        () => value.value[axis],
        (number) => {
          const [x, y, z] = value.value;
          value.value = [axis === 0 ? number : x, axis === 1 ? number : y, axis === 2 ? number : z];
        },
      );
      const field = new NumberField(component, travel(axis));
      field.input.setAttribute('aria-label', labels[axis]);
      field.input.title = labels[axis];
      this.$widget.append(field.input);
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
