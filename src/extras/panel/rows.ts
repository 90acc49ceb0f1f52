// The rows of a table: one function for each kind of control. A table has a row for each field of
// an element, or says that the field has none; a folder is built from it. Each write can be undone.
import { type Controller, FunctionController, type GUI } from 'lil-gui';
import {
  fieldsOf,
  historyOf,
  type PhongLight,
  type PhongMesh,
  type PhongViewer,
  type Subject,
  type ViewerText,
} from '../../viewer/extra.js';
import type { Vec3 } from '../../phong/math/vector.js';
import { bound, type Bound } from './bound.js';
import { addColor } from './color-control.js';
import { explain, nameAttribute, nameRow, type Say } from './label.js';
import {
  addNumber,
  addVector,
  type Axis,
  type ComponentNames,
  componentOf,
  nameComponent,
} from './number-controls.js';
import { addSelect, addText, Readout } from './input-row.js';
import type { SceneRange, SliderScale } from './travel.js';
import { attributeOf } from '../../phong/fields/attribute-text.js';
import type { FieldStore } from '../../phong/fields/field-store.js';

export type Editable = PhongLight | PhongMesh | PhongViewer;

/** What a folder edits, and what its rows depend on. */
export interface RowContext<E> {
  readonly element: E;
  readonly viewer: PhongViewer;
  readonly range: SceneRange;
  /** The title of the folder, in the page's words. */
  title(): string;
  /** The scale that is shown in place of a row's own. */
  readonly scale?: (own: SliderScale) => SliderScale;
  /** The only component of vectors that is shown, by slider and field. */
  readonly axis?: Axis | null;
}

/** Where the value of a row is kept. */
export interface Source {
  readonly subject: Subject;
  readonly get: () => unknown;
  /** Throws RangeError or TypeError for a value that the element refuses. */
  readonly set: (value: unknown) => void;
}

export const storeOf = (element: Editable) =>
  fieldsOf(element as PhongViewer).store as unknown as FieldStore<Record<string, unknown>>;

/** The declared value of an element. It is written through the property, which checks it. */
export const declared = (element: Editable, key: string): Source => ({
  subject: element,
  get: () => storeOf(element).values[key],
  set: (value) => Reflect.set(element, key, value),
});

/** The folders of the viewer's own rows. A row of the viewer in none of them is not shown. */
export type ViewerFolder = 'Camera' | 'Shading' | 'Show' | 'Material';

export interface Row<T, E> {
  /** The row's name, where it has one. */
  readonly label?: ViewerText;
  /** Adds the controls to the folder. `value` reads and writes the field. */
  readonly add: (gui: GUI, place: RowContext<E>, value: Bound<T>) => void;
  /** Where the value is; the declared one, if left out. */
  readonly source?: (element: E) => Source;
  /**
   * When the row is shown; always, if left out. Rows with the same condition stay while one of them
   * has the focus.
   */
  readonly shown?: (element: E) => boolean;
  readonly folder?: ViewerFolder;
}

export const NO_ROW = null;

/** A decision for each field of `V`, in the order shown. `Own`: rows that belong to no field. */
export type RowTable<V, E, Own extends string = never> = {
  readonly [K in keyof V]: Row<V[K], E> | typeof NO_ROW;
} & { readonly [K in Own]: Row<unknown, E> };

export type AnyRow<E> = Omit<Row<unknown, E>, 'add'> & {
  readonly add: (gui: GUI, place: RowContext<E>, value: never) => void;
};

export type Rows<E> = Readonly<Record<string, AnyRow<E> | typeof NO_ROW>>;

/** The same rows, in the folder of that name. */
export const inFolder = <R extends Rows<never>>(folder: ViewerFolder, rows: R): R =>
  Object.fromEntries(
    Object.entries(rows).map(([key, row]) => [key, row && { ...row, folder }]),
  ) as R;

export const rowsIn = <E>(folder: ViewerFolder, rows: Rows<E>): Rows<E> =>
  Object.fromEntries(Object.entries(rows).filter(([, row]) => row?.folder === folder));

export interface AddedRow<E> {
  readonly row: AnyRow<E>;
  readonly controls: readonly Controller[];
}

/** Adds the rows of a table, and returns them by their fields. */
export function addRows<E extends Editable>(
  gui: GUI,
  place: RowContext<E>,
  rows: Rows<E>,
): ReadonlyMap<string, AddedRow<E>> {
  const { element } = place;
  const { fields } = storeOf(element);
  const added = new Map<string, AddedRow<E>>();
  for (const [key, row] of Object.entries(rows)) {
    if (row === NO_ROW) continue;
    const before = gui.controllers.length;
    const { subject, get, set } = row.source?.(element) ?? declared(element, key);
    row.add(gui, place, edited(place.viewer, subject, get, set) as never);
    const controls = gui.controllers.slice(before);
    if (Object.hasOwn(fields, key)) {
      for (const { domElement } of controls) {
        nameAttribute(domElement, attributeOf(key));
      }
    }
    added.set(key, { row, controls });
  }
  return added;
}

/** A value whose writes can be undone. Writes of one gesture are one step. */
export function edited<T>(
  viewer: PhongViewer,
  subject: Subject,
  get: () => T,
  set: (value: T) => void,
): Bound<T> {
  const value: Bound<T> = bound(get, (next) =>
    historyOf(viewer).edit(subject, () => set(next), value),
  );
  return value;
}

/**
 * A row whose control edits `A` for a field that holds `B`. `write` gets the field's present value
 * too.
 */
export const mapped = <A, B, E>(
  row: Row<A, E>,
  read: (value: B) => A,
  write: (value: A, before: B) => B,
): Row<B, E> => ({
  ...row,
  add: (gui, place, field) => {
    const value = bound(
      () => read(field.value),
      (next: A) => (field.value = write(next, field.value)),
    );
    row.add(gui, place, value);
  },
});

const scaled = <E>({ scale }: RowContext<E>, travel: SliderScale): SliderScale =>
  scale?.(travel) ?? travel;

/** `travel`: the slider's scale, or how it follows from the scene. */
export const number = <E>(
  label: ViewerText,
  travel: SliderScale | ((place: RowContext<E>) => SliderScale),
  hint?: ViewerText,
): Row<number, E> => ({
  label,
  add: (gui, place, value) => {
    const control = addNumber(gui, value, label, () =>
      scaled(place, typeof travel === 'function' ? travel(place) : travel),
    );
    if (hint !== undefined) {
      explain(control.domElement, hint);
    }
  },
});

/** `components`: accessible names of x, y and z. */
export const vector = <E>(
  label: ViewerText,
  travel: SliderScale | ((place: RowContext<E>, axis: Axis) => SliderScale),
  components?: ComponentNames,
): Row<Vec3, E> => ({
  label,
  add: (gui, place, value) => {
    const travelOf = (axis: Axis): SliderScale =>
      scaled(place, typeof travel === 'function' ? travel(place, axis) : travel);
    const { axis = null } = place;
    if (axis === null) {
      addVector(gui, value, label, travelOf, components);
    } else {
      const control = addNumber(gui, componentOf(value, axis), label, () => travelOf(axis));
      nameComponent(control.$name, label, axis, components);
    }
  },
});

/** `usual`: the end of the brightness slider; 1 is 255. */
export const color = (label: ViewerText, usual: number): Row<Vec3, unknown> => ({
  label,
  add: (gui, _, value) => addColor(gui, value, label, usual),
});

export const flag = (label: ViewerText): Row<boolean, unknown> => ({
  label,
  add: (gui, _, value) => nameRow(gui.add(value, 'value'), label),
});

/** A flag for each word that the field can list. */
export const flags = <T extends string>(
  words: readonly T[],
  label: (word: T) => ViewerText,
): Row<readonly T[], unknown> => ({
  add: (gui, place, value) => {
    for (const word of words) {
      const hasWord = mapped<boolean, readonly T[], unknown>(
        flag(label(word)),
        (listed) => listed.includes(word),
        (wanted, listed) =>
          words.filter((other) => (other === word ? wanted : listed.includes(other))),
      );
      hasWord.add(gui, place, value);
    }
  },
});

/** A line of text; empty, it shows the folder's title. */
export const text = (label: ViewerText): Row<string, unknown> => ({
  label,
  add: (gui, place, value) => addText(gui, value, label, () => place.title()),
});

/** One of several words; null is the viewer's own value. `hint`: the tooltip. */
export const oneOf = <T extends ViewerText | null>(
  label: ViewerText,
  words: readonly T[],
  hint?: ViewerText,
): Row<T, unknown> => ({
  label,
  add: (gui, _, value) => {
    const textOf = (word: T, say: Say) => say(word ?? 'as viewer');
    const control = addSelect(gui, value, label, () => words, textOf);
    if (hint !== undefined) {
      explain(control.domElement, hint);
    }
  },
});

/** One of the names that `values` lists, which depend on the scene. */
export const oneName = <E>(
  label: ViewerText,
  values: (element: E) => readonly string[],
  textOf: (name: string, element: E, say: Say) => string,
): Row<string, E> => ({
  label,
  add: (gui, { element }, value) => {
    const valuesNow = () => values(element);
    addSelect(gui, value, label, valuesNow, (name, say) => textOf(name, element, say));
  },
});

/** Text that the user cannot edit. `followsPictures`: each drawn picture may change it. */
export const readout = <T, E>(
  label: ViewerText,
  read: (element: E) => string,
  followsPictures = false,
): Row<T, E> => ({
  add: (gui, { element, viewer }) => {
    new Readout(gui, () => read(element), label, followsPictures ? viewer : null);
  },
});

/** A button in a row of its own. The press edits what it needs to. */
export const button = <E>(
  label: ViewerText,
  press: (place: RowContext<E>) => void,
): Row<unknown, E> => ({
  add: (gui, place) => addButton(gui, label, () => press(place)),
});

export const addButton = (gui: GUI, name: ViewerText, press: () => void): FunctionController =>
  nameRow(new FunctionController(gui, { value: press }, 'value'), name);
