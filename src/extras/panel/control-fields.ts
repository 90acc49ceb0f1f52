// The fields of a <phong-control>.
import { choiceField, numberField, optional, textField } from '../../phong/fields/field.js';
import type { Fields } from '../../phong/fields/field-store.js';
import type { ValuesByTag } from '../../viewer/extra.js';

export type ControlValues = ValuesByTag['phong-control'];

export const CONTROL_FIELDS: Fields<ControlValues> = {
  for: textField(),
  attribute: textField(),
  component: optional(choiceField(['x', 'y', 'z', 'kc', 'kl', 'kq'])),
  values: textField(),
  min: optional(numberField(0, {})),
  max: optional(numberField(1, {})),
  step: optional(numberField(1, { above: 0, max: 1e15 })),
  type: optional(choiceField(['number', 'slider'])),
};
