// The values that a <phong-probe> declares: which point it explains, and how.
import type { PhongLight, ValuesByTag } from '../../viewer/extra.js';
import {
  choiceField,
  type Field,
  optional,
  outside,
  presenceField,
  textField,
  vectorField,
} from '../../phong/fields/field.js';
import type { Fields } from '../../phong/fields/field-store.js';
import { LIMITS, type Term } from '../../phong/light/light-state.js';

export type ProbeValues = ValuesByTag['phong-probe'];

const ASKED = 'sum, or ambient, diffuse or specular and the name of a light';

/** What is asked. */
export interface Asked {
  readonly term: Term | 'sum';
  /** Name or id of a light; empty for all. */
  readonly name: string;
}

/** Null where nothing is asked, or something that does not exist. */
export function askedOf(ask: string): Asked | null {
  const match = /^\s*(sum|ambient|diffuse|specular)(?:\s+(\S.*?))?\s*$/i.exec(ask);
  if (match === null) return null;
  const [, term = '', name = ''] = match;
  return { term: term.toLowerCase() as Asked['term'], name };
}

/** Whether a line, or a light's share, is of the light that is asked for. */
export const isAsked = (
  { name }: Asked,
  of: { readonly name: string; readonly light: PhongLight | null },
): boolean => name === '' || name === of.name || name === of.light?.id;

/** What a probe is: questions where `ask` says what, unless `as` says otherwise. */
export const formOf = ({
  as,
  ask,
}: Pick<ProbeValues, 'as' | 'ask'>): NonNullable<ProbeValues['as']> =>
  as ?? (ask.trim() === '' ? 'table' : 'ask');

const askField: Field<string> = {
  ...textField('', ASKED),
  check(value) {
    const text = textField('', ASKED).check(value);
    if (text.trim() !== '' && askedOf(text) === null) throw outside(ASKED, value);
    return text;
  },
};

export const PROBE_FIELDS: Fields<ProbeValues> = {
  for: textField(),
  as: optional(choiceField(['table', 'formula', 'ask'])),
  at: optional(vectorField([0, 0, 0], { min: -LIMITS.coordinate, max: LIMITS.coordinate })),
  ask: askField,
  seed: textField(),
  name: textField(),
  required: presenceField(),
};
