// How is a row made for each kind of value? One function per kind, bound to a getter and a setter, whose writes can be undone. Knows no
// light, mesh or camera.
import { type Controller, FunctionController, type GUI, OptionController } from 'lil-gui';
import type { ViewerText } from '../element/fields/text-list.js';
import type { Vec3 } from '../math/vector.js';
import { bound, type Bound } from './bound.js';
import { ColorControl } from './color-control.js';
import { label, nameRow } from './label.js';
import { NumberControl } from './number-control.js';
import { TextControl } from './text-control.js';
import type { Travel } from './travel.js';
import { type ComponentNames, VectorControl } from './vector-control.js';

/** Runs `write` as a step that can be undone. Writes with the same `gesture` are one step until the user lets go. */
export type Edit = (write: () => void, gesture: object | null) => void;

/** Where rows are added, and how they write. */
export interface Rows {
  readonly gui: GUI;
  readonly edit: Edit;
}

function edited<T>({ edit }: Rows, get: () => T, set: (value: T) => void): Bound<T> {
  const row: Bound<T> = bound(get, (value) => {
    edit(() => {
      set(value);
    }, row);
  });
  return row;
}

export function addNumber(
  rows: Rows,
  name: ViewerText,
  travel: Travel,
  get: () => number,
  set: (value: number) => void,
): NumberControl {
  return new NumberControl(rows.gui, edited(rows, get, set), name, travel);
}

/** `components`: accessible names of x, y and z. */
export function addVector(
  rows: Rows,
  name: ViewerText,
  components: ComponentNames,
  travel: (axis: 0 | 1 | 2) => Travel,
  get: () => Vec3,
  set: (value: Vec3) => void,
): VectorControl {
  return new VectorControl(rows.gui, edited(rows, get, set), name, components, travel);
}

/** `usual`: the end of the brightness slider; 1 is 255. */
export function addColor(
  rows: Rows,
  name: ViewerText,
  usual: number,
  get: () => Vec3,
  set: (value: Vec3) => void,
): void {
  new ColorControl(rows.gui, edited(rows, get, set), name, usual);
}

export function addFlag(
  rows: Rows,
  name: ViewerText,
  get: () => boolean,
  set: (value: boolean) => void,
): Controller {
  return nameRow(rows.gui.add(edited(rows, get, set), 'value'), name);
}

export function addText(
  rows: Rows,
  name: ViewerText,
  get: () => string,
  set: (value: string) => void,
): TextControl {
  return new TextControl(rows.gui, edited(rows, get, set), name);
}

/** `choices`: from the texts shown, or names, to their values. */
export function addChoice<T extends string | null>(
  rows: Rows,
  name: ViewerText,
  choices: Choices<T> | Readonly<Record<string, T>>,
  get: () => T,
  set: (value: T) => void,
): OptionController {
  const row = nameRow(new OptionController(rows.gui, edited(rows, get, set), 'value', choices), name);
  const { $select } = row;
  const texts = Object.keys(choices) as ViewerText[];
  label($select, (say) => {
    texts.forEach((text, i) => ($select.options[i]!.textContent = say(text)));
  });
  return row;
}

/** The press is no step of its own: it edits what it needs to. */
export function addButton(gui: GUI, name: ViewerText, press: () => void): FunctionController {
  return nameRow(new FunctionController(gui, { value: press }, 'value'), name);
}

type Choices<T> = { readonly [text in ViewerText]?: T };

/** Choices that are shown as their values. */
export const named = <T extends ViewerText>(values: readonly T[]): Choices<T> =>
  Object.fromEntries(values.map((value) => [value, value]));

/** Updates a row. Rows keep what the user is typing. */
export function refresh(row: Controller): void {
  // Assigning the index, even the same one, would close an open list.
  if (row instanceof OptionController && row._values[row.$select.selectedIndex] === row.getValue()) return;
  row.updateDisplay();
}
