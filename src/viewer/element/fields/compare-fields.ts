// The values that a <phong-compare> declares: how its viewers lie beside or over each other.
import {
  choiceField,
  type Field,
  numbersField,
  optional,
  orAuto,
  textField,
} from '../../../phong/fields/field.js';
import type { Fields } from '../../../phong/fields/field-store.js';
import type { Inputs, ValuesOf } from './properties.js';

export interface CompareProperties {
  /**
   * `split`: the viewers lie over each other, with dividers. `side`: side by side. Default split.
   */
  get layout(): 'split' | 'side';
  set layout(value: Accepted['layout']);
  /**
   * The viewers follow each other along a line of text (`horizontal`) or from top to bottom
   * (`vertical`). Default horizontal.
   */
  get direction(): 'horizontal' | 'vertical';
  set direction(value: Accepted['direction']);
  /**
   * Where the dividers of `split` are: percent from the start of the line, or from the top. Those
   * left out share the rest evenly. The property follows the user's moves, the attribute does not.
   * Default auto: equal parts.
   */
  get at(): readonly number[] | 'auto';
  set at(value: Accepted['at']);
  /**
   * Labels of the viewers, separated by commas; the property also takes a list. Empty: no labels.
   * Null, the default: each viewer's `aria-label` or `alt`.
   */
  get labels(): string | null;
  set labels(value: Accepted['labels']);
}

export type CompareValues = ValuesOf<CompareProperties>;
type Accepted = Inputs<CompareValues>;

export const COMPARE_FIELDS: Fields<CompareValues> = {
  layout: choiceField(['split', 'side']),
  direction: choiceField(['horizontal', 'vertical']),
  at: orAuto(numbersField('numbers from 0 to 100 in ascending order', 0, 100)),
  labels: optional(labelsField()),
};

/** A text, or a list of texts without commas. */
function labelsField(): Field<string> {
  const text = textField('', 'text, or a list of texts without commas');
  const isLabel = (label: unknown) => typeof label === 'string' && !label.includes(',');
  return {
    ...text,
    check: (value) =>
      text.check(Array.isArray(value) && value.every(isLabel) ? value.join(', ') : value),
  };
}
