// The rows of a <phong-control> that the panel has not: a stepper through values, and fields without a row.
import { Controller, type GUI } from 'lil-gui';
import { attributeOf, formatValue, parseText } from '../element/fields/attribute-text.js';
import type { ViewerText } from '../element/fields/texts.js';
import { sceneMeshes } from '../element/internals.js';
import type { PhongViewer } from '../element/phong-viewer.js';
import type { Field } from '../fields/field.js';
import { sameValue } from '../fields/field-store.js';
import type { Bound } from './bound.js';
import { label, nameRow, type Say } from './label.js';
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

/** Shown for a value without words. */
const NOTHING = '–';

/** The camera is where it was put but for rounding. */
const same = (a: unknown, b: unknown): boolean =>
  typeof a === 'number' && typeof b === 'number' ? Math.abs(a - b) < 1e-6 : sameValue(a, b);

class StepControl extends Controller {
  readonly #bound: Bound<unknown>;
  readonly #values: readonly unknown[];
  readonly #buttons: readonly HTMLButtonElement[];
  readonly #output = document.createElement('output');
  readonly #text: (value: unknown) => string;

  /** `list`: values as the attribute's text, separated by `|`. What the field refuses is left out. */
  constructor(folder: GUI, value: Bound<unknown>, name: ViewerText, field: Field<unknown>, list: string) {
    super(folder, value, 'value', 'steps');
    nameRow(this, name);
    this.#bound = value;
    this.#values = list.split('|').flatMap((text) => valuesIn(text, field));
    let say: Say = (text) => text;
    this.#text = (shown) =>
      (formatValue(shown, field) ?? '').replace(/[\w-]+/g, (word) => say(word as ViewerText)) || NOTHING;
    this.#buttons = (['back', 'forward'] as const).map((text, i) => {
      const button = document.createElement('button');
      button.type = 'button';
      button.className = text;
      button.id = `${this.$name.id}-${text}`;
      button.setAttribute('aria-labelledby', `${this.$name.id} ${button.id}`);
      label(button, (words) => {
        say = words;
        button.setAttribute('aria-label', words(text));
      });
      button.addEventListener('click', () => this.#go(i === 0 ? -1 : 1));
      return button;
    });
    this.#output.setAttribute('aria-labelledby', this.$name.id);
    this.$widget.append(this.#buttons[0]!, this.#output, this.#buttons[1]!);
    this.updateDisplay();
  }

  override updateDisplay(): this {
    const at = this.#place;
    const text = this.#text(this.#bound.value);
    if (this.#output.textContent !== text) this.#output.textContent = text;
    this.#buttons.forEach((button, i) =>
      button.setAttribute('aria-disabled', String(at >= 0 && at === (i === 0 ? 0 : this.#values.length - 1))),
    );
    return this;
  }

  get #place(): number {
    return this.#values.findIndex((value) => same(value, this.#bound.value));
  }

  /** From a value that is not in the list, to its first or last. */
  #go(by: -1 | 1): void {
    const at = this.#place;
    const next = this.#values.at(at < 0 ? (by < 0 ? -1 : 0) : Math.max(at + by, 0));
    if (next !== undefined && !same(next, this.#bound.value)) this.#bound.value = next;
  }
}

function valuesIn(text: string, field: Field<unknown>): readonly unknown[] {
  try {
    return [field.check(parseText(text.trim(), field))];
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

/** Names that are not the attribute's. */
const NAMES: Readonly<Record<string, ViewerText>> = {
  theta: 'θ azimuth °',
  phi: 'φ polar °',
  fov: 'fov °',
  aperture: 'aperture °',
  rotation: 'rotation °',
  colorInterpolation: 'colour space',
  viewLight: 'view light',
};

const nameOf = (key: string): ViewerText => NAMES[key] ?? (attributeOf(key) as ViewerText);

/** The panel's row, or what the kind of the field asks for. */
export function rowOf(key: string, { kind, choices }: Field<unknown>, own: AnyRow<Editable> | null): AnyRow<Editable> {
  if (own !== null && SCALES[key] === undefined) return own;
  const name = nameOf(key);
  if (choices !== undefined) return oneOf(name, choices as readonly ViewerText[]);
  if (kind === 'number') {
    const row: Row<number, Editable> = number(name, SCALES[key] ?? linear(0, 1));
    const source = (element: Editable): Source => {
      const value = declared(element, key);
      const auto = (): number => sceneMeshes.get(element as PhongViewer)?.segments ?? devicePixelRatio;
      return { ...value, get: () => (typeof value.get() === 'number' ? value.get() : auto()) };
    };
    return { ...row, source };
  }
  const known = <T>(row: Row<T, Editable>, read: (value: unknown) => T) => mapped(row, read, (value) => value);
  if (kind === 'numbers')
    return known(vector(name, linear(-10, 10, 0.05)), (value) => (value ?? [0, 0, 0]) as [0, 0, 0]);
  if (kind === 'text') return known(text(name), String);
  return known(flag(name), Boolean);
}

/** Goes through the values of `list`. */
export const stepper = (
  key: string,
  field: Field<unknown>,
  list: string,
  own: AnyRow<Editable> | null,
): AnyRow<Editable> => ({
  ...(own?.source === undefined ? {} : { source: own.source }),
  add: (gui, _, value) => {
    new StepControl(gui, value, nameOf(key), field, list);
  },
});
