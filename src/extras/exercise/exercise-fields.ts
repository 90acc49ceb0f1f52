// The fields of a <phong-exercise>.
import {
  choiceField,
  optional,
  presenceField,
  subsetField,
  textField,
} from '../../phong/fields/field.js';
import type { Fields } from '../../phong/fields/field-store.js';
import { KINDS, TERMS } from '../../phong/light/light-state.js';
import type { ValuesByTag } from '../../viewer/extra.js';

export type ExerciseValues = ValuesByTag['phong-exercise'];

export const EXERCISE_FIELDS: Fields<ExerciseValues> = {
  for: textField(),
  name: textField(),
  terms: subsetField(TERMS),
  kinds: optional(subsetField(KINDS)),
  hint: choiceField(['what', 'where', 'verdict', 'none']),
  solution: presenceField(),
  required: presenceField(),
};
