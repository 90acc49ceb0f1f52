// The values that a <phong-control> declares: which value it edits, and how it looks.
import { choiceField, numberField, optional, textField } from '../../fields/field.js';
import type { Fields } from '../../fields/field-store.js';

export interface ControlValues {
  /**
   * Ids of viewers, lights or meshes, separated by spaces. All get the value; the first one's is shown. Default empty.
   */
  for: string;
  /** The attribute to edit: any that these elements have. Default empty. */
  attribute: string;
  /** One number of a vector: `x`, `y`, `z`, or `kc`, `kl`, `kq` of `attenuation`. Null, the default: all three. */
  component: 'x' | 'y' | 'z' | 'kc' | 'kl' | 'kq' | null;
  /** Values as the attribute's text, separated by `|`: a stepper through them, with back and forward. Default empty. */
  values: string;
  /** Least number. Null, the default: as in the panel, where the slider grows to include the value. */
  min: number | null;
  /** Greatest number. Null, the default: as in the panel. */
  max: number | null;
  /** Distance of the numbers. Null, the default: as in the panel. */
  step: number | null;
  /**
   * `number`: a number to drag, turn or type. `slider`: a slider with that number, on a line of its own. Null, the
   * default: a number within a line of text, otherwise a slider.
   */
  type: 'number' | 'slider' | null;
}

export const CONTROL_FIELDS: Fields<ControlValues> = {
  for: textField(),
  attribute: textField(),
  component: optional(choiceField<NonNullable<ControlValues['component']>>('x', ['x', 'y', 'z', 'kc', 'kl', 'kq'])),
  values: textField(),
  min: optional(numberField(0, {})),
  max: optional(numberField(1, {})),
  step: optional(numberField(1, { above: 0, max: 1e15 })),
  type: optional(choiceField<NonNullable<ControlValues['type']>>('slider', ['number', 'slider'])),
};
