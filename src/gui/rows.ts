// How is a row made for each kind of value? One function per kind, bound to a getter and a setter. Knows no light, mesh or camera.
import {
  ColorController,
  type Controller,
  FunctionController,
  type GUI,
  OptionController,
  StringController,
} from 'lil-gui';
import type { Vec3 } from '../math/vector.js';
import { bound } from './bound.js';
import { colorOf, ColorMix, hexOf } from './color-mix.js';
import { NumberControl } from './number-control.js';
import { linear, type Travel } from './travel.js';

export function addNumber(
  gui: GUI,
  label: string,
  travel: Travel,
  get: () => number,
  set: (value: number) => void,
): NumberControl {
  return new NumberControl(gui, bound(get, set), label, travel);
}

/** One row per axis. `labels`: those of x, y and z. */
export function addVector(
  gui: GUI,
  labels: readonly [string, string, string],
  travel: (axis: 0 | 1 | 2) => Travel,
  get: () => Vec3,
  set: (value: Vec3) => void,
): NumberControl[] {
  return ([0, 1, 2] as const).map((axis) =>
    addNumber(
      gui,
      labels[axis],
      travel(axis),
      () => get()[axis],
      (value) => {
        const [x, y, z] = get();
        set([axis === 0 ? value : x, axis === 1 ? value : y, axis === 2 ? value : z]);
      },
    ),
  );
}

export const axesOf = (name: string): [string, string, string] => [`${name} x`, `${name} y`, `${name} z`];

/** A colour picker with an intensity row below it. `usual`: the end of the intensity slider. */
export function addColor(
  gui: GUI,
  label: string,
  usual: number,
  get: () => Vec3,
  set: (value: Vec3) => void,
): void {
  const mix = new ColorMix();
  const hex = bound(
    () => hexOf(mix.split(get()).color),
    (text) => {
      set(mix.recolor(get(), colorOf(text)));
    },
  );
  const picker = new ColorController(gui, hex, 'value', 1).name(label);
  // Make the picker itself reachable by keyboard, not only its text field.
  picker.$input.tabIndex = 0;
  const intensity = addNumber(
    gui,
    '× intensity',
    linear(0, usual, 0.01),
    () => mix.split(get()).intensity,
    (value) => {
      set(mix.intensify(get(), value));
    },
  );
  const labels = `${picker.$name.id} ${intensity.$name.id}`;
  for (const input of intensity.$widget.children) input.setAttribute('aria-labelledby', labels);
  intensity.domElement.classList.add('below');
}

export function addFlag(
  gui: GUI,
  label: string,
  get: () => boolean,
  set: (value: boolean) => void,
): Controller {
  return gui.add(bound(get, set), 'value').name(label);
}

export function addText(
  gui: GUI,
  label: string,
  get: () => string,
  set: (value: string) => void,
): StringController {
  return new StringController(gui, bound(get, set), 'value').name(label);
}

/** `choices`: from the names shown to their values. */
export function addChoice<T extends string | null>(
  gui: GUI,
  label: string,
  choices: Readonly<Record<string, T>>,
  get: () => T,
  set: (value: T) => void,
): OptionController {
  return new OptionController(gui, bound(get, set), 'value', choices).name(label);
}

export function addButton(gui: GUI, label: string, press: () => void): FunctionController {
  return new FunctionController(gui, { value: press }, 'value').name(label);
}

/** Choices whose names are their values. */
export const named = <T extends string>(values: readonly T[]): Readonly<Record<string, T>> =>
  Object.fromEntries(values.map((value) => [value, value]));

/** Updates a row, unless the user is editing it. */
export function refresh(row: Controller): void {
  if (row instanceof StringController && row.$input.matches(':focus')) return;
  // Assigning the index, even the same one, would close an open list.
  if (row instanceof OptionController && row._values[row.$select.selectedIndex] === row.getValue()) return;
  row.updateDisplay();
}
