// The rows of a <phong-control> that the panel has not: a stepper through values, and fields
// without a row.
import { cssColor, type PhongViewer, sceneMeshes, type ViewerText } from '../../viewer/extra.js';
import type { Field } from '../../phong/fields/field.js';
import { sameValue } from '../../phong/fields/field-store.js';
import type { Bound } from './bound.js';
import { InputRow } from './input-row.js';
import { label, show, type Say } from './label.js';
import {
  type AnyRow,
  declared,
  type Editable,
  flag,
  mapped,
  number,
  oneOf,
  type Row,
  type Source,
  text,
  vector,
} from './rows.js';
import { linear, type SliderScale } from './travel.js';
import { attributeOf, formatValue, parseText } from '../../phong/fields/attribute-text.js';

/** Shown for a value without words. */
const NOTHING = '–';

/** The camera is where it was put but for rounding. */
const same = (a: unknown, b: unknown): boolean =>
  typeof a === 'number' && typeof b === 'number' ? Math.abs(a - b) < 1e-6 : sameValue(a, b);

/**
 * Goes through the values of `list`, the attribute's text separated by `|`. What the field refuses
 * is left out.
 */
export const stepper = (
  key: string,
  field: Field<unknown>,
  list: string,
  own: AnyRow<Editable> | null,
): AnyRow<Editable> => ({
  ...(own?.source === undefined ? {} : { source: own.source }),
  add: (gui, _, bound: Bound<unknown>) => {
    const values = list.split('|').flatMap((text) => valuesIn(text, field));
    const place = (): number => values.findIndex((value) => same(value, bound.value));
    /** From a value that is not in the list, to its first or last. */
    const go = (by: -1 | 1): void => {
      const at = place();
      const next = values.at(at < 0 ? Math.min(by, 0) : Math.max(at + by, 0));
      if (next !== undefined && !same(next, bound.value)) {
        bound.value = next;
      }
    };
    let say: Say = (text) => text;
    const stepTo = (text: 'back' | 'forward') => {
      const input = document.createElement('button');
      input.type = 'button';
      input.className = text;
      input.addEventListener('click', () => go(text === 'back' ? -1 : 1));
      const end = text === 'back' ? 0 : values.length - 1;
      const update = (): void => {
        const at = place();
        input.setAttribute('aria-disabled', String(at >= 0 && at === end));
      };
      return { input, update };
    };
    const output = document.createElement('output');
    const update = (): void => {
      const text = formatValue(bound.value, field) ?? '';
      show(output, text.replace(/[\w-]+/g, (word) => say(word as ViewerText)) || NOTHING);
    };
    const [back, forward] = [stepTo('back'), stepTo('forward')];
    const row = new InputRow(gui, bound, 'steps', nameOf(key, own), [
      back,
      { input: output, update },
      forward,
    ]);
    for (const { input } of [back, forward]) {
      input.id = `${row.$name.id}-${input.className}`;
      input.setAttribute('aria-labelledby', `${row.$name.id} ${input.id}`);
      label(input, (words) => {
        say = words;
        input.setAttribute('aria-label', words(input.className as ViewerText));
      });
    }
    update();
  },
});

function valuesIn(text: string, field: Field<unknown>): readonly unknown[] {
  try {
    return [field.check(parseText(text.trim(), field, cssColor))];
  } catch (error) {
    console.warn(`<phong-control values="…">: ${(error as Error).message}`);
    return [];
  }
}

/** Scales of values that have no slider in the panel. */
const SCALES: Readonly<Record<string, SliderScale>> = {
  segments: linear(3, 128, 1),
  pixelRatio: linear(0.25, 4, 0.25),
};

const nameOf = (key: string, own: AnyRow<Editable> | null): ViewerText =>
  own?.label ?? (attributeOf(key) as ViewerText);

/** The panel's row, or what the kind of the field asks for. */
export function rowOf(
  key: string,
  { kind, choices }: Field<unknown>,
  own: AnyRow<Editable> | null,
): AnyRow<Editable> {
  if (own !== null && SCALES[key] === undefined) return own;
  const name = nameOf(key, own);
  if (choices !== undefined) return oneOf(name, choices as readonly ViewerText[]);
  if (kind === 'number') {
    const row: Row<number, Editable> = number(name, SCALES[key] ?? linear(0, 1));
    const source = (element: Editable): Source => {
      const value = declared(element, key);
      const auto = () => sceneMeshes.get(element as PhongViewer)?.segments ?? devicePixelRatio;
      return { ...value, get: () => (typeof value.get() === 'number' ? value.get() : auto()) };
    };
    return { ...row, source };
  }
  const readAs = <T>(row: Row<T, Editable>, read: (value: unknown) => T) =>
    mapped(row, read, (value) => value);
  if (kind === 'numbers') {
    return readAs(
      vector(name, linear(-10, 10, 0.05)),
      (value) => (value ?? [0, 0, 0]) as [0, 0, 0],
    );
  }
  if (kind === 'text') return readAs(text(name), String);
  return readAs(flag(name), Boolean);
}
